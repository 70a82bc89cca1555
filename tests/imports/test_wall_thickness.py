"""Each wall's own thickness is read: from the gaps between rooms, from walls as drawn, from what our own exports say."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import Any

import ezdxf.filemanagement as drawings
import pytest

from compose_homes import Request, generate, load, validate
from solver import export
from solver.answers import PlanImport
from solver.imports.drawn import DrawnWall
from solver.imports.rectilinear import PlanEdge
from solver.imports.wall_depths import WallDepths
from solver.scene import Room, Scene
from tests.exports.test_page_agrees import THICK_WALLS
from tests.imports.plans import box, collection, line, piece, polygon, read, text_of
from tests.sweeps import ALL

CLOSE = 0.0101
"""m."""
OUTLINES = ("rectangle", "L", "T", "U")
WALLS = ((0.115, 0.42), (0.15, 0.365), (0.24, 0.3))
"""How thick inner and outer walls are, m."""
THICK = [
    (9100 + at, walls, outline) for at, walls in enumerate(WALLS) for turn, outline in enumerate(OUTLINES) if ALL or turn % len(WALLS) == at
]
"""Each outline with one of these, in turn; in `make targets`, with all."""


@pytest.fixture(scope="module")
def house() -> Scene:
    return load(THICK_WALLS)


def faces_of(room: Room, scene: Scene) -> tuple[float, ...]:
    half = scene.wall_thickness / 2
    return room.x + half, room.z + half, room.x + room.width - half, room.z + room.depth - half


def outer_of(room: Room, scene: Scene) -> list[float]:
    lines = len(room.outline or "nesw")
    said = [*(room.wall_thickness or ()), *[None] * lines][:lines]
    return [scene.wall_thickness if one is None else one for one in said]


def again(house: Scene, format: str) -> PlanImport:
    (name, content), *_ = export(house, format).items()
    return read(content, name)


def test_walls_thicker_than_any_of_a_scene_are_held_as_thick_as_those() -> None:
    answer = read(collection(box("Hall", 0, 0, 4, 3), drawn="inner", wall_thickness=1.4))
    assert (answer.scene.wall_thickness, answer.scene.rooms[0].width) == (1.0, 5.0)


@pytest.mark.parametrize(("usual", "thick", "joins"), [(1.0, 0.9, "bedroom_1"), (0.1, 0.1, "EXTERIOR")])
def test_rooms_no_farther_apart_than_the_usual_wall_is_thick_have_one_between_them(usual: float, thick: float, joins: str) -> None:
    """A door stands between two rooms 0.9 m apart; of walls 0.1 m thick there is more than one there."""
    door = line("door", (4.5, 1), (4.5, 1.9)) if usual > 0.9 else line("door", (4.05, 1), (4.05, 1.9))
    rooms = box("Hallway", 0, 0, 4, 3), box("Bedroom", 4.9, 0, 9, 3)
    scene = read(collection(*rooms, door, drawn="inner", wall_thickness=usual)).scene
    assert (scene.wall_thickness, [one.connects_to for one in scene.rooms[0].openings]) == (thick, [joins])


@pytest.mark.parametrize("format", ["procthor", "sh3d", "ifc", "svg", "dxf"])
def test_our_exports_read_back(house: Scene, format: str) -> None:
    after = again(house, format).scene
    found = sorted(after.rooms, key=lambda room: (room.z, room.x))
    west, north, _, _ = faces_of(house.rooms[0], house)
    origin = faces_of(found[0], after)
    for before, room in zip(house.rooms, found, strict=True):
        a, b = faces_of(before, house), faces_of(room, after)
        moved = (a[0] - west + origin[0], a[1] - north + origin[1], a[2] - west + origin[0], a[3] - north + origin[1])
        assert max(abs(one - other) for one, other in zip(moved, b, strict=True)) <= CLOSE
        shared = {"a": (1, 2), "b": (2, 3), "c": ()}[before.id]
        pairs = list(zip(outer_of(before, house), outer_of(room, after), strict=True))
        outer = [pair for line, pair in enumerate(pairs) if line not in shared and (before.id != "c" or line > 0)]
        assert all(abs(one - other) <= CLOSE for one, other in outer), (before.id, outer)
    doors = [{(one.kind, one.connects_to) for one in room.openings} for room in found]
    assert [len(one) for one in doors] == [len(room.openings) for room in house.rooms]
    assert [issue.message for issue in validate(after) if issue.severity == "error"] == []


@pytest.mark.parametrize("format", ["procthor", "svg"])
@pytest.mark.parametrize(("said", "thick"), [(-0.3, None), (0.00025, None), (0.005, None), (1.2, None), (0.3, 0.3)])
def test_what_a_file_says_of_sides_counts_for_outer_walls_as_thick_as_walls_are(
    house: Scene, format: str, said: float, thick: float | None
) -> None:
    (name, content), *_ = export(house, format).items()
    if format == "svg":
        all_sides = " ".join([f"{said * 1000:g}"] * 4)
        content = re.sub('data-outer-walls="[^"]*"', f'data-outer-walls="{all_sides}"', content.decode()).encode()
    else:
        document = json.loads(content)
        for room in document["rooms"]:
            room["compose"]["wall_thickness"] = [said] * 4
        content = json.dumps(document).encode()
    west, east, _ = sorted(read(content, name).scene.rooms, key=lambda room: (room.z, room.x))
    outer = [(thick, None, None, thick), (thick, thick, None, None)] if thick else [None, None]
    assert [west.wall_thickness, east.wall_thickness] == outer


def test_walls_thinner_than_nothing_have_no_thickness() -> None:
    assert read(collection(box("Hall", 0, 0, 4, 3), drawn="inner", wall_thickness=-0.3)).scene.wall_thickness == 0.0


def outside(room: Room, house: Scene, wall: int) -> float:
    """How much of a wall no other room lies at, m, by steps of 5 cm."""
    x0, z0, x1, z1 = room.x, room.z, room.x + room.width, room.z + room.depth
    steps = round(((x1 - x0) if wall in (0, 2) else (z1 - z0)) / 0.05)
    free = 0
    for step in range(steps):
        along = 0.05 * step + 0.025
        x, z = ((x0 + along, z0 - 0.01), (x1 + 0.01, z0 + along), (x0 + along, z1 + 0.01), (x0 - 0.01, z0 + along))[wall]
        free += not any(one.x < x < one.x + one.width and one.z < z < one.z + one.depth for one in house.rooms)
    return 0.05 * free


@pytest.mark.parametrize(("seed", "walls", "outline"), THICK)
def test_a_drawing_tells_how_thick_each_outer_wall_is(seed: int, walls: tuple[float, float], outline: str) -> None:
    """Of a wall that is cut to pieces shorter than they are thick, too, and one that the corner of another outer wall hides."""
    inner, outer = walls
    house = generate(Request(seed=seed, program="large", outline=outline, wall_thickness=inner, outer_wall_thickness=outer)).scene
    after, seen = again(house, "dxf").scene, 0
    assert after.wall_thickness == pytest.approx(inner, abs=CLOSE)
    for before, room in zip(house.rooms, after.rooms, strict=True):
        pairs = zip(outer_of(before, house), outer_of(room, after), strict=True)
        for wall, (one, other) in enumerate(pairs):
            if outside(before, house, wall):
                assert abs(one - other) <= CLOSE, (before.id, wall)
                seen += one != inner
    assert seen > 10


@pytest.mark.parametrize("outer", [0.2, 0.4])
def test_a_wall_that_the_corner_of_another_hides_is_as_thick_as_that(outer: float) -> None:
    """The wall of c to the north is an outer one over 15 cm, where the east wall of a ends; b's north wall begins beyond that."""
    h, far = outer / 2, outer - 0.05
    rooms = [
        ([(x0, z0), (x1, z0), (x1, z1), (x0, z1), (x0, z0)], {"kind": "room", "name": name})
        for name, x0, z0, x1, z1 in (("a", 0.05, 0.05, 2.95, 2.95), ("b", 3.2, 3.05, 5.1, 5.95), ("c", 0.05, 3.05, 3.1, 5.95))
    ]
    thick = [((0.05 - h, -far), (0.05 - h, 6)), ((2.95 + h, -far), (2.95 + h, 3)), ((5.1 + h, 3), (5.1 + h, 6)),
             ((-far, 0.05 - h), (3, 0.05 - h)), ((2.95 + outer, 3.05 - h), (5, 3.05 - h)), ((-far, 5.95 + h), (5, 5.95 + h))]  # fmt: skip
    thin = [((0, 3), (2.95 + outer, 3)), ((3.15, 3), (3.15, 6))]
    walls = [(line, {"kind": "wall", "thickness": wide}) for lines, wide in ((thick, outer), (thin, 0.1)) for line in lines]
    shapes = [*((says, "Polygon", [ring]) for ring, says in rooms), *((says, "LineString", line) for line, says in walls)]
    features = [{"type": "Feature", "properties": says, "geometry": {"type": kind, "coordinates": at}} for says, kind, at in shapes]
    document = {"type": "FeatureCollection", "unit": "m", "y": "down", "drawn": "inner", "features": features}
    scene = read(json.dumps(document).encode(), "plan.json").scene
    assert scene.wall_thickness == pytest.approx(0.1)
    assert [room.wall_thickness for room in scene.rooms] == [
        (outer, outer, None, outer), (outer, outer, outer, None), (outer, None, outer, outer),
    ]  # fmt: skip


def test_gaps_between_inner_faces_are_the_walls() -> None:
    def polygon(x: float, z: float, width: float, depth: float) -> dict[str, object]:
        ring = [[x, z], [x + width, z], [x + width, z + depth], [x, z + depth], [x, z]]
        return {"type": "Feature", "properties": {"kind": "room"}, "geometry": {"type": "Polygon", "coordinates": [ring]}}

    wall = {"type": "Feature", "properties": {"kind": "wall", "thickness": 0.4},
            "geometry": {"type": "LineString", "coordinates": [[-0.2, -0.2], [-0.2, 3.2]]}}  # fmt: skip
    door = {"type": "Feature", "properties": {"kind": "door"},
            "geometry": {"type": "LineString", "coordinates": [[3.125, 1.0], [3.125, 1.9]]}}  # fmt: skip
    features = [polygon(0, 0, 3, 3), polygon(3.25, 0, 3, 3), polygon(0, 3.12, 6.25, 3), wall, door]
    document = {"type": "FeatureCollection", "unit": "m", "y": "down", "drawn": "inner", "features": features}
    scene = read(json.dumps(document).encode(), "plan.json").scene
    a, b, c = scene.rooms
    assert (scene.wall_thickness, b.x - (a.x + a.width), c.z - (a.z + a.depth)) == pytest.approx((0.12, 0.13, 0.0))
    assert (a.wall_thickness, b.wall_thickness) == ((None, None, None, 0.4), None)
    assert [one.connects_to for one in (*a.openings, *b.openings) if one.kind == "door"] == [b.id, a.id]
    assert scene.adjacency == ((0, 1), (0, 2), (1, 2))


def test_a_wall_that_goes_on_as_a_border_without_one_takes_no_floor_of_the_room_behind_it() -> None:
    thick, stove = 0.125, {"width": 0.6, "depth": 0.64, "height": 0.85, "rotation": 180}
    rooms = [box("Kitchen", 0, 0, 4, 3), box("Bathroom", 0, 3 + thick, 2, 5), box("Hallway", 2 + thick, 3, 4, 5)]
    doors = [line("door", (1, 3 + thick / 2), (1.8, 3 + thick / 2)), line("door", (3, 5), (3.9, 5)), line("passage", (2.2, 3), (3.9, 3))]
    said = {"y": "down", "drawn": "inner", "wall_thickness": thick}
    answer = read(collection(*rooms, *doors, piece("Stove", 0.6, 3 - 0.32, **stove), **said))
    kitchen, bathroom, hallway = answer.scene.rooms
    assert (kitchen.depth - answer.scene.wall_thickness, bathroom.depth - answer.scene.wall_thickness) == pytest.approx(
        (3, 2 - thick), abs=0.001
    )
    told = [(one["of"], str(one["message"])) for one in answer.changes]
    assert any(of == hallway.id and "drawn 0 mm thick and held as 125" in words for of, words in told)
    assert [words for _, words in told if words.startswith("moved")] == []
    assert [issue.message for issue in answer.issues if issue.severity == "error"] == []


Ring = list[tuple[float, float]]


def ring(x0: float, y0: float, x1: float, y1: float) -> Ring:
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


ROOMS = [ring(0, 0, 5, 4), ring(5.12, 0, 8, 4)]
OUTER: dict[str, tuple[list[Ring], float]] = {
    "boxes": ([ring(-0.3, -0.3, 8.3, 0), ring(-0.3, 4, 8.3, 4.3), ring(-0.3, 0, 0, 4), ring(8, 0, 8.3, 4)], 0.0),
    "outlines": ([ring(-0.3, -0.3, 8.3, 4.3), ring(0, 0, 8, 4)], 0.0),
    "a thick line": ([ring(-0.15, -0.15, 8.15, 4.15)], 0.3),
}
"""Walls of 0.3 m around two rooms, as outlines and the width of their lines."""


def dxf_of(rooms: list[Ring], walls: list[Ring], width: float) -> bytes:
    drawing: Any = drawings.new()
    drawing.header["$INSUNITS"] = 6
    for layer, rings in (("ROOMS", rooms), ("WALLS", walls)):
        for points in rings:
            wide = {"const_width": width} if layer == "WALLS" and width else {}
            drawing.modelspace().add_lwpolyline(points, close=True, dxfattribs={"layer": layer, **wide})
    return text_of(drawing).encode()


def svg_of(rooms: list[Ring], walls: list[Ring], width: float) -> bytes:
    """In cm, a tenth as large and drawn ten times as large."""

    def path(rings: list[Ring]) -> str:
        return " ".join("M" + " ".join(f"{10 * x} {10 * y}" for x, y in points) + "Z" for points in rings)

    drawn = "".join(f"<path class='room' d='{path([points])}'/>" for points in rooms)
    drawn += f"<path class='wall' d='{path(walls)}' style='fill: none; stroke-width: {10 * width}'/>"
    return f"<svg xmlns='http://www.w3.org/2000/svg' data-unit='cm'><g transform='scale(10)'>{drawn}</g></svg>".encode()


@pytest.mark.parametrize("way", OUTER)
@pytest.mark.parametrize("draw", [dxf_of, svg_of])
def test_an_outer_wall_is_as_thick_however_it_is_drawn(draw: Callable[[list[Ring], list[Ring], float], bytes], way: str) -> None:
    scene = read(draw(ROOMS, *OUTER[way]), "plan").scene
    assert scene.wall_thickness == pytest.approx(0.12)
    assert [(room.width, room.depth, room.wall_thickness) for room in scene.rooms] == [
        (5.12, 4.12, (0.3, None, 0.3, 0.3)), (3.0, 4.12, (0.3, 0.3, 0.3, None)),
    ]  # fmt: skip


@pytest.mark.parametrize("draw", [dxf_of, svg_of])
def test_outlines_of_walls_around_rooms_that_are_not_drawn_tell_how_thick_they_are(
    draw: Callable[[list[Ring], list[Ring], float], bytes],
) -> None:
    scene = read(draw([], [OUTER["outlines"][0][0], *ROOMS], 0.0), "plan").scene
    assert [room.wall_thickness for room in scene.rooms] == [(0.3, None, 0.3, 0.3), (0.3, 0.3, 0.3, None)]


def test_an_outline_along_the_faces_of_rooms_alone_tells_nothing() -> None:
    scene = read(dxf_of(ROOMS, [ring(0, 0, 8, 4)], 0.0), "plan").scene
    assert [room.wall_thickness for room in scene.rooms] == [None, None]


def test_a_stub_of_a_thin_wall_within_a_room_keeps_its_other_walls_where_they_are() -> None:
    """The room's outline goes around a stub 8 cm thick, thinner than the walls of 10 cm that the room is grown by half of."""
    points = ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (2.08, 2.0), (2.08, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0))
    plan = collection(polygon("Living room", *points), box("Kitchen", 5.1, 0.0, 8.1, 4.0), y="down", drawn="inner")
    living, kitchen = read(plan).scene.rooms
    assert (living.width, living.depth, kitchen.x - living.x) == (5.1, 4.1, 5.1)
    assert living.outline is not None and len(living.outline) == 8
    stub = [x for x, z in living.outline if z == pytest.approx(2.0)]
    assert len(stub) == 2 and all(abs(x - 2.09) <= 0.002 for x in stub)


@pytest.mark.parametrize("times", [1, 2, 3])
def test_what_is_drawn_more_than_once_covers_no_more_of_an_edge(times: int) -> None:
    jamb = [DrawnWall((14300.0, 8300.0), (14400.0, 8300.0), 100.0)] * times
    edge = PlanEdge(room=0, side=2, axis="x", at=8350, low=14350, high=19350, out=1)
    assert WallDepths(jamb).face(edge) is None
