"""Which pieces to leave out of a room in which no place was found for all: one, the least important that helps; else the fewest in the way.

Comes in: a space, pieces, the work each trial may cost. Goes out: an Arrangement of the others, those left out named in it. May import:
every stage. Not here: why they cannot stand (conflicts).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from solver.pieces import Arrangement, Piece, Space
from solver.pipeline.least_movement import least_moved
from solver.placement import Budget, in_the_way

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
    for gone in _trials(space, pieces):
        rest = [piece for piece in pieces if piece.label not in gone]
        answer = least_moved(space, rest, Budget(work / WORK_SHARE))
        if is_whole(answer):
            left_out = tuple((piece.label, "no place was found for it beside the others") for piece in pieces if piece.label in gone)
            return replace(answer, left_out=left_out, proven=False, best=False)
    return None


def is_whole(answer: Arrangement) -> bool:
    """Tells whether all stand and can be used."""
    return not answer.left_out and not answer.notes


def _trials(space: Space, pieces: Sequence[Piece]) -> Iterator[set[str]]:
    """Yields who goes: each of those in the way alone, the least important first; then the others; then more and more of them."""
    blamed = in_the_way(space, pieces)
    order = [piece.label for piece in reversed(pieces)]
    alone = sorted((label for label in order if label in blamed), key=order.index)
    for label in alone[:MOST_ALONE]:
        yield _with_carried(pieces, {label})
    for k in range(2, len(alone) + 1):
        yield _with_carried(pieces, alone[:k])


def _with_carried(pieces: Sequence[Piece], gone: Collection[str]) -> set[str]:
    """Returns who goes, with all that stands only with one of them."""
    found = set(gone)
    for piece in pieces:  # what is carried comes after what carries it
        parents = {way.attach.parent if way.attach else None for way in piece.candidates}
        if parents <= found:
            found.add(piece.label)
    return found
