"""Every way to edit a home: numbers, several pieces, other rooms, the plan; by pointer, keys alone, fingers. One opened page a way."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import expect

from tests.browser.acts import Act, left_as_found
from tests.browser.acts_on_pieces import ACTS, OTHER, TABLET, doing, home, ids, move_piece, piece
from tests.browser.conftest import PHONE
from tests.browser.test_editing import Bench
from tests.browser.ways import Keyboard, Touch, Way, unfold


def begin(way: Way) -> None:
    """The home is opened, seen from above."""
    Bench(way.visit, home())


@doing("5 a kind is found by its category, by search, and put where it is best; its other places are flipped through")
def _added(way: Way) -> None:
    before = ids(way)
    way.tool("add")
    palette = way.page.locator("#palette")
    way.press(palette.locator("[data-category=seating]"))
    expect(palette.locator("[data-kind=bed]")).to_be_hidden()
    palette.locator("input").fill("armch")
    expect(palette.locator("[data-kind=sofa]")).to_be_hidden()
    way.changed(lambda: way.press(palette.locator("[data-kind=armchair]")))
    (new,) = ids(way) - before
    first = piece(way, new)
    expect(way.page.locator("#places")).to_contain_text("1 of 3")
    way.changed(lambda: way.press(way.page.locator("#places button").nth(1)))
    assert (piece(way, new)["x"], piece(way, new)["z"], piece(way, new)["rotation"]) != (first["x"], first["z"], first["rotation"])
    way.press(way.page.locator("#places button").last)
    expect(way.page.locator("#places")).to_be_hidden()


@doing("5 a kind is starred")
def _starred(way: Way) -> None:
    for kinds, stars in ((1, "true"), (0, "false")):
        way.tool("add")
        palette = way.page.locator("#palette")
        palette.locator("input").fill("bookshelf")
        star = palette.locator("li:visible .star").first
        way.press(star)
        expect(star).to_have_attribute("aria-pressed", stars)
        palette.locator("input").fill("")
        way.press(palette.locator("[data-category=favourites]"))
        expect(palette.locator("li:visible")).to_have_count(kinds)
        way.press(palette.locator(".palette-head button"))
        expect(palette).to_be_hidden()


@doing("5 a kind is dragged into the house", keyboard="it is put where it is best, and moved by arrows")
def _dragged_in(way: Way) -> None:
    before = ids(way)
    way.tool("add")
    palette = way.page.locator("#palette")
    palette.locator("input").fill("armchair")
    kind = palette.locator("[data-kind=armchair]")
    expect(kind).to_be_visible()
    way.visit.settle()  # the list has moved up to what is found
    box = kind.bounding_box()
    assert box
    start = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    way.changed(lambda: way.drag(start, way.floor(8, 2), held=False))
    (new,) = ids(way) - before
    added = piece(way, new)
    assert (added["room"], added["x"], added["z"]) == ("yard", pytest.approx(2, abs=0.2), pytest.approx(2, abs=0.2))
    expect(palette).to_be_hidden()


DRAWN = "which => document.querySelector(which)?.shadowRoot?.querySelector('use[data-id]') != null"
BOX = """([which, id]) => {
    const box = document.querySelector(which).shadowRoot.querySelector(`use[data-id='${id}']`).getBoundingClientRect();
    return [box.x + box.width / 2, box.y + box.height / 2];
}"""
CHOSEN = "() => [...document.querySelector('#beside .plan-sheet').shadowRoot.querySelectorAll('.chosen')].map(one => one.dataset.of)"
SHEET = "#stage .plan-sheet"


def _on_sheet(way: Way, which: str, id_of: str) -> Any:
    way.page.wait_for_function(DRAWN, arg=which)
    way.visit.settle()
    return way.page.evaluate(BOX, [which, id_of])


@doing("3 a piece is chosen and moved in the plan")
def _in_the_plan(way: Way) -> None:
    way.view("plan")
    before = _on_sheet(way, SHEET, OTHER)
    move_piece(way)
    assert _on_sheet(way, SHEET, OTHER) != pytest.approx(before, abs=2)
    way.let_go()
    way.view("top")
    expect(way.page.locator(SHEET)).to_be_hidden()


@doing("3 plan and house beside each other choose the same")
def _beside(way: Way) -> None:
    if isinstance(way, Touch):
        way.page.set_viewport_size(TABLET)
    way.view("corner")
    way.view("split")
    at = _on_sheet(way, "#beside .plan-sheet", OTHER)
    if isinstance(way, Keyboard):
        way.choose(OTHER)
    else:
        (way.page.touchscreen.tap if isinstance(way, Touch) else way.page.mouse.click)(*at)
        way.page.wait_for_function("id => compose.state.selected === id", arg=OTHER)
    assert way.page.evaluate(CHOSEN) == [OTHER]
    way.let_go()
    way.view("split")
    expect(way.page.locator("#beside .plan-sheet")).to_be_hidden()
    if isinstance(way, Touch):
        way.page.set_viewport_size(PHONE)
    way.view("top")


@doing("3 the plan is saved to scale, and printed")
def _plan_files(way: Way) -> None:
    unfold(way, "view")
    way.select(way.page.locator("#plan_scale"), "50")
    for name, start in (("svg", b"<svg"), ("png", b"\x89PNG")):
        with way.page.expect_download() as saved:
            way.press(way.page.locator(f"#plan_{name}"))
        with open(saved.value.path(), "rb") as file:
            assert start in file.read(200)
    way.page.evaluate("() => { window.print = () => { globalThis.isPrinted = true; }; }")
    way.press(way.page.locator("#print_plan"))
    way.page.wait_for_function("() => globalThis.isPrinted")
    way.select(way.page.locator("#plan_scale"), "")


@ACTS.by_every_way()
def test_is_done_and_undone(way: Way, act: Act) -> None:
    left_as_found(way, act)
