"""Relations between two pieces as boxes: where, in the other's own frame, a piece's centre must lie for one to hold.

Each function: a fit -> boxes ((across low, high), (along low, high)), mm, from the other's centre; front +z, right +x. They
lie a little inside what is asked for.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final, NamedTuple

from catalogs.schema import Rule
from solver.furnish.relations.slots import TOWARDS
from solver.geometry import FACING, to_mm

Interval = tuple[int, int]
Box = tuple[Interval, Interval]

ANYWHERE: Final = (-100_000, 100_000)
NEARLY_MM: Final = 80
EXACT_MM: Final = 6
NEAR, FAR = 1.5, 2.0
"""What near and far_from take for a distance where the rule names none, m."""
GAPS: Final = {"beside": (0.02, 0.28), "in_front_of": (0.25, 0.65), "around": (0.02, 0.28), "in_row": (0.0, 0.0)}
"""Gaps that hold where the rule names none, m."""
UNTUCKED_MM: Final = 160
"""How much of a tucked piece's depth stays outside its table."""


class Fit(NamedTuple):
    """A rule between two pieces: the other's width and depth, and the own extents and rotation in the other's frame."""

    rule: Rule
    parent: tuple[int, int]
    own: tuple[int, int]
    turn: int

    @property
    def reach(self) -> tuple[float, float]:
        """How far apart the centres are where the pieces touch, across and along."""
        return (self.parent[0] + self.own[0]) / 2, (self.parent[1] + self.own[1]) / 2


def near(fit: Fit) -> list[Box]:
    """Close: a box inside the rounded one; two longer ones beside it."""
    distance = to_mm(NEAR if fit.rule.distance is None else fit.rule.distance) - EXACT_MM
    x, z = fit.reach
    if distance < 0:
        return []
    flat, steep = 0.99 * distance, 0.14 * distance
    halves = [(0.7 * distance, 0.7 * distance), (flat, steep), (steep, flat)]
    return [((-int(x + a), int(x + a)), (-int(z + b), int(z + b))) for a, b in halves]


def far_from(fit: Fit) -> list[Box]:
    """Beyond the distance at any of four sides, or off any corner by less along each axis."""
    distance = to_mm(FAR if fit.rule.distance is None else fit.rule.distance) + EXACT_MM
    x, z = (int(half) + 1 for half in fit.reach)
    low, high = ANYWHERE
    d = distance
    found: list[Box] = [((low, -x - d), ANYWHERE), ((x + d, high), ANYWHERE), (ANYWHERE, (low, -z - d)), (ANYWHERE, (z + d, high))]
    for part, rest in ((0.924, 0.383), (0.383, 0.924)):
        a, b = x + math.ceil(part * d), z + math.ceil(rest * d)
        found += [(across, along) for across in ((low, -a), (a, high)) for along in ((low, -b), (b, high))]
    return found


def aligned_with(_: Fit) -> list[Box]:
    """Middles in line, along either axis."""
    return [((-NEARLY_MM, NEARLY_MM), ANYWHERE), (ANYWHERE, (-NEARLY_MM, NEARLY_MM))]


def facing(fit: Fit) -> list[Box]:
    """Straight before the own front, or within half a right angle of it at several distances."""
    x, z = fit.reach
    ahead = z if fit.turn % 180 == 0 else x
    aside = (fit.parent[0] if fit.turn % 180 == 0 else fit.parent[1]) / 2 - EXACT_MM
    ranges = [(ahead, aside), (250.0, 240.0), (700.0, 690.0), (1500.0, 1490.0)]
    return [_before(fit.turn, least, half) for least, half in ranges if half > 0]


def _before(turn: int, least: float, half: float) -> Box:
    """Returns the places from which a piece with that turn has the other's centre before it, so far off and aside."""
    dx, dz = FACING[turn]
    side = (-int(half), int(half))
    ahead = {1: (ANYWHERE[0], -int(least) - 1), -1: (int(least) + 1, ANYWHERE[1])}
    return (ahead[dx], side) if dx else (side, ahead[dz])


def opposite(fit: Fit) -> list[Box]:
    """Before the other's front, turned to it, one's middle on the other."""
    if fit.turn != 180:
        return []
    half = int(max(fit.parent[0], fit.own[0]) / 2) - EXACT_MM
    return [((-half, half), (int(fit.reach[1]) + 1, ANYWHERE[1]))] if half > 0 else []


def beside(fit: Fit) -> list[Box]:
    """At a side, lined up as the rule says; exactly, backs in line and close, or sliding."""
    sides = fit.rule.sides or ("left", "right")
    gap = _gap(fit.rule)
    return [box for side in sides for box in (*_exact(fit, side, "back", 0.02), _at_side(fit, side, gap, fit.rule.align))]


def in_front_of(fit: Fit) -> list[Box]:
    """Before the front; exactly in the middle, or sliding."""
    sides = fit.rule.sides or ("front",)
    gap = _gap(fit.rule)
    return [box for side in sides for box in (*_exact(fit, side, "centre", 0.4), _at_side(fit, side, gap, fit.rule.align))]


def in_row(fit: Fit) -> list[Box]:
    """At either end, backs in line and turned alike."""
    if fit.turn or fit.rule.wall == "adjacent":
        return []
    gap = _gap(fit.rule)
    return [_at_side(fit, side, gap, "back") for side in fit.rule.sides or ("left", "right")]


def around(fit: Fit) -> list[Box]:
    """At a side, turned to it."""
    sides = [side for side in fit.rule.sides or ("front", "back", "left", "right") if TOWARDS[side] == fit.turn]
    gap = _gap(fit.rule)
    return [_at_side(fit, side, gap, fit.rule.align) for side in sides]


def under(fit: Fit) -> list[Box]:
    """At a side, turned to it and reaching under it."""
    depth = fit.own[1] if fit.turn % 180 == 0 else fit.own[0]
    least = UNTUCKED_MM - depth
    low, high = (least, -50) if fit.rule.gap is None else (to_mm(fit.rule.gap[0]), to_mm(fit.rule.gap[1]))
    low = max(low, least)
    sides = [side for side in fit.rule.sides or ("front",) if TOWARDS[side] == fit.turn]
    return [_at_side(fit, side, (low, high), fit.rule.align) for side in sides] if low <= high < 0 else []


def _exact(fit: Fit, side: str, align: str, gap: float) -> list[Box]:
    """Returns the place where a rule that leaves gap and alignment open looks best."""
    if fit.rule.gap is not None or fit.rule.align is not None or (align == "back" and fit.turn):
        return []
    across, along = _at_side(fit, side, (to_mm(gap), to_mm(gap)), align)
    return [(across if across[0] == across[1] else (0, 0), along if along[0] == along[1] else (0, 0))]


def _gap(rule: Rule) -> Interval:
    low, high = rule.gap or GAPS[rule.type]
    return to_mm(low), to_mm(high)


def _at_side(fit: Fit, side: str, gap: Interval, align: str | None) -> Box:
    x, z = fit.reach
    sign = -1 if side in ("left", "back") else 1
    out = sorted(sign * (round(x if side in ("left", "right") else z) + g) for g in gap)
    if side in ("left", "right"):
        return (out[0], out[1]), _lined_up(align, fit.parent[1], fit.own[1], True)
    return _lined_up(align, fit.parent[0], fit.own[0], False), (out[0], out[1])


def _lined_up(align: str | None, parent: int, own: int, along: bool) -> Interval:
    """Returns the offsets along a side that line up as the rule says; by default half the shorter one's length is shared."""
    if align == "centre":
        return -NEARLY_MM, NEARLY_MM
    if align in ("back", "front") and along:
        edge = (parent - own) // 2
        at = -edge if align == "back" else edge
        return at, at
    half = int((parent + own) / 2 - min(parent, own) / 2) - EXACT_MM
    return -max(half, 0), max(half, 0)


def shared(a: Box, b: Box) -> Box | None:
    """Returns what two boxes share, if anything."""
    across, along = _common(a[0], b[0]), _common(a[1], b[1])
    return (across, along) if across[0] <= across[1] and along[0] <= along[1] else None


def _common(a: Interval, b: Interval) -> Interval:
    return a[0] if a[0] > b[0] else b[0], a[1] if a[1] < b[1] else b[1]


BOXES: Final[dict[str, Callable[[Fit], list[Box]]]] = {
    "near": near, "far_from": far_from, "aligned_with": aligned_with, "facing": facing, "opposite": opposite, "beside": beside,
    "in_front_of": in_front_of, "in_row": in_row, "around": around, "under": under,
}  # fmt: skip
