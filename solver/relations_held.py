"""Is a relation held? Judged from the finished room alone, in exact millimetres, one function a relation.

Comes in: a room, what a name stands for, a piece and a rule. Goes out: whether it holds, and with which body. May import:
catalogs, scene, geometry. Shares no code with what brings relations about (furnish, placement, the pipeline's holding).

Tolerances, m: a piece is *at* a wall when its back is within 0.05 of its face; in a corner, centred, aligned or at a window
within 0.1; a `gap` that is given is met within 0.02; distances are met to the millimetre.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from catalogs.schema import Rule
from solver.geometry import FACING, OPPOSITE, WALL_BEHIND, Rect, rotate
from solver.scene import WALLS, Furniture, Opening, Room

AT_WALL_MM: Final = 50
NEARLY_MM: Final = 100
GAP_MM: Final = 20
DISTANCE_MM: Final = 1500
"""What near, near_door and far_from_door take for a distance where the rule names none."""
FAR_MM: Final = 2000
"""What far_from takes."""
GAPS_MM: Final = {
    "beside": (0, 300), "in_front_of": (0, 700), "around": (-10_000, 300), "under": (-10_000, -10), "in_row": (0, 20),
}  # fmt: skip
"""Gaps that are held where the rule names none."""
ROUND_CORNER_MM: Final = 100
"""How near a row must come to what it continues round the corner from."""


@dataclass(frozen=True)
class Standing:
    """A body as it stands: its footprint in its room, mm, and where its front looks."""

    id: str
    rect: Rect
    rotation: int
    bottom: int
    on: str | None

    @property
    def centre(self) -> tuple[int, int]:
        """Twice its centre (x, z), mm: exact."""
        return self.rect.x0 + self.rect.x1, self.rect.z0 + self.rect.z1


@dataclass(frozen=True)
class Judged:
    """A room to be judged: its clear floor, openings, and bodies by id."""

    clear: Rect
    openings: Sequence[tuple[str, str, tuple[float, float]]]
    """Kind, wall, and the middle of it on the wall's line (x, z), mm."""
    bodies: Mapping[str, Standing]
    names: Mapping[str, Sequence[str]]
    """The ids that each name of an `of` stands for."""
    surfaces: Mapping[str, Sequence[int]]
    """Heights of the surfaces of a body above the floor, by id, mm."""

    def at(self, body: Standing) -> str | None:
        """Returns the wall a body's back stands at."""
        wall = WALL_BEHIND[body.rotation]
        return wall if self.wall_distance(body, wall) <= AT_WALL_MM else None

    def wall_distance(self, body: Standing, wall: str) -> int:
        """Returns how far a body is from a wall's face, mm."""
        rect, clear = body.rect, self.clear
        return {
            "north": rect.z0 - clear.z0, "south": clear.z1 - rect.z1, "west": rect.x0 - clear.x0, "east": clear.x1 - rect.x1,
        }[wall]  # fmt: skip

    def opened(self, kinds: Sequence[str]) -> list[tuple[str, tuple[float, float]]]:
        """Returns wall and middle of the openings of some kinds."""
        return [(wall, middle) for kind, wall, middle in self.openings if kind in kinds]


def judged(room: Room, wall_thickness: float, names: Mapping[str, Sequence[str]], surfaces: Mapping[str, Sequence[float]]) -> Judged:
    """Prepares a room for judging.

    Args:
        room: finished.
        wall_thickness: m.
        names: the ids that each name of an `of` stands for.
        surfaces: heights above a body's underside that things may stand on, by id, m.
    """
    half = -(-round(wall_thickness * 1000) // 2)
    clear = Rect(half, half, round(room.width * 1000) - half, round(room.depth * 1000) - half)
    bodies = {piece.id: _standing(piece) for piece in room.furniture}
    heights = {
        name: [bodies[name].bottom + round(height * 1000) for height in found] for name, found in surfaces.items() if name in bodies
    }  # fmt: skip
    return Judged(clear, [_opened(room, opening) for opening in room.openings], bodies, names, heights)


def _standing(piece: Furniture) -> Standing:
    turn = round(piece.rotation / 90) * 90 % 360
    width, depth = _extents(piece)
    x, z = round(piece.x * 2000), round(piece.z * 2000)
    rect = Rect((x - width) // 2, (z - depth) // 2, (x + width) // 2, (z + depth) // 2)
    return Standing(piece.id, rect, turn, round(piece.y * 1000), piece.on)


def _extents(piece: Furniture) -> tuple[int, int]:
    width, depth = piece.width * 1000, piece.depth * 1000
    if piece.rotation % 90 == 0:
        return (round(depth), round(width)) if piece.rotation % 180 else (round(width), round(depth))
    angle = math.radians(piece.rotation)
    c, s = abs(math.cos(angle)), abs(math.sin(angle))
    return math.ceil(width * c + depth * s), math.ceil(width * s + depth * c)


def _opened(room: Room, opening: Opening) -> tuple[str, str, tuple[float, float]]:
    kind = "door" if opening.kind == "passage" else opening.kind
    along, width, depth = opening.position * 1000, room.width * 1000, room.depth * 1000
    if opening.edge is not None and room.outline and opening.edge < len(room.outline):
        return _on_edge(kind, room.outline, opening.edge, along)
    wall = opening.wall or ""
    middle = {"north": (along, 0.0), "south": (along, depth), "west": (0.0, along), "east": (width, along)}.get(wall, (math.inf, math.inf))
    return kind, wall, middle


def _on_edge(kind: str, outline: Sequence[tuple[float, float]], edge: int, along: float) -> tuple[str, str, tuple[float, float]]:
    (x0, z0), (x1, z1) = outline[edge], outline[(edge + 1) % len(outline)]
    if z0 == z1:
        return kind, "north" if x1 > x0 else "south", (min(x0, x1) * 1000 + along, z0 * 1000)
    return kind, "east" if z1 > z0 else "west", (x0 * 1000, min(z0, z1) * 1000 + along)


def held(room: Judged, label: str, rule: Rule) -> tuple[bool, str | None]:
    """Tells whether a piece's relation is held, and with which body or opening of those it names.

    A relation to several holds when it holds with any of them; far_from when it holds with all. A relation to what is not
    in the room (an opening it does not have, a piece that found no place) is not held; far_from it is.
    """
    own = room.bodies.get(label)
    if own is None:
        return False, rule.of[0] if rule.of else None
    if not rule.of:
        return IN_ROOM[rule.type](room, own, rule), None
    answers = [(name, _with(room, own, rule, name)) for name in rule.of]
    if rule.type == "far_from":
        return all(answer for _, answer in answers), rule.of[0]
    return next(((True, name) for name, answer in answers if answer), (False, rule.of[0]))


def _with(room: Judged, own: Standing, rule: Rule, name: str) -> bool:
    others = [room.bodies[i] for i in room.names.get(name, ()) if i in room.bodies and i != own.id]
    if name not in room.names:
        return TO_OPENING[rule.type](room, own, rule, (name,))
    if rule.type == "far_from":
        return all(_far(own, other, rule) for other in others)
    return any(BETWEEN[rule.type](room, own, other, rule) and _walls(room, own, other, rule) for other in others)


def against_wall(room: Judged, own: Standing, _: Rule) -> bool:
    """Its back is at a wall."""
    return room.at(own) is not None


def in_corner(room: Judged, own: Standing, _: Rule) -> bool:
    """It is near two walls that meet."""
    near = {wall for wall in WALLS if room.wall_distance(own, wall) <= NEARLY_MM}
    return bool(near & {"north", "south"}) and bool(near & {"east", "west"})


def centred(room: Judged, own: Standing, _: Rule) -> bool:
    """It is in the middle of the wall at its back, or of the room."""
    clear, wall = room.clear, room.at(own)
    x, z = abs(own.centre[0] - clear.x0 - clear.x1), abs(own.centre[1] - clear.z0 - clear.z1)
    off = max(x, z) if wall is None else x if wall in ("north", "south") else z
    return off <= 2 * NEARLY_MM


def at_window(room: Judged, own: Standing, _: Rule) -> bool:
    """It is at the wall of a window, its middle on the window's middle."""
    return any(
        room.wall_distance(own, wall) <= 2 * NEARLY_MM and abs(own.centre[_axis(wall)] - 2 * middle[_axis(wall)]) <= 2 * NEARLY_MM
        for wall, middle in room.opened(("window",))
        if wall in WALLS
    )


def near_door(room: Judged, own: Standing, rule: Rule) -> bool:
    """It is within the distance of a door."""
    return _near_opening(room, own, rule, ("door",))


def far_from_door(room: Judged, own: Standing, rule: Rule) -> bool:
    """It is at least the distance from every door."""
    return _far_from_opening(room, own, rule, ("door",))


def _near_opening(room: Judged, own: Standing, rule: Rule, kinds: Sequence[str]) -> bool:
    wished = _distance(rule, DISTANCE_MM)
    return any(_to_point(own.rect, middle) <= wished for _, middle in room.opened(kinds))


def _far_from_opening(room: Judged, own: Standing, rule: Rule, kinds: Sequence[str]) -> bool:
    wished = _distance(rule, DISTANCE_MM)
    return all(_to_point(own.rect, middle) >= wished for _, middle in room.opened(kinds))


def _facing_opening(room: Judged, own: Standing, _: Rule, kinds: Sequence[str]) -> bool:
    return any(OPPOSITE[WALL_BEHIND[own.rotation]] == wall for wall, _ in room.opened(kinds))


def _distance(rule: Rule, default: int) -> float:
    return default if rule.distance is None else rule.distance * 1000


def _to_point(rect: Rect, point: tuple[float, float]) -> float:
    return math.hypot(max(rect.x0 - point[0], point[0] - rect.x1, 0), max(rect.z0 - point[1], point[1] - rect.z1, 0))


def apart_mm(a: Rect, b: Rect) -> float:
    """Returns the free distance between two footprints, mm; 0 where they touch or overlap."""
    return math.hypot(max(a.x0 - b.x1, b.x0 - a.x1, 0), max(a.z0 - b.z1, b.z0 - a.z1, 0))


def _axis(wall: str) -> int:
    return 0 if wall in ("north", "south") else 1


def near(_: Judged, own: Standing, other: Standing, rule: Rule) -> bool:
    """The free distance between them is at most the wished one."""
    return apart_mm(own.rect, other.rect) <= _distance(rule, DISTANCE_MM)


def _far(own: Standing, other: Standing, rule: Rule) -> bool:
    return apart_mm(own.rect, other.rect) >= _distance(rule, FAR_MM)


def far_from(_: Judged, own: Standing, other: Standing, rule: Rule) -> bool:
    """The free distance between them is at least the wished one."""
    return _far(own, other, rule)


def aligned_with(_: Judged, own: Standing, other: Standing, __: Rule) -> bool:
    """Their middles are in line along x or along z."""
    return any(abs(own.centre[axis] - other.centre[axis]) <= 2 * NEARLY_MM for axis in (0, 1))


def opposite(room: Judged, own: Standing, other: Standing, _: Rule) -> bool:
    """Each looks at the other, from opposite walls where the other is at one, and one's middle meets the other."""
    if (own.rotation - other.rotation) % 360 != 180 or not _ahead(own, other) or not _ahead(other, own):
        return False
    wall = room.at(other)
    return (wall is None or room.at(own) == OPPOSITE[wall]) and (_meets(own, other) or _meets(other, own))


def facing(_: Judged, own: Standing, other: Standing, __: Rule) -> bool:
    """The other's middle lies before its front, no farther aside than ahead; or straight before it."""
    dx, dz = FACING[own.rotation]
    x, z = other.centre[0] - own.centre[0], other.centre[1] - own.centre[1]
    return abs(x * dz) + abs(z * dx) <= x * dx + z * dz > 0 or (_ahead(own, other) and _meets(own, other))


def _ahead(own: Standing, other: Standing) -> bool:
    """Tells whether the other lies wholly before the own front."""
    dx, dz = FACING[own.rotation]
    a, b = own.rect, other.rect
    return {1: b.x0 >= a.x1, -1: b.x1 <= a.x0}[dx] if dx else {1: b.z0 >= a.z1, -1: b.z1 <= a.z0}[dz]


def _meets(own: Standing, other: Standing) -> bool:
    """Tells whether the line from the own middle along its front meets the other."""
    axis = 0 if FACING[own.rotation][0] == 0 else 1
    low, high = (other.rect.x0, other.rect.x1) if axis == 0 else (other.rect.z0, other.rect.z1)
    return 2 * low <= own.centre[axis] <= 2 * high


def _sides(own: Standing, other: Standing, rule: Rule, sides: Sequence[str]) -> Iterator[str]:
    """Yields the sides of the other at which the own piece stands, the wished gap away; past its edge where it reaches under it."""
    low, high = GAPS_MM[rule.type]
    if rule.gap is not None:
        low, high = round(rule.gap[0] * 1000) - GAP_MM, round(rule.gap[1] * 1000) + GAP_MM
    for side in rule.sides or sides:
        dx, dz = _normal(other, side)
        a, b = own.rect, other.rect
        gap = {1: a.x0 - b.x1, -1: b.x0 - a.x1}[dx] if dx else {1: a.z0 - b.z1, -1: b.z0 - a.z1}[dz]
        reach = a.width if dx else a.depth
        if max(low, 1 - reach) <= gap <= high and _lined_up(own, other, rule, dx == 0):
            yield side


def _normal(other: Standing, side: str) -> tuple[int, int]:
    return rotate(*{"front": (0, 1), "back": (0, -1), "left": (-1, 0), "right": (1, 0)}[side], other.rotation)


def _lined_up(own: Standing, other: Standing, rule: Rule, along_x: bool) -> bool:
    """Tells whether they line up along a side as the rule says; by default they share half of the shorter one's length."""
    a, b = own.rect, other.rect
    low, high = ((a.x0, a.x1), (b.x0, b.x1)) if along_x else ((a.z0, a.z1), (b.z0, b.z1))
    if rule.align == "centre":
        return abs(sum(low) - sum(high)) <= 2 * NEARLY_MM
    if rule.align in ("back", "front"):
        dx, dz = _normal(other, rule.align)
        end = 1 if dx + dz > 0 else 0
        # Before a front there is no back to line up with: the ends in the room's order would mean nothing.
        return abs(low[end] - high[end]) <= NEARLY_MM if (dx != 0) == along_x else True
    return 2 * (min(low[1], high[1]) - max(low[0], high[0])) >= min(low[1] - low[0], high[1] - high[0])


def beside(_: Judged, own: Standing, other: Standing, rule: Rule) -> bool:
    """It stands at the left or right of the other, close to it."""
    return any(_sides(own, other, rule, ("left", "right")))


def in_front_of(_: Judged, own: Standing, other: Standing, rule: Rule) -> bool:
    """It stands before the other's front."""
    return any(_sides(own, other, rule, ("front",)))


def around(_: Judged, own: Standing, other: Standing, rule: Rule) -> bool:
    """It stands at a side of the other and looks at it."""
    return any(_looks_at_side(own, other, side) for side in _sides(own, other, rule, ("front", "back", "left", "right")))


def under(_: Judged, own: Standing, other: Standing, rule: Rule) -> bool:
    """It stands at a side of the other, looks at it and reaches under it."""
    sides = _sides(own, other, rule, ("front",))
    return own.rect.overlaps(other.rect) and any(_looks_at_side(own, other, side) for side in sides)


def _looks_at_side(own: Standing, other: Standing, side: str) -> bool:
    dx, dz = _normal(other, side)
    return FACING[own.rotation] == (-dx, -dz)


def in_row(_: Judged, own: Standing, other: Standing, rule: Rule) -> bool:
    """It continues the other's row, backs in line; or, `wall: adjacent`, does so round the corner."""
    if rule.wall == "adjacent":
        return apart_mm(own.rect, other.rect) <= ROUND_CORNER_MM
    in_line = rule.model_copy(update={"align": "back"})
    return own.rotation == other.rotation and any(_sides(own, other, in_line, ("left", "right")))


def on(room: Judged, own: Standing, other: Standing, _: Rule) -> bool:
    """Its middle is over the other, and its underside on one of the other's surfaces."""
    x, z = own.centre
    rect = other.rect
    over = 2 * rect.x0 <= x <= 2 * rect.x1 and 2 * rect.z0 <= z <= 2 * rect.z1
    return over and own.on == other.id and own.bottom in room.surfaces.get(other.id, ())


def _walls(room: Judged, own: Standing, other: Standing, rule: Rule) -> bool:
    """Tells whether the walls at their backs lie as the rule's `wall` says."""
    if rule.wall is None:
        return True
    mine, theirs = room.at(own), room.at(other)
    if mine is None or theirs is None:
        return False
    found = "same" if mine == theirs else "opposite" if OPPOSITE[mine] == theirs else "adjacent"
    return found == rule.wall or (rule.wall == "other" and found != "same")


IN_ROOM: Final[Mapping[str, Callable[[Judged, Standing, Rule], bool]]] = {
    "against_wall": against_wall,
    "in_corner": in_corner,
    "centred": centred,
    "at_window": at_window,
    "near_door": near_door,
    "far_from_door": far_from_door,
}
TO_OPENING: Final[Mapping[str, Callable[[Judged, Standing, Rule, Sequence[str]], bool]]] = {
    "near": _near_opening,
    "far_from": _far_from_opening,
    "facing": _facing_opening,
}
BETWEEN: Final[Mapping[str, Callable[[Judged, Standing, Standing, Rule], bool]]] = {
    "near": near,
    "far_from": far_from,
    "aligned_with": aligned_with,
    "opposite": opposite,
    "facing": facing,
    "beside": beside,
    "in_front_of": in_front_of,
    "around": around,
    "under": under,
    "in_row": in_row,
    "on": on,
}
