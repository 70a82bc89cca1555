"""Rooms made by the core in one go, from what is wanted to what stands in them; OSQP confirms the optimum of the whole house.

Not here: what is wanted (furnish). The rows are those of solver/core/rooms/made.hpp.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import inf
from struct import Struct, pack
from typing import Final

from solver.body_rows import KIND
from solver.core import CoreInstance, borrowed
from solver.pieces import Arrangement, Candidate, Residuals, StandingRows, WantedRows
from solver.placement.budget import ROOM_WORK, Budget, charge
from solver.placement.made_rooms import RoomAnswer, answer_in, arrangement_of
from solver.placement.qp import house_residuals
from solver.records import kept

_NAME: Final = Struct("<3q")
_WAY: Final = Struct("<176s")


def place_wanted(rooms: Sequence[WantedRows], tidy: bool = False, engine: str = "osqp") -> list[Arrangement]:
    """Makes every room of a house.

    Args:
        rooms: what each is made of.
        tidy: whether slivers are closed or opened afterwards (solver/core/placement/tidy.hpp), at a cost of at most 0.8 a room.
        engine: who confirms the optimum: "osqp", or "reference" for the cvxpy model.

    Returns:
        One arrangement a room, in the same order, exactly valid on the millimetre lattice.

    Raises:
        AssertionError: the search found nothing, or what breaks a rule, which it never does.
        OptimumRefuted: another optimum is found than one that was proven.
    """
    with borrowed(roomy=True) as core:
        answers, problems = _made(core, rooms, tidy)
        residuals = house_residuals(core, answers, problems, engine)
    return [_arrangement(room, answer, said) for room, answer, said in zip(rooms, answers, residuals, strict=True)]


def _made(core: CoreInstance, rooms: Sequence[WantedRows], tidy: bool) -> tuple[list[RoomAnswer], list[int]]:
    """Makes rooms one after the other: each may cost what a room may, and all of them what is left of the call's work.

    Returns what is said of them, and where their final problems are in the core's memory.
    """
    types = {rows: number for number, rows in enumerate(dict.fromkeys(room.type_rows for room in rooms))}
    numbers = core.write(pack(f"<{len(rooms)}i", *[types[room.type_rows] for room in rooms]))
    sent, wanted = core.send([*types]), core.send([room.room_rows for room in rooms])
    core.call("make_rooms", sent, numbers, wanted, len(rooms), tidy, ROOM_WORK, Budget(inf).left)
    told = core.told(wanted, len(rooms))
    answers = [answer_in(data, room.space.room) for room, (_, data) in zip(rooms, told, strict=True)]
    charge(sum(answer.made.spent for answer in answers))
    return answers, [at + answer.size - len(answer.problem) for answer, (at, _) in zip(answers, told, strict=True)]


@dataclass(frozen=True)
class _WantedNumbers:
    """What the numbers of a room mean: `names` is what the wanted pieces are called by, `ways` is how those that stand were placed."""

    room: WantedRows
    names: bytes
    ways: bytes

    @kept
    def _named(self) -> list[tuple[int, int, int]]:
        """The rows of the wanted pieces' labels."""
        return [*_NAME.iter_unpack(self.names)]

    def label_of(self, piece: int) -> str:
        """Returns the label of a wanted piece."""
        return self.room.label(self._named, piece)

    def kind_of(self, number: int) -> str:
        """Returns the name of a kind."""
        return self.room.kinds[number][0]

    def ways_of(self, candidates: Iterable[int]) -> list[Candidate]:
        """Returns how those stand that stand."""
        labels = [self.label_of(at) for at in range(len(self._named))]
        return [self.room.candidate(way, labels) for (way,) in _WAY.iter_unpack(self.ways)]

    def why_nowhere(self, piece: int) -> str:
        """Never asked: what is wanted has a way to stand."""
        raise NotImplementedError(self.label_of(piece))


def _arrangement(room: WantedRows, answer: RoomAnswer, residuals: Residuals | None) -> Arrangement:
    more = answer.more
    ways_at = 8 + _NAME.size * int.from_bytes(more[:8], "little")
    bodies_at = ways_at + _WAY.size * answer.made.placed
    bodies = more[bodies_at:]
    standing = StandingRows(bodies, room.kinds, [room.looks[kind] for (kind,) in KIND.iter_unpack(bodies)])
    wanted = _WantedNumbers(room, more[8:ways_at], more[ways_at:bodies_at])
    return arrangement_of(room.space, answer, wanted, residuals, standing)
