"""`near_door`: within a distance of a door."""

from __future__ import annotations

from catalogs.schema import RelationSpec
from solver.relations.near import Near


class NearDoor(Near):
    """Is `near` a door."""

    def openings(self, spec: RelationSpec) -> tuple[str, ...]:
        """Doors, whatever it names."""
        return ("door",)
