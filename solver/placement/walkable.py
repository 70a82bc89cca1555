"""Whether pieces can stand so that the room is walkable, proven either way: every candidate, and for each the kernel's proof.

Not here: least movement.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from solver.geometry import Rect
from solver.pieces import Candidate, Piece, Space
from solver.placement import kernel, layout
from solver.placement.budget import Budget
from solver.placement.encode import lay_out
from solver.placement.layout import IMPOSSIBLE, POSSIBLE, UNKNOWN

WORK = 9000
"""Work of one proof over all candidates together: nodes times pieces."""
QUICK_WORK = 500
"""The same where "no" is worth little."""
PREFIX_NODES = 200
"""Nodes spent on some of the pieces before others join."""
MOST_DEPTH = 1024
"""Nodes open at a time."""


@dataclass(frozen=True)
class WalkablePlace:
    """Where a piece can be used together with the others: its candidate, the use sides reached, its footprint."""

    piece: Piece
    candidate: Candidate
    sides: tuple[str, ...]
    footprint: Rect

    @property
    def free(self) -> Piece:
        """The piece with this candidate alone, wherever it may stand so."""
        return replace(self.piece, candidates=(self.candidate,))

    def near(self, reach_mm: int, clear: Rect) -> Piece:
        """Returns the piece kept to its candidate and within reach of where it was found, in the clear rectangle."""
        only = replace(self.candidate, within=self.footprint.shrunk(-reach_mm).common(self.candidate.within or clear))
        stands = tuple(stand for stand in self.piece.stands if stand.side in self.sides)
        return replace(self.piece, candidates=(only,), stands=stands, need_all=True)


def find_walkable(
    space: Space, pieces: Sequence[Piece], budget: Budget, prove: bool = True
) -> tuple[bool | None, tuple[WalkablePlace, ...]]:
    """Tells whether pieces can all stand so that all doors and use sides are joined.

    Args:
        space: the room's.
        pieces: all of them are asked for, required or not.
        budget: the work it may cost.
        prove: whether "no" must be certain, and is worth much work; else it is said of the free centres that the search asks for.

    Returns:
        False where that is proven for whole millimetres; True, with where they can, in the pieces' order; else None.
    """
    size = max(len(pieces), 1)
    most = int(min(WORK if prove else QUICK_WORK, budget.left)) // size
    if most <= 0:
        return None, ()
    proof = _Proof(space, pieces, most)
    verdict = proof.join(0)
    found = proof.found() if verdict == POSSIBLE else ()
    budget.left -= (most - proof.left) * size
    return {IMPOSSIBLE: False, POSSIBLE: True}.get(verdict), found


class _Proof:
    """The work space of one proof."""

    def __init__(self, space: Space, pieces: Sequence[Piece], most: int) -> None:
        self.pieces, self.left = pieces, most
        self.tables, request = lay_out(space, pieces, "stands")
        self.engine = kernel.new_engine(request)
        self.nodes = kernel.new_proof(self.engine, MOST_DEPTH)
        self.decisions = np.full(len(pieces), layout.ABSENT, dtype=np.int64)

    def join(self, piece: int) -> int:
        """Returns the verdict on the pieces from number `piece` on beside those decided before it."""
        if piece == len(self.pieces):
            return self._verdict(self.left)
        verdict = IMPOSSIBLE
        decisions = self._ways(piece)
        for decision in decisions:
            self.decisions[piece] = decision
            hopeless = len(decisions) > 1 and piece + 1 < len(self.pieces) and self._verdict(min(PREFIX_NODES, self.left)) == IMPOSSIBLE
            own = IMPOSSIBLE if hopeless else self.join(piece + 1)
            if own == POSSIBLE:
                return POSSIBLE
            if own == UNKNOWN:
                verdict = UNKNOWN
            if self.left <= 0:
                verdict = UNKNOWN
                break
        self.decisions[piece] = layout.ABSENT
        return verdict

    def _ways(self, piece: int) -> list[int]:
        """Returns a piece's decisions, of those that differ only in their anchor or cost the first."""
        first: dict[tuple[int, int], int] = {}
        for decision in kernel.open_decisions(self.engine, self.decisions, piece)[0].tolist():
            first.setdefault((int(self.engine.room.candidates[decision // 8, layout.KIN]), decision % 8), decision)
        return list(first.values())

    def _verdict(self, most: int) -> int:
        self.left -= 1
        if not kernel.assemble(self.engine, self.decisions):
            return IMPOSSIBLE
        verdict, spent = kernel.prove(self.engine, self.nodes, most)
        self.left -= spent
        return verdict

    def found(self) -> tuple[WalkablePlace, ...]:
        """Returns where the pieces are once they were found walkable."""
        found, work, positions = [], self.engine.work, self.engine.grid.positions
        for k, piece in enumerate(self.pieces):
            part, decision = work.parts[work.body_part[k]], int(self.decisions[k])
            x, z = (int(positions[a, part[layout.VAR_X + a]] + part[layout.OFF_X + a]) for a in (0, 1))
            rect = Rect(x, z, x + int(part[layout.EXT_X]), z + int(part[layout.EXT_X + 1]))
            side = int(self.engine.room.pieces[k, layout.SIDES_0]) + decision % 8
            found.append(WalkablePlace(piece, self.tables.candidates[decision // 8], self.tables.side_names[side], rect))
        return tuple(found)
