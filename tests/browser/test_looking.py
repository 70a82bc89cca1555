"""Looking at the house: floors that are clicked, cameras, the cut through the walls, names on demand."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.browser.visit import SMALL, Document, Visit

EYE_HEIGHT = 1.6
PROJECTED = "points => points.map(at => compose.viewport.project(compose.viewport.camera.position.clone().set(...at)))"
"""Where points of the house are seen on the canvas [CSS pixels]."""

DRAWN_WHEN_FOLDED = """async () => {
    const [stage, canvas] = [document.querySelector('#stage'), document.querySelector('#stage > canvas')];
    const copy = Object.assign(document.createElement('canvas'), {width: 80, height: 60}).getContext('2d', {willReadFrequently: true});
    const drawn = () => {
        copy.clearRect(0, 0, 80, 60);
        copy.drawImage(canvas, 0, 0, 80, 60);
        return [canvas.clientWidth, copy.getImageData(0, 0, 80, 60).data.filter((value, at) => at % 4 === 3 && value > 0).length];
    };
    const before = canvas.clientWidth;
    let told;
    const changed = new Promise(done => { told = done; });
    const watch = new ResizeObserver(() => { if (canvas.clientWidth !== before) told(drawn()); });
    watch.observe(stage);
    document.querySelector('#fold_controls').click();
    const [width, pixels] = await changed;
    watch.disconnect();
    document.querySelector('#fold_controls').click();
    return [width - before, pixels];
}"""
"""By how much folding the controls makes the canvas wider, and how many of its 4,800 places are drawn, before any of it is shown."""


def entrance_of(answer: Document) -> Document:
    """The room that the main entrance leads into."""
    rooms: list[Document] = answer["scene"]["rooms"]
    return next(room for room in rooms if not room["outdoor"] and any(one["main_entrance"] for one in room["openings"]))


def holds(room: Document, eye: list[float]) -> bool:
    """Whether a room's rectangle holds a point of the plan."""
    return bool(room["x"] <= eye[0] <= room["x"] + room["width"] and room["z"] <= eye[2] <= room["z"] + room["depth"])


@pytest.mark.own_page
def test_a_floor_clicked_tells_its_room(visit: Visit) -> None:
    rooms = visit.open(SMALL.format(4))["scene"]["rooms"]
    visit.page.evaluate("globalThis.told = []; compose.onRoom = id => told.push(id); 0")
    visit.page.keyboard.press("2")
    visit.settle()
    clicked = [room["id"] for room in rooms if visit.click_on(room["id"])]
    assert len(clicked) == len(rooms)
    assert visit.page.evaluate("told") == clicked


@pytest.mark.draws_all
def test_a_canvas_of_another_size_is_shown_with_the_house_and_never_empty(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    wider, drawn = visit.page.evaluate(DRAWN_WHEN_FOLDED)
    assert wider > 0 and drawn > 100
    visit.settle()
    assert visit.idle() == 0


def test_walls_before_the_viewer_are_low_unless_they_are_wanted_whole(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    page, lowers = visit.page, visit.page.get_by_label("Lower the walls before me")
    expect(lowers).to_be_checked()
    assert visit.state()["lowered"] == ["east", "south"]
    visit.held("ArrowRight")
    eye, target = visit.state()["eye"], visit.state()["target"]
    ahead = {"north": target[2] - eye[2], "east": eye[0] - target[0], "south": eye[2] - target[2], "west": target[0] - eye[0]}
    assert {side for side in ahead if side in visit.state()["lowered"]} >= {max(ahead, key=lambda side: ahead[side])}
    assert all(ahead[side] > 0 for side in visit.state()["lowered"])
    page.keyboard.press("2")
    visit.settle()
    assert visit.state()["lowered"] == []
    page.keyboard.press("3")
    lowers.uncheck()
    visit.settle()
    assert visit.state()["lowered"] == []
    visit.reopened(page.reload)
    expect(lowers).not_to_be_checked()
    assert visit.state()["lowered"] == []
    lowers.check()
    visit.settle()
    assert visit.state()["lowered"] == ["east", "south"]
    assert visit.idle() == 0


def test_a_walk_begins_within_the_entrance_and_goes_where_the_keys_say(visit: Visit) -> None:
    answer = visit.open(SMALL.format(4))
    visit.page.keyboard.press("1")
    visit.settle()
    state = visit.state()
    start = state["eye"]
    assert state["walking"]
    assert start[1] == EYE_HEIGHT
    assert holds(entrance_of(answer), start)
    ahead = [state["target"][i] - start[i] for i in (0, 2)]
    visit.page.wait_for_function("() => compose.state.knowsFloor")
    reached = start
    for key, way in (("w", 1), ("ArrowDown", -1)):  # on and back: a wall may be near
        before = reached
        visit.held(key)
        reached = visit.state()["eye"]
        assert ((reached[0] - before[0]) * ahead[0] + (reached[2] - before[2]) * ahead[1]) * way > 0
        assert reached[1] == EYE_HEIGHT
    visit.page.keyboard.press("Escape")
    visit.settle()
    assert not visit.state()["walking"]
    assert visit.state()["eye"][1] > EYE_HEIGHT


def test_keys_in_a_field_do_not_walk_and_a_drag_looks_around(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    visit.page.get_by_role("button", name="Walk through").click()
    visit.settle()
    expect(visit.page.get_by_role("button", name="Walk through")).to_have_attribute("aria-pressed", "true")
    before = visit.state()
    visit.page.locator("#seed").press("ArrowUp")
    visit.settle()
    assert visit.state()["eye"] == before["eye"]
    box = visit.page.locator("#stage > canvas").bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    visit.page.mouse.move(x, y)
    visit.page.mouse.down()
    visit.page.mouse.move(x + 120, y, steps=3)
    visit.page.mouse.up()
    visit.settle()
    assert visit.state()["eye"] == before["eye"]
    assert visit.state()["target"] != before["target"]
    visit.page.get_by_role("button", name="Top down").click()
    visit.settle()
    assert not visit.state()["walking"]


def test_all_pieces_are_named_on_demand_and_no_name_covers_another(visit: Visit) -> None:
    answer = visit.open(SMALL.format(4))
    names = visit.page.locator(".piece-label:visible")
    assert names.count() == 0
    visit.page.keyboard.press("2")
    visit.page.keyboard.press("l")
    visit.settle()
    furniture = [piece for room in answer["scene"]["rooms"] for piece in room["furniture"]]
    boxes = [box for label in names.all() if (box := label.bounding_box())]
    assert len(furniture) / 2 < len(boxes) <= len(furniture)
    if len(boxes) < len(furniture):
        expect(visit.page.locator("#labels_words")).to_have_text(f"{len(boxes)} of {len(furniture)} fit")
    for index, one in enumerate(boxes):
        for other in boxes[index + 1 :]:
            apart_x = abs(one["x"] + one["width"] / 2 - other["x"] - other["width"] / 2) >= (one["width"] + other["width"]) / 2
            assert apart_x or abs(one["y"] - other["y"]) >= (one["height"] + other["height"]) / 2
    visit.page.get_by_label("Names of all pieces").uncheck()
    expect(names).to_have_count(0)


@pytest.mark.draws_all
def test_walls_are_drawn_as_high_as_the_slider_says_and_whole_to_who_walks(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    canvas = visit.page.locator("#stage > canvas")
    low, height = canvas.screenshot(), visit.state()["walls"]
    visit.page.locator("#cut").fill("2.8")
    visit.settle()
    assert visit.state()["walls"] == 2.8 > height
    assert canvas.screenshot() != low
    visit.page.locator("#cut").fill("0.9")
    visit.page.keyboard.press("1")
    visit.settle()
    assert visit.state()["walls"] >= 2.4
    visit.page.get_by_role("button", name="3D").click()
    visit.settle()
    expect(visit.page.locator("#cut_words")).to_have_text("0.9 m")
    assert visit.state()["walls"] == 0.9


def test_a_tap_on_the_floor_goes_there_and_only_names_in_sight_are_shown(visit: Visit) -> None:
    answer = visit.open(SMALL.format(4))
    rooms = answer["scene"]["rooms"]
    visit.page.keyboard.press("1")
    visit.page.wait_for_function("() => compose.state.knowsFloor")
    visit.settle()
    start = visit.state()["eye"]
    shown = visit.page.locator(".room-label:visible .words").all_text_contents()
    assert len(shown) < len(rooms)
    room = entrance_of(answer)
    assert visit.click_on(room["id"])
    visit.settle()
    reached = visit.state()
    assert reached["walking"]
    assert reached["eye"] != start
    assert reached["eye"][1] == EYE_HEIGHT
    assert any(holds(one, reached["eye"]) for one in rooms)


def test_the_whole_house_is_in_view_in_windows_of_any_shape(visit: Visit) -> None:
    for width, height in ((390, 800), (1600, 700), (1000, 700)):
        visit.page.set_viewport_size({"width": width, "height": height})
        scene = visit.open(SMALL.format(8))["scene"]
        canvas = visit.page.locator("#stage > canvas").bounding_box()
        assert canvas
        ends = [(room, i, j) for room in scene["rooms"] for i in (0, 1) for j in (0, 1)]
        corners = [[room["x"] + i * room["width"], 0, room["z"] + j * room["depth"]] for room, i, j in ends]
        seen = visit.page.evaluate(PROJECTED, corners)
        across, along = [at["x"] / canvas["width"] for at in seen], [at["y"] / canvas["height"] for at in seen]
        assert min(across + along) > 0
        assert max(across + along) < 1
        assert max(max(across) - min(across), max(along) - min(along)) > 0.6
