"""`in_corner`: in a corner of the room."""

from catalogs.schema import RelationSpec
from solver.geometry import Rect
from solver.relations.relation import SOUGHT, Relation, Tolerance
from solver.relations.subject import Footing, Scope


class InCorner(Relation):
    """Stands in a corner of the room: near two walls that meet."""

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """In each of the four corners."""
        clear = scope.clear
        w, d = footing.extent[0] + tolerance.nearly_mm, footing.extent[1] + tolerance.nearly_mm
        return [
            Rect(x, z, x + w, z + d) for z in (clear.z0, clear.z1 - d) for x in (clear.x0, clear.x1 - w)
        ]  # fmt: skip
