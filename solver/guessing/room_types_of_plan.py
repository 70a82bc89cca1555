"""The types of a plan's rooms: by their names, else by what stands in them, else by their form; both weighed for all rooms at once."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from catalogs import Catalogs
from catalogs.synonyms import RoomMeaning, RoomNames, room_names_of
from solver.answers import RoomGuess
from solver.guessing.doors_between import doors_between, joined_rooms
from solver.guessing.suiting import NEVER, SEVERAL, Costs, Counts, RoomMarks, RoomNumbers, Suiting, marks_of
from solver.plain import quoted
from solver.scene import EXTERIOR, Room, Scene, robot_width_of

KEPT: Final = 200
"""Ways to give types to the first rooms of a home that are looked at further: the cheapest."""
SWEEPS: Final = 12
"""How often all rooms are looked at anew, at most."""
DIGITS: Final = 9
"""Costs that are alike to so many digits are alike."""
Types = NDArray[np.int64]


class TypesInHome:
    """The types of a home's rooms, and what they cost. A room of a kind that we have no type for is as if it were not there.

    `fixed` are types that are known, by room, empty for such a kind; `program` says how many rooms of each word there are, where that is
    known.
    """

    def __init__(self, suiting: Suiting, fixed: Mapping[int, str], program: Mapping[str, int] | None = None) -> None:
        self.marks = suiting.marks
        self._names = list(suiting.kinds)
        self._none = len(self._names)
        self.free = [k for k in range(len(self.marks)) if k not in fixed]
        """The rooms that are guessed."""
        self._alone = {k: np.array([suiting.alone(k, name) for name in self._names]) for k in self.free}
        self._joined = _joined(suiting) if self.free else np.zeros((6, 0, 0))
        indoors = sum(not one.outdoor for k, one in enumerate(self.marks) if fixed.get(k) != "")
        self._numbers = RoomNumbers(suiting.catalogs, indoors, program)
        start = [self._names.index(fixed[k]) if fixed.get(k) else self._none for k in range(len(self.marks))]
        self._types = self._settled(np.array(start, dtype=np.int64)) if self.free else np.array(start, dtype=np.int64)

    @property
    def types(self) -> list[str]:
        """The type of each room; empty for a kind that we have none for."""
        return [self._names[at] if at < self._none else "" for at in self._types.tolist()]

    def ranked(self, room: int) -> list[str]:
        """Returns the types a room may have, best first, the others' types given."""
        return [self._names[at] for at in self._order(room, self._types)]

    def _order(self, room: int, types: Types) -> list[int]:
        others = types.copy()
        others[room] = self._none
        counts = self._counts(others[None, :])
        filled = counts + np.eye(self._none, dtype=np.int64)
        costs = self._steps(room, others[None, :])[0] + self._numbers.more(counts)[0] + self._numbers.missing(filled)
        order = np.argsort(np.round(costs, DIGITS), kind="stable")
        return [at for at in order.tolist() if self._alone[room][at] < NEVER]

    def _counts(self, homes: Types) -> Counts:
        """Returns how many rooms of each type each home has."""
        return np.stack([np.bincount(home, minlength=self._none + 1)[: self._none] for home in homes])

    def _steps(self, room: int, homes: Types) -> Costs:
        """Returns the cost of each type in a room of each home, by its form and what it is joined to."""
        found = np.repeat(self._alone[room][None, :], len(homes), axis=0)
        for there, is_open in self.marks[room].ways:
            past = 1 if self.marks[room].behind == there else 2 if self.marks[there].behind == room else 0
            found += self._joined[2 * past + is_open][homes[:, there]]
        return found

    def _settled(self, start: Types) -> Types:
        """Gives the free rooms types: the plainest first, the cheapest homes kept; then each alone until nothing changes."""
        homes, costs, counts = start[None, :], np.zeros(1), self._counts(start[None, :])
        for room in sorted(self.free, key=lambda k: (-self._margin(k), k)):
            steps = costs[:, None] + self._steps(room, homes) + self._numbers.more(counts)
            flat = np.round(steps, DIGITS).ravel()
            kept = np.argsort(flat, kind="stable")[:KEPT]
            rows, types = np.divmod(kept, self._none)
            homes, counts, costs = homes[rows].copy(), counts[rows].copy(), flat[kept]
            homes[:, room] = types
            counts[np.arange(len(kept)), types] += 1
        found: Types = homes[int(np.argmin(np.round(costs + self._numbers.missing(counts), DIGITS)))]
        for _ in range(SWEEPS):
            before = found.copy()
            for room in self.free:
                found[room] = self._order(room, found)[0]
            if (found == before).all():
                break
        return found

    def _margin(self, room: int) -> float:
        costs = np.sort(self._alone[room])
        return float(costs[1] - costs[0]) if len(costs) > 1 else 0.0


def _joined(suiting: Suiting) -> NDArray[np.float64]:
    """Returns what joining two types costs, by how, by the first's type or none, and the second's.

    How: by a door, by an opening without a leaf; then both where one comes to the second through the first, both where to the first
    through the second.
    """
    names: Sequence[str] = list(suiting.kinds)
    found = np.zeros((2, len(names) + 1, len(names)))
    past = np.zeros((len(names) + 1, len(names)))
    for a, one in enumerate(names):
        past[a] = [suiting.past(one, other) for other in names]
        for b, other in enumerate(names[: a + 1]):
            for is_open in (0, 1):
                found[is_open, a, b] = found[is_open, b, a] = suiting.joined(one, other, bool(is_open))
    back = np.zeros_like(past)
    back[:-1] = past[:-1].T
    return np.concatenate([found, found + past, found + back])


def guessed_types(scene: Scene, catalogs: Catalogs, program: Mapping[str, int] | None = None) -> tuple[RoomGuess, ...]:
    """Guesses the types of the rooms whose type the catalogs do not know; furniture is under the catalogs' names.

    Rooms that are called by what we have no type for keep that, and shafts are of none. `program` says how many rooms of each word the home
    has, where that is known. Rooms that are called as gardens are lie outdoors, whatever the scene says.
    """
    names = room_names_of(catalogs)
    unknown = {room.id: _called(room, names)[1] for room in scene.rooms if room.type not in catalogs.rooms}
    called = {name: meaning.key for name, meaning in unknown.items() if meaning and meaning.key in catalogs.rooms}
    typed = with_types(scene, called, catalogs).rooms
    scene = replace(scene, rooms=tuple(replace(room, outdoor=one.outdoor) for room, one in zip(scene.rooms, typed, strict=True)))
    homes = [scene] if program is not None else _dwellings(scene)
    guesses = {guess.room: guess for home in homes for guess in _guessed(home, catalogs, program)}
    return tuple(guesses[room.id] for room in scene.rooms if room.id in guesses)


def _dwellings(scene: Scene) -> list[Scene]:
    """Returns the dwellings of a storey that no door joins: of several rooms each, one of which leads outside; the rest is the first's."""
    joints = list(doors_between(scene.rooms))
    inner = {opening.id for _, _, opening in joints}
    outside = [
        k for k, room in enumerate(scene.rooms)
        if not room.outdoor and any(one.kind == "door" and one.connects_to == EXTERIOR and one.id not in inner for one in room.openings)
    ]  # fmt: skip
    found: list[set[int]] = []
    for k in outside:
        own = set() if any(k in one for one in found) else joined_rooms(k, joints)
        indoors = sum(not scene.rooms[j].outdoor for j in own)
        if indoors >= SEVERAL and scene.rooms[k].level == scene.rooms[outside[0]].level:
            found.append(own)
    if len(found) < 2:
        return [scene]
    others = set[int]().union(*found[1:])
    rooms = [tuple(room for k, room in enumerate(scene.rooms) if k not in others)]
    rooms += [tuple(room for k, room in enumerate(scene.rooms) if k in own) for own in found[1:]]
    return [replace(scene, rooms=own) for own in rooms]


def _guessed(scene: Scene, catalogs: Catalogs, program: Mapping[str, int] | None) -> tuple[RoomGuess, ...]:
    """Guesses the types of the rooms of one dwelling."""
    names, found = room_names_of(catalogs), dict[str, RoomGuess]()
    marks = marks_of(scene.rooms)
    fixed: dict[int, str] = {}
    for k, room in enumerate(scene.rooms):
        if room.type in catalogs.rooms:
            fixed[k] = room.type
            continue
        said, meaning = _called(room, names)
        if meaning is None:
            if is_shaft(room, scene):
                fixed[k] = ""
            continue
        if meaning.key in catalogs.rooms:
            fixed[k] = _of_size(meaning.key, marks[k], catalogs)
            found[room.id] = RoomGuess(room.id, fixed[k], "name", said, None, _by_name(room, said, meaning, fixed[k]))
        else:
            fixed[k] = ""
    for k, guess in _by_form(scene.rooms, TypesInHome(Suiting(marks, catalogs), fixed, program)).items():
        found[scene.rooms[k].id] = guess
    return tuple(found[room.id] for room in scene.rooms if room.id in found)


def is_shaft(room: Room, scene: Scene) -> bool:
    """Tells whether a room is empty and between its walls too narrow for anybody to stand in: a shaft, or a cupboard in a wall."""
    return not (room.furniture or room.outdoor) and min(room.width, room.depth) - scene.wall_thickness < robot_width_of(scene)


def with_types(scene: Scene, types: Mapping[str, str], catalogs: Catalogs, *, stays: bool = True) -> Scene:
    """Returns a scene with types of rooms by their ids, and outdoors those whose type lies there: a garden, a balcony.

    Whether one outdoors `stays` there whatever type it is given.
    """

    def typed(room: Room) -> Room:
        kind = catalogs.rooms.get(key := types.get(room.id, room.type))
        outdoor = (room.outdoor and (stays or room.id not in types)) or (kind is not None and kind.outdoor)
        return replace(room, type=key, outdoor=outdoor)

    return replace(scene, rooms=tuple(map(typed, scene.rooms)))


def _called(room: Room, names: RoomNames) -> tuple[str, RoomMeaning | None]:
    """Returns the first that names a room's use of its type and its name, and what that means."""
    return next(((word, told) for word in (room.type, room.name) if word is not None and (told := names.meaning(word))), ("", None))


def _of_size(key: str, marks: RoomMarks, catalogs: Catalogs) -> str:
    """Returns the type of a family, such as garages, that a room is large enough for: what is called garage may be one for two cars."""
    kinds = catalogs.rooms
    if not kinds[key].plan.garage_door:
        return key
    larger = [name for name, kind in kinds.items() if kind.plan.garage_door and kind.area.min[0] <= marks.area]
    return max((key, *larger), key=lambda name: kinds[name].area.min[0])


def _by_name(room: Room, said: str, meaning: RoomMeaning, type_name: str) -> str:
    return f"{room.id} is taken for {type_name}: it is called {quoted(said)}" + ("" if meaning.plain else ", which holds such a word")


def _by_form(rooms: Sequence[Room], home: TypesInHome) -> dict[int, RoomGuess]:
    """Guesses the types of all other rooms together."""
    found = {}
    for k in home.free:
        marks, ranked = home.marks[k], home.ranked(k)
        by = "pieces" if marks.pieces else "form"
        instead = ranked[1] if by == "form" and len(ranked) > 1 else None
        found[k] = RoomGuess(rooms[k].id, home.types[k], by, rooms[k].type, instead, _words(rooms[k].id, home.types[k], marks, by))
    return found


def _words(room: str, type_name: str, marks: RoomMarks, by: str) -> str:
    if by == "pieces":
        return f"{room} is taken for {type_name}: it holds {', '.join(sorted(marks.pieces)[:4])}"
    doors, windows = len(marks.ways) + bool(marks.front), marks.large + marks.small
    told = f"{marks.area:.1f} m2, {doors} door{'s' * (doors != 1)}, {windows} window{'s' * (windows != 1)}, and what it lies beside"
    return f"{room} is taken for {type_name}: {told}"
