"""The walk against a flood over every 50 mm: exact where all edges are multiples of 100 mm."""

from __future__ import annotations

from collections import deque

import pytest

from solver.geometry import Rect
from solver.placement.walk import connected
from solver.streams import Stream
from solver.wanted import Doorway, Space


def raster_connected(space: Space, solids: list[Rect], stands: list[Rect]) -> bool:
    """Moves the centre of a 600 mm square in steps of 50 mm from the first door."""
    clear, half = space.clear, 300

    def free(x: int, z: int) -> bool:
        inside = clear.x0 <= x - half and x + half <= clear.x1 and clear.z0 <= z - half and z + half <= clear.z1
        return inside and not any(x - half < r.x1 and r.x0 < x + half and z - half < r.z1 and r.z0 < z + half for r in solids)

    groups: list[set[tuple[int, int]]] = []
    for door in space.doorways:
        z = clear.z1 - half if door.wall == "south" else clear.z0 + half
        groups.append({(x, z) for x in range(door.square.x0 + half, door.square.x1 - half + 1, 50)})
    groups += [{((r.x0 + r.x1) // 2, (r.z0 + r.z1) // 2)} for r in stands]
    for start in groups[0]:
        if not free(*start):
            continue
        seen, queue = {start}, deque([start])
        while queue:
            x, z = queue.popleft()
            for step in ((x + 50, z), (x - 50, z), (x, z + 50), (x, z - 50)):
                if step not in seen and free(*step):
                    seen.add(step)
                    queue.append(step)
        if all(seen & group for group in groups):
            return True
    return False


def random_case(seed: int) -> tuple[Space, list[Rect], list[Rect]]:
    stream = Stream(seed, "walk")
    width, depth = 2400 + 100 * stream.below(25), 2400 + 100 * stream.below(25)
    clear = Rect(0, 0, width, depth)
    doors = []
    for name, wall in (("door_1", "south"), ("door_2", "north")):
        x = 100 * stream.below((width - 900) // 100 + 1)
        square = Rect(x, depth - 900, x + 900, depth) if wall == "south" else Rect(x, 0, x + 900, 900)
        doors.append(Doorway(name, wall, square, "hall"))
    solids: list[Rect] = []
    for _ in range(3 + stream.below(5)):
        x, z = 100 * stream.below(width // 100), 100 * stream.below(depth // 100)
        r = Rect(x, z, min(x + 300 + 100 * stream.below(12), width), min(z + 300 + 100 * stream.below(9), depth))
        if not any(r.overlaps(door.square) for door in doors):
            solids.append(r)
    return Space("room", clear, (), tuple(doors)), solids, []


@pytest.mark.parametrize("seed", range(120))
def test_the_walk_agrees_with_the_flood(seed: int) -> None:
    space, solids, stands = random_case(seed)
    assert connected(space, solids, stands) == raster_connected(space, solids, stands)


def test_both_answers_occur() -> None:
    assert {connected(*random_case(seed)) for seed in range(120)} == {True, False}


@pytest.mark.parametrize(("gap", "passes"), [(600, True), (599, False)])
def test_a_gap_of_exactly_the_width_is_enough(gap: int, passes: bool) -> None:
    door = Doorway("d", "south", Rect(0, 2100, 900, 3000), "hall")
    space = Space("room", Rect(0, 0, 3000, 3000), (), (door,))
    wall = [Rect(0, 1400, 3000 - gap, 1500)]
    assert connected(space, wall, [Rect(0, 0, 600, 600)]) is passes
