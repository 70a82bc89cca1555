"""`far_from_door`: at least a distance from every door."""

from __future__ import annotations

from catalogs.schema import RelationSpec
from solver.relations.far_from import FarFrom


class FarFromDoor(FarFrom):
    """Is `far_from` every door."""

    def openings(self, spec: RelationSpec) -> tuple[str, ...]:
        """Doors, whatever it names."""
        return ("door",)
