"""Free floor cut into tiles is the same floor: on random houses, in a town, in a heap."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.scene import Opening, Room, Scene
from solver.validator import floors, walk
from solver.validator.world import world_of
from tests.sweeps import examples
from tests.validator.test_against_raster import houses, told, unreached
from tests.validator.worlds import piece, room, scene


@examples(16)
@given(houses(), st.sampled_from([8, 14, 25]))
def test_tiles_do_not_show(house: Scene, most: int) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(walk, "MOST", most)
        assert told(house, "unreachable") == unreached(house)


def town(side: int, walled: int | None = None) -> Scene:
    """Builds side x side rooms of 3 m, a door in every wall between two, the way in at the north-west; no doors into row `walled`."""
    rooms = []
    for x in range(side):
        for z in range(side):
            doors = []
            for wall, to_x, to_z in (("east", x + 1, z), ("west", x - 1, z), ("south", x, z + 1), ("north", x, z - 1)):
                is_room = 0 <= to_x < side and 0 <= to_z < side
                if is_room and not (wall in ("south", "north") and walled == max(z, to_z)):
                    between = f"{min(x, to_x)}.{min(z, to_z)}-{max(x, to_x)}.{max(z, to_z)}"
                    doors.append(Opening(between, wall=wall, position=1.5, connects_to=f"{to_x}.{to_z}"))
            if x == z == 0:
                doors.append(Opening("in", wall="north", position=1.5, main_entrance=True))
            rooms.append(Room(f"{x}.{z}", x=3.0 * x, z=3.0 * z, width=3.0, depth=3.0, openings=tuple(doors)))
    return Scene(rooms=tuple(rooms), wall_thickness=0.1)


def test_a_town_is_walked_from_tile_to_tile() -> None:
    (tiled,) = walk.walks(world_of(town(14)))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(walk, "MOST", 10_000)
        (whole,) = walk.walks(world_of(town(14)))
    assert tiled.tiles >= 4 > whole.tiles == 1
    assert (tiled.areas, tiled.missed, tiled.comes_in) == (whole.areas, whole.missed, whole.comes_in)
    assert told(town(14), "unreachable") == set()
    assert told(town(14, walled=9), "unreachable") == {("unreachable", f"{x}.{z}", ()) for x in range(14) for z in range(9, 14)}


def test_a_hall_of_thousands_of_pieces_takes_cells_in_proportion() -> None:
    """One grid of all would have (2 x 3600)^2 cells, which is more than can be calculated with."""
    crates = [piece(1.0 + x, 1.0 + z, 0.3, 0.3, id=f"{x}.{z}", name="sofa") for x in range(60) for z in range(60)]
    hall = scene(room(*crates, width=61.0, depth=61.0))
    assert told(hall, "unreachable", "overlap") == set()
    (walked,) = walk.walks(world_of(hall))
    assert walked.cells < 500 * len(crates)


@examples(24)
@given(st.lists(st.lists(st.booleans(), min_size=7, max_size=7), min_size=1, max_size=7), st.sampled_from([6, 400]))
def test_what_is_come_to_is_what_a_flood_finds(taken: list[list[bool]], most: int) -> None:
    """A hall of squares of 1 m, some of them taken by crates; one comes in at the first."""
    rows, columns = len(taken), len(taken[0])
    crates = [piece(k + 0.5, i + 0.5, id=f"{i}.{k}") for i in range(rows) for k in range(columns) if taken[i][k]]
    way_in = Opening("in", wall="north", position=0.5, main_entrance=True)
    hall = scene(room(*crates, width=float(columns), depth=float(rows), openings=(way_in,)), request={"robot_width": 0.1})
    reached, waiting = set(), [(0, 0)]
    while waiting:
        i, k = waiting.pop()
        if 0 <= i < rows and 0 <= k < columns and not taken[i][k] and (i, k) not in reached:
            reached.add((i, k))
            waiting += [(i + 1, k), (i - 1, k), (i, k + 1), (i, k - 1)]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(walk, "MOST", most)
        (floor,) = floors(hall)
    for i in range(rows):
        for k in range(columns):
            shared = [(min(x1, k + 1) - max(x0, k), min(z1, i + 1) - max(z0, i)) for x0, z0, x1, z1 in floor["free"]]
            assert sum(x * z for x, z in shared if x > 0 and z > 0) == pytest.approx(float((i, k) in reached), abs=1e-5)
