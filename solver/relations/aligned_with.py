"""`aligned_with`: its middle in line with another piece's middle."""

from __future__ import annotations

from catalogs.schema import RelationSpec
from solver.pieces import Link
from solver.relations.relation import ALIGN_PULL, ANYWHERE, Box, Fit, Relation


class AlignedWith(Relation):
    """Has its middle in line with another piece's middle, along either axis."""

    by_degree = among_copies = True

    def boxes(self, fit: Fit) -> list[Box]:
        """Middles in line, across or along."""
        nearly = fit.tolerance.nearly_mm
        return [((-nearly, nearly), ANYWHERE), (ANYWHERE, (-nearly, nearly))]

    def pulls(self, spec: RelationSpec, labels: list[str]) -> list[Link]:
        """Returns a pull of the middles into line."""
        return [Link(spec.type, labels[0], align=ALIGN_PULL)]
