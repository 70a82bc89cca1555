"""Where in the walls the doors, passages, the front door and garage doors stand, and how their leaves swing.

Comes in: a layout, types, the door tree. Goes out: `Cut`s on the lattice. May import: the ground floor, catalogs.
No leaf sweeps another leaf or the square of another door; squares of different doors in a furnished room stay apart
where the walls allow.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

from catalogs.schema import RoomType
from solver.floorplan.fitness import CAR_DOOR_MM, cars_of
from solver.floorplan.layout import HALLWAY_MM, Joint, Layout, exterior_sides
from solver.geometry import OPPOSITE, Rect, strip

LEAF_MM: Final = 900
"""Width of a door (the predecessor's 6.1)."""
WIDE_MM: Final = 1200
"""Width of a passage where two hallways meet or the shared wall is at least WIDE_WALL_MM."""
WIDE_WALL_MM: Final = 3000
"""Shared wall from which a passage is wide: what is left takes a sofa's end. Our choice."""
JAMB_MM: Final = 100
"""Least wall between an opening and the end of its stretch of wall (floorplan.md: ends + 0.55 m)."""
STEP_MM: Final = 100
"""Distance of the places tried along a wall (floorplan.md)."""
SQUARE_MM: Final = 900
"""Greatest depth of the square that stays free at a door (contract)."""
COLLISION: Final = 1000.0
"""Score of a leaf that meets a leaf or another door's square, or of two openings in one place."""
CROWDED: Final = 10.0
"""Score of two doors' squares that overlap in a furnished room (floorplan.md)."""
SHIFTED: Final = 0.5
"""Score of a place other than the middle (floorplan.md)."""


@dataclass(frozen=True)
class Cut:
    """An opening on the lattice, named by kind and number when written.

    `room` and `wall` say where it is; `other` is the room on the other side, None for outside. `centre` is its middle
    along x (walls north and south) or z, mm in the house. `leaf` is the room whose floor the leaf sweeps, None: no leaf.
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

    def wall_of(self, room: int) -> str:
        """Returns the wall as that room sees it."""
        return self.wall if room == self.room else OPPOSITE[self.wall]

    def square(self, room: int, rect: Rect) -> Rect:
        """Returns what stays free in that room: as deep as the opening is wide, at most SQUARE_MM."""
        return strip(rect, self.wall_of(room), self.ends, min(self.width, SQUARE_MM))

    @property
    def sides(self) -> tuple[int, ...]:
        """The rooms it opens on."""
        return (self.room,) if self.other is None else (self.room, self.other)


class Doorways:
    """The openings placed so far, by room."""

    def __init__(self, layout: Layout, types: Sequence[str], rooms: Mapping[str, RoomType], cuts: Sequence[Cut] = ()) -> None:
        self.layout, self.types, self.rooms = layout, types, rooms
        self.cuts: list[Cut] = []
        self.by_room: dict[int, list[Cut]] = {}
        for cut in cuts:
            self.add(cut)

    def add(self, cut: Cut) -> None:
        """Adds an opening as it is."""
        self.cuts.append(cut)
        for room in cut.sides:
            self.by_room.setdefault(room, []).append(cut)

    def plan_of(self, room: int) -> RoomType:
        """Returns the type of a room."""
        return self.rooms[self.types[room]]

    def score(self, cut: Cut) -> float:
        """Scores an opening against those placed: 0 is free of all, COLLISION and more cannot be."""
        return sum(self._score_in(cut, room) for room in cut.sides)

    def _score_in(self, cut: Cut, room: int) -> float:
        rect, total = self.layout.rooms[room], 0.0
        for other in self.by_room.get(room, ()):
            if other.id == cut.id:
                continue
            low, high = max(cut.ends[0], other.ends[0]), min(cut.ends[1], other.ends[1])
            if cut.wall_of(room) == other.wall_of(room) and low < high + JAMB_MM:
                total += COLLISION
            elif "window" not in (cut.kind, other.kind) and "garage_door" not in (cut.kind, other.kind):
                total += self._meeting(cut, other, room, rect)
        return total

    def _meeting(self, cut: Cut, other: Cut, room: int, rect: Rect) -> float:
        if not cut.square(room, rect).overlaps(other.square(room, rect)):
            return 0.0
        if room in (cut.leaf, other.leaf):
            return COLLISION
        return 0.0 if self.types[room] == "hallway" else CROWDED

    def best(self, cut: Cut, stretch: tuple[int, int]) -> tuple[float, Cut]:
        """Returns the best place of an opening in a stretch of wall, with its score."""
        offers = ((SHIFTED * (k > 0) + self.score(placed), k, placed) for k, placed in enumerate(places(cut, stretch)))
        best: tuple[float, int, Cut] | None = None
        for offer in offers:
            if best is None or offer[:2] < best[:2]:
                best = offer
            if offer[0] <= SHIFTED:
                break
        return (best[0], best[2]) if best else (2 * COLLISION, cut)


def places(cut: Cut, stretch: tuple[int, int]) -> Iterator[Cut]:
    """Yields an opening at every place of a stretch of wall: the middle, both ends, then every STEP_MM."""
    jamb = min(JAMB_MM, (stretch[1] - stretch[0] - cut.width) // 2)
    if jamb < 0:
        return
    first, last = stretch[0] + jamb + cut.width // 2, stretch[1] - jamb - cut.width // 2
    seen = set()
    for centre in ((first + last) // 2, first, last, *range(first + STEP_MM, last, STEP_MM)):
        if centre not in seen:
            seen.add(centre)
            yield replace(cut, centre=centre)


def place_entrance(doorways: Doorways, room: int, wall: str) -> None:
    """Places the main entrance; its leaf opens inwards."""
    cut = Cut("door_0", "door", room, wall, None, 0, LEAF_MM, leaf=room, main=True)
    doorways.add(doorways.best(cut, doorways.layout.rooms[room].along(wall))[1])


def place_doors(doorways: Doorways, tree: Sequence[tuple[Joint, int]]) -> None:
    """Places the doors and passages of the tree, the shortest shared wall first."""
    for number, (joint, entered) in enumerate(sorted(tree, key=lambda item: (item[0].length, item[0])), start=1):
        doorways.add(_door(doorways, joint, entered, number))


def _door(doorways: Doorways, joint: Joint, entered: int, number: int) -> Cut:
    """Places one door; where no leaf has room whichever way it swings, a passage."""
    stretch = (joint.low, joint.high)
    both = [doorways.plan_of(room).plan.passage for room in (joint.a, joint.b)]
    if not all(both):
        for leaf in _swings(doorways, joint, entered):
            cut = Cut(f"door_{number}", "door", joint.a, joint.wall, joint.b, 0, LEAF_MM, leaf=leaf)
            score, placed = doorways.best(cut, stretch)
            if score < COLLISION:
                return placed
    return doorways.best(_passage(doorways, joint, number), stretch)[1]


def _swings(doorways: Doorways, joint: Joint, entered: int) -> list[int]:
    """The rooms the leaf may open into: the one entered first, hallways and their like last."""
    order = [entered, joint.other(entered)]
    return sorted(order, key=lambda room: not doorways.plan_of(room).plan.swings_in)


def _passage(doorways: Doorways, joint: Joint, number: int) -> Cut:
    halls = doorways.types[joint.a] == doorways.types[joint.b] == "hallway"
    wide = joint.length >= (HALLWAY_MM if halls else WIDE_WALL_MM)
    return Cut(f"passage_{number}", "passage", joint.a, joint.wall, joint.b, 0, WIDE_MM if wide else LEAF_MM)


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
    walls = sorted(exterior_sides(rect, doorways.layout.outline), key=lambda w: (w != "south", rect.along(w)[0] - rect.along(w)[1]))
    for cars in range(cars_of(doorways.plan_of(room)), 0, -1):
        for wall in walls:
            cut = Cut(f"garage_door_{room}", "garage_door", room, wall, None, 0, CAR_DOOR_MM * cars)
            score, placed = doorways.best(cut, rect.along(wall))
            if score < COLLISION:
                return placed
    return None
