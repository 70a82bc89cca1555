"""Fingers: what they press is large enough for them, and what they choose is read; `test_every_way_of_a_home.py` has what they do."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from tests.browser.conftest import PHONE, visiting
from tests.browser.service_process import ServiceProcess
from tests.browser.test_gaps import LAID, keep_apart
from tests.browser.visit import SMALL, Visit
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


def test_what_is_pressed_is_as_large_as_a_finger(touched: Visit) -> None:
    """With all groups and the palette open, on a phone's width."""
    page = touched.page
    touched.open(SMALL.format(4))
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
