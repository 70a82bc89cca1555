"""How well a room suits a type: one number, lower is better.

All area, side and access numbers are the catalog's; the weights are our choice.
"""

from collections.abc import Sequence
from functools import lru_cache
from math import log
from typing import Final

from catalogs.schema import Catalogs, RoomType
from solver.floorplan.access import THROUGH_OTHER, AccessPlan, is_private, passing_cost
from solver.floorplan.tiling import Joint, Layout, neighbours
from solver.records import MadeOnce

CAR_DOOR_MM: Final = 2400
"""Width of a garage door, mm a car."""
IMPOSSIBLE: Final = 1000.0
"""A cost no plain preference reaches: the type cannot be there."""
DARK: Final = 12.0
"""Cost of a habitable room without an outside wall: more than one of three times its largest area. Twice as much to sleep in."""
PAST_LIVING: Final = 4.0
"""Cost of a bedroom or bathroom behind a room one lives in, whose guests are walked past: less than that of a misfit."""
MISFIT: Final = 6.0
"""From this cost on a type is no use of a room: it is too small, or half too large."""
WET_APART: Final = 0.4
TABLE_APART: Final = 1.0
"""Costs of a wet room without a wet neighbour and of a dining room away from the kitchen."""
_MOST_KEPT: Final = 10_000
"""Pairs of types of which it is kept what they are to each other."""


def cars_of(kind: RoomType) -> int:
    """Returns how many cars a room type holds, at least one."""
    asked = [count for line in kind.requires for name, count in line.items() if name == "car"]
    held = [piece.count for piece in kind.pieces if "car" in ([one.kind for one in piece.kinds] or [piece.piece])]
    return max((*asked, *held, 1))


class _Types:
    """What room types are to each other, whatever the layout.

    `wet` are those with pipes, `cars` tells how many those hold that have a garage door, `behind` which may be entered through one alone.
    `leads` tells whether the first of two may be come through to the second, `past` what it costs that the second lies behind the first.
    """

    def __init__(self, catalogs: Catalogs) -> None:
        self._rooms = rooms = catalogs.rooms
        self.wet = {name for name, kind in rooms.items() if kind.plan.wet}
        self.cars = {name: cars_of(kind) for name, kind in rooms.items() if kind.plan.garage_door}
        self.behind = {name: [own for own, kind in rooms.items() if name in kind.plan.behind] for name in rooms}
        self.leads = MadeOnce[tuple[str, str], bool](self._leads, _MOST_KEPT)
        self.past = MadeOnce[tuple[str, str], float](self._past, _MOST_KEPT)

    def _leads(self, pair: tuple[str, str]) -> bool:
        """Even where that bedroom becomes the children's."""
        through, entered = pair
        becomes = (through, "kids_bedroom") if through == "bedroom" else (through,)
        return all(passing_cost(name, entered, self._rooms) < THROUGH_OTHER for name in becomes)

    def _past(self, pair: tuple[str, str]) -> float:
        if not self.leads[pair]:
            return IMPOSSIBLE
        front = self._rooms[pair[0]].plan
        return PAST_LIVING if front.way_through and front.habitable and is_private(pair[1], self._rooms) else 0.0


_types_of: Final = lru_cache(maxsize=64)(_Types)


class Fitness:
    """Costs of types in the rooms of one layout; remembers what it has computed."""

    def __init__(self, layout: Layout, shared: Sequence[Joint], access_plan: AccessPlan, catalogs: Catalogs) -> None:
        self.layout, self.access_plan, self.rooms = layout, access_plan, catalogs.rooms
        by_room = neighbours(len(layout.rooms), tuple(shared))
        self.beside = [tuple(joint.other(i) for joint in by_room[i]) for i in range(len(layout.rooms))]
        self.outside = [tuple(exposed) for exposed in layout.exposed]
        self.children: dict[int, list[int]] = {}
        for child, parent in enumerate(access_plan.parent):
            if parent is not None:
                self.children.setdefault(parent, []).append(child)
        more = layout.walls.more
        self._sides = [sorted((rect.width - more, rect.depth - more)) for rect in layout.rooms]
        self.area = [short * long / 1e6 for short, long in self._sides]
        self._shape: dict[tuple[int, str], float] = {}
        self._types = _types_of(catalogs)
        self.cars = self._types.cars

    def shape(self, room: int, name: str) -> float:
        """Cost of a type by the room's size, form and outside walls alone."""
        known = self._shape.get((room, name))
        if known is None:
            known = self._shape[room, name] = self._shape_of(room, name)
        return known

    def _shape_of(self, room: int, name: str) -> float:
        (short, long), sides, kind = self._sides[room], self.outside[room], self.rooms[name]
        area, asked, plan = self.area[room], kind.area, kind.plan
        least = asked.min[room in self.access_plan.through]
        if area < least:
            size = 10.0 + 20.0 * (least - area) / least
        else:
            size = (2.0 + 8.0 * log(area / asked.max) if area > asked.max else 0.0) + 0.7 * abs(log(area / asked.typical))
        form = (8.0 if short < round(kind.short_side * 1000) else 0.0) + max(0.0, long / short - kind.aspect)
        light = 0.0 if sides or not plan.habitable else DARK * (2.0 if is_private(name, self.rooms) else 1.0)
        if name not in self.cars:
            return size + form + (light + (IMPOSSIBLE if plan.street and not sides else 0.0))
        rect, need = self.layout.rooms[room], CAR_DOOR_MM * self.cars[name] + 400
        wide = [side for side in sides if rect.along(side)[1] - rect.along(side)[0] >= need]
        return size + form + (light + (IMPOSSIBLE if not wide else 0.0 if "south" in wide else 1.5))

    def access(self, room: int, name: str, types: Sequence[str | None]) -> float:
        """Cost of a type by who is entered through whom; rooms without a type yet are taken as willing."""
        parent, children = self.access_plan.parent[room], self.children.get(room)
        through = types[parent] if parent is not None else None
        cost = 0.0 if through is None else self._types.past[through, name]
        if not children or self.rooms[name].plan.way_through:
            return cost
        return cost + sum(0.0 if self._may_own(name, child, types[child]) else IMPOSSIBLE for child in children)

    def _may_own(self, name: str, child: int, given: str | None) -> bool:
        """Tells whether the room behind is, or could well be, one that may lie behind the type; it must lead no further."""
        if child in self.access_plan.through:
            return False
        if given is not None:
            return self._types.leads[name, given]
        return any(self.shape(child, own) < MISFIT for own in self._types.behind[name])

    def company(self, room: int, name: str, types: Sequence[str | None]) -> float:
        """Cost of a type by its neighbours: pipes together, the table by the kitchen."""
        if name in self._types.wet:
            return WET_APART if self._types.wet.isdisjoint([types[i] for i in self.beside[room]]) else 0.0
        if name == "dining_room":
            return 0.0 if any(types[i] == "kitchen" for i in self.beside[room]) else TABLE_APART
        return 0.0

    def cost(self, room: int, name: str, types: Sequence[str | None]) -> float:
        """Returns the whole cost of a type in a room among the types known so far."""
        shape = self.shape(room, name)
        return shape if shape >= IMPOSSIBLE else shape + self.access(room, name, types) + self.company(room, name, types)
