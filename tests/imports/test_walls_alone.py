"""Drawings of walls without rooms: rooms are found between the faces of walls, in any unit and at any angle."""

from __future__ import annotations

import math
import tracemalloc
from io import BytesIO, StringIO
from typing import Any, Literal
from xml.etree import ElementTree
from zipfile import ZipFile

import ezdxf.filemanagement as readers
import ezdxf.math as ezmath
import ifcopenshell
import ifcopenshell.api.root
import pytest

from solver import export
from solver.answers import PlanImport
from solver.errors import FieldError
from solver.imports import steps_inside, wall_faces
from solver.imports.rectilinear import DrawnLine
from solver.imports.steps_inside import connected
from solver.scene import Scene
from tests.imports.plans import floor_area, read
from tests.imports.test_round_trips import home
from tests.sweeps import pairs

AXES: tuple[Literal["x"], Literal["z"]] = ("x", "z")
KEPT = ("WALLS", "DOORS", "WINDOWS", "OPENINGS", "NAMES")
"""Layers that a drawing of walls alone has."""
SVG = "<svg xmlns='http://www.w3.org/2000/svg' {}>{}</svg>"


def exploded(program: str, scale: float, degrees: float) -> bytes:
    """Our drawing of a home without its rooms, each wall as four lines, in another unit, turned."""
    (content,) = export(home(program), "dxf").values()
    drawing: Any = readers.read(StringIO(content.decode()))
    space = drawing.modelspace()
    turn = ezmath.Matrix44.z_rotate(math.radians(degrees)) @ ezmath.Matrix44.scale(scale, scale, scale)
    for entity in list(space):
        if entity.dxf.layer not in KEPT or entity.dxftype() == "HATCH":
            space.delete_entity(entity)
        elif entity.dxf.layer == "WALLS":
            entity.transform(turn)
            corners = list(entity.get_points("xy"))
            for a, b in zip(corners, [*corners[1:], *corners[:1]], strict=True):
                space.add_line(a, b, dxfattribs={"layer": "WALLS"})
            space.delete_entity(entity)
        else:
            entity.transform(turn)
    drawing.header["$INSUNITS"] = 0
    text = StringIO()
    drawing.write(text)
    return text.getvalue().encode()


def sizes(scene: Scene) -> list[tuple[Any, ...]]:
    return sorted((room.type, *sorted((room.width, room.depth)), len(room.openings), room.outline is None) for room in scene.rooms)


@pytest.mark.parametrize(("program", "drawn"), pairs(["studio", "family"], [(1000.0, 0.0), (39.37007874, 0.0), (100.0, 20.0)]))
def test_walls_of_a_home_enclose_its_rooms(program: str, drawn: tuple[float, float]) -> None:
    before, answer = home(program), read(exploded(program, *drawn))
    after = sizes(answer.scene)
    assert len(after) == len(before.rooms)
    for one, other in zip(sizes(before), after, strict=True):
        assert (one[0], *one[3:]) == (other[0], *other[3:])
        assert max(abs(a - b) for a, b in zip(one[1:3], other[1:3], strict=True)) <= 0.0101
    assert abs(answer.scene.wall_thickness - before.wall_thickness) <= 0.002
    assert not [issue for issue in answer.issues if issue.severity == "error"]


POSTS = (0.1, 0.25, 0.4)
"""How far before a hallway's end a doorpost stands, m: before 0.45 m it lies beside what opens at the end."""


@pytest.mark.parametrize("post", POSTS)
@pytest.mark.parametrize("wall", [0.1, 0.3])
def test_a_hallway_reaches_the_wall_at_its_end_past_a_doorpost(post: float, wall: float) -> None:
    """A hallway 1.2 m wide and 5 m long, at whose end lies a passage, and just before that a door to the side."""
    drawing: Any = readers.new()
    space = drawing.modelspace()

    def block(x0: float, y0: float, x1: float, y1: float, layer: str = "Walls") -> None:
        space.add_lwpolyline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], close=True, dxfattribs={"layer": layer})

    block(-wall, -3 - wall, 0, 1.2 + wall)
    block(0, 1.2, 9, 1.2 + wall)
    block(0, -wall, 4.1 - post, 0)
    block(5 - post, -wall, 5, 0)
    block(0, -3 - wall, 9, -3)
    block(5, -3, 5 + wall, 0.15)
    block(5, 1.05, 5 + wall, 1.2)
    block(9, -3 - wall, 9 + wall, 1.2 + wall)
    block(4.1 - post, -wall, 5 - post, 0, "Doors")
    block(5, 0.15, 5 + wall, 1.05, "Openings")
    for name, x, y in (("Flur", 1, 0.6), ("Bedroom", 2, -1.5), ("Living room", 7, -1)):
        space.add_text(name, dxfattribs={"layer": "Names", "insert": (x, y)})
    drawing.header["$INSUNITS"] = 6
    text = StringIO()
    drawing.write(text)
    scene = read(text.getvalue().encode()).scene
    (hallway,) = (room for room in scene.rooms if room.type == "hallway")
    assert len(scene.rooms) == 3
    thick = scene.wall_thickness
    assert abs(hallway.width - thick - 5) <= 0.011
    assert abs(hallway.depth - thick - 1.2) <= 0.011


def test_what_lies_within_a_room_is_sought_in_that_room_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """However many rooms there are: the cells looked through are a few times those of the whole drawing, not that for each room."""
    looked: list[int] = []

    def counted(free: Any) -> Any:
        looked.append(free.size)
        return connected(free)

    for module in (wall_faces, steps_inside):
        monkeypatch.setattr(module, "connected", counted)
    lines = [DrawnLine(axis, at * 3000, 0, 36000) for at in range(13) for axis in AXES]
    pillar = [DrawnLine(axis, at, 1000, 2000) for at in (1000, 2000) for axis in AXES]
    found = wall_faces.faces_between([*lines, *pillar])
    assert found is not None
    assert [len(one.holes) for one in found].count(1) == 1
    assert len(found) == 145
    assert sum(looked) <= 10 * looked[0]


def without_rooms(scene: Scene, format: str, degrees: float) -> bytes:
    """Our export of a home without its rooms, as other libraries take them out, its site (an IFC's) turned."""
    content = next(iter(export(scene, format).values()))
    if format == "ifc":
        building = ifcopenshell.file.from_string(content.decode())
        for space in building.by_type("IfcSpace"):
            ifcopenshell.api.root.remove_product(building, product=space)
        (site,) = building.by_type("IfcSite")
        turn = (math.cos(math.radians(degrees)), math.sin(math.radians(degrees)), 0.0)
        site.ObjectPlacement.RelativePlacement.Axis = building.create_entity("IfcDirection", (0.0, 0.0, 1.0))
        site.ObjectPlacement.RelativePlacement.RefDirection = building.create_entity("IfcDirection", turn)
        return str(building.to_string()).encode()
    with ZipFile(BytesIO(content)) as archive:
        root = ElementTree.fromstring(archive.read("Home.xml"))
    for room in root.findall("room"):
        root.remove(room)
    return ElementTree.tostring(root)


@pytest.mark.parametrize(("format", "degrees"), [("ifc", 0.0), ("ifc", 7.0), ("ifc", -31.5), ("sh3d", 0.0)])
def test_walls_of_a_building_without_rooms_enclose_them(format: str, degrees: float) -> None:
    before = home("family")
    answer = read(without_rooms(before, format, degrees))
    assert answer.format == format
    after = sizes(answer.scene)
    assert len(after) == len(before.rooms)
    for one, other in zip(sorted(one[1:] for one in sizes(before)), sorted(one[1:] for one in after), strict=True):
        assert one[2:] == other[2:]
        assert max(abs(a - b) for a, b in zip(one[:2], other[:2], strict=True)) <= 0.0101
    assert sum(len(room.furniture) for room in answer.scene.rooms) > 20


def drawn(body: str, more: str = "data-unit='cm'") -> PlanImport:
    return read(SVG.format(more, body).encode(), "walls.svg")


OUTER = "<path class='wall' d='M0 0 H800 V400 H0 Z M30 30 H770 V370 H30 Z'/>"
INNER = "<path id='wall' d='M400 30 V{0} H412 V30 M400 370 V{1} H412 V370'/>"
DOOR = "<line class='door' x1='406' y1='150' x2='406' y2='240'/>"


def test_a_wall_that_stops_short_of_another_by_a_crack_still_parts_two_rooms() -> None:
    """The outer walls, 0.3 m thick, are most of the walls; the rooms reach to the middle of theirs and of the one between them."""
    for gap in (("150", "240"), ("195", "205")):
        rooms = drawn(OUTER + INNER.format(*gap) + DOOR).scene.rooms
        assert [(room.width, room.depth) for room in rooms] == [(3.82, 3.52), (3.7, 3.52)]


def test_a_gap_without_a_door_leaves_one_room() -> None:
    (room,) = drawn(OUTER + INNER.format("150", "240")).scene.rooms
    assert room.outline is not None
    (whole,) = drawn(OUTER).scene.rooms
    assert (whole.width, whole.depth, whole.outline) == (7.7, 3.7, None)


@pytest.mark.parametrize(("side", "door", "count"), [(400, "", 2), (400, "<path class='door' d='M0 600 V690'/>", 3), (200, "", 3)])
def test_what_lies_around_a_home_is_ground_but_a_home_lies_around_small_rooms(side: int, door: str, count: int) -> None:
    """Two rooms side by side within a frame; within a garden with a gate; and in a loft."""
    around = "M0 600 V0 H2000 V1500 H0 V690" + (" V600" if not door else "")
    within = f"M500 500 h{2 * side} v{side} h-{2 * side} z M{500 + side} 500 v{side}"
    assert len(drawn(f"<path class='wall' d='{around}'/><path class='wall' d='{within}'/>{door}").scene.rooms) == count


def test_without_a_unit_or_doors_walls_are_left_out_with_what_to_say() -> None:
    with pytest.raises(FieldError, match="are none in this file"):
        drawn(OUTER, "")
    assert len(read(SVG.format("", OUTER).encode(), "walls.svg", unit="cm").scene.rooms) == 1


def test_a_room_of_several_names_is_called_by_one_that_names_a_room_and_the_others_are_told() -> None:
    lines = ((0, 0, 8, 0), (8, 0, 8, 5), (8, 5, 0, 5), (0, 5, 0, 0))
    walls = "".join(f"<line class='wall' x1='{a}' y1='{b}' x2='{c}' y2='{d}'/>" for a, b, c, d in lines)
    names = ("See note 4", 1), ("Kitchen", 2), ("Cuisine", 3), ("3.5 m", 4), ("Dining room", 5)
    texts = "".join(f"<text x='{x}' y='2'>{words}</text>" for words, x in names)
    answer = read(SVG.format("data-unit='m'", walls + texts).encode(), "plan.svg")
    assert [(room.type, room.name) for room in answer.scene.rooms] == [("kitchen", "Kitchen")]
    assert [one["place"] for one in answer.unread] == ["text 'Dining room'"]


LONE = "<g class='wall'>{}</g><text x='200' y='200'>Kitchen</text><text x='600' y='200'>Bedroom</text>"


def single_lines(*walls: tuple[int, int, int, int], more: str = "") -> PlanImport:
    return drawn(LONE.format("".join(f"<path d='M{x0} {z0} L{x1} {z1}'/>" for x0, z0, x1, z1 in walls)) + more)


@pytest.mark.parametrize(("gap", "is_closed"), [(5, True), (25, True), (26, False)])
def test_a_wall_that_ends_short_of_one_across_its_way_reaches_it(gap: int, is_closed: bool) -> None:
    around = ((0, 0, 800, 0), (800, 0, 800, 400), (800, 400, 0, 400), (0, 400, 0, 0))
    answer = single_lines(*around, (400, 0, 400, 400 - gap))
    assert sorted((room.width, room.depth) for room in answer.scene.rooms) == ([(4.0, 4.0)] * 2 if is_closed else [(8.0, 4.0)])
    told = [str(one["reason"]) for one in answer.unread if one["place"] == "text 'Bedroom'"]
    assert told == ([] if is_closed else ["names a room, but no wall is drawn between it and 'Kitchen'"])


@pytest.mark.parametrize(("gap", "count"), [(15, 3), (20, 2)])
def test_two_wing_walls_with_a_gap_between_leave_one_room(gap: int, count: int) -> None:
    """Each ends in a line across, as walls of two faces do; what is no wider than a crack is closed all the same."""
    wings = "".join(f"<path class='wall' d='M{wall} 240 H{end} V250 H{wall}'/>" for wall, end in ((412, 580), (770, 580 + gap)))
    assert len(drawn(OUTER + INNER.format(150, 240) + DOOR + wings).scene.rooms) == count


STORAGE, CLOSETS_DOOR = "<text x='780' y='200'>Storage</text>", "<line class='door' x1='750' y1='100' x2='750' y2='170'/>"


@pytest.mark.parametrize(("more", "count"), [(STORAGE + CLOSETS_DOOR, 3), (STORAGE, 2), (CLOSETS_DOOR, 2)])
def test_a_room_as_narrow_as_a_wall_may_be_thick_is_one_if_it_is_named_and_a_door_leads_into_it(more: str, count: int) -> None:
    around = ((0, 0, 800, 0), (800, 0, 800, 400), (800, 400, 0, 400), (0, 400, 0, 0), (400, 0, 400, 400))
    front = ((750, 0, 750, 100), (750, 170, 750, 400)) if CLOSETS_DOOR in more else ((750, 0, 750, 400),)
    assert len(single_lines(*around, *front, more=more).scene.rooms) == count


AROUND = ((0, 0, 800, 0), (800, 0, 800, 400), (800, 400, 0, 400), (0, 400, 0, 0), (400, 0, 400, 400))
TILES = tuple((x, 10, x, 390) for x in (470, 535, 600, 665, 735))


@pytest.mark.parametrize("extra", [TILES, ((0, 330, 395, 330),)])
def test_lines_on_a_layer_of_walls_that_end_at_nothing_and_part_no_two_names_are_no_walls(
    extra: tuple[tuple[int, int, int, int], ...],
) -> None:
    answer = single_lines(*AROUND, *extra)
    assert [(room.width, room.depth) for room in answer.scene.rooms] == [(4.0, 4.0)] * 2
    assert [one["reason"] for one in answer.unread] == [f"{len(extra)} shapes with floor before and behind them are taken as no walls"]


def test_a_line_that_ends_at_nothing_is_a_wall_between_two_names() -> None:
    answer = single_lines(*AROUND[:4], (400, 10, 400, 390))
    assert (len(answer.scene.rooms), list(answer.unread)) == (2, [])


def test_lines_with_floor_on_both_sides_are_no_walls_beside_walls_of_two_faces() -> None:
    """A counter, with corners as walls have them."""
    counter = "<path class='wall' d='M100 30 V370'/>"
    answer = drawn(OUTER + INNER.format(150, 240) + DOOR + counter)
    assert [len(room.openings) for room in answer.scene.rooms] == [1, 1]


def test_what_ends_at_a_door_is_a_wall_though_it_has_floor_on_both_sides() -> None:
    """A single line beside walls of two faces."""
    thin = "<path class='wall' d='M200 30 V150'/><path class='wall' d='M200 240 V370'/>" + DOOR.replace("406", "200")
    assert len(drawn(OUTER + INNER.format(150, 240) + DOOR + thin).scene.rooms) == 3


@pytest.mark.parametrize(("gap", "is_closed"), [(25, True), (26, False)])
def test_walls_that_end_short_of_their_corner_meet_there(gap: int, is_closed: bool) -> None:
    """The eastern room's corner is left open: its name is told, where nothing encloses it."""
    answer = single_lines(
        (0, 0, 800 - gap, 0), (800, gap, 800, 400), (800, 400, 0, 400), (0, 400, 0, 0), (400, 0, 400, 400),
    )  # fmt: skip
    assert [(room.width, room.depth) for room in answer.scene.rooms] == [(4.0, 4.0)] * (1 + is_closed)
    told = [str(one["reason"]) for one in answer.unread if one["place"] == "text 'Bedroom'"]
    assert told == ([] if is_closed else ["names a room, but stands in none: nothing encloses it"])


def test_a_door_in_the_corner_of_a_room_closes_the_gap_up_to_the_wall_across() -> None:
    around = ((0, 0, 800, 0), (800, 0, 800, 400), (800, 400, 0, 400), (0, 400, 0, 0), (400, 90, 400, 400))
    answer = single_lines(*around, more="<line class='door' x1='400' y1='0' x2='400' y2='90'/>")
    assert [(room.type, room.width, [one.kind for one in room.openings]) for room in answer.scene.rooms] == [
        ("kitchen", 4.0, ["door"]), ("bedroom", 4.0, ["door"]),
    ]  # fmt: skip
    assert [[one.kind for one in room.openings] for room in single_lines(*around).scene.rooms] == [["passage"], ["passage"]]


def test_walls_with_gaps_alone_are_told_to_be_open_there() -> None:
    with pytest.raises(FieldError, match="its walls: enclose no room: gaps in which no door, window or opening is drawn leave them open"):
        drawn("<path class='wall' d='M0 0 H800 V400 H510 V380 H780 V20 H20 V380 H300 V400 H0 Z'/>")


def test_walls_that_enclose_nothing_are_told_with_how_many_of_their_ends_are_free() -> None:
    with pytest.raises(FieldError, match="its walls: enclose no room: 4 of their ends meet neither another wall nor an opening"):
        single_lines((0, 0, 800, 0), (800, 0, 800, 400), (700, 600, 0, 600))


def octagon(across: float) -> list[tuple[float, float]]:
    """The corners of an octagon around (500, 500), so wide across, from the east end of its north side on, clockwise."""
    turns = [math.radians(45 * at - 67.5) for at in range(8)]
    by = across / 2 / math.cos(math.radians(22.5))
    return [(500 + by * math.cos(turn), 500 + by * math.sin(turn)) for turn in turns]


def path_of(spots: list[tuple[float, float]], end: str = "") -> str:
    return "M" + " L".join(f"{x:.4f} {y:.4f}" for x, y in spots) + end


@pytest.mark.parametrize("turn", [0, 20])
@pytest.mark.parametrize("is_open", [False, True])
def test_slanted_walls_enclose_rooms_that_reach_to_the_steps_before_them(turn: int, is_open: bool) -> None:
    """An octagon 6 m wide; where it is open, a window closes half of its north-east side, which is slanted."""
    inner, outer = octagon(600), octagon(640)
    window = ""
    if is_open:
        quarters = [[(a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share) for share in (0.25, 0.75)]
                    for a, b in (inner[:2], outer[:2])]  # fmt: skip
        around = [quarters[0][1], *inner[1:], inner[0], quarters[0][0], quarters[1][0], outer[0], *outer[:0:-1], quarters[1][1]]
        walls = path_of(around, "Z")
        (x0, y0), (x1, y1) = (((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in zip(*quarters, strict=True))
        window = f"<line class='window' x1='{x0}' y1='{y0}' x2='{x1}' y2='{y1}'/>"
    else:
        walls = path_of(inner, "Z") + path_of(outer, "Z")
    answer = drawn(f"<g transform='rotate({turn})'><path class='wall' d='{walls}'/>{window}</g>")
    (room,) = answer.scene.rooms
    assert room.outline is not None
    half = answer.scene.wall_thickness / 2
    side, area = 6.0 * math.tan(math.radians(22.5)), 8 * math.tan(math.radians(22.5)) * 9.0
    reached = floor_area(room.outline) - half * (4 * side + 2 * (6.0 - side) * 2)
    assert area - 4 * side * 0.15 <= reached <= area + 0.3 * is_open


def test_many_rooms_between_walls_take_memory_for_each_of_them_alone() -> None:
    """625 rooms of 1 m2: where each takes as much as the whole drawing, that is 2.4 MB."""
    lines = [DrawnLine(axis, 1000 * at, 0, 25_000) for axis in AXES for at in range(26)]
    wall_faces.faces_between(lines[:4])
    tracemalloc.start()
    try:
        found = wall_faces.faces_between(lines)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert len(found or ()) == 625
    assert peak < 1_500_000
