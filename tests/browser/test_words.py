"""What the page says where little is there to be seen: beside a piece in hand, of a scene without rooms, in few colours, of no number."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.browser.test_editing import ONE, OTHER, Bench, crate, den
from tests.browser.test_looking import PROJECTED
from tests.browser.visit import SMALL, Visit

COLORS = "all => all.map(one => getComputedStyle(one).backgroundColor + getComputedStyle(one).borderTopColor)"


def test_the_name_of_a_dragged_piece_goes_with_it(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1, 0.6), crate(OTHER, 3.4, 2.4, 0.6)))
    tip = bench.page.locator(".body-tip")
    from_x, from_y = bench.at(ONE)
    bench.page.mouse.move(from_x, from_y)
    expect(tip).to_be_visible()
    visit.settle()
    before = tip.bounding_box()
    bench.drag(ONE, (from_x + 150, from_y + 60))
    visit.settle()
    after = tip.bounding_box()
    bench.page.mouse.up()
    bench.rest()
    assert before
    assert after
    assert after["x"] - before["x"] == pytest.approx(150, abs=25)
    assert after["y"] - before["y"] == pytest.approx(60, abs=25)


def test_a_scene_without_rooms_is_ground_seen_from_above_and_says_so(visit: Visit) -> None:
    none = visit.page.locator("#no_rooms")
    Bench(visit, {"rooms": []})
    expect(none).to_contain_text("No rooms")
    expect(none).to_be_in_viewport()
    none.get_by_role("button", name="Draw a plan").click()
    expect(visit.page.locator("#drawing")).to_be_visible()
    visit.page.locator("#drawing").get_by_role("button", name="Close").click()
    for key in ("3", "2"):
        visit.page.keyboard.press(key)
        visit.settle()
        state = visit.state()
        assert state["eye"][1] > 5
        assert state["eye"][1] > state["target"][1] + 5
    canvas = visit.page.locator("#stage > canvas").bounding_box()
    [seen] = visit.page.evaluate(PROJECTED, [[6, 0, 4.5]])
    assert canvas
    assert seen["x"] == pytest.approx(canvas["width"] / 2, abs=canvas["width"] / 10)
    visit.page.keyboard.press("1")
    visit.settle()
    assert visit.console == []
    visit.page.unroute("**/generate")
    visit.after(lambda: visit.page.keyboard.press("r"))
    expect(none).to_be_hidden()


def test_colours_that_tell_apart_are_kept_in_forced_colours(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    visit.page.locator("#legend summary").click()
    shown = visit.page.locator("#legend .swatch, .room-label .dot, .plan-sheet, #drawing .sheet")
    before = shown.evaluate_all(COLORS)
    assert len(set(before)) > 6
    visit.page.emulate_media(forced_colors="active")
    assert visit.page.evaluate("matchMedia('(forced-colors: active)').matches")
    assert shown.evaluate_all(COLORS) == before
    lines = visit.page.locator("#yaml button")
    lines.first.click()
    assert len(set(lines.evaluate_all(COLORS)[:2])) == 2


@pytest.mark.parametrize(
    "query", ["?width=NaN", "?seed=" + "9" * 400, "?max_depth=deep&area=1e999", "?program.bedrooms=many&min_room_size=-"]
)
def test_what_is_no_number_is_said_beside_its_field_and_nothing_on_the_console(visit: Visit, query: str) -> None:
    visit.page.goto(visit.address + query)
    expect(visit.page.get_by_role("alert")).to_be_visible()
    expect(visit.page.locator("[aria-invalid=true]").first).to_be_focused()
    # What a browser says by itself of a refused call is not the page's.
    assert [said for said in visit.console if "status of 422" not in said] == []


def test_the_palette_offers_at_once_what_the_page_was_told(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    asked = len(visit.requests)
    visit.page.keyboard.press("a")
    assert visit.page.locator("#palette li:visible").count() > 50
    expect(visit.page.locator("#palette > p")).to_be_hidden()
    assert visit.requests[asked:] == []
