"""The search for a home in an outline that is given.

Comes in: planned rooms, ways to cut the outline, a seed. Goes out: `FoundHome`. May import: the search for homes.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf
from typing import Final

from solver.floorplan.programme.home_search import GIVEN, Frame
from solver.floorplan.programme.planned_rooms import PlannedRoom
from solver.geometry import Rect
from solver.streams import Stream
from tests.floorplan.reference.cost import UNREACHED, HomeJudge
from tests.floorplan.reference.given_deal import GivenDealer
from tests.floorplan.reference.given_drafts import GivenDrawer
from tests.floorplan.reference.search import HomeSearch

MOVES: Final = 96
"""How often a deal is changed: nothing of the outline gives way, so rooms must be tried in more places."""


class GivenSearch(HomeSearch):
    """Searches for homes of one programme in one outline.

    Args:
        planned: the rooms.
        tilings: rectangles that the outline may be cut into.
        seed: the house's seed.
        turn: which search of the seed's it is.
    """

    moves = MOVES

    def __init__(self, planned: Sequence[PlannedRoom], tilings: Sequence[Sequence[Rect]], seed: int, turn: int = 0) -> None:
        super().__init__(planned, lambda _: Frame(), seed, turn)
        self.outline = GIVEN
        self.tilings = [tiling for tiling in tilings if len(tiling) <= len(planned)]
        self.judge = HomeJudge(planned, (0.0, inf), dark=UNREACHED)
        self.drawers = {GIVEN: GivenDrawer(self.judge.sizes)}

    def _dealer(self, stream: Stream) -> GivenDealer:
        return GivenDealer(self.planned, stream, self.tilings)
