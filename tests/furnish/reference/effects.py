"""What each relation of a room type does to a piece's candidates: slots, links, further places, and what a place costs by it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from catalogs.checks import OPENINGS
from catalogs.schema import RelationSpec
from solver.geometry import ALONG_X, INWARDS, OPPOSITE, WALL_BEHIND, Rect, to_mm
from solver.pieces import LOOKS_AT, Candidate, Link, Opened
from solver.relations.subject import Kind, Scope
from solver.scene import WALLS
from tests.furnish.reference.openings import middle_of, opened
from tests.furnish.reference.slots import SIDES, slots_of
from tests.furnish.reference.subject import Subject, missed, wished_footprint

NEAR_MM, FAR_MM, FAR_FROM_OPENING_MM, LEAST_MM = 1500, 2000, 1500, 10
CENTRED_REACH_MM = 1000
"""A piece this far from where it should be centred pays the full cost."""
LONGER = 1.15
SHUNNED = 2.0
PAST_GATE_SHARE = 0.3
ALONG_SHARE = 0.3
"""A wall is long, and those beside it short, from this ratio on: a square room has neither."""
AT_SIDES = {*SIDES} - {"in_row"}
"""Relations whose slots turn the piece already."""


@dataclass(frozen=True)
class Effect:
    """What a room type's relation does to a piece's candidates.

    Args:
        slots: candidates at another piece.
        links: conditions and terms against earlier pieces.
        cost_of: cost of a candidate that is no slot; infinity forbids it.
        positions: further centres along a wall to try (wall, kind, mm), beside the ends and middles of its clear stretches.
        spots: further free anchors to try (kind, (x, z) mm).
        corners: free pieces are tried in the room's corners.
        backs: free pieces are tried with their back at each wall.
        weight: pull towards the anchor, m^-2, where the relation wants a firm one.
    """

    slots: tuple[Candidate, ...] = ()
    links: tuple[Link, ...] = ()
    cost_of: Callable[[Candidate], float] | None = None
    positions: tuple[tuple[str, str, int], ...] = ()
    spots: tuple[tuple[str, tuple[int, int]], ...] = ()
    corners: bool = False
    backs: bool = False
    weight: float = 0.0


NOTHING = Effect()


def effect_of(subject: Subject, spec: RelationSpec) -> Effect:
    """Returns what a relation does to the candidates of a piece."""
    return _EFFECTS.get(spec.type, _at_side)(subject, spec)


def _first(subject: Subject, spec: RelationSpec) -> str | None:
    return next(iter(subject.labels(spec.of)), None)


def _link(subject: Subject, spec: RelationSpec) -> Link | None:
    """Returns a link to the first earlier piece that the relation names, as costly and as hard as it is."""
    label = _first(subject, spec)
    return None if label is None else Link(spec.type, label, cost=spec.cost, required=spec.required)


def _at_side(subject: Subject, spec: RelationSpec) -> Effect:
    link = _link(subject, spec)
    asks = link is not None and spec.wall is not None and spec.type not in ("around", "in_row", "on")
    return Effect(slots=slots_of(subject, spec), links=(replace(link, walls=spec.wall),) if asks and link else ())


def _in_row(subject: Subject, spec: RelationSpec) -> Effect:
    link = _link(subject, spec)
    if spec.wall != "adjacent":
        return _at_side(subject, spec)
    if link is None:
        return NOTHING
    clear, gap = subject.scope.clear, subject.scope.gap_mm
    depths = sorted({parent.kind.size[1] for parent in subject.parents(spec.of)})
    positions = [
        (wall, kind.name, at)
        for kind, _ in subject.variants
        for wall in WALLS
        for depth in depths
        for at in (
            clear.along(wall)[0] + gap + depth + kind.size[0] // 2,
            clear.along(wall)[1] - gap - depth - kind.size[0] // 2,
        )
    ]
    return Effect(links=(replace(link, walls="adjacent", near=spec.weight),), positions=tuple(positions))


def _aligned_with(subject: Subject, spec: RelationSpec) -> Effect:
    label = _first(subject, spec)
    return Effect(links=(Link(spec.type, label, walls=spec.wall, cost=spec.cost, align=spec.weight),)) if label else NOTHING


def _opposite(subject: Subject, spec: RelationSpec) -> Effect:
    link = _link(subject, spec)
    return Effect(links=(replace(link, turn=180, walls="opposite", align=spec.weight),)) if link else NOTHING


def _facing(subject: Subject, spec: RelationSpec) -> Effect:
    kinds = tuple(name for name in spec.of if name in OPENINGS)
    if kinds:
        walls = {opening.wall for opening in opened(subject.scope, *kinds)}
        gates = opened(subject.scope, "garage_door") if "garage_door" in kinds else []

        def cost_of(candidate: Candidate) -> float:
            if OPPOSITE[WALL_BEHIND[candidate.rotation % 360]] not in walls:
                return missed(spec)
            return PAST_GATE_SHARE * spec.cost if gates and not behind_gate(subject, candidate) else 0.0

        spots = tuple(spot for gate in gates for kind, _ in subject.variants for spot in _spots_behind(subject.scope, gate, kind))
        return Effect(cost_of=cost_of, spots=spots) if walls else NOTHING
    link = _link(subject, spec)
    if link is None or any(other.type in AT_SIDES and set(other.of) & set(spec.of) for other in subject.relations):
        return NOTHING
    return Effect(links=(replace(link, turn=LOOKS_AT),))


def _spots_behind(scope: Scope, gate: Opened, kind: Kind) -> list[tuple[str, tuple[int, int]]]:
    """Returns the places of a kind right behind a garage door, at both its ends."""
    (low, high), (width, depth, _) = gate.interval, kind.size
    into = scope.gap_mm + depth // 2
    across = scope.clear.line(gate.wall) + INWARDS[gate.wall] * into
    along = [low + width // 2, high - width // 2] if width <= high - low else []
    return [(kind.name, (at, across) if gate.wall in ALONG_X else (across, at)) for at in along]


def behind_gate(subject: Subject, candidate: Candidate) -> Rect | None:
    """Returns where a candidate stays between the ends of the garage door that it faces; at another piece, of any door."""
    faced = any(spec.type == "facing" and "garage_door" in spec.of for spec in subject.relations)
    ahead, clear = OPPOSITE[WALL_BEHIND[candidate.rotation % 360]], subject.scope.clear
    for gate in opened(subject.scope, "garage_door") if faced else ():
        (low, high), (a, b) = gate.interval, wished_footprint(candidate).along(ahead)
        if candidate.attach or (gate.wall == ahead and low <= a and b <= high):
            start, end = clear.along(gate.wall)
            low, high = max(start, low), min(end, high)
            return Rect(low, clear.z0, high, clear.z1) if gate.wall in ALONG_X else Rect(clear.x0, low, clear.x1, high)
    return None


def _near(subject: Subject, spec: RelationSpec) -> Effect:
    kinds = ("door",) if spec.type == "near_door" else tuple(name for name in spec.of if name in OPENINGS)
    if kinds:
        return _off_distance(subject, spec, opened(subject.scope, *kinds), (NEAR_MM, 1))
    link = _link(subject, spec)
    return Effect(links=(replace(link, walls=spec.wall, cost=spec.cost if spec.wall else 0.0, near=spec.weight),)) if link else NOTHING


def _far_from(subject: Subject, spec: RelationSpec) -> Effect:
    kinds = ("door",) if spec.type == "far_from_door" else tuple(name for name in spec.of if name in OPENINGS)
    if kinds:
        return _off_distance(subject, spec, opened(subject.scope, *kinds), (FAR_FROM_OPENING_MM, -1))
    apart = distance_mm(spec, FAR_MM) / 1000
    links = [Link(spec.type, label, apart_m=apart, apart_cost=spec.cost) for label in subject.labels(spec.of)]
    walls = _link(subject, spec)
    return Effect(links=(*links, replace(walls, walls=spec.wall)) if spec.wall and walls else tuple(links))


def _off_distance(subject: Subject, spec: RelationSpec, openings: list[Opened], meant: tuple[int, int]) -> Effect:
    """Returns the cost of being beyond (1) or short of (-1) the wished distance to the nearest of some openings."""
    default, sign = meant
    wished = max(distance_mm(spec, default), LEAST_MM) / 1000

    def cost_of(candidate: Candidate) -> float:
        nearest = min(wished_footprint(candidate).distance_to(Rect(*middle_of(opening), *middle_of(opening))) for opening in openings)
        off = sign * (nearest / 1000 - wished)
        return missed(spec) * min(1.0, off / wished) if off > 0 else 0.0

    return Effect(cost_of=cost_of) if openings else NOTHING


def _against_wall(subject: Subject, spec: RelationSpec) -> Effect:
    scope = subject.scope

    def cost_of(candidate: Candidate) -> float:
        if candidate.wall is None:
            return missed(spec)
        return sum(cost * _share(scope, candidate, candidate.wall, sort) for sort, cost in spec.walls.items())

    return Effect(cost_of=cost_of, backs=True)


def _share(scope: Scope, candidate: Candidate, wall: str, sort: str) -> float:
    """Returns which share of a sort's cost a candidate pays."""
    if _is(scope, candidate, wall, sort):
        return 1.0
    return ALONG_SHARE if sort == "window" and _along_window(scope, candidate) else 0.0


def _is(scope: Scope, candidate: Candidate, wall: str, sort: str) -> bool:
    """Tells whether the wall behind a candidate is of a sort; only a window right behind it counts, or a door straight across."""
    here = [opening for opening in scope.openings if opening.wall == wall]
    if sort in ("window", "across"):
        a, b = wished_footprint(candidate).along(wall)
        return any(low < b and a < high for low, high in _made_by(scope, wall, sort))
    own, other = (scope.clear.width, scope.clear.depth) if wall in ALONG_X else (scope.clear.depth, scope.clear.width)
    return {
        "door": any(one.kind != "window" for one in here),
        "plain": not here,
        "exterior": getattr(scope.exterior, wall, False),
        "long": own > LONGER * other,
        "short": other > LONGER * own,
    }[sort]


def kept_in(subject: Subject, candidate: Candidate) -> Rect | None:
    """Returns where a candidate by itself stays: beside windows and doors that it shuns, behind its gate."""
    areas = [*_beside_shunned(subject, candidate)]
    if gate := behind_gate(subject, candidate):
        areas.append(gate)
    if not areas:
        return None
    return Rect(max(a.x0 for a in areas), max(a.z0 for a in areas), min(a.x1 for a in areas), min(a.z1 for a in areas))


def _beside_shunned(subject: Subject, candidate: Candidate) -> Iterator[Rect]:
    """Yields the stretch of wall beside its windows, and beside doors across, where a rule prices these at SHUNNED or more."""
    wall, clear = candidate.wall, subject.scope.clear
    if wall is None:
        return
    shuns = {sort for spec in subject.relations if spec.type == "against_wall" for sort, cost in spec.walls.items() if cost >= SHUNNED}
    (a, b), (start, end) = wished_footprint(candidate).along(wall), clear.along(wall)
    for sort in shuns & {"window", "across"}:
        there = _made_by(subject.scope, wall, sort)
        if there and not any(low < b and a < high for low, high in there):
            least = max([start, *(high for _, high in there if high <= a)])
            most = min([end, *(low for low, _ in there if b <= low)])
            yield Rect(least, clear.z0, most, clear.z1) if wall in ALONG_X else Rect(clear.x0, least, clear.x1, most)


def _made_by(scope: Scope, wall: str, sort: str) -> list[tuple[int, int]]:
    """Returns the stretches of a wall's windows, or of the doors across from it."""
    if sort == "window":
        return [one.interval for one in scope.openings if one.wall == wall and one.kind == "window"]
    return [one.interval for one in scope.openings if one.wall == OPPOSITE[wall] and one.kind != "window"]


def _along_window(scope: Scope, candidate: Candidate) -> bool:
    """Tells whether a piece's long side lies before the middle of a window of another wall: a bed lengthwise under it."""
    rect, near = wished_footprint(candidate), 2 * scope.gap_mm
    if candidate.size_mm[1] <= candidate.size_mm[0]:
        return False
    others = [one for one in opened(scope, "window") if one.wall != candidate.wall and rect.wall_distance(one.wall, scope.clear) <= near]
    return any(a < sum(one.interval) // 2 < b for one in others for a, b in (rect.along(one.wall),))


def _in_corner(subject: Subject, spec: RelationSpec) -> Effect:
    clear, near = subject.scope.clear, 2 * subject.scope.gap_mm

    def cost_of(candidate: Candidate) -> float:
        rect = wished_footprint(candidate)
        away = [min(rect.wall_distance(wall, clear) for wall in walls) for walls in (("west", "east"), ("north", "south"))]
        return 0.0 if max(away) <= near else missed(spec)

    return Effect(cost_of=cost_of, corners=True, weight=spec.weight)


def _off_middle(spec: RelationSpec, off_mm: float) -> float:
    return missed(spec) * min(1.0, off_mm / CENTRED_REACH_MM) if off_mm else 0.0


def _centred(subject: Subject, spec: RelationSpec) -> Effect:
    middle = subject.scope.clear.centre

    def cost_of(candidate: Candidate) -> float:
        offsets = [abs(candidate.anchor_mm[axis] - middle[axis]) for axis in (0, 1)]
        if candidate.wall is not None:
            offsets = [offsets[0] if candidate.wall in ALONG_X else offsets[1]]
        return _off_middle(spec, max(offsets))

    kinds = [kind.name for kind, _ in subject.variants]
    positions = tuple((wall, kind, middle[0] if wall in ALONG_X else middle[1]) for wall in WALLS for kind in kinds)
    return Effect(cost_of=cost_of, positions=positions, spots=tuple((kind, middle) for kind in kinds), weight=spec.weight)


def _at_window(subject: Subject, spec: RelationSpec) -> Effect:
    windows = opened(subject.scope, "window")

    def cost_of(candidate: Candidate) -> float:
        here = [middle_of(window) for window in windows if window.wall == candidate.wall]
        axis = 0 if candidate.wall in ALONG_X else 1
        return _off_middle(spec, min((abs(candidate.anchor_mm[axis] - centre[axis]) for centre in here), default=math.inf))

    positions = tuple((window.wall, kind.name, sum(window.interval) // 2) for window in windows for kind, _ in subject.variants)
    return Effect(cost_of=cost_of, positions=positions, weight=spec.weight) if windows else NOTHING


_EFFECTS: dict[str, Callable[[Subject, RelationSpec], Effect]] = {
    "against_wall": _against_wall, "in_corner": _in_corner, "opposite": _opposite, "facing": _facing, "near": _near,
    "far_from": _far_from, "aligned_with": _aligned_with, "centred": _centred, "in_row": _in_row, "at_window": _at_window,
    "near_door": _near, "far_from_door": _far_from,
}  # fmt: skip
"""The relations that are more than slots at another piece's sides."""


def distance_mm(spec: RelationSpec, usual: int) -> int:
    """Returns the distance a relation wishes, mm."""
    return usual if spec.distance is None else to_mm(spec.distance)
