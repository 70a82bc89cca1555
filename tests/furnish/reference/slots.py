"""The slots that relations offer at another piece: at its sides, around it, under it, on it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from catalogs.schema import RelationSpec
from solver.geometry import Rect, to_mm, turned
from solver.pieces import Attach, Candidate, Extents
from solver.relations.subject import Kind
from tests.furnish.reference.at_side import TOWARDS, at_side, lined_up, spans, whole
from tests.furnish.reference.knee_room import free, taken
from tests.furnish.reference.subject import Parent, Subject

SIDE_COST, SEAT_COST = 0.05, 0.01
"""What each later side, and each later place around a piece, costs more than the one before it."""
GAPS = {"beside": 0.02, "in_front_of": 0.4, "around": 0.05, "in_row": 0.0, "under": -0.3}
"""The free space, m, where a relation names none."""
SIDES = {
    "beside": ("left", "right"), "in_row": ("left", "right"), "in_front_of": ("front",), "under": ("front",),
    "around": ("front", "back", "left", "right"),
}  # fmt: skip
"""The sides of the other piece, where a relation names none."""
ELBOW_MM = 100
"""Free width between neighbours around a table."""
LEAST_TUCKED_MM = {"under": -10}
"""The gap of a piece that was to reach under the other, where their parts leave no room for it."""


def slots_of(subject: Subject, spec: RelationSpec) -> tuple[Candidate, ...]:
    """Returns the slots of a relation that gives a piece its place."""
    if spec.type == "on":
        return tuple(_on(subject, spec))
    if spec.type == "around":
        return tuple(_around(subject, spec))
    looks = spec.type == "under" or (spec.type != "in_row" and faces(subject, spec.of))
    return tuple(_at_sides(subject, spec, looks))


def faces(subject: Subject, names: tuple[str, ...]) -> bool:
    """Tells whether a relation turns the piece towards one of those."""
    return any(spec.type == "facing" and set(spec.of) & set(names) for spec in subject.relations)


def _gap(spec: RelationSpec) -> tuple[int, int]:
    low, high = spec.gap or (GAPS[spec.type], GAPS[spec.type])
    return to_mm(low), to_mm(high)


def _sides(spec: RelationSpec) -> tuple[str, ...]:
    return spec.sides or SIDES[spec.type]


def _at_sides(subject: Subject, spec: RelationSpec, turn: bool) -> Iterator[Candidate]:
    gap = _gap(spec)
    for kind, cost in subject.variants:
        for parent in subject.parents(spec.of):
            for order, side in enumerate(_sides(spec)):
                lateral = side in ("left", "right")
                align = spec.align or ("back" if lateral else "centre")
                if align in ("back", "front") and not lateral:
                    align = "centre"
                rotation = TOWARDS[side] if turn else 0
                sizes = parent.kind.size[:2], turned(*kind.size[:2], rotation)
                places = [whole(at_side(sizes, side, gap, align))]
                if gap[0] < 0:
                    places = _tucked(spec, places[0], whole(at_side(sizes, side, gap, None)), (parent.kind, kind, rotation), side)
                for place in places:
                    yield _slot(kind, parent, place, (side, rotation, gap[0] < 0, cost + SIDE_COST * order))


def _on(subject: Subject, spec: RelationSpec) -> Iterator[Candidate]:
    """The first surface of every parent that has room above it."""
    for kind, cost in subject.variants:
        width, depth, height = kind.size
        for parent in subject.parents(spec.of):
            wide, deep, _ = parent.kind.size
            level = next((one for one in parent.kind.levels if one.clearance_mm is None or one.clearance_mm >= height), None)
            if level is None or width > wide:
                continue
            slide = (wide - width) // 2 if spec.align == "any" else 0
            low, high = lined_up(deep, depth, spec.align if spec.align in ("back", "front") else "centre")
            attach = Attach(parent.label, parent.kind.name, (-slide, slide), (round(low), round(high)), f"on {level.name}")
            yield Candidate(kind.name, kind.size, 0, cost=cost, attach=attach, on=parent.label, bottom_mm=level.height_mm)


def _around(subject: Subject, spec: RelationSpec) -> Iterator[Candidate]:
    gap, slide = _gap(spec), ELBOW_MM // 2
    for kind, cost in subject.variants:
        for parent in subject.parents(spec.of):
            seats = [seat for side in _sides(spec) for seat in _seats(parent.kind.size, kind.size, side)]
            for rank, (side, shift, _) in enumerate(sorted(seats, key=lambda seat: seat[2])):
                rotation = TOWARDS[side]
                x0, z0, x1, z1 = whole(at_side((parent.kind.size[:2], turned(*kind.size[:2], rotation)), side, gap, "centre"))
                ends = side in ("left", "right")
                wish = Rect(x0, shift, x1, shift) if ends else Rect(shift, z0, shift, z1)
                near = Rect(x0, shift - slide, x1, shift + slide) if ends else Rect(shift - slide, z0, shift + slide, z1)
                places = _tucked(spec, wish, near, (parent.kind, kind, rotation), side) if gap[0] < 0 else [wish]
                for place in places:
                    yield _slot(kind, parent, place, (f"{side} {shift}", rotation, gap[0] < 0, cost + SEAT_COST * rank))


def _slot(kind: Kind, parent: Parent, place: Rect, so: tuple[str, int, bool, float]) -> Candidate:
    name, rotation, under, cost = so
    attach = Attach(parent.label, parent.kind.name, *spans(place), name)
    made = Candidate(kind.name, kind.size, rotation, cost=cost, attach=attach)
    return replace(made, under=parent.label) if under else made


def _seats(parent: Extents, own: Extents, side: str) -> list[tuple[str, int, int]]:
    """Returns the places along one side: side, shift from its middle, rank (ends last)."""
    length = parent[1] if side in ("left", "right") else parent[0]
    number = max(1, length // (own[0] + ELBOW_MM))
    end = 100 if length < max(parent[0], parent[1]) else 0
    return [(side, ((2 * i + 1) * length // number - length) // 2, end + i) for i in range(number)]


def _tucked(spec: RelationSpec, wish: Rect, near: Rect, kinds: tuple[Kind, Kind, int], side: str) -> list[Rect]:
    """Returns the places of a piece that reaches under another one where their parts do not cross, as near to the wish as can be."""
    parent, own, rotation = kinds
    gap, sideways = (LEAST_TUCKED_MM.get(spec.type, 0),) * 2, side in ("left", "right")
    out = whole(at_side((parent.size[:2], turned(*own.size[:2], rotation)), side, gap, "centre"))
    x = (min(near.x0, out.x0), max(near.x1, out.x1)) if sideways else (near.x0, near.x1)
    z = (near.z0, near.z1) if sideways else (min(near.z0, out.z0), max(near.z1, out.z1))
    blocked = taken(parent.parts, own.parts, rotation)
    return nearest_free(wish, Rect(x[0], z[0], x[1], z[1]), blocked, sideways)


def nearest_free(wish: Rect, reach: Rect, blocked: Sequence[Rect], sideways: bool) -> list[Rect]:
    """Returns what of the places wished for is free; where nothing is, the free places of the reach that are nearest to them.

    As little as possible is lost along the axis that leads away from the other piece, x where `sideways`, then along the other.
    """
    found = free(wish, blocked)
    if found:
        return found
    near = [_nearest(place, wish) for place in free(reach, blocked)]
    away = [(_between(rect.span(0), wish.span(0)), _between(rect.span(1), wish.span(1))) for rect in near]
    ranked = [gaps if sideways else gaps[::-1] for gaps in away]
    return [rect for rect, rank in zip(near, ranked, strict=True) if rank == min(ranked)]


def _between(low_high: tuple[int, int], wish: tuple[int, int]) -> int:
    return max(0, low_high[0] - wish[1], wish[0] - low_high[1])


def _nearest(place: Rect, wish: Rect) -> Rect:
    """Returns the part of a rectangle of places that is nearest to another one."""
    (x0, x1), (z0, z1) = _towards(place.span(0), wish.span(0)), _towards(place.span(1), wish.span(1))
    return Rect(x0, z0, x1, z1)


def _towards(span: tuple[int, int], wish: tuple[int, int]) -> tuple[int, int]:
    low, high = max(span[0], wish[0]), min(span[1], wish[1])
    return (low, high) if low <= high else (span[0], span[0]) if span[0] > wish[1] else (span[1], span[1])
