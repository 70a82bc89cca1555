"""Deals the rooms of a programme to the strips of a skeleton, and changes a deal a little.

Comes in: wishes, a kind, a stream. Goes out: `Draft`s. May import: the ground floor. Rooms that belong together are dealt
together: a bedroom with its own bathroom, the bathroom with what shares its pipes, kitchen, dining and living room.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from solver.floorplan.programme.drafts import Column, Draft
from solver.floorplan.programme.wishes import Wish
from solver.streams import Stream

DEPTHS: Final = (3300, 4350)
"""Depth of a strip of rooms one deep, mm: bedrooms of 11.5 m2 are then 2.7 to 3.5 m wide."""
DEEP: Final = (5400, 6150)
"""Depth of a strip that cars stand in, mm."""
STEPS: Final = (-300, -150, 150, 300)
"""What a move adds to a strip's depth, mm (floorplan.md)."""
STEP_MM: Final = 150
PAIRED: Final = 0.55
"""How often a small wet room lies behind another one, and
an own bathroom behind a small wet room next to its bedroom."""
BESIDE: Final = 0.8
"""How often it else lies beside the bedroom, not behind it."""
Chunk = list[Column]


def kinds_for(wishes: Sequence[Wish]) -> tuple[str, ...]:
    """Returns the skeletons that suit a programme: by how many rooms need a hallway, and whether cars come in."""
    private = sum(not wish.kind.plan.way_through and wish.owner is None and not wish.garage for wish in wishes)
    sleeping = sum(wish.kind.plan.habitable and not wish.public for wish in wishes)
    if sleeping <= 1 and private <= 3:
        return ("rows",)
    public = sum(wish.public for wish in wishes)
    kinds = ["full"]
    if public >= 2:
        kinds.append("ranch")
    if not any(wish.garage for wish in wishes):
        kinds.append("axial")
    return tuple(kinds)


class Dealer:
    """Deals one programme's rooms."""

    def __init__(self, wishes: Sequence[Wish], stream: Stream) -> None:
        self.wishes, self.stream = wishes, stream
        every = range(len(wishes))
        self.entries = [i for i in every if wishes[i].entry]
        self.garages = [i for i in every if wishes[i].garage]
        self.public = [i for i in every if wishes[i].public]
        self.small = [i for i in every if wishes[i].small and wishes[i].owner is None]
        self.owned = [(i, wish.owner) for i, wish in enumerate(wishes) if wish.owner is not None]
        self.others = [i for i in every if not (wishes[i].kind.plan.way_through or wishes[i].small or wishes[i].garage)]
        self.areas = [wish.size.typical for wish in wishes]

    def deal(self, kind: str) -> Draft:
        """Deals a draft of a kind."""
        deals: dict[str, Callable[[], Draft]] = {"rows": self._rows, "full": self._full, "ranch": self._ranch, "axial": self._axial}
        return deals[kind]()

    def _depth(self, bounds: tuple[int, int] = DEPTHS) -> int:
        return bounds[0] + STEP_MM * self.stream.below((bounds[1] - bounds[0]) // STEP_MM + 1)

    def _deep(self) -> int:
        return self._depth(DEEP if self.garages else DEPTHS)

    def _chunks(self) -> tuple[Chunk, list[Chunk]]:
        """Returns the public rooms, with what is dealt beside them, and the private rooms in chunks."""
        stream, small, private = self.stream, list(self.small), list[Chunk]()
        stream.shuffle(small)
        baths = [i for i in small if self.wishes[i].kind.plan.behind and self._is_bath(i)]
        others = [i for i in small if i not in baths]
        owners = {owner: bath for bath, owner in self.owned}
        for room in self.others:
            private.append(self._suite(room, owners[room], baths, others) if room in owners else [(room,)])
        public: Chunk = [(room,) for room in self._public_order()]
        while baths:
            bath = baths.pop()
            if others and stream.chance(PAIRED):
                private.append([(bath, others.pop())])
            elif baths and stream.chance(PAIRED):
                private.append([(bath,), (baths.pop(),)])
            else:
                private.append([(bath,)])
        for room in others:
            kitchens = [k for k, column in enumerate(public) if self.wishes[column[0]].kind.plan.wet]
            if kitchens and stream.chance(0.8):
                public.insert(kitchens[0] + stream.below(2), (room,))
            else:
                private.append([(room,)])
        stream.shuffle(private)
        return public, private

    def _is_bath(self, room: int) -> bool:
        return any("toilet" in line for line in self.wishes[room].kind.requires)

    def _suite(self, room: int, bath: int, baths: list[int], others: list[int]) -> Chunk:
        """A bedroom with its own bathroom: behind a small wet room next to it, beside it, or behind it."""
        fronts = baths if baths and (not others or self.stream.chance(0.6)) else others
        if fronts and self.stream.chance(PAIRED):
            chunk: Chunk = [(room,), (fronts.pop(), bath)]
        elif self.stream.chance(BESIDE):
            chunk = [(room,), (bath,)]
            if fronts:
                chunk.append((fronts.pop(),))
        else:
            chunk = [(room, bath)]
        return self._either(chunk)

    def _either(self, chunk: Chunk) -> Chunk:
        return chunk[::-1] if self.stream.chance(0.5) else chunk

    def _public_order(self) -> list[int]:
        """Living rooms at one end, kitchens at the other or in the middle."""
        living = [i for i in self.public if not self.wishes[i].kind.plan.wet]
        kitchens = [i for i in self.public if self.wishes[i].kind.plan.wet]
        living.sort(key=lambda i: (-self.areas[i], i))
        at = len(living) if self.stream.chance(0.6) else min(1, len(living))
        return living[:at] + kitchens + living[at:]

    def _length(self, strip: Sequence[Column], depth: int) -> int:
        return sum(self.areas[room] for column in strip for room in column) // depth

    def _fill(self, strips: Sequence[list[Column]], depths: Sequence[int], chunks: Sequence[Chunk]) -> None:
        """Adds chunks to either end of the strip that is the shorter one, mostly."""
        for chunk in sorted(chunks, key=lambda chunk: -sum(self.areas[i] for column in chunk for i in column)):
            lengths = [self._length(strip, depth) * self.stream.uniform(0.9, 1.1) for strip, depth in zip(strips, depths, strict=True)]
            shorter = strips[lengths.index(min(lengths))]
            if self.stream.chance(0.5):
                shorter[:0] = chunk
            else:
                shorter.extend(chunk)

    def _entry(self) -> Chunk:
        """The entry as a column; in a strip for cars something small lies between it and the hallway."""
        return [(self.entries[0],)] if self.entries else []

    def _front(self, private: list[Chunk]) -> Chunk:
        entry = self._entry()
        single = [chunk for chunk in private if len(chunk) == 1 and len(chunk[0]) == 1 and self.wishes[chunk[0][0]].small]
        if entry and single and (self.garages or self.stream.chance(0.15)):
            private.remove(single[0])
            return [(single[0][0][0], entry[0][0])]
        return entry

    def _full(self) -> Draft:
        public, private = self._chunks()
        depths = [self._depth(), self._deep()]
        north: list[Column] = []
        south: list[Column] = self._front(private)
        if self.garages or self.stream.chance(0.65):
            south = self._either(south + public)
        else:
            north = self._either(public)
        self._fill((north, south), depths, private)
        south[:0] = [(room,) for room in self.garages]
        return Draft("full", [north, south], depths)

    def _axial(self) -> Draft:
        public, private = self._chunks()
        depths = [self._depth(), self._depth()]
        strips: list[list[Column]] = [[], []]
        self._fill(strips, depths, private)
        side = self.stream.below(2)
        strips[side].extend(public[::-1] if self.stream.chance(0.8) else public)
        lengths = [self._length(strip, depth) for strip, depth in zip(strips, depths, strict=True)]
        for _ in range(len(strips[side])):
            if lengths[side] - lengths[1 - side] < 3000:
                break
            strips[1 - side].append(strips[side].pop(0))
            lengths = [self._length(strip, depth) for strip, depth in zip(strips, depths, strict=True)]
        return Draft("axial", strips, depths, self.entries[0] if self.entries else None)

    def _ranch(self) -> Draft:
        public, private = self._chunks()
        north, south = self._depth(), self._depth()
        street = self._deep() if self.garages else self._depth((3600, 5250))
        strips: list[list[Column]] = [[], [], [], self._front_of_ranch()]
        depths = [north + south + 1300 - street, street, north, south]
        self._fill(strips[2:], depths[2:], private)
        if self._entry():
            strips[3].sort(key=lambda column: column[0] not in self.entries)
        behind = self._either(list(public))
        cut = self._cut(behind, depths[:2])
        strips[0], strips[1] = behind[:cut], [(room,) for room in self.garages] + behind[cut:]
        return Draft("ranch", strips, depths)

    def _front_of_ranch(self) -> Chunk:
        return self._entry()

    def _cut(self, public: Chunk, depths: Sequence[int]) -> int:
        """Finds where to part the public rooms so that both rows are about as long."""
        cars = [(room,) for room in self.garages]

        def uneven(cut: int) -> float:
            return abs(self._length(public[:cut], depths[0]) - self._length(cars + public[cut:], depths[1])) * self.stream.uniform(0.8, 1.2)

        return min(range(1, max(2, len(public))), key=uneven)

    def _rows(self) -> Draft:
        public, private = self._chunks()
        depths = [self._depth(), self._deep()]
        north: list[Column] = []
        south: list[Column] = self._front(private)
        cut = self.stream.below(len(public) + 1)
        south = self._either(south + public[:cut])
        north = self._either(public[cut:])
        self._fill((north, south), depths, private)
        south[:0] = [(room,) for room in self.garages]
        return Draft("rows", [north, south], depths)


def moved(draft: Draft, stream: Stream) -> Draft:
    """Returns a draft with one thing changed: columns or strips swapped, a stack turned, a column moved, a depth changed."""
    new = draft.copy()
    strips = new.strips
    places = [(s, c) for s, strip in enumerate(strips) for c in range(len(strip))]
    which = stream.below(10)
    if which < 4:
        (s, c), (t, d) = stream.pick(places), stream.pick(places)
        strips[s][c], strips[t][d] = strips[t][d], strips[s][c]
    elif which < 6:
        s, c = stream.pick(places)
        if len(strips[s]) > 1:
            column = strips[s].pop(c)
            strip = stream.pick(strips)
            strip.insert(stream.below(len(strip) + 1), column)
    elif which == 6:
        s, c = stream.pick(places)
        strips[s][c] = strips[s][c][::-1]
    elif which == 7:
        k = stream.below(len(strips))
        strips[k].reverse()
    elif which == 8 and len(strips) == 2:
        strips.reverse()
        new.depths.reverse()
    else:
        k = stream.below(len(new.depths))
        new.depths[k] += stream.pick(STEPS)
    return new
