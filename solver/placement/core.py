"""The compiled kernel behind one room: what is asked of it, and its answers as plain data.

Here end the arrays.
"""

import math
from collections.abc import Sequence
from dataclasses import astuple, dataclass
from functools import cached_property

import numpy as np

from solver.geometry import Rect
from solver.pieces import Candidate
from solver.placement import kernel, layout
from solver.placement.budget import Budget
from solver.placement.encode import Encoded
from solver.placement.layout import BEST, CLOSED, DEEPEST, Engine, Ints
from solver.placement.made_rooms import SolvedRoom, answer_at, solved_room
from solver.placement.problem import Choice, DifferenceRow, ProblemBox


@dataclass(frozen=True)
class Limits:
    """How much each step may try; counts, never times.

    Args:
        required: evaluations (searches of placements) on the required pieces before the dive, and as many after it.
        required_qps: QPs of each.
        optional: evaluations on one optional piece.
        optional_qps: QPs of each.
        optional_lapses: of these evaluations, how many may end at their limit before the piece is given up.
        moves: evaluations in a room on moving one other piece so that an optional one fits.
        final_qps: QPs of the final search over all choices of a room.
    """

    required: int = 3000
    required_qps: int = 2000
    optional: int = 16
    optional_qps: int = 50
    optional_lapses: int = 2
    moves: int = 8
    final_qps: int = 24_000

    @cached_property
    def row(self) -> Ints:
        """As the kernel takes them."""
        return np.array(astuple(self), dtype=np.int64)


class Core:
    """The kernel's work space of one room."""

    def __init__(self, encoded: Encoded) -> None:
        self.encoded = encoded
        self.engine: Engine = encoded.engine

    def stand_together(self, limits: Limits, budget: Budget, walk: bool) -> tuple[Ints | None, bool]:
        """Asks for all pieces at once, whatever is required: decisions of the best way, or None; and whether that answer is exact."""
        count, tree = len(self.encoded.pieces), self.engine.tree
        found = self._best_first(self.blank(), 0, limits, budget, walk)
        closed = bool(tree.counters[CLOSED])
        if not found:
            complete = tree.counters[DEEPEST] >= 0 and self._deepest() == count
            return (tree.decisions[tree.counters[DEEPEST]].copy(), False) if complete else (None, closed)
        return tree.decisions[tree.counters[BEST]].copy(), closed

    def joined(self, first: int, limits: Limits, budget: Budget) -> Ints | None:
        """Asks for all pieces from number `first` on, used and walked between, beside those before it, which have one way each.

        Returns decisions of the best way found for all to stand, or None.
        """
        start, tree = self.blank(), self.engine.tree
        for piece in range(first):
            grown = self.with_first(start, piece)
            if grown is None:
                return None
            start = grown
        found = self._best_first(start, first, limits, budget, True)
        complete = found or (tree.counters[DEEPEST] >= 0 and self._deepest() == len(start))
        decisions: Ints = tree.decisions[tree.counters[BEST if found else DEEPEST]]
        return decisions.copy() if complete else None

    def _best_first(self, start: Ints, first: int, limits: Limits, budget: Budget, walk: bool) -> bool:
        """Finds the cheapest way for the pieces from number `first` on to join decisions; what it found is left in `tree`."""
        call = self.engine.call
        call.decisions[:], call.group[:] = start, (first, len(start))
        call.limits[:] = limits.required, limits.required_qps, layout.MANY, 0
        return self._searched(budget, "best_first", walk)

    def _searched(self, budget: Budget, search: str, *given: float) -> bool:
        """Asks for a search within a budget, from which is taken what it costs; tells whether something was found."""
        tree = self.engine.tree
        tree.budget[0] = budget.left
        found = bool(self.engine.instance.call(search, self.engine.desk, *given))
        budget.left = float(tree.budget[0])
        return found

    def with_first(self, decisions: Ints, piece: int) -> Ints | None:
        """Returns decisions with a piece's first way beside them; None where it has none."""
        found, _ = kernel.open_decisions(self.engine, decisions, piece)
        if not len(found):
            return None
        grown = decisions.copy()
        grown[piece] = found[0]
        return grown

    def stands_walkable(self, decisions: Ints) -> bool:
        """Tells whether decided pieces that have one place each may stand there together, all within reach."""
        if not self.assemble(decisions):
            return False
        work = self.engine.work
        if work.counts[layout.N_CHOICES]:  # of two with one place each that lie apart nothing is left to choose
            return False
        return self.walkable_at([work.low[axis, : work.sizes[axis]].tolist() for axis in (0, 1)])

    def _deepest(self) -> int:
        """Returns how many pieces the deepest prefix of the last best-first search holds."""
        tree = self.engine.tree
        at = int(tree.counters[DEEPEST])
        return 0 if at < 0 else int((tree.decisions[at] != layout.ABSENT).sum())

    def blank(self) -> Ints:
        """Returns the decisions of an empty room."""
        return np.full(len(self.encoded.pieces), layout.ABSENT, dtype=np.int64)

    def first_decisions(self) -> Ints | None:
        """Returns every piece's cheapest candidate and sides beside the ones before it, or None where one has none."""
        decisions = self.blank()
        for piece in range(len(decisions)):
            found, costs = kernel.open_decisions(self.engine, decisions, piece)
            if not len(found):
                return None
            decisions[piece] = found[int(costs.round(9).argmin())]
        return decisions

    def preference(self, decisions: Ints) -> float:
        """Returns the preference cost of decisions together, or -1 where they rule each other out."""
        self.engine.call.decisions[:] = decisions
        return float(self.engine.instance.call("total_preference", self.engine.desk))

    def decided(self, decision: int) -> Candidate:
        """Returns the candidate that a decision means."""
        return self.encoded.tables.candidates[decision // 8]

    def sides_of(self, piece: int, decision: int) -> tuple[str, ...]:
        """Returns the use sides that a decision of a piece means, in a room that was laid out as it is."""
        return self.encoded.tables.side_names[int(self.engine.room.pieces[piece, layout.SIDES_0]) + decision % 8]

    def assemble(self, decisions: Ints) -> bool:
        """Lays out the problem of decisions; tells whether they can stand together."""
        return kernel.assemble(self.engine, decisions)

    def evaluate(self, decisions: Ints, limit: int, budget: Budget, walk: bool, ceiling: float = np.inf) -> bool:
        """Searches a placement of the decisions; it stays in the work space."""
        self.engine.call.decisions[:] = decisions
        return self._searched(budget, "evaluate", limit, ceiling, walk)

    def bodies(self, first: int = 0) -> list[Rect]:
        """Returns the footprints that the last search found, by piece from `first` on, all decided, rounded to millimetres."""
        own = self.engine.work.body_part[first : len(self.encoded.pieces)]
        xs, zs = ([math.floor(x * 1000 + 0.5) for x in axis.tolist()] for axis in self.engine.nodes.best)
        found = []
        for _, _, u, v, off_x, off_z, wide, deep, _, _ in self.engine.work.parts[own].tolist():
            x, z = xs[u] + off_x, zs[v] + off_z
            found.append(Rect(x, z, x + wide, z + deep))
        return found

    def walkable_at(self, p: Sequence[Sequence[int]]) -> bool:
        """Tells whether doors and use sides are joined with the assembled bodies at integer positions p[axis][variable], mm."""
        positions = self.engine.grid.positions
        for axis in (0, 1):
            positions[axis, : len(p[axis])] = p[axis]
        return kernel.walkable(self.engine)

    def pulled_back(self, places: Sequence[Rect]) -> float | None:
        """Brings the pieces of the assembled problem from their places back towards their wishes, as far as all holds.

        Returns what that costs; None where the pieces could not stand and be walked between there.
        """
        positions = self.engine.grid.positions
        for part, place in zip(self.engine.work.parts[self.engine.work.body_part[: len(places)]].tolist(), places, strict=True):
            _, _, x, z, off_x, off_z, *_ = part
            positions[0, x], positions[1, z] = place.x0 - off_x, place.z0 - off_z
        return float(self.engine.nodes.best_cost[0]) if self.engine.instance.call("pull_back", self.engine.desk) else None

    def boxes(self) -> list[ProblemBox]:
        """Returns the boxes of the assembled problem, for reading."""
        work, found = self.engine.work, []
        for row in work.parts[: work.counts[layout.N_PARTS]].tolist():
            piece, stand, x, z, off_x, off_z, ext_x, ext_z, low, high = row
            label = self.encoded.pieces[piece].label
            found.append(ProblemBox(label, bool(stand), (x, z), (off_x, off_z), (ext_x, ext_z), low, high))
        return found

    def choices(self, boxes: Sequence[ProblemBox]) -> list[Choice]:
        """Returns its choices, for reading."""
        work, found = self.engine.work, []
        count = int(work.counts[layout.N_CHOICES])
        options = work.options[: 4 * count].tolist()
        both = zip(work.choice_parts[:count].tolist(), work.choice_size[:count].tolist(), strict=True)
        for c, ((first, second), size) in enumerate(both):
            name = boxes[second].label if second >= 0 else self.encoded.space.zones[-1 - second].cause
            ways, stands = tuple([DifferenceRow(*row) for row in options[4 * c : 4 * c + size]]), second >= 0 and boxes[second].stand
            found.append(Choice(boxes[first].label, name, ways, (boxes[first].stand, stands)))
        return found

    def told(self, walk: bool = False) -> SolvedRoom:
        """Returns what the last search found, on whole millimetres; `walk`: only walkable placements were looked for, else it is tested."""
        instance, room = self.engine.instance, self.encoded.space
        mark = instance.mark()
        answer = answer_at(instance, int(instance.call("tell_room", self.engine.desk, walk)), room.room)
        instance.release(mark)
        return solved_room(room, answer, self.encoded.tables)
