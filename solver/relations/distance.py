"""What near and far_from have in common: the cost of being beyond or short of a distance to an opening."""

from __future__ import annotations

from catalogs.schema import RelationSpec
from solver.pieces import Candidate
from solver.relations.relation import NOTHING, Effect, distance_mm, missed
from solver.relations.subject import Subject


def off_distance(subject: Subject, spec: RelationSpec, kinds: tuple[str, ...], meant: tuple[int, int]) -> Effect:
    """Returns the cost of being beyond or short of the wished distance to the nearest opening of some kinds.

    Args:
        subject: the piece.
        spec: the relation.
        kinds: of openings.
        meant: the distance, mm, where the relation names none; 1 where being beyond it costs, -1 where being short of it does.
    """
    default, sign = meant
    points = [opening.centre for opening in subject.scope.opened(*kinds)]
    wished = max(distance_mm(spec, default), 10) / 1000
    if not points:
        return NOTHING

    def cost_of(candidate: Candidate) -> float:
        off = sign * (min(candidate.footprint.distance_to_point(point) for point in points) / 1000 - wished)
        return missed(spec) * min(1.0, off / wished) if off > 0 else 0.0

    return Effect(cost_of=cost_of)
