"""`far_from`: at least a distance from a piece or an opening."""

import math

from catalogs.schema import RelationSpec
from solver.geometry import ALONG_X, Rect
from solver.pieces import Link
from solver.relations.relation import ANYWHERE, SOUGHT, Box, Fit, Relation, Standing, Tolerance, distance_mm
from solver.relations.subject import Footing, Scope

FAR_MM, FAR_FROM_OPENING_MM = 2000, 1500
"""How far is far from a piece, and from an opening, where the relation names no distance."""
EVERYWHERE = 1_000_000
PULL_BEYOND_M, PULL_SHARE = 1.0, 0.25
"""A piece is pushed away until it is that much farther than asked, at that share of the relation's cost."""


class FarFrom(Relation):
    """Keeps `distance` from a piece or an opening."""

    by_degree = with_all = among_copies = True

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """Rectangles clear of the square around every opening; along a wall, exactly clear of the circle."""
        wished = distance_mm(spec, FAR_FROM_OPENING_MM) + tolerance.inside_mm
        found = [footing.reach]
        for opening in scope.opened(*self.openings(spec)):
            half = _half_around(footing, opening.centre, wished)
            if half is not None:
                found = [part for rect in found for part in _without(rect, opening.centre, half) if _holds(part, footing.extent)]
        return found

    def boxes(self, fit: Fit) -> list[Box]:
        """Beyond the distance at any of four sides, or off any corner by less along each axis."""
        d = distance_mm(fit.spec, FAR_MM) + fit.tolerance.inside_mm
        x, z = (int(half) + 1 for half in fit.reach)
        low, high = ANYWHERE
        found: list[Box] = [((low, -x - d), ANYWHERE), ((x + d, high), ANYWHERE), (ANYWHERE, (low, -z - d)), (ANYWHERE, (z + d, high))]
        for part, rest in ((0.924, 0.383), (0.383, 0.924)):
            a, b = x + math.ceil(part * d), z + math.ceil(rest * d)
            found += [(across, along) for across in ((low, -a), (a, high)) for along in ((low, -b), (b, high))]
        return found

    def holds_in_room(self, scope: Scope, spec: RelationSpec, own: Standing) -> bool:
        """Tells whether it is at least the distance from every opening."""
        wished = distance_mm(spec, FAR_FROM_OPENING_MM)
        return all(own.rect.distance_to_point(opening.centre) >= wished for opening in scope.opened(*self.openings(spec)))

    def holds_with(self, spec: RelationSpec, own: Standing, other: Standing) -> bool:
        """Tells whether the free distance between them is at least the wished one."""
        return own.rect.distance_to(other.rect) >= distance_mm(spec, FAR_MM)

    def pulls(self, spec: RelationSpec, labels: list[str]) -> list[Link]:
        """Returns a weak push away from every piece named."""
        distance = PULL_BEYOND_M + distance_mm(spec, FAR_MM) / 1000
        return [Link(spec.type, label, apart_m=distance, apart_cost=PULL_SHARE * spec.cost / distance) for label in labels]


def _half_around(footing: Footing, point: tuple[int, int], wished: float) -> tuple[float, float] | None:
    """Returns how far along x and z from a point a footprint must stay clear; None where it is far enough anyway."""
    if footing.wall is None:
        return wished, wished
    across = 1 if footing.wall in ALONG_X else 0
    low, high = ((footing.reach.x0, footing.reach.x1), (footing.reach.z0, footing.reach.z1))[across]
    off = max(low - point[across], point[across] - high, 0)
    if off >= wished:
        return None
    half = math.sqrt(wished**2 - off**2)
    return (half, EVERYWHERE) if across else (EVERYWHERE, half)


def _without(rect: Rect, point: tuple[int, int], half: tuple[float, float]) -> list[Rect]:
    """Returns the four largest parts of a rectangle beside a box around a point."""
    a, b = math.floor(point[0] - half[0]), math.ceil(point[0] + half[0])
    c, d = math.floor(point[1] - half[1]), math.ceil(point[1] + half[1])
    if not rect.overlaps(Rect(a, c, b, d)):
        return [rect]
    return [
        Rect(rect.x0, rect.z0, min(a, rect.x1), rect.z1), Rect(max(b, rect.x0), rect.z0, rect.x1, rect.z1),
        Rect(rect.x0, rect.z0, rect.x1, min(c, rect.z1)), Rect(rect.x0, max(d, rect.z0), rect.x1, rect.z1),
    ]  # fmt: skip


def _holds(rect: Rect, extent: tuple[int, int]) -> bool:
    return rect.width >= extent[0] and rect.depth >= extent[1]
