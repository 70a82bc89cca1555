"""Deals the rooms of a programme to the rectangles of a given outline.

Comes in: planned rooms, ways to cut the outline, a stream. Goes out: `Draft`s with blocks. May import: the ground floor, the dealing
of rectangles.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from solver.floorplan.programme.home_search import GIVEN
from solver.floorplan.programme.planned_rooms import PlannedRoom
from solver.geometry import Rect
from solver.streams import Stream
from tests.floorplan.reference.asked import hallway
from tests.floorplan.reference.deal import Chunk, Dealer
from tests.floorplan.reference.drafts import Column, Draft, OutlineBlock

SIDED_MM: Final = 3700
"""Least extent across of a rectangle with a hallway along one side."""
LINED_MM: Final = 6500
"""The same with rooms on both sides of the hallway."""
SPLIT_MM: Final = 9000
"""Least length of a rectangle with public rooms at one end and a hallway at the other."""
ALONG: Final = 0.8
"""How often strips run along the longer side of a rectangle."""
StreetEnd = tuple[int, bool]
"""A strip, and whether its end is meant, not its beginning."""


class GivenDealer(Dealer):
    """Deals one programme's rooms to an outline that may be cut into rectangles in several ways."""

    def __init__(self, planned: Sequence[PlannedRoom], stream: Stream, tilings: Sequence[Sequence[Rect]]) -> None:
        super().__init__(planned, stream)
        self.tilings = tilings
        private = len(planned) - len(self.public) - len(self.entries)
        self.hallways = private > 1

    def deal(self, kind: str) -> Draft:
        """Deals a draft: public rooms where there is no hallway, the others along hallways, the entry at the street."""
        rects = self.stream.pick(self.tilings)
        blocks = tuple(self._block(rect) for rect in rects)
        strips: list[list[Column]] = [[] for block in blocks for _ in range(block.strips)]
        left, public = self._floors(blocks)
        street = self._street(blocks)
        for room in (*self.garages, *self.entries):
            strip, at_end = self.stream.pick(street)
            strips[strip].insert(len(strips[strip]) if at_end else 0, (room,))
            left[strip] -= self.areas[room]
        fronts = {strip: at_end for strip, at_end in street if strips[strip]}
        living, private = self._chunks()
        for chunk, wanted in ((living, public), *((chunk, range(len(strips))) for chunk in self._largest_first(private))):
            self._lay(chunk, list(wanted), strips, left, fronts)
        _filled(blocks, strips)
        depths = [block.extents[1] // 2 for block in blocks for _ in range(block.strips)]
        return Draft(GIVEN, strips, depths, blocks=blocks)

    def _block(self, rect: Rect) -> OutlineBlock:
        stream = self.stream
        turned = (rect.depth > rect.width) == stream.chance(ALONG)
        along, across = (rect.depth, rect.width) if turned else (rect.width, rect.depth)
        kinds = ["rows"]
        if self.hallways and across >= SIDED_MM:
            kinds += ["full"]
            if across >= LINED_MM:
                kinds = ["rows", "full", "full", "ranch", "ranch"] if along >= SPLIT_MM else ["rows", "full", "full"]
        return OutlineBlock(rect, stream.pick(kinds), turned, stream.chance(0.5))

    def _floors(self, blocks: Sequence[OutlineBlock]) -> tuple[list[float], list[int]]:
        """Returns the floor of every strip, mm2, and which strips lie at no hallway: all where there are none such."""
        floors, public = list[float](), list[int]()
        for block in blocks:
            along, across = block.extents
            for pair in range(block.strips // 2):
                beside = block.kind == "rows" or (block.kind == "ranch" and not pair)
                deep = across if beside else across - hallway()
                length = along * 2 / block.strips
                public += [len(floors), len(floors) + 1] if beside else []
                one_sided = deep < LINED_MM - hallway()
                share = float(self.stream.below(2)) if one_sided else self.stream.uniform(0.4, 0.6)
                floors += [share * deep * length, (1 - share) * deep * length]
        return floors, public or list(range(len(floors)))

    def _street(self, blocks: Sequence[OutlineBlock]) -> list[StreetEnd]:
        """Returns where a room lies at the street: the southern strips, and southern ends of strips along z, of blocks that do."""
        found, first = list[StreetEnd](), 0
        for block in blocks:
            if not any(other.rect.z0 == block.rect.z1 and _covers(other.rect, block.rect) for other in blocks):
                if block.turned:
                    begin = first if block.mirrored else first + block.strips - 2
                    found += [(begin, not block.mirrored), (begin + 1, not block.mirrored)]
                else:
                    found += [(k, end) for k in range(first + 1, first + block.strips, 2) for end in (False, True)]
            first += block.strips
        return found or [(0, False)]

    def _largest_first(self, chunks: Sequence[Chunk]) -> list[Chunk]:
        return sorted(chunks, key=lambda chunk: -sum(self.areas[room] for column in chunk for room in column))

    def _lay(self, chunk: Chunk, wanted: list[int], strips: list[list[Column]], left: list[float], fronts: dict[int, bool]) -> None:
        """Lays columns in the strip with the most floor left, and what does not go there in the next; never before who is at the street."""
        rest = list(chunk)
        while rest:
            stream = self.stream
            fresh = [k for k in wanted if left[k] > 0] or list(range(len(strips)))
            strip = max(fresh, key=lambda k: left[k] * stream.uniform(0.7, 1.3))
            count, floor = 0, left[strip]
            while count < len(rest) and (not count or floor > 0.5 * self._floor(rest[count])):
                floor -= self._floor(rest[count])
                count += 1
            dealt, rest, left[strip] = rest[:count], rest[count:], floor
            at_end = not fronts[strip] if strip in fronts else stream.chance(0.5)
            strips[strip][len(strips[strip]) if at_end else 0 : len(strips[strip]) if at_end else 0] = dealt

    def _floor(self, column: Column) -> int:
        return sum(self.areas[room] for room in column)


def _filled(blocks: Sequence[OutlineBlock], strips: list[list[Column]]) -> None:
    """Gives every pair of strips without rooms a column of those that have most, one room of it where it has but one."""
    pairs = range(0, sum(block.strips for block in blocks), 2)
    for empty in [k for k in pairs if not strips[k] and not strips[k + 1]]:
        full = max(range(len(strips)), key=lambda k: sum(len(column) for column in strips[k] + strips[k ^ 1]) * bool(strips[k]))
        column = strips[full].pop()
        if len(column) > 1 and not strips[full] and not strips[full ^ 1]:
            strips[full].append(column[1:])
            column = column[:1]
        strips[empty].append(column)


def _covers(other: Rect, rect: Rect) -> bool:
    return other.x0 <= rect.x0 and rect.x1 <= other.x1
