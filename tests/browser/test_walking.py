"""Walking: walls, shut doors and furniture are in the way; doors and fronts open; a map shows where one is, and goes there."""

from __future__ import annotations

from io import BytesIO

import pytest
from PIL import Image, ImageStat
from playwright.sync_api import expect

from tests.browser.test_looking import entrance_of, holds
from tests.browser.visit import SMALL, Document, Visit, furniture_of, said
from tests.sweeps import seeds

HALF_BODY = 0.2
KNOWN = "() => compose.state.knowsFloor"
ON_MAP = """([x, z]) => {
    const svg = document.querySelector('#minimap svg');
    const at = new DOMPoint(x, z).matrixTransform(svg.getScreenCTM());
    svg.dispatchEvent(new MouseEvent('click', {clientX: at.x, clientY: at.y}));
}"""
"""Clicks on the map where a place of the plan is."""
FRONTS = """compose.scene.rooms.flatMap(room => Object.entries(compose.scene.certificate.rooms[room.id]?.fronts ?? {})
    .flatMap(([piece, ones]) => Object.keys(ones).map(one => `${piece}/${one}`)))"""
ALL_OPEN = """() => compose.house.doors.leaves.forEach(({opening}, i) => {
    if (!compose.house.doors.open.includes(opening)) compose.house.doors.toggle(i);
})"""
"""Opens the doors that are shut: one may stand open from the way there."""
OFTEN_OF_ONE_MOMENT = """() => {
    const real = requestAnimationFrame.bind(globalThis);
    let told = 0, frames = 0, last = -1;
    globalThis.requestAnimationFrame = (step) => real((now) => {
        if (now !== last) told = [now, told, told + 0.01][frames++ % 3];
        last = now;
        step(told);
    });
}"""
"""Lets one of three frames say the time of the one before and one hardly a later one, as frames of a busy machine may; whoever asks for a
frame is told the same of it."""
AT_REST_FRAMES = 3


def walk_into(visit: Visit) -> None:
    """Begins to walk, once the floor is known."""
    visit.page.keyboard.press("1")
    visit.page.wait_for_function(KNOWN)
    visit.settle()


def until_stopped(visit: Visit, key: str) -> list[float]:
    """Holds a key until frames pass in which it moves nothing; returns where one stands."""
    visit.page.keyboard.down(key)
    eye: list[float] = visit.state()["eye"]
    while True:
        visit.idle(AT_REST_FRAMES)
        now: list[float] = visit.state()["eye"]
        if now == eye:
            break
        eye = now
    visit.page.keyboard.up(key)
    visit.settle()
    return eye


def is_within(rectangles: list[list[float]], x: float, z: float) -> bool:
    """Whether some rectangle holds a place."""
    return any(west - 1e-6 <= x <= east + 1e-6 and north - 1e-6 <= z <= south + 1e-6 for west, north, east, south in rectangles)


def floor_of(visit: Visit, answer: Document) -> list[list[float]]:
    """The free floor that the service tells the page, in the house."""
    with visit.page.expect_response(lambda response: response.url.endswith("/floor")) as asked:
        walk_into(visit)
    rooms = {room["id"]: room for room in answer["scene"]["rooms"]}
    told = [(rooms[floor["room"]], place) for floor in asked.value.json()["rooms"] for place in floor["free"]]
    return [[room["x"] + at[0], room["z"] + at[1], room["x"] + at[2], room["z"] + at[3]] for room, at in told]


def test_walls_furniture_and_shut_doors_stop_who_walks(visit: Visit) -> None:
    answer = visit.open(SMALL.format(4))
    free = floor_of(visit, answer)
    room = entrance_of(answer)
    for key in ("w", "d", "s", "a", "w"):
        eye = until_stopped(visit, key)
        assert holds(room, eye), key
        corners = [(eye[0] + dx, eye[2] + dz) for dx in (-HALF_BODY, HALF_BODY) for dz in (-HALF_BODY, HALF_BODY)]
        assert all(is_within(free, x, z) for x, z in corners), key


def test_the_map_tells_the_room_and_goes_there_through_doors_that_are_open(visit: Visit) -> None:
    answer = visit.open(SMALL.format(4))
    walk_into(visit)
    start = entrance_of(answer)
    status = visit.page.locator("#minimap [role=status]")
    expect(status).to_have_text(said(start["type"]))
    inner = [room for room in answer["scene"]["rooms"] if room["id"] != start["id"] and not room["outdoor"]]

    def walked_to(room: Document) -> bool:
        visit.page.evaluate(ON_MAP, [room["x"] + room["width"] / 2, room["z"] + room["depth"] / 2])
        visit.settle()
        return holds(room, visit.state()["eye"])

    assert not all(walked_to(room) for room in inner), "some door is shut"
    visit.page.evaluate(ALL_OPEN)
    for room in seeds(inner, 2):
        assert walked_to(room), room["id"]
        expect(status).to_have_text(said(room["type"]))
    visit.page.keyboard.press("Escape")
    expect(visit.page.locator("#minimap")).to_be_hidden()


@pytest.mark.parametrize("begin", ["1", "camera_walk"])
def test_who_walks_has_nothing_of_a_chosen_piece_in_the_way(visit: Visit, begin: str) -> None:
    piece = furniture_of(visit.open(SMALL.format(4)))[0]
    visit.line_of(piece).click()
    assert visit.state()["selected"] == piece
    if begin == "1":
        visit.page.keyboard.press(begin)
    else:
        visit.page.locator(f"#{begin}").click()
    visit.settle()
    assert (visit.state()["walking"], visit.state()["selected"]) == (True, None)


@pytest.mark.own_page
def test_frames_of_one_moment_and_hardly_later_ones_stop_nobody(visit: Visit) -> None:
    answer = visit.open(SMALL.format(4))
    walk_into(visit)
    visit.page.evaluate(ALL_OPEN)
    visit.page.evaluate(OFTEN_OF_ONE_MOMENT)
    start = entrance_of(answer)
    room = next(one for one in answer["scene"]["rooms"] if one["id"] != start["id"] and not one["outdoor"])
    visit.page.evaluate(ON_MAP, [room["x"] + room["width"] / 2, room["z"] + room["depth"] / 2])
    visit.settle()
    assert holds(room, visit.state()["eye"])


IN_THE_OPEN = """names => names.filter((name) => {
    const at = compose.whereIs(name);
    return at && document.elementFromPoint(at.x, at.y).localName === 'canvas';
})"""
"""Those of the named that a click meets: they are in view, and no panel of the page lies over them."""


def test_a_click_opens_a_front_in_passing_and_the_key_what_is_looked_at(visit: Visit) -> None:
    visit.open("?program=studio&seed=3")
    walk_into(visit)
    fronts = visit.page.evaluate(FRONTS)
    seen: list[str] = []
    for _ in range(8):
        seen = visit.page.evaluate(IN_THE_OPEN, fronts)
        if seen:
            break
        visit.held("ArrowLeft")
    assert seen, "no front is seen in a turn"
    assert visit.click_on(seen[0])
    visit.settle()
    assert visit.state()["openFronts"] == [seen[0]]
    assert visit.state()["selected"] is None


SET_HOUR = "hour => { const field = document.querySelector('#hour'); field.value = hour; field.dispatchEvent(new Event('input')); }"


@pytest.mark.draws_all
def test_lamps_light_the_rooms_in_the_evening(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    visit.page.locator("#camera_walk").click()
    visit.settle()
    seen = {}
    for hour in (15, 19):
        visit.page.evaluate(SET_HOUR, hour)
        visit.settle()
        picture = Image.open(BytesIO(visit.page.locator("#stage > canvas").screenshot())).convert("RGB")
        seen[hour] = ImageStat.Stat(picture).mean
    red, _, blue = seen[19]
    assert red - blue > seen[15][0] - seen[15][2] + 10, "it is warm light"
    assert red > 0.55 * seen[15][0], "it is no dark house"


@pytest.mark.draws_all
def test_from_outside_a_home_stands_in_the_dusk_of_its_evening(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    seen = []
    for hour in (12, 19, 12):
        visit.page.evaluate(SET_HOUR, hour)
        visit.settle()
        picture = Image.open(BytesIO(visit.page.locator("#stage").screenshot())).convert("L")
        over = picture.crop((picture.width // 2, 2, picture.width // 2 + 20, 6))  # the house, seen whole, does not reach so high
        seen.append(ImageStat.Stat(over).mean[0])
    assert seen[1] < seen[0] - 30
    assert seen[2] == seen[0]
