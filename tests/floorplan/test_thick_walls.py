"""Walls as thick as wished: as much floor between them as ever, nothing cut into walls around corners, outer walls where nothing lies."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product
from math import sqrt
from typing import Any

import pytest

from catalogs import load_catalogs
from solver import Request, generate, reroll
from solver.exports.describing import describe
from solver.floorplan import draw
from solver.scene import Room, Scene
from tests.floorplan import checks, homes
from tests.sweeps import seeds

KNOWN = load_catalogs()
WISHES: Mapping[str, Mapping[str, Any]] = {
    "family": {"program": "family"},
    "family, U": {"program": "family", "outline": "U"},
    "large": {"program": "large"},
    "one_bed, garden": {"program": "one_bed", "outdoor": True},
    "studio": {"program": "studio"},
    "plain": {},
    "plain, gardens": {"outdoor": True, "use_spine": False},
    "plain, cut": {"use_spine": False, "width": 14.0, "depth": 12.0},
}
WALLS = ((0.24, 0.42), (0.115, 0.365), (0.05, 0.05), (0.2, 0.2))
CASES = [(name, walls) for name in WISHES for walls in WALLS]
USUAL = 0.1
HALLWAY = 1.2
"""Clear width of a hallway, m."""


def joined(rooms: Sequence[Room], apart: float) -> tuple[Room, ...]:
    """The rooms with gardens brought to the lines of the house, from which they lie apart by what outer walls are thicker."""
    found = []
    for room in rooms:
        west, north, east, south = ends = [room.x, room.z, room.x + room.width, room.z + room.depth]
        for other, side in product([one for one in rooms if room.outdoor and not one.outdoor], range(4)):
            theirs = (other.x + other.width, other.z + other.depth, other.x, other.z)[side]
            along = (
                (max(north, other.z), min(south, other.z + other.depth))
                if side % 2 == 0
                else (max(west, other.x), min(east, other.x + other.width))
            )
            if abs(abs(theirs - (west, north, east, south)[side]) - apart) < 1e-6 and along[0] < along[1] - 1e-6:
                ends[side] = theirs
        shift = {"north": west - ends[0], "south": west - ends[0], "west": north - ends[1], "east": north - ends[1]}
        moved = tuple(replace(one, position=round(one.position + shift[str(one.wall)], 6)) for one in room.openings)
        x, z, width, depth = (round(one, 6) for one in (ends[0], ends[1], ends[2] - ends[0], ends[3] - ends[1]))
        found.append(replace(room, openings=moved, x=x, z=z, width=width, depth=depth))
    return tuple(found)


def lies_at_nothing(rooms: tuple[Room, ...], room: Room, wall: str) -> bool:
    """Whether some of a wall lies at no other room: points of it 5 cm apart, as lines are, a centimetre outside."""
    x0, z0, x1, z1 = checks.box(room)
    length = x1 - x0 if wall in ("north", "south") else z1 - z0
    for along in range(25, length, 50):
        x = x0 + along if wall in ("north", "south") else x0 - 10 if wall == "west" else x1 + 10
        z = z0 + along if wall in ("west", "east") else z0 - 10 if wall == "north" else z1 + 10
        if not any(a <= x <= c and b <= z <= d for a, b, c, d in map(checks.box, rooms)):
            return True
    return False


def too_tight(room: Room, inner: float) -> Iterator[str]:
    """Openings that reach into the wall around a corner, and hallways that are too narrow."""
    for opening in room.openings:
        low, high = opening.position - opening.width / 2, opening.position + opening.width / 2
        length = room.width if opening.wall in ("north", "south") else room.depth
        if low < inner / 2 - 1e-6 or high > length - inner / 2 + 1e-6:
            yield f"{opening.id} of {room.id} is cut into the corner"
    if room.type == "hallway" and min(room.width, room.depth) < HALLWAY + inner - 1e-6:
        yield f"{room.id} is narrow"


def too_small(room: Room, inner: float) -> bool:
    """Whether a room has less floor than its type's least between usual walls, or is narrower."""
    least, _, width, _ = homes.LIMITS[room.type]
    more = max(inner - USUAL, 0.0)
    return (room.width - more) * (room.depth - more) < least - 0.01 or min(room.width, room.depth) - more < width - 1e-6


@pytest.mark.parametrize(("name", "walls"), CASES)
def test_homes_between_thick_walls_are_sound(name: str, walls: tuple[float, float]) -> None:
    inner, outer = walls
    for seed in seeds(range(900, 920), 5):
        request = Request(seed=seed, wall_thickness=inner, outer_wall_thickness=outer, **WISHES[name])
        plan = draw(request, KNOWN)
        rooms = joined(plan.rooms, outer - inner)
        assert homes.sound(replace(plan, rooms=rooms)) == []
        assert [line for room in plan.rooms for line in too_tight(room, inner)] == []
        if request.planned:
            assert homes.violations(plan.rooms) == []
            assert [room.id for room in plan.rooms if room.type in homes.LIMITS and too_small(room, inner)] == []
        for room in plan.rooms:
            own = room.wall_thickness or (None,) * 4
            thick = {wall for wall, one in zip(("north", "east", "south", "west"), own, strict=True) if one == outer}
            outside = {wall for wall in ("north", "east", "south", "west") if lies_at_nothing(rooms, rooms[room.index], wall)}
            assert thick == (outside if outer != inner and not room.outdoor else set()), room.id


def behind_walls(rooms: Sequence[Room], inner: float, outer: float) -> Iterator[str]:
    """Openings to outside before which an outer wall of a room stands that comes forward beside them."""
    face = outer - inner / 2
    indoors = [(room.x - face, room.z - face, room.x + room.width + face, room.z + room.depth + face) for room in rooms if not room.outdoor]
    for room in (one for one in rooms if not one.outdoor):
        for opening in (one for one in room.openings if one.connects_to == "EXTERIOR"):
            along, size = (room.x, room.width) if opening.wall in ("north", "south") else (room.z, room.depth)
            line = {"north": room.z, "south": room.z + room.depth, "west": room.x, "east": room.x + room.width}[str(opening.wall)]
            across = line + (face + 0.02) * (-1 if opening.wall in ("north", "west") else 1)
            low, high = along + opening.position - opening.width / 2, along + opening.position + opening.width / 2
            assert along < low < high < along + size
            for x0, z0, x1, z1 in indoors:
                first, last, near, far = (x0, x1, z0, z1) if opening.wall in ("north", "south") else (z0, z1, x0, x1)
                if near < across < far and min(high, last) - max(low, first) > 1e-6:
                    yield f"{opening.id} of {room.id}"


@pytest.mark.parametrize("outline", ["L", "T", "U"])
@pytest.mark.parametrize("walls", [(0.08, 0.42), (0.15, 0.36)])
def test_nothing_opens_behind_a_wall_around_an_inner_corner(outline: str, walls: tuple[float, float]) -> None:
    inner, outer = walls
    for seed, name in product(seeds(range(960, 990), 12), ("family", "one_bed")):
        plan = draw(Request(seed=seed, wall_thickness=inner, outer_wall_thickness=outer, program=name, outline=outline), KNOWN)
        assert list(behind_walls(plan.rooms, inner, outer)) == []
        habitable = [room for room in plan.rooms if room.type in ("bedroom", "bedroom_master", "kids_bedroom", "living_room")]
        assert all(any(one.kind == "window" for one in room.openings) for room in habitable)


@pytest.mark.parametrize(
    ("name", "walls"),
    [
        ("family", (0.24, 0.42)),
        ("studio", (0.175, 0.36)),
        ("plain", (0.2, 0.3)),
        ("plain, gardens", (0.1, 0.3)),
        ("one_bed, garden", (0.2, 0.4)),
    ],
)
def test_they_are_furnished_walked_through_and_drawn(name: str, walls: tuple[float, float]) -> None:
    inner, outer = walls
    for seed in seeds(range(940, 946), 3):
        made = generate(Request(seed=seed, wall_thickness=inner, outer_wall_thickness=outer, **WISHES[name]))
        assert [issue.message for issue in made.issues if issue.severity == "error"] == []
        scene = made.scene
        assert scene.wall_thickness == inner
        assert scene.request is not None
        assert (scene.request["wall_thickness"], scene.request["outer_wall_thickness"]) == walls
        for room in scene.rooms:
            for piece in room.furniture:
                wide, deep = (piece.width, piece.depth) if piece.rotation % 180 == 0 else (piece.depth, piece.width)
                sides = piece.x - wide / 2, room.width - piece.x - wide / 2, piece.z - deep / 2, room.depth - piece.z - deep / 2
                assert min(sides) >= inner / 2 - 1e-6, piece.id
        drawn = describe(scene, KNOWN)
        assert {round(panel.thickness, 3) for panel in drawn.panels} == {inner, outer}
        for opening in drawn.openings:
            outdoor = {one.outdoor for one in scene.rooms if one.id in opening.rooms}
            assert round(opening.thickness, 3) == (outer if None in opening.rooms or len(outdoor) == 2 else inner), opening.id


def test_usual_walls_asked_for_make_the_home_that_is_made_unasked() -> None:
    unasked = generate(Request(seed=5, program="one_bed")).scene
    asked = generate(Request(seed=5, program="one_bed", wall_thickness=0.1)).scene
    assert unasked.rooms == asked.rooms
    assert unasked.request is not None
    assert not any("wall" in key for key in unasked.request)


def test_rooms_of_any_form_keep_their_least_floor() -> None:
    """A room of the least area between thick walls' lines, however long it may be, has the least floor between usual walls."""
    for more in (15, 140):
        for name, kind in KNOWN.widened(more).rooms.items():
            if kind.home is None:
                continue
            least, usual = kind.home.area[0], KNOWN.rooms[name].home
            assert usual is not None
            for form in (1.0, (1 + kind.home.aspect) / 2, kind.home.aspect):
                short = sqrt(least / form)
                assert (short - more / 1000) * (short * form - more / 1000) >= usual.area[0] - 0.01


def test_a_room_rolled_anew_keeps_its_walls() -> None:
    scene: Scene = generate(Request(seed=3, program="studio", wall_thickness=0.2, outer_wall_thickness=0.4)).scene
    other = reroll(scene, [scene.rooms[0].id], seed=9)
    assert [issue for issue in other.issues if issue.severity == "error"] == []
    assert [room.wall_thickness for room in other.scene.rooms] == [room.wall_thickness for room in scene.rooms]
    assert other.scene.wall_thickness == 0.2
