"""`around`: at one of the places around another piece, looking at it."""

from __future__ import annotations

from dataclasses import replace

from catalogs.schema import RelationSpec
from solver.geometry import Rect, turned
from solver.pieces import Attach, Candidate, Extents
from solver.relations.at_side import TOWARDS, AtSide, at_side, spans, whole
from solver.relations.relation import Effect
from solver.relations.subject import Kind, Parent, Subject

SLOT_COST = 0.01
"""What each later place along the sides costs: chairs fill a table in pairs."""
ELBOW_MM = 100
"""Free width between neighbours around a table."""


class Around(AtSide):
    """Takes one of the places around another piece, facing it; long sides take several, filled in pairs."""

    turns = looks = True
    sides = ("front", "back", "left", "right")
    best_gap, held_mm = 0.05, (-10_000, 300)

    def effect(self, subject: Subject, spec: RelationSpec) -> Effect:
        """Offers every seat of every parent, the middles of long sides first."""
        found: list[Candidate] = []
        for kind, cost in subject.variants:
            for parent in subject.parents(spec.of):
                seats = [seat for side in spec.sides or self.sides for seat in _seats(parent.kind.size, kind.size, side)]
                for rank, (side, shift, _) in enumerate(sorted(seats, key=lambda seat: seat[2])):
                    seat = self._seat(kind, parent, (side, shift), self.slot_gap(spec))
                    found += [replace(way, cost=cost + SLOT_COST * rank) for way in seat]
        return Effect(slots=tuple(found))

    def _seat(self, kind: Kind, parent: Parent, at: tuple[str, int], gap: tuple[int, int]) -> list[Candidate]:
        """Returns the candidates at a place (side, shift) around a parent; where a leg is in the way, beside it."""
        (side, shift), rotation = at, TOWARDS[at[0]]
        x0, z0, x1, z1 = whole(at_side((parent.kind.size[:2], turned(*kind.size[:2], rotation)), side, gap, "centre"))
        ends, slide = side in ("left", "right"), ELBOW_MM // 2
        wish = Rect(x0, shift, x1, shift) if ends else Rect(shift, z0, shift, z1)
        near = Rect(x0, shift - slide, x1, shift + slide) if ends else Rect(shift - slide, z0, shift + slide, z1)
        under = parent.label if gap[0] < 0 else None
        places = self.tucked(wish, near, (parent.kind, kind, rotation), side) if under else [wish]
        ways = [Attach(parent.label, parent.kind.name, *spans(place), f"{side} {shift}", parent.stance) for place in places]
        return [Candidate(kind.name, kind.size, rotation, attach=attach, under=under) for attach in ways]


def _seats(parent: Extents, own: Extents, side: str) -> list[tuple[str, int, int]]:
    """Returns the places along one side: side, shift from its middle, rank (ends last)."""
    length = parent[1] if side in ("left", "right") else parent[0]
    number = max(1, length // (own[0] + ELBOW_MM))
    end = 100 if length < max(parent[0], parent[1]) else 0
    return [(side, ((2 * i + 1) * length // number - length) // 2, end + i) for i in range(number)]
