"""Gives every room its type: a deterministic sequence of rules, then the rest by fitness and variety.

No randomness: the plan's rooms are varied enough.
"""

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Final

from catalogs.schema import RoomType
from solver.errors import RequestError
from solver.floorplan.bsp import MAX_ROOMS
from solver.floorplan.fitness import IMPOSSIBLE, MISFIT, Fitness
from solver.request import Request

KITCHEN_M2: Final = 8.0
MASTER_M2: Final = 12.0
"""Least kitchen, where none of its typical area is to be had, and least master bedroom where the rooms allow, m2."""
PROGRAMME: Final = (
    "bathroom", "kitchen", "living_room", "bedroom_master", "bedroom", "dining_room", "bathroom", "office", "laundry",
    "bedroom", "garage", "bathroom", "bedroom", "workshop", "office", "bedroom", "living_room", "bathroom", "bedroom",
)  # fmt: skip
"""What a house of n rooms holds: the first n of these, from the start again when they run out. Our choice, from what
people build: a second bathroom by the seventh room, a garage by the eleventh, a family room in large houses."""
ONCE: Final = ("kitchen", "bedroom_master", "dining_room", "laundry", "garage")
"""Types of which a house wishes one, and one more for every 40 rooms."""
MOST: Final = {"kitchen": 1, "bedroom_master": 1, "living_room": 2, "dining_room": 1}
"""Of which a household has no more, however well a room would suit them; as many again for every 40 rooms."""
HOUSEHOLD: Final = ("kitchen", "garage", "laundry", "workshop", "living_room")
"""Types whose repetition makes two households of a house, or looks odd in a home: it costs thrice as much."""
SMALL: Final = 0.75
"""Below this share of its typical area a second one of a type is no gain."""
TOO_MANY: Final = 100.0
"""Cost of a type of which there are the most already: above that of any misfit."""
FOYER: Final = (1.5, 3.0)
"""Cost of a hallway that is a whole room: without and with an outside wall, which a living space would want more."""
OUTDOOR: Final = ("backyard", "patio")
"""What the outdoor option makes of the largest rooms to spare, in this order."""


def check_forced(request: Request, count: int, rooms: Mapping[str, RoomType]) -> None:
    """Checks the request's forced types.

    Raises:
        RequestError: an index the plan does not have, or a type the catalog does not have.
    """
    for index, name in sorted(request.force_types.items()):
        field = f"force_types[{index}]"
        if not 0 <= index < count:
            raise RequestError(field, f"this plan has no room {index}", f"0 to {count - 1}")
        if name not in rooms:
            raise RequestError(field, f"unknown room type {name!r}", ", ".join(sorted(rooms)))


def classify(fitness: Fitness, request: Request) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Gives every room of a layout a type; returns the types by room index, and notes.

    Of the request `force_types`, which must have been checked, and `outdoor` are read.
    """
    draft = _Draft(fitness, request)
    draft.essentials()
    draft.fronts()
    draft.rest()
    draft.improve()
    notes = draft.outdoors() if request.outdoor else ()
    draft.kids()
    return tuple(t or "hallway" for t in draft.types), notes


class _Draft:
    """The types given so far."""

    def __init__(self, fitness: Fitness, request: Request) -> None:
        layout = fitness.layout
        self.fitness, self.area = fitness, fitness.area
        self.types: list[str | None] = ["hallway" if i < layout.hallways else None for i in range(len(layout.rooms))]
        for index, name in request.force_types.items():
            self.types[index] = name
        self.unforced = sorted((i for i, t in enumerate(self.types) if t is None), key=lambda i: (self.area[i], i))
        self.fixed: set[int] = set()
        self.group = dict(zip(fitness.rooms, fitness.rooms, strict=True)) | dict.fromkeys(fitness.cars, "garage")
        """Garages of any size count as one type."""
        none = dict.fromkeys((*self.group.values(), *PROGRAMME), 0)
        self.counts = none | Counter(self.group[t] for t in self.types if t is not None)
        self.households = 1 + (len(layout.rooms) - layout.hallways) // 40
        self.most = {group: self.households * MOST.get(group, MAX_ROOMS) for group in none}
        self.wish = none | self._wishes(len(layout.rooms) - layout.hallways)
        self.names = sorted({name for name in PROGRAMME if name in fitness.rooms} | fitness.cars.keys())

    def _wishes(self, count: int) -> Counter[str]:
        wish = Counter(PROGRAMME[i % len(PROGRAMME)] for i in range(count))
        for name in ONCE:
            wish[name] = min(wish[name], self.households)
        return wish

    def give(self, room: int, name: str, fixed: bool = False) -> None:
        """Gives a room a type, in place of the one it may have had."""
        old = self.types[room]
        if old is not None:
            self.counts[self.group[old]] -= 1
        self.types[room] = name
        self.counts[self.group[name]] += 1
        if fixed:
            self.fixed.add(room)

    def untyped(self) -> list[int]:
        """Returns the rooms without a type, smallest first."""
        return [i for i in self.unforced if self.types[i] is None]

    def essentials(self) -> None:
        """Bathroom, living room, kitchen, dining room, master bedroom, as far as the rooms go and nobody forced them."""
        rooms = len(self.unforced)
        if rooms >= 2 and not self.counts["bathroom"]:
            self.give(self.untyped()[0], "bathroom", fixed=True)
        if rooms != 2 and self.untyped() and not self.counts["living_room"]:
            self.give(min(self.untyped(), key=self._living), "living_room", fixed=True)
        if self.untyped() and not self.counts["kitchen"]:
            self.give(min(self._kitchens(), key=self._kitchen), "kitchen", fixed=True)
        if self.wish["dining_room"] and self.untyped() and not self.counts["dining_room"]:
            room = min(self.untyped(), key=lambda i: (self.fitness.cost(i, "dining_room", self.types), i))
            if self.fitness.cost(room, "dining_room", self.types) < MISFIT:
                self.give(room, "dining_room", fixed=True)
        if rooms >= 4 and self.untyped() and not self.counts["bedroom_master"]:
            room = min(self.untyped(), key=self._master)
            self.give(room, "bedroom_master" if self.area[room] >= MASTER_M2 else "bedroom", fixed=True)

    def _kitchens(self) -> list[int]:
        """Returns the rooms as large as kitchens are, else those no smaller than they may be; at the outside if any is."""
        left, asked = self.untyped(), self.fitness.rooms["kitchen"].area
        lit = [i for i in left if self.fitness.outside[i]] or left
        fit = [i for i in lit if asked.typical <= self.area[i] <= asked.max]
        return fit or [i for i in lit if self.area[i] >= KITCHEN_M2] or left[-1:]

    def _kitchen(self, room: int) -> tuple[float, int]:
        """A kitchen has a room beside it in which to eat."""
        beside = set(self.fitness.beside[room]).intersection(self.untyped()) if self.wish["dining_room"] else ()
        table = min((self.fitness.cost(i, "dining_room", self.types) for i in beside), default=MISFIT)
        return table + self.fitness.cost(room, "kitchen", self.types), room

    def _living(self, room: int) -> tuple[float, int]:
        """A living room is the largest that is not too large; best one that others are entered through."""
        cost = self.fitness.cost(room, "living_room", self.types) - 0.05 * self.area[room]
        return cost - (2.0 if room in self.fitness.access_plan.through else 0.0), room

    def _master(self, room: int) -> tuple[float, int]:
        """A master bedroom has a bathroom behind it that is not too large."""
        small = 20.0 if self.area[room] < MASTER_M2 else 0.0
        behind = self.fitness.children.get(room, ())
        bath = min((0.0, *(self.fitness.shape(i, "bathroom") - 1.0 for i in behind)))
        return self.fitness.cost(room, "bedroom_master", self.types) + small + bath, room

    def _more(self, room: int, name: str) -> float:
        """Cost of a type besides what it costs in the room: of one more room of it.

        That is a bonus up to the wish, then ever steeper; a second one that is too large or small is no bonus.
        """
        if name == "hallway":
            return FOYER[bool(self.fitness.outside[room])]
        group = self.group[name]
        there, over = self.counts[group], self.counts[group] + 1 - self.wish[group]
        if there >= self.most[group]:
            return TOO_MANY
        if over <= 0:
            asked = self.fitness.rooms[name].area
            return 2.0 if there and not SMALL * asked.typical <= self.area[room] <= asked.max else -0.8
        return (6.0 if group in HOUSEHOLD else 2.0) * math.pow(over, 1.3)

    def _least(self, room: int, names: Sequence[str]) -> tuple[float, str]:
        """Returns what the type costs that suits the room best now, and the type; a shape costs nothing at least."""
        fitness, best = self.fitness, (math.inf, "")
        for more, name in sorted([(self._more(room, name), name) for name in names]):
            if more > best[0]:
                break
            if fitness.shape(room, name) + more <= best[0]:
                best = min(best, (fitness.cost(room, name, self.types) + more, name))
        return best

    def names_for(self, room: int) -> list[str]:
        """Returns the types to choose from: a room that others are entered through may be a hallway."""
        foyer = room in self.fitness.access_plan.through and not self.fitness.layout.spine
        return [*self.names, "hallway"] if foyer else self.names

    def best(self, room: int) -> str:
        """Returns the type that suits the room best now."""
        return self._least(room, self.names_for(room))[1]

    def fronts(self) -> None:
        """Rooms that others are entered through, largest first, each together with a room behind it."""
        for room in reversed([i for i in self.untyped() if i in self.fitness.access_plan.through]):
            behind = [i for i in self.fitness.children.get(room, ()) if self.types[i] is None]
            if len(behind) == 1:
                self._pair(room, behind[0])
            else:
                self.give(room, self.best(room))

    def _pair(self, front: int, back: int) -> None:
        best = (math.inf, "", "")
        for name in self.names_for(front):
            cost = self.fitness.cost(front, name, self.types) + self._more(front, name)
            if cost >= IMPOSSIBLE:
                continue
            self.types[front] = name
            more, other = self._least(back, self.names)
            best = min(best, (cost + more, name, other))
        self.types[front] = None
        if best[1]:
            self.give(front, best[1])
            self.give(back, best[2])

    def rest(self) -> None:
        """Rooms without an outside wall or behind others first: they suit the fewest types; then by size."""
        fitness = self.fitness

        def order(room: int) -> tuple[bool, float, int]:
            return bool(fitness.outside[room]) and fitness.access_plan.parent[room] is None, -self.area[room], room

        for room in sorted(self.untyped(), key=order):
            self.give(room, self.best(room))

    def improve(self) -> None:
        """Looks at every free room once more, now that the others are known."""
        for room in self.unforced:
            now = self.types[room]
            if room not in self.fixed and now is not None:
                self.counts[self.group[now]] -= 1
                self.types[room] = None
                self.give(room, self.best(room))

    def outdoors(self) -> tuple[str, ...]:
        """Turns the largest rooms that the house can spare into a garden and a terrace."""
        notes = []
        for name in OUTDOOR:
            spare = [i for i in self.unforced if self._spare(i, name)]
            if spare:
                self.give(max(spare, key=lambda i: (self.area[i], -i)), name, fixed=True)
            else:
                notes.append(f"no {name}: every room with an outside wall and {self.fitness.rooms[name].area.min[0]} m2 is needed")
        return tuple(notes)

    def _spare(self, room: int, name: str) -> bool:
        """Tells whether the house can do without the room, and nobody walks through it or privately into it."""
        if room in self.fixed or room in self.fitness.access_plan.through or not self.fitness.outside[room]:
            return False
        return self.fitness.access(room, name, self.types) < IMPOSSIBLE and self.area[room] >= self.fitness.rooms[name].area.min[0]

    def kids(self) -> None:
        """The smallest plain bedroom is the children's, where there is another to sleep in."""
        plain = [i for i in self.unforced if self.types[i] == "bedroom"]
        if plain and self.counts["bedroom_master"] + len(plain) >= 2 and not self.counts["kids_bedroom"]:
            self.give(plain[0], "kids_bedroom")
