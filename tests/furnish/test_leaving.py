"""A run leaves places to pieces that come after it: whole, off its fronts and ends, and clear of doors."""

from __future__ import annotations

import pytest

from catalogs.entries import Run
from solver.furnish import space_of, wanted_pieces
from solver.pieces import Piece
from solver.scene import Room
from solver.streams import Stream
from tests.furnish.worlds import DOOR, KINDS, Box, box_of, catalog, den, piece

NAMES = ("shelf", "second", "third")
BEFORE, ASIDE, FLOOR = 700, 600, 600


def wanted(room: Room, seed: int, cost: float) -> dict[str, Piece]:
    """Returns what a room wants: three shelves in a run, which had better leave a table a place, and the table."""
    run = {"orders": [NAMES], "leaves": [{"to": "table", "floor": FLOOR / 1000, "cost": cost}]}
    known = catalog([*(piece(name, kinds=[{"kind": "shelf"}], required=True) for name in NAMES), piece("table")])
    own = known.rooms["den"].model_copy(update={"run": Run.model_validate(run)})
    found = wanted_pieces(room, space_of(room, 0.1), known.model_copy(update={"rooms": {"den": own}}), Stream(seed, "furnish", 0))
    return {one.label.rsplit("_", 1)[0]: one for one in found}


def floor_of(table: Piece) -> Box:
    """Returns the floor at the front and back of the table's first place, with the table."""
    x, z = table.candidates[0].anchor_mm
    width, depth = (round(1000 * length) for length in KINDS["table"]["size"][:2])
    across, along = (width, depth + 2 * FLOOR) if table.candidates[0].rotation == 0 else (depth + 2 * FLOOR, width)
    return (x - across / 2, z - along / 2, x + across / 2, z + along / 2)


def kept(shelf: Piece) -> Box:
    """Returns a shelf's first place with the floor before it and beside it."""
    west, north, east, south = box_of(shelf.candidates[0])
    ahead = {0: (ASIDE, 0, ASIDE, BEFORE), 90: (0, ASIDE, BEFORE, ASIDE), 180: (ASIDE, BEFORE, ASIDE, 0), 270: (BEFORE, ASIDE, 0, ASIDE)}
    w, n, e, s = ahead[shelf.candidates[0].rotation]
    return (west - w, north - n, east + e, south + s)


def apart(one: Box, two: Box) -> bool:
    return one[2] <= two[0] or two[2] <= one[0] or one[3] <= two[1] or two[3] <= one[1]


@pytest.mark.parametrize("seed", range(12))
def test_a_run_leaves_a_place_to_what_comes_after_it(seed: int) -> None:
    pieces = wanted(den(DOOR, width=4.0, depth=3.3), seed, cost=50.0)
    floor, table = floor_of(pieces["table"]), pieces["table"].candidates[0]
    assert table.cost == 0
    assert floor[0] >= 50 and floor[1] >= 50 and floor[2] <= 3950 and floor[3] <= 3250
    assert all(apart(floor, kept(pieces[name])) for name in NAMES)


def test_where_no_run_leaves_a_place_the_table_is_wanted_all_the_same() -> None:
    pieces = wanted(den(DOOR, width=3.4, depth=2.2), 1, cost=50.0)
    assert pieces["table"].candidates and all(candidate.cost < 8 for candidate in pieces["table"].candidates)
