"""Where the centre of a piece lies that stands at a side of another one. Offsets in the other's frame, mm: front +z, right +x."""

from __future__ import annotations

from solver.geometry import Rect

TOWARDS = {"left": 90, "right": 270, "front": 180, "back": 0}
"""The turn, in the other's frame, with which a piece at that side faces it."""
LeastMost = tuple[float, float]
Box = tuple[LeastMost, LeastMost]


def at_side(sizes: tuple[tuple[int, int], tuple[int, int]], side: str, gap: LeastMost, align: str | None) -> Box:
    """Returns where the centre lies of a piece a gap away and lined up; `sizes`: extents of the parent and the piece in its frame."""
    parent, own = sizes
    beside = side in ("left", "right")
    touching = (parent[0] + own[0]) / 2 if beside else (parent[1] + own[1]) / 2
    sign = -1 if side in ("left", "back") else 1
    least, most = sorted(sign * (touching + free) for free in gap)
    if beside:
        return (least, most), lined_up(parent[1], own[1], align)
    return lined_up(parent[0], own[0], None if align in ("back", "front") else align), (least, most)


def lined_up(parent: int, own: int, align: str | None) -> LeastMost:
    """Returns the offsets along a side with which two lengths line up; by default the shorter one is within the longer one."""
    if align in ("back", "front"):
        edge = (parent - own) / 2 * (-1 if align == "back" else 1)
        return edge, edge
    half = 0.0 if align == "centre" else abs(parent - own) / 2
    return -half, half


def whole(box: Box) -> Rect:
    """Rounds a box to whole millimetres."""
    (x0, x1), (z0, z1) = box
    return Rect(round(x0), round(z0), round(x1), round(z1))


def spans(place: Rect) -> tuple[tuple[int, int], tuple[int, int]]:
    """Returns where a centre may lie across and along."""
    return (place.x0, place.x1), (place.z0, place.z1)
