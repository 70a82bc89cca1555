"""Relations that give a piece a slot at another piece: beside, in front, around, in a row, on and under it.

All offsets are in the parent's own frame (front +z, right +x), mm, from its centre to the piece's centre.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from catalogs.schema import Rule
from solver.furnish.ask import Ask, Effect, Size
from solver.geometry import to_mm, turned
from solver.scene import WALLS
from solver.wanted import Alternative, Attach, Link

TOWARDS = {"left": 90, "right": 270, "front": 180, "back": 0}
"""The turn, relative to the parent, with which a piece at that side faces it."""
SIDE_COST = 0.05
"""What each later side in a rule's list costs more than the one before it."""
SLOT_COST = 0.01
"""What each later place along the sides costs: chairs fill a table in pairs."""
ELBOW_MM = 100
"""Free width between neighbours around a table."""
TUCK = (-0.3, -0.3)
"""How far a piece reaches under another where the rule names no gap, m."""

Interval = tuple[int, int]


def _gap(rule: Rule, default: tuple[float, float]) -> Interval:
    low, high = rule.gap or default
    return to_mm(low), to_mm(high)


def _across_a_side(parent: int, own: int, align: str) -> Interval:
    """Returns the offset along a side of a parent, from its back or left end, for a way to line up."""
    edge = parent // 2 - own // 2
    return {"back": (-edge, -edge), "front": (edge, edge), "centre": (0, 0), "any": (-abs(edge), abs(edge))}[align]


def beside_offset(parent: Size, extent: tuple[int, int], side: str, gap: Interval, align: str) -> tuple[Interval, Interval]:
    """Returns the offsets across and along of a piece of that extent at a side of its parent."""
    if side in ("left", "right"):
        sign = -1 if side == "left" else 1
        least, most = (sign * (parent[0] // 2 + extent[0] // 2 + g) for g in gap)
        return (min(least, most), max(least, most)), _across_a_side(parent[1], extent[1], align)
    sign = -1 if side == "back" else 1
    least, most = (sign * (parent[1] // 2 + extent[1] // 2 + g) for g in gap)
    return _across_a_side(parent[0], extent[0], align), (min(least, most), max(least, most))


def _sized(ask: Ask) -> Iterator[tuple[str, Size, float]]:
    """Yields the piece's variants: kind, size, cost."""
    for variant in ask.piece.variants:
        yield variant.kind, ask.scope.size(variant.kind), variant.cost


def _at_sides(ask: Ask, rule: Rule, sides: tuple[str, ...], gap: Interval, turn: bool) -> tuple[Alternative, ...]:
    """Returns one slot for every variant, parent and side; `turn` makes the piece face its parent."""
    found: list[Alternative] = []
    for kind, size, cost in _sized(ask):
        for label, parent_kind in ask.parents(rule.of):
            for order, side in enumerate(sides):
                rotation = TOWARDS[side] if turn else 0
                align = rule.align or ("back" if side in ("left", "right") else "centre")
                across, along = beside_offset(
                    ask.scope.size(parent_kind), turned(size[0], size[1], rotation), side, gap, align
                )  # fmt: skip
                attach = Attach(label, parent_kind, across, along, side)
                under = label if gap[0] < 0 else None
                found.append(Alternative(kind, size, rotation, cost=cost + SIDE_COST * order, attach=attach, under=under))
    return tuple(found)


def beside(ask: Ask, rule: Rule) -> Effect:
    """Stands at a side of another piece (left or right unless `sides` says otherwise), backs in line."""
    sides = rule.sides or ("left", "right")
    return Effect(slots=_at_sides(ask, rule, sides, _gap(rule, (0.02, 0.02)), ask.faces(rule.of)), links=_walls(ask, rule))


def in_front_of(ask: Ask, rule: Rule) -> Effect:
    """Stands before another piece's front (or the `sides` named), centred."""
    return Effect(slots=_at_sides(ask, rule, rule.sides or ("front",), _gap(rule, (0.4, 0.4)), ask.faces(rule.of)))


def under(ask: Ask, rule: Rule) -> Effect:
    """Stands at a side of another piece and reaches under it, facing it."""
    return Effect(slots=_at_sides(ask, rule, rule.sides or ("front",), _gap(rule, TUCK), turn=True))


def in_row(ask: Ask, rule: Rule) -> Effect:
    """Continues a row: at either end of another piece, backs in line; with `wall: adjacent`, round the corner from it."""
    if rule.wall == "adjacent":
        return _round_the_corner(ask, rule)
    return Effect(slots=_at_sides(ask, rule, rule.sides or ("left", "right"), _gap(rule, (0.0, 0.0)), turn=False))


def _round_the_corner(ask: Ask, rule: Rule) -> Effect:
    """Tries the places next to each corner that leave room for the row's depth, drawn to the row."""
    clear, gap = ask.scope.space.clear, ask.scope.space.gap_mm
    depths = sorted({ask.scope.size(kind)[1] for _, kind in ask.parents(rule.of)})
    positions: list[tuple[str, str, int]] = []
    for kind, size, _ in _sized(ask):
        for wall in WALLS:
            low, high = clear.along(wall)
            for depth in depths:
                start = gap + depth + size[0] // 2
                positions += [(wall, kind, low + start), (wall, kind, high - start)]
    label = next(iter(ask.labels(rule.of)), None)
    if label is None:
        return Effect()
    link = Link("in_row", label, walls="adjacent", cost=rule.cost, required=rule.required, near=rule.weight)
    return Effect(links=(link,), positions=tuple(positions))


def _walls(ask: Ask, rule: Rule) -> tuple[Link, ...]:
    """Returns the link that a rule's `wall` asks for."""
    label = next(iter(ask.labels(rule.of)), None)
    if rule.wall is None or label is None:
        return ()
    return (Link(rule.type, label, walls=rule.wall, cost=rule.cost, required=rule.required),)


def around(ask: Ask, rule: Rule) -> Effect:
    """Takes one of the places around another piece, facing it; long sides take several, filled in pairs."""
    sides = rule.sides or ("front", "back", "left", "right")
    gap = _gap(rule, (0.05, 0.05))
    found: list[Alternative] = []
    for kind, size, cost in _sized(ask):
        for label, parent_kind in ask.parents(rule.of):
            parent = ask.scope.size(parent_kind)
            seats = [seat for side in sides for seat in _seats(parent, size, side)]
            order = sorted(range(len(seats)), key=lambda i: (seats[i][2], i))
            for rank, i in enumerate(order):
                side, shift, _ = seats[i]
                found.append(_seat(kind, size, (label, parent_kind), (side, shift), (parent, gap)))
                found[-1] = replace(found[-1], cost=cost + SLOT_COST * rank)
    return Effect(slots=tuple(found))


def _seats(parent: Size, own: Size, side: str) -> list[tuple[str, int, int]]:
    """Returns the places along one side: side, shift from its middle, rank (ends last)."""
    length = parent[1] if side in ("left", "right") else parent[0]
    number = max(1, length // (own[0] + ELBOW_MM))
    end = 100 if length < max(parent[0], parent[1]) else 0
    return [(side, ((2 * i + 1) * length // number - length) // 2, end + i) for i in range(number)]


def _seat(kind: str, size: Size, parent: tuple[str, str], at: tuple[str, int], fit: tuple[Size, Interval]) -> Alternative:
    """Returns the alternative of one place around a parent (label, kind), at (side, shift), for (parent's size, gap)."""
    (label, parent_kind), (side, shift), (parent_size, gap) = parent, at, fit
    rotation = TOWARDS[side]
    across, along = beside_offset(parent_size, turned(size[0], size[1], rotation), side, gap, "centre")
    if side in ("left", "right"):
        along = (shift, shift)
    else:
        across = (shift, shift)
    attach = Attach(label, parent_kind, across, along, f"{side} {shift}")
    return Alternative(kind, size, rotation, attach=attach, under=label if gap[0] < 0 else None)


def on(ask: Ask, rule: Rule) -> Effect:
    """Stands on another piece's surface: in its middle, at its back, or (align any) anywhere along it."""
    found: list[Alternative] = []
    for kind, size, cost in _sized(ask):
        for label, parent_kind in ask.parents(rule.of):
            parent, entry = ask.scope.size(parent_kind), ask.scope.entry(parent_kind)
            surface = next((s for s in entry.surfaces if s.clearance is None or to_mm(s.clearance) >= size[2]), None)
            if surface is None or size[0] > parent[0]:
                continue
            slide = (parent[0] - size[0]) // 2
            across = (-slide, slide) if rule.align == "any" else (0, 0)
            along = _across_a_side(parent[1], size[1], rule.align if rule.align in ("back", "front") else "centre")
            attach = Attach(label, parent_kind, across, along, f"on {surface.name}")
            bottom = to_mm(surface.height)
            found.append(Alternative(kind, size, 0, cost=cost, attach=attach, on=label, bottom_mm=bottom))
    return Effect(slots=tuple(found))
