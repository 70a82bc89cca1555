"""The search for a home: a kind drawn by the seed, some deals, some moves, always by counts.

Comes in: planned rooms, a frame, a seed. Goes out: `FoundHome`: the cheapest drawing. May import: the ground floor.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from math import inf
from typing import Final, NamedTuple

from solver.fields import RECTANGLE
from solver.floorplan.programme.home_search import TRIES, Frame, HomeVerdict, bent_kind, kinds_for
from solver.floorplan.programme.planned_rooms import PlannedRoom
from solver.streams import Stream
from tests.floorplan.reference.bent_deal import BentDealer
from tests.floorplan.reference.bent_drafts import BentDrawer
from tests.floorplan.reference.cost import BENT_OUTLINE, HomeJudge
from tests.floorplan.reference.deal import Dealer, moved
from tests.floorplan.reference.drafts import Draft, Drawer, Misfit, Sheet

DEALS: Final = 12
MOVES: Final = 48
"""How many deals and moves there are each time that it is begun anew."""
GOOD: Final = 1.2
GOOD_EACH: Final = 0.2
"""A home that costs no more than this, and this for every room, is taken at once: searching on makes all homes alike."""
MISFIT: Final = 1000.0
"""Cost of a draft that cannot be drawn, and MISFIT_COLUMN for each column without a width, 1 for every MISFIT_MM."""
MISFIT_COLUMN: Final = 100.0
MISFIT_MM: Final = 50.0


class FoundHome(NamedTuple):
    """The cheapest home: its kind, drawing and verdict."""

    kind: str
    sheet: Sheet
    verdict: HomeVerdict

    @property
    def rank(self) -> tuple[int, int, float]:
        """What is better among homes that are not sound: all rooms entered, few short, cheap."""
        return self.verdict.unreached, self.verdict.short, self.verdict.cost


class _Seen(NamedTuple):
    cost: float
    draft: Draft
    sheet: Sheet | None
    verdict: HomeVerdict | None


NOTHING: Final = _Seen(inf, Draft("", [], []), None, None)


class HomeSearch:
    """Searches for homes of one programme.

    `moves` is how many a search makes each time.

    Args:
        planned: the rooms.
        frame_of: the frame of a house of a kind.
        seed: the house's seed.
        turn: which search of the seed's it is.
        outline: RECTANGLE, L, T or U; other than a rectangle only where the frame is free.
    """

    moves = MOVES

    def __init__(
        self, planned: Sequence[PlannedRoom], frame_of: Callable[[str], Frame], seed: int, turn: int = 0, outline: str = RECTANGLE
    ) -> None:
        self.planned, self.seed, self.turn, self.outline = planned, seed, turn, outline
        self.good = GOOD + GOOD_EACH * len(planned)
        self._looked: dict[tuple[object, ...], _Seen] = {}
        self.drawers: dict[str, Drawer]
        if outline == RECTANGLE:
            self.judge = HomeJudge(planned)
            self.drawers = {kind: Drawer(self.judge.sizes, frame_of(kind)) for kind in kinds_for(planned)}
        else:
            self.judge = HomeJudge(planned, BENT_OUTLINE)
            self.drawers = {bent_kind(planned, outline): BentDrawer(self.judge.sizes, outline)}

    def run(self) -> FoundHome | None:
        """Searches in the kind that the seed draws; in the others too where a room falls short in it.

        None where nothing has the outline; a rectangle is always found.
        """
        if self.outline == RECTANGLE:
            return self._rectangle()
        best = self._cheapest(self._kind(kind) for kind in self.drawers)
        return FoundHome(best.draft.kind, best.sheet, best.verdict) if best.sheet is not None and best.verdict is not None else None

    def _rectangle(self) -> FoundHome:
        kinds = list(kinds_for(self.planned))
        if kinds[0] != "rows":
            Stream(self.seed, "programme.kind").shuffle(kinds)
        best = NOTHING
        for kind in dict.fromkeys(kinds):
            seen = self._kind(kind)
            if seen.cost < best.cost:
                best = seen
            if seen.verdict is not None and not (seen.verdict.short or seen.verdict.unreached):
                break
        if best.sheet is not None and best.verdict is not None:
            return FoundHome(best.draft.kind, best.sheet, best.verdict)
        sheet = self.drawers[best.draft.kind].sheet(best.draft, stretch=True)
        if isinstance(sheet, Misfit):
            raise ValueError("a draft without depths")
        return FoundHome(best.draft.kind, sheet, self.judge.verdict(sheet))

    def _kind(self, kind: str) -> _Seen:
        shape = "" if self.outline == RECTANGLE else f"{self.outline}."
        streams = (Stream(self.seed, "programme", f"{shape}{kind}.{self.turn}.{number}") for number in range(TRIES))
        return self._cheapest(self._try(kind, stream) for stream in streams)

    def _cheapest(self, offers: Iterable[_Seen]) -> _Seen:
        """Returns the cheapest, the first that is good at once."""
        best = NOTHING
        for seen in offers:
            if seen.cost < best.cost:
                best = seen
            if best.cost <= self.good:
                break
        return best

    def _try(self, kind: str, stream: Stream) -> _Seen:
        dealer = self._dealer(stream)
        best = self._cheapest(self._dealt(kind, dealer) for _ in range(DEALS))
        for _ in range(self.moves):
            if best.cost <= self.good:
                break
            draft = moved(best.draft, stream)
            self.drawers[kind].fit_depths(draft)
            seen = self._look(draft)
            if seen.cost <= best.cost:
                best = seen
        return best

    def _dealer(self, stream: Stream) -> Dealer:
        if self.outline == RECTANGLE:
            return Dealer(self.planned, stream)
        return BentDealer(self.planned, stream, self.outline)

    def _dealt(self, kind: str, dealer: Dealer) -> _Seen:
        draft = dealer.deal(kind)
        self.drawers[kind].choose_depths(draft, dealer.stream)
        return self._look(draft)

    def _look(self, draft: Draft) -> _Seen:
        key = draft.key
        if key not in self._looked:
            self._looked[key] = self._judged(draft)
        return self._looked[key]

    def _judged(self, draft: Draft) -> _Seen:
        sheet = self.drawers[draft.kind].sheet(draft)
        if isinstance(sheet, Misfit):
            return _Seen(MISFIT + MISFIT_COLUMN * sheet.columns + sheet.gap / MISFIT_MM, draft, None, None)
        verdict = self.judge.verdict(sheet)
        return _Seen(verdict.cost, draft, sheet, verdict)
