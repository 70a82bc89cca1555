"""How well a room suits a type: one number, lower is better.

All area, side and access numbers are the catalog's; the weights are our choice.
"""

from collections.abc import Mapping, Sequence, Set
from functools import lru_cache
from math import log
from typing import Final

from catalogs.schema import Catalogs, RoomType
from solver.floorplan.access import THROUGH_OTHER, AccessPlan, is_private, passing_cost
from solver.floorplan.tiling import Joint, Layout, neighbours

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


def cars_of(kind: RoomType) -> int:
    """Returns how many cars a room type holds, at least one."""
    asked = [count for line in kind.requires for name, count in line.items() if name == "car"]
    held = [piece.count for piece in kind.pieces if "car" in ([one.kind for one in piece.kinds] or [piece.piece])]
    return max((*asked, *held, 1))


@lru_cache(maxsize=64)
def _wet_and_garages(catalogs: Catalogs) -> tuple[Set[str], Mapping[str, int]]:
    """Returns the types that are wet, and how many cars those hold that have a garage door."""
    rooms = catalogs.rooms
    return {name for name in rooms if rooms[name].plan.wet}, {name: cars_of(rooms[name]) for name in rooms if rooms[name].plan.garage_door}


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
        self._wet, self.cars = _wet_and_garages(catalogs)

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
        cost = 0.0 if through is None else self._behind(through, name)
        if not children or self.rooms[name].plan.way_through:
            return cost
        return cost + sum(0.0 if self._may_own(name, child, types[child]) else IMPOSSIBLE for child in children)

    def _may_own(self, name: str, child: int, given: str | None) -> bool:
        """Tells whether the room behind is, or could well be, one that may lie behind the type; it must lead no further."""
        if child in self.access_plan.through:
            return False
        if given is not None:
            return self._leads(name, given)
        return any(name in kind.plan.behind and self.shape(child, own) < MISFIT for own, kind in self.rooms.items())

    def _behind(self, through: str, name: str) -> float:
        """Cost of a type behind a room of another."""
        if not self._leads(through, name):
            return IMPOSSIBLE
        front = self.rooms[through].plan
        return PAST_LIVING if front.way_through and front.habitable and is_private(name, self.rooms) else 0.0

    def _leads(self, through: str, entered: str) -> bool:
        """Tells whether one type may be entered through another, even where that bedroom becomes the children's."""
        becomes = (through, "kids_bedroom") if through == "bedroom" else (through,)
        return all(passing_cost(name, entered, self.rooms) < THROUGH_OTHER for name in becomes)

    def company(self, room: int, name: str, types: Sequence[str | None]) -> float:
        """Cost of a type by its neighbours: pipes together, the table by the kitchen."""
        if name in self._wet:
            beside = (types[i] for i in self.beside[room])
            return WET_APART if self._wet.isdisjoint(beside) else 0.0
        if name == "dining_room":
            return 0.0 if any(types[i] == "kitchen" for i in self.beside[room]) else TABLE_APART
        return 0.0

    def cost(self, room: int, name: str, types: Sequence[str | None]) -> float:
        """Returns the whole cost of a type in a room among the types known so far."""
        shape = self.shape(room, name)
        return shape if shape >= IMPOSSIBLE else shape + self.access(room, name, types) + self.company(room, name, types)
