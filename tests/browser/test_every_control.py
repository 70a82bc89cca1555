"""Each control that no other test uses is used here, and what it does is checked."""

from __future__ import annotations

import re
from typing import Any

import pytest
from playwright.sync_api import Page, Route, ViewportSize, expect

from tests.browser.service_process import ROOT
from tests.browser.test_editing import ONE, OTHER, Bench, crate, den, poses
from tests.browser.visit import SMALL, Document, Visit, intercept, said, sent_by

PHONE: ViewportSize = {"width": 390, "height": 800}
FIRST = {"seed": 42, "program": "family", "outdoor": True, "decorate": True}


class Asked:
    """Every request of a house that the page sends from now on, each answered with the same house."""

    def __init__(self, page: Page, answer: Document) -> None:
        self.requests: list[Any] = []
        self.answer = answer
        intercept(page, "**/generate", self._take)

    def _take(self, route: Route) -> None:
        self.requests.append(route.request.post_data_json)
        route.fulfill(json=self.answer)

    def last(self, visit: Visit) -> Document:
        """What was asked for last."""
        visit.settle()
        request: Document = self.requests[-1]
        return request


def rgb(visit: Visit, color: str) -> str:
    """A colour as the browser writes it."""
    written: str = visit.page.evaluate("color => { const one = new Option().style; one.color = color; return one.color; }", color)
    return written


def test_every_field_of_the_form_is_asked_for_and_reset_takes_all_back(visit: Visit) -> None:
    asked = Asked(visit.page, visit.open(SMALL.format(4)))
    page = visit.page
    for name, text in {
        "seed": "7",
        "width": "13.5",
        "depth": "8",
        "robot_width": "0.5",
        "wall_thickness": "0.15",
        "outer_wall_thickness": "0.3",
    }.items():
        page.locator(f"#{name}").fill(text)
    page.get_by_label("Smallest room side, slider").fill("2.6")
    page.get_by_label("Depth of cuts, slider").fill("4")
    for label in ("Hallway through the house", "Outdoor rooms", "People and pets"):
        page.get_by_label(label).uncheck()
    page.get_by_label("Decorations", exact=True).check()
    page.locator("#style").select_option("rustic")
    expect(page.locator("#style_words")).to_contain_text("Walls of")
    page.locator("#generate").click()
    plan = {"width": 13.5, "depth": 8, "min_room_size": 2.6, "max_depth": 4, "use_spine": False}
    others = {"seed": 7, "outdoor": False, "decorate": True, "style": "rustic", "robot_width": 0.5, "people": False}
    others |= {"wall_thickness": 0.15, "outer_wall_thickness": 0.3}
    assert asked.last(visit) == {**plan, **others}
    page.locator("#program").select_option("by_area")
    page.locator("#area").fill("75")
    page.locator("#area").press("Enter")
    assert asked.last(visit) == {**others, "area": 75, "width": 13.5, "depth": 8}
    for extent in ("width", "depth"):
        page.locator(f"#{extent}").fill("")
    page.get_by_label("Outline").select_option("U-shaped")
    page.locator("#generate").click()
    assert asked.last(visit) == {**others, "area": 75, "outline": "U"}
    page.get_by_role("button", name="Reset").click()
    assert asked.last(visit) == FIRST
    expect(page.locator("#style")).to_have_value("")
    expect(page.get_by_label("Decorations", exact=True)).to_be_checked()
    page.locator("#seed").fill("")
    page.locator("#generate").click()
    drawn = asked.last(visit)["seed"]
    assert isinstance(drawn, int)
    expect(page.locator("#seed")).to_have_value(str(drawn))


def test_a_choice_of_looks_keeps_the_one_whose_answer_it_did_not_await(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    held: list[Route] = []
    intercept(visit.page, "**/generate", lambda route: held.append(route) if not held else route.continue_())
    with visit.page.expect_request("**/generate"):
        visit.page.get_by_label("Decorations", exact=True).check()
    visit.page.locator("#style").select_option("rustic")
    with visit.page.expect_request("**/generate") as second:
        held[0].continue_()
    visit.settle()
    sent: Document = second.value.post_data_json  # type: ignore[assignment]
    assert sent["style"] == "rustic"
    assert sent["scene"]["request"]["decorate"] is True
    assert any(room["decorations"] for room in sent["scene"]["rooms"])
    expect(visit.page.get_by_label("Decorations", exact=True)).to_be_checked()
    expect(visit.page.locator("#style")).to_have_value("rustic")


def test_groups_fold_by_click_and_by_key(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    group = visit.page.locator("details", has=visit.page.get_by_role("heading", name="Furnishing"))
    style = visit.page.locator("#style")
    group.locator("summary").click()
    expect(style).to_be_hidden()
    group.locator("summary").press("Enter")
    expect(style).to_be_visible()


def test_the_tool_bar_does_what_its_buttons_say(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1), crate(OTHER, 3, 2)))
    tool = bench.page.get_by_role("toolbar", name="Editing").get_by_role("button", name=re.compile("^(Turn|Lock|Delete)"))
    expect(tool).to_have_count(0)
    bench.choose(ONE)

    def click(name: str) -> float:
        bench.page.get_by_role("button", name=name, exact=True).click()
        bench.rest()
        return poses(bench.scene())[ONE][2]

    assert [click(name) for name in ("Turn left", "Turn left", "Turn right")] == [90, 180, 90]
    click("Lock")
    expect(bench.page.get_by_role("button", name="Lock", exact=True)).to_have_attribute("aria-pressed", "true")
    assert [piece["locked"] for piece in bench.scene()["rooms"][0]["furniture"]] == [True, False]
    assert visit.state()["marks"]["locked"] == [ONE]
    for name in ("Turn left", "Turn right", "Delete"):
        assert click(name) == 90
    bench.press("ArrowRight", "Delete")
    assert poses(bench.scene())[ONE] == (1, 1, 90)
    bench.press("k")
    assert "locked" not in visit.state()["marks"]
    bench.page.get_by_role("button", name="Delete", exact=True).press("Enter")
    bench.rest()
    assert set(poses(bench.scene())) == {OTHER}
    for name in ("Turn left", "Lock", "Delete"):
        expect(bench.page.get_by_role("button", name=name, exact=True)).to_be_hidden()
    expect(bench.page.locator("#stage")).to_be_focused()


def test_the_palette_finds_kinds_and_closes_and_a_conflict_closes(visit: Visit) -> None:
    bench = Bench(visit, den(crate(OTHER, 1.1, 1.1, 1.8, locked=True), width=2.2, depth=2.2))
    page = bench.page
    adding = page.get_by_role("button", name="Add a piece")
    palette, search = page.locator("#palette"), page.get_by_role("searchbox", name="Add a piece")
    for closing in (lambda: page.keyboard.press("Escape"), palette.get_by_role("button", name="Close").click, adding.click):
        adding.focus()
        page.keyboard.press("Enter")
        expect(search).to_be_focused()
        closing()
        expect(palette).to_be_hidden()
        expect(adding).to_be_focused()
    page.keyboard.press("a")
    known = page.request.get(visit.address + "catalog").json()["furniture"]
    offered = {kind for kind, one in known.items() if one["category"] != "dynamic"}
    shown = palette.locator("li:visible button[data-kind]")
    expect(shown).to_have_count(len(offered))
    assert set(shown.evaluate_all("all => all.map(one => one.dataset.kind)")) == offered < set(known)
    search.fill("no such thing")
    expect(shown).to_have_count(0)
    expect(palette).to_contain_text("No such kind.")
    search.fill("armchair")
    with page.expect_response(lambda response: response.url.endswith("/fix")) as asked:
        page.keyboard.press("Enter")
    assert sent_by(asked.value.request)["scene"]["rooms"][0]["furniture"][-1]["name"] == "armchair"
    bench.rest()
    conflict = page.locator("#conflict")
    expect(conflict).to_be_visible()
    asked_before = bench.fixes
    conflict.get_by_role("button", name="Close").click()
    expect(conflict).to_be_hidden()
    assert (bench.fixes, bench.scene()) == (asked_before, bench.before)


def test_the_legend_has_the_colours_that_rooms_are_drawn_with(visit: Visit) -> None:
    scene = visit.open(SMALL.format(4))["scene"]
    visit.page.locator("#legend summary").click()
    shown = visit.page.locator("#legend_rooms li").evaluate_all(
        """all => all.map(one => {
            const {backgroundColor, borderTopColor} = getComputedStyle(one.firstChild);
            return [one.textContent, backgroundColor, borderTopColor];
        })"""
    )
    drawn = {
        (said(room["type"])[0].upper() + said(room["type"])[1:], rgb(visit, room["flooring"]["color"]), rgb(visit, room["accent"]))
        for room in scene["rooms"]
    }
    assert sorted(map(tuple, shown)) == sorted(drawn)
    dots = visit.page.locator(".room-label .dot").evaluate_all("all => all.map(one => getComputedStyle(one).backgroundColor)")
    assert set(dots) == {accent for _, _, accent in drawn}
    assert visit.page.locator("#legend_marks li").count() == 5


def test_an_issue_of_a_room_takes_the_room_in_hand(visit: Visit) -> None:
    def miss(route: Route) -> None:
        answer = route.fetch().json()
        room = answer["scene"]["rooms"][1]["id"]
        wrong = {"rule": "missing_required", "severity": "warning", "room": room, "ids": [], "amount": None, "message": "there is no oven"}
        route.fulfill(json={**answer, "issues": [wrong]})

    intercept(visit.page, "**/generate", miss)
    room = visit.open(SMALL.format(4))["scene"]["rooms"][1]
    visit.page.get_by_role("button", name="there is no oven").click()
    expect(visit.page.locator("#room_choice")).to_have_value(room["id"])
    expect(visit.page.locator("#room_facts")).to_contain_text(f"{len(room['furniture'])}")
    visit.page.locator("#room_choice").select_option("")
    expect(visit.page.locator("#room_facts")).to_be_hidden()
    expect(visit.page.locator("#reroll")).to_be_disabled()


@pytest.mark.own_page
def test_a_narrow_screen_begins_with_the_house_and_unfolds_the_rest(visit: Visit) -> None:
    visit.page.set_viewport_size(PHONE)
    visit.open(SMALL.format(4))
    page = visit.page
    assert page.locator("details.group").evaluate_all("all => all.filter(one => one.open).length") == 1
    for chosen in (False, True):  # tools are in one row, those of a piece in another; both move sideways where they are longer
        if chosen:
            page.locator("#yaml [data-id]").first.evaluate("line => line.click()")
        rows = set()
        for tool in page.locator("#tools button:enabled").all():
            tool.scroll_into_view_if_needed()
            box = tool.bounding_box()
            assert box
            assert 0 <= box["x"] <= box["x"] + box["width"] <= PHONE["width"]
            rows.add(box["y"])
        assert len(rows) == 1 + chosen
        assert page.evaluate("document.documentElement.scrollWidth") == PHONE["width"]
    text, toggle = page.locator("#yaml"), page.get_by_role("button", name="Text", exact=True)
    for visible in (False, True):
        toggle.click()
        expect(toggle).to_have_attribute("aria-expanded", str(visible).lower())
        expect(text).to_be_visible(visible=visible)
    page.get_by_role("button", name="Add a piece").click()
    page.locator("#palette").get_by_role("button", name="Close").click()
    expect(page.locator("#palette")).to_be_hidden()


def test_the_keys_are_told_on_the_page_as_in_the_documents(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    dialog = visit.page.get_by_role("dialog", name="Keys")
    visit.page.get_by_role("button", name="Keys").click()
    expect(dialog).to_be_visible()
    visit.page.keyboard.press("r")
    dialog.get_by_role("button", name="Close").click()
    expect(dialog).to_be_hidden()
    visit.page.keyboard.press("?")
    expect(dialog).to_be_visible()
    told = set(dialog.locator("kbd").all_text_contents())
    visit.page.keyboard.press("Escape")
    expect(dialog).to_be_hidden()
    assert visit.state()["selected"] is None
    table = re.search(r"\| key \| does \|\n\|---\|---\|\n((?:\|.*\n)+)", (ROOT / "docs" / "page.md").read_text())
    assert table
    named = {key for row in table[1].splitlines() for key in re.split("[, ]+(?!Up|Down)", row.split("|")[1].strip())}
    assert named - {"Page Up", "Page Down"} <= told
    assert sum(url.endswith("/generate") for url in visit.requests) == 1


def tab_to(page: Page, wanted: str) -> None:
    """Press Tab until something has the focus."""
    for _ in range(80):
        if page.evaluate("wanted => document.activeElement.matches(wanted)", wanted):
            return
        page.keyboard.press("Tab")
    raise AssertionError(f"{wanted} cannot be reached")


def made_by_keys(visit: Visit, seed: int) -> Document:
    """Ask for the house of a seed by keys alone."""
    press = visit.page.keyboard.press
    tab_to(visit.page, "a[href='#controls']")
    press("Enter")
    tab_to(visit.page, "#seed")
    press("Control+a")
    visit.page.keyboard.type(str(seed))
    scene: Document = visit.after(lambda: press("Enter"))["scene"]
    assert scene["seed"] == seed
    return scene


def chosen_by_keys(visit: Visit, piece: str) -> None:
    """Choose a piece in the text and go to it in the house, by keys alone."""
    press = visit.page.keyboard.press
    tab_to(visit.page, "#yaml button")
    for _ in range(80):
        if visit.page.evaluate("document.activeElement.dataset.id") == piece:
            break
        press("ArrowDown")
    press("Enter")
    assert visit.state()["selected"] == piece
    press("Enter")
    expect(visit.page.locator("#stage")).to_be_focused()


def test_keys_alone_make_a_house_move_and_lock_a_piece_and_read_the_diagnosis(visit: Visit) -> None:
    page, press = visit.page, visit.page.keyboard.press
    visit.open(SMALL.format(4))
    piece = _movable(visit, made_by_keys(visit, 9))
    chosen_by_keys(visit, piece)
    before = page.evaluate("id => compose.places[id]", piece)
    with page.expect_response(lambda response: response.url.endswith("/fix")):
        press("ArrowDown")
    visit.settle()
    assert page.evaluate("id => compose.places[id]", piece) != before
    press("k")
    visit.settle()
    assert visit.state()["marks"]["locked"] == [piece]
    dialog = page.get_by_role("dialog", name="Diagnosis")
    press("d")
    expect(page.locator(f'#report [data-id="{piece}"]').first).to_contain_text("locked")
    expect(dialog).to_contain_text("changed since")
    press("Escape")
    expect(dialog).to_be_hidden()
    press("Control+z")
    press("Control+z")
    visit.settle()
    assert page.evaluate("id => compose.places[id]", piece) == before


def _movable(visit: Visit, scene: Document) -> str:
    """A piece that stands at no wall and by itself, and that the service lets stand 5 cm further south."""
    for piece in (piece for room in scene["rooms"] for piece in room["furniture"]):
        if piece["wall"] or piece["on"] or piece["under"]:
            continue
        piece["z"] += 0.05
        if not visit.page.request.post(visit.address + "fix", data={"scene": scene}).json()["moves"]:
            return str(piece["id"])
        piece["z"] -= 0.05
    raise AssertionError("nothing can be moved")
