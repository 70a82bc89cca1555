"""A narrow screen: what is done on the house leaves the house where it is."""

from __future__ import annotations

import re

from playwright.sync_api import ViewportSize, expect

from tests.browser.test_drawing import DrawingBoard
from tests.browser.test_editing import ONE, OTHER, Bench, crate, den
from tests.browser.visit import SMALL, Document, Visit

WIDE_NAMES = """() => {
    const rooms = [...document.querySelectorAll('[data-room]')].map(one => one.getBBox());
    return [...document.querySelectorAll('.sheet .room-name')].filter(name => {
        const {x, y, width, height} = name.getBBox();
        const [u, v] = [x + width / 2, y + height / 2];
        const own = rooms.find(room => room.x <= u && u <= room.x + room.width && room.y <= v && v <= room.y + room.height);
        return x < own.x || own.x + own.width < x + width;
    }).map(name => name.textContent);
}"""
PHONE: ViewportSize = {"width": 390, "height": 844}
ZOOMED: ViewportSize = {"width": 720, "height": 450}
A_WORD = 60
"""How wide some letters are [CSS pixels]."""
FRAME = 4
"""How far the frame of what has the focus reaches around it [CSS pixels]."""
"""A laptop at 200 %."""
OF_LINES = """id => {
    const [region, line] = ['#yaml', `#yaml [data-id="${id}"]`].map(one => document.querySelector(one).getBoundingClientRect());
    return {above: line.top - region.top, below: region.bottom - line.bottom};
}"""
"""How far a piece's line is from the ends of the text's region [CSS pixels]."""

MUCH_TOLD = """() => {
    document.querySelector('.verdict').className = 'verdict has-issues has-errors';
    document.querySelector('[data-count=issues]').nextSibling.textContent = ' verletzte Regeln, 12 Warnungen';
    document.querySelector('[data-count=unfurnished]').textContent = '11 Räume noch nicht eingerichtet';
    document.querySelector('.unfurnished').hidden = false;
}"""
"""The foot of a home in which much is wrong, and much to be done."""

COVERED = """() => {
    const sizeOf = one => one.getBoundingClientRect().width * one.getBoundingClientRect().height;
    const names = [...document.querySelectorAll('.room-label:not(.crowded-out)')].map(sizeOf);
    const floors = compose.scene.rooms.map(({x, z, width, depth}) => {
        const [a, b] = [compose.whereAt(x, z), compose.whereAt(x + width, z + depth)];
        return Math.abs((b.x - a.x) * (b.y - a.y));
    });
    const sum = sizes => sizes.reduce((one, other) => one + other, 0);
    return sum(names) / sum(floors);
}"""
"""How much of a home's floor names cover; seen from above, where a room is a rectangle."""
MOST_COVERED = 0.18
"""Names hang where walls end, a little nearer than the floor."""


def crowd(count: int) -> Document:
    """A room of so many crates in a row: more lines than the region shows."""
    many = (crate(f"den/crate_{number:02}", 1 + 0.7 * number, 0.5, 0.4) for number in range(count))
    return den(crate(ONE, 1, 2.6), *many, crate(OTHER, 3, 2.6), width=0.7 * count + 2, depth=4)


def scrolled(visit: Visit) -> int:
    """How far the page is scrolled down [CSS pixels]."""
    down: int = visit.page.evaluate("window.scrollY")
    return down


def test_a_piece_touched_and_dragged_scrolls_its_line_into_view_and_nothing_else(visit: Visit) -> None:
    visit.page.set_viewport_size(PHONE)
    bench = Bench(visit, crowd(60))
    for piece in (OTHER, ONE):
        visit.page.mouse.click(*bench.at(piece))
        visit.settle()
        assert visit.state()["selected"] == piece
        assert scrolled(visit) == 0
        assert min(visit.page.evaluate(OF_LINES, piece).values()) >= 0
    bench.drag(OTHER, bench.at(ONE))
    assert scrolled(visit) == 0
    bench.page.mouse.up()
    bench.rest()
    visit.page.locator("#find").fill("crate_59")
    visit.page.evaluate("window.scrollTo(0, 0)")
    visit.page.locator("#find").dispatch_event("input")
    assert scrolled(visit) == 0
    assert min(visit.page.evaluate(OF_LINES, "den/crate_59").values()) >= 0


def test_the_way_out_of_a_walk_is_over_the_house_for_finger_and_key(visit: Visit) -> None:
    visit.page.set_viewport_size(PHONE)
    visit.open(SMALL.format(4))
    leave = visit.page.get_by_role("button", name="Leave the walk")
    canvas = visit.page.locator("#stage > canvas").bounding_box()
    assert canvas
    expect(leave).to_be_hidden()
    for act in (leave.click, lambda: visit.page.keyboard.press("Enter"), lambda: visit.page.keyboard.press("Escape")):
        visit.page.keyboard.press("1")
        visit.settle()
        assert visit.state()["walking"]
        at = leave.bounding_box()
        assert at
        assert at["y"] >= canvas["y"]
        assert at["y"] + at["height"] <= canvas["y"] + canvas["height"]
        leave.focus()
        act()
        visit.settle()
        assert not visit.state()["walking"]
        expect(leave).to_be_hidden()
        expect(visit.page.locator("#stage")).to_be_focused()
    assert scrolled(visit) == 0


def test_what_is_told_of_a_piece_and_what_may_be_added_stand_beneath_the_house(visit: Visit) -> None:
    visit.page.set_viewport_size(PHONE)
    bench = Bench(visit, den(crate(ONE, 1, 2.6)))
    visit.page.mouse.click(*bench.at(ONE))
    visit.settle()
    beneath(visit, "#gaps", "#piece")
    bench.page.get_by_role("button", name="Add a piece").click()
    expect(visit.page.locator("#palette li button").first).to_be_visible()
    beneath(visit, "#palette")
    slides = """one => {
        const label = one.querySelector('.palette-head label'), said = label.textContent;
        label.textContent = 'what others call it';
        const isWide = one.scrollWidth > one.clientWidth;
        label.textContent = said;  // the page is handed on
        return isWide;
    }"""
    assert not visit.page.locator(".beneath").evaluate(slides)
    expect(visit.page.locator("#gaps")).to_be_hidden()
    assert scrolled(visit) == 0


def beneath(visit: Visit, *panels: str) -> None:
    """Checks that panels are on the screen as a whole, below all of the canvas."""
    canvas = visit.page.locator("#stage > canvas").bounding_box()
    assert canvas
    for panel in panels:
        expect(visit.page.locator(panel)).to_be_visible()
        box = visit.page.locator(panel).bounding_box()
        assert box
        assert box["y"] >= canvas["y"] + canvas["height"]
        assert box["y"] + box["height"] <= PHONE["height"]
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= PHONE["width"]


def test_on_a_phone_names_leave_the_home_in_sight_and_coming_nearer_names_all(visit: Visit) -> None:
    visit.page.set_viewport_size(PHONE)
    visit.open("?program=family&seed=11")
    visit.page.keyboard.press("2")
    visit.settle()
    dots = visit.page.locator(".room-label.crowded-out")
    assert 2 <= dots.count() <= len(visit.page.evaluate("compose.scene.rooms")) - 3
    assert 0.05 < visit.page.evaluate(COVERED) < MOST_COVERED
    canvas = visit.page.locator("#stage > canvas").bounding_box()
    assert canvas
    visit.page.mouse.move(canvas["x"] + canvas["width"] / 2, canvas["y"] + canvas["height"] / 2)
    for _ in range(8):
        visit.page.mouse.wheel(0, -120)
        visit.settle()
    expect(visit.page.locator(".room-label:visible").first).to_be_visible()
    assert dots.locator("visible=true").count() == 0


def test_on_a_phones_side_what_fell_short_is_in_sight(visit: Visit) -> None:
    visit.page.set_viewport_size({"width": 844, "height": 390})
    visit.open("?program=large&area=90&seed=5")
    line = visit.page.locator("#shortfall_line")
    expect(line).to_be_visible()
    box, rooms = line.bounding_box(), visit.page.locator("[data-count=rooms]").bounding_box()
    assert box and rooms
    assert box["y"] + box["height"] <= 390
    assert rooms["y"] + rooms["height"] <= 390
    assert box["x"] + box["width"] <= 844
    pieces = visit.page.evaluate("compose.scene.rooms.flatMap(room => room.furniture.map(piece => piece.id))")
    assert any(visit.click_on(piece) for piece in pieces)
    visit.settle()
    house, told = visit.page.locator("#stage > canvas").bounding_box(), visit.page.locator("#gaps").bounding_box()
    assert house and told
    assert house["height"] > 300, "the house keeps the height that there is"
    assert house["x"] + house["width"] <= told["x"], "what is told of a piece stands beside it"
    assert told["x"] + told["width"] <= 844
    assert told["y"] + told["height"] <= house["y"] + house["height"]
    assert scrolled(visit) == 0


def test_nothing_shines_through_the_tour(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    visit.page.set_viewport_size(PHONE)
    visit.page.emulate_media(color_scheme="dark")
    visit.page.evaluate("document.getElementById('tour_again').click()")
    expect(visit.page.locator("#tour")).to_be_visible()
    title, words = (visit.page.locator(f"#tour {one}").first.bounding_box() for one in ("h2", "p"))
    assert title and words and title["y"] + title["height"] + FRAME <= words["y"], "the frame of what has the focus lies over the words"
    ground = visit.page.locator("#tour").evaluate("one => getComputedStyle(one).backgroundColor")
    assert float(re.split(r"[,/ ]+", ground.rstrip(")"))[-1]) > 0.99, ground
    visit.page.set_viewport_size(ZOOMED)
    expect(visit.page.locator("#tour button:visible").last).to_be_in_viewport(ratio=1)
    visit.page.locator("#tour button:visible").first.click()
    expect(visit.page.locator("#tour")).to_be_hidden()


def test_names_are_no_wider_than_their_rooms_and_a_phone_is_all_sheet(visit: Visit) -> None:
    before = visit.page.viewport_size
    visit.page.set_viewport_size({"width": 1440, "height": 900})
    visit.open("")
    rooms = visit.page.evaluate("compose.scene.rooms.length")
    assert rooms > 10
    board = DrawingBoard(visit).open("Change this plan")
    assert board.page.locator(".sheet .room-name").count() == rooms
    assert board.page.evaluate(WIDE_NAMES) == []
    visit.page.set_viewport_size({"width": 390, "height": 844})
    assert board.page.locator(".sheet .room-name").count() == rooms
    assert board.page.evaluate(WIDE_NAMES) == []
    assert board.page.locator(".room-name", has_text="Dining").locator("tspan").all_text_contents()[:2] == ["Dining", "room"]
    box = board.page.locator("#drawing").bounding_box()
    assert box == {"x": 0, "y": 0, "width": 390, "height": 844}
    for tool in ("choose", "furnish", "close"):
        expect(board.page.locator(f".drawing-tools [data-tool={tool}]")).to_be_in_viewport(ratio=0.99)
    visit.page.set_viewport_size({"width": 844, "height": 390})
    sheet = board.page.locator(".sheet").bounding_box()
    assert sheet and sheet["height"] > 300, "on its side what is chosen stands beside the sheet"
    board.tool("close")
    visit.page.set_viewport_size({"width": 568, "height": 320})
    expect(visit.page.locator("#shortfall_line:not(.is-asked)")).to_be_visible()
    assert visit.page.evaluate("document.documentElement.scrollWidth") == 568
    visit.page.locator("#yaml button").first.dispatch_event("click")
    visit.page.evaluate("window.scrollTo(0, 0)")
    for tool in ("undo", "delete"):
        expect(visit.page.locator(f"#tools [data-tool={tool}]")).to_be_in_viewport(ratio=0.99)
    visit.page.evaluate(MUCH_TOLD)
    expect(visit.page.get_by_role("button", name="Furnish now")).to_be_in_viewport(ratio=0.99)
    told = [visit.page.locator(one).bounding_box() for one in (".verdict", ".unfurnished > span", "#furnish_empty", "#shortfall_line")]
    ends = [0.0, *(one["x"] + one["width"] for one in told if one)]
    assert all(one and one["width"] > A_WORD and end <= one["x"] for one, end in zip(told, ends, strict=False)), told
    assert ends[-1] <= 568
    assert before
    visit.page.set_viewport_size(before)
