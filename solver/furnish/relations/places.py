"""Relations of a piece to the room: walls, corners, middles, windows and doors."""

from __future__ import annotations

import math

from catalogs.schema import Rule
from solver.furnish.ask import NOTHING, Ask, Effect, Judge, Opened, Scope
from solver.geometry import Rect, turned
from solver.scene import WALLS
from solver.wanted import Alternative

CENTRED_REACH_MM = 1000
"""A piece this far from where it should be centred pays the full cost."""
LONGER = 1.15
"""A wall is long, and those beside it short, from this ratio on: a square room has neither."""
DOOR_DISTANCE = 1.5
"""What near_door and far_from_door take for near and far where the rule names no distance, m."""


def footprint(alternative: Alternative) -> Rect:
    """Returns the footprint an alternative has at its anchor."""
    width, depth = turned(alternative.size_mm[0], alternative.size_mm[1], alternative.rotation)
    x, z = alternative.anchor_mm
    return Rect(x - width // 2, z - depth // 2, x - width // 2 + width, z - depth // 2 + depth)


def distance_m(rect: Rect, point: tuple[int, int]) -> float:
    """Returns the distance of a point from a rectangle, m."""
    dx = max(rect.x0 - point[0], point[0] - rect.x1, 0)
    dz = max(rect.z0 - point[1], point[1] - rect.z1, 0)
    return math.hypot(dx, dz) / 1000


def against_wall(ask: Ask, rule: Rule) -> Effect:
    """Stands with its back to a wall; `walls` says what walls of each sort cost."""
    scope = ask.scope

    def judge(alternative: Alternative) -> float:
        if alternative.wall is None:
            return math.inf if rule.required else rule.cost
        return sum(cost for sort, cost in rule.walls.items() if _is(scope, alternative, sort))

    return Effect(judge=judge, backs=True)


def _is(scope: Scope, alternative: Alternative, sort: str) -> bool:
    """Tells whether the wall behind an alternative is of a sort; only a window right behind it counts."""
    wall = alternative.wall or ""
    clear = scope.space.clear
    here = [opening for opening in scope.openings if opening.wall == wall]
    along_x = wall in ("north", "south")
    own, other = (clear.width, clear.depth) if along_x else (clear.depth, clear.width)
    if sort == "window":
        a, b = footprint(alternative).along(wall)
        behind = any(o.kind == "window" and o.interval[0] < b and a < o.interval[1] for o in here)
        return behind or _beside_window(scope, alternative)
    return {
        "door": any(o.kind != "window" for o in here),
        "plain": not here,
        "exterior": getattr(scope.exterior, wall, False),
        "long": own > LONGER * other,
        "short": other > LONGER * own,
    }[sort]


def _beside_window(scope: Scope, alternative: Alternative) -> bool:
    """Tells whether a piece's long side lies before the middle of a window of another wall: a bed lengthwise under it."""
    rect, clear, near = footprint(alternative), scope.space.clear, 2 * scope.space.gap_mm
    if alternative.size_mm[1] <= alternative.size_mm[0]:
        return False
    away = {"north": rect.z0 - clear.z0, "south": clear.z1 - rect.z1, "west": rect.x0 - clear.x0, "east": clear.x1 - rect.x1}
    others = [o for o in scope.openings if o.kind == "window" and o.wall != alternative.wall and away[o.wall] <= near]
    return any(a < sum(o.interval) // 2 < b for o in others for a, b in (rect.along(o.wall),))


def in_corner(ask: Ask, rule: Rule) -> Effect:
    """Stands in a corner of the room."""
    clear, reach = ask.scope.space.clear, 2 * ask.scope.space.gap_mm

    def judge(alternative: Alternative) -> float:
        rect = footprint(alternative)
        at_x = rect.x0 - clear.x0 <= reach or clear.x1 - rect.x1 <= reach
        at_z = rect.z0 - clear.z0 <= reach or clear.z1 - rect.z1 <= reach
        return 0.0 if at_x and at_z else _missed(rule)

    return Effect(judge=judge, corners=True, weight=rule.weight)


def centred(ask: Ask, rule: Rule) -> Effect:
    """Stands in the middle: of its wall, or of the room."""
    clear = ask.scope.space.clear
    middle = ((clear.x0 + clear.x1) // 2, (clear.z0 + clear.z1) // 2)

    def judge(alternative: Alternative) -> float:
        offsets = [abs(alternative.anchor_mm[axis] - middle[axis]) for axis in (0, 1)]
        if alternative.wall is not None:
            offsets = [offsets[0] if alternative.wall in ("north", "south") else offsets[1]]
        return _missed(rule) * min(1.0, max(offsets) / CENTRED_REACH_MM) if max(offsets) else 0.0

    kinds = [variant.kind for variant in ask.piece.variants]
    positions = tuple((wall, kind, middle[0] if wall in ("north", "south") else middle[1]) for wall in WALLS for kind in kinds)
    return Effect(judge=judge, positions=positions, spots=tuple((kind, middle) for kind in kinds), weight=rule.weight)


def at_window(ask: Ask, rule: Rule) -> Effect:
    """Stands at a window, centred on it; falls away in a room without one."""
    windows = ask.scope.opened("window")
    if not windows:
        return NOTHING

    def judge(alternative: Alternative) -> float:
        offsets = [_offset(alternative, window) for window in windows if window.wall == alternative.wall]
        return _missed(rule) * min(1.0, min(offsets, default=math.inf) / CENTRED_REACH_MM) if min(offsets, default=1) else 0.0

    kinds = [variant.kind for variant in ask.piece.variants]
    positions = tuple((window.wall, kind, sum(window.interval) // 2) for window in windows for kind in kinds)
    return Effect(judge=judge, positions=positions, weight=rule.weight)


def _offset(alternative: Alternative, opening: Opened) -> int:
    """Returns how far along the wall an anchor is from an opening's middle, mm."""
    axis = 0 if opening.wall in ("north", "south") else 1
    return abs(alternative.anchor_mm[axis] - opening.centre[axis])


def near_door(ask: Ask, rule: Rule) -> Effect:
    """Stands within `distance` of a door; what is beyond it costs, in full at twice the distance."""
    return nearness(ask, rule, ("door",))


def far_from_door(ask: Ask, rule: Rule) -> Effect:
    """Stands at least `distance` from every door; what is short of it costs, in full at the door."""
    return remoteness(ask, rule, ("door",))


def nearness(ask: Ask, rule: Rule, kinds: tuple[str, ...]) -> Effect:
    """Cost of being farther than `distance` from the nearest opening of some kinds."""
    return _off_distance(ask, rule, kinds, 1)


def remoteness(ask: Ask, rule: Rule, kinds: tuple[str, ...]) -> Effect:
    """Cost of being nearer than `distance` to any opening of some kinds."""
    return _off_distance(ask, rule, kinds, -1)


def _off_distance(ask: Ask, rule: Rule, kinds: tuple[str, ...], sign: int) -> Effect:
    """Cost of being beyond (sign 1) or short of (-1) the wished distance to the nearest opening."""
    points = [opening.centre for kind in kinds for opening in ask.scope.opened(kind)]
    wished = DOOR_DISTANCE if rule.distance is None else max(rule.distance, 0.01)
    if not points:
        return NOTHING

    def judge(alternative: Alternative) -> float:
        rect = footprint(alternative)
        off = sign * (min(distance_m(rect, point) for point in points) - wished)
        return _missed(rule) * min(1.0, off / wished) if off > 0 else 0.0

    return Effect(judge=judge)


def turned_to(ask: Ask, rule: Rule, kinds: tuple[str, ...]) -> Judge | None:
    """Cost of not facing the wall of an opening; None where the room has no such opening."""
    walls = {opening.wall for kind in kinds for opening in ask.scope.opened(kind)}
    facing = {"south": 0, "east": 90, "north": 180, "west": 270}
    rotations = [facing[wall] for wall in WALLS if wall in walls]
    return (lambda alternative: 0.0 if alternative.rotation in rotations else _missed(rule)) if rotations else None


def _missed(rule: Rule) -> float:
    return math.inf if rule.required else rule.cost
