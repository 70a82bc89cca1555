"""Who is entered through whom in a planned home: passages between the rooms one lives in, doors off the hallway."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from solver.floorplan.access import HOP, THROUGH_OTHER, THROUGH_PRIVATE, RoomAccess, is_private, passing_cost

NEVER: Final = 1000.0
"""Cost of the way to an own bathroom from anywhere but its bedroom, and of a way through it."""
OFF_HALLWAY: Final = 0.3
"""Cost of entering a living space from the hallway: from the next living space it is a passage, and costs less."""
BED_FROM_ENTRY: Final = 4.0
"""Cost of a bedroom entered from the entrance room, beside what it costs to walk through that."""
OFF_ENTRY: Final = 0.4
"""Cost of a small room entered from the entrance room: from the hallway beside it, it is out of sight."""
LIVING_TO_PRIVATE: Final = 1.2
"""Cost of a private room entered from a living space."""
SERVICE: Final = 0.1
"""Cost of a small wet room entered from the kitchen, of a garage entered from a laundry."""


@dataclass(frozen=True)
class HomeAccess(RoomAccess):
    """A planned home's rooms: `owners` names the bedroom of every own bathroom, `entrance` the entrance room."""

    owners: Mapping[int, int] = field(default_factory=dict)
    entrance: int = 0

    def cost(self, through: int, entered: int) -> float:
        """Returns what it costs to enter one room through another."""
        if through in self.owners:
            return NEVER
        if entered in self.owners:
            return HOP if self.owners[entered] == through else NEVER
        return HOP + self._passing(through, entered)

    def _passing(self, through: int, entered: int) -> float:
        via, to = self.rooms[self.types[through]].plan, self.rooms[self.types[entered]]
        if not via.way_through:
            if self.types[through] in to.plan.behind and not is_private(self.types[through], self.rooms):
                return SERVICE
            return (
                THROUGH_PRIVATE
                if is_private(self.types[through], self.rooms)
                else max(passing_cost(self.types[through], self.types[entered], self.rooms), THROUGH_OTHER)
            )
        private = is_private(self.types[entered], self.rooms)
        if private and not to.plan.wet and through == self.entrance:
            return BED_FROM_ENTRY
        if not via.habitable:
            if to.plan.way_through and to.plan.habitable:
                return OFF_HALLWAY if through != self.entrance else 0.0
            return OFF_ENTRY if through == self.entrance and not to.plan.way_through else 0.0
        if to.plan.way_through:
            return 0.0 if to.plan.habitable else SERVICE
        if via.wet and to.plan.wet and not private:
            return 0.0
        return LIVING_TO_PRIVATE
