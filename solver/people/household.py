"""Who is in a house, and where: what the catalogs' people.yaml says, drawn by a seed."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from catalogs import Catalogs
from catalogs.entries import Dweller, Seats, Surface
from catalogs.schema import FurnitureSpec
from solver.free_floor import FreeFloor, Goal
from solver.free_places import Block, block_of, decoration_blocks, footprint
from solver.geometry import OPPOSITE, Rect, half_m, rotate, strip, to_mm, wall_faced
from solver.pieces import Space
from solver.records import changed, kept
from solver.scene import Dynamic, Furniture, Room
from solver.streams import Stream

NEAR_MM: Final = 2000
"""How far from somebody what they look at may be: a person's length and a bit; our choice."""
FULLY: Final = math.cos(math.radians(40))
"""Somebody faces a thing when its middle and its nearest point both lie within this angle of their front: 45 degrees are asked
for, the rest is for whoever measures to another point of it."""
OPENINGS: Final = ("door", "garage_door", "window")
SCREEN: Final = "tv"
_kinds_by_name: Final = lru_cache(maxsize=64)(Catalogs.kinds_by_name)


@dataclass(frozen=True)
class Sight:
    """A rectangle to look at, mm (flat for an opening), and the wall that whoever looks at it has behind."""

    rect: Rect
    seen_from: str


def sights(room: Room, space: Space, catalogs: Catalogs) -> list[Sight]:
    """Returns what there is to look at: the room's furniture in its order, then its openings."""
    named = _kinds_by_name(catalogs)
    found = []
    for piece in room.furniture:
        kind = named.get(piece.name)
        is_worktop = kind is not None and kind.category == "table" and kind.use is not None
        if piece.category == "seating" or piece.name == SCREEN or is_worktop:
            looked_at = "back" if piece.under else "front"  # a chair at a table from behind
            found.append(Sight(footprint(piece), wall_faced(looked_at, piece.rotation)))
    return found + list(_openings(room, space))


def _openings(room: Room, space: Space) -> Iterator[Sight]:
    """Yields the openings of a rectangular room, and the doorways of any other."""
    if room.outline is not None:
        for door in space.doorways:
            yield Sight(door.square, OPPOSITE[door.wall])
        return
    for opening in room.openings:
        if opening.kind in OPENINGS and opening.wall is not None:
            middle, half = to_mm(opening.position), to_mm(opening.width) // 2
            yield Sight(strip(space.clear, opening.wall, (middle - half, middle + half), 0), OPPOSITE[opening.wall])


def faces(person: Dynamic, sight: Sight) -> bool:
    """Tells whether somebody's front is turned to a thing that is near."""
    x, z = person.x * 1000, person.z * 1000
    rect = sight.rect
    middle = ((rect.x0 + rect.x1) / 2 - x, (rect.z0 + rect.z1) / 2 - z)
    nearest = (min(max(x, rect.x0), rect.x1) - x, min(max(z, rect.z0), rect.z1) - z)
    angle = math.radians(person.rotation)
    front = (math.sin(angle), math.cos(angle))
    turned = all(front[0] * dx + front[1] * dz >= FULLY * math.hypot(dx, dz) > 0 for dx, dz in (middle, nearest))
    return turned and math.hypot(*nearest) <= NEAR_MM


TRIES: Final = 40
"""Wishes that are tried; after half of them nobody asks for a gap around any more."""
GAP_MM: Final = 60
"""What somebody likes to keep free around."""
TALKING: Final = (0.5, 1.4)
"""How far from a thing one stands to look at it, m, to one's middle."""
STEP: Final = 15
"""Degrees that people turn by."""
CUSHION_MM: Final = 60
"""What lies on a seat and is no thicker is sat on: one sits on top of it."""


@dataclass(frozen=True)
class Surroundings:
    """A furnished room as whoever is to be in it finds it: what is there, and the floor that is left."""

    room: Room
    floor: FreeFloor
    catalogs: Catalogs

    @kept
    def things(self) -> Sequence[Block]:
        """What its decorations take up."""
        return decoration_blocks(self.room)

    def near(self, person: Dynamic, gap_mm: int) -> Dynamic | None:
        """Returns somebody at the free place nearest to the pose, with a gap all around, or None where there is none."""
        found = self.floor.nearest(block_of(person), gap_mm)
        if found is None:
            return None
        return changed(person, x=half_m(found.x0 + found.x1), z=half_m(found.z0 + found.z1))

    def leaves_all_reachable(self, person: Dynamic) -> bool:
        """Tells whether everything stays within reach with somebody there on the floor, and so is who stands there."""
        own = footprint(person)
        return self.floor.connects([own], [Goal.beside(own)])

    def front_reachable(self, piece: Furniture) -> bool:
        """Tells whether one can come to a piece's front, those who stand there being in the way."""
        return self.floor.connects(goals=[Goal(footprint(piece), (wall_faced("front", piece.rotation),))])


def standing(here: Surroundings, person: Dynamic, _: Dweller, stream: Stream) -> Dynamic | None:
    """Returns a person on free floor who faces something near, within reach and in nobody's way."""
    seen = sights(here.room, here.floor.space, here.catalogs)
    for k in range(TRIES if seen else 0):
        sight = stream.pick(seen)
        wish = _before(sight, person, stream)
        placed = here.near(wish, GAP_MM if k < TRIES // 2 else 0)
        if placed and faces(placed, sight) and here.leaves_all_reachable(placed):
            return placed
    return None


def _before(sight: Sight, person: Dynamic, stream: Stream) -> Dynamic:
    """Returns a person somewhere before a thing, turned to its middle."""
    rect, away = sight.rect, stream.uniform(*TALKING)
    along = stream.uniform(-0.2, 1.2)
    x, z = rect.x0 + along * rect.width, rect.z0 + along * rect.depth
    x = {"west": rect.x0 - 1000 * away, "east": rect.x1 + 1000 * away}.get(sight.seen_from, x)
    z = {"north": rect.z0 - 1000 * away, "south": rect.z1 + 1000 * away}.get(sight.seen_from, z)
    turn = math.degrees(math.atan2((rect.x0 + rect.x1) / 2 - x, (rect.z0 + rect.z1) / 2 - z))
    return changed(person, x=round(x) / 1000, z=round(z) / 1000, rotation=round(turn / STEP) * STEP % 360)


def roaming(here: Surroundings, pet: Dynamic, _: Dweller, stream: Stream) -> Dynamic | None:
    """Returns a pet somewhere on free floor, within reach and in nobody's way."""
    clear = here.floor.space.clear
    for k in range(TRIES):
        x, z = stream.uniform(clear.x0, clear.x1), stream.uniform(clear.z0, clear.z1)
        turn = STEP * stream.below(360 // STEP)
        wish = changed(pet, x=round(x) / 1000, z=round(z) / 1000, rotation=turn)
        placed = here.near(wish, GAP_MM if k < TRIES // 2 else 0)
        if placed and here.leaves_all_reachable(placed):
            return placed
    return None


def sitting(here: Surroundings, person: Dynamic, entry: Dweller, stream: Stream) -> Dynamic | None:
    """Returns a person who sits on a seat or at the end of a bed, whose front can be reached."""
    wanted = entry.seats
    if wanted is None:
        return None
    seats = [(piece, seat) for piece in here.room.furniture if (seat := _seat(here, piece, wanted))]
    stream.shuffle(seats)
    sitter = changed(person, width=wanted.size[0], depth=wanted.size[1], height=wanted.size[2])
    for piece, seat in seats:
        for across in _places(piece, seat, sitter.width, stream):
            for behind in (seat.inset, 0.0):  # at the very edge before what leans on the back
                placed = _on_top(here.things, _seated(sitter, piece, seat, (across, behind)))
                if here.floor.is_free(block_of(placed), block_of(piece)) and here.front_reachable(piece):
                    return placed
    return None


@lru_cache(maxsize=64)
def _kinds_by_size(catalogs: Catalogs) -> Mapping[tuple[str, tuple[float, float, float]], FurnitureSpec]:
    """Returns the kinds of furniture by what scenes call them and their size, m; of those that share both the first."""
    return {(catalogs.name_of(name), kind.size): kind for name, kind in reversed(catalogs.furniture.items())}


def _seat(here: Surroundings, piece: Furniture, wanted: Seats) -> Surface | None:
    """Returns what somebody can sit on of a piece; nobody sits on a chair that is tucked in, or on one that stands on something."""
    if piece.category not in wanted.categories or piece.under or piece.on or piece.y or piece.rotation % 90:
        return None
    kind = _kinds_by_size(here.catalogs).get((piece.name, (piece.width, piece.depth, piece.height)))
    surfaces = kind.surfaces if kind else ()
    low, high = wanted.heights
    return next((one for one in surfaces if low <= one.height <= high and one.clearance is None), None)


def _places(piece: Furniture, seat: Surface, width: float, stream: Stream) -> Sequence[int]:
    """Returns middles across a seat to try, mm: one at random, then from end to end."""
    room = round((piece.width - 2 * seat.inset - width) * 1000) // 2
    if room <= 0:
        return (0,)
    ends = [-room, room, 0, -room // 2, room // 2]
    stream.shuffle(ends)
    return [round(stream.uniform(-room, room) / 50) * 50 if abs(room) > 50 else 0, *ends]


def _seated(person: Dynamic, piece: Furniture, seat: Surface, place: tuple[int, float]) -> Dynamic:
    """Returns a person on a seat, within the piece's footprint: so far across (mm), so far behind its front edge (m)."""
    across, behind = place
    width, depth = min(person.width, piece.width), min(person.depth, piece.depth)
    along = max(0, round((piece.depth / 2 - behind - depth / 2) * 1000), round((depth - piece.depth) * 500))
    x, z = rotate(across, along, round(piece.rotation))
    centre = (round(piece.x + x / 1000, 4), round(piece.z + z / 1000, 4))
    return changed(
        person, x=centre[0], y=round(piece.y + seat.height, 4), z=centre[1], rotation=piece.rotation,
        width=width, depth=depth, on=piece.id,
    )  # fmt: skip


def _on_top(things: Sequence[Block], placed: Dynamic) -> Dynamic:
    """Returns somebody on top of the cushions and blankets that lie there on the seat."""
    own = block_of(placed)
    here = (block for block in things if block.rect.overlaps(own.rect))
    tops = [block.high for block in here if round(own.low) < round(block.high) <= round(own.low) + CUSHION_MM]
    return changed(placed, y=round(max(tops) / 1000, 4)) if tops else placed


Posing = Callable[[Surroundings, Dynamic, Dweller, Stream], Dynamic | None]
POSES: Final[Mapping[str, Posing]] = {"stands": standing, "sits": sitting, "roams": roaming}
"""How somebody finds a place, by the word of people.yaml."""


_use_sides: Final = lru_cache(maxsize=64)(Catalogs.use_sides)


@dataclass(frozen=True)
class Household:
    """What decides who is in a house: its seed, or that of what is done anew, and the catalogs.

    `space_of` tells of a room its clear rectangle, doorways and the width of who walks; asked where somebody may come.
    """

    seed: int
    catalogs: Catalogs
    space_of: Callable[[Room], Space]


def peopled(rooms: Sequence[Room], household: Household, before: Sequence[Dynamic] | None = None) -> tuple[Dynamic, ...]:
    """Returns the people and pets of furnished rooms.

    `before` is who was in the house where only some of its rooms are peopled anew: those elsewhere stay as they are, and who belongs to the
    home, as pets do, and was in one of these rooms comes back to one of them.
    """
    ids = {room.id for room in rooms}
    drawing = _Drawing(rooms, household, [one for one in before or () if one.room not in ids])
    of_home = {name: entry for name, entry in household.catalogs.people.items() if entry.per == "home"}
    for name, entry in household.catalogs.people.items():
        if entry.per == "room":
            drawing.people_rooms(name, entry)
        elif before is None:
            drawing.settle_one(name, entry)
    coming_anew = {kind for entry in household.catalogs.people.values() if entry.per == "room" for kind in entry.kinds}
    for one in before or ():
        named = next((name for name, entry in of_home.items() if one.kind in entry.kinds), next(iter(of_home), None))
        if one.room in ids and one.kind not in coming_anew and named:
            drawing.settle(one, named, of_home[named])
    return tuple(drawing.there)


class _Drawing:
    """The people drawn so far, and what the rooms leave them."""

    def __init__(self, rooms: Sequence[Room], household: Household, there: Iterable[Dynamic]) -> None:
        self.rooms, self.household, self.there = rooms, household, list(there)
        self._surroundings: dict[str, Surroundings] = {}

    def people_rooms(self, name: str, entry: Dweller) -> None:
        """Draws somebody for some of the rooms, until there are enough in the house."""
        for room in (room for room in self.rooms if room.type in entry.rooms):
            stream = Stream(self.household.seed, name, room.index)
            enough = sum(one.kind in entry.kinds for one in self.there) >= entry.most
            if not enough and stream.chance(entry.chance):
                self._place(self._newcomer(entry, stream), room, entry, stream)

    def settle_one(self, name: str, entry: Dweller) -> None:
        """Draws whether the house has one, and which."""
        stream = Stream(self.household.seed, name)
        if stream.chance(entry.chance):
            self.settle(self._newcomer(entry, stream), name, entry)

    def settle(self, one: Dynamic, name: str, entry: Dweller) -> None:
        """Finds somebody a place in the rooms; where there is none they are not in the house."""
        seed = self.household.seed
        for room in self._liked(entry, Stream(seed, name, one.id)) or self.rooms:
            if self._place(changed(one, y=0.0, on=None), room, entry, Stream(seed, name, room.index)):
                break

    def _liked(self, entry: Dweller, stream: Stream) -> list[Room]:
        """Returns the rooms one may be in, those liked first, each group in random order."""
        groups = [[room for room in self.rooms if room.type in types] for types in (entry.rooms, entry.otherwise)]
        for group in groups:
            stream.shuffle(group)
        return [room for group in groups for room in group]

    def _newcomer(self, entry: Dweller, stream: Stream) -> Dynamic:
        """Returns somebody without a place, of the catalogs' size, in one of its colours."""
        kind = stream.pick(entry.kinds) if len(entry.kinds) > 1 else entry.kinds[0]
        spec = self.household.catalogs.furniture[kind]
        width, depth, height = spec.size
        taken = {one.id for one in self.there}
        label = next(name for number in range(1, len(taken) + 2) if (name := f"{kind}_{number}") not in taken)
        return Dynamic(label, kind, width=width, depth=depth, height=height, color=stream.pick((spec.color, *spec.variants)))

    def _place(self, one: Dynamic, room: Room, entry: Dweller, stream: Stream) -> bool:
        """Places somebody in a room; tells whether there was a place."""
        if room.id not in self._surroundings:
            floor = FreeFloor.of_room(room, self.household.space_of(room), _use_sides(self.household.catalogs))
            self._surroundings[room.id] = Surroundings(room, floor, self.household.catalogs)
        floor, poses = self._surroundings[room.id].floor, list(entry.poses)
        stream.shuffle(poses)
        here = changed(one, room=room.id)
        placed = next((found for pose in poses if (found := POSES[pose](self._surroundings[room.id], here, entry, stream))), None)
        if placed is not None:
            stands = placed.on is None
            floor.add(block_of(placed), in_the_way=stands, is_goal=stands)
            self.there.append(placed)
        return placed is not None
