"""Drafts of homes: rooms dealt to the columns of strips, and the rectangles that come of them.

Comes in: the kind of skeleton, strips of columns, depths. Goes out: `Sheet`: a rectangle for every room and the hallway.
May import: the ground floor. A strip runs along u and is its depth across, v; a column's first room lies at the hallway (at
the inner line, where there is none). `rows`, `ranch` and `full` have u = x and the street at the end of v; `axial` has u =
z and the street at the end of u.

    rows   strip | strip                      full    strip | hallway | strip
    ranch  (strip | strip) beside (strip | hallway | strip)
    winged a ranch with a second (strip | hallway | strip) at the other end
    axial  strip | hallway and foyer | strip, seen from the side

In a rectangle the two pairs of a ranch are as deep, and the two strips of rows as long, as each other; in other outlines not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final, NamedTuple

from solver.floorplan.programme.home_search import FLOOR, RATIO, Frame
from solver.floorplan.programme.planned_rooms import RoomSize
from solver.geometry import Rect
from solver.streams import Stream
from tests.floorplan.reference.asked import centre, hallway
from tests.floorplan.reference.widths import DEPTHS_MM, LATTICE_MM, WidthRange, depths_for, depths_of, shared_out, width_of

SLIM_MM: Final = 1600
"""A strip is never made slimmer than this for the other's sake."""
CHOICES: Final = 4
"""How often depths are drawn until a ranch's two pairs of strips go together."""
FREE, NORTH_OUT, SOUTH_OUT = range(3)
"""How a home's wings lie: anywhere; or so that all of a wing's northern (southern) strip juts out, the rest being flush."""
Column = tuple[int, ...]
"""Rooms of a column, the one at the hallway first."""


class OutlineBlock(NamedTuple):
    """A rectangle of a given outline, mm, drawn as a house of a kind: with strips along z if `turned`, from its far end if `mirrored`."""

    rect: Rect
    kind: str
    turned: bool
    mirrored: bool

    @property
    def extents(self) -> tuple[int, int]:
        """Along its strips and across them, mm."""
        width, depth = self.rect.width, self.rect.depth
        return (depth, width) if self.turned else (width, depth)

    @property
    def strips(self) -> int:
        """How many strips it has."""
        return 4 if self.kind == "ranch" else 2

    def placed(self, box: Rect) -> Rect:
        """Returns where a room drawn in a house of these extents comes to lie."""
        x0, z0, x1, z1 = box
        if self.mirrored:
            along = self.extents[0]
            x0, x1 = along - x1, along - x0
        moved = Rect(z0, x0, z1, x1) if self.turned else Rect(x0, z0, x1, z1)
        return moved.moved(self.rect.x0, self.rect.z0)


@dataclass
class Draft:
    """Rooms dealt to strips.

    `strips` lie in this order: the northern (western) one before the southern (eastern); a ranch has its public pair first.
    Those of wings begin at the public rooms. `depths` are theirs, mm. `entry` is the room at an axial hallway's end, `garages`
    those at the end of the first wing's. `bend` says how wings lie (None: the outline is a rectangle), `turn` which of several
    places they or rows have. `blocks` are the rectangles of a given outline, whose strips follow each other.
    """

    kind: str
    strips: list[list[Column]]
    depths: list[int]
    entry: int | None = None
    garages: tuple[int, ...] = ()
    bend: int | None = None
    turn: int = 0
    blocks: tuple[OutlineBlock, ...] = ()

    @property
    def key(self) -> tuple[object, ...]:
        """Everything its drawing depends on, to look up by."""
        strips = tuple([tuple(strip) for strip in self.strips])
        return self.kind, strips, tuple(self.depths), self.entry, self.garages, self.bend, self.turn, self.blocks

    def copy(self) -> Draft:
        """Returns a draft that may be changed."""
        return replace(self, strips=[list(strip) for strip in self.strips], depths=list(self.depths))


class Sheet(NamedTuple):
    """Rectangles of the rooms by index, of the hallways, and the width and depth of all, mm."""

    boxes: list[Rect]
    hallways: list[Rect]
    width: int
    depth: int


class Misfit(NamedTuple):
    """A draft whose strips do not come out: by how many columns and mm."""

    columns: int
    gap: int


class Pair(NamedTuple):
    """Two strips of one length: the spans of their columns, and the lengths both may have, mm."""

    spans: tuple[list[WidthRange], list[WidthRange]]
    low: int
    wished: int
    high: int


def place(depth: int) -> int:
    """Returns the bit of the depth nearest to one, or one past them all."""
    place = (depth - DEPTHS_MM[0] + DEPTHS_MM.step // 2) // DEPTHS_MM.step
    return place if 0 <= place < len(DEPTHS_MM) else len(DEPTHS_MM)


def listed(bits: int) -> list[int]:
    """Returns the depths that are bits."""
    return [depth for k, depth in enumerate(DEPTHS_MM) if bits >> k & 1]


def nearest(bits: int, wished: int) -> int:
    """Returns the depth among bits that is nearest to one wished, that one itself where it is as good."""
    if bits >> place(wished) & 1:
        return wished
    return min(listed(bits), key=lambda depth: (abs(depth - wished), depth))


def snapped(length: int) -> int:
    """Returns the length on the lattice that is nearest."""
    return (length + LATTICE_MM // 2) // LATTICE_MM * LATTICE_MM


class Drawer:
    """Draws the drafts of one programme in one frame."""

    def __init__(self, sizes: Sequence[RoomSize], frame: Frame) -> None:
        self.sizes, self.frame = sizes, frame
        floor = FLOOR * sum(size.typical for size in sizes)
        self.wished = ((floor / RATIO) ** 0.5 - hallway()) / 2

    def choose_depths(self, draft: Draft, stream: Stream) -> None:
        """Gives the strips depths at which all their columns have a width, pairs of strips about one length.

        A strip whose columns have no such depth in common takes what the others leave it.
        """
        last, whole = len(draft.strips) - 2, self._across(draft.kind)
        self._draw_depths(draft, last, whole, stream)
        self._close(draft, whole)

    def _draw_depths(self, draft: Draft, last: int, whole: int, stream: Stream) -> None:
        for _ in range(CHOICES):
            fits = self._choose_pair(draft, last, whole, stream)
            if not last or (self._choose_pair(draft, 0, sum(draft.depths[2:]) + hallway(), stream) and fits):
                return

    def _choose_pair(self, draft: Draft, first: int, whole: int, stream: Stream) -> bool:
        """Chooses the depths of two strips; tells whether both suit their columns."""
        depths, strips = draft.depths, draft.strips
        north, south = listed(self._possible(strips[first])), self._possible(strips[first + 1])
        if whole:
            both = [depth for depth in north if south >> place(whole - depth) & 1]
            depths[first] = stream.pick(both or north)
            self._share(depths, first, whole)
            return bool(both)
        depth = min(stream.pick(north), stream.pick(north), key=lambda one: abs(one - self.wished))
        areas = [sum([self.sizes[room].typical for column in strips[k] for room in column]) for k in (first, first + 1)]
        depths[first : first + 2] = depth, nearest(south, areas[1] * depth // max(areas[0], 1) // DEPTHS_MM.step * DEPTHS_MM.step)
        return True

    def _possible(self, strip: Sequence[Column]) -> int:
        """Returns the depths at which a strip's columns have a width, as bits; columns that leave none are passed over."""
        common = (1 << len(DEPTHS_MM)) - 1
        for column in strip:
            common = common & depths_for(self._stack(column)) or common
        return common

    def _stack(self, column: Column) -> tuple[RoomSize, ...]:
        return tuple([self.sizes[room] for room in column])

    def _spans(self, strip: Sequence[Column], depth: int) -> list[WidthRange]:
        return [width_of(self._stack(column), depth) for column in strip]

    def _across(self, kind: str) -> int:
        """Returns what the last two strips' depths add up to, 0 where it is free."""
        frame = self.frame
        between = 0 if kind == "rows" else centre() if kind == "axial" else hallway()
        across = frame.width if kind == "axial" else frame.depth
        return across and across - between

    def fit_depths(self, draft: Draft) -> None:
        """Makes a changed draft's depths add up to what the frame and its kind ask for, near to what its columns can have."""
        depths, last, whole = draft.depths, len(draft.strips) - 2, self._across(draft.kind)
        for k in range(len(depths)):
            depths[k] = nearest(self._possible(draft.strips[k]), depths[k])
        if whole:
            self._share(depths, last, whole)
        if last:
            self._share(depths, 0, depths[2] + hallway() + depths[3])
        self._close(draft, whole)

    @staticmethod
    def _close(draft: Draft, whole: int) -> None:
        """Gives the depth of a strip without columns to the other one of its pair, where both make up a whole."""
        for k, strip in enumerate(draft.strips):
            if not strip:
                if whole or k < len(draft.strips) - 2:
                    draft.depths[k ^ 1] += draft.depths[k]
                draft.depths[k] = 0

    @staticmethod
    def _share(depths: list[int], first: int, whole: int) -> None:
        """Makes two depths add up; the first is kept unless that leaves the second next to nothing."""
        if whole - depths[first] < SLIM_MM:
            depths[first] = whole // 2 // LATTICE_MM * LATTICE_MM
        depths[first + 1] = whole - depths[first]

    def sheet(self, draft: Draft, stretch: bool = False) -> Sheet | Misfit:
        """Draws a draft.

        Args:
            draft: its depths fit.
            stretch: draw it even where its strips do not come out: rooms then miss their limits.
        """
        if min(depth for depth, strip in zip(draft.depths, draft.strips, strict=True) if strip) < 2 * LATTICE_MM:
            return Misfit(len(self.sizes), 0)
        pairs = []
        for first in range(0, len(draft.depths), 2):
            pair = self._pair(draft, first, stretch)
            if isinstance(pair, Misfit):
                return pair
            pairs.append(pair)
        along = self.frame.depth if draft.kind == "axial" else self.frame.width
        lengths = self._lengths(pairs, along)
        misses = sum(max(pair.low - length, length - pair.high, 0) for pair, length in zip(pairs, lengths, strict=True))
        if misses and not stretch:
            return Misfit(0, misses)
        return self._drawn(draft, pairs, lengths)

    def _pair(self, draft: Draft, first: int, stretch: bool) -> Pair | Misfit:
        north, south = (self._spans(draft.strips[k], draft.depths[k]) for k in (first, first + 1))
        bad, low, high, wished = 0, 0, 1 << 30, 0
        rows = [row for row in (north, south) if row] or [north]
        for row in rows:
            least = most = 0
            for span in row:
                least += span.low
                most += span.high
                wished += span.wished
                bad += span.misses
            low, high = max(low, least), min(high, most)
        wished = snapped(wished // len(rows))
        if stretch:
            return Pair((north, south), wished, wished, wished)
        if bad or low > high:
            return Misfit(bad, max(low - high, 0))
        return Pair((north, south), low, min(max(wished, low), high), high)

    def _lengths(self, pairs: Sequence[Pair], along: int) -> list[int]:
        if not along:
            return [pair.wished for pair in pairs]
        if len(pairs) == 1:
            return [along]
        spans = [WidthRange(pair.low, pair.wished, pair.high) for pair in pairs]
        return list(shared_out(along, spans))

    def _drawn(self, draft: Draft, pairs: Sequence[Pair], lengths: Sequence[int]) -> Sheet:
        boxes: list[Rect] = [Rect(0, 0, 0, 0)] * len(self.sizes)
        between = centre() if draft.kind == "axial" else hallway()
        at, across, hallways = 0, 0, list[Rect]()
        for k, (pair, length) in enumerate(zip(pairs, lengths, strict=True)):
            gap = 0 if draft.kind == "rows" or (draft.kind == "ranch" and k == 0) else between
            first, second = draft.depths[2 * k], draft.depths[2 * k + 1]
            self._row(draft.strips[2 * k], shared_out(length, pair.spans[0]), (at, first, first), boxes)
            self._row(draft.strips[2 * k + 1], shared_out(length, pair.spans[1]), (at, first + gap, -second), boxes)
            if gap:
                hallways.append(Rect(at, first, at + length, first + gap))
            at += length
            across = first + gap + second
        if draft.kind == "axial":
            return self._turned(draft, boxes, hallways, (at, across))
        return Sheet(boxes, hallways, at, across)

    def _row(self, columns: Sequence[Column], widths: Sequence[int], place: tuple[int, int, int], boxes: list[Rect]) -> None:
        """Lays the columns of a strip side by side.

        `place` is where the strip starts along u, its inner line across, and its depth: positive where it lies before
        that line, negative where it lies behind.
        """
        if not columns:
            return
        at, line, depth = place
        for column, width in zip(columns, widths, strict=True):
            inner = line
            parts = (abs(depth),) if len(column) == 1 else depths_of(self._stack(column), width, abs(depth))
            for room, part in zip(column, parts, strict=True):
                if depth > 0:
                    boxes[room] = Rect(at, inner - part, at + width, inner)
                    inner -= part
                else:
                    boxes[room] = Rect(at, inner, at + width, inner + part)
                    inner += part
            at += width

    def _turned(self, draft: Draft, boxes: list[Rect], hallways: list[Rect], extents: tuple[int, int]) -> Sheet:
        """Turns an axial house so that its hallway runs back from the street, and puts the entry at its end."""
        turned = [Rect(v0, u0, v1, u1) for u0, v0, u1, v1 in boxes]
        along, across = extents
        west, east = hallways[0].z0, hallways[0].z1
        end = along
        if draft.entry is not None:
            end = max(along - width_of((self.sizes[draft.entry],), east - west).wished, along // 2)
            turned[draft.entry] = Rect(west, end, east, along)
        return Sheet(turned, [Rect(west, 0, east, end)], across, along)
