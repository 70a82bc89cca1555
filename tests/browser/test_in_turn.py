"""What is asked while something else waits: nothing done is lost, nothing is done to another house."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, Route, expect

from tests.browser.test_diagnose import errors, spoiled
from tests.browser.visit import SMALL, Document, Visit, first, furniture_of, intercept
from tests.sweeps import seeds


def held(page: Page, call: str, act: Callable[[], object]) -> Route:
    """Does something that makes a call, and holds the call back."""
    routes: list[Route] = []

    def hold(route: Route) -> None:
        routes.append(route)

    intercept(page, f"**/{call}", hold)
    with page.expect_request(lambda request: request.url.endswith(call)):
        act()
    taken = first(page, routes)
    page.unroute(f"**/{call}")
    return taken


def shown(visit: Visit) -> dict[str, Document]:
    """The furniture of the shown scene by its id."""
    scene = visit.page.evaluate("compose.scene")
    return {piece["id"]: piece for room in scene["rooms"] for piece in room["furniture"]}


def roomy(answer: Document, least: int) -> list[Document]:
    """The rooms with so many pieces."""
    return [room for room in answer["scene"]["rooms"] if len(room["furniture"]) >= least]


def test_a_skip_link_moves_the_focus_and_keeps_what_was_edited(visit: Visit) -> None:
    piece = furniture_of(visit.open(SMALL.format(3)))[0]
    visit.line_of(piece).click()
    visit.page.keyboard.press("Delete")
    expect(visit.line_of(piece)).to_have_count(0)
    asked, address = len(visit.requests), visit.page.url
    for name, region in (("To the text", "reading"), ("To the controls", "controls"), ("To the house", "stage")):
        visit.page.get_by_role("link", name=name).focus()
        visit.page.keyboard.press("Enter")
        expect(visit.page.locator(f"#{region}")).to_be_focused()
    visit.settle()
    assert (len(visit.requests), visit.page.url, piece in shown(visit)) == (asked, address, False)
    expect(visit.page.get_by_role("button", name="Undo")).to_be_enabled()


def test_a_room_furnished_anew_and_an_edit_of_another_room_both_stay(visit: Visit) -> None:
    answer = visit.open(SMALL.format(3))
    one, other = roomy(answer, 3)[:2]
    locked, gone = other["furniture"][0]["id"], other["furniture"][1]["id"]
    visit.page.get_by_label("Room", exact=True).select_option(one["id"])
    waiting = held(visit.page, "generate", visit.page.get_by_role("button", name="Re-roll this room").click)
    expect(visit.page.get_by_role("button", name="Undo")).to_be_enabled()
    visit.line_of(locked).click()
    visit.page.keyboard.press("k")
    visit.line_of(gone).click()
    visit.page.keyboard.press("Delete")
    waiting.continue_()
    expect(visit.line_of(gone)).to_have_count(0)
    visit.settle()
    assert shown(visit)[locked]["locked"]
    anew = {id_of: (piece["x"], piece["z"]) for id_of, piece in shown(visit).items() if id_of.startswith(f"{one['id']}/")}
    assert anew != {piece["id"]: (piece["x"], piece["z"]) for piece in one["furniture"]}
    for _ in range(3):
        visit.page.keyboard.press("Control+z")
    visit.settle()
    assert visit.page.evaluate("compose.scene") == answer["scene"]
    expect(visit.page.get_by_role("button", name="Undo")).to_be_disabled()


def test_what_was_asked_of_a_house_is_done_to_that_and_not_to_the_next(visit: Visit) -> None:
    piece = roomy(visit.open(SMALL.format(3)), 3)[0]["furniture"][0]["id"]
    visit.line_of(piece).click()
    waiting = held(visit.page, "fix", lambda: visit.page.keyboard.press("Delete"))
    with visit.page.expect_response(lambda response: response.url.endswith("/generate")):
        visit.page.locator("#random").click()
    assert visit.page.evaluate("compose.scene.seed") == 3
    waiting.continue_()
    visit.page.wait_for_function("() => compose.scene.seed !== 3")
    visit.settle()
    visit.page.keyboard.press("Control+z")
    visit.page.wait_for_function("() => compose.scene.seed === 3")
    visit.settle()
    assert piece not in shown(visit)
    visit.page.keyboard.press("Control+z")
    expect(visit.line_of(piece)).to_be_visible()


@pytest.mark.own_page
def test_an_edit_that_finds_no_answer_holds_the_next_home_up_only_so_long(visit: Visit) -> None:
    page = visit.page
    page.clock.install()
    piece = roomy(visit.open(SMALL.format(3)), 3)[0]["furniture"][0]["id"]
    visit.line_of(piece).click()
    held(page, "fix", lambda: page.keyboard.press("Delete"))
    with page.expect_response(lambda response: response.url.endswith("/generate")):
        page.locator("#random").click()
    assert page.evaluate("compose.scene.seed") == 3
    page.clock.fast_forward("00:10")
    page.wait_for_function("() => compose.scene.seed !== 3")
    expect(page.get_by_role("alert")).to_contain_text("The last change was not made")
    visit.settle()


def test_the_copied_link_opens_the_house_that_is_shown(visit: Visit) -> None:
    visit.open(SMALL.format(3))
    visit.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    visit.page.locator("#width").fill("2")
    visit.page.get_by_role("button", name="Generate").click()
    expect(visit.page.get_by_role("alert")).to_be_visible()
    visit.page.get_by_role("button", name="Copy link").click()
    expect(visit.page.locator("#said")).to_contain_text("it opens this house")
    link = visit.page.evaluate("navigator.clipboard.readText()")
    assert "seed=3" in link
    assert "width=12" in link
    answer = visit.after(visit.page.get_by_role("button", name="Decorate current plan").click)
    assert answer["scene"]["size"]["width"] == 12
    assert any(room["decorations"] for room in answer["scene"]["rooms"])


def test_a_key_that_is_held_asks_once(visit: Visit) -> None:
    visit.open(SMALL.format(3))
    before = sum(url.endswith("/generate") for url in visit.requests)
    for _ in range(5):
        visit.page.keyboard.down("r")
    visit.page.keyboard.up("r")
    visit.settle()
    assert sum(url.endswith("/generate") for url in visit.requests) == before + 1


def test_a_conflict_goes_with_the_home_it_spoke_of(visit: Visit) -> None:
    one, other = roomy(visit.open(SMALL.format(3)), 2)[:2]
    visit.page.get_by_label("Room", exact=True).select_option(one["id"])
    visit.page.get_by_role("button", name="Add a piece").click()
    visit.page.locator("#palette button[data-kind=pool]").click()
    expect(visit.page.locator("#conflict")).to_be_visible()
    visit.page.get_by_label("Room", exact=True).select_option(other["id"])
    visit.after(visit.page.get_by_role("button", name="Re-roll this room").click)
    expect(visit.page.locator("#conflict")).to_be_hidden()


def test_other_arrangements_are_put_away_when_an_edit_begins(visit: Visit) -> None:
    one, other = roomy(visit.open(SMALL.format(3)), 2)[:2]
    visit.page.get_by_label("Room", exact=True).select_option(one["id"])
    visit.page.get_by_role("button", name="Other arrangements…").click()
    expect(visit.page.locator("#others .others-row button")).to_have_count(3)
    visit.line_of(other["furniture"][0]["id"]).click()
    waiting = held(visit.page, "fix", lambda: visit.page.keyboard.press("k"))
    expect(visit.page.locator("#others")).to_be_hidden()  # what was chosen of them now would be none of the home that comes
    waiting.continue_()
    visit.settle()


def test_what_the_diagnosis_fixes_comes_after_an_edit_under_way(visit: Visit) -> None:
    answer, page = spoiled(visit), visit.page
    wrong = {issue["room"] for issue in answer["issues"]}
    piece = next(one for one in furniture_of(answer) if one.split("/")[0] not in wrong)
    visit.line_of(piece).click()
    waiting = held(page, "fix", lambda: page.keyboard.press("k"))
    page.keyboard.press("d")
    page.get_by_role("dialog", name="Diagnosis").get_by_role("button", name="Fix", exact=True).click()
    expect(page.locator("#diagnose_said")).to_have_text("Fixing…")
    waiting.continue_()
    expect(page.locator("#diagnose_said")).not_to_have_text("Fixing…")
    visit.settle()
    assert shown(visit)[piece]["locked"]
    expect(page.locator("#diagnose_fix")).to_be_disabled()  # nothing is wrong any more
    assert errors(answer["issues"]) != []


FILES = [("Plan as SVG", "export/svg", "house_3_plan.svg"), ("Save JSON", "export/json", "house_3.json")]
"""What saves a file, what it asks for, and how the file is called."""


def test_a_file_that_is_being_written_is_said_and_not_written_twice(visit: Visit) -> None:
    page = visit.page
    visit.open(SMALL.format(3))
    files: list[str] = []
    page.on("download", lambda download: files.append(download.suggested_filename))
    for name, call, file in seeds(FILES, 2):
        button, asked = page.get_by_role("button", name=name), len(visit.requests)
        waiting = held(page, call, button.click)
        expect(page.locator("#stage")).to_have_attribute("aria-busy", "true")
        expect(page.get_by_role("progressbar", name=f"Writing {file}")).to_contain_text(f"Writing {file}")
        button.click()
        page.locator("#random").click()  # another home does not take the file back
        page.wait_for_function("seed => compose.scene.seed !== seed", arg=3)
        with page.expect_download():
            waiting.continue_()
        visit.settle()
        assert [one for one in visit.requests[asked:] if one.endswith(call)] == [f"{visit.address}{call}"]
        assert files.pop() == file
        visit.open(SMALL.format(3))
    assert files == []


def test_a_home_that_comes_while_a_piece_is_dragged_shows_nothing_of_the_drag(visit: Visit) -> None:
    answer, page = visit.open(SMALL.format(3)), visit.page
    spots = {piece: page.evaluate("id => compose.whereIs(id)", piece) for piece in furniture_of(answer)}
    spot = next(spot for spot in spots.values() if spot)
    page.mouse.move(spot["x"], spot["y"])
    page.mouse.down()
    page.mouse.move(spot["x"] + 20, spot["y"] + 10, steps=4)
    expect(page.locator("#gaps")).to_be_visible()
    visit.after(lambda: page.keyboard.press("r"))
    expect(page.locator("#gaps")).to_be_hidden()
    expect(page.locator(".ruler-words")).to_have_count(0)
    places = page.evaluate("compose.places")
    page.mouse.move(spot["x"] + 60, spot["y"] + 30)
    page.mouse.up()
    visit.settle()
    assert page.evaluate("compose.places") == places
    assert visit.state()["selected"] is None
    assert visit.console == []
