"""How likely a home has so many rooms of each type: a cost, lower is better."""

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from catalogs import Catalogs
from catalogs.entries import Mark, OfType
from solver.guessing.suiting import UNSAID

Costs = NDArray[np.float64]
Counts = NDArray[np.int64]
Flags = NDArray[np.bool_]
ONE_MORE: Final[tuple[Mark, Mark]] = ("again", "first")
SEVERAL: Final = 3
"""A home of so many rooms indoors has what is wanted."""
UNCOUNTED: Final = "hallway"
"""The word of a programme that nobody counts."""


class RoomNumbers:
    """Costs of how many rooms there are of each type, in the catalogs' order, in a home with so many indoors.

    `program` says how many rooms of each word there are, where that is known; the types of a word count as one.
    """

    def __init__(self, catalogs: Catalogs, indoors: int, program: Mapping[str, int] | None) -> None:
        self._is_several = indoors >= SEVERAL
        self._kinds, self._told = catalogs.rooms, catalogs.guessing
        self._names, usual = list(self._kinds), self._of_types("usual")
        self._usual = np.array([1 + (int(indoors // usual[name]) if name in usual else 0) for name in self._names])
        self._one_more, self._rare = (np.array([self._of_types(mark).get(name, 0.0) for name in self._names]) for mark in ONE_MORE)
        homes = [kind.home for kind in self._kinds.values()]
        self._word_of = [(home.word if home else None) or name for name, home in zip(self._names, homes, strict=True)]
        self._first = np.array([bool(home and home.once) for home in homes])
        self._turn = np.array([home.turn if home else 0 for home in homes])
        self._program: Counts | None = None
        if program is not None:
            words = sorted({*self._word_of, *program} - {UNCOUNTED})
            self._program = np.array([program.get(word, 0) for word in words])
            self._words = np.array([[word == own for word in words] for own in self._word_of], dtype=np.int64)

    def _of_types(self, mark: Mark) -> OfType:
        return self._told.get(mark, UNSAID).types

    def _cost(self, mark: Mark) -> float:
        return self._told.get(mark, UNSAID).cost

    def more(self, counts: Counts) -> Costs:
        """Returns the cost of one more room of each type in homes of so many rooms; a row a home."""
        if self._program is None:
            return np.where(counts >= self._usual, self._one_more, 0.0) + np.where(counts == 0, self._rare, 0.0)
        wrong = self._cost("miscounted")
        wants = np.where(counts @ self._words < self._program, -wrong, wrong)
        return np.asarray(wants @ self._words.T, dtype=np.float64)

    def missing(self, counts: Counts) -> Costs:
        """Returns the cost of what whole homes lack, one each."""
        found = np.zeros(len(counts))
        if self._program is not None or not self._is_several:
            return found
        for name, cost in self._of_types("missing").items():
            found += np.where(counts[:, self._alike(self._word_of[self._names.index(name)])].sum(axis=1) == 0, cost, 0.0)
        for word in sorted({word for word, first in zip(self._word_of, self._first, strict=True) if first}):
            found += self._out_of_turn(counts, self._alike(word))
        return found

    def _alike(self, word: str) -> Flags:
        return np.array([one == word for one in self._word_of])

    def _out_of_turn(self, counts: Counts, alike: Flags) -> Costs:
        """Returns the cost of rooms of one word whose first is not the one that comes first, or that are all of the last turn."""
        every = counts[:, alike].sum(axis=1)
        first, last = (counts[:, alike & turn].sum(axis=1) for turn in (self._first, self._turn == self._turn[alike].max()))
        lacking = np.where((every > 1) & (first == 0), self._cost("no_first"), 0.0)
        return lacking + np.where((last > 0) & (last == every), self._cost("later_alone"), 0.0)
