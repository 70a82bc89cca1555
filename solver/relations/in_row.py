"""`in_row`: continues a row at either end of another piece, or round the corner from it."""

from __future__ import annotations

from catalogs.schema import RelationSpec
from solver.pieces import Link
from solver.relations.at_side import AtSide
from solver.relations.relation import NOTHING, Box, Effect, Fit, Standing, first
from solver.relations.subject import Subject
from solver.scene import WALLS

ROUND_CORNER_MM = 100
"""How near a row must come to what it continues round the corner from."""


class InRow(AtSide):
    """Stands at either end of another piece, backs in line and turned alike; with `wall: adjacent`, round the corner from it."""

    turns = at_walls = among_copies = True
    best_gap, sought_mm, held_mm = 0.0, (0, 0), (0, 20)

    def effect(self, subject: Subject, spec: RelationSpec) -> Effect:
        """Offers the slots at both ends, or the places next to each corner that leave room for the row's depth."""
        if spec.wall != "adjacent":
            return Effect(slots=self._slots(subject, spec, turn=False))
        label = first(subject, spec)
        if label is None:
            return NOTHING
        link = Link(spec.type, label, walls="adjacent", cost=spec.cost, required=spec.required, near=spec.weight)
        return Effect(links=(link,), positions=_beyond_corners(subject, spec))

    def boxes(self, fit: Fit) -> list[Box]:
        """At either end, turned alike; round a corner no box says where."""
        return [] if fit.turn or fit.spec.wall == "adjacent" else super().boxes(fit)

    def align(self, spec: RelationSpec) -> str | None:
        """Backs are in line, always."""
        return "back"

    def holds_with(self, spec: RelationSpec, own: Standing, other: Standing) -> bool:
        """Tells whether it continues the row; round a corner it is enough to be close."""
        if spec.wall == "adjacent":
            return own.rect.distance_to(other.rect) <= ROUND_CORNER_MM
        return super().holds_with(spec, own, other)


def _beyond_corners(subject: Subject, spec: RelationSpec) -> tuple[tuple[str, str, int], ...]:
    """Returns the centres along each wall, by kind, at which a piece begins where a row round the corner ends."""
    clear, gap = subject.scope.clear, subject.scope.gap_mm
    depths = sorted({parent.kind.size[1] for parent in subject.parents(spec.of)})
    found: list[tuple[str, str, int]] = []
    for kind, _ in subject.variants:
        for wall in WALLS:
            low, high = clear.along(wall)
            for depth in depths:
                start = gap + depth + kind.size[0] // 2
                found += [(wall, kind.name, low + start), (wall, kind.name, high - start)]
    return tuple(found)
