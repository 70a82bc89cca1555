"""The types of all rooms of a home that suit them best together: found by a search that keeps the cheapest of what it has tried."""

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from solver.guessing.room_numbers import Costs, Counts, RoomNumbers
from solver.guessing.suiting import NEVER, Suiting

KEPT: Final = 200
"""Ways to give types to the first rooms of a home that are looked at further: the cheapest."""
SWEEPS: Final = 12
"""How often all rooms are looked at anew, at most."""
DIGITS: Final = 9
"""Costs that are alike to so many digits are alike."""
Types = NDArray[np.int64]


class TypesInHome:
    """The types of a home's rooms, and what they cost. A room of a kind that we have no type for is as if it were not there.

    `fixed` are types that are known, by room, empty for such a kind; `program` says how many rooms of each word there are, where that is
    known.
    """

    def __init__(self, suiting: Suiting, fixed: Mapping[int, str], program: Mapping[str, int] | None = None) -> None:
        self.marks = suiting.marks
        self._names = list(suiting.kinds)
        self._none = len(self._names)
        self.free = [k for k in range(len(self.marks)) if k not in fixed]
        """The rooms that are guessed."""
        self._alone = {k: np.array([suiting.alone(k, name) for name in self._names]) for k in self.free}
        self._joined = _joined(suiting) if self.free else np.zeros((6, 0, 0))
        indoors = sum(not one.outdoor for k, one in enumerate(self.marks) if fixed.get(k) != "")
        self._numbers = RoomNumbers(suiting.catalogs, indoors, program)
        start = [self._names.index(fixed[k]) if fixed.get(k) else self._none for k in range(len(self.marks))]
        self._types = self._settled(np.array(start, dtype=np.int64)) if self.free else np.array(start, dtype=np.int64)

    @property
    def types(self) -> list[str]:
        """The type of each room; empty for a kind that we have none for."""
        return [self._names[at] if at < self._none else "" for at in self._types.tolist()]

    def ranked(self, room: int) -> list[str]:
        """Returns the types a room may have, best first, the others' types given."""
        return [self._names[at] for at in self._order(room, self._types)]

    def _order(self, room: int, types: Types) -> list[int]:
        others = types.copy()
        others[room] = self._none
        counts = self._counts(others[None, :])
        filled = counts + np.eye(self._none, dtype=np.int64)
        costs = self._steps(room, others[None, :])[0] + self._numbers.more(counts)[0] + self._numbers.missing(filled)
        order = np.argsort(np.round(costs, DIGITS), kind="stable")
        return [at for at in order.tolist() if self._alone[room][at] < NEVER]

    def _counts(self, homes: Types) -> Counts:
        """Returns how many rooms of each type each home has."""
        return np.stack([np.bincount(home, minlength=self._none + 1)[: self._none] for home in homes])

    def _steps(self, room: int, homes: Types) -> Costs:
        """Returns the cost of each type in a room of each home, by its form and what it is joined to."""
        found = np.repeat(self._alone[room][None, :], len(homes), axis=0)
        for there, is_open in self.marks[room].ways:
            past = 1 if self.marks[room].behind == there else 2 if self.marks[there].behind == room else 0
            found += self._joined[2 * past + is_open][homes[:, there]]
        return found

    def _settled(self, start: Types) -> Types:
        """Gives the free rooms types: the plainest first, the cheapest homes kept; then each alone until nothing changes."""
        homes, costs, counts = start[None, :], np.zeros(1), self._counts(start[None, :])
        for room in sorted(self.free, key=lambda k: (-self._margin(k), k)):
            steps = costs[:, None] + self._steps(room, homes) + self._numbers.more(counts)
            flat = np.round(steps, DIGITS).ravel()
            kept = np.argsort(flat, kind="stable")[:KEPT]
            rows, types = np.divmod(kept, self._none)
            homes, counts, costs = homes[rows].copy(), counts[rows].copy(), flat[kept]
            homes[:, room] = types
            counts[np.arange(len(kept)), types] += 1
        found: Types = homes[int(np.argmin(np.round(costs + self._numbers.missing(counts), DIGITS)))]
        for _ in range(SWEEPS):
            before = found.copy()
            for room in self.free:
                found[room] = self._order(room, found)[0]
            if (found == before).all():
                break
        return found

    def _margin(self, room: int) -> float:
        costs = np.sort(self._alone[room])
        return float(costs[1] - costs[0]) if len(costs) > 1 else 0.0


def _joined(suiting: Suiting) -> NDArray[np.float64]:
    """Returns what joining two types costs, by how, by the first's type or none, and the second's.

    How: by a door, by an opening without a leaf; then both where one comes to the second through the first, both where to the first
    through the second.
    """
    names: Sequence[str] = list(suiting.kinds)
    found = np.zeros((2, len(names) + 1, len(names)))
    past = np.zeros((len(names) + 1, len(names)))
    for a, one in enumerate(names):
        past[a] = [suiting.past(one, other) for other in names]
        for b, other in enumerate(names[: a + 1]):
            for is_open in (0, 1):
                found[is_open, a, b] = found[is_open, b, a] = suiting.joined(one, other, bool(is_open))
    back = np.zeros_like(past)
    back[:-1] = past[:-1].T
    return np.concatenate([found, found + past, found + back])
