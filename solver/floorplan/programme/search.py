"""The search for a home: a kind drawn by the seed, some deals, some moves, always by counts.

Comes in: wishes, a frame, a seed. Goes out: `Found`: the cheapest drawing. May import: the ground floor.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple

from solver.floorplan.programme.cost import Judge, Verdict
from solver.floorplan.programme.deal import Dealer, kinds_for, moved
from solver.floorplan.programme.drafts import Draft, Drawer, Frame, Misfit, Sheet
from solver.floorplan.programme.wishes import Wish
from solver.streams import Stream

TRIES: Final = 3
DEALS: Final = 12
MOVES: Final = 48
"""How often it is begun anew, and the deals and moves of each time (floorplan.md)."""
GOOD: Final = 1.2
GOOD_EACH: Final = 0.16
"""A home that costs no more than this, and this for every room, is taken at once: searching on makes all homes alike."""
MISFIT: Final = 1000.0
"""Cost of a draft that cannot be drawn, and MISFIT_COLUMN for each column without a width, 1 for every MISFIT_MM."""
MISFIT_COLUMN: Final = 100.0
MISFIT_MM: Final = 50.0


class Found(NamedTuple):
    """The cheapest home: its kind, drawing and verdict."""

    kind: str
    sheet: Sheet
    verdict: Verdict


class _Seen(NamedTuple):
    cost: float
    draft: Draft
    sheet: Sheet | None
    verdict: Verdict | None


class Search:
    """Searches for homes of one programme in one frame."""

    def __init__(self, wishes: Sequence[Wish], frame: Frame, seed: int) -> None:
        self.wishes, self.seed = wishes, seed
        self.judge = Judge(wishes)
        self.drawer = Drawer(self.judge.sizes, frame)
        self.good = GOOD + GOOD_EACH * len(wishes)
        self.judged = 0

    def run(self) -> Found:
        """Searches in the kind that the seed draws; in the others too where a room falls short in it."""
        kinds = list(kinds_for(self.wishes))
        Stream(self.seed, "programme.kind").shuffle(kinds)
        best: _Seen | None = None
        for kind in kinds:
            seen = self._kind(kind)
            if best is None or seen.cost < best.cost:
                best = seen
            if seen.verdict is not None and not seen.verdict.short:
                break
        return self._found(best)

    def _found(self, best: _Seen | None) -> Found:
        if best is None:
            raise ValueError("a programme without a kind")
        if best.sheet is not None and best.verdict is not None:
            return Found(best.draft.kind, best.sheet, best.verdict)
        sheet = self.drawer.sheet(best.draft, stretch=True)
        if isinstance(sheet, Misfit):
            raise ValueError("a draft without depths")
        return Found(best.draft.kind, sheet, self.judge.verdict(sheet))

    def _kind(self, kind: str) -> _Seen:
        best: _Seen | None = None
        for number in range(TRIES):
            stream = Stream(self.seed, "programme", f"{kind}.{number}")
            seen = self._try(kind, stream)
            if best is None or seen.cost < best.cost:
                best = seen
            if best.cost <= self.good:
                break
        if best is None:
            raise ValueError("no tries")
        return best

    def _try(self, kind: str, stream: Stream) -> _Seen:
        dealer = Dealer(self.wishes, stream)
        best = self._look(dealer.deal(kind))
        for _ in range(DEALS - 1):
            if best.cost <= self.good:
                return best
            seen = self._look(dealer.deal(kind))
            if seen.cost < best.cost:
                best = seen
        for _ in range(MOVES):
            if best.cost <= self.good:
                return best
            seen = self._look(moved(best.draft, stream))
            if seen.cost <= best.cost:
                best = seen
        return best

    def _look(self, draft: Draft) -> _Seen:
        self.judged += 1
        self.drawer.settle(draft)
        sheet = self.drawer.sheet(draft)
        if isinstance(sheet, Misfit):
            return _Seen(MISFIT + MISFIT_COLUMN * sheet.columns + sheet.gap / MISFIT_MM, draft, None, None)
        verdict = self.judge.verdict(sheet)
        return _Seen(verdict.cost, draft, sheet, verdict)
