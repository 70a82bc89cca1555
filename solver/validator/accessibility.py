"""Whether a home is accessible as a standard asks: for each room what is met, and what is missing, m.

Turning spaces are squares, also where a standard asks for a circle: that is stricter. The sweep of door leaves is not counted.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from math import ceil
from typing import Final

import numpy as np
from numpy.typing import NDArray

from catalogs import Catalogs, load_catalogs
from catalogs.access_profiles import AccessProfile, AccessRule
from solver.demanded import demand
from solver.errors import RequestError
from solver.geometry import INWARDS, OPPOSITE, extents
from solver.scene import Decoration, Furniture, Room, Scene
from solver.understanding import understood
from solver.validator.checking import check
from solver.validator.lattice import PER_METRE, ExactBox, exact, metres
from solver.validator.world import DOOR_KINDS, FLAT, PlacedRoom, World, side_of, world_of
from solver.wall_fittings import WIDEST_LEAF

HEADROOM: Final = exact(2.0)
"""What hangs higher is in nobody's way."""
PROTRUDES: Final = (exact(0.685), exact(0.1))
"""Above this height, what reaches no further from its wall than this is in nobody's way: pictures, towel bars (ADA 307.2)."""
LEAST_CM: Final = 10
"""The narrowest square that is tried, cm."""
AFTER: Final = {"north": "east", "south": "east", "east": "south", "west": "south"}
"""Where along a wall its coordinate grows."""
REACH: Final = "reach"
"""What is asked for beside a profile's rules: that its walker comes everywhere."""
BODY_WORK: Final = 0.5
"""What a body costs for each piece that something must be free before [see demanded.py]. Measured."""


@dataclass(frozen=True)
class AccessFinding:
    """One demand in one room: `id` is the body or opening it is about (None: the room), `needs` and `has` are lengths, m."""

    what: str
    room: str
    id: str | None
    clause: str
    needs: float
    has: float
    place: tuple[float, float, float, float] | None = None
    """The empty square found: its west, north, east and south edge in the room, m."""

    @property
    def missing(self) -> float:
        """How much is missing, m; 0 where it is met."""
        return round(max(0.0, self.needs - self.has), 4)


@dataclass(frozen=True)
class AccessReport:
    """All demands of a profile on a home; `unmet` are those that no other room makes up for."""

    profile: str
    description: str
    findings: tuple[AccessFinding, ...]
    unmet: tuple[AccessFinding, ...]

    def document(self) -> dict[str, object]:
        """Returns it as a document: by room what is asked for, what there is and how many centimetres are missing."""
        rooms: dict[str, list[dict[str, object]]] = {}
        for one in self.findings:
            entry = {"what": one.what, "id": one.id, "clause": one.clause, "needs": one.needs, "has": one.has}
            more = {"missing_cm": round(one.missing * 100, 2), **({"place": list(one.place)} if one.place else {})}
            rooms.setdefault(one.room, []).append(entry | more)
        unmet = [f"{one.id or one.room}: {one.what} {one.missing * 100:g} cm short" for one in self.unmet]
        return {"profile": self.profile, "description": self.description, "met": not unmet, "unmet": unmet, "rooms": rooms}


def access_profile(name: str, catalogs: Catalogs) -> AccessProfile:
    """Returns a profile.

    Raises:
        RequestError: there is none of this name.
    """
    if name not in catalogs.access:
        raise RequestError("access", f"unknown profile {name!r}", ", ".join(sorted(catalogs.access)))
    return catalogs.access[name]


def access_of(scene: Scene, name: str, catalogs: Catalogs | None = None) -> AccessReport:
    """Judges a home by a profile.

    Raises:
        RequestError: there is no such profile.
    """
    known = catalogs or load_catalogs()
    profile = access_profile(name, known)
    read = understood(scene, known).scene
    world = world_of(read)
    findings = list(_reach(read, known, profile))
    unmet = [one for one in findings if one.missing]
    for rule in profile.rules:
        found = [one for place in world.places if _about(rule, place.room) for one in _RULES[rule.what](rule, place, world)]
        findings += found
        unmet += _short(rule, found)
    return AccessReport(name, profile.description, tuple(findings), tuple(unmet))


def turning_squares(scene: Scene, name: str, catalogs: Catalogs | None = None) -> list[AccessFinding]:
    """Returns the empty squares that a profile's rules of turning find in a home: those met, and those that no other room makes up for.

    Raises:
        RequestError: there is no such profile.
    """
    known = catalogs or load_catalogs()
    rules = [rule for rule in access_profile(name, known).rules if rule.what == "turning"]
    world = world_of(understood(scene, known).scene)
    found = []
    for rule in rules:
        every = [one for place in world.places if _about(rule, place.room) for one in _turning(rule, place, world)]
        short = _short(rule, every)
        found += [one for one in every if not one.missing or one in short]
    return found


def _short(rule: AccessRule, found: Sequence[AccessFinding]) -> list[AccessFinding]:
    """Returns what of a rule is not met; of one that asks for a single room, that of the room that misses least."""
    if not rule.one:
        return [one for one in found if one.missing]
    rooms = dict.fromkeys(one.room for one in found)
    each = [[one for one in found if one.room == room and one.missing] for room in rooms]
    return min(each, key=lambda short: sum(one.missing for one in short), default=[])


def _reach(scene: Scene, catalogs: Catalogs, profile: AccessProfile) -> Iterator[AccessFinding]:
    """Yields for each room how wide a square comes into it and to all that is used there, in whole cm, the profile's walker at most."""

    @cache
    def missed(width: float) -> dict[str | None, tuple[str, ...]]:
        asked = {**(scene.request or {}), "robot_width": width}
        issues = check(replace(scene, request=asked), catalogs).issues
        return {issue.room: issue.ids for issue in reversed(issues) if issue.rule == "unreachable"}

    for room in scene.rooms:
        ids, has = missed(profile.walker).get(room.id, ()), profile.walker
        if room.id in missed(profile.walker):
            low, high = LEAST_CM - 1, ceil(round(profile.walker * 100, 6))
            while high - low > 1:
                middle = (low + high) // 2
                low, high = (low, middle) if room.id in missed(middle / 100) else (middle, high)
            has = low / 100 if low >= LEAST_CM else 0.0
        yield AccessFinding(REACH, room.id, ids[0] if ids else None, profile.description, profile.walker, has)


def _about(rule: AccessRule, room: Room) -> bool:
    return not room.outdoor and rule.is_about(room.type)


def _footprint(body: Furniture | Decoration) -> ExactBox:
    wide, deep = (exact(length) for length in extents(body.width, body.depth, body.rotation))
    x, z = exact(body.x), exact(body.z)
    return ExactBox(x - wide // 2, z - deep // 2, x + wide // 2, z + deep // 2)


def _clear(place: PlacedRoom, world: World) -> ExactBox:
    return place.outline.bounds.grown(-world.half_wall)


def _taken(place: PlacedRoom, world: World) -> list[tuple[Furniture | Decoration | None, ExactBox]]:
    """Returns what stands on a room's floor, and what of its bounds is none of it."""
    bodies: list[Furniture | Decoration] = [*place.room.furniture, *place.room.decorations]
    standing = [one for one in bodies if exact(one.height) > FLAT and _in_the_way(one)]
    free = [(one, _footprint(one)) for one in standing if not getattr(one, "on", None) and not getattr(one, "parent", None)]
    return [*free, *((None, box.grown(world.half_wall)) for box in place.outline.missing)]


def _in_the_way(body: Furniture | Decoration) -> bool:
    low, thin = PROTRUDES
    return exact(body.y) < HEADROOM and not (exact(body.y) >= low and exact(body.depth) <= thin)


def _turning(rule: AccessRule, place: PlacedRoom, world: World) -> Iterator[AccessFinding]:
    square = largest_square(_clear(place, world), [box for _, box in _taken(place, world)])
    has = metres(square.x1 - square.x0) if square else 0.0
    at = (square.x0 / PER_METRE, square.z0 / PER_METRE, square.x1 / PER_METRE, square.z1 / PER_METRE) if square else None
    yield AccessFinding(rule.what, place.room.id, None, rule.clause, rule.min, has, at)


def _door(rule: AccessRule, place: PlacedRoom, world: World) -> Iterator[AccessFinding]:
    for opening in place.room.openings:
        if opening.kind in DOOR_KINDS and (opening.main_entrance or not rule.main):
            within = rule.out and opening.kind == "door" and opening.swing == "in"
            has = 0.0 if within else round(opening.width - (rule.frame if opening.kind == "door" else 0.0), 4)
            yield AccessFinding(rule.what, place.room.id, opening.id, rule.clause, rule.min, has)


def _hallway(rule: AccessRule, place: PlacedRoom, world: World) -> Iterator[AccessFinding]:
    clear = _clear(place, world)
    yield AccessFinding(rule.what, place.room.id, None, rule.clause, rule.min, metres(min(clear.x1 - clear.x0, clear.z1 - clear.z0)))


def _pieces(rule: AccessRule, place: PlacedRoom, world: World) -> Iterator[tuple[Furniture, list[ExactBox]]]:
    """Yields the pieces a rule is about, each with what is in the way before it; what is tucked under it is none of that."""
    meant = [piece for piece in place.room.furniture if piece.name in rule.pieces]
    taken = _taken(place, world) if meant else []
    demand(BODY_WORK * len(meant) * len(taken))
    for piece in meant:
        yield piece, [box for one, box in taken if one is None or not _goes_with(one, piece, rule)]


def _goes_with(one: Furniture | Decoration, piece: Furniture, rule: AccessRule) -> bool:
    """Tells whether a body is the piece, is tucked under it, or may stand where the rule asks for room."""
    return piece.id in (one.id, getattr(one, "under", None)) or one.name in rule.beside


def _before(rule: AccessRule, place: PlacedRoom, world: World) -> Iterator[AccessFinding]:
    for piece, taken in _pieces(rule, place, world):
        side = side_of(piece.rotation, "front")
        frame = turned(_clear(place, world), side), [turned(box, side) for box in taken]
        own = turned(_footprint(piece), side)
        if rule.deep is None:
            needs, has = rule.min, depth_before(*frame, own.z1, (own.x0, own.x1))
        else:
            needs, has = rule.deep, deepest_before(*frame, own, exact(rule.min))
        yield AccessFinding(rule.what, place.room.id, piece.id, rule.clause, needs, metres(has))


def _along(rule: AccessRule, place: PlacedRoom, world: World) -> Iterator[AccessFinding]:
    for piece, taken in _pieces(rule, place, world):
        depths = []
        for name in ("left", "right"):
            side = side_of(piece.rotation, name)
            own = turned(_footprint(piece), side)
            depths.append(depth_before(turned(_clear(place, world), side), [turned(box, side) for box in taken], own.z1, (own.x0, own.x1)))
        for needs, has in ((rule.min, max(depths)), (rule.other or 0.0, min(depths))):
            yield AccessFinding(rule.what, place.room.id, piece.id, rule.clause, needs, metres(has))


def _approach(rule: AccessRule, place: PlacedRoom, world: World) -> Iterator[AccessFinding]:
    """Yields how deep the floor before each leaf is empty, and how far beside its latch."""
    leaves = [hole for hole in place.holes if hole.opening.kind == "door" and (hole.opening.swing == "in") == rule.pull]
    taken = [box for _, box in _taken(place, world)] if leaves else []
    demand(BODY_WORK * len(leaves) * len(taken))

    def empty(floor: ExactBox, side: str) -> int:
        box = turned(floor, side)
        return depth_before(turned(_clear(place, world), side), [turned(one, side) for one in taken], box.z1, (box.x0, box.x1))

    for opening, edge, *_ in leaves:
        face = edge._replace(line=edge.line + INWARDS[edge.side] * world.half_wall)
        deep = empty(face.strip(face.start, face.end, 0), OPPOSITE[face.side])
        yield AccessFinding(rule.what, place.room.id, opening.id, rule.clause, rule.min, metres(deep))
        if rule.latch and opening.hinge and opening.width <= WIDEST_LEAF:
            at, side = (face.end, AFTER[face.side]) if opening.hinge == "start" else (face.start, OPPOSITE[AFTER[face.side]])
            beside = empty(face.strip(at, at, min(deep, exact(rule.min))), side)
            yield AccessFinding(rule.what, place.room.id, opening.id, rule.clause, rule.latch, metres(beside))


_RULES: Final = {
    "turning": _turning,
    "door": _door,
    "hallway": _hallway,
    "before": _before,
    "deep": _before,
    "along": _along,
    "approach": _approach,
}


LINE_WORK: Final = 0.02
ONE_LINE: Final = 1500
"""What a box costs at each line that a square may begin at, and how many boxes' worth the line itself [see demanded.py]. Measured."""


def largest_square(bounds: ExactBox, taken: Sequence[ExactBox]) -> ExactBox | None:
    """Returns the largest empty square, the north-western of equal ones; None where no floor is empty.

    Pushed to the west and north as far as it goes, it lies at the bounds or at the edges of boxes.

    Raises:
        TooMuch: the call may not have so much work.
    """
    best: ExactBox | None = None
    most = 0
    norths = sorted({bounds.z0, *(box.z1 for box in taken if bounds.z0 <= box.z1 < bounds.z1)})
    demand(LINE_WORK * len(norths) * (len(taken) + ONE_LINE))
    ahead = np.array(sorted(taken), dtype=np.int64).reshape(-1, 4)
    for z in norths:
        ahead = ahead[ahead[:, 3] > z]
        while (x := _first_start(bounds, ahead, z, most + 1)) is not None:
            beside = ahead[ahead[:, 2] > x]
            free = np.maximum(beside[:, 0] - x, beside[:, 1] - z).min(initial=min(bounds.x1 - x, bounds.z1 - z))
            most = int(free)
            best = ExactBox(x, z, x + most, z + most)
    return best


def _first_start(bounds: ExactBox, ahead: NDArray[np.int64], z: int, side: int) -> int | None:
    """Returns the westernmost place within bounds where an empty square of a side, its north at z, begins.

    `ahead` are the boxes that end south of z, from west to east by where they begin.
    """
    beside = ahead[ahead[:, 1] < z + side]
    starts = np.maximum.accumulate(np.concatenate(([bounds.x0], beside[:, 2])))
    ends = np.minimum(np.concatenate((beside[:, 0], [bounds.x1])), bounds.x1)
    fits = np.flatnonzero(ends - starts >= side)
    return int(starts[fits[0]]) if fits.size and z + side <= bounds.z1 else None


def turned(box: ExactBox, side: str) -> ExactBox:
    """Returns a box in a frame in which what a side of the room's looks to is south."""
    if side == "south":
        return box
    if side == "north":
        return ExactBox(-box.x1, -box.z1, -box.x0, -box.z0)
    if side == "east":
        return ExactBox(-box.z1, box.x0, -box.z0, box.x1)
    return ExactBox(box.z0, -box.x1, box.z1, -box.x0)


def depth_before(bounds: ExactBox, taken: Sequence[ExactBox], line: int, span: tuple[int, int]) -> int:
    """Returns how deep the floor south of a line is empty over a whole span; nothing where the span leaves the bounds."""
    if span[0] < bounds.x0 or span[1] > bounds.x1:
        return 0
    ahead = [box.z0 - line for box in taken if box.x0 < span[1] and box.x1 > span[0] and box.z1 > line]
    return max(0, min([bounds.z1 - line, *ahead]))


def deepest_before(bounds: ExactBox, taken: Sequence[ExactBox], piece: ExactBox, wide: int) -> int:
    """Returns how deep an empty rectangle of a width south of a piece can be, its middle within the piece's extent."""
    low, high = piece.x0 - wide // 2, piece.x1 - wide // 2
    starts = {low, high, bounds.x0, bounds.x1 - wide, *(box.x1 for box in taken), *(box.x0 - wide for box in taken)}
    return max((depth_before(bounds, taken, piece.z1, (at, at + wide)) for at in starts if low <= at <= high), default=0)
