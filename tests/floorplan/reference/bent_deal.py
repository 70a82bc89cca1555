"""Deals the rooms of a programme to homes whose outline is no rectangle.

Comes in: planned rooms, an outline, a stream. Goes out: `Draft`s. May import: the ground floor, the dealing of rectangles.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from solver.floorplan.programme.planned_rooms import PlannedRoom
from solver.streams import Stream
from tests.floorplan.reference.deal import AT_KITCHEN, TURNS, Chunk, Dealer
from tests.floorplan.reference.drafts import FREE, NORTH_OUT, SOUTH_OUT, Draft

BENDS: Final = {"L": (NORTH_OUT, NORTH_OUT, SOUTH_OUT, FREE), "T": (FREE,), "U": (NORTH_OUT, NORTH_OUT, SOUTH_OUT, SOUTH_OUT, FREE)}
"""How wings lie in an outline, drawn from these. A strip that juts out as a whole makes a deep court, so it is drawn often."""
SINGLE: Final = 0.5
"""How often public rooms lie in one row where they could lie in two."""
SHARINGS: Final = 16
"""How often private rooms are shared out among wings; the most even is taken. More makes homes alike."""
BARE_MM2: Final = 10_000_000
"""A wing with rooms on one side alone counts as so much floor uneven: its hallway serves half as many."""
IN_WING: Final = 0.75
"""How often the kitchen of a home with two wings begins one of them, beside the dining room."""


class BentDealer(Dealer):
    """Deals one programme's rooms to an outline."""

    def __init__(self, planned: Sequence[PlannedRoom], stream: Stream, outline: str) -> None:
        super().__init__(planned, stream)
        self.outline = outline

    def deal(self, kind: str) -> Draft:
        """Deals a draft of a kind."""
        if kind == "rows":
            draft = self._rows()
            draft.bend = FREE
        else:
            draft = self._wings(2 if kind == "winged" else 1)
        draft.turn = self.stream.below(TURNS)
        return draft

    def _wings(self, wings: int) -> Draft:
        stream = self.stream
        bend = stream.pick(BENDS[self.outline])
        in_wing = wings > 1 and stream.chance(IN_WING)
        single = bend != FREE or stream.chance(SINGLE)
        public, private = self._in_deep_row() if single and not in_wing else self._chunks()
        depths = [self._depth(), self._deep() if self.garages else self._depth(), *(self._depth() for _ in range(2 * wings))]
        begun: list[Chunk] = [self._entry() if k == 1 else [] for k in range(2 * wings)]
        kitchens = [column for column in public if self._is_kitchen(column)]
        rest = [column for column in public if column not in kitchens and not self._is_small(column)]
        moved = bool(in_wing and kitchens and rest)
        wing = 0
        if moved:
            side = stream.below(2) if bend == FREE else int(bend == NORTH_OUT)
            wing = stream.below(2)
            beside = [column for column in public if self._is_small(column)]
            begun[2 * wing + side] = kitchens + beside + begun[2 * wing + side]
            public = rest
        strips = [[], [], *self._shared(private, begun)]
        behind = public[::-1] if (wing if moved else stream.chance(0.8)) else list(public)
        cut = 0 if single or len(behind) < 2 else self._cut(behind, depths[:2])
        cars = [] if wings > 1 else [(room,) for room in self.garages]
        strips[0], strips[1] = behind[:cut], cars + behind[cut:]
        garages = tuple(self.garages) if wings > 1 else ()
        return Draft("winged" if wings > 1 else "ranch", strips, depths, garages=garages, bend=bend)

    def _is_small(self, column: Sequence[int]) -> bool:
        return self.planned[column[0]].kind.plan.wet and not self.planned[column[0]].kind.plan.habitable

    def _is_kitchen(self, column: Sequence[int]) -> bool:
        return self.planned[column[0]].kind.plan.wet and self.planned[column[0]].kind.plan.habitable

    def _in_deep_row(self) -> tuple[Chunk, list[Chunk]]:
        """Returns public and private rooms where the public ones lie in one deep row: what is small lies behind the kitchen."""
        if not self.small or not self.stream.chance(AT_KITCHEN):
            return self._chunks(shallow=False)
        dry = [room for room in self.small if not self._is_bath(room)]
        behind = self.stream.pick(dry or self.small)
        public, private = self._chunks(shallow=False, without=[behind])
        kitchens = [k for k, column in enumerate(public) if self.planned[column[0]].kind.plan.wet]
        if not kitchens:
            return public, [*private, [(behind,)]]
        k = kitchens[-1]
        public[k] = (behind, *public[k]) if self.stream.chance(0.5) else (*public[k], behind)
        return public, private

    def _shared(self, chunks: Sequence[Chunk], begun: Sequence[Chunk]) -> list[Chunk]:
        """Shares private rooms out among strips that are begun, so that the two strips of each wing are about as long."""

        def floor(chunk: Chunk) -> int:
            return sum(self.areas[room] for column in chunk for room in column)

        areas, first, count = [floor(chunk) for chunk in chunks], [floor(chunk) for chunk in begun], len(begun)

        def uneven(dealt: Sequence[int]) -> float:
            floors = list(first)
            for area, strip in zip(areas, dealt, strict=True):
                floors[strip] += area
            pairs = [(floors[k], floors[k + 1]) for k in range(0, count, 2)]
            return sum(abs(one - other) + BARE_MM2 * (not one or not other) for one, other in pairs)

        stream = self.stream
        dealt = min(([stream.below(count) for _ in chunks] for _ in range(SHARINGS)), key=uneven)
        strips: list[Chunk] = [[] for _ in range(count)]
        for chunk, strip in zip(chunks, dealt, strict=True):
            strips[strip] = strips[strip] + chunk if stream.chance(0.5) else chunk + strips[strip]
        return [first + rest for first, rest in zip(begun, strips, strict=True)]
