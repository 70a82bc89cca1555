"""A room in hand and furnishing it anew; saving a scene whole and opening one."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import pytest
import yaml
from playwright.sync_api import FilePayload, expect

from compose_homes import export, load
from tests.browser.test_drawing import DrawingBoard
from tests.browser.visit import SMALL, Document, Visit

DROP = """async ([name, text, spaces = 0]) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([text, ' '.repeat(spaces)], name));
    const send = type => window.dispatchEvent(new DragEvent(type, {dataTransfer: transfer, bubbles: true, cancelable: true}));
    send('dragover');
    const shown = !document.querySelector('#drop').hidden;
    send('drop');
    return shown && document.querySelector('#drop').hidden;
}"""


def saved(visit: Visit, format: str) -> tuple[str, str]:
    """Save what is shown; returns the file's name and text."""
    with visit.page.expect_download() as caught:
        visit.page.locator(f"#download_{format}").click()
    return caught.value.suggested_filename, Path(caught.value.path()).read_text()


def choose(visit: Visit, scene: Document, type_of: str) -> str:
    """Take the first room of a type in hand; returns its id."""
    room: str = next(room["id"] for room in scene["rooms"] if room["type"] == type_of)
    visit.page.locator("#room_choice").select_option(room)
    return room


def test_a_room_is_told_and_furnished_anew_alone(visit: Visit) -> None:
    scene = visit.open(SMALL.format(4))["scene"]
    expect(visit.page.locator("#reroll")).to_be_disabled()
    chosen = choose(visit, scene, "living_room")
    room = next(one for one in scene["rooms"] if one["id"] == chosen)
    facts = visit.page.locator("#room_facts")
    wall = scene["wall_thickness"]
    expect(facts).to_contain_text(f"{(room['width'] - wall) * (room['depth'] - wall):.1f} m²")
    expect(facts).to_contain_text(room["flooring"]["type"])
    others = {one["id"]: one["furniture"] for one in scene["rooms"] if one["id"] != chosen}
    after = visit.after(lambda: visit.page.locator("#reroll").click())["scene"]
    assert {one["id"]: one["furniture"] for one in after["rooms"] if one["id"] != chosen} == others
    assert next(one for one in after["rooms"] if one["id"] == chosen)["furniture"] != room["furniture"]
    expect(visit.page.locator("#room_choice")).to_have_value(chosen)


def test_what_is_saved_is_the_scene(visit: Visit) -> None:
    scene = visit.open(SMALL.format(4))["scene"]
    name, text = saved(visit, "json")
    assert name == "house_4.json"
    assert json.loads(text) == scene
    name, text = saved(visit, "yaml")
    assert name == "house_4.yaml"
    assert yaml.load(text, yaml.CSafeLoader) == scene


def test_a_dropped_yaml_file_is_shown(visit: Visit) -> None:
    scene = visit.open(SMALL.format(4))["scene"]
    _, text = saved(visit, "yaml")
    visit.after(lambda: visit.page.keyboard.press("r"))
    assert visit.page.evaluate(DROP, ["mine.yaml", text]) is True
    expect(visit.page).to_have_title("Compose: mine.yaml")
    visit.settle()
    _, again = saved(visit, "json")
    assert json.loads(again) == scene
    assert visit.page.url == visit.address
    expect(visit.page.get_by_role("button", name="Copy link")).to_be_disabled()
    expect(visit.page.locator("#said")).to_contain_text("No link holds this home: save it under Saved homes")
    words, plan = (visit.page.locator(where).bounding_box() for where in ("#said", "#plan"))
    assert words and plan and plan["y"] - words["y"] - words["height"] >= 8, "the line beneath does not touch the words"
    furniture = [room["furniture"] for room in scene["rooms"]]
    decorated = visit.after(visit.page.get_by_role("button", name="Decorate current plan").click)["scene"]
    assert [room["furniture"] for room in decorated["rooms"]] == furniture
    assert visit.count("decorations") > 0


def test_back_forward_and_a_reload_find_the_dropped_file_again(visit: Visit) -> None:
    scene = visit.open(SMALL.format(4))["scene"]
    copied = {**scene, "seed": 77}
    visit.page.evaluate(DROP, ["mine", json.dumps(copied)])
    expect(visit.page).to_have_title("Compose: mine")
    assert visit.reopened(visit.page.go_back) == scene
    expect(visit.page.get_by_role("button", name="Copy link")).to_be_enabled()
    expect(visit.page.locator("#said")).to_have_text("")
    for again in (visit.page.go_forward, visit.page.reload):
        again()
        expect(visit.page).to_have_title("Compose: mine")
        visit.settle()
        assert visit.page.evaluate("compose.scene.seed") == 77
        assert len(visit.state()["bodies"]) > 10


def test_an_exported_glb_opens_as_its_scene_and_a_reload_finds_it_again(visit: Visit) -> None:
    scene = visit.open(SMALL.format(4))["scene"]
    (content,) = export(load(json.dumps({**scene, "seed": 78})), "glb").values()
    file: FilePayload = {"name": "home.glb", "mimeType": "model/gltf-binary", "buffer": content}
    with visit.page.expect_file_chooser() as chooser:
        visit.page.locator("#open_file").click()
    chooser.value.set_files([file])
    expect(visit.page).to_have_title("Compose: home.glb")
    visit.page.reload()
    expect(visit.page).to_have_title("Compose: home.glb")
    visit.settle()
    assert visit.page.evaluate("compose.scene") == {**scene, "seed": 78}


def test_a_chosen_file_that_is_no_scene_is_refused_in_the_services_words(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    rooms = visit.count("rooms")
    file: FilePayload = {
        "name": "bad.json",
        "mimeType": "application/json",
        "buffer": b'{"rooms": [{"id": "<b>a</b>", "width": -3, "depth": 2}]}',
    }
    with visit.page.expect_file_chooser() as chooser:
        visit.page.locator("#open_file").click()
    chooser.value.set_files([file])
    expect(visit.page.get_by_role("alert")).to_contain_text("width")
    assert visit.count("rooms") == rooms


TRAP = "<img src=x onerror=console.error('ran')>"
BROKEN = {
    "unclosed.yaml": ("rooms: [a", "Not YAML"),
    "notes": ("hello there", "It is none of the files that are read here: scenes as JSON"),
    "empty.json": ("", "It is empty."),
    "list.json": ("[1, 2]", "none of the files"),
    "null.json": ("null", "none of the files"),
    "nan.json": ('{"rooms": [{"width": NaN, "depth": 2}]}', "rooms[0].width: is nan; allowed: a number above 0"),
    "walls.geojson": ('{"type": "FeatureCollection", "unit": "m", "features": []}', "It holds no rooms. What is needed: at least one room"),
    "huge.json": ('{"rooms": [{"width": 1e300, "depth": 2}]}', "up to 1000"),
    "named <b>.json": ('{"rooms": [{"width": 3, "depth": 2, "furniture": 7}]}', "rooms[0].furniture"),
    "large.json": ('{"rooms": []}', "It is larger than 8 MB"),
}
SPACES = {"large.json": 9_000_000}
"""What is added to a file by the page: to send it there takes as long as all else."""


@pytest.mark.own_page
def test_a_scene_of_others_is_drawn_and_its_names_are_text(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    bodies: list[Document] = [
        {"id": f"{TRAP}\"'&{side}", "name": TRAP, "category": TRAP, "x": x, "z": 1, "width": 0.5, "depth": 0.5, "height": 1}
        for side, x in (("in", 1), ("out", 9))
    ]
    backwards = [[0, 4], [2, 4], [2, 2], [4, 2], [4, 0], [0, 0]]
    door = {"id": TRAP, "kind": "door", "wall": "east", "position": 3, "width": 0.9}
    room = {"id": TRAP, "type": TRAP, "width": 4, "depth": 4, "outline": backwards, "openings": [door], "furniture": bodies}
    visit.page.evaluate(DROP, ["others", json.dumps({"rooms": [room]})])
    expect(visit.page).to_have_title("Compose: others")
    visit.settle()
    assert visit.state()["bodies"] == [body["id"] for body in bodies]
    assert visit.page.locator("[data-count=issues]").inner_text() != "0"
    at, corner = (visit.page.evaluate("id => compose.whereIs(id)", one) for one in (TRAP, bodies[0]["id"]))
    assert at and corner
    visit.page.locator("#room_choice").select_option(TRAP)
    visit.line_of(bodies[0]["id"].replace("\\", "\\\\").replace('"', '\\"')).click()
    for key in ("f", "l"):
        visit.page.keyboard.press(key)
    visit.page.keyboard.press("d")
    expect(visit.page.locator("#report")).to_contain_text(f"{TRAP} (")
    assert visit.page.locator("img:not(#plan_print, #starts *)").count() == 0
    assert visit.console == []


def test_broken_files_are_refused_by_name_and_the_house_stays(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    shown = visit.page.evaluate("compose.scene")
    notice = visit.page.get_by_role("alert")
    for name, (text, words) in BROKEN.items():
        visit.page.evaluate(DROP, [name, text, SPACES.get(name, 0)])
        expect(notice).to_contain_text(f"{name} cannot be read")
        expect(notice).to_contain_text(words)
        notice.get_by_role("button", name="Close").click()
    assert visit.page.evaluate("compose.scene") == shown
    expect(visit.page.get_by_role("button", name="Copy link")).to_be_enabled()


SQUARE = [[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]
BESIDE = [[4, 0], [8, 0], [8, 3], [4, 3], [4, 0]]


def drawn_plan() -> str:
    """A plan of two rooms as GeoJSON, a door between them, another that leads outside, a line that is in no wall, and a storey above."""
    rooms = [
        {"type": "Feature", "properties": {"name": name, "level": level}, "geometry": {"type": "Polygon", "coordinates": [ring]}}
        for name, level, ring in (("Schlafzimmer", 0, SQUARE), ("Salon", 0, BESIDE), ("Attic", 1, SQUARE))
    ]
    lines = [[[4, 1], [4, 1.9]], [[5, 0], [5.9, 0]], [[20, 20], [20.9, 20]]]
    doors = [{"type": "Feature", "properties": {"kind": "door"}, "geometry": {"type": "LineString", "coordinates": line}} for line in lines]
    return json.dumps({"type": "FeatureCollection", "unit": "m", "features": rooms + doors})


def test_a_dropped_plan_is_told_of_and_furnished(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    page = visit.page
    expect(page.get_by_role("button", name="Furnish empty rooms")).to_be_hidden()
    page.evaluate(DROP, ["flat.geojson", drawn_plan()])
    expect(page).to_have_title("Compose: flat.geojson")
    visit.settle()
    assert visit.count("rooms") == 2
    expect(page.locator("#imported_list")).to_contain_text("Left out (2)")
    page.get_by_role("button", name="Open storey 1").click()
    expect(page.get_by_role("button", name="Open storey 0")).to_be_visible()
    visit.settle()
    assert page.evaluate("compose.scene.rooms.map(room => room.name)") == ["Attic"]
    assert visit.requests.count(visit.address + "import?level=1") == 1  # not in base64, a third larger
    page.get_by_role("button", name="Open storey 0").click()
    expect(page.get_by_role("button", name="Open storey 1")).to_be_visible()
    visit.settle()
    assert visit.count("rooms") == 2
    expect(page.locator("#status")).to_contain_text("Not furnished yet")
    expect(page.locator("#status .broken, #status .kept, #issues").filter(visible=True)).to_have_count(0)
    expect(page.get_by_role("button", name="Furnish empty rooms")).to_be_visible()
    page.get_by_role("button", name="Furnish now").click()
    expect(page.get_by_role("button", name="Furnish empty rooms")).to_be_hidden()
    visit.settle()
    expect(page.locator("#status .unfurnished")).to_be_hidden()
    assert [room["type"] for room in page.evaluate("compose.scene.rooms")] == ["bedroom", "living_room"]
    assert min(page.evaluate("compose.scene.rooms.map(room => room.furniture.length)")) > 1, "of a seed that the page draws"
    page.keyboard.press("Control+z")
    visit.settle()
    assert visit.count("furniture") == 0
    visit.after(lambda: page.get_by_role("button", name="Random").click())
    expect(page.locator("#imported")).to_be_hidden()
    assert visit.console == []
    ring = [[x * 70, z * 70] for x, z in SQUARE]  # as large as a room in cm, and in inches
    room = {"type": "Feature", "properties": {"name": "Salon"}, "geometry": {"type": "Polygon", "coordinates": [ring]}}
    page.evaluate(DROP, ["unsaid.geojson", json.dumps({"type": "FeatureCollection", "features": [room]})])
    page.get_by_role("button", name="Read it in inches").click()
    expect(page).to_have_title("Compose: unsaid.geojson")
    visit.settle()
    assert page.evaluate("compose.scene.rooms[0].width") == pytest.approx(280 * 0.0254, abs=0.002)


def test_rooms_that_share_floor_are_not_furnished_until_they_do_not(visit: Visit) -> None:
    """As files have it: on the sheet no room is drawn over another."""
    outlines = {"Bedroom": ((0, 0), (4, 0), (4, 4), (0, 4)), "Living room": ((3, 0), (8, 0), (8, 4), (3, 4))}
    rooms = [{"properties": {"name": name}, "geometry": {"type": "Polygon", "coordinates": [points]}} for name, points in outlines.items()]
    plan = {"type": "FeatureCollection", "unit": "m", "features": [{"type": "Feature", **room} for room in rooms]}
    visit.open(SMALL.format(4))
    page = visit.page
    content = json.dumps(plan).encode()
    given: FilePayload = {"name": "plan.geojson", "mimeType": "application/json", "buffer": content}
    visit.reopened(lambda: page.locator("#file").set_input_files(given))
    board = DrawingBoard(visit).open("Change this plan")
    checked = page.locator("#imported", has_text="rooms that share floor")
    board.furnish()
    expect(checked).to_be_visible()
    with page.expect_response(lambda response: response.url.endswith("/furnish")) as caught:
        page.locator("#furnish_now").evaluate("one => one.click()")
    visit.settle()
    for scene in (caught.value.json()["scene"], page.evaluate("compose.scene")):
        assert [len(room["furniture"]) for room in scene["rooms"]] == [0, 0]
    expect(checked).to_be_visible()
    expect(page.locator("[data-count=optimality]")).to_have_text("2 rooms left as they were")
    board.open("Change this plan")
    page.locator(".drawing-side .issue", has_text="rooms that share floor").click()
    page.get_by_role("button", name="Delete the room").click()
    board.judge()
    assert len(board.furnish()["scene"]["rooms"]) == 1


MARKS = """() => [...document.querySelectorAll('.mark-label:not([hidden])')].map(one => {
    const {x, y, width, height} = one.getBoundingClientRect();
    return [x, y, x + width, y + height, one.innerText];
})"""
ON_PLAN = """which => [...document.querySelector('.plan-sheet').shadowRoot.querySelectorAll(which)]
    .filter(one => one.style.visibility !== 'hidden').map(one => one.getBoundingClientRect())
    .filter(({width}) => width > 0).map(({x, y, width, height}) => [x, y, x + width, y + height])"""


def overlap(one: Sequence[float], other: Sequence[float]) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


@pytest.mark.parametrize(("across", "along", "words"), [(2, 1, "UNREACHABLE"), (8, 5, "")])
def test_marks_of_rooms_say_words_where_there_is_room_for_them(visit: Visit, across: int, along: int, words: str) -> None:
    """Of forty rooms without a door one saw nothing but forty words, each over three rooms; on the plan marks hid the rooms' names."""
    corners = ((0, 0), (3, 0), (3, 3), (0, 3), (0, 0))
    squares = [[[3 * i + x, 3 * j + z] for x, z in corners] for i in range(across) for j in range(along)]
    features = [{"type": "Feature", "properties": {"name": f"Den {n}"}, "geometry": {"type": "Polygon", "coordinates": [one]}}
                for n, one in enumerate(squares)]  # fmt: skip
    content = json.dumps({"type": "FeatureCollection", "unit": "m", "features": features}).encode()
    visit.page.set_viewport_size({"width": 1280, "height": 800})
    visit.open(SMALL.format(4))
    visit.reopened(
        lambda: visit.page.locator("#file").set_input_files({"name": "dens.geojson", "mimeType": "application/json", "buffer": content})
    )
    for key in ("2", "4"):
        visit.page.keyboard.press(key)
        visit.settle()
        marks = visit.page.evaluate(MARKS)
        assert len(marks) == across * along - 1, "ways are judged from one of them"
        assert {said for *_, said in marks} == {words}
        assert not any(overlap(one, other) for n, one in enumerate(marks) for other in marks[:n])
    written, rooms = [visit.page.evaluate(ON_PLAN, which) for which in ("g:has(> .name) > text", "polygon.floor")]
    assert len(written) >= len(rooms) == across * along
    assert not any(overlap(one, words) for one in marks for words in written)
    middles = [((west + east) / 2, (north + south) / 2) for west, north, east, south, _ in marks]
    marked = [[n for n, room in enumerate(rooms) if overlap((*at, *at), room)] for at in middles]
    assert len({tuple(found) for found in marked}) == len(marks) and all(len(found) == 1 for found in marked), "each lies in its room"
