"""Files as other programs write them, made here: RPLAN's pixels, Sweet Home 3D's centimetres, ProcTHOR's houses."""

from __future__ import annotations

import math
from dataclasses import replace
from io import BytesIO
from itertools import pairwise
from typing import Any
from zipfile import ZipFile

import ifcopenshell
import pytest

from catalogs import load_catalogs
from solver import export
from solver.answers import PlanImport
from solver.errors import FieldError
from solver.exports import describe
from solver.imports.drawn import DrawnOpening, DrawnWall
from solver.imports.missing_walls import without_niches
from solver.scene import Flooring, Room
from tests.imports.plans import box as room_box
from tests.imports.plans import collection, opening, read
from tests.imports.test_round_trips import home


def loop(room: int, x0: int, y0: int, x1: int, y1: int) -> tuple[list[list[float]], list[list[int]]]:
    corners = [(x0, y0), (x0, y1), (x1, y1), (x1, y0), (x0, y0)]
    edges = [[float(value) for value in (*a, *b, 0, 0)] for a, b in pairwise(corners)]
    return edges, [[room]] * 4


def apartment() -> dict[str, Any]:
    """A living room, a bedroom and a bathroom with walls of 4 pixels; a door of 12 between each and the living room, one outside."""
    boxes = [
        (1, 50, 50, 110, 120),
        (3, 114, 50, 170, 90),
        (4, 114, 94, 150, 120),
        (17, 111, 60, 113, 72),
        (17, 111, 100, 113, 112),
        (15, 47, 80, 49, 92),
    ]
    edges: list[list[float]] = []
    rooms: list[list[int]] = []
    for number, (_, *box) in enumerate(boxes):
        mine, owners = loop(number, *box)
        edges, rooms = edges + mine, rooms + owners
    return {"room_type": [kind for kind, *_ in boxes], "boxes": [box for _, *box in boxes], "edges": edges, "ed_rm": rooms}


def test_an_apartment_of_rplan_is_joined() -> None:
    answer = read(apartment())
    living, bedroom, bath = answer.scene.rooms
    assert (answer.format, [room.type for room in answer.scene.rooms]) == ("rplan", ["living_room", "bedroom", "bathroom"])
    assert {one.connects_to for one in living.openings} == {bedroom.id, bath.id, "EXTERIOR"}
    assert abs(answer.scene.wall_thickness - 4 * 18 / 256) < 0.002
    assert living.x + living.width == bedroom.x == bath.x and bedroom.depth == bath.z
    assert [one.main_entrance for one in living.openings if one.connects_to == "EXTERIOR"] == [True]
    assert [issue for issue in answer.issues if issue.severity == "error"] == []
    assert [guess["what"] for guess in answer.guesses] == ["unit"]


def sweet_home(*elements: str) -> bytes:
    return f"<?xml version='1.0'?>\n<home version='7000' name='h' wallHeight='250'>{''.join(elements)}</home>".encode()


def drawn_room(name: str, *box: float, more: str = "") -> str:
    x0, y0, x1, y1 = box
    points = "".join(f"<point x='{x}' y='{y}'/>" for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1)))
    return f"<room name='{name}' {more}>{points}</room>"


def drawn_wall(x0: float, y0: float, x1: float, y1: float, height: int = 250) -> str:
    return f"<wall id='w' xStart='{x0}' yStart='{y0}' xEnd='{x1}' yEnd='{y1}' height='{height}' thickness='10'/>"


WALLS = (drawn_wall(-5, -5, 1005, -5), drawn_wall(-5, 405, 1005, 405), drawn_wall(-5, -5, -5, 405), drawn_wall(1005, -5, 1005, 405))
ROOMS = (drawn_room("Cuisine", 0, 0, 400, 400), drawn_room("Salon", 410, 0, 1000, 400))
DOOR = "<doorOrWindow name='Door' x='405' y='200' angle='1.5708' width='91.5' depth='14.5' height='208.5'/>"
FRONT = "<doorOrWindow name='Front door' x='600' y='405' angle='3.1416' width='100' depth='14.5' height='208.5'/>"
WINDOW = "<doorOrWindow name='Window' x='200' y='-5' width='90' depth='20' height='120' elevation='90'/>"
BED = "<pieceOfFurniture name='Canapé' x='700' y='60' width='200' depth='90' height='80' color='FF00376B'/>"


def packed(**files: bytes) -> bytes:
    content = BytesIO()
    with ZipFile(content, "w") as archive:
        for name, text in files.items():
            archive.writestr(name.replace("_xml", ".xml"), text)
    return content.getvalue()


def check_sweet_home(answer: PlanImport) -> None:
    kitchen, living = answer.scene.rooms
    assert (answer.format, kitchen.type, living.type, answer.scene.wall_thickness) == ("sh3d", "kitchen", "living_room", 0.1)
    assert (kitchen.width, living.x, living.width, living.depth) == (4.1, 4.1, 6.0, 4.1)
    assert (opening(kitchen, "door_0").wall, opening(living, "door_0").wall) == ("east", "west")
    assert opening(living, "door_1").main_entrance
    assert (opening(kitchen, "window_0").sill, opening(kitchen, "window_0").height) == (0.9, 1.2)
    (sofa,) = living.furniture
    assert (sofa.name, sofa.color, answer.understood_as[sofa.id]) == ("Canapé", "#00376b", "sofa")
    assert answer.unread == ()


def test_the_colour_of_a_floor_is_the_files_the_material_its_types() -> None:
    rooms = [room.replace("<room ", f"<room floorColor='{color}' ", 1) for room, color in zip(ROOMS, ("FF6CAAA5", "blue"), strict=True)]
    answer = read(sweet_home(*WALLS, drawn_wall(405, 0, 405, 400), *rooms, DOOR, FRONT))
    kinds = load_catalogs().rooms
    first, second = answer.scene.rooms
    assert first.flooring == Flooring(kinds[first.type].flooring, "#6caaa5")
    assert second.flooring is None
    (drawn, plain) = (plate.paint for plate in describe(answer.scene, load_catalogs()).rooms)
    assert (drawn.color, drawn.texture) == ("#6caaa5", kinds[first.type].flooring)
    assert (plain.color, plain.texture) == (load_catalogs().floorings[kinds[second.type].flooring].color, kinds[second.type].flooring)


def test_a_home_of_sweet_home_3d() -> None:
    xml = sweet_home(*WALLS, drawn_wall(405, 0, 405, 400), *ROOMS, DOOR, FRONT, WINDOW, BED)
    check_sweet_home(read(xml))
    check_sweet_home(read(packed(Home_xml=xml, Home=b"java")))


@pytest.mark.parametrize("turn", [1.5708, -1.5708])
def test_a_door_whose_open_leaf_is_in_its_box_is_where_its_frame_is(turn: float) -> None:
    """Its frame takes a ninth of its depth, at its back; a door stands where the wall would be if its middle counted."""
    depth, thickness = 90, 10
    x = 405 - math.sin(turn) * (depth - thickness) / 2
    door = (
        f"<doorOrWindow name='Open door' x='{x}' y='200' angle='{turn}' width='91.5' depth='{depth}' height='208.5' "
        f"wallThickness='{thickness / depth}'><sash xAxis='0' yAxis='0.1' width='1' startAngle='0' endAngle='-1.5708'/></doorOrWindow>"
    )
    answer = read(sweet_home(*WALLS, drawn_wall(405, 0, 405, 400), *ROOMS, door, FRONT, WINDOW, BED))
    check_sweet_home(answer)
    assert opening(answer.scene.rooms[0], "door_0").swing == ("out" if x > 405 else "in")


@pytest.mark.parametrize("said", ["Thickness='NaN'", "Thickness='0'", "Thickness='5'", "Distance=''", "Distance='-1'", "Distance='0.5'"])
def test_a_door_whose_frame_is_said_to_be_beside_its_box_stands_in_its_middle(said: str) -> None:
    door = DOOR.replace("depth='14.5'", f"depth='90' wall{said}")
    check_sweet_home(read(sweet_home(*WALLS, drawn_wall(405, 0, 405, 400), *ROOMS, door, FRONT, WINDOW, BED)))


def test_where_no_wall_is_drawn_there_is_a_passage() -> None:
    answer = read(sweet_home(*WALLS, drawn_wall(405, 0, 405, 250), *ROOMS, FRONT))
    (passage,) = [one for one in answer.scene.rooms[0].openings if one.kind == "passage"]
    assert 1.2 <= passage.width <= 1.5 and passage.connects_to == answer.scene.rooms[1].id
    assert any("no wall is drawn" in str(change["message"]) for change in answer.changes)


def test_rooms_that_reach_into_the_reveal_of_a_door_are_joined() -> None:
    points = ((0, 0), (400, 0), (400, 154), (404, 154), (404, 246), (400, 246), (400, 400), (0, 400))
    niche = "<room name='Cuisine'>" + "".join(f"<point x='{x}' y='{y}'/>" for x, y in points) + "</room>"
    answer = read(sweet_home(*WALLS, drawn_wall(405, 0, 405, 400), niche, ROOMS[1], DOOR, FRONT, WINDOW, BED))
    check_sweet_home(answer)
    assert any("niches" in str(change["message"]) for change in answer.changes)


@pytest.mark.parametrize(("depth", "door", "wall", "is_left"), [
    (1, False, 0, False), (40, False, 0, False), (41, False, 0, True), (41, True, 0, False), (200, True, 0, False), (201, True, 0, True),
    (225, True, 450, False), (230, True, 450, True), (350, True, 100, True), (-1, True, 0, True), (-40, True, 0, True),
])  # fmt: skip
def test_a_niche_is_shallow_or_a_doors_reveal_and_leads_outwards(depth: int, door: bool, wall: int, is_left: bool) -> None:
    """A reveal of more than 200 mm goes no deeper than to the middle of the wall that is drawn there."""
    south, east = 1500 + max(1, min(depth, 900)), 4000 + depth
    corners = [(0, 0), (4000, 0), (4000, 1500), (east, 1500), (east, south), (4000, south), (4000, 4000), (0, 4000)]
    ends = (east, 1500), (east, south)
    openings = [DrawnOpening("door", *ends, "here")] if door else []
    bare, walls = [(0, 0), (4000, 0), (4000, 4000), (0, 4000)], [DrawnWall((east, 0), (east, 4000), wall)]
    assert without_niches(corners, corners, openings, walls) == ((corners, 0) if is_left else (bare, depth))


def test_what_is_between_two_doors_reveals_and_a_wall_is_floor() -> None:
    """The end of the room beyond both is 110 mm deep and has a window as long as half of it, but is no reveal."""
    east, west = [(4000, 110), (4050, 110), (4050, 900), (4000, 900)], [(0, 900), (-50, 900), (-50, 110), (0, 110)]
    corners = [(0, 0), (4000, 0), *east, (4000, 3000), (0, 3000), *west]
    ends = [((4050, 110), (4050, 900)), ((-50, 110), (-50, 900)), ((500, 0), (3500, 0))]
    openings = [DrawnOpening("door", *two, "here") for two in ends]
    assert without_niches(corners, corners, openings, []) == ([(0, 0), (4000, 0), (4000, 3000), (0, 3000)], 50)


def test_storeys_are_told_apart() -> None:
    levels = "<level id='a' name='Up' elevation='260' height='250'/><level id='b' name='Down' elevation='0' height='250'/>"
    rooms = drawn_room("Bedroom", 0, 0, 400, 400, more="level='a'"), drawn_room("Kitchen", 0, 0, 500, 400, more="level='b'")
    answer = read(sweet_home(levels, *rooms))
    assert ([room.type for room in answer.scene.rooms], answer.scene.levels[0].height) == (["kitchen"], 2.5)
    assert [left["place"] for left in answer.unread] == ["level 1 (Up)"]
    assert [room.type for room in read(sweet_home(levels, *rooms), level=1).scene.rooms] == ["bedroom"]


def label(words: str, x: float, y: float, more: str = "") -> str:
    return f"<label x='{x}' y='{y}' {more}><text>{words}</text></label>"


@pytest.mark.parametrize("rooms", [(), (drawn_room("", 0, 0, 400, 400), drawn_room("", 410, 0, 1000, 400))])
def test_labels_name_the_rooms_without_a_name_that_they_stand_in(rooms: tuple[str, ...]) -> None:
    labels = label("to be painted", 190, 90), label("Cuisine", 200, 200), label("Salon", 700, 100)
    check_sweet_home(read(sweet_home(*WALLS, drawn_wall(405, 0, 405, 400), *rooms, *labels, DOOR, FRONT, WINDOW, BED)))


def test_of_rooms_some_of_which_are_drawn_the_others_are_found_between_their_walls() -> None:
    """Neither what low walls enclose, a terrace with a door to it, nor that to which no door leads, a shaft."""
    terrace = (drawn_wall(400, 405, 400, 700, 90), drawn_wall(400, 700, 800, 700, 90), drawn_wall(800, 700, 800, 405, 90))
    shaft = drawn_wall(-5, 405, -5, 600), drawn_wall(-5, 600, 200, 600), drawn_wall(200, 600, 200, 405)
    labels = label("Salon", 700, 100), label("Bureau", 700, 200), label("Terrasse", 600, 550)
    answer = read(sweet_home(*WALLS, drawn_wall(405, 0, 405, 400), *terrace, *shaft, ROOMS[0], *labels, DOOR, FRONT, WINDOW, BED))
    assert [left["place"] for left in answer.unread] == ["text 'Bureau'", "text 'Terrasse'"]
    check_sweet_home(replace(answer, unread=()))


def test_a_storey_without_drawn_rooms_beside_one_with_is_read_where_it_is_asked_for() -> None:
    levels = "<level id='a' elevation='-250' height='250'/><level id='b' elevation='0' height='250'/>"
    below = [one.replace(" ", " level='a' ", 1) for one in (*WALLS, drawn_wall(405, 0, 405, 400), DOOR, FRONT, WINDOW)]
    home = sweet_home(levels, *below, drawn_room("Office", 0, 0, 400, 400, more="level='b'"))
    assert [room.type for room in read(home).scene.rooms] == ["office"]
    assert [(room.width, room.depth) for room in read(home, level=0).scene.rooms] == [(4.1, 4.1), (6.0, 4.1)]


def test_labels_of_another_storey_or_of_no_room_and_of_named_rooms_name_none() -> None:
    levels = "<level id='a' elevation='0' height='250'/><level id='b' elevation='250' height='250'/>"
    drawn = [drawn_room("Office", 0, 0, 400, 400, more="level='a'"), drawn_room("", 500, 0, 900, 400, more="level='a'")]
    labels = label("Kitchen", 200, 200, "level='a'"), label("Bath", 700, 200, "level='b'"), label("to be painted", 700, 200, "level='a'")
    office, other = read(sweet_home(levels, *drawn, *labels)).scene.rooms
    assert (office.type, other.type, other.name) == ("office", "room", None)


def test_a_home_of_an_old_version_is_refused_with_what_to_do() -> None:
    with pytest.raises(FieldError, match="save it again"):
        read(packed(Home=b"java"))


def test_a_house_of_procthor_without_sizes() -> None:
    wall = [{"x": 4.0, "y": 0, "z": 0.0}, {"x": 4.0, "y": 0, "z": 3.0}, {"x": 4.0, "y": 2.5, "z": 0.0}, {"x": 4.0, "y": 2.5, "z": 3.0}]

    def floor(x0: float, x1: float) -> list[dict[str, float]]:
        return [{"x": x, "y": 0.0, "z": z} for x, z in ((x0, 0.0), (x0, 3.0), (x1, 3.0), (x1, 0.0))]

    types = {"room|1": ("Kitchen", floor(0, 4)), "room|2": ("LivingRoom", floor(4, 9))}
    house = {
        "rooms": [{"id": name, "roomType": kind, "floorPolygon": corners} for name, (kind, corners) in types.items()],
        "walls": [{"id": "w1", "polygon": wall}, {"id": "w2", "polygon": wall}],
        "doors": [{"id": "door|1", "room0": "room|1", "room1": "room|2", "wall0": "w1", "wall1": "w2", "assetId": "Doorway_1",
                   "holePolygon": [{"x": 0.5, "y": 0, "z": 0}, {"x": 1.5, "y": 2.1, "z": 0}]}],
        "windows": [],
        "objects": [{"id": "Sofa|1", "assetId": "Sofa_7", "position": {"x": 7, "y": 0.4, "z": 0.6}, "rotation": {"x": 0, "y": 0, "z": 0}}],
    }  # fmt: skip
    answer = read(house)
    kitchen, living = answer.scene.rooms
    assert (kitchen.id, living.type, kitchen.width, living.x) == ("kitchen_0", "living_room", 4.0, 4.0)
    assert (opening(kitchen, "door_0").wall, opening(kitchen, "door_0").position) == ("east", 2.0)
    (sofa,) = living.furniture
    assert (sofa.rotation, answer.understood_as[sofa.id]) == (180, "sofa")


@pytest.mark.parametrize(("name", "asset", "middle", "kind"), [
    ("Glorp_chair_flurble", "c_1", 0.42, "dining_chair"), ("Glorp_chair_flurble", "c_1", 0.05, None), ("Glorp_flurble", "g_1", 0.4, None),
    ("GLORPbedflurble", "GLORP_bed_flurble", 0.5, "bed"), ("GLORPbedflurble", "another_bed", 0.5, None),
])  # fmt: skip
def test_a_name_that_holds_a_word_of_a_kind_as_high_has_its_size(name: str, asset: str, middle: float, kind: str | None) -> None:
    corners = [{"x": x, "y": 0.0, "z": z} for x, z in ((0, 0), (0, 4), (5, 4), (5, 0))]
    thing = {"id": f"{name}|1|0", "assetId": asset, "position": {"x": 2, "y": middle, "z": 2}}
    answer = read({"rooms": [{"id": "r", "roomType": "Bedroom", "floorPolygon": corners}], "objects": [thing]})
    assert [answer.understood_as[one.id] for one in answer.scene.rooms[0].furniture] == ([kind] if kind else [])
    assert [guess["of"] for guess in answer.guesses if guess["what"] == "size"] == (["objects[0]"] if kind else [])
    assert [left["place"] for left in answer.unread] == ([] if kind else ["objects[0]"])


def unsized(*objects: dict[str, Any]) -> tuple[Room, PlanImport]:
    """A bedroom of 5 x 4 m with things that have no sizes, as ProcTHOR has them."""
    corners = [{"x": x, "y": 0.0, "z": z} for x, z in ((0, 0), (0, 4), (5, 4), (5, 0))]
    answer = read({"rooms": [{"id": "r", "roomType": "Bedroom", "floorPolygon": corners}], "objects": list(objects)})
    return answer.scene.rooms[0], answer


def thing(name: str, x: float, y: float, z: float, *children: dict[str, Any], yaw: float = 0) -> dict[str, Any]:
    return {"id": f"{name}|1", "assetId": name, "position": {"x": x, "y": y, "z": z}, "rotation": {"y": yaw}, "children": [*children]}


@pytest.mark.parametrize("yaw", [0, 90, 180, 270])
def test_what_a_file_lays_on_a_thing_lies_on_it_in_the_size_that_it_is_taken_to_have(yaw: float) -> None:
    small = [
        thing("Laptop", 2.4, 0.94, 2.0),
        thing("Box", 2.45, 0.86, 2.05),
        thing("Mug", 4.4, 0.8, 2.0),
        thing("HousePlant", 2.0, 0.86, 2.0),
    ]
    room, answer = unsized(
        thing("DiningTable", 2.4, 0.37, 2.0, *small, yaw=yaw), thing("TVStand", 2.4, 0.3, 3.7, thing("Television", 2.4, 1.0, 3.7), yaw=180)
    )
    table = next(one for one in room.furniture if one.kind == "dining_table")
    assert [(one.parent, one.y) for one in room.decorations] == [(table.id, table.height)] * 4
    assert {one.kind for one in room.decorations} == {"laptop", "storage_box", "mug", "plant_small"}
    (screen,) = [one for one in room.furniture if one.kind == "tv"]
    stand = next(one for one in room.furniture if one.id == screen.on)
    assert (stand.kind, screen.y) == ("tv_stand", stand.height)
    assert {issue.rule for issue in answer.issues} <= {"missing_required", "no_entrance"}


def test_small_things_without_a_colour_are_drawn_in_that_of_their_kind() -> None:
    room, answer = unsized(thing("Desk", 2.5, 0.37, 2.0, thing("Vase", 2.4, 0.9, 2.0), thing("Mug", 2.7, 0.8, 2.0)))
    known = load_catalogs()
    said = tuple(replace(one, color=known.decorations[one.kind or ""].color) for one in room.decorations)
    assert {one.color for one in room.decorations} == {None}
    plain = describe(answer.scene, known).bodies
    assert plain == describe(replace(answer.scene, rooms=(replace(room, decorations=said),)), known).bodies
    assert len(said) == 2


def test_what_lies_in_a_thing_lies_on_a_board_of_it() -> None:
    room, answer = unsized(thing("ShelvingUnit", 2.4, 1.0, 3.7, thing("Book", 2.4, 0.5, 3.7), thing("Book", 2.4, 1.4, 3.7), yaw=180))
    (shelf,), books = room.furniture, room.decorations
    assert [one.parent for one in books] == [shelf.id] * 2
    assert 0.1 < books[0].y < books[1].y < shelf.height - 0.1
    assert "floating" not in {issue.rule for issue in answer.issues}


def test_what_begins_above_the_floor_hangs_and_what_may_stand_does() -> None:
    room, answer = unsized(
        thing("Wall_Decor_Painting_1", 2.5, 1.6, 3.93, yaw=180),
        thing("Television_3", 4.9, 1.9, 2.0, yaw=270),
        thing("Bed", 1.0, 0.6, 2.0, yaw=90),
    )
    (picture,), (screen, bed) = room.decorations, room.furniture
    assert (picture.mounted_on_wall, picture.y + picture.height / 2) == ("north", pytest.approx(1.6))
    assert (screen.kind, screen.y + screen.height / 2, bed.y) == ("tv", pytest.approx(1.9, abs=0.001), 0.0)
    assert {issue.rule for issue in answer.issues} <= {"missing_required", "no_entrance"}


def test_things_that_one_surface_cannot_take_apart_are_many_and_still_lie_on_it() -> None:
    room, _ = unsized(thing("Desk", 2.5, 0.37, 2.0, *(thing("Book", 2.5, 0.76, 2.0) for _ in range(40))))
    assert len(room.decorations) == 40
    assert {one.parent for one in room.decorations} == {room.furniture[0].id}


def test_guessed_sizes_of_small_things_are_said_once_a_name() -> None:
    corners = [{"x": x, "y": 0.0, "z": z} for x, z in ((0, 0), (0, 3), (4, 3), (4, 0))]
    plants = [{"id": f"Vase|{x}", "assetId": "p", "position": {"x": x, "y": 0.3, "z": 1}} for x in (1, 2, 3)]
    answer = read({"rooms": [{"id": "r", "roomType": "Kitchen", "floorPolygon": corners}], "objects": plants})
    (said,) = [guess for guess in answer.guesses if guess["what"] == "size"]
    assert len(answer.scene.rooms[0].decorations) == 3
    assert (said["of"], "of 3 of them" in str(said["message"])) == ("plan", True)


@pytest.mark.parametrize(("door", "passages"), [(True, 0), (False, 2)])
def test_gardens_side_by_side_have_a_passage_where_one_of_them_has_no_door(door: bool, passages: int) -> None:
    """Nothing is drawn between garden and terrace; each has its door from the house, or the garden has none."""
    rooms = drawn_room("Kitchen", 5, 5, 795, 295), drawn_room("Garden", 5, 305, 400, 700), drawn_room("Terrace", 400, 305, 795, 700)
    walls = [drawn_wall(*ends) for ends in ((0, 0, 800, 0), (0, 300, 800, 300), (0, 0, 0, 300), (800, 0, 800, 300))]
    places = ((400, 0), (600, 300), (200, 300)) if door else ((400, 0), (600, 300))
    doors = [f"<doorOrWindow name='Door' x='{x}' y='{y}' width='91.5' depth='14.5' height='208.5'/>" for x, y in places]
    answer = read(sweet_home(*walls, *rooms, *doors))
    assert [room.outdoor for room in answer.scene.rooms] == [False, True, True]
    openings = [one for room in answer.scene.rooms for one in room.openings]
    assert sum(one.kind == "passage" for one in openings) == passages
    assert sum(one.kind == "door" for one in openings) == (5 if door else 3)


@pytest.mark.parametrize(("name", "more", "outdoor", "guessed"), [
    ("Balkon", {}, True, True), ("Terrasse", {}, True, True), ("Garden", {}, True, True), ("Kitchen", {}, False, False),
    ("Balcony", {"outdoor": False}, False, False), ("Balcony", {"outdoor": True}, True, False),
])  # fmt: skip
def test_what_lies_outdoors_is_told_by_its_name(name: str, more: dict[str, Any], outdoor: bool, guessed: bool) -> None:
    answer = read(collection(room_box(name, 0, 0, 4, 3, **more)))
    assert answer.scene.rooms[0].outdoor == outdoor
    assert any(guess["what"] == "outdoor" for guess in answer.guesses) == guessed


@pytest.mark.parametrize(("raised", "passages"), [(("IfcDoor", None), 10), ((None,), 0)])
def test_a_hole_at_the_height_of_the_doors_is_a_passage(raised: tuple[str | None, ...], passages: int) -> None:
    """Floors may lie above their storey's elevation; a hole that begins 23 cm above where the doors do is none to walk through."""
    (content,) = export(home("family"), "ifc").values()
    building: Any = ifcopenshell.file.from_string(content.decode())
    for hole in building.by_type("IfcOpeningElement"):
        filled = hole.HasFillings[0].RelatedBuildingElement.is_a() if hole.HasFillings else None
        place = hole.ObjectPlacement.RelativePlacement
        if filled in raised:
            x, y, z = place.Location.Coordinates
            place.Location = building.create_entity("IfcCartesianPoint", (x, y, z + 0.23))
    found = read(building.to_string().encode()).scene
    openings = [one for room in found.rooms for one in room.openings]
    assert sum(one.kind == "passage" for one in openings) == passages
    assert {one.sill for one in openings if one.kind == "door"} == {0.0}


@pytest.mark.parametrize("format", ["png", "nav2", "tasks"])
def test_exports_that_hold_no_whole_home_are_refused_by_their_names(format: str) -> None:
    files = export(home("studio"), format)
    alone = {name: content for name, content in files.items() if name != "compose_scene.json"}
    (document,) = (content for name, content in alone.items() if name.endswith(".json"))
    for content in (document, packed(**alone)):
        with pytest.raises(FieldError, match=f"^file: an export of ours, {format}, which does not say all of a home: send the scene"):
            read(content, f"{format}.zip")


@pytest.mark.parametrize(("format", "name"), [("ifc", "Haus am Tor.IFC"), ("dxf", "plans/plan.dxf"), ("svg", "plan.svg")])
def test_the_one_plan_in_an_archive_is_read_as_if_it_stood_alone(format: str, name: str) -> None:
    (content,) = export(home("studio"), format).values()
    beside = {"__MACOSX/._plan.ifc": b"\0\5\x16\7", "plans/": b"", "brick.png": b"\x89PNG"}
    assert read(packed(**beside, **{name: content}), "plan.ifczip") == read(content)
