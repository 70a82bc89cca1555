"""`near`: close to a piece or an opening."""

import math

from catalogs.schema import RelationSpec
from solver.geometry import ALONG_X, Rect
from solver.pieces import Opened
from solver.relations.centred import about
from solver.relations.relation import SOUGHT, Box, Fit, Relation, Standing, Tolerance, distance_mm
from solver.relations.subject import Footing, Scope

NEAR_MM = 1500
"""How far is near where the relation names no distance."""


class Near(Relation):
    """Is drawn towards a piece, or stands within `distance` of an opening."""

    by_degree = among_copies = True

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """Within the distance of each opening."""
        wished = distance_mm(spec, NEAR_MM) - tolerance.inside_mm
        found = []
        for opening in scope.opened(*self.openings(spec)):
            x, z = opening.centre
            for half_x, half_z in _reaches(scope, footing, opening, wished):
                (a, b), (c, d) = about(x, half_x + footing.extent[0]), about(z, half_z + footing.extent[1])
                found.append(Rect(a, c, b, d))
        return found

    def boxes(self, fit: Fit) -> list[Box]:
        """A box inside the rounded one, and two longer ones beside it."""
        distance = distance_mm(fit.spec, NEAR_MM) - fit.tolerance.inside_mm
        x, z = fit.reach
        if distance < 0:
            return []
        flat, steep = 0.99 * distance, 0.14 * distance
        halves = [(0.7 * distance, 0.7 * distance), (flat, steep), (steep, flat)]
        return [((-int(x + a), int(x + a)), (-int(z + b), int(z + b))) for a, b in halves]

    def holds_in_room(self, scope: Scope, spec: RelationSpec, own: Standing) -> bool:
        """Tells whether it is within the distance of an opening."""
        wished = distance_mm(spec, NEAR_MM)
        return any(own.rect.distance_to_point(opening.centre) <= wished for opening in scope.opened(*self.openings(spec)))

    def holds_with(self, spec: RelationSpec, own: Standing, other: Standing) -> bool:
        """Tells whether the free distance between them is at most the wished one."""
        return own.rect.distance_to(other.rect) <= distance_mm(spec, NEAR_MM)


def _reaches(scope: Scope, footing: Footing, opening: Opened, wished: float) -> list[tuple[float, float]]:
    """Returns how far along x and z a footprint may be from an opening's middle: boxes inside the circle."""
    if wished < 0:
        return []
    if footing.wall is None:
        flat, steep = 0.95 * wished, 0.31 * wished
        return [(0.7 * wished, 0.7 * wished), (flat, steep), (steep, flat)]
    across = 1 if footing.wall in ALONG_X else 0
    low, high = ((footing.reach.x0, footing.reach.x1), (footing.reach.z0, footing.reach.z1))[across]
    off = max(low - opening.centre[across], opening.centre[across] - high, 0)
    if off > wished:
        return []
    along = math.sqrt(wished**2 - off**2)
    return [(along, wished) if across else (wished, along)]
