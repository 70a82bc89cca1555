"""The types of a plan's rooms: by their names, else by what stands in them, else by their form; the last two weighed for all rooms at once.

Comes in: a Scene, catalogs. Goes out: a RoomGuess for each room whose type the catalogs do not know. Deterministic: the types are
those of least cost that exchanging one room's type, or those of two rooms, does not make cheaper.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Final

from catalogs import Catalogs
from catalogs.room_names import RoomMeaning, room_names_of
from solver.guessed import RoomGuess
from solver.guessing.room_marks import RoomMarks, marks_of
from solver.guessing.suiting import Suiting
from solver.scene import Room, Scene

SWEEPS: Final = 12
"""How often all rooms are looked at anew, at most."""
NOTHING: Final = 1e-9
"""Costs that differ by less are alike."""
ONLY: Final = frozenset({"kitchen", "living_room", "dining_room", "bedroom_master", "laundry"})
"""Types that are handed over: of which a home mostly has one."""
SWAPPED: Final = 24
"""Rooms of a home of which pairs are exchanged; of larger homes only single rooms change."""


def guessed_types(scene: Scene, catalogs: Catalogs, program: Mapping[str, int] | None = None) -> tuple[RoomGuess, ...]:
    """Guesses the types of the rooms whose type the catalogs do not know.

    Args:
        scene: with furniture under the catalogs' names.
        catalogs: the room types, and what others call them.
        program: how many rooms of each word the home has, where that is known.

    Returns:
        A guess for each such room; rooms that are called by what we have no type for keep that.
    """
    names, found = room_names_of(catalogs), dict[str, RoomGuess]()
    marks = marks_of(scene.rooms)
    fixed: dict[int, str] = {}
    for k, room in enumerate(scene.rooms):
        if room.type in catalogs.rooms:
            fixed[k] = room.type
            continue
        said, meaning = next(((word, told) for word in _said(room) if (told := names.meaning(word))), ("", None))
        if meaning is None:
            continue
        if meaning.key in catalogs.rooms:
            fixed[k] = _of_size(meaning.key, marks[k], catalogs)
            found[room.id] = RoomGuess(room.id, fixed[k], "name", said, None, _by_name(room, said, meaning, fixed[k]))
        else:
            fixed[k] = ""
    for k, guess in _by_form(scene.rooms, marks, Suiting(marks, catalogs, program), fixed).items():
        found[scene.rooms[k].id] = guess
    return tuple(found[room.id] for room in scene.rooms if room.id in found)


def with_types(scene: Scene, guesses: Sequence[RoomGuess]) -> Scene:
    """Returns a scene whose rooms have the types that were guessed."""
    types = {guess.room: guess.type for guess in guesses}
    return replace(scene, rooms=tuple(replace(room, type=types.get(room.id, room.type)) for room in scene.rooms))


def _said(room: Room) -> tuple[str, ...]:
    """Returns what may name a room's use: its type, its name if it has one."""
    name = room.extra.get("name")
    return (room.type, name) if isinstance(name, str) else (room.type,)


def _of_size(key: str, marks: RoomMarks, catalogs: Catalogs) -> str:
    """Returns the type of a family, such as garages, that a room is large enough for: what is called garage may be one for two cars."""
    kinds = catalogs.rooms
    if not kinds[key].plan.garage_door:
        return key
    larger = [name for name, kind in kinds.items() if kind.plan.garage_door and kind.area.min[0] <= marks.area]
    return max((key, *larger), key=lambda name: kinds[name].area.min[0])


def _by_name(room: Room, said: str, meaning: RoomMeaning, type_name: str) -> str:
    return f"{room.id} is taken for {type_name}: it is called {said!r:.60}" + ("" if meaning.plain else ", which holds such a word")


def _by_form(rooms: Sequence[Room], marks: Sequence[RoomMarks], suiting: Suiting, fixed: Mapping[int, str]) -> dict[int, RoomGuess]:
    """Guesses the types of all other rooms together."""
    free = [k for k in range(len(rooms)) if k not in fixed]
    if not free:
        return {}
    home = _Home(suiting, fixed, len(rooms))
    home.settle(free)
    found = {}
    for k in free:
        ranked = home.ranked(k)
        by = "pieces" if marks[k].pieces else "form"
        instead = ranked[1] if by == "form" and len(ranked) > 1 else None
        found[k] = RoomGuess(rooms[k].id, home.types[k], by, rooms[k].type, instead, _words(rooms[k].id, home.types[k], marks[k], by))
    return found


def _words(room: str, type_name: str, marks: RoomMarks, by: str) -> str:
    if by == "pieces":
        return f"{room} is taken for {type_name}: it holds {', '.join(sorted(marks.pieces)[:4])}"
    doors, windows = len(marks.ways) + bool(marks.front), marks.large + marks.small
    told = f"{marks.area:.1f} m2, {doors} door{'s' * (doors != 1)}, {windows} window{'s' * (windows != 1)}, and what it lies beside"
    return f"{room} is taken for {type_name}: {told}"


class _Home:
    """The types given so far, and what they cost. A room of a kind that we have no type for is as if it were not there."""

    def __init__(self, suiting: Suiting, fixed: Mapping[int, str], count: int) -> None:
        self._suiting = suiting
        self.types: list[str] = [fixed.get(k, "") for k in range(count)]
        self._alone = [{name: suiting.alone(k, name) for name in suiting.types[k]} for k in range(count)]

    def settle(self, free: Sequence[int]) -> None:
        """Gives the free rooms types: the plainest first, then each again until nothing changes, pairs exchanged."""
        margin = {k: self._margin(k) for k in free}
        for k in sorted(free, key=lambda k: (-margin[k], k)):
            self.types[k] = self.ranked(k)[0]
        for _ in range(SWEEPS):
            before = list(self.types)
            for k in free:
                self.types[k] = self.ranked(k)[0]
            if len(free) <= SWAPPED:
                self._exchange(free)
                self._hand_over(free)
            if self.types == before:
                return

    def _margin(self, room: int) -> float:
        costs = sorted(self._alone[room].values())
        return costs[1] - costs[0] if len(costs) > 1 else 0.0

    def ranked(self, room: int) -> list[str]:
        """Returns the types a room may have, best first, the others' types given."""
        others = Counter(kind for k, kind in enumerate(self.types) if kind and k != room)

        def cost(name: str) -> float:
            return self._near(room, name) + self._suiting.in_all({**others, name: others[name] + 1})

        return sorted(self._suiting.types[room], key=lambda name: (round(cost(name), 9), name))

    def _near(self, room: int, name: str) -> float:
        ways = self._suiting.marks[room].ways
        joined = sum(self._suiting.joined(name, self.types[there], is_open) for there, is_open in ways if self.types[there])
        return self._alone[room].get(name, 1e6) + joined

    def _hand_over(self, free: Sequence[int]) -> None:
        """Gives the type of a room, of which a home mostly has one, to another room, and that room what then suits it best."""
        for owner in free:
            if self.types[owner] not in ONLY:
                continue
            for heir in free:
                kept = self.types[owner], self.types[heir]
                if kept[0] == kept[1] or self._alone[heir].get(kept[0]) is None:
                    continue
                before = self._together(owner, heir)
                self.types[heir] = kept[0]
                self.types[owner] = self.ranked(owner)[0]
                if self._together(owner, heir) < before - NOTHING:
                    break
                self.types[owner], self.types[heir] = kept

    def _together(self, one: int, other: int) -> float:
        """Returns what two rooms cost as they are, the numbers of rooms included; a door between them counts twice."""
        counted = self._suiting.in_all(Counter(name for name in self.types if name))
        return self._near(one, self.types[one]) + self._near(other, self.types[other]) + counted

    def _exchange(self, free: Sequence[int]) -> None:
        """Exchanges the types of two rooms where that is cheaper."""
        for i, a in enumerate(free):
            for b in free[i + 1 :]:
                if self.types[a] == self.types[b]:
                    continue
                before = self._near(a, self.types[a]) + self._near(b, self.types[b])
                self.types[a], self.types[b] = self.types[b], self.types[a]
                if self._near(a, self.types[a]) + self._near(b, self.types[b]) > before - NOTHING:
                    self.types[a], self.types[b] = self.types[b], self.types[a]
