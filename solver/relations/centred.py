"""`centred`: in the middle of its wall, or of the room."""

import math

from catalogs.schema import RelationSpec
from solver.geometry import ALONG_X, Rect
from solver.relations.relation import SOUGHT, Relation, Tolerance
from solver.relations.subject import Footing, Scope


class Centred(Relation):
    """Stands in the middle: of the wall at its back, or of the room."""

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """About the middle of the wall, or of the room."""
        clear = scope.clear
        x0, x1 = about((clear.x0 + clear.x1) / 2, footing.extent[0] / 2 + tolerance.nearly_mm)
        z0, z1 = about((clear.z0 + clear.z1) / 2, footing.extent[1] / 2 + tolerance.nearly_mm)
        if footing.wall is None:
            return [Rect(x0, z0, x1, z1)]
        return [Rect(x0, clear.z0, x1, clear.z1) if footing.wall in ALONG_X else Rect(clear.x0, z0, clear.x1, z1)]


def about(middle: float, half: float) -> tuple[int, int]:
    """Returns the whole millimetres within a distance of a middle."""
    return math.ceil(middle - half), math.floor(middle + half)
