"""The relations that place a piece at a side of another one: their common geometry.

Offsets are in the other's own frame, mm, from its centre to the piece's centre: front +z, right +x.
"""

from typing import ClassVar

from catalogs.schema import RelationSpec
from solver.geometry import Rect, to_mm
from solver.relations.knee_room import free
from solver.relations.relation import EXACT, GAP_MM, HELD, Box, Fit, LeastMost, Relation, Tolerance

TOWARDS = {"left": 90, "right": 270, "front": 180, "back": 0}
"""The turn, in the other's frame, with which a piece at that side faces it."""
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
    """The free space, m, of the best place where the relation names neither gap nor align."""
    sought_mm: ClassVar[LeastMost] = (20, 280)
    """The same of all places that are sought."""
    held_mm: ClassVar[LeastMost] = (0, 300)
    """The same that holds."""
    best_align: ClassVar[str | None] = None
    """How the best place lines up, where there is one that is better than the rest."""
    looks: ClassVar[bool] = False
    """It must face the other."""

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
