"""A programme -> the rooms of a home, each with the sizes it may have and what it is to the plan.

Not here: where the rooms lie.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from math import log
from typing import Final, NamedTuple

from catalogs.entries import Home
from catalogs.schema import Catalogs, RoomType
from solver.errors import RequestError
from solver.floorplan.fitness import cars_of
from solver.request import Request

GARAGE: Final = "garage"
"""The word that counts cars."""
IMPLIED: Final = {"bedrooms": 1, "bathrooms": 1, "living_room": 1, "kitchen": 1, "foyer": 1}
"""What a programme holds where it does not count it. Our choice: the least that makes a home."""
MOST_ROOMS: Final = 30
"""Most rooms of a programme; our choice: strips of more would be longer than any street."""
SHRINKING: Final = 2.0
"""How much worse a floor too small for a preset is than one as much too large."""
LAST: Final = 4
"""From this `spare` on even the last room of its word may be left out."""
WALLS_SHARE: Final = 1.15
"""Floor of a home over that of its rooms, its hallway counted. Measured."""


class RoomSize(NamedTuple):
    """How large a room may be: areas, mm2, short side, mm, long side over short, and extent away from the street, mm."""

    least: int
    typical: int
    most: int
    width: int
    aspect: float
    length: int = 0


@dataclass(frozen=True)
class PlannedRoom:
    """A room asked for.

    `owner` is the index of the room it belongs to (its bathroom), None for all others.
    """

    type: str
    kind: RoomType
    size: RoomSize
    owner: int | None = None

    @property
    def home(self) -> Home:
        """What the catalog says of the type in a home."""
        return _home(self.kind)

    @property
    def public(self) -> bool:
        """Tells whether one lives in it and walks through it."""
        return self.kind.plan.way_through and self.kind.plan.habitable

    @property
    def entry(self) -> bool:
        """Tells whether it is where one comes in: a way through that is no living space."""
        return self.kind.plan.way_through and not self.kind.plan.habitable

    @property
    def garage(self) -> bool:
        """Tells whether cars stand in it."""
        return self.kind.plan.garage_door


def _home(kind: RoomType) -> Home:
    if kind.home is None:
        raise ValueError("a room type without `home` is in no programme")
    return kind.home


@lru_cache(maxsize=16)
def words_of(catalogs: Catalogs) -> Mapping[str, list[str]]:
    """Returns the words a programme may count, each with its room types in the order they take turns."""
    words: dict[str, list[str]] = {}
    for name, kind in sorted(catalogs.rooms.items(), key=lambda entry: (entry[1].home.turn if entry[1].home else 0, entry[0])):
        if kind.home is not None:
            words.setdefault(kind.home.word or name, []).append(name)
    return words


def counts_of(request: Request, catalogs: Catalogs) -> dict[str, int]:
    """Returns how many rooms of each word (cars, for garages) a request asks for.

    Raises:
        RequestError: an unknown preset or word, too many rooms, or what a programme does not go with.
    """
    if request.force_types:
        raise RequestError("force_types", "says what rooms of a plain request are", "none beside a program or an area")
    program = _preset_for(request, catalogs) if request.program is None else request.program
    if isinstance(program, str):
        if program not in catalogs.presets:
            raise RequestError("program", f"no preset is called {program!r}", ", ".join(sorted(catalogs.presets)))
        program = catalogs.presets[program].rooms
    else:
        words = words_of(catalogs)
        for word in program:
            if word not in words:
                raise RequestError(f"program.{word}", "is no word for rooms", ", ".join(sorted(words)))
        program = {word: count for word, count in {**IMPLIED, **program}.items() if word in words}
    counts = {word: count for word, count in program.items() if count}
    if not 1 <= sum(counts.values()) <= MOST_ROOMS:
        raise RequestError("program", f"asks for {sum(counts.values())} rooms and cars", f"1 to {MOST_ROOMS} in all")
    return counts


def _preset_for(request: Request, catalogs: Catalogs) -> str:
    """Returns the preset whose typical floor is nearest to the area asked for; rooms grow more gladly than they shrink."""
    area = request.area or 0.0

    def strays(name: str) -> tuple[float, str]:
        rooms = types_of({word: count for word, count in catalogs.presets[name].rooms.items() if count}, catalogs)
        kinds = catalogs.of_home(rooms).rooms
        floor = sum(_home(kinds[room]).area[1] for room in rooms) * WALLS_SHARE
        stretch = log(area / floor)
        return max(stretch, -SHRINKING * stretch), name

    return min(catalogs.presets, key=strays)


def types_of(counts: Mapping[str, int], catalogs: Catalogs) -> list[str]:
    """Returns the room types a programme comes to, in a fixed order."""
    words, types = words_of(catalogs), list[str]()
    for word in sorted(counts):
        names = words[word]
        if word == GARAGE:
            types += _garages(counts[word], names, catalogs)
            continue
        later = [name for name in names if not _home(catalogs.rooms[name]).once] or names
        first = [name for name in names if name not in later]
        types += (first + later * counts[word])[: counts[word]]
    return types


def program_counts(program: Mapping[str, int] | str, catalogs: Catalogs) -> dict[str, int]:
    """Returns how many rooms of each word a programme, or a preset of that name, comes to: garages, not cars.

    Raises:
        RequestError: as `counts_of`.
    """
    types = types_of(counts_of(Request(program=program), catalogs), catalogs)
    return dict(Counter(_home(catalogs.rooms[name]).word or name for name in types))


def program_of(types: Sequence[str], catalogs: Catalogs) -> dict[str, int]:
    """Returns the programme that counts rooms of these types, those that none can count left out."""
    counts = Counter[str]()
    for name in types:
        home = catalogs.rooms[name].home if name in catalogs.rooms else None
        if home is not None:
            word = home.word or name
            counts[word] += cars_of(catalogs.rooms[name]) if word == GARAGE else 1
    return dict(sorted(counts.items()))


def _garages(cars: int, names: Sequence[str], catalogs: Catalogs) -> list[str]:
    """Returns garages for so many cars, as few as there can be."""
    places = sorted((cars_of(catalogs.rooms[name]), name) for name in names)
    found = []
    while cars > 0:
        held, name = next(((held, name) for held, name in places if held >= cars), places[-1])
        found.append(name)
        cars -= held
    return found


def planned_rooms(types: Sequence[str], catalogs: Catalogs, area_m2: float | None) -> tuple[PlannedRoom, ...]:
    """Returns rooms of these types with their sizes.

    `area_m2` is the floor the house is wished to have, hallways included; the rooms' typical areas by default.
    """
    rooms = catalogs.of_home(types).rooms
    kinds = _with_one_entry([rooms[name] for name in types])
    homes = [_home(kind) for kind in kinds]
    scale = 1.0 if area_m2 is None else _scale(homes, area_m2 / WALLS_SHARE)
    sizes = [_size(home, scale) for home in homes]
    owners = _owners(types, kinds)
    return tuple(PlannedRoom(name, kind, size, owner) for name, kind, size, owner in zip(types, kinds, sizes, owners, strict=True))


def _with_one_entry(kinds: Sequence[RoomType]) -> list[RoomType]:
    """Returns the rooms' kinds, of all by which one may come in only the first as such: the others are dealt like private rooms."""
    entries = [i for i, kind in enumerate(kinds) if kind.plan.way_through and not kind.plan.habitable]
    private = {i: kinds[i].plan.model_copy(update={"way_through": False}) for i in entries[1:]}
    return [kind.model_copy(update={"plan": private[i]}) if i in private else kind for i, kind in enumerate(kinds)]


def _scale(homes: Sequence[Home], floor: float) -> float:
    """Finds by bisection what the typical areas are multiplied by so that the rooms have so much floor, m2."""
    low, high = 0.2, 5.0
    for _ in range(30):
        middle = (low + high) / 2
        if sum(_typical(home, middle) for home in homes) < floor:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def _typical(home: Home, scale: float) -> float:
    return min(max(home.area[1] * scale, home.area[0]), home.area[2])


def _size(home: Home, scale: float) -> RoomSize:
    least, _, most = (round(area * 1e6) for area in home.area)
    return RoomSize(least, round(_typical(home, scale) * 1e6), most, round(home.width * 1000), home.aspect, round(home.length * 1000))


def _owners(types: Sequence[str], kinds: Sequence[RoomType]) -> list[int | None]:
    """Gives every second bathroom to a bedroom, the largest first; the first is everybody's."""
    baths = [i for i, kind in enumerate(kinds) if any("toilet" in line for line in kind.requires)]
    owners: list[int | None] = [None] * len(types)
    for bath in baths[1::2]:
        free = [i for i, name in enumerate(types) if name in kinds[bath].plan.behind and i not in owners]
        if free:
            owners[bath] = max(free, key=lambda i: (_home(kinds[i]).area[1], -i))
    return owners


def loosened(planned: Sequence[PlannedRoom], slack: float, floor: float | None) -> tuple[PlannedRoom, ...]:
    """Returns the rooms with looser limits, wished as large as the floor, m2, asks for."""
    scale = 1.0 if floor is None else floor * 1e6 / WALLS_SHARE / sum(one.size.typical for one in planned)

    def loose(size: RoomSize) -> RoomSize:
        least, most = round(size.least / slack), round(size.most * slack)
        typical = min(max(round(size.typical * scale), least), most)
        narrower = slack**0.5
        return RoomSize(least, typical, most, round(size.width / narrower), size.aspect * slack, round(size.length / narrower))

    return tuple(replace(one, size=loose(one.size)) for one in planned)


def spared(types: Sequence[str], catalogs: Catalogs) -> str | None:
    """Returns the type of the room that a home can best do without, None where it needs all of them."""

    def spare(name: str) -> int:
        home = _home(catalogs.rooms[name])
        alike = sum((_home(catalogs.rooms[other]).word or other) == (home.word or name) for other in types)
        return 0 if home.spare is None or (alike == 1 and home.spare < LAST) else home.spare

    best = max(types, key=spare)
    return best if spare(best) else None
