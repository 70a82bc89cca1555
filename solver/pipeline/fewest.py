"""Which pieces to leave out of a room in which no place was found for all: a few of those in the way, the least important that help.

Not here: why they cannot stand (conflicts).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from solver.pieces import Arrangement, Piece, Space
from solver.pipeline.least_movement import least_moved
from solver.placement import Budget, can_be_used, in_the_way, is_call_spent

WORK_SHARE = 4
"""Of what an attempt at the whole room may cost a trial may cost this part."""


def without_fewest(space: Space, pieces: Sequence[Piece], work: float) -> Arrangement | None:
    """Returns an arrangement, walkable, of all pieces but a few in the way; None where leaving out all that may be moved does not do.

    Of those in the way, the least important first, as many go as it takes; less those before the last of them that need not go. `work` is
    what one attempt at the whole room may cost, in QPs of a small room.
    """
    blamed = in_the_way(space, pieces)
    order = tuple(piece.label for piece in reversed(pieces) if piece.label in blamed)
    return _Trials(space, pieces, work / WORK_SHARE).answer(order) if order else None


class _Trials:
    """Sets of pieces to leave out, each tried once. Where one does not help, none of its parts is taken to help."""

    def __init__(self, space: Space, pieces: Sequence[Piece], work: float) -> None:
        self.space, self.pieces, self.work = space, pieces, work
        self._helps: dict[tuple[str, ...], bool] = {}

    def answer(self, order: tuple[str, ...]) -> Arrangement | None:
        """Leaves out a few of these and moves the others least; a set with which that does not succeed counts as no help.

        Without the least important one the others are looked for thoroughly: most rooms need no more, and it often finds a place again.
        """
        if answer := self._placed_without(order[:1]):
            return answer
        self._helps[order[:1]] = False
        while (gone := self._few(order)) is not None:
            if answer := self._placed_without(gone):
                return answer
            self._helps[gone] = False
        return None

    def _few(self, order: tuple[str, ...]) -> tuple[str, ...] | None:
        """Returns a run of these that helps: it ends as early as can be, then begins as late as can be."""
        if not self._without(order):
            return None
        last = _least(1, len(order), lambda count: self._without(order[:count]))
        count = _least(0, last, lambda count: self._without(order[last - count : last]))
        return order[last - count : last]

    def _without(self, labels: tuple[str, ...]) -> bool:
        """Tells whether all others can be used without these."""
        if labels not in self._helps:
            self._helps[labels] = not is_call_spent() and can_be_used(self.space, self._others(labels), Budget(self.work))
        return self._helps[labels]

    def _others(self, labels: tuple[str, ...]) -> list[Piece]:
        gone = _with_carried(self.pieces, labels)
        return [piece for piece in self.pieces if piece.label not in gone]

    def _placed_without(self, labels: tuple[str, ...]) -> Arrangement | None:
        """Places all but these, and what stands only with them, with least movement; None where that finds no place for all."""
        others = self._others(labels)
        answer = least_moved(self.space, others, Budget(self.work))
        there = {piece.label for piece in others}
        left_out = tuple((piece.label, "no place was found for it beside the others") for piece in self.pieces if piece.label not in there)
        return replace(answer, left_out=left_out, proven=False, best=False) if is_whole(answer) else None


def _least(low: int, high: int, helps: Callable[[int], bool]) -> int:
    """Returns the least number above `low`, which does not help, that does, if `high` helps and helping is monotone."""
    while high - low > 1:
        middle = min(max(2 * low, 1), (low + high) // 2)
        low, high = (low, middle) if helps(middle) else (middle, high)
    return high


def is_whole(answer: Arrangement) -> bool:
    """Tells whether all stand and can be used."""
    return not answer.left_out and not answer.notes


def _with_carried(pieces: Sequence[Piece], gone: Sequence[str]) -> set[str]:
    """Returns who goes, with all that stands only with one of them."""
    found = set(gone)
    for piece in pieces:  # what is carried comes after what carries it
        parents = {way.attach.parent if way.attach else None for way in piece.candidates}
        if parents <= found:
            found.add(piece.label)
    return found
