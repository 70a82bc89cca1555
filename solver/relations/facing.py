"""`facing`: its front is turned to another piece or to an opening."""

from catalogs.schema import RelationSpec
from solver.geometry import FACING, OPPOSITE, WALL_BEHIND, Rect
from solver.relations.relation import ANYWHERE, SOUGHT, Box, Fit, Relation, Standing, Tolerance
from solver.relations.subject import Footing, Scope

AHEAD_MM = (250.0, 700.0, 1500.0)
"""Distances of the other's middle at which places are sought from where it lies within half a right angle of the front."""


class Facing(Relation):
    """Turns its front towards a piece or an opening; in a slot of that piece the slot does it."""

    turns = True

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """Anywhere, turned to the wall of an opening."""
        ahead = OPPOSITE[WALL_BEHIND[footing.rotation % 360]]
        return [footing.reach] if any(opening.wall == ahead for opening in scope.opened(*spec.of)) else []

    def boxes(self, fit: Fit) -> list[Box]:
        """Straight before the own front, or within half a right angle of it at several distances."""
        x, z = fit.reach
        level = fit.turn % 180 == 0
        aside = (fit.parent[0] if level else fit.parent[1]) / 2 - fit.tolerance.inside_mm
        ranges = [(z if level else x, aside), *((ahead, ahead - 10) for ahead in AHEAD_MM)]
        return [_before(fit.turn, least + fit.spare, half) for least, half in ranges if half > 0]

    def holds_with(self, spec: RelationSpec, own: Standing, other: Standing) -> bool:
        """Tells whether the other's middle lies before its front, no farther aside than ahead; or the other straight before it."""
        dx, dz = FACING[own.rotation]
        x, z = other.double_centre[0] - own.double_centre[0], other.double_centre[1] - own.double_centre[1]
        ahead, aside = x * dx + z * dz, abs(x * dz) + abs(z * dx)
        a, b = own.rect, other.rect
        reach, width = (a.width + b.width, b.depth) if dx else (a.depth + b.depth, b.width)
        return aside <= ahead > 0 or (ahead >= reach and aside <= width)


def _before(turn: int, least: float, half: float) -> Box:
    """Returns the places from which a piece with that turn has the other's centre before it, so far off and aside."""
    dx, dz = FACING[turn]
    side = (-half, half)
    ahead = {1: (ANYWHERE[0], -least), -1: (least, ANYWHERE[1])}
    return (ahead[dx], side) if dx else (side, ahead[dz])
