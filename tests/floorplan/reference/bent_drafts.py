"""Drafts of homes whose outline is no rectangle: an L, a T, a U.

Comes in: drafts of rows, of a ranch, or of two wings. Goes out: `Sheet`s. May import: the ground floor. Each pair of strips has
its own depth, and a wing slides along the public block as far as its hallway meets it; of rows each strip has its own length.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from solver.floorplan.programme.home_search import Frame
from solver.floorplan.programme.planned_rooms import RoomSize
from solver.geometry import Rect
from solver.streams import Stream
from tests.floorplan.reference.asked import hallway
from tests.floorplan.reference.bends import JOG_MM, Wing, offsets
from tests.floorplan.reference.drafts import (
    CHOICES,
    FREE,
    NORTH_OUT,
    Draft,
    Drawer,
    Misfit,
    Pair,
    Sheet,
    listed,
    nearest,
    place,
    snapped,
)
from tests.floorplan.reference.widths import DEPTHS_MM, LATTICE_MM, WidthRange, shared_out, width_of

GARAGE_MM: Final = 5700
"""Depth of a garage at the end of a wing: a car with space to walk around it. Our choice."""


class BentDrawer(Drawer):
    """Draws the drafts of one programme in an outline that is chosen to fit."""

    def __init__(self, sizes: Sequence[RoomSize], outline: str) -> None:
        super().__init__(sizes, Frame())
        self.outline = outline

    def choose_depths(self, draft: Draft, stream: Stream) -> None:
        """Gives the strips depths at which all their columns have a width, and wings and public rooms a place beside each other."""
        for _ in range(CHOICES):
            for first in range(2 if len(draft.strips) > 2 else 0, len(draft.strips), 2):
                self._choose_pair(draft, first, 0, stream)
            if draft.kind != "rows":
                self._choose_public(draft, stream)
            self._close(draft, 0)
            if draft.kind == "rows" or self._offsets(draft):
                return

    def _choose_pair(self, draft: Draft, first: int, whole: int, stream: Stream) -> bool:
        for k in (first, first + 1):
            if not draft.strips[k ^ 1]:
                options = listed(self._possible(draft.strips[k]))
                draft.depths[k] = min(stream.pick(options), stream.pick(options), key=lambda one: abs(one - self.wished))
                return True
        return super()._choose_pair(draft, first, whole, stream)

    def _choose_public(self, draft: Draft, stream: Stream) -> None:
        """Chooses the public rooms' depths: free, or what is flush with the hallways and the strips beyond."""
        if draft.bend == FREE:
            self._choose_pair(draft, 0, 0, stream)
            return
        flush = self._flush(draft)
        public = next(strip for strip in (draft.strips[0], draft.strips[1]) if strip)
        possible = self._possible(public)
        depths = [depth for depth in self._common(draft) if possible >> place(depth + hallway()) & 1]
        wished = stream.pick(depths) if depths else draft.depths[flush[0]]
        for k in flush:
            draft.depths[k] = nearest(self._possible(draft.strips[k]), wished)
        self._make_flush(draft)

    def _flush(self, draft: Draft) -> list[int]:
        """Returns the strips of wings that are flush with the public rooms."""
        return list(range(3 if draft.bend == NORTH_OUT else 2, len(draft.strips), 2))

    def _common(self, draft: Draft) -> list[int]:
        """Returns the depths that all flush strips can have."""
        common = (1 << len(DEPTHS_MM)) - 1
        for k in self._flush(draft):
            common &= self._possible(draft.strips[k])
        return listed(common)

    def _make_flush(self, draft: Draft) -> None:
        """Makes flush strips as deep as the first of them, and the public rooms as deep as these and the hallway."""
        flush = self._flush(draft)
        for k in flush:
            draft.depths[k] = draft.depths[flush[0]]
        whole = draft.depths[flush[0]] + hallway()
        if draft.strips[0] and draft.strips[1]:
            self._share(draft.depths, 0, whole)
        else:
            draft.depths[0 if draft.strips[0] else 1] = whole

    def fit_depths(self, draft: Draft) -> None:
        """Makes a changed draft's depths near ones that its columns can have."""
        for k, strip in enumerate(draft.strips):
            draft.depths[k] = nearest(self._possible(strip), draft.depths[k] or int(self.wished))
        if draft.kind != "rows" and draft.bend != FREE:
            self._make_flush(draft)
        self._close(draft, 0)

    @staticmethod
    def _close(draft: Draft, whole: int) -> None:
        for k, strip in enumerate(draft.strips):
            draft.depths[k] = draft.depths[k] if strip else 0

    def _offsets(self, draft: Draft) -> tuple[tuple[int, ...], ...]:
        wings = tuple([Wing(*draft.depths[k : k + 2]) for k in range(2, len(draft.depths), 2)])
        return offsets(self.outline, sum(draft.depths[:2]), wings)

    def sheet(self, draft: Draft, stretch: bool = False) -> Sheet | Misfit:
        """Draws a draft; one whose strips do not come out is a misfit, however much they are to be stretched."""
        if any(strip and depth < 2 * LATTICE_MM for strip, depth in zip(draft.strips, draft.depths, strict=True)):
            return Misfit(len(self.sizes), 0)
        if draft.kind == "rows":
            return self._rows(draft)
        chosen = self._offsets(draft)
        beyond = abs(Wing(*draft.depths[2:4]).depth - GARAGE_MM) if draft.garages else 0
        if not chosen or 0 < beyond < JOG_MM:
            return Misfit(0, JOG_MM)
        pairs = list[Pair]()
        for first in range(0, len(draft.depths), 2):
            pair = self._pair(draft, first, stretch=False)
            if isinstance(pair, Misfit):
                return pair
            pairs.append(pair)
        return self._winged(draft, pairs, chosen[draft.turn % len(chosen)])

    def _winged(self, draft: Draft, pairs: Sequence[Pair], chosen: Sequence[int]) -> Sheet:
        """Lays the western wing, the public rooms and the eastern wing side by side, and garages at the eastern end."""
        boxes: list[Rect] = [Rect(0, 0, 0, 0)] * len(self.sizes)
        hallways: list[Rect] = []
        at = 0
        for k in (2, 0, 1)[-len(pairs) :]:
            offset = chosen[k - 1] if k else 0
            self._block(draft, (k, pairs[k]), (at, offset), boxes)
            if k:
                line = offset + draft.depths[2 * k]
                hallways.append(Rect(at, line, at + pairs[k].wished, line + hallway()))
            at += pairs[k].wished
        south = chosen[0] + draft.depths[2] + hallway() + draft.depths[3]
        for room in draft.garages:
            width = width_of((self.sizes[room],), GARAGE_MM).wished
            boxes[room] = Rect(at, south - GARAGE_MM, at + width, south)
            at += width
        return _sheet(boxes, hallways)

    def _block(self, draft: Draft, which: tuple[int, Pair], corner: tuple[int, int], boxes: list[Rect]) -> None:
        """Lays a pair of strips at a north-west corner; the second wing's columns begin at their eastern end."""
        (k, pair), (at, z) = which, corner
        first, second = draft.depths[2 * k], draft.depths[2 * k + 1]
        south = z + first + (hallway() if k else 0)
        order = -1 if k == 2 else 1
        for row, (line, depth) in enumerate(((z + first, first), (south, -second))):
            columns, spans = draft.strips[2 * k + row], pair.spans[row]
            if columns:
                self._row(columns[::order], shared_out(pair.wished, spans[::order]), (at, line, depth), boxes)

    def _rows(self, draft: Draft) -> Sheet | Misfit:
        """Lays two strips of different lengths behind each other."""
        spans = [self._spans(strip, depth) for strip, depth in zip(draft.strips, draft.depths, strict=True)]
        bad = sum(span.misses for row in spans for span in row)
        if bad or not all(spans):
            return Misfit(bad, JOG_MM)
        lengths = _apart([_whole(row) for row in spans], JOG_MM if self.outline == "L" else 2 * JOG_MM)
        if lengths is None:
            return Misfit(0, JOG_MM)
        boxes: list[Rect] = [Rect(0, 0, 0, 0)] * len(self.sizes)
        spare = abs(lengths[0] - lengths[1])
        inset = spare // 2 // LATTICE_MM * LATTICE_MM if self.outline == "T" else spare * (draft.turn % 2)
        for row, depth, length, strip in zip(spans, (1, -1), lengths, draft.strips, strict=True):
            deep = draft.depths[0] if depth == 1 else -draft.depths[1]
            at = inset if length < max(lengths) else 0
            self._row(strip, shared_out(length, row), (at, draft.depths[0], deep), boxes)
        return _sheet(boxes, [])


def _whole(row: Sequence[WidthRange]) -> WidthRange:
    """Returns how long a strip may be."""
    low, wished, high = (sum(span[k] for span in row) for k in range(3))
    return WidthRange(low, min(max(snapped(wished), low), high), high)


def _apart(rows: Sequence[WidthRange], least: int) -> tuple[int, int] | None:
    """Returns lengths of two strips that differ by at least so much, mm; None where there are none."""
    one, other = sorted((0, 1), key=lambda k: -rows[k].wished)
    lengths = [row.wished for row in rows]
    lengths[one] += max(0, min(least - (lengths[one] - lengths[other]), rows[one].high - lengths[one]))
    lengths[other] -= max(0, min(least - (lengths[one] - lengths[other]), lengths[other] - rows[other].low))
    return (lengths[0], lengths[1]) if lengths[one] - lengths[other] >= least else None


def _sheet(boxes: list[Rect], hallways: list[Rect]) -> Sheet:
    """Moves rooms so that the least rectangle around them begins at nought."""
    every = [*boxes, *hallways]
    west, north = min(box.x0 for box in every), min(box.z0 for box in every)
    moved = [box.moved(-west, -north) for box in every]
    return Sheet(moved[: len(boxes)], moved[len(boxes) :], max(box.x1 for box in moved), max(box.z1 for box in moved))
