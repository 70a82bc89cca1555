"""The search for a home: a kind drawn by the seed, some deals, some moves, always by counts.

Comes in: wishes, a frame, a seed. Goes out: `Found`: the cheapest drawing. May import: the ground floor.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
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
GOOD_EACH: Final = 0.2
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

    @property
    def rank(self) -> tuple[int, int, float]:
        """What is better among homes that are not sound: all rooms entered, few short, cheap."""
        return self.verdict.unreached, self.verdict.short, self.verdict.cost


class _Seen(NamedTuple):
    cost: float
    draft: Draft
    sheet: Sheet | None
    verdict: Verdict | None


class Search:
    """Searches for homes of one programme.

    Args:
        wishes: the rooms.
        frame_of: the frame of a house of a kind.
        seed: the house's seed.
        turn: which search of the seed's it is.
    """

    def __init__(self, wishes: Sequence[Wish], frame_of: Callable[[str], Frame], seed: int, turn: int = 0) -> None:
        self.wishes, self.seed, self.turn = wishes, seed, turn
        self.judge = Judge(wishes)
        self.drawers = {kind: Drawer(self.judge.sizes, frame_of(kind)) for kind in kinds_for(wishes)}
        self.good = GOOD + GOOD_EACH * len(wishes)
        self.judged = 0

    def run(self) -> Found:
        """Searches in the kind that the seed draws; in the others too where a room falls short in it."""
        kinds = list(kinds_for(self.wishes))
        if kinds[0] != "rows":
            Stream(self.seed, "programme.kind").shuffle(kinds)
        best: _Seen | None = None
        for kind in dict.fromkeys(kinds):
            seen = self._kind(kind)
            if best is None or seen.cost < best.cost:
                best = seen
            if seen.verdict is not None and not (seen.verdict.short or seen.verdict.unreached):
                break
        return self._found(best)

    def _found(self, best: _Seen | None) -> Found:
        if best is None:
            raise ValueError("a programme without a kind")
        if best.sheet is not None and best.verdict is not None:
            return Found(best.draft.kind, best.sheet, best.verdict)
        sheet = self.drawers[best.draft.kind].sheet(best.draft, stretch=True)
        if isinstance(sheet, Misfit):
            raise ValueError("a draft without depths")
        return Found(best.draft.kind, sheet, self.judge.verdict(sheet))

    def _kind(self, kind: str) -> _Seen:
        best: _Seen | None = None
        for number in range(TRIES):
            stream = Stream(self.seed, "programme", f"{kind}.{self.turn}.{number}")
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
        best = self._dealt(kind, dealer)
        for _ in range(DEALS - 1):
            if best.cost <= self.good:
                return best
            seen = self._dealt(kind, dealer)
            if seen.cost < best.cost:
                best = seen
        for _ in range(MOVES):
            if best.cost <= self.good:
                return best
            draft = moved(best.draft, stream)
            self.drawers[kind].settle(draft)
            seen = self._look(draft)
            if seen.cost <= best.cost:
                best = seen
        return best

    def _dealt(self, kind: str, dealer: Dealer) -> _Seen:
        draft = dealer.deal(kind)
        self.drawers[kind].choose(draft, dealer.stream)
        return self._look(draft)

    def _look(self, draft: Draft) -> _Seen:
        self.judged += 1
        sheet = self.drawers[draft.kind].sheet(draft)
        if isinstance(sheet, Misfit):
            return _Seen(MISFIT + MISFIT_COLUMN * sheet.columns + sheet.gap / MISFIT_MM, draft, None, None)
        verdict = self.judge.verdict(sheet)
        return _Seen(verdict.cost, draft, sheet, verdict)
