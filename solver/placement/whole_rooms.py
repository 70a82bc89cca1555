"""Rooms made by the core in one go, from what is wanted to what stands in them; OSQP confirms the optimum of the whole house.

Not here: what is wanted (furnish). The rows are those of solver/core/rooms/made.hpp.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import inf
from struct import Struct, pack
from typing import Any, Final, NamedTuple

from solver.body_rows import BODY, KIND
from solver.core import CoreInstance, borrowed
from solver.geometry import Rect
from solver.pieces import Arrangement, Placed, Residuals, StandingRows, WantedRows
from solver.placement.arrange import CANNOT_STAND, NOT_FOUND, NOT_WALKABLE, REASONS
from solver.placement.budget import ROOM_WORK, Budget, charge
from solver.placement.layout import COVERED, NO_WAY, SPENT
from solver.placement.left_out import WALLS, clear_size, named_parent, room_needed
from solver.placement.qp import REFUTED, OptimumRefuted, solved_house
from solver.records import kept, made_later
from solver.scene import WALLS as NUMBERED_WALLS

_MADE: Final = Struct("<11q2d")
_NAME: Final = Struct("<3q")
_PLACED: Final = Struct("<7q176s")
_LEFT_OUT: Final = Struct("<2qd7q")
_WHY: Final = (CANNOT_STAND, NOT_FOUND, REASONS[NO_WAY], REASONS[COVERED], REASONS[SPENT])
"""By `enum Why`."""
_new: Final = tuple.__new__
_AS_NAMED: Final = tuple(map(NUMBERED_WALLS.index, WALLS))
"""The numbers of the walls, in the order in which reasons name them."""
_WALL_NAMES: Final = (*NUMBERED_WALLS, None)


class _Made(NamedTuple):
    """What the core says of a room: `struct MadeRoom`."""

    names: int
    placed: int
    left_out: int
    problem: int
    failed: int
    walkable: int
    proven: int
    best: int
    optimal: int
    widened: int
    solves: int
    cost: float
    spent: float


class _Answer(NamedTuple):
    """A room made: what is said of it, its rows, and where in the core's memory its final problem is."""

    made: _Made
    rows: bytes
    problem: int


def place_wanted(rooms: Sequence[WantedRows], tidy: bool = False) -> list[Arrangement]:
    """Makes every room of a house.

    Args:
        rooms: what each is made of.
        tidy: whether slivers are closed or opened afterwards (solver/core/placement/tidy.hpp), at a cost of at most 0.8 a room.

    Returns:
        One arrangement a room, in the same order, exactly valid on the millimetre lattice.

    Raises:
        AssertionError: the search found nothing, or what breaks a rule, which it never does.
        OptimumRefuted: OSQP finds another optimum than one that was proven.
    """
    with borrowed(roomy=True) as core:
        answers = _made(core, rooms, tidy)
        residuals = _residuals(core, answers)
    return [_arrangement(room, answer, said) for room, answer, said in zip(rooms, answers, residuals, strict=True)]


def _made(core: CoreInstance, rooms: Sequence[WantedRows], tidy: bool) -> list[_Answer]:
    """Makes rooms one after the other: each may cost what a room may, and all of them what is left of the call's work."""
    types = {rows: number for number, rows in enumerate(dict.fromkeys(room.type_rows for room in rooms))}
    numbers = core.write(pack(f"<{len(rooms)}i", *[types[room.type_rows] for room in rooms]))
    sent, wanted = core.send([*types]), core.send([room.room_rows for room in rooms])
    core.call("make_rooms", sent, numbers, wanted, len(rooms), tidy, ROOM_WORK, Budget(inf).left)
    answers = []
    for room, (at, data) in zip(rooms, core.told(wanted, len(rooms)), strict=True):
        made = _new(_Made, _MADE.unpack_from(data))
        if made.failed:
            raise AssertionError(f"{room.space.room}: nothing that holds was found")
        answers.append(_Answer(made, data, at + len(data) - 8 * made.problem))
    charge(sum(one.made.spent for one in answers))
    return answers


def _residuals(core: CoreInstance, answers: Sequence[_Answer]) -> list[Residuals | None]:
    """Asks OSQP for the optimum of the whole house; raises OptimumRefuted where it is another one than one that was proven."""
    answer = solved_house(core, [one.problem for one in answers])
    if answer is None:
        return [None] * len(answers)
    for one, judged in zip(answers, answer.rooms, strict=True):
        if one.made.optimal and judged.moved > REFUTED:
            raise OptimumRefuted(one.rows[len(one.rows) - 8 * one.made.problem :])
    return [None if one.made.widened else judged.residuals for one, judged in zip(answers, answer.rooms, strict=True)]


@dataclass(frozen=True)
class _Placing:
    """The pieces of a room that stand, as the core told them; called, it makes them.

    `names` is what the wanted pieces are called by, `ways` is how those that stand were placed, `standing` the same as bodies.
    """

    room: WantedRows
    names: bytes
    ways: bytes
    standing: StandingRows

    def __call__(self) -> tuple[Placed, ...]:
        labels, candidate = [self.room.label(self.named, at) for at in range(len(self.named))], self.room.candidate
        return tuple(
            Placed(labels[piece], candidate(way, labels), rotation, _WALL_NAMES[wall], Rect(x0, z0, x1, z1))
            for piece, rotation, wall, x0, z0, x1, z1, way in _PLACED.iter_unpack(self.ways)
        )

    @kept
    def named(self) -> list[tuple[int, int, int]]:
        """The rows of the wanted pieces' labels."""
        return [*_NAME.iter_unpack(self.names)]


def _arrangement(room: WantedRows, answer: _Answer, residuals: Residuals | None) -> Arrangement:
    made, data, begin = answer.made, answer.rows, _MADE.size
    ways_at = begin + _NAME.size * made.names
    bodies_at = ways_at + _PLACED.size * made.placed
    missing_at = bodies_at + BODY.size * made.placed
    names, ways, bodies = data[begin:ways_at], data[ways_at:bodies_at], data[bodies_at:missing_at]
    missing = data[missing_at : missing_at + _LEFT_OUT.size * made.left_out]
    standing = StandingRows(bodies, room.kinds, [room.looks[kind] for (kind,) in KIND.iter_unpack(bodies)])
    placing = _Placing(room, names, ways, standing)
    gone = [*_LEFT_OUT.iter_unpack(missing)]
    left_out = tuple(_reasons(room, placing, gone, made.placed)) if gone else ()
    skipped = {label: row[2] for (label, _), row in zip(left_out, gone, strict=True)}
    notes = () if made.walkable else (NOT_WALKABLE,)
    proven, best = bool(made.proven), bool(made.best)
    arrangement = Arrangement(room.space.room, (), left_out, made.cost, proven, made.solves, notes, best, residuals, skipped)
    return made_later(arrangement, placed=placing)


def _reasons(room: WantedRows, placing: _Placing, rows: Sequence[tuple[Any, ...]], count: int) -> Iterator[tuple[str, str]]:
    """Yields the label of each piece that was left out, and why."""
    gone, holds = {row[0] for row in rows}, f"{clear_size(room.space.clear)} and holds {count} pieces"
    named, kinds = placing.named, room.kinds
    for piece, why, _, parent, kind, at_walls, *free in rows:
        longest = [free[number] for number in _AS_NAMED] if at_walls else ()
        at = named_parent(room.label(named, parent), parent in gone) if parent >= 0 else None
        yield room.label(named, piece), f"{_WHY[why]}; {room_needed(kinds[kind], at, longest, holds)}"
