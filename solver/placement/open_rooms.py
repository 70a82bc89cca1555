"""A room that was made, its problem left in the core's memory, for whoever reads that: /explain, tools and tests."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from struct import Struct
from typing import Final

import numpy as np

from solver.core import taken
from solver.pieces import Candidate, Piece, Space
from solver.placement.arrange import LIMITS, asked_of_room, lay_out_first
from solver.placement.budget import Budget
from solver.placement.core import Core, Limits
from solver.placement.empty_floor import FLOOR, PULL
from solver.placement.encode import Encoded, Tables
from solver.placement.layout import Engine, Ints
from solver.placement.made_rooms import SolvedRoom, answer_at, solved_room
from solver.placement.problem import Choice, Force, ProblemBox
from solver.placement.qp import forces_in

_PROBLEM: Final = Struct("<5q")
"""`struct MadeProblem` of solver/core/placement/entry.cpp."""


@dataclass(frozen=True)
class OpenRoom:
    """A room that was made, and its problem.

    Args:
        solved: the room.
        core: where its problem is.
        ways_mm: how wide the ways between its doors are, where they are wider than asked; else 0.
    """

    solved: SolvedRoom
    core: Core
    ways_mm: int

    @property
    def engine(self) -> Engine:
        """The work space that the problem is in."""
        return self.core.engine

    @cached_property
    def boxes(self) -> list[ProblemBox]:
        """The problem's boxes."""
        return self.core.boxes()

    @cached_property
    def choices(self) -> list[Choice]:
        """Its choices."""
        return self.core.choices(self.boxes)

    @cached_property
    def forces(self) -> tuple[Force, ...]:
        """What holds its pieces back, by OSQP."""
        return forces_in(self.engine)

    @property
    def decisions(self) -> Ints:
        """What was decided of the pieces of the problem."""
        return self.core.engine.call.decisions

    @property
    def preference(self) -> float:
        """What the candidates chosen cost."""
        return self.core.preference(self.decisions.copy())


def opened(  # noqa: PLR0913 - as `arrange`
    space: Space,
    pieces: Sequence[Piece],
    *,
    walk: bool = True,
    budget: Budget | None = None,
    limits: Limits = LIMITS,
    wide: bool = False,
    tidy: bool = False,
) -> OpenRoom:
    """Makes a room as `arrange`, and leaves its problem open."""
    allowed, core = budget or Budget(), taken(roomy=True)
    tables, request = lay_out_first(space, pieces)
    asked = asked_of_room(limits, allowed, walk=walk, wide=wide, tidy=tidy)
    address = int(core.call("make_room", core.write(request), core.write(asked)))
    answer = answer_at(core, address, space.room)
    allowed.left -= answer.made.spent
    at = address + answer.size
    desk, walked, ways, count, candidates = _PROBLEM.unpack(core.read(at, _PROBLEM.size))
    numbers = np.frombuffer(core.read(at + _PROBLEM.size, 8 * (count + candidates)), np.int64).tolist()
    engine = Engine(core, desk)
    encoded = Encoded(_as_made(tables, engine, numbers[:count], numbers[count:]), "stands" if walked else "none", engine)
    return OpenRoom(solved_room(space, answer, tables), Core(encoded), ways)


def _as_made(tables: Tables, engine: Engine, pieces: Sequence[int], ways: Sequence[int]) -> Tables:
    """Returns what the numbers of a room mean that the core made of one asked for: without some pieces, perhaps with floor kept empty."""
    shapes = engine.room.candidates[: ways.count(-1)].tolist()
    floor = tuple(Candidate(FLOOR, (row[1], row[2], row[3]), 0, None, (row[6], row[7]), PULL) for row in shapes)
    made = Tables(tables.space, [tables.pieces[k] if k >= 0 else Piece(FLOOR, True, floor, is_floor=True) for k in pieces])
    made.candidates = [*floor, *(tables.candidates[k] for k in ways if k >= 0)]
    return made
