"""`against_wall`: its back is at a wall."""

from __future__ import annotations

from catalogs.schema import RelationSpec
from solver.geometry import ALONG_X, Rect
from solver.pieces import Candidate
from solver.relations.relation import SOUGHT, Effect, Relation, Tolerance, missed
from solver.relations.subject import Footing, Scope, Subject

LONGER = 1.15
"""A wall is long, and those beside it short, from this ratio on: a square room has neither."""


class AgainstWall(Relation):
    """Stands with its back to a wall; `walls` says what walls of each sort cost."""

    at_walls = True

    def effect(self, subject: Subject, spec: RelationSpec) -> Effect:
        """Tries free pieces at walls too, and costs by the sort of the wall."""
        scope = subject.scope

        def cost_of(candidate: Candidate) -> float:
            if candidate.wall is None:
                return missed(spec)
            return sum(cost for sort, cost in spec.walls.items() if _is(scope, candidate, candidate.wall, sort))

        return Effect(cost_of=cost_of, backs=True)

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """At any wall."""
        return [footing.reach] if footing.wall else []


def _is(scope: Scope, candidate: Candidate, wall: str, sort: str) -> bool:
    """Tells whether the wall behind a candidate is of a sort; only a window right behind it counts."""
    here = [opening for opening in scope.openings if opening.wall == wall]
    if sort == "window":
        a, b = candidate.footprint.along(wall)
        behind = any(one.kind == "window" and one.interval[0] < b and a < one.interval[1] for one in here)
        return behind or _beside_window(scope, candidate)
    own, other = (scope.clear.width, scope.clear.depth) if wall in ALONG_X else (scope.clear.depth, scope.clear.width)
    return {
        "door": any(one.kind != "window" for one in here),
        "plain": not here,
        "exterior": getattr(scope.exterior, wall, False),
        "long": own > LONGER * other,
        "short": other > LONGER * own,
    }[sort]


def _beside_window(scope: Scope, candidate: Candidate) -> bool:
    """Tells whether a piece's long side lies before the middle of a window of another wall: a bed lengthwise under it."""
    rect, near = candidate.footprint, 2 * scope.gap_mm
    if candidate.size_mm[1] <= candidate.size_mm[0]:
        return False
    others = [
        one for one in scope.opened("window") if one.wall != candidate.wall and rect.wall_distance(one.wall, scope.clear) <= near
    ]  # fmt: skip
    return any(a < sum(one.interval) // 2 < b for one in others for a, b in (rect.along(one.wall),))
