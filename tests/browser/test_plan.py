"""The plan: an architect's sheet beneath the canvas, in which one chooses, moves and undoes as in 3D; printed by itself."""

from __future__ import annotations

import re
from typing import Literal

import pytest
from playwright.sync_api import expect

from tests.browser.visit import SMALL, Document, Visit
from tests.sweeps import seeds

DRAWN = "() => document.querySelector('.plan-sheet').shadowRoot.querySelector('svg use[data-id]') !== null"
USE = "id => document.querySelector('.plan-sheet').shadowRoot.querySelector(`use[data-id='${id}']`)"
WHERE = f"id => {{ const box = ({USE})(id).getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; }}"
NUMBERS = "() => [...document.querySelector('.plan-sheet').shadowRoot.querySelectorAll('text.number')].map(one => one.textContent)"


def planned(visit: Visit, seed: int) -> Document:
    answer = visit.open(SMALL.format(seed))
    visit.page.keyboard.press("4")
    visit.page.wait_for_function(DRAWN)
    visit.settle()
    return answer


@pytest.mark.parametrize("seed", [4])
def test_pieces_lie_on_the_sheet_where_the_canvas_has_them(visit: Visit, seed: int) -> None:
    answer = planned(visit, seed)
    rooms = answer["scene"]["rooms"]
    for room in rooms:
        for piece in room["furniture"]:
            x, z = room["x"] + piece["x"], room["z"] + piece["z"]
            seen = visit.page.evaluate("at => compose.whereAt(...at)", [x, z])
            across, along = visit.page.evaluate(WHERE, piece["id"])
            assert abs(seen["x"] - across) < 3 and abs(seen["y"] - along) < 3, piece["id"]


def test_rooms_measure_on_the_sheet_what_they_measure_in_the_scene(visit: Visit) -> None:
    answer = planned(visit, 4)
    scene = answer["scene"]
    told = set(visit.page.evaluate(NUMBERS))
    size, walls = scene["size"], scene["wall_thickness"]
    assert {f"{size[side] + walls:.2f}" for side in ("width", "depth")} <= told


SIZES = """which => [...document.querySelector(which).shadowRoot.querySelectorAll('text')].flatMap(one => {
    const [style, at] = [getComputedStyle(one), one.getScreenCTM()];
    const hidden = style.visibility === 'hidden' || one.getClientRects().length === 0;
    return hidden ? [] : [[one.textContent, one.classList.contains('name'), parseFloat(style.fontSize) * Math.hypot(at.a, at.b)]];
})"""
"""The words of a sheet that are seen, whether each is a name, and how high its letters are, px."""
HOMES = {"?program=family&decorate=true&seed=42": True, "?program=studio&seed=9": True, "?program=large&outline=T&seed=5": False}
"""Homes, and whether there is room for their lengths and all their areas in the plan."""


@pytest.mark.parametrize("home", seeds([*HOMES], 2))
def test_numbers_and_areas_are_read_or_left_out(visit: Visit, home: str) -> None:
    page = visit.page
    page.set_viewport_size({"width": 1440, "height": 900})
    scene = visit.open(home)["scene"]
    page.locator("#fold_reading").click()
    areas = 0
    for key, which in (("4", "#stage .plan-sheet"), ("5", "#beside .plan-sheet")):
        page.keyboard.press(key)
        floors = "([which, count]) => document.querySelector(which).shadowRoot.querySelectorAll('polygon.floor').length === count"
        page.wait_for_function(floors, arg=[which, len(scene["rooms"])])
        visit.settle()
        seen = page.evaluate(SIZES, which)
        assert [one for one in seen if one[2] < (8 if one[1] else 10.9)] == []
        assert sum(name for _, name, _ in seen) >= len(scene["rooms"])
        areas += sum("m²" in words for words, _, _ in seen)
        if which.startswith("#stage") and HOMES[home]:
            assert sum(len(re.findall(r"[0-9]+[.][0-9]{2}", words)) for words, _, _ in seen) >= 3 * len(scene["rooms"])
            assert sum(" × " in words for words, _, _ in seen) >= 0.6 * len(scene["rooms"])
    assert areas >= (len(scene["rooms"]) if HOMES[home] else 1)


CUT = """() => [...document.querySelector('.plan-sheet').shadowRoot.querySelectorAll('.lengths')].map(one => {
    const [seen, box] = [document.querySelector('#stage').getBoundingClientRect(), one.getBoundingClientRect()];
    const within = box.left >= seen.left && box.right <= seen.right && box.top >= seen.top && box.bottom <= seen.bottom;
    return [one.dataset.along, getComputedStyle(one).visibility === 'visible', within];
})"""
"""Of the lengths along x and along z: whether they are shown, and whether all of them is on the canvas."""


@pytest.mark.own_page
def test_lengths_are_shown_whole_or_not_at_all_and_the_plan_fills_the_canvas(visit: Visit) -> None:
    visit.page.set_viewport_size({"width": 1280, "height": 720})
    scene = visit.open("?width=30&depth=9&seed=4")["scene"]
    visit.page.locator("#fold_reading").click()
    visit.page.keyboard.press("4")
    visit.page.wait_for_function(DRAWN)
    visit.settle()
    assert visit.page.evaluate(CUT) == [["x", True, True], ["z", False, False]]
    west, east = (visit.page.evaluate("at => compose.whereAt(...at)", [x, 0])["x"] for x in (0, scene["size"]["width"]))
    assert east - west > 0.85 * visit.page.evaluate("document.getElementById('stage').clientWidth")
    for _ in range(3):
        visit.page.keyboard.press("-")
        visit.settle()
    assert [shown for _, shown, _ in visit.page.evaluate(CUT)] in ([True, True], [False, False]), (
        "there is room for both, or they are too small"
    )


def test_letters_stay_as_large_as_the_view_comes_nearer(visit: Visit) -> None:
    planned(visit, 4)
    before = visit.page.evaluate(SIZES, "#stage .plan-sheet")
    canvas = visit.page.locator("#stage > canvas").bounding_box()
    assert canvas
    visit.page.mouse.move(canvas["x"] + canvas["width"] / 2, canvas["y"] + canvas["height"] / 2)
    for _ in range(4):
        visit.page.mouse.wheel(0, -240)
        visit.settle()
    after = visit.page.evaluate(SIZES, "#stage .plan-sheet")
    assert min(size for _, _, size in after) >= 8
    assert max(size for _, _, size in after) < 1.5 * max(size for _, _, size in before)


def test_a_piece_is_chosen_moved_and_put_back_in_the_plan(visit: Visit) -> None:
    answer = planned(visit, 4)
    room = max(answer["scene"]["rooms"], key=lambda room: room["width"] * room["depth"])
    piece = next(piece for piece in room["furniture"] if visit.click_on(piece["id"]))
    before = visit.page.evaluate(WHERE, piece["id"])
    visit.page.keyboard.press("q")
    visit.settle()
    assert visit.page.evaluate(WHERE, piece["id"]) != pytest.approx(before, abs=1)
    visit.page.keyboard.press("Control+z")
    visit.settle()
    assert visit.page.evaluate(WHERE, piece["id"]) == pytest.approx(before, abs=1)


def test_a_drag_beside_all_moves_the_sheet_and_never_turns_it(visit: Visit) -> None:
    planned(visit, 4)
    before = visit.state()
    canvas = visit.page.locator("#stage > canvas").bounding_box()
    assert canvas
    x, y = canvas["x"] + 20, canvas["y"] + canvas["height"] - 80
    visit.page.mouse.move(x, y)
    visit.page.mouse.down()
    visit.page.mouse.move(x + 90, y - 40, steps=4)
    visit.page.mouse.up()
    visit.settle()
    after = visit.state()
    moved = [after["eye"][i] - before["eye"][i] for i in range(3)]
    assert moved[0] < -0.1 and moved[2] > 0.05 and abs(moved[1]) < 1e-3
    assert after["target"][0] - before["target"][0] == pytest.approx(moved[0], abs=1e-3)
    visit.page.keyboard.press("3")
    visit.settle()
    expect(visit.page.locator("#stage .plan-sheet")).to_be_hidden()


BESIDE = "document.querySelector('#beside .plan-sheet').shadowRoot"
FRAMES = f"() => [...{BESIDE}.querySelectorAll('.chosen')].map(one => one.dataset.of)"
FRAMED = f"id => {BESIDE}.querySelector('.chosen')?.dataset.of === id"
UNCOVERED = """id => {
    const at = compose.whereIs(id);
    return at !== null && document.elementFromPoint(at.x, at.y)?.tagName === 'CANVAS';
}"""
AT = f"() => {BESIDE}.querySelector('.chosen').getAttribute('transform')"
LEFT_ALONE = f"before => {BESIDE}.querySelector('.chosen')?.getAttribute('transform') !== before"
SEEN = f"""() => {{ const sheet = {BESIDE}, of = use => {{
    const box = use.getBoundingClientRect(), [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    return sheet.elementFromPoint(x, y) === use ? [[use.dataset.id, x, y]] : [];
}}; return [...sheet.querySelectorAll('use[data-sort=furniture]')].flatMap(of); }}"""


LENGTHS = """sheet => [...sheet.shadowRoot.querySelectorAll('.lengths .number')].map(one => one.getBoundingClientRect().width > 0)"""


def test_no_length_lies_half_beside_the_house(visit: Visit) -> None:
    """Of a home so small that they are near it."""
    page = visit.page
    page.set_viewport_size({"width": 1280, "height": 800})
    assert len(visit.open("?width=4&depth=3&outdoor=false&seed=4")["scene"]["rooms"]) == 1
    for key, sheet, is_seen in (("4", "#stage", True), ("5", "#beside", False)):
        page.keyboard.press(key)
        page.wait_for_function(f"() => document.querySelector('{sheet} .plan-sheet').shadowRoot.querySelector('use[data-id]') !== null")
        visit.settle()
        seen = page.locator(f"{sheet} .plan-sheet").evaluate(LENGTHS)
        assert len(seen) > 2 and set(seen) == {is_seen}
    page.keyboard.press("5")


def test_what_is_chosen_beside_or_in_the_house_is_chosen_in_both(visit: Visit) -> None:
    page = visit.page
    visit.open(SMALL.format(4))
    page.locator("#fold_reading").click()
    page.get_by_role("button", name="Plan", exact=True).click()
    page.keyboard.press("5")
    expect(page.get_by_role("button", name="3D")).to_have_attribute("aria-pressed", "true")
    page.wait_for_function(f"() => {BESIDE}.querySelector('use[data-id]') !== null")
    visit.settle()
    expect(page.get_by_role("button", name="Split")).to_have_attribute("aria-pressed", "true")
    stage, beside = (page.locator(one).bounding_box() for one in ("#stage", "#beside"))
    assert stage and beside and stage["x"] + stage["width"] <= beside["x"] and abs(stage["width"] - beside["width"]) < 2
    seen = page.evaluate(SEEN)
    first, x, y = seen[0]
    page.mouse.click(x, y)
    page.wait_for_function("id => compose.state.selected === id", arg=first)
    assert page.evaluate(FRAMES) == [first]
    page.keyboard.press("Escape")
    page.wait_for_function("() => compose.state.selected === null")
    assert page.evaluate(FRAMES) == []
    second = next(one for one, _, _ in seen[1:] if page.evaluate(UNCOVERED, one))
    assert visit.click_on(second)
    page.wait_for_function(FRAMED, arg=second)
    there = page.evaluate(AT)
    page.keyboard.press("q")
    page.wait_for_function(LEFT_ALONE, arg=there)
    visit.settle()
    page.reload()
    page.wait_for_function(f"() => globalThis.compose?.scene && {BESIDE}.querySelector('use[data-id]') !== null")
    visit.settle()
    page.get_by_role("button", name="Split").click()
    expect(page.locator("#beside")).to_be_hidden()
    assert visit.console == []


ON_PAPER = """() => {
    const paper = document.querySelector('#view_print');
    const dots = paper.getContext('2d').getImageData(0, 0, paper.width, paper.height).data;
    let inked = 0;
    for (let at = 0; at < dots.length; at += 4) inked += dots[at] + dots[at + 1] + dots[at + 2] < 700;
    return [[...dots.slice(0, 4)], inked / (paper.width * paper.height)];
}"""
"""The dot in the corner of the view as it is printed, and the share of dots that are not white."""
ON_SHEET = "() => [...document.querySelectorAll('#stage > *')].filter(one => one.offsetParent).map(one => one.className)"
PRINT = """() => { window.print = () => {
    const sheet = document.querySelector('#plan_print');
    const wide = sheet.naturalWidth;
    globalThis.printed = fetch(sheet.src).then(answer => answer.text()).then(text => [wide, text]);
}; }"""


@pytest.mark.own_page
def test_the_plan_is_printed_alone_and_to_scale(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    visit.page.evaluate(PRINT)
    visit.page.get_by_role("button", name="Print the plan").click()
    visit.page.wait_for_function("() => globalThis.printed")
    pixels, text = visit.page.evaluate("() => globalThis.printed")
    wide = re.search(r'<svg [^>]*width="([\d.]+)mm"', text)
    assert wide and pixels == pytest.approx(float(wide[1]) / 25.4 * 96, abs=1.5)
    expect(visit.page.locator("#plan_print")).to_be_hidden()
    visit.page.emulate_media(media="print")
    expect(visit.page.locator("#stage")).to_be_hidden()
    visit.page.emulate_media(media="screen")


@pytest.mark.draws_all
@pytest.mark.parametrize("colours", seeds(["dark", "light"], 2))
def test_the_browsers_own_print_prints_what_is_in_view_on_white(visit: Visit, colours: Literal["light", "dark"]) -> None:
    page = visit.page
    page.emulate_media(color_scheme=colours)
    visit.open(SMALL.format(4))
    page.pdf(landscape=True)  # the browser says beforeprint
    corner, shares = page.evaluate(ON_PAPER)
    assert corner == [255, 255, 255, 255]
    assert shares > 0.05
    page.keyboard.press("4")
    visit.settle()
    page.emulate_media(media="print")
    expect(page.locator("#view_print")).to_be_hidden()
    assert page.evaluate(ON_SHEET) == ["plan-sheet"]
    looks = page.locator(".plan-sheet").first.evaluate("one => [getComputedStyle(one)].flatMap(it => [it.filter, it.backgroundColor])")
    assert looks == ["none", "rgb(255, 255, 255)"]
    page.emulate_media(media="screen")
    expect(page.locator("#view_print")).to_be_hidden()
    assert visit.console == []
