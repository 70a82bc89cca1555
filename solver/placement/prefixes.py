"""Best-first search over prefixes of the pieces that must stand.

Pieces come in order of importance; a child's bound is its parent's exact cost plus the way's own cost (every term is
>= 0), so the first complete prefix popped is the best.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence

from solver.placement.assemble import Chosen
from solver.placement.states import Budget, State, extend, kin, options
from solver.wanted import Wanted


class BestFirst:
    """One search; goes on deepest-first once its limit is spent.

    `closed` stays True while the answer, best or impossible, is exact.

    Args:
        start: the state to grow.
        pieces: what is to stand, most important first.
        limit: searches of placements before the order changes, and as many after.
        budget: the work it may cost.
        walk: whether a state counts only if it is walkable.
    """

    def __init__(self, start: State, pieces: Sequence[Wanted], limit: int, budget: Budget, walk: bool = False) -> None:
        self.pieces, self.limit, self.budget, self.walk = pieces, limit, budget, walk
        self.order = 0
        self.heap: list[tuple[int, float, int, int, State, tuple[float, Chosen] | None]] = []
        self.deepest = (0, start)
        self.solves = 0
        self.evaluations = 0
        self.closed = True
        self.diving = False
        self.refused: set[tuple[object, ...]] = set()
        self._push(start.cost, 0, start, None)

    def _push(self, bound: float, depth: int, state: State, entry: tuple[float, Chosen] | None) -> None:
        rank = -depth if self.diving else 0
        heapq.heappush(self.heap, (rank, round(bound, 9), self.order, depth, state, entry))
        self.order += 1

    def _dive(self) -> None:
        """Goes on from the deepest prefixes, for as many searches again."""
        self.diving, self.closed = True, False
        self.limit *= 2
        self.heap = [(-depth, bound, order, depth, *rest) for _, bound, order, depth, *rest in self.heap]  # type: ignore[misc]
        heapq.heapify(self.heap)

    def run(self) -> State | None:
        """Returns the best complete state, or None (see `deepest` and `closed`)."""
        while self.heap:
            _, _, _, depth, state, entry = heapq.heappop(self.heap)
            if entry is not None:
                self._evaluate(depth, state, entry)
            elif depth == len(self.pieces):
                return state
            else:
                for cost, c in options(state.assembly, self.pieces[depth]):
                    self._push(state.cost + cost, depth, state, (cost, c))
            if self.budget.spent:
                self.closed = False
                return None
            if self.evaluations >= self.limit:
                if self.diving:
                    return None
                self._dive()
        return None

    def _evaluate(self, depth: int, state: State, entry: tuple[float, Chosen]) -> None:
        c = entry[1]
        key = (*(kin(earlier) for earlier in state.assembly.chosen), kin(c))
        if key in self.refused:
            return
        self.evaluations += 1
        grown, outcome = extend(state, entry, self.walk, self.budget)
        self.solves += outcome.solves if outcome else 0
        if grown is None:
            if outcome is None or not outcome.turned_down:
                self.refused.add(key)
            self.closed &= outcome is None or outcome.proven
            return
        if depth + 1 > self.deepest[0]:
            self.deepest = (depth + 1, grown)
        self._push(grown.cost, depth + 1, grown, None)
