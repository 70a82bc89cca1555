"""Who is in a house, and where: what the catalogs' people.yaml says, drawn by a seed."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from catalogs import Catalogs
from catalogs.entries import Dweller
from solver.free_floor import FreeFloor
from solver.free_places import block_of
from solver.people.poses import POSES, Surroundings
from solver.pieces import Space
from solver.records import changed
from solver.scene import Dynamic, Room
from solver.streams import Stream

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
