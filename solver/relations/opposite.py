"""`opposite`: at the wall opposite another piece, facing it."""

from catalogs.schema import RelationSpec
from solver.geometry import OPPOSITE
from solver.relations.relation import ANYWHERE, Box, Fit, Relation


class Opposite(Relation):
    """Stands at the wall opposite another piece, each looking at the other, one's middle on the other."""

    turns = at_walls = into_line = True

    def boxes(self, fit: Fit) -> list[Box]:
        """Before the other's front, turned to it."""
        half = max(fit.parent[0], fit.own[0]) / 2 - fit.tolerance.inside_mm
        return [((-half, half), (fit.reach[1] + fit.spare, ANYWHERE[1]))] if fit.turn == 180 and half > 0 else []

    def suits(self, spec: RelationSpec, mine: str | None, theirs: str | None) -> bool:
        """Tells whether it stands at the opposite wall, where the other is at one."""
        return (theirs is None or mine == OPPOSITE[theirs]) and super().suits(spec, mine, theirs)
