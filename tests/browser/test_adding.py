"""Adding by looking: pictures, categories, favourites, the best place and others, a kind dragged in, a room arranged in other ways."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import expect

from catalogs import load_catalogs
from tests.browser.test_editing import ONE, Bench, crate, den, poses
from tests.browser.visit import SMALL, Visit, sent_by

COLORS = """selector => [...document.querySelectorAll(selector)].map(canvas => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    return new Set(Array.from({ length: data.length / 4 }, (_, i) => data.slice(4 * i, 4 * i + 4).join())).size;
})"""
"""How many colours the canvases hold that a selector finds."""


def added(bench: Bench) -> list[str]:
    return [piece for piece in poses(bench.scene()) if piece not in poses(bench.before)]


@pytest.mark.draws_all
def test_pictures_are_drawn_of_kinds_in_view_and_categories_choose_among_them(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 2, 1.5)))
    page = bench.page
    drawn = visit.state()["geometries"]
    bench.press("a")
    page.wait_for_function("selector => document.querySelector(selector)", arg="#palette li canvas")
    visit.settle()
    page.wait_for_function(f"() => ({COLORS})('#palette li:first-child canvas')[0] > 20")
    sizes = page.locator("#palette li small")
    assert re.fullmatch(r"\d+×\d+×\d+ cm", sizes.first.text_content() or "")
    assert (
        sizes.evaluate_all(
            "all => all.filter(one => one.getClientRects().length > 1 || one.scrollWidth > one.parentElement.clientWidth).length"
        )
        == 0
    )
    page.get_by_role("group", name="Categories").get_by_role("button", name="Bed", exact=True).click()
    kinds = page.locator("#palette li:visible [data-kind]").evaluate_all("all => all.map(one => one.dataset.kind)")
    assert {"bed", "bunk_bed"} <= set(kinds)
    expect(page.locator("#palette [data-kind=bunk_bed]")).to_contain_text(re.compile("^Bunk bed"))
    assert "sofa" not in kinds
    visit.settle()
    page.wait_for_function(f"() => ({COLORS})('#palette li:not([hidden]) canvas').slice(0, 3).every(count => count > 20)")
    page.keyboard.press("Escape")
    visit.settle()
    assert visit.state()["geometries"] <= drawn + 12, "what was pictured is given back"
    assert visit.idle() == 0
    assert visit.console == []


def test_favourites_are_found_again_after_a_reload(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    page = visit.page
    for label in ("Favourite: bookshelf", "Favourite: armchair"):
        if not page.locator("#palette").is_visible():
            page.get_by_role("button", name="Add a piece").click()
        page.get_by_role("button", name=label, exact=True).press("Enter")
    page.get_by_role("button", name="Favourite: armchair", exact=True).click()
    visit.reopened(page.reload)
    page.get_by_role("button", name="Add a piece").click()
    page.get_by_role("group", name="Categories").get_by_role("button", name="favourites").click()
    expect(page.locator("#palette li:visible")).to_have_count(1)
    expect(page.locator("#palette li:visible [data-kind]")).to_have_attribute("data-kind", "bookshelf")


def test_with_no_room_chosen_a_kind_goes_to_a_room_of_a_type_that_has_it(visit: Visit) -> None:
    scene = visit.open(SMALL.format(4))["scene"]
    page, rooms = visit.page, load_catalogs().rooms
    for kind in ("toilet", "stove", "double_vanity"):
        having = {name for name, room in rooms.items() for piece in room.pieces if kind in (one.kind for one in piece.variants)}
        page.keyboard.press("a")
        with page.expect_request("**/place") as asked:
            page.locator(f"#palette [data-kind={kind}]").click()
        assert sent_by(asked.value)["room"]["type"] in having & {room["type"] for room in scene["rooms"]}
        visit.settle()
        assert visit.state()["selected"] is not None, "the new piece"
        page.locator("#stage").focus()
        while visit.state()["selected"] is not None:
            page.keyboard.press("Escape")
    visit.settle()
    assert visit.console == []


def test_a_piece_goes_where_the_service_finds_it_best_and_its_other_places_are_flipped_through(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 3, 2.5), width=6, depth=5))
    page = bench.page
    bench.press("a")
    page.get_by_role("searchbox", name="Add a piece").fill("bookshelf")
    with page.expect_response(lambda response: response.url.endswith("/place")) as placed:
        page.locator("#palette button[data-kind=bookshelf]").click()
        bench.rest()
    answer = placed.value.json()
    scenes = [answer["scene"], *(other["scene"] for other in answer["alternatives"])]
    assert len(scenes) == 3
    (new,) = added(bench)
    wanted = [poses(scene)[new] for scene in scenes]
    expect(page.locator("#places")).to_contain_text("Place 1 of 3")
    assert poses(bench.scene())[new] == wanted[0]
    seen = []
    for _ in range(3):
        page.get_by_role("button", name="Another place").press("Enter")
        bench.rest()
        seen.append(poses(bench.scene())[new])
    assert seen == [wanted[1], wanted[2], wanted[0]]
    assert poses(bench.scene())[ONE] == poses(bench.before)[ONE]
    bench.press("Escape")
    expect(page.locator("#places")).to_be_hidden()
    bench.press(*["Control+z"] * 4)
    assert bench.scene() == bench.before
    assert visit.console == []


@pytest.mark.draws_all
def test_a_room_is_shown_in_other_arrangements_of_which_one_is_taken(visit: Visit) -> None:
    made, page = visit.open(SMALL.format(4)), visit.page
    room = next(one["id"] for one in made["scene"]["rooms"] if one["type"] in ("bedroom_master", "bedroom"))
    page.locator("#room_choice").select_option(room)
    page.get_by_role("button", name="Other arrangements…").press("Enter")
    choices = page.locator("#others .others-row button")
    expect(choices).to_have_count(3)
    visit.settle()
    page.wait_for_function(f"() => ({COLORS})('#others canvas').every(count => count > 20)")
    before = page.evaluate("compose.scene")
    page.keyboard.press("Escape")
    expect(page.locator("#others")).to_be_hidden()
    page.get_by_role("button", name="Other arrangements…").press("Enter")
    expect(choices).to_have_count(3)
    choices.nth(1).press("Enter")
    visit.settle()
    expect(page.locator("#others")).to_be_hidden()
    after = page.evaluate("compose.scene")
    differ = [one["id"] for one, other in zip(before["rooms"], after["rooms"], strict=True) if one["furniture"] != other["furniture"]]
    assert differ == [room]
    page.keyboard.press("Control+z")
    visit.settle()
    assert page.evaluate("compose.scene") == before
    assert visit.console == []
