"""Drafts of homes in an outline that is given: each of its rectangles is drawn as a house of its own in a fixed frame.

Comes in: drafts with blocks. Goes out: `Sheet`s that tile the outline. May import: the ground floor, the drawing of rectangles.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from solver.floorplan.programme.home_search import Frame
from solver.floorplan.programme.planned_rooms import RoomSize
from solver.geometry import Rect
from solver.streams import Stream
from tests.floorplan.reference.drafts import Draft, Drawer, Misfit, OutlineBlock, Sheet


class GivenDrawer(Drawer):
    """Draws the drafts of one programme in the rectangles of a given outline."""

    def __init__(self, sizes: Sequence[RoomSize]) -> None:
        super().__init__(sizes, Frame())
        self.within: dict[tuple[int, int], Drawer] = {}

    def choose_depths(self, draft: Draft, stream: Stream) -> None:
        """Gives the strips of every block depths that add up to what it has across."""
        for first, block, part in self._parts(draft):
            self._drawer(block).choose_depths(part, stream)
            draft.depths[first : first + block.strips] = part.depths

    def fit_depths(self, draft: Draft) -> None:
        """Makes a changed draft's depths add up again, block by block."""
        for first, block, part in self._parts(draft):
            self._drawer(block).fit_depths(part)
            draft.depths[first : first + block.strips] = part.depths

    def sheet(self, draft: Draft, stretch: bool = False) -> Sheet | Misfit:
        """Draws a draft, rooms outside their limits where strips do not come out; one with a block without rooms is a misfit."""
        boxes: list[Rect] = [Rect(0, 0, 0, 0)] * len(self.sizes)
        hallways = list[Rect]()
        for _, block, part in self._parts(draft):
            drawn = self._block(block, part)
            if isinstance(drawn, Misfit):
                return drawn
            hallways += [block.placed(hallway) for hallway in drawn.hallways]
            for room in (room for strip in part.strips for column in strip for room in column):
                boxes[room] = block.placed(drawn.boxes[room])
        every = [*boxes, *hallways]
        if any(box.width <= 0 or box.depth <= 0 for box in every):
            return Misfit(len(self.sizes), 0)
        return Sheet(boxes, hallways, max(box.x1 for box in every), max(box.z1 for box in every))

    def _block(self, block: OutlineBlock, part: Draft) -> Sheet | Misfit:
        empty = sum(not any(part.strips[first : first + 2]) for first in range(0, len(part.strips), 2))
        if empty:
            return Misfit(len(self.sizes) * empty, 0)
        drawer = self._drawer(block)
        drawn = drawer.sheet(part)
        return drawer.sheet(part, stretch=True) if isinstance(drawn, Misfit) else drawn

    def _drawer(self, block: OutlineBlock) -> Drawer:
        """Returns what draws a house of a block's extents."""
        return self.within.setdefault(block.extents, Drawer(self.sizes, Frame(*block.extents)))

    @staticmethod
    def _parts(draft: Draft) -> Iterator[tuple[int, OutlineBlock, Draft]]:
        """Yields every block with the number of its first strip, and its own draft."""
        first = 0
        for block in draft.blocks:
            last = first + block.strips
            yield first, block, replace(draft, kind=block.kind, strips=draft.strips[first:last], depths=draft.depths[first:last], blocks=())
            first = last
