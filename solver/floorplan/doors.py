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
from solver.geometry import OPPOSITE, Rect

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


@dataclass(frozen=True)
class _Side:
    """An opening as one of its rooms sees it: its wall there, its ends, the square that stays free (None: a window)."""

    cut: Cut
    wall: str
    low: int
    high: int
    square: Rect | None


class Doorways:
    """The openings placed so far, by room."""

    def __init__(self, layout: Layout, types: Sequence[str], rooms: Mapping[str, RoomType], cuts: Sequence[Cut] = ()) -> None:
        self.layout, self.types, self.rooms = layout, types, rooms
        self.cuts: list[Cut] = []
        self._by_room: dict[int, list[_Side]] = {}
        for cut in cuts:
            self.add(cut)

    def add(self, cut: Cut) -> None:
        """Adds an opening as it is."""
        self.cuts.append(cut)
        for room in cut.sides:
            self._by_room.setdefault(room, []).append(self._side(cut, room))

    def move(self, old: Cut, new: Cut) -> None:
        """Puts an opening in the place of another of the same rooms."""
        self.cuts[self.cuts.index(old)] = new
        for room in old.sides:
            self._by_room[room] = [self._side(new, room) if side.cut is old else side for side in self._by_room[room]]

    def walkable(self, rooms: Sequence[int]) -> list[Cut]:
        """Returns the doors and passages of some rooms."""
        return list(dict.fromkeys(side.cut for room in rooms for side in self._by_room.get(room, ()) if side.square is not None))

    def plan_of(self, room: int) -> RoomType:
        """Returns the type of a room."""
        return self.rooms[self.types[room]]

    def _side(self, cut: Cut, room: int) -> _Side:
        wall, (low, high) = cut.wall_of(room), cut.ends
        squared = cut.kind in ("door", "passage")
        return _Side(cut, wall, low, high, _square(self.layout.rooms[room], wall, low, high) if squared else None)

    def score(self, cut: Cut) -> float:
        """Scores an opening against those placed: 0 is free of all, COLLISION and more cannot be."""
        return sum(self._score_in(cut, room) for room in cut.sides)

    def _score_in(self, cut: Cut, room: int) -> float:
        side, total = self._side(cut, room), 0.0
        for other in self._by_room.get(room, ()):
            if other.cut.id == cut.id:
                continue
            if side.wall == other.wall and max(side.low, other.low) < min(side.high, other.high) + JAMB_MM:
                total += COLLISION
            elif side.square is not None and other.square is not None and side.square.overlaps(other.square):
                swept = room in (cut.leaf, other.cut.leaf)
                total += COLLISION if swept else 0.0 if self.types[room] == "hallway" else CROWDED
        return total

    def free(self, room: int, wall: str, low: int, high: int) -> bool:
        """Tells whether a stretch of an outside wall holds no opening."""
        sides = self._by_room.get(room, ())
        return not any(side.wall == wall and max(low, side.low) < min(high, side.high) + JAMB_MM for side in sides)

    def best(self, cut: Cut, stretch: tuple[int, int]) -> tuple[float, Cut]:
        """Returns the best place of an opening in a stretch of wall, with its score."""
        best = (2 * COLLISION, cut)
        for k, centre in enumerate(places(cut.width, stretch)):
            placed = cut.at(centre)
            score = self.score(placed) + SHIFTED * (k > 0)
            if score < best[0]:
                best = (score, placed)
            if score <= SHIFTED:
                break
        return best


def _square(rect: Rect, wall: str, low: int, high: int) -> Rect:
    """Returns what stays free at a door: as deep as it is wide, at most SQUARE_MM."""
    deep = min(high - low, SQUARE_MM)
    if wall == "north":
        return Rect(low, rect.z0, high, rect.z0 + deep)
    if wall == "south":
        return Rect(low, rect.z1 - deep, high, rect.z1)
    if wall == "west":
        return Rect(rect.x0, low, rect.x0 + deep, high)
    return Rect(rect.x1 - deep, low, rect.x1, high)


def places(width: int, stretch: tuple[int, int]) -> Iterator[int]:
    """Yields the centres an opening may have in a stretch of wall: the middle, both ends, then every STEP_MM."""
    jamb = min(JAMB_MM, (stretch[1] - stretch[0] - width) // 2)
    if jamb < 0:
        return
    first, last = stretch[0] + jamb + width // 2, stretch[1] - jamb - width // 2
    middle = (first + last) // 2
    yield middle
    for centre in dict.fromkeys((first, last, *range(first + STEP_MM, last, STEP_MM))):
        if centre != middle:
            yield centre


def place_entrance(doorways: Doorways, room: int, wall: str) -> None:
    """Places the main entrance; its leaf opens inwards."""
    cut = Cut("door_0", "door", room, wall, None, 0, LEAF_MM, leaf=room, main=True)
    doorways.add(doorways.best(cut, doorways.layout.rooms[room].along(wall))[1])


def place_doors(doorways: Doorways, tree: Sequence[tuple[Joint, int]]) -> None:
    """Places the doors and passages of the tree, the shortest shared wall first."""
    walls = {(joint.a, joint.b): (joint.low, joint.high) for joint, _ in tree}
    for number, (joint, entered) in enumerate(sorted(tree, key=lambda item: (item[0].length, item[0])), start=1):
        offers = [doorways.best(cut, (joint.low, joint.high)) for cut in _forms(doorways, joint, entered, number)]
        fit = next((placed for score, placed in offers if score < COLLISION), None)
        if fit is None:
            fit = _make_room(doorways, joint, [placed for _, placed in offers], walls) or min(offers, key=lambda offer: offer[0])[1]
        doorways.add(fit)


def _forms(doorways: Doorways, joint: Joint, entered: int, number: int) -> Iterator[Cut]:
    """Yields what may be cut into a wall: a leaf into the room entered, the other way, and no leaf at all.

    Between two rooms of passages it is a passage from the start.
    """
    if not all(doorways.plan_of(room).plan.passage for room in (joint.a, joint.b)):
        for leaf in _swings(doorways, joint, entered):
            yield Cut(f"door_{number}", "door", joint.a, joint.wall, joint.b, 0, LEAF_MM, leaf=leaf)
    yield _passage(doorways, joint, number)
    yield replace(_passage(doorways, joint, number), width=LEAF_MM)


def _make_room(doorways: Doorways, joint: Joint, forms: Sequence[Cut], walls: Mapping[tuple[int, int], tuple[int, int]]) -> Cut | None:
    """Moves or turns one earlier door so that a new one fits; None where no single one helps."""
    for old in doorways.walkable((joint.a, joint.b)):
        stretch = doorways.layout.rooms[old.room].along(old.wall) if old.other is None else walls[min(old.sides), max(old.sides)]
        current = old
        for moved in _elsewhere(old, stretch):
            doorways.move(current, moved)
            current = moved
            if doorways.score(moved) < COLLISION:
                offers = (doorways.best(form, (joint.low, joint.high)) for form in forms)
                fit = next((placed for score, placed in offers if score < COLLISION), None)
                if fit is not None:
                    return fit
        doorways.move(current, old)
    return None


def _elsewhere(cut: Cut, stretch: tuple[int, int]) -> Iterator[Cut]:
    """Yields a door at every place of its wall, with its leaf as it is, then the other way."""
    others = [room if room != cut.leaf else None for room in cut.sides] if cut.kind == "door" else []
    leaves = [cut.leaf, *others[:1]] if cut.other is None else [cut.leaf, *(room for room in others if room is not None)]
    for leaf in leaves:
        for centre in places(cut.width, stretch):
            yield replace(cut, centre=centre, leaf=leaf)


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
