"""`aligned_with`: its middle in line with another piece's middle."""

from solver.relations.relation import ANYWHERE, Box, Fit, Relation


class AlignedWith(Relation):
    """Has its middle in line with another piece's middle, along either axis."""

    by_degree = among_copies = into_line = True

    def boxes(self, fit: Fit) -> list[Box]:
        """Middles in line, across or along."""
        nearly = fit.tolerance.nearly_mm
        return [((-nearly, nearly), ANYWHERE), (ANYWHERE, (-nearly, nearly))]
