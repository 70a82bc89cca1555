"""A home of several storeys: one is looked at, what is beneath it stays, and its plan is its own."""

from __future__ import annotations

import json
from pathlib import Path

from playwright.sync_api import expect

from tests.browser.test_accessible import violations
from tests.browser.test_editing import crate, den
from tests.browser.test_rooms_and_files import DROP
from tests.browser.visit import SMALL, Visit

DRAWN = "() => [...document.querySelector('.plan-sheet').shadowRoot.querySelectorAll('use[data-id]')].map(one => one.dataset.id)"


def two_storeys() -> str:
    """A house of a den and a loft over it, a crate in each."""
    ground, loft = den(crate("low", 1, 1))["rooms"][0], den(crate("high", 2, 1))["rooms"][0]
    levels = [{"index": 0, "elevation": 0, "height": 2.8}, {"index": 1, "elevation": 2.8, "height": 2.5}]
    return json.dumps({"levels": levels, "rooms": [ground, {**loft, "id": "loft", "level": 1}]})


def test_a_storey_is_chosen_and_its_plan_with_it(visit: Visit) -> None:
    page = visit.page
    page.set_viewport_size({"width": 1280, "height": 600})
    visit.open(SMALL.format(4))
    storey = page.locator("#storey")
    expect(storey).to_be_hidden()
    page.evaluate(DROP, ["two.json", two_storeys()])
    expect(page).to_have_title("Compose: two.json")
    visit.settle()
    expect(storey).to_be_visible()
    for width in (390, 1280):
        page.set_viewport_size({"width": width, "height": 600})
        row = page.locator(".views > :not([hidden])").filter(visible=True)
        middles = row.evaluate_all("all => all.map(one => one.getBoundingClientRect()).map(({top, height}) => top + height / 2)")
        assert max(middles) - min(middles) < 2, "storeys and views in one row"
    assert visit.state()["bodies"] == ["low"]
    low = visit.state()["walls"]

    storey.select_option("1")
    visit.settle()
    assert visit.state()["bodies"] == ["low", "high"]
    assert visit.state()["walls"] == low + 2.8
    assert violations(visit) == []
    page.locator("#show_floor").check()
    page.wait_for_function("() => compose.state.floorZones > 0")
    zones = visit.state()["floorZones"]
    page.locator("#camera_plan").click()
    visit.settle()
    assert page.evaluate(DRAWN) == ["high"]
    with page.expect_download() as saved:
        page.locator("#plan_svg").click()
    assert Path(saved.value.path()).read_text().count("<svg ") == 1

    visit.line_of("low").click()
    visit.settle()
    expect(storey).to_have_value("0")
    assert page.evaluate(DRAWN) == ["low"]
    assert visit.state()["selected"] == "low"
    assert 0 < visit.state()["floorZones"] < zones
    assert visit.console == []
