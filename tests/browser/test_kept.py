"""Nothing is lost: steps, homes and styles outlast reloads, Back and Forward, and undo walks all the way back."""

from __future__ import annotations

import json
import random
from collections.abc import Callable

import pytest
from playwright.sync_api import Browser, Dialog, expect

from tests.browser.conftest import visiting
from tests.browser.test_rooms_and_files import DROP
from tests.browser.visit import SMALL, Visit
from tests.sweeps import seeds, times

SCENE = "JSON.stringify(compose.scene)"
DENIED = "IDBFactory.prototype.open = () => { throw new DOMException('denied', 'SecurityError'); }"
FULL = """IDBObjectStore.prototype.put = function () {
    this.transaction.abort();
    throw new DOMException('full', 'QuotaExceededError');
};"""

ACTS = ("edit", "edit", "move", "move", "style", "new", "reload", "back and forth", "undo and redo", "away")
"""What a person does, by how often; a sequence has each, and in `make targets` a few more."""


def text(visit: Visit) -> str:
    """The scene shown, to the byte."""
    visit.settle()
    shown: str = visit.page.evaluate(SCENE)
    return shown


def changed(visit: Visit, act: Callable[[], object]) -> str:
    """Does something that changes what is shown; returns what is shown then."""
    before = text(visit)
    act()
    visit.page.wait_for_function(f"before => {SCENE} !== before", arg=before)
    return text(visit)


def again(visit: Visit, act: Callable[[], object]) -> str:
    """Leaves the page as it is shown; returns what the page shows that is open then."""
    act()
    visit.page.wait_for_function("() => globalThis.compose?.scene")
    return text(visit)


def piece(visit: Visit, draw: random.Random) -> str:
    """Some piece of the home shown."""
    found: list[str] = visit.page.evaluate("compose.scene.rooms.flatMap(room => room.furniture.map(one => one.id))")
    return draw.choice(found)


def edit(visit: Visit, draw: random.Random) -> str:
    """Deletes, locks or unlocks some piece by its key."""
    id_of = chosen(visit, draw)
    locked = visit.page.evaluate("id => compose.scene.rooms.some(room => room.furniture.some(one => one.id === id && one.locked))", id_of)
    return changed(visit, lambda: visit.page.keyboard.press("k" if locked else draw.choice(["k", "Delete", "Delete"])))


def chosen(visit: Visit, draw: random.Random) -> str:
    """Chooses some piece of the home shown."""
    visit.page.evaluate("document.activeElement?.blur()")
    id_of = piece(visit, draw)
    visit.line_of(id_of).click()
    return id_of


def moved(visit: Visit, draw: random.Random) -> str:
    """Moves, turns or copies some piece by its key; where that cannot be, all stays as it was."""
    chosen(visit, draw)
    visit.page.locator("#stage").focus()
    visit.page.keyboard.press(draw.choice(["ArrowUp", "ArrowLeft", "Shift+ArrowDown", "q", "e", "Control+d"]))
    shown = text(visit)
    visit.page.keyboard.press("Escape")
    return shown


def restyle(visit: Visit, draw: random.Random) -> str:
    """Chooses another style, or switches the decorations."""
    decorations = visit.page.get_by_label("Decorations", exact=True)
    if draw.random() < 0.3:
        return changed(visit, decorations.click)
    styles = ["modern", "rustic", "scandi", "industrial"]
    shown = visit.page.evaluate("compose.scene.request.style")  # one that the seed drew is not in the form
    return changed(visit, lambda: visit.page.locator("#style").select_option(draw.choice([one for one in styles if one != shown])))


def undone(visit: Visit) -> list[str]:
    """What undo shows, step after step, until there is nothing to undo."""
    found = []
    undo = visit.page.get_by_role("button", name="Undo")
    while undo.is_enabled():
        before = visit.page.evaluate(SCENE), visit.page.url
        undo.click()
        visit.page.wait_for_function(f"([scene, url]) => {SCENE} !== scene || location.href !== url", arg=before)
        found.append(text(visit))
    return found


@pytest.mark.parametrize("seed", seeds(range(200), 200))
def test_a_random_sequence_is_kept_to_the_byte(visit: Visit, seed: int) -> None:
    draw = random.Random(seed)
    visit.open(SMALL.format(3 + seed % 20))
    first = shown = text(visit)
    for act in [*draw.sample(ACTS, len(ACTS)), *draw.choices(ACTS, k=times(4, 0))]:
        if act == "edit":
            shown = edit(visit, draw)
        elif act == "move":
            shown = moved(visit, draw)
        elif act == "style":
            shown = restyle(visit, draw)
        elif act == "new":
            shown = changed(visit, visit.page.locator("#random").click)
        elif act == "reload":
            assert again(visit, visit.page.reload) == shown
        elif act == "undo and redo" and visit.page.get_by_role("button", name="Undo").is_enabled():
            assert changed(visit, lambda: visit.page.keyboard.press("Control+z")) != shown
            assert changed(visit, lambda: visit.page.keyboard.press("Control+y")) == shown
        elif act == "back and forth":
            other = changed(visit, visit.page.locator("#random").click)
            assert changed(visit, visit.page.go_back) == shown
            assert changed(visit, visit.page.go_forward) == other
            assert changed(visit, visit.page.go_back) == shown
        elif act == "away":
            visit.page.goto(visit.address + "healthz")
            assert again(visit, visit.page.go_back) == shown
        assert text(visit) == shown
    assert undone(visit)[-1] == first
    assert visit.console == []


def test_homes_as_they_were_left_by_back_forward_and_undo(visit: Visit) -> None:
    draw = random.Random(5)
    visit.open(SMALL.format(3))
    made = text(visit)
    edited = edit(visit, draw)
    styled = restyle(visit, draw)
    other = changed(visit, visit.page.locator("#random").click)
    further = edit(visit, draw)
    assert changed(visit, visit.page.go_back) == styled
    assert "seed=3" in visit.page.url
    assert changed(visit, visit.page.go_forward) == further
    assert undone(visit) == [other, styled, edited, made]
    redo = visit.page.get_by_role("button", name="Redo")
    assert [changed(visit, redo.click) for _ in range(4)] == [edited, styled, other, further]
    expect(redo).to_be_disabled()
    assert again(visit, visit.page.reload) == further
    assert undone(visit)[-1] == made


def test_style_and_decorations_change_in_place(visit: Visit) -> None:
    draw = random.Random(2)
    visit.open(SMALL.format(4) + "&style=modern")
    edit(visit, draw)
    standing = "compose.scene.rooms.map(room => room.furniture.map(({color, asset, ...rest}) => JSON.stringify(rest)))"
    furniture = visit.page.evaluate(standing)
    before = text(visit)
    for act in (
        visit.page.get_by_label("Decorations", exact=True).check,
        lambda: visit.page.locator("#style").select_option("scandi"),
        visit.page.get_by_label("Decorations", exact=True).uncheck,
        visit.page.locator("#decorate_now").click,
    ):
        changed(visit, act)
        assert visit.page.evaluate(standing) == furniture
    assert visit.count("decorations") > 0
    assert "style=scandi" in visit.page.url
    assert "decorate=true" in visit.page.url
    for _ in range(4):
        changed(visit, lambda: visit.page.keyboard.press("Control+z"))
    assert text(visit) == before
    expect(visit.page.locator("#style")).to_have_value("modern")
    expect(visit.page.get_by_label("Decorations", exact=True)).not_to_be_checked()
    assert "style=modern" in visit.page.url


def test_recent_homes_have_pictures_and_open_as_they_were_left(visit: Visit) -> None:
    page = visit.page
    visit.open(SMALL.format(3))
    edited = edit(visit, random.Random(1))
    page.evaluate(DROP, ["<b>mine</b>", json.dumps({**json.loads(edited), "seed": 77})])
    expect(page).to_have_title("Compose: <b>mine</b>")
    filed = text(visit)
    page.locator("#recent summary").click()
    homes = page.locator("#recent_list .recent-home")
    expect(homes).to_have_count(2)
    expect(homes.first).to_contain_text("<b>mine</b>")
    expect(homes.first).to_have_attribute("aria-current", "true")
    expect(homes.last).to_contain_text("1 change")
    expect(homes.locator("img[src^='data:image/']")).to_have_count(2)
    assert page.evaluate("[...document.querySelectorAll('#recent_list img')].every(one => one.naturalWidth > 100)")
    assert changed(visit, homes.last.click) == edited
    assert again(visit, page.reload) == edited
    page.locator("#recent summary").click()
    expect(homes).to_have_count(2)
    assert changed(visit, page.go_back) == filed
    page.get_by_role("button", name="Forget all but this one").click()
    page.get_by_role("button", name="Really forget").click()
    expect(homes).to_have_count(1)
    expect(page.get_by_role("button", name="Undo")).to_be_disabled()
    assert again(visit, page.reload) == filed
    assert visit.console == []


def test_a_link_brings_the_changes(visit: Visit, browser: Browser) -> None:
    visit.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    visit.open(SMALL.format(3))
    made = text(visit)
    edit(visit, random.Random(3))
    edited = changed(visit, lambda: visit.page.locator("#style").select_option("rustic"))
    visit.page.locator("#copy_link").click()
    expect(visit.page.locator("#said")).to_have_text("Link copied: it opens this house with your changes.")
    link = visit.page.evaluate("navigator.clipboard.readText()")
    with visiting(browser, visit.address) as friend:
        friend.after(lambda: friend.page.goto(link))
        friend.page.wait_for_function(f"wanted => {SCENE} === wanted", arg=edited)
        assert "#" not in friend.page.url
        assert again(friend, friend.page.reload) == edited
        assert len(undone(friend)) == 1
        friend.page.goto(link[:-5])
        expect(friend.page.get_by_role("alert")).to_contain_text("The link is damaged")
        assert text(friend) != made
        assert friend.console == []


@pytest.mark.parametrize("trouble", [DENIED, FULL])
@pytest.mark.own_page
def test_where_the_browser_keeps_nothing_the_page_works_and_warns(visit: Visit, trouble: str) -> None:
    page = visit.page
    asked: list[str] = []

    def heard(dialog: Dialog) -> None:
        asked.append(dialog.type)
        dialog.accept()

    page.on("dialog", heard)
    page.add_init_script(trouble)
    visit.open(SMALL.format(3))
    made = text(visit)
    edited = edit(visit, random.Random(4))
    changed(visit, page.locator("#random").click)
    assert undone(visit) == [edited, made]
    assert changed(visit, lambda: page.keyboard.press("Control+y")) == edited
    page.locator("#recent summary").click()
    expect(page.locator("#recent_said")).to_contain_text("is lost when you leave")
    expect(page.locator("#recent_list .recent-home")).to_have_count(2)
    visit.after(page.reload)
    assert asked == ["beforeunload"]
    assert text(visit) == made
    assert visit.console == []
