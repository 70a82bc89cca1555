"""Openings cut by the core as it is built, and by a native build that checks every index and traps at undefined behaviour."""

from __future__ import annotations

from solver.core import ask
from solver.floorplan.openings import open_walls, rows_of
from tests.core.native import Native
from tests.floorplan.opened import opened_question
from tests.sweeps import seeds


def rows_asked(number: int) -> tuple[tuple[str, bytes], tuple[str, bytes]]:
    """Returns what the core is asked of a house: to cut all openings, then where else the last door could stand."""
    house, tree, entrance, _ = opened_question(number)
    cuts = open_walls(house, tree, entrance)[0]
    moved = next(cut for cut in reversed(cuts) if cut.kind in ("door", "passage"))
    joint = [one for one in tree if (one[0].a, one[0].b) == tuple(sorted(moved.sides))]
    others = [*(cut for cut in cuts if cut is not moved), moved]
    return ("open_walls", rows_of(house, tree, entrance)), ("door_places", rows_of(house, joint, entrance, others))


def test_checked_and_as_built_agree_to_the_last_bit(native: Native) -> None:
    asked = [one for number in seeds(range(2400), 43) for one in rows_asked(number)]
    for call in ("open_walls", "door_places"):
        rows = [rows for name, rows in asked if name == call]
        assert native.answers(call, ([one] for one in rows)) == b"".join(ask(call, one) for one in rows)
