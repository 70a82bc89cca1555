"""`against_wall`: its back is at a wall."""

from catalogs.schema import RelationSpec
from solver.geometry import Rect
from solver.relations.relation import SOUGHT, Relation, Tolerance
from solver.relations.subject import Footing, Scope


class AgainstWall(Relation):
    """Stands with its back to a wall; `walls` says what walls of each sort cost."""

    at_walls = True

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """At any wall."""
        return [footing.reach] if footing.wall else []
