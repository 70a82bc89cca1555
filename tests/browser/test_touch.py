"""Fingers: one turns the house, two come nearer, one that stays on a piece drags it; what is pressed is large enough for them."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.conftest import PHONE, visiting
from tests.browser.service_process import ServiceProcess
from tests.browser.test_gaps import LAID, keep_apart
from tests.browser.visit import MOVED, SMALL, Visit
from tests.browser.ways import Touch

SMALLEST = 44
PRESSED = """least => [...document.querySelectorAll('button, select, summary, input:not([type=checkbox], [type=range], [type=file])')]
    .filter(one => one.checkVisibility() && !one.matches('.yaml-line, .report-line, .skips *'))
    .filter(one => { const box = one.getBoundingClientRect(); return box.width < least || box.height < least; })
    .map(one => one.outerHTML.slice(0, 90))"""
"""What is shown to be pressed and is smaller than so many CSS pixels."""


@pytest.fixture
def touched(browser: Browser, service: ServiceProcess) -> Iterator[Visit]:
    """A visit from a phone."""
    with visiting(browser, service.address, PHONE, has_touch=True, is_mobile=True) as visit:
        yield visit


def test_fingers_turn_come_nearer_and_drag(touched: Visit) -> None:
    visit, page = touched, touched.page
    scene = visit.open(SMALL.format(4))["scene"]
    touch = Touch(visit)
    canvas = page.locator("#stage > canvas").bounding_box()
    assert canvas
    x, y = canvas["x"] + canvas["width"] / 2, canvas["y"] + canvas["height"] / 2

    def looks() -> list[list[float]]:
        visit.settle()
        state = visit.state()
        return [state["eye"], state["target"]]

    before = looks()
    touch.fingers("touchStart", [(x, y)])
    for step in range(1, 5):
        touch.fingers("touchMove", [(x + 15 * step, y)])
    touch.lift((x + 60, y))
    page.wait_for_function(MOVED, arg=before)
    turned = looks()
    assert turned[1] == pytest.approx(before[1], abs=0.01)
    assert visit.state()["selected"] is None
    touch.fingers("touchStart", [(x - 20, y), (x + 20, y)])
    for step in range(1, 5):
        touch.fingers("touchMove", [(x - 20 - 10 * step, y), (x + 20 + 10 * step, y)])
    touch.lift((x - 60, y), (x + 60, y))
    page.wait_for_function(MOVED, arg=turned)
    nearer = looks()

    def far(at: list[list[float]]) -> float:
        return sum((a - b) ** 2 for a, b in zip(*at, strict=True))

    assert far(nearer) < far(turned)

    seen = {piece["id"]: page.evaluate("id => compose.whereIs(id)", piece["id"]) for room in scene["rooms"] for piece in room["furniture"]}
    held, at = next((one, spot) for one, spot in seen.items() if spot and abs(spot["x"] - x) < 150 and abs(spot["y"] - y) < 200)
    place = page.evaluate("id => compose.places[id][0]", held)
    touch.fingers("touchStart", [(at["x"], at["y"])])
    page.wait_for_function("id => compose.state.selected === id", arg=held)
    for step in range(1, 5):
        touch.fingers("touchMove", [(at["x"] + 10 * step, at["y"])])
    page.wait_for_function("([id, x]) => compose.places[id][0] !== x", arg=[held, place])
    assert visit.state()["eye"] == pytest.approx(nearer[0], abs=0.01)
    touch.lift((at["x"] + 40, at["y"]))
    expect(page.locator("#stage")).to_have_attribute("aria-busy", "false")
    presses_nothing_small(page)


def presses_nothing_small(page: Page) -> None:
    """Whether every button, with all groups and the palette open, is as large as a finger, on a phone's width."""
    page.locator("details.group").evaluate_all("all => all.forEach(one => { one.open = true; })")
    page.locator("#tour_again").tap()
    expect(page.locator("#tour")).to_be_visible()
    assert page.evaluate(PRESSED, SMALLEST) == []
    page.locator("#tour").get_by_role("button", name="Skip").tap()
    expect(page.locator("#tour")).to_be_hidden()
    page.locator("#tools [data-tool=add]").tap()
    expect(page.locator("#palette li button").first).to_be_visible()
    assert page.evaluate(PRESSED, SMALLEST) == []
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    expect(page.locator("kbd").filter(visible=True)).to_have_count(0)


def test_names_make_way_for_the_distances_of_a_piece_that_is_tapped(touched: Visit) -> None:
    scene = touched.open("?program=one_bed&style=mid_century&seed=12&outdoor=true")["scene"]
    sofa = next(piece["id"] for room in scene["rooms"] for piece in room["furniture"] if piece["name"] == "sofa")
    touch = Touch(touched)
    for kitchen in ("stove", "refrigerator"):  # a length comes to lie under the finger as it is chosen
        touch.choose(next(piece["id"] for room in scene["rooms"] for piece in room["furniture"] if piece["name"] == kitchen))
        expect(touched.page.locator("#gaps")).to_be_visible()
        expect(touched.page.locator("#gaps input")).to_have_count(0)
        touched.page.keyboard.press("Escape")
        touched.settle()
    touch.choose(sofa)
    laid = touched.page.evaluate(LAID)
    touched.page.set_viewport_size({"width": 320, "height": 568})
    for tool in ("undo", "redo", "left", "right", "lock", "delete"):
        expect(touched.page.locator(f"#tools [data-tool={tool}]")).to_be_in_viewport(ratio=1)
    assert any(words.startswith("sofa") for words, *_ in laid)
    keep_apart(laid)
