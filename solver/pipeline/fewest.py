"""Which pieces to leave out of a room in which no place was found for all: one, the least important that helps; else the fewest in the way.

Comes in: a space, pieces, the work each trial may cost. Goes out: an Arrangement of the others, those left out named in it. May import:
every stage. Not here: why they cannot stand (conflicts).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from solver.pieces import Arrangement, Piece, Space
from solver.pipeline.least_movement import least_moved
from solver.placement import Budget, in_the_way, is_call_spent

MOST_ALONE = 6
"""Pieces that are left out alone, at most, before several are."""
WORK_SHARE = 4
"""Of what an attempt at the whole room may cost a trial may cost this part."""


def without_fewest(space: Space, pieces: Sequence[Piece], work: float) -> Arrangement | None:
    """Returns an arrangement, walkable, of all pieces but the fewest found; None where leaving out what may be moved does not do.

    Args:
        space: the room's.
        pieces: the most important first.
        work: what one attempt at the whole room may cost, in QPs of a small room.
    """
    blamed = in_the_way(space, pieces)
    order = tuple(piece.label for piece in reversed(pieces) if piece.label in blamed)
    return _Trials(space, pieces, work / WORK_SHARE).fewest(order) if order else None


class _Trials:
    """Attempts without some pieces. Where none is found, none is taken to be found with one of those left out beside the others."""

    def __init__(self, space: Space, pieces: Sequence[Piece], work: float) -> None:
        self.space, self.pieces, self.work = space, pieces, work
        self._tried: dict[tuple[str, ...], Arrangement | None] = {}

    def fewest(self, order: tuple[str, ...]) -> Arrangement | None:
        """Leaves out one of a few, else as few as do from the first on."""
        if (first := self._without(order[:1])) or self._without(order) is None:
            return first
        low, high = 1, len(order)
        while high - low > 1:
            middle = min(2 * low, (low + high) // 2)
            low, high = (low, middle) if self._without(order[:middle]) else (middle, high)
        others = order[low:MOST_ALONE]  # without those before them all together no place was found
        return (self._one(others) if others else None) or self._without(order[:high])

    def _one(self, order: tuple[str, ...]) -> Arrangement | None:
        """Leaves out one, the first that helps: sought by halves."""
        answer = self._without(order)
        if answer is None or len(order) == 1:
            return answer
        half = len(order) // 2
        return self._one(order[:half]) or self._one(order[half:])

    def _without(self, labels: tuple[str, ...]) -> Arrangement | None:
        if labels not in self._tried:
            self._tried[labels] = None if is_call_spent() else self._attempt(_with_carried(self.pieces, labels))
        return self._tried[labels]

    def _attempt(self, gone: Collection[str]) -> Arrangement | None:
        answer = least_moved(self.space, [piece for piece in self.pieces if piece.label not in gone], Budget(self.work))
        left_out = tuple((piece.label, "no place was found for it beside the others") for piece in self.pieces if piece.label in gone)
        return replace(answer, left_out=left_out, proven=False, best=False) if is_whole(answer) else None


def is_whole(answer: Arrangement) -> bool:
    """Tells whether all stand and can be used."""
    return not answer.left_out and not answer.notes


def _with_carried(pieces: Sequence[Piece], gone: Collection[str]) -> set[str]:
    """Returns who goes, with all that stands only with one of them."""
    found = set(gone)
    for piece in pieces:  # what is carried comes after what carries it
        parents = {way.attach.parent if way.attach else None for way in piece.candidates}
        if parents <= found:
            found.add(piece.label)
    return found
