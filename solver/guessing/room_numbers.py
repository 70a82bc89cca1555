"""How likely a home has so many rooms of each type: a cost, lower is better.

Comes in: counts of rooms by type, of many homes at once. Goes out: what one more room costs, and what is still missing. The weights are
our choice.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from catalogs.schema import RoomType

Costs = NDArray[np.float64]
Counts = NDArray[np.int64]
BEDROOMS: Final = ("bedroom", "bedroom_master", "kids_bedroom")
WANTED: Final = {"kitchen": 6.0, "bathroom": 6.0, "living_room": 3.5, "bedroom": 5.0}
"""Cost of a home of several rooms without the type; any bedroom will do."""
ONE_MORE: Final = {
    "kitchen": 6.0, "bathroom": 1.2, "living_room": 3.0, "dining_room": 4.0, "office": 1.5, "laundry": 3.0, "foyer": 3.0, "hallway": 0.7,
    "bedroom_master": 4.0, "kids_bedroom": 0.6, "bedroom": 0.4,
}  # fmt: skip
"""Cost of each more of a type than there are usually."""
RARE: Final = {"office": 1.2, "laundry": 1.2, "workshop": 4.0, "garage": 1.0, "foyer": 0.3, "kids_bedroom": 0.2}
"""Cost of the first of a type that many homes do without."""
NO_MASTER: Final = 1.0
"""Cost of several bedrooms without a master's."""
CHILDREN_ALONE: Final = 3.0
"""Cost of bedrooms that are all children's."""
SEVERAL: Final = 3
"""A home of so many rooms indoors has what is wanted."""
MISCOUNTED: Final = 4.0
"""Cost of each room more or less than a programme counts."""
UNCOUNTED: Final = "hallway"
"""The word of a programme that nobody counts."""


class RoomNumbers:
    """Costs of how many rooms there are of each type.

    Args:
        kinds: the room types, in the order in which counts have them.
        indoors: rooms of the home that lie indoors.
        program: how many rooms of each word there are, where that is known; bedrooms count as one.
    """

    def __init__(self, kinds: Mapping[str, RoomType], indoors: int, program: Mapping[str, int] | None) -> None:
        self._names = list(kinds)
        self._is_several = indoors >= SEVERAL
        usual = {"bathroom": 1 + indoors // 6, "bedroom": 1 + indoors // 6}
        self._usual = np.array([usual.get(name, 1) for name in kinds])
        self._one_more, self._rare = (np.array([costs.get(name, 0.0) for name in kinds]) for costs in (ONE_MORE, RARE))
        self._program: Counts | None = None
        if program is not None:
            word_of = [(kind.home.word or name) if kind.home else name for name, kind in kinds.items()]
            words = sorted({*word_of, *program} - {UNCOUNTED})
            self._program = np.array([program.get(word, 0) for word in words])
            self._words = np.array([[word == own for word in words] for own in word_of], dtype=np.int64)

    def _columns_of(self, names: Sequence[str]) -> list[int]:
        return [self._names.index(name) for name in names if name in self._names]

    def more(self, counts: Counts) -> Costs:
        """Returns the cost of one more room of each type in homes of so many rooms.

        Args:
            counts: homes by types.
        """
        if self._program is None:
            return np.where(counts >= self._usual, self._one_more, 0.0) + np.where(counts == 0, self._rare, 0.0)
        wants = np.where(counts @ self._words < self._program, -MISCOUNTED, MISCOUNTED)
        return np.asarray(wants @ self._words.T, dtype=np.float64)

    def missing(self, counts: Counts) -> Costs:
        """Returns the cost of what whole homes lack, one each.

        Args:
            counts: homes by types.
        """
        found = np.zeros(len(counts))
        if self._program is not None or not self._is_several:
            return found
        beds = counts[:, self._columns_of(BEDROOMS)].sum(axis=1)
        for name, cost in WANTED.items():
            there = beds if name == "bedroom" else counts[:, self._columns_of([name])].sum(axis=1)
            found += np.where(there == 0, cost, 0.0)
        masters, children = (counts[:, self._columns_of([name])].sum(axis=1) for name in ("bedroom_master", "kids_bedroom"))
        found += np.where((beds > 1) & (masters == 0), NO_MASTER, 0.0)
        found += np.where((children > 0) & (beds == children), CHILDREN_ALONE, 0.0)
        return found
