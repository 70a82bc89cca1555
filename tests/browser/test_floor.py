"""The floor on demand: the zones that are drawn are the service's, and go when they are not wished for."""

from __future__ import annotations

from playwright.sync_api import expect

from tests.browser.visit import SMALL, Visit


def test_the_floor_shown_is_the_services(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    assert visit.state()["floorZones"] == 0
    with visit.page.expect_response(lambda response: response.url.endswith("/floor")) as asked:
        visit.page.keyboard.press("o")
    floors = asked.value.json()["rooms"]
    wanted = sum(len(floor[zone]) for floor in floors for zone in ("free", "doors", "windows"))
    visit.page.wait_for_function("wanted => compose.state.floorZones === wanted", arg=wanted)
    assert wanted > len(floors)
    shown = visit.page.locator("#floor_legend .swatch-zone")
    expect(shown).to_have_count(sum(any(floor[zone] for floor in floors) for zone in ("free", "doors", "windows", "turning", "short")))
    expect(visit.page.locator("#floor_legend")).to_be_visible()
    expect(visit.page.locator("#show_floor")).to_be_checked()
    visit.page.locator("#show_floor").uncheck()
    assert visit.state()["floorZones"] == 0
    expect(shown).to_have_count(0)
    assert visit.console == []
