"""Where in the walls the doors, passages, the front door and garage doors stand, and how their leaves swing.

Comes in: a layout, types, the door tree. Goes out: `Cut`s on the lattice. May import: the ground floor, catalogs.
No leaf sweeps another leaf or the square of another door; squares of different doors in a furnished room stay apart
where the walls allow.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from itertools import takewhile
from math import inf
from typing import Final, NamedTuple

from catalogs.access_profiles import AccessProfile
from catalogs.schema import RoomType
from solver.floorplan.fitness import CAR_DOOR_MM, cars_of
from solver.floorplan.tiling import JAMB_MM, LEAF_MM, Joint, Layout
from solver.geometry import OPPOSITE, Rect, strip, to_mm

WIDE_MM: Final = 1200
"""Width of a passage where two hallways meet or the shared wall is at least WIDE_WALL_MM."""
WIDE_WALL_MM: Final = 3000
"""Shared wall from which a passage is wide: what is left takes a sofa's end. Our choice."""
STEP_MM: Final = 100
"""Distance of the places tried along a wall."""
SQUARE_MM: Final = 900
"""Greatest depth of the square that stays free at a door."""
COLLISION: Final = 1000.0
"""Score of a leaf that meets a leaf or another door's square, or of two openings in one place."""
CROWDED: Final = 10.0
"""Score of two doors' squares that overlap in a furnished room."""
CORNERED: Final = 20.0
"""Score of a door with less wall beside its latch than is asked for in its rooms."""
EJECTIONS: Final = 3
"""How many doors in a row may give way to one another in a house too small for doors in the middle of walls."""
TRIES: Final = 2000
"""Places tried in all for them: a count, so that the same request always ends the same way."""
SHIFTED: Final = 0.5
"""Score of a place other than the middle."""
FACING_MM: Final = 500
"""Doors whose middles are closer along a hallway face each other."""
FACES_MM: Final = 1000
"""So far a way from the corner is as awkward as that."""


class Cut(NamedTuple):
    """An opening on the lattice, named by kind and number when written.

    `room` and `wall` say where it is; `other` is the room on the other side, None for outside. `centre` is its middle
    along x (walls north and south) or z, mm in the house. `leaf` is the room whose floor a door's leaf sweeps; None: it
    sweeps none of the house's floor.
    """

    id: str
    kind: str
    room: int
    wall: str
    other: int | None
    centre: int
    width: int
    leaf: int | None = None
    main: bool = False

    @property
    def ends(self) -> tuple[int, int]:
        """The opening's two ends along its wall, mm."""
        return self.centre - self.width // 2, self.centre + self.width // 2

    def at(self, centre: int) -> Cut:
        """Returns the same opening elsewhere in its wall."""
        return Cut(self.id, self.kind, self.room, self.wall, self.other, centre, self.width, self.leaf, self.main)

    def wall_of(self, room: int) -> str:
        """Returns the wall as that room sees it."""
        return self.wall if room == self.room else OPPOSITE[self.wall]

    @property
    def sides(self) -> tuple[int, ...]:
        """The rooms it opens on."""
        return (self.room,) if self.other is None else (self.room, self.other)


class OpeningSide(NamedTuple):
    """An opening as one of its rooms sees it: its wall there, its ends, the square that stays free (None: a window)."""

    cut: Cut
    wall: str
    low: int
    high: int
    square: Rect | None


class Doorways:
    """The openings placed so far, by room."""

    def __init__(
        self,
        layout: Layout,
        types: Sequence[str],
        rooms: Mapping[str, RoomType],
        cuts: Sequence[Cut] = (),
        profile: AccessProfile | None = None,
    ) -> None:
        self.layout, self.types, self.rooms, self.profile = layout, types, rooms, profile
        self.leaf_mm, self.entrance_mm = (max(LEAF_MM, to_mm(profile.leaf(main))) if profile else LEAF_MM for main in (False, True))
        self.latches = [profile.latch_behind(name) if profile else 0.0 for name in types]
        self.jamb = layout.walls.least_jamb if any(self.latches) else layout.walls.jamb
        self.cuts: list[Cut] = []
        self._by_room: dict[int, list[OpeningSide]] = {}
        for cut in cuts:
            self.add(cut)

    def add(self, cut: Cut) -> None:
        """Adds an opening as it is."""
        self.cuts.append(cut)
        for room in cut.sides:
            self._by_room.setdefault(room, []).append(self.side(cut, room))

    def remove(self, cut: Cut) -> None:
        """Takes an opening out again."""
        self.cuts.remove(cut)
        for room in cut.sides:
            self._by_room[room] = [side for side in self._by_room[room] if side.cut is not cut]

    def replace(self, cut: Cut, by: Cut) -> None:
        """Puts an opening in the place of another one of the same rooms, in the order of openings too."""
        self.cuts[self.cuts.index(cut)] = by
        for room in cut.sides:
            self._by_room[room] = [self.side(by, room) if side.cut is cut else side for side in self._by_room[room]]

    def sides(self, room: int) -> Sequence[OpeningSide]:
        """Returns the openings of a room as it sees them."""
        return self._by_room.get(room, ())

    def faced(self, cut: Cut) -> int:
        """Returns how many openings that one walks through an opening faces across the rooms that its leaf is not in."""
        if cut.kind not in {"door", "passage"}:
            return 0
        seen = [(side, cut.wall_of(room)) for room in cut.sides if room != cut.leaf for side in self.sides(room)]
        across = [side for side, wall in seen if side.square is not None and side.wall == OPPOSITE[wall]]
        return sum(abs(side.cut.centre - cut.centre) < FACING_MM for side in across)

    def restore(self, cuts: Sequence[Cut]) -> None:
        """Goes back to the openings there were."""
        for cut in [cut for cut in self.cuts if cut not in cuts]:
            self.remove(cut)
        for cut in [cut for cut in cuts if cut not in self.cuts]:
            self.add(cut)

    def colliding(self, cut: Cut) -> list[Cut]:
        """Returns the openings that this one cannot stand together with."""
        scores: dict[Cut, float] = {}
        for other, score in self._meetings(cut):
            scores[other] = scores.get(other, 0.0) + score
        return [other for other, score in scores.items() if score >= COLLISION]

    def plan_of(self, room: int) -> RoomType:
        """Returns the type of a room."""
        return self.rooms[self.types[room]]

    def swings_wrongly(self, leaf: int | None) -> bool:
        """Tells whether a leaf that sweeps a room's floor should swing out of it."""
        return leaf is not None and self.profile is not None and self.profile.swings_out(self.types[leaf])

    def side(self, cut: Cut, room: int) -> OpeningSide:
        """Returns an opening as one of its rooms sees it."""
        wall, half = cut.wall_of(room), cut.width // 2
        low, high = cut.centre - half, cut.centre + half
        squared = cut.kind in {"door", "passage"}
        return OpeningSide(cut, wall, low, high, _square(self.layout.rooms[room], wall, low, high) if squared else None)

    def score(self, cut: Cut) -> float:
        """Scores an opening against those placed: 0 is free of all, COLLISION and more cannot be."""
        return CORNERED * self._is_cornered(cut) + sum([score for _, score in self._meetings(cut)])

    def _is_cornered(self, cut: Cut) -> bool:
        """Tells whether neither end of a door has the wall beside it that a latch asks for, as far as its rooms' next walls."""
        ends = list[list[bool]]()
        for room in cut.sides if cut.kind == "door" else ():
            rect, asked = self.layout.rooms[room], self.latches[room]
            low, high = (rect.x0, rect.x1) if cut.wall in ("north", "south") else (rect.z0, rect.z1)
            half = self.layout.walls.half
            ends.append([not asked or free - half >= to_mm(asked) for free in (cut.ends[0] - low, high - cut.ends[1])])
        return bool(ends) and not any(map(all, zip(*ends, strict=True)))

    def _meetings(self, cut: Cut) -> Iterator[tuple[Cut, float]]:
        """Yields the other openings of a cut's rooms, each with the score of the two in that room."""
        for room in cut.sides:
            side = self.side(cut, room)
            for other in self._by_room.get(room, ()):
                if other.cut.id != cut.id:
                    yield other.cut, self._meeting(side, other, room)

    def _meeting(self, side: OpeningSide, other: OpeningSide, room: int) -> float:
        if side.wall == other.wall and max(side.low, other.low) < min(side.high, other.high) + JAMB_MM:
            return COLLISION
        one, two = side.square, other.square
        if one is None or two is None or not (one[0] < two[2] and two[0] < one[2] and one[1] < two[3] and two[1] < one[3]):
            return 0.0
        if room in (side.cut.leaf, other.cut.leaf):
            return COLLISION
        return 0.0 if self.types[room] == "hallway" else CROWDED

    def free(self, room: int, wall: str, low: int, high: int) -> bool:
        """Tells whether a stretch of an outside wall holds no opening."""
        sides = self._by_room.get(room, ())
        return not any(side.wall == wall and max(low, side.low) < min(high, side.high) + JAMB_MM for side in sides)

    def best_outside(self, cut: Cut) -> tuple[float, Cut]:
        """Returns the best place of an opening to the outside in its wall, the longest stretch first, with its score."""
        stretches = sorted(self.layout.openable[cut.room].get(cut.wall, ()), key=lambda stretch: stretch[0] - stretch[1])
        return min((self.best(cut, stretch) for stretch in stretches), key=lambda offer: offer[0], default=(inf, cut))

    def best(self, cut: Cut, stretch: tuple[int, int]) -> tuple[float, Cut]:
        """Returns the best place of an opening in a stretch of wall, with its score."""
        best = (inf, cut)
        for k, centre in enumerate(places(cut.width, stretch, self)):
            placed = cut.at(centre)
            score = self.score(placed) + SHIFTED * (k > 0)
            if score < best[0]:
                best = (score, placed)
            if score <= SHIFTED:
                break
        return best


def _square(rect: Rect, wall: str, low: int, high: int) -> Rect:
    """Returns what stays free at a door: as deep as it is wide, at most SQUARE_MM."""
    return strip(rect, wall, (low, high), min(high - low, SQUARE_MM))


def places(width: int, stretch: tuple[int, int], doorways: Doorways) -> Iterator[int]:
    """Yields the centres an opening may have in a stretch of wall: the middle, both ends, then every STEP_MM."""
    jamb = min(doorways.jamb, (stretch[1] - stretch[0] - width) // 2)
    if jamb < doorways.layout.walls.least_jamb:
        return
    first, last = stretch[0] + jamb + width // 2, stretch[1] - jamb - width // 2
    middle = (first + last) // 2
    yield middle
    for centre in dict.fromkeys((first, last, *range(first + STEP_MM, last, STEP_MM))):
        if centre != middle:
            yield centre


def place_entrance(doorways: Doorways, room: int, wall: str) -> None:
    """Places the main entrance; its leaf opens inwards."""
    cut = Cut("door_0", "door", room, wall, None, 0, doorways.entrance_mm, leaf=room, main=True)
    doorways.add(doorways.best_outside(cut)[1])


def place_doors(doorways: Doorways, tree: Sequence[tuple[Joint, int]]) -> None:
    """Places the doors and passages of the tree, the shortest shared wall first."""
    walls = {(joint.a, joint.b): (joint.low, joint.high) for joint, _ in tree}
    for number, (joint, entered) in enumerate(sorted(tree, key=lambda item: (item[0].length, item[0])), start=1):
        forms = tuple(_forms(doorways, joint, entered, number))
        for strict in (True, False):
            tried = list(takewhile(lambda form: not doorways.swings_wrongly(form.leaf), forms)) if strict else list(forms)
            offers: list[tuple[float, Cut]] = []
            for form in tried:
                offers.append(doorways.best(form, (joint.low, joint.high)))
                if offers[-1][0] < COLLISION:
                    break
            if offers and min(offer[0] for offer in offers) < COLLISION:
                doorways.add(min(offers, key=lambda offer: offer[0])[1])
                break
            if any(_Shuffle(doorways, walls, strict).add(form) for form in tried):
                break
        else:
            doorways.add(min(offers, key=lambda offer: offer[0])[1])


def move_to_corners(doorways: Doorways, tree: Sequence[tuple[Joint, int]], entrance: int) -> None:
    """Moves doors of habitable rooms that are no passages to a corner of theirs, and away from doors that they face.

    To no corner move those of the room where one enters: its walls stay whole for coats.
    """
    stretches = {(joint.a, joint.b): (joint.low, joint.high) for joint, _ in tree}
    for cut in tuple(doorways.cuts):
        if cut.kind != "door" or cut.leaf is None or cut.other is None:
            continue
        plan = doorways.plan_of(cut.leaf).plan
        if not plan.habitable or plan.passage:
            continue
        moved = (cut.at(centre) for centre in places(cut.width, stretches[cut.room, cut.other], doorways))
        free = [one for one in moved if doorways.score(one) <= doorways.score(cut)]
        doorways.replace(cut, min((cut, *free), key=partial(_awkwardness, doorways, cut.leaf, entrance in cut.sides)))


def _awkwardness(doorways: Doorways, room: int, entered: bool, cut: Cut) -> int:
    """Returns how far a door is from the corner of its leaf's room, mm, unless one enters there, and more for each that it faces."""
    rect = doorways.layout.rooms[room]
    low, high = (rect.x0, rect.x1) if cut.wall in ("north", "south") else (rect.z0, rect.z1)
    return (0 if entered else min(cut.ends[0] - low, high - cut.ends[1])) + FACES_MM * doorways.faced(cut)


def _forms(doorways: Doorways, joint: Joint, entered: int, number: int) -> Iterator[Cut]:
    """Yields what may be cut into a wall: a leaf into the room entered, the other way, and no leaf at all.

    Between two rooms of passages it is a passage from the start.
    """
    if not all(doorways.plan_of(room).plan.passage for room in (joint.a, joint.b)):
        for leaf in _swings(doorways, joint, entered):
            yield Cut(f"door_{number}", "door", joint.a, joint.wall, joint.b, 0, doorways.leaf_mm, leaf=leaf)
    yield _passage(doorways, joint, number)
    yield _passage(doorways, joint, number)._replace(width=doorways.leaf_mm)


class _Shuffle:
    """Adds an opening wherever the few others in its way can be added elsewhere in the same manner."""

    def __init__(self, doorways: Doorways, walls: Mapping[tuple[int, int], tuple[int, int]], strict: bool) -> None:
        self.doorways, self.walls, self.tries, self.strict = doorways, walls, TRIES, strict

    def add(self, cut: Cut, depth: int = EJECTIONS) -> bool:
        """Adds the opening; False, and nothing changed, where none of a bounded number of tries works."""
        for moved in self._variants(cut):
            self.tries -= 1
            if self.tries < 0:
                return False
            ejected = self.doorways.colliding(moved)
            if len(ejected) > min(depth, 2) or any(other.kind not in ("door", "passage") for other in ejected):
                continue
            before = list(self.doorways.cuts)
            for other in ejected:
                self.doorways.remove(other)
            self.doorways.add(moved)
            if all(self.add(other, depth - 1) for other in ejected):
                return True
            self.doorways.restore(before)
        return False

    def _variants(self, cut: Cut) -> Iterator[Cut]:
        """Yields an opening everywhere in its wall: as it is, with its leaf the other way, and at last, if not strict, without a leaf."""
        outside = cut.other is None
        stretches = self.doorways.layout.openable[cut.room][cut.wall] if outside else (self.walls[min(cut.sides), max(cut.sides)],)
        forms = [cut]
        if cut.kind == "door":
            leaves = [leaf for leaf in (cut.room, cut.other) if not (self.strict and self.doorways.swings_wrongly(leaf))]
            forms += [cut._replace(leaf=leaf) for leaf in leaves if leaf != cut.leaf]
        if cut.kind == "door" and cut.other is not None and not self.strict:
            forms.append(cut._replace(id=cut.id.replace("door", "passage"), kind="passage", leaf=None))
        return (form.at(centre) for form in forms for stretch in stretches for centre in places(cut.width, stretch, self.doorways))


def _swings(doorways: Doorways, joint: Joint, entered: int) -> list[int]:
    """The rooms the leaf may open into: the one entered first, hallways and their like last, last of all what it must swing out of."""
    order, profile = [entered, joint.other(entered)], doorways.profile
    out = {room for room in order if profile is not None and profile.swings_out(doorways.types[room])}
    return sorted(order, key=lambda room: (room in out, not doorways.plan_of(room).plan.swings_in))


def _passage(doorways: Doorways, joint: Joint, number: int) -> Cut:
    halls = doorways.types[joint.a] == doorways.types[joint.b] == "hallway"
    wide = joint.length >= (doorways.layout.walls.hallway if halls else WIDE_WALL_MM)
    width = max(WIDE_MM * wide, doorways.leaf_mm)
    return Cut(f"passage_{number}", "passage", joint.a, joint.wall, joint.b, 0, width)


def place_garage_doors(doorways: Doorways) -> tuple[str, ...]:
    """Gives every room for cars a door to the street: as many cars wide as the wall takes, the south wall first.

    Returns:
        A note for each that has none.
    """
    notes = []
    for room, rect in enumerate(doorways.layout.rooms):
        if doorways.plan_of(room).plan.garage_door:
            cut = _garage_door(doorways, room, rect)
            if cut is None:
                notes.append(f"{doorways.types[room]}_{room}: no outside wall has {CAR_DOOR_MM / 1000} m for a garage door")
            else:
                doorways.add(cut)
    return tuple(notes)


def _garage_door(doorways: Doorways, room: int, rect: Rect) -> Cut | None:
    walls = sorted(doorways.layout.openable[room], key=lambda w: (w != "south", rect.along(w)[0] - rect.along(w)[1]))
    for cars in range(cars_of(doorways.plan_of(room)), 0, -1):
        for wall in walls:
            cut = Cut(f"garage_door_{room}", "garage_door", room, wall, None, 0, CAR_DOOR_MM * cars)
            score, placed = doorways.best_outside(cut)
            if score < COLLISION:
                return placed
    return None
