"""`in_corner`: in a corner of the room."""

from __future__ import annotations

from catalogs.schema import RelationSpec
from solver.geometry import Rect
from solver.pieces import Candidate
from solver.relations.relation import SOUGHT, Effect, Relation, Tolerance, missed
from solver.relations.subject import Footing, Scope, Subject


class InCorner(Relation):
    """Stands in a corner of the room: near two walls that meet."""

    def effect(self, subject: Subject, spec: RelationSpec) -> Effect:
        """Tries the corners, and costs elsewhere."""
        clear, near = subject.scope.clear, 2 * subject.scope.gap_mm

        def cost_of(candidate: Candidate) -> float:
            rect = candidate.footprint
            away = [min(rect.wall_distance(wall, clear) for wall in walls) for walls in (("west", "east"), ("north", "south"))]
            return 0.0 if max(away) <= near else missed(spec)

        return Effect(cost_of=cost_of, corners=True, weight=spec.weight)

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """In each of the four corners."""
        clear = scope.clear
        w, d = footing.extent[0] + tolerance.nearly_mm, footing.extent[1] + tolerance.nearly_mm
        return [
            Rect(x, z, x + w, z + d) for z in (clear.z0, clear.z1 - d) for x in (clear.x0, clear.x1 - w)
        ]  # fmt: skip
