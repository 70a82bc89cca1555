"""Walls that plans keep whole: openings move for a bed, a sofa and its screen, a kitchen's run, and for nothing else."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from catalogs import Catalogs, load_catalogs
from solver import Request
from solver.floorplan import draw
from solver.scene import Opening, Room

KNOWN = load_catalogs()
SQUARE = 900
"""The floor at a door, as deep as the door is wide, at most so deep, mm."""
PROGRAMS = ("studio", "one_bed", "family", "large", None)


def without_keeping() -> Catalogs:
    """Returns our catalogs with plans that keep no walls."""
    rooms = {name: kind.model_copy(update={"plan": kind.plan.model_copy(update={"keeps": ()})}) for name, kind in KNOWN.rooms.items()}
    return KNOWN.model_copy(update={"rooms": rooms})


def ends(opening: Opening) -> tuple[int, int]:
    middle, half = round(opening.position * 1000), round(opening.width * 500)
    return middle - half, middle + half


def broken(room: Room, wall: str, depth: int) -> NDArray[np.bool_]:
    """Tells of each cm of a wall whether a window is in it, or a door's square on the floor before it: by a raster of 1 by 5 cm."""
    width, length = round(room.width * 1000), round(room.depth * 1000)
    at = np.arange(5, width if wall in ("north", "south") else length, 10)[:, None]
    off = np.arange(5, depth, 50)[None, :]
    x, z = {"north": (at, off), "south": (at, length - off), "west": (off, at), "east": (width - off, at)}[wall]
    found = np.zeros((at.size, off.size), dtype=bool)
    for opening in room.openings:
        low, high = ends(opening)
        if opening.kind == "window":
            found |= (opening.wall == wall) & (low < at) & (at < high)
            continue
        across, into = (x, z) if opening.wall in ("north", "south") else (z, x)
        into = into if opening.wall in ("north", "west") else (length if opening.wall == "south" else width) - into
        found |= (low < across) & (across < high) & (into < min(high - low, SQUARE))
    return np.logical_or.reduce(found, axis=1)


def longest(room: Room, depth: int) -> int:
    """Returns the longest whole stretch of any of a room's walls, mm, within 2 cm."""
    best = 0
    for wall in ("north", "south", "west", "east"):
        run = 0
        for is_broken in broken(room, wall, depth).tolist():
            run = 0 if is_broken else run + 10
            best = max(best, run)
    return best


@pytest.mark.parametrize(
    ("program", "kind", "depth", "length", "more"),
    [("family", "bedroom_master", 2100, 2800, 3), ("studio", "living_room", 2100, 2800, 30), ("one_bed", "foyer", 400, 1500, 30)],
)
def test_a_bed_a_sofa_and_coats_find_a_whole_wall(program: str, kind: str, depth: int, length: int, more: int) -> None:
    """A wide bed between its nightstands takes 2.8 m; where plans keep no walls, fewer rooms have such."""

    def count(catalogs: Catalogs) -> int:
        homes = (draw(Request(seed=seed, program=program), catalogs) for seed in range(310, 370))
        return sum(longest(room, depth) >= length for home in homes for room in home.rooms if room.type == kind)

    kept = count(KNOWN)
    assert kept >= 50
    assert count(without_keeping()) <= kept - more


@pytest.mark.parametrize(("program", "cornered"), [("family", 0.9), ("large", 0.9), (None, 0.75)])
def test_doors_of_bedrooms_stand_near_a_corner_and_do_not_face_others(program: str | None, cornered: float) -> None:
    near, doors, facing = 0, 0, 0
    for seed in range(330, 345):
        rooms = {room.id: room for room in draw(Request(seed=seed, program=program), KNOWN).rooms}
        for room, door in ((own, one) for own in rooms.values() if "bedroom" in own.type for one in own.openings):
            if door.kind != "door" or door.swing != "in" or rooms[door.connects_to or ""].type != "hallway":
                continue
            low, high = ends(door)
            length = round((room.width if door.wall in ("north", "south") else room.depth) * 1000)
            doors, near = doors + 1, near + (min(low, length - high) <= 500)
            facing += any(_faces(room, door, other, rooms[door.connects_to or ""]) for other in rooms[door.connects_to or ""].openings)
    assert doors >= 40
    assert near >= cornered * doors
    assert facing <= 0.1 * doors  # 0.38 of plain homes' where doors of the hallway with the front door stayed


def _faces(room: Room, door: Opening, other: Opening, hallway: Room) -> bool:
    """Tells whether a door or passage is straight across a hallway from a room's door, within half a metre."""
    if other.kind not in ("door", "passage") or other.wall != door.wall:
        return False
    off = hallway.x - room.x if door.wall in ("north", "south") else hallway.z - room.z
    return abs(other.position + off - door.position) < 0.499


@pytest.mark.parametrize("program", PROGRAMS)
def test_openings_move_within_their_walls_alone(program: str | None) -> None:
    """Same rooms, same openings in the same walls of the same widths, in the same order."""
    for seed in range(320, 324):
        kept, before = (draw(Request(seed=seed, program=program), catalogs).rooms for catalogs in (KNOWN, without_keeping()))
        assert [[(o.id, o.kind, o.wall, o.width, o.connects_to) for o in room.openings] for room in kept] == [
            [(o.id, o.kind, o.wall, o.width, o.connects_to) for o in room.openings] for room in before
        ]


def test_what_keeps_nothing_moves_nothing() -> None:
    rooms = dict(without_keeping().rooms)
    short = KNOWN.rooms["kitchen"].plan.keeps[0].model_copy(update={"length": 0.1})
    kitchen = KNOWN.rooms["kitchen"]
    rooms["kitchen"] = kitchen.model_copy(update={"plan": kitchen.plan.model_copy(update={"keeps": (short,)})})
    asked = Request(seed=7, program="family")
    assert draw(asked, KNOWN.model_copy(update={"rooms": rooms})).rooms == draw(asked, without_keeping()).rooms
