"""Relations of a piece to the room as rectangles its footprint must stay in for the relation to hold.

Each function: a way to stand -> the rectangles (mm) within any of which the relation holds; () where it cannot hold so.
They lie a little inside what is asked for, so that the lattice's last millimetre decides nothing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Final, NamedTuple

from catalogs.schema import Rule
from solver.furnish.ask import Opened, Scope
from solver.furnish.relations.places import DOOR_DISTANCE
from solver.geometry import FACING, Rect
from solver.scene import WALLS

NEARLY_MM: Final = 90
"""How far from a corner, a middle or a window's middle still counts as there."""
EXACT_MM: Final = 5
"""What is kept clear of a wished distance."""
EVERYWHERE: Final = 1_000_000


class Way(NamedTuple):
    """A way to stand: extents along x and z, rotation, the wall at its back, and where the footprint may be at all."""

    extent: tuple[int, int]
    rotation: int
    wall: str | None
    reach: Rect


def _around(middle: float, half: float) -> tuple[int, int]:
    return math.ceil(middle - half), math.floor(middle + half)


def against_wall(_: Scope, __: Rule, way: Way) -> list[Rect]:
    """At any wall."""
    return [way.reach] if way.wall else []


def in_corner(scope: Scope, _: Rule, way: Way) -> list[Rect]:
    """In each of the four corners."""
    clear = scope.space.clear
    w, d = way.extent[0] + NEARLY_MM, way.extent[1] + NEARLY_MM
    return [
        Rect(x, z, x + w, z + d) for z in (clear.z0, clear.z1 - d) for x in (clear.x0, clear.x1 - w)
    ]  # fmt: skip


def centred(scope: Scope, _: Rule, way: Way) -> list[Rect]:
    """In the middle of the wall at its back, or of the room."""
    clear = scope.space.clear
    x0, x1 = _around((clear.x0 + clear.x1) / 2, way.extent[0] / 2 + NEARLY_MM)
    z0, z1 = _around((clear.z0 + clear.z1) / 2, way.extent[1] / 2 + NEARLY_MM)
    if way.wall in ("north", "south"):
        return [Rect(x0, clear.z0, x1, clear.z1)]
    if way.wall:
        return [Rect(clear.x0, z0, clear.x1, z1)]
    return [Rect(x0, z0, x1, z1)]


def at_window(scope: Scope, _: Rule, way: Way) -> list[Rect]:
    """At the wall of each window, on its middle."""
    return [_at(scope, way, window) for window in scope.opened("window")]


def _at(scope: Scope, way: Way, window: Opened) -> Rect:
    clear = scope.space.clear
    along = 0 if window.wall in ("north", "south") else 1
    a, b = _around(window.centre[along], way.extent[along] / 2 + NEARLY_MM)
    deep = way.extent[1 - along] + 2 * NEARLY_MM
    return {
        "north": Rect(a, clear.z0, b, clear.z0 + deep), "south": Rect(a, clear.z1 - deep, b, clear.z1),
        "west": Rect(clear.x0, a, clear.x0 + deep, b), "east": Rect(clear.x1 - deep, a, clear.x1, b),
    }[window.wall]  # fmt: skip


def near_door(scope: Scope, rule: Rule, way: Way) -> list[Rect]:
    """Within the distance of each door."""
    return _near(scope, rule, way, ("door",))


def far_from_door(scope: Scope, rule: Rule, way: Way) -> list[Rect]:
    """Beyond the distance from every door."""
    return _far(scope, rule, way, ("door",))


def near(scope: Scope, rule: Rule, way: Way) -> list[Rect]:
    """Within the distance of each opening of the kinds named."""
    return _near(scope, rule, way, rule.of)


def far_from(scope: Scope, rule: Rule, way: Way) -> list[Rect]:
    """Beyond the distance from every opening of the kinds named."""
    return _far(scope, rule, way, rule.of)


def facing(scope: Scope, rule: Rule, way: Way) -> list[Rect]:
    """Turned to the wall of an opening of the kinds named."""
    ahead = {(0, 1): "south", (1, 0): "east", (0, -1): "north", (-1, 0): "west"}[FACING[way.rotation]]
    return [way.reach] if any(opening.wall == ahead for kind in rule.of for opening in scope.opened(kind)) else []


def _wished_mm(rule: Rule) -> float:
    return (DOOR_DISTANCE if rule.distance is None else rule.distance) * 1000


def _near(scope: Scope, rule: Rule, way: Way, kinds: Sequence[str]) -> list[Rect]:
    wished = _wished_mm(rule) - EXACT_MM
    found = []
    for opening in (opening for kind in kinds for opening in scope.opened(kind)):
        x, z = opening.centre
        for half_x, half_z in _reaches(scope, way, opening, wished):
            a, b = _around(x, half_x + way.extent[0])
            c, d = _around(z, half_z + way.extent[1])
            found.append(Rect(a, c, b, d))
    return found


def _reaches(scope: Scope, way: Way, opening: Opened, wished: float) -> list[tuple[float, float]]:
    """Returns how far along x and z a footprint may be from an opening's middle: boxes inside the circle."""
    if wished < 0:
        return []
    if way.wall is None:
        flat, steep = 0.95 * wished, 0.31 * wished
        return [(0.7 * wished, 0.7 * wished), (flat, steep), (steep, flat)]
    across = 1 if way.wall in ("north", "south") else 0
    low, high = ((way.reach.x0, way.reach.x1), (way.reach.z0, way.reach.z1))[across]
    off = max(low - opening.centre[across], opening.centre[across] - high, 0)
    if off > wished:
        return []
    along = math.sqrt(wished**2 - off**2)
    return [(along, wished) if across else (wished, along)]


def _far(scope: Scope, rule: Rule, way: Way, kinds: Sequence[str]) -> list[Rect]:
    """Rectangles clear of the square around every opening; along a wall, exactly clear of the circle."""
    wished = _wished_mm(rule) + EXACT_MM
    found = [way.reach]
    for opening in (opening for kind in kinds for opening in scope.opened(kind)):
        x, z = opening.centre
        half_x = half_z = wished
        if way.wall is not None:
            across = 1 if way.wall in ("north", "south") else 0
            low, high = ((way.reach.x0, way.reach.x1), (way.reach.z0, way.reach.z1))[across]
            off = max(low - opening.centre[across], opening.centre[across] - high, 0)
            if off >= wished:
                continue
            half = math.sqrt(wished**2 - off**2)
            half_x, half_z = (half, EVERYWHERE) if across else (EVERYWHERE, half)
        found = [part for rect in found for part in _without(rect, (x, z), (half_x, half_z)) if _holds(part, way.extent)]
    return found


def _without(rect: Rect, point: tuple[int, int], half: tuple[float, float]) -> list[Rect]:
    """Returns the four largest parts of a rectangle beside a box around a point."""
    a, b = math.floor(point[0] - half[0]), math.ceil(point[0] + half[0])
    c, d = math.floor(point[1] - half[1]), math.ceil(point[1] + half[1])
    if b <= rect.x0 or a >= rect.x1 or d <= rect.z0 or c >= rect.z1:
        return [rect]
    return [
        Rect(rect.x0, rect.z0, min(a, rect.x1), rect.z1), Rect(max(b, rect.x0), rect.z0, rect.x1, rect.z1),
        Rect(rect.x0, rect.z0, rect.x1, min(c, rect.z1)), Rect(rect.x0, max(d, rect.z0), rect.x1, rect.z1),
    ]  # fmt: skip


def _holds(rect: Rect, extent: tuple[int, int]) -> bool:
    return rect.width >= extent[0] and rect.depth >= extent[1]


def within_both(a: Rect, b: Rect, extent: tuple[int, int]) -> Rect | None:
    """Returns what two rectangles share, if a footprint fits in it."""
    (a_x0, a_z0, a_x1, a_z1), (b_x0, b_z0, b_x1, b_z1) = a, b
    x0, x1 = a_x0 if a_x0 > b_x0 else b_x0, a_x1 if a_x1 < b_x1 else b_x1
    z0, z1 = a_z0 if a_z0 > b_z0 else b_z0, a_z1 if a_z1 < b_z1 else b_z1
    return Rect(x0, z0, x1, z1) if x1 - x0 >= extent[0] and z1 - z0 >= extent[1] else None


REGIONS: Final[dict[str, Callable[[Scope, Rule, Way], list[Rect]]]] = {
    "against_wall": against_wall, "in_corner": in_corner, "centred": centred, "at_window": at_window,
    "near_door": near_door, "far_from_door": far_from_door, "near": near, "far_from": far_from, "facing": facing,
}  # fmt: skip

__all__ = ["EVERYWHERE", "REGIONS", "WALLS", "Way", "within_both"]
