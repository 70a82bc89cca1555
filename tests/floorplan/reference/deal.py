"""Deals the rooms of a programme to the strips of a skeleton, and changes a deal a little.

Comes in: planned rooms, a kind, a stream. Goes out: `Draft`s. May import: the ground floor. Rooms that belong together are dealt
together: a bedroom with its own bathroom, the bathroom with what shares its pipes, kitchen, dining and living room.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from solver.floorplan.programme.planned_rooms import PlannedRoom, RoomSize
from solver.streams import Stream
from tests.floorplan.reference.asked import hallway
from tests.floorplan.reference.drafts import Column, Draft
from tests.floorplan.reference.widths import width_of

DEPTHS: Final = (3300, 4350)
"""Depth of a strip of rooms one deep, mm: bedrooms of 11.5 m2 are then 2.7 to 3.5 m wide."""
DEEP: Final = (5400, 6150)
"""Depth of a strip that cars stand in, mm."""
STEPS: Final = (-300, -150, 150, 300)
"""What a move adds to a strip's depth, mm."""
STEP_MM: Final = 150
PAIRED: Final = 0.55
"""How often a small wet room lies behind another one, and
an own bathroom behind a small wet room next to its bedroom."""
BESIDE: Final = 0.8
"""How often it else lies beside the bedroom, not behind it."""
AT_KITCHEN: Final = 0.85
AT_SUITE: Final = 0.85
"""How often a small wet room is dealt beside the kitchen, and another at the wet end of a suite."""
TURNS: Final = 12
"""Divided without rest by the numbers of places that wings may have, mostly."""
Chunk = list[Column]


class Dealer:
    """Deals one programme's rooms."""

    def __init__(self, planned: Sequence[PlannedRoom], stream: Stream) -> None:
        self.planned, self.stream = planned, stream
        every = range(len(planned))
        self.entries = [i for i in every if planned[i].entry]
        self.garages = [i for i in every if planned[i].garage]
        self.public = [i for i in every if planned[i].public]
        self.small = [i for i in every if is_small_wet(planned[i]) and planned[i].owner is None]
        self.owned = [(i, one.owner) for i, one in enumerate(planned) if one.owner is not None]
        self.others = [i for i in every if not (planned[i].kind.plan.way_through or is_small_wet(planned[i]) or planned[i].garage)]
        self.areas = [one.size.typical for one in planned]

    def deal(self, kind: str) -> Draft:
        """Deals a draft of a kind."""
        deals: dict[str, Callable[[], Draft]] = {"rows": self._rows, "full": self._full, "ranch": self._ranch, "axial": self._axial}
        return deals[kind]()

    def _depth(self, bounds: tuple[int, int] = DEPTHS) -> int:
        return bounds[0] + STEP_MM * self.stream.below((bounds[1] - bounds[0]) // STEP_MM + 1)

    def _deep(self) -> int:
        return self._depth(DEEP if self.garages else DEPTHS)

    def _chunks(self, shallow: bool = True, without: Sequence[int] = ()) -> tuple[Chunk, list[Chunk]]:
        """Returns the public rooms, with what is dealt beside them, and the private rooms in chunks.

        In a strip that is not `shallow` nothing small stands beside the kitchen: it would be too slim. Rooms `without` are
        dealt elsewhere.
        """
        stream, private = self.stream, list[Chunk]()
        small = [room for room in self.small if room not in without]
        stream.shuffle(small)
        baths = [i for i in small if self._is_bath(i)]
        others = [i for i in small if i not in baths]
        owners = {owner: bath for bath, owner in self.owned}
        public: Chunk = [(room,) for room in self._public_order()]
        if shallow and stream.chance(AT_KITCHEN):
            self._beside_kitchen(public, others if others and (not baths or stream.chance(0.7)) else baths)
        suites = [self._suite(room, owners[room], baths, others) for room in self.others if room in owners]
        private += [[(room,)] for room in self.others if room not in owners]
        singles: list[Column] = []
        while others and baths and stream.chance(PAIRED):
            singles.append((baths.pop(), others.pop()))
        singles += [(room,) for room in (*others, *baths)]
        wet: Chunk = []
        for column in singles:
            if suites and stream.chance(AT_SUITE):
                self._join(stream.pick(suites), column)
            else:
                wet.append(column)
        private += suites
        if wet:
            private.append(wet)
        stream.shuffle(private)
        return public, private

    def _beside_kitchen(self, public: Chunk, rooms: list[int]) -> None:
        """Moves one of the rooms beside the kitchen, not between it and the dining room."""
        kitchens = [k for k, column in enumerate(public) if self.planned[column[0]].kind.plan.wet]
        if kitchens and rooms:
            public.insert(len(public) if kitchens[-1] == len(public) - 1 else kitchens[-1], (rooms.pop(),))

    def _join(self, suite: Chunk, column: Column) -> None:
        """Adds a small wet room at the wet end of a suite."""
        if is_small_wet(self.planned[suite[0][-1]]):
            suite.insert(0, column)
        else:
            suite.append(column)

    def _is_bath(self, room: int) -> bool:
        return any("toilet" in line for line in self.planned[room].kind.requires)

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
        living = [i for i in self.public if not self.planned[i].kind.plan.wet]
        kitchens = [i for i in self.public if self.planned[i].kind.plan.wet]
        living.sort(key=lambda i: (-self.areas[i], i))
        at = len(living) if self.stream.chance(0.75) else min(1, len(living))
        return living[:at] + kitchens + living[at:]

    def _stack(self, column: Column) -> tuple[RoomSize, ...]:
        return tuple([self.planned[room].size for room in column])

    def _length(self, strip: Sequence[Column], depth: int) -> int:
        return sum(self.areas[room] for column in strip for room in column) // depth

    def _fill(self, strips: Sequence[list[Column]], depths: Sequence[int], chunks: Sequence[Chunk]) -> None:
        """Adds chunks to either end of the strip that is the shorter one, mostly."""
        for chunk in sorted(chunks, key=lambda chunk: -sum(self.areas[i] for column in chunk for i in column)):
            lengths = [self._length(strip, depth) * self.stream.uniform(0.9, 1.1) for strip, depth in zip(strips, depths, strict=True)]
            fitting = [k for k, depth in enumerate(depths) if not any(width_of(self._stack(column), depth).misses for column in chunk)]
            shorter = strips[min(fitting or range(len(strips)), key=lengths.__getitem__)]
            if self.stream.chance(0.5):
                shorter[:0] = chunk
            else:
                shorter.extend(chunk)

    def _entry(self) -> Chunk:
        """The entry as a column; in a strip for cars something small lies between it and the hallway."""
        return [(self.entries[0],)] if self.entries else []

    def _front(self) -> Chunk:
        """The entry as a column; in a strip for cars, and now and then elsewhere, something small lies behind it."""
        entry = self._entry()
        if not entry or not self.small or not (self.garages or self.stream.chance(0.15)):
            return entry
        dry = [room for room in self.small if not self._is_bath(room)]
        return [((dry or self.small)[-1], entry[0][0])]

    def _dealt(self) -> tuple[Chunk, Chunk, list[Chunk]]:
        """Returns the entry's column, the public rooms and the private ones, for strips along the street."""
        front = self._front()
        public, private = self._chunks(not self.garages, [room for column in front for room in column])
        return front, public, private

    def _along_street(self, front: Chunk, public: Chunk) -> Chunk:
        """The entry beside the living room, or what lies behind it beside the kitchen, or between the two."""
        if not front or len(front[0]) == 1 or self.stream.chance(0.3):
            return front + public
        cut = self.stream.below(2)
        return public[:cut] + front + public[cut:][::-1]

    def _full(self) -> Draft:
        south, public, private = self._dealt()
        depths = [self._depth(), self._deep()]
        north: list[Column] = []
        if self.garages or self.stream.chance(0.65):
            south = self._either(self._along_street(south, public))
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
        across = strips[1 - side]
        if across and self._sleeps(across[-1]) and not self._sleeps(across[0]):
            across.reverse()
        strips[side].extend(public[::-1] if self.stream.chance(0.8) else public)
        lengths = [self._length(strip, depth) for strip, depth in zip(strips, depths, strict=True)]
        for _ in range(len(strips[side])):
            if lengths[side] - lengths[1 - side] < 3000:
                break
            strips[1 - side].append(strips[side].pop(0))
            lengths = [self._length(strip, depth) for strip, depth in zip(strips, depths, strict=True)]
        return Draft("axial", strips, depths, self.entries[0] if self.entries else None)

    def _sleeps(self, column: Column) -> bool:
        """Tells whether the room of a column that lies at the hallway is slept or worked in: not beside the entry."""
        return not is_small_wet(self.planned[column[0]])

    def _ranch(self) -> Draft:
        public, private = self._chunks()
        north, south = self._depth(), self._depth()
        street = self._deep() if self.garages else self._depth((3600, 5250))
        strips: list[list[Column]] = [[], [], [], self._front_of_ranch()]
        depths = [north + south + hallway() - street, street, north, south]
        self._fill(strips[2:], depths[2:], private)
        if self._entry():
            strips[3].sort(key=lambda column: column[0] not in self.entries)
        behind = public[::-1] if self.stream.chance(0.8) else list(public)
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
        front, public, private = self._dealt()
        depths = [self._depth(), self._deep()]
        cut = self.stream.below(len(public) + 1)
        south, north = self._either(front + public[:cut]), self._either(public[cut:])
        self._fill((north, south), depths, private)
        south[:0] = [(room,) for room in self.garages]
        return Draft("rows", [north, south], depths)


def is_small_wet(room: PlannedRoom) -> bool:
    """Whether it is a bathroom, say, in which nobody lives."""
    return room.kind.plan.wet and not room.kind.plan.habitable


def moved(draft: Draft, stream: Stream) -> Draft:
    """Returns a draft with one thing changed: columns or strips swapped, a stack turned, a column moved, a depth changed."""
    new = draft.copy()
    strips = new.strips
    places = [(s, c) for s, strip in enumerate(strips) for c in range(len(strip))]
    which = stream.below(10 if draft.bend is None else 12)
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
    elif which >= 10:
        new.turn = stream.below(TURNS)
    else:
        k = stream.below(len(new.depths))
        new.depths[k] += stream.pick(STEPS)
    return new
