"""The relations that place a piece at a side of another one: their common geometry.

Offsets are in the other's own frame, mm, from its centre to the piece's centre: front +z, right +x.
"""

from __future__ import annotations

from typing import ClassVar

from catalogs.schema import RelationSpec
from solver.geometry import Rect, to_mm, turned
from solver.pieces import Attach, Candidate, Link
from solver.relations.knee_room import free, nearest_free, taken
from solver.relations.relation import EXACT, GAP_MM, HELD, Box, Effect, Fit, LeastMost, Relation, Tolerance, first
from solver.relations.subject import Kind, Subject

TOWARDS = {"left": 90, "right": 270, "front": 180, "back": 0}
"""The turn, in the other's frame, with which a piece at that side faces it."""
SIDE_COST = 0.05
"""What each later side in a relation's list costs more than the one before it."""
MOST_PLACES = 4
"""Most rectangles that are sought of the places where a piece can reach under another one."""
FloorSize = tuple[int, int]
"""Extents of a footprint across and along, mm."""


def at_side(sizes: tuple[FloorSize, FloorSize], side: str, gap: LeastMost, align: str | None, tolerance: Tolerance = EXACT) -> Box:
    """Returns where the centre of a piece lies that stands at a side of its parent, a gap away and lined up with it.

    Args:
        sizes: the extents of the parent and the piece, in the parent's frame.
        side: of the parent.
        gap: the free space between them, least and most, mm.
        align: how they line up along the side; there is no back to line up with before a front.
        tolerance: how exactly.
    """
    parent, own = sizes
    beside = side in ("left", "right")
    touching = (parent[0] + own[0]) / 2 if beside else (parent[1] + own[1]) / 2
    sign = -1 if side in ("left", "back") else 1
    least, most = sorted(sign * (touching + free) for free in gap)
    if beside:
        return (least, most), lined_up(parent[1], own[1], align, tolerance)
    return lined_up(parent[0], own[0], None if align in ("back", "front") else align, tolerance), (least, most)


def lined_up(parent: int, own: int, align: str | None, tolerance: Tolerance) -> LeastMost:
    """Returns the offsets along a side with which two lengths line up; by default they share a part of the shorter one."""
    if align in ("back", "front"):
        edge = (parent - own) / 2 * (-1 if align == "back" else 1)
        return edge - tolerance.flush_mm, edge + tolerance.flush_mm
    if align == "centre":
        return -tolerance.nearly_mm, tolerance.nearly_mm
    half = max((parent + own) / 2 - tolerance.shared * min(parent, own) - tolerance.inside_mm, 0)
    return -half, half


def whole(box: Box) -> Rect:
    """Rounds a box to whole millimetres."""
    (x0, x1), (z0, z1) = box
    return Rect(round(x0), round(z0), round(x1), round(z1))


def spans(place: Rect) -> tuple[tuple[int, int], tuple[int, int]]:
    """Returns where a centre may lie across and along."""
    return (place.x0, place.x1), (place.z0, place.z1)


class AtSide(Relation):
    """A relation that places a piece at a side of another, a gap away."""

    gives_place = True
    sides: ClassVar[tuple[str, ...]] = ("left", "right")
    """Where the relation names no sides."""
    best_gap: ClassVar[float] = 0.02
    """The free space, m, of the best place where the relation names no gap."""
    sought_mm: ClassVar[LeastMost] = (20, 280)
    """The same of all places that are sought."""
    held_mm: ClassVar[LeastMost] = (0, 300)
    """The same that holds."""
    best_align: ClassVar[str | None] = None
    """How the best place lines up, where there is one that is better than the rest."""
    looks: ClassVar[bool] = False
    """It must face the other."""
    least_tucked_mm: ClassVar[int] = 0
    """The gap of a piece that was to reach under the other, where their parts leave no room for it."""

    def effect(self, subject: Subject, spec: RelationSpec) -> Effect:
        """Offers a slot for every variant, parent and side; where it is to face its parent, it does so there."""
        return Effect(slots=self._slots(subject, spec, self.looks or subject.faces(spec.of)), links=wall_links(subject, spec))

    def _slots(self, subject: Subject, spec: RelationSpec, turn: bool) -> tuple[Candidate, ...]:
        gap = self.slot_gap(spec)
        found: list[Candidate] = []
        for kind, cost in subject.variants:
            for parent in subject.parents(spec.of):
                for order, side in enumerate(spec.sides or self.sides):
                    rotation = TOWARDS[side] if turn else 0
                    align = spec.align or ("back" if side in ("left", "right") else "centre")
                    if align in ("back", "front") and side in ("front", "back"):
                        align = "centre"
                    sizes = parent.kind.size[:2], turned(*kind.size[:2], rotation)
                    wish, along_it = whole(at_side(sizes, side, gap, align)), whole(at_side(sizes, side, gap, None))
                    under = parent.label if gap[0] < 0 else None
                    for place in self.tucked(wish, along_it, (parent.kind, kind, rotation), side) if under else [wish]:
                        attach = Attach(parent.label, parent.kind.name, *spans(place), side, parent.stance)
                        found.append(Candidate(kind.name, kind.size, rotation, cost=cost + SIDE_COST * order, attach=attach, under=under))
        return tuple(found)

    def tucked(self, wish: Rect, near: Rect, kinds: tuple[Kind, Kind, int], side: str) -> list[Rect]:
        """Returns the places of a piece that reaches under another one, at that one's side, where their parts do not cross.

        Args:
            wish: the best places.
            near: those that will do as well; and what lies between them and where the pieces hardly overlap any more.
            kinds: of the other piece, and of the piece with its rotation in the other's frame.
            side: of the other.
        """
        parent, own, rotation = kinds
        out = whole(at_side((parent.size[:2], turned(*own.size[:2], rotation)), side, (self.least_tucked_mm,) * 2, "centre"))
        sideways = side in ("left", "right")
        x = (min(near.x0, out.x0), max(near.x1, out.x1)) if sideways else (near.x0, near.x1)
        z = (near.z0, near.z1) if sideways else (min(near.z0, out.z0), max(near.z1, out.z1))
        blocked = taken(parent.parts, own.parts, rotation)
        return nearest_free(wish, Rect(x[0], z[0], x[1], z[1]), blocked, outwards="x" if sideways else "z")

    def slot_gap(self, spec: RelationSpec) -> tuple[int, int]:
        """Returns the free space of a room type's slot, mm."""
        low, high = spec.gap or (self.best_gap, self.best_gap)
        return to_mm(low), to_mm(high)

    def boxes(self, fit: Fit) -> list[Box]:
        """At each side: the place that looks best, then all that hold."""
        sides = [side for side in fit.spec.sides or self.sides if not self.looks or TOWARDS[side] == fit.turn]
        return [box for side in sides for box in self._at(fit, side)]

    def _at(self, fit: Fit, side: str) -> list[Box]:
        low, high = self.gap(fit)
        align = self.align(fit.spec)
        if fit.tolerance is HELD:
            low = max(low, 1 - fit.own[0 if side in ("left", "right") else 1])
        found = [at_side((fit.parent, fit.own), side, (low, high), align, fit.tolerance)] if low <= high else []
        if low < 0 and fit.blocked:
            found = [spans(place) for box in found for place in free(whole(box), fit.blocked)[:MOST_PLACES]]
        any_will_do = fit.tolerance is not HELD and fit.spec.gap is None and fit.spec.align is None
        if self.best_align is None or not any_will_do or (self.best_align == "back" and fit.turn):
            return found
        best = self.best_align if side in ("left", "right") else "centre"
        gap = to_mm(self.best_gap)
        return [at_side((fit.parent, fit.own), side, (gap, gap), best), *found]

    def align(self, spec: RelationSpec) -> str | None:
        """Returns how the pieces are to line up."""
        return spec.align

    def gap(self, fit: Fit) -> LeastMost:
        """Returns the free space with which the relation holds, or is sought, mm."""
        held = fit.tolerance is HELD
        if fit.spec.gap is None:
            return self.held_mm if held else self.sought_mm
        more = GAP_MM if held else 0
        return to_mm(fit.spec.gap[0]) - more, to_mm(fit.spec.gap[1]) + more


def wall_links(subject: Subject, spec: RelationSpec) -> tuple[Link, ...]:
    """Returns the link that a relation's `wall` asks for."""
    label = first(subject, spec)
    if spec.wall is None or label is None:
        return ()
    return (Link(spec.type, label, walls=spec.wall, cost=spec.cost, required=spec.required),)
