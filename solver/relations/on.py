"""`on`: on another piece's surface."""

from catalogs.schema import RelationSpec
from solver.pieces import Attach, Candidate
from solver.relations.at_side import lined_up
from solver.relations.relation import EXACT, Relation, Standing
from solver.relations.subject import Subject


class On(Relation):
    """Stands on another piece's surface: in its middle, at its back or front, or (align any) anywhere along it."""

    gives_place = True

    def slots(self, subject: Subject, spec: RelationSpec) -> tuple[Candidate, ...]:
        """Returns a candidate on the first surface of every parent that has room above it."""
        found: list[Candidate] = []
        for kind, cost in subject.variants:
            width, depth, height = kind.size
            for parent in subject.parents(spec.of):
                wide, deep, _ = parent.kind.size
                levels = (level for level in parent.kind.levels if level.clearance_mm is None or level.clearance_mm >= height)
                level = next(levels, None)
                if level is None or width > wide:
                    continue
                slide = (wide - width) // 2
                across = (-slide, slide) if spec.align == "any" else (0, 0)
                back = lined_up(deep, depth, spec.align if spec.align in ("back", "front") else "centre", EXACT)
                along = round(back[0]), round(back[1])
                attach = Attach(parent.label, parent.kind.name, across, along, f"on {level.name}", parent.stance)
                found.append(Candidate(kind.name, kind.size, 0, cost=cost, attach=attach, on=parent.label, bottom_mm=level.height_mm))
        return tuple(found)

    def holds_with(self, spec: RelationSpec, own: Standing, other: Standing) -> bool:
        """Tells whether its middle is over the other, and its underside on one of the other's surfaces."""
        (x, z), rect = own.double_centre, other.rect
        over = 2 * rect.x0 <= x <= 2 * rect.x1 and 2 * rect.z0 <= z <= 2 * rect.z1
        return over and own.on == other.id and own.bottom in other.levels
