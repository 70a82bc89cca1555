"""`in_row`: continues a row at either end of another piece, or round the corner from it."""

from catalogs.schema import RelationSpec
from solver.relations.at_side import AtSide
from solver.relations.relation import Box, Fit, Standing

ROUND_CORNER_MM = 100
"""How near a row must come to what it continues round the corner from."""


class InRow(AtSide):
    """Stands at either end of another piece, backs in line and turned alike; with `wall: adjacent`, round the corner from it."""

    turns = at_walls = among_copies = True
    sought_mm, held_mm = (0, 0), (0, 20)

    def boxes(self, fit: Fit) -> list[Box]:
        """At either end, turned alike; round a corner no box says where."""
        return [] if fit.turn or fit.spec.wall == "adjacent" else super().boxes(fit)

    def align(self, spec: RelationSpec) -> str | None:
        """Backs are in line, always."""
        return "back"

    def holds_with(self, spec: RelationSpec, own: Standing, other: Standing) -> bool:
        """Tells whether it continues the row; round a corner it is enough to be close."""
        if spec.wall == "adjacent":
            return own.rect.distance_to(other.rect) <= ROUND_CORNER_MM
        return super().holds_with(spec, own, other)
