"""`centred`: in the middle of its wall, or of the room."""

from __future__ import annotations

import math

from catalogs.schema import RelationSpec
from solver.geometry import ALONG_X, Rect
from solver.pieces import Candidate
from solver.relations.relation import SOUGHT, Effect, Relation, Tolerance, missed
from solver.relations.subject import Footing, Scope, Subject
from solver.scene import WALLS

CENTRED_REACH_MM = 1000
"""A piece this far from where it should be centred pays the full cost."""


class Centred(Relation):
    """Stands in the middle: of the wall at its back, or of the room."""

    def effect(self, subject: Subject, spec: RelationSpec) -> Effect:
        """Tries the middles, and costs by the distance from them."""
        middle = subject.scope.clear.centre

        def cost_of(candidate: Candidate) -> float:
            offsets = [abs(candidate.anchor_mm[axis] - middle[axis]) for axis in (0, 1)]
            if candidate.wall is not None:
                offsets = [offsets[0] if candidate.wall in ALONG_X else offsets[1]]
            return off_middle(spec, max(offsets))

        kinds = [kind.name for kind, _ in subject.variants]
        positions = tuple((wall, kind, middle[0] if wall in ALONG_X else middle[1]) for wall in WALLS for kind in kinds)
        return Effect(cost_of=cost_of, positions=positions, spots=tuple((kind, middle) for kind in kinds), weight=spec.weight)

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


def off_middle(spec: RelationSpec, off_mm: float) -> float:
    """Returns what being off a middle costs: by degree, and everything where the relation is hard."""
    return missed(spec) * min(1.0, off_mm / CENTRED_REACH_MM) if off_mm else 0.0
