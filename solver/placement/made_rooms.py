"""What the core answers of a room that it made: what stands, what was left out and why, as rows that are read here alone.

The rows are those of solver/core/placement/making.hpp.
"""

from collections.abc import Container, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from struct import Struct
from typing import Final, NamedTuple, Protocol

from solver.core import CoreInstance
from solver.geometry import Rect
from solver.pieces import Arrangement, Candidate, Placed, Residuals, Space, StandingRows
from solver.placement.layout import CANNOT_STAND, COVERED, NO_WAY, NOT_FOUND, SPENT
from solver.placement.why_left_out import WALLS, clear_size, named_parent, room_needed
from solver.records import changed, made_later
from solver.scene import WALLS as NUMBERED_WALLS

_MADE: Final = Struct("<11q3d")
_PLACED: Final = Struct("<3q2i4q")
_LEFT_OUT: Final = Struct("<2qd9q")
NOT_WALKABLE = "no walkable arrangement of the required pieces was found"
_WHY: Final = {
    CANNOT_STAND: "no way to stand it is free beside the pieces before it",
    NOT_FOUND: "no place was found for it beside the pieces before it",
    NO_WAY: "no way to stand it was found that leaves the room valid and walkable",
    COVERED: "the floor is covered as densely as wished without it",
    SPENT: "no place found for it within the search's limit",
}
_AS_NAMED: Final = tuple(map(NUMBERED_WALLS.index, WALLS))
"""The numbers of the walls, in the order in which reasons name them."""
_WALL_NAMES: Final = (*NUMBERED_WALLS, None)


class Made(NamedTuple):
    """What the core says of a room: `struct MadeRoom`."""

    placed: int
    left_out: int
    problem: int
    failed: int
    walked: int
    walkable: int
    proven: int
    best: int
    optimal: int
    widened: int
    solves: int
    cost: float
    added: float
    spent: float


class RoomAnswer(NamedTuple):
    """A room made: what is said of it, rows of what stands and of what does not, its final problem, and what lies behind that."""

    made: Made
    placed: bytes
    left_out: bytes
    problem: bytes
    more: bytes = b""

    @property
    def size(self) -> int:
        """How many bytes it takes without that."""
        return _MADE.size + len(self.placed) + len(self.left_out) + len(self.problem)


class Numbered(Protocol):
    """What the numbers of an answer mean."""

    def label_of(self, piece: int) -> str:
        """Returns the label of a piece that was asked for."""

    def kind_of(self, number: int) -> str:
        """Returns the name of a kind."""

    def ways_of(self, candidates: Iterable[int]) -> Iterable[Candidate]:
        """Returns how those stand that stand, by the numbers of their candidates."""

    def why_nowhere(self, piece: int) -> str:
        """Says why a piece has no way to stand at all."""


def answer_in(data: bytes, room: str) -> RoomAnswer:
    """Returns what bytes say of a room.

    Raises:
        AssertionError: the search found nothing, or what breaks a rule, which it never does.
    """
    made = tuple.__new__(Made, _MADE.unpack_from(data))
    if made.failed:
        raise AssertionError(f"{room}: nothing that holds was found")
    missing_at = _MADE.size + _PLACED.size * made.placed
    problem_at = missing_at + _LEFT_OUT.size * made.left_out
    end = problem_at + 8 * made.problem
    return RoomAnswer(made, data[_MADE.size : missing_at], data[missing_at:problem_at], data[problem_at:end], data[end:])


def answer_at(core: CoreInstance, address: int, room: str) -> RoomAnswer:
    """Returns what is said of a room at an address; raises AssertionError as `answer_in`."""
    made = Made(*_MADE.unpack(core.read(address, _MADE.size)))
    size = _MADE.size + _PLACED.size * made.placed + _LEFT_OUT.size * made.left_out + 8 * made.problem
    return answer_in(core.read(address, size), room)


@dataclass(frozen=True)
class _Placing:
    """The pieces of a room that stand, as the core told them; called, it makes them. `standing` is the same as bodies, where told."""

    rows: bytes
    numbered: Numbered
    standing: StandingRows | None

    def __call__(self) -> tuple[Placed, ...]:
        rows, label = [*_PLACED.iter_unpack(self.rows)], self.numbered.label_of
        ways = self.numbered.ways_of(row[1] for row in rows)
        return tuple(
            Placed(label(piece), way, rotation, _WALL_NAMES[wall], Rect(x0, z0, x1, z1))
            for (piece, _, rotation, wall, _, x0, z0, x1, z1), way in zip(rows, ways, strict=True)
        )


def arrangement_of(
    space: Space, answer: RoomAnswer, numbered: Numbered, residuals: Residuals | None = None, standing: StandingRows | None = None
) -> Arrangement:
    """Returns a room as it was made; what stands in it is written when somebody asks for it."""
    made, gone = answer.made, [*_LEFT_OUT.iter_unpack(answer.left_out)]
    left_out = tuple(_reasons(space, numbered, gone, made.placed)) if gone else ()
    skipped = {label: row[2] for (label, _), row in zip(left_out, gone, strict=True)}
    notes, cost = () if made.walkable else (NOT_WALKABLE,), round(made.cost + made.added, 6)
    proven, best = bool(made.proven), bool(made.best)
    arrangement = Arrangement(space.room, (), left_out, cost, proven, made.solves, notes, best, residuals, skipped)
    return made_later(arrangement, placed=_Placing(answer.placed, numbered, standing))


def _reasons(space: Space, numbered: Numbered, rows: Sequence[tuple[float, ...]], count: int) -> Iterator[tuple[str, str]]:
    """Yields the label of each piece that was left out, and why."""
    gone, holds = {row[0] for row in rows}, f"{clear_size(space.clear)} and holds {count} pieces"
    for row in rows:
        piece, fate = int(row[0]), int(row[1])
        yield numbered.label_of(piece), f"{_WHY[fate]}; {_room_left(numbered, row, gone, holds)}"


def _room_left(numbered: Numbered, row: Sequence[float], gone: Container[float], holds: str) -> str:
    """Says how much room the smallest way of a piece that was left out needs, and how much there is."""
    piece, _, _, parent, kind, width, depth, at_walls, *free = map(int, (row[0], row[1], 0, *row[3:]))
    if kind < 0:
        return numbered.why_nowhere(piece)
    longest = [free[number] for number in _AS_NAMED] if at_walls else ()
    at = named_parent(numbered.label_of(parent), parent in gone) if parent >= 0 else None
    return room_needed((numbered.kind_of(kind), width, depth), at, longest, holds)


@dataclass(frozen=True)
class SolvedRoom:
    """A room whose pieces stand.

    Args:
        arrangement: on whole millimetres.
        answer: what the core said of it.
        walkable: whether the placement was, before it was put on whole millimetres.
    """

    arrangement: Arrangement
    answer: RoomAnswer
    walkable: bool

    @property
    def cost(self) -> float:
        """Terms and preferences, before slivers are tidied away."""
        return self.answer.made.cost

    @property
    def fates(self) -> dict[str, int]:
        """The number of why each piece was left out."""
        rows = _LEFT_OUT.iter_unpack(self.answer.left_out)
        return {label: row[1] for (label, _), row in zip(self.arrangement.left_out, rows, strict=True)}

    def with_(self, **values: object) -> "SolvedRoom":
        """Returns the room with other things said of its arrangement."""
        return replace(self, arrangement=changed(self.arrangement, **values))


def solved_room(space: Space, answer: RoomAnswer, numbered: Numbered) -> SolvedRoom:
    """Returns a room as the core made it."""
    return SolvedRoom(arrangement_of(space, answer, numbered), answer, bool(answer.made.walked))
