"""Who is in a house, and where: a person in some rooms, at most four, and perhaps a pet.

Comes in: rooms, their spaces, who was there before. Goes out: people and pets. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

from catalogs import Catalogs
from solver.people.floor import Floor
from solver.people.poses import roaming, sitting, standing
from solver.scene import Dynamic, Room
from solver.streams import Stream
from solver.wanted import Space

MAJOR: Final = ("living_room", "studio", "kitchen", "dining_room", "bedroom_master", "backyard", "patio", "outdoor_deck")
"""Room types that people are seen in."""
PERSON_CHANCE: Final = 0.3
MOST_PEOPLE: Final = 4
PET_CHANCE: Final = 0.7
PETS: Final = ("dog", "cat")
PETS_LIKE: Final = ("living_room", "studio", "backyard", "kitchen")
"""Where a pet is rather than elsewhere; these and the numbers above are the predecessor's, section 8."""
PETS_TAKE: Final = ("dining_room", "bedroom_master", "hallway", "patio", "outdoor_deck", "bedroom", "office", "kids_bedroom")
"""Where it is else."""


@dataclass(frozen=True)
class Home:
    """What decides who is in a house.

    Args:
        seed: of the house, or of what is done anew.
        catalogs: sizes and colours of people and pets, and which sides of furniture are used.
        spaces: of each room that may be peopled, by id: its clear rectangle, doorways and the width of who walks.
    """

    seed: int
    catalogs: Catalogs
    spaces: Mapping[str, Space]


def peopled(rooms: Sequence[Room], home: Home, before: Sequence[Dynamic] | None = None) -> tuple[Dynamic, ...]:
    """Returns the people and pets of a house.

    Args:
        rooms: furnished; they are peopled.
        home: what decides who comes.
        before: who was in the house, where only some of its rooms are peopled anew: those elsewhere stay as they are, and
            pets that were in one of these rooms come back to one of them. None: nobody was, the house is new.
    """
    ids = {room.id for room in rooms}
    staying = [one for one in before or () if one.room not in ids]
    returning = [one for one in before or () if one.room in ids and one.kind != "person"]
    floors = _Floors(rooms, home)
    people = _people(rooms, floors, home, [one for one in staying if one.kind == "person"])
    pets = _drawn_pet(home) if before is None else returning
    return (*staying, *people, *_settled(pets, rooms, floors, home))


class _Floors(dict[str, Floor]):
    """The floors of rooms by id, made when they are asked for."""

    def __init__(self, rooms: Sequence[Room], home: Home) -> None:
        super().__init__()
        self.rooms, self.home = {room.id: room for room in rooms}, home

    def __missing__(self, room_id: str) -> Floor:
        """Makes a room's floor."""
        self[room_id] = Floor(self.rooms[room_id], self.home.spaces[room_id], self.home.catalogs)
        return self[room_id]


def _people(rooms: Sequence[Room], floors: _Floors, home: Home, others: Sequence[Dynamic]) -> list[Dynamic]:
    """Draws a person for some of the rooms, until there are enough with the others."""
    found: list[Dynamic] = []
    for room in rooms:
        stream = Stream(home.seed, "people", room.index)
        if room.type not in MAJOR or len(others) + len(found) >= MOST_PEOPLE or not stream.chance(PERSON_CHANCE):
            continue
        person = replace(_newcomer("person", home, stream), room=room.id)
        ways = (sitting, standing) if stream.chance(0.5) else (standing, sitting)
        placed = next((one for way in ways if (one := way(floors[room.id], person, stream))), None)
        if placed is not None:
            named = replace(placed, id=_free_id("person", (*others, *found)))
            floors[room.id].add(named)
            found.append(named)
    return found


def _drawn_pet(home: Home) -> list[Dynamic]:
    """Draws whether a new house has a pet, and which."""
    stream = Stream(home.seed, "pet")
    if not stream.chance(PET_CHANCE):
        return []
    kind = stream.pick(PETS)
    return [replace(_newcomer(kind, home, stream), id=f"{kind}_1")]


def _settled(pets: Iterable[Dynamic], rooms: Sequence[Room], floors: _Floors, home: Home) -> list[Dynamic]:
    """Finds pets places in the rooms; where there is none the pet is not in the house."""
    found: list[Dynamic] = []
    for pet in pets:
        for room in _liked(rooms, Stream(home.seed, "pet", pet.id)) or rooms:
            placed = roaming(floors[room.id], replace(pet, room=room.id, y=0.0, on=None), Stream(home.seed, "pet", room.index))
            if placed is not None:
                floors[room.id].add(placed)
                found.append(placed)
                break
    return found


def _liked(rooms: Sequence[Room], stream: Stream) -> list[Room]:
    """Returns the rooms a pet may be in, those it likes first, each group in random order."""
    groups = [[room for room in rooms if room.type in types] for types in (PETS_LIKE, PETS_TAKE)]
    for group in groups:
        stream.shuffle(group)
    return [room for group in groups for room in group]


def _newcomer(kind: str, home: Home, stream: Stream) -> Dynamic:
    """Returns somebody without a place, of the catalogs' size, in one of its colours."""
    spec = home.catalogs.furniture[kind]
    width, depth, height = spec.size
    color = stream.pick((spec.color, *spec.variants))
    return Dynamic("", kind, width=width, depth=depth, height=height, color=color)


def _free_id(kind: str, others: Sequence[Dynamic]) -> str:
    taken = {one.id for one in others}
    return next(name for number in range(1, len(taken) + 2) if (name := f"{kind}_{number}") not in taken)
