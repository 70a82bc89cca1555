"""Free floor cut into tiles is the same floor: on random houses, in a town, in a heap."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.scene import Opening, Room, Scene
from solver.validator import tiled_floor
from solver.validator.tiled_floor import label
from solver.validator.walk import walks
from solver.validator.world import world_of
from tests.validator.test_against_raster import houses, told, unreached
from tests.validator.worlds import piece, room, scene


@settings(max_examples=40)
@given(houses(), st.sampled_from([8, 14, 25]))
def test_tiles_do_not_show(house: Scene, most: int) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(tiled_floor, "MOST", most)
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
    (walk,) = walks(world_of(town(14)))
    assert len(walk.free.tiles) >= 4
    assert told(town(14), "unreachable") == set()
    assert told(town(14, walled=9), "unreachable") == {("unreachable", f"{x}.{z}", ()) for x in range(14) for z in range(9, 14)}


def test_a_hall_of_thousands_of_pieces_takes_cells_in_proportion() -> None:
    """One grid of all would have (2 x 3600)^2 cells, which is more than can be calculated with."""
    crates = [piece(1.0 + x, 1.0 + z, 0.3, 0.3, id=f"{x}.{z}", name="sofa") for x in range(60) for z in range(60)]
    hall = scene(room(*crates, width=61.0, depth=61.0))
    assert told(hall, "unreachable", "overlap") == set()
    (walk,) = walks(world_of(hall))
    assert sum(tile.components.size for tile in walk.free.tiles) < 500 * len(crates)


@given(st.integers(0, 12), st.integers(0, 12), st.data())
def test_patches_are_what_a_flood_finds(rows: int, columns: int, data: st.DataObject) -> None:
    cells = data.draw(st.lists(st.lists(st.booleans(), min_size=columns, max_size=columns), min_size=rows, max_size=rows))
    free = np.array(cells, dtype=bool).reshape(rows, columns)
    expected = np.zeros((rows, columns), dtype=int)
    patch = 0
    for start in np.ndindex(rows, columns):
        if free[start] and not expected[start]:
            patch += 1
            waiting = [start]
            while waiting:
                row, column = waiting.pop()
                if 0 <= row < rows and 0 <= column < columns and free[row, column] and not expected[row, column]:
                    expected[row, column] = patch
                    waiting += [(row + 1, column), (row - 1, column), (row, column + 1), (row, column - 1)]
    assert (label(free) == expected).all()
