"""What a person would measure in a furnished room, from the scene alone; shares no code with what furnishes.

Comes in: a `Room` of a scene. Goes out: shares, lengths and counts, metres. Lines are the wall lines; a wall's face is half
a wall inside them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import combinations, pairwise

from solver.scene import Furniture, Opening, Room

FACE = 0.05
"""From a wall's line to its face."""
TOUCHING, SLIVER = 0.05, 0.15
"""Gaps up to the first are contact, beyond it and below the second slivers: too narrow for a hand, wide enough for dust."""
NARROW = 0.30
SHARED = 0.15
"""How long two sides must face each other before the gap between them counts."""
CENTRED = 0.3
SIGHT_WIDTH, SIGHT_HEIGHT = 0.6, 0.5
TALL_OR_SOFT = ("bed", "single_bed", "bunk_bed", "sofa", "tv_stand", "wardrobe", "bookshelf", "refrigerator", "pantry")
GROUP = ("sofa", "coffee_table", "tv", "tv_stand")
AHEAD = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}


@dataclass(frozen=True)
class Box:
    """A piece's footprint between the wall lines, its height, and where its front looks."""

    piece: Furniture
    x0: float
    z0: float
    x1: float
    z1: float
    top: float
    ahead: tuple[int, int]

    @property
    def middle(self) -> tuple[float, float]:
        """Its centre."""
        return (self.x0 + self.x1) / 2, (self.z0 + self.z1) / 2

    @property
    def front(self) -> tuple[float, float]:
        """The middle of its front edge."""
        (x, z), (dx, dz) = self.middle, self.ahead
        return x + dx * (self.x1 - self.x0) / 2, z + dz * (self.z1 - self.z0) / 2

    def meets(self, x0: float, z0: float, x1: float, z1: float) -> bool:
        """Tells whether it shares more than a millimetre with a rectangle."""
        return min(self.x1, x1) - max(self.x0, x0) > 1e-3 and min(self.z1, z1) - max(self.z0, z0) > 1e-3


def boxes(room: Room) -> list[Box]:
    """Returns the room's furniture as boxes."""
    return [_box(piece) for piece in room.furniture]


def _box(piece: Furniture) -> Box:
    turn = round(piece.rotation) % 360
    width, depth = (piece.width, piece.depth) if turn % 180 == 0 else (piece.depth, piece.width)
    x0, z0 = piece.x - width / 2, piece.z - depth / 2
    return Box(piece, x0, z0, x0 + width, z0 + depth, piece.y + piece.height, AHEAD[turn])


def cover(room: Room) -> float:
    """Returns the share of the floor between the wall lines that pieces standing on it cover, overlaps counted once."""
    standing = [box for box in boxes(room) if box.piece.on is None]
    xs = sorted({x for box in standing for x in (box.x0, box.x1)})
    area = 0.0
    for x0, x1 in pairwise(xs):
        spans = sorted((box.z0, box.z1) for box in standing if box.x0 < x1 - 1e-9 and box.x1 > x0 + 1e-9)
        reach = -math.inf
        for z0, z1 in spans:
            area += (x1 - x0) * max(0.0, z1 - max(z0, reach))
            reach = max(reach, z1)
    return area / (room.width * room.depth)


def gaps(room: Room) -> list[float]:
    """Returns the widths of all gaps of at most NARROW between neighbouring sides of pieces, and between pieces and walls.

    Chairs at their table and things on others have no neighbours; a gap that something fills is none.
    """
    standing = [box for box in boxes(room) if box.piece.on is None and box.piece.under is None]
    found = [gap for one, two in combinations(standing, 2) for gap in _between(one, two, standing)]
    for box in standing:
        found += [_to_wall(room, box, side, standing) for side in range(4)]
    return [gap for gap in found if gap <= NARROW]


def _between(one: Box, two: Box, standing: list[Box]) -> Iterator[float]:
    for low, high, strip in _strips(one, two):
        if high - low >= -1e-3:
            between = strip(low + 1e-3, high - 1e-3)
            if high - low < 5e-3 or not any(box.meets(*between) for box in standing if box not in (one, two)):
                yield max(high - low, 0.0)


def _strips(one: Box, two: Box) -> Iterator[tuple[float, float, Callable[[float, float], tuple[float, float, float, float]]]]:
    """Yields the span between two boxes along x and along z where their sides face each other."""
    a, b = max(one.z0, two.z0), min(one.z1, two.z1)
    if b - a >= SHARED:
        left, right = (one, two) if one.x0 < two.x0 else (two, one)
        yield left.x1, right.x0, lambda low, high: (low, a, high, b)
    c, d = max(one.x0, two.x0), min(one.x1, two.x1)
    if d - c >= SHARED:
        upper, lower = (one, two) if one.z0 < two.z0 else (two, one)
        yield upper.z1, lower.z0, lambda low, high: (c, low, d, high)


def _to_wall(room: Room, box: Box, side: int, standing: list[Box]) -> float:
    strips = (
        (FACE, box.z0, box.x0, box.z1),
        (box.x1, box.z0, room.width - FACE, box.z1),
        (box.x0, FACE, box.x1, box.z0),
        (box.x0, box.z1, box.x1, room.depth - FACE),
    )
    x0, z0, x1, z1 = strips[side]
    if any(other.meets(x0, z0, x1, z1) for other in standing if other is not box):
        return math.inf
    return (x1 - x0) if side < 2 else (z1 - z0)


def slivers(room: Room) -> tuple[int, int]:
    """Returns how many gaps are slivers, and how many gaps there are in all up to NARROW."""
    found = gaps(room)
    return sum(TOUCHING < gap < SLIVER - 1e-3 for gap in found), len(found)


def under_windows(room: Room) -> list[str]:
    """Returns the tall or soft pieces whose back is centred at a window."""
    return [
        box.piece.name
        for box in boxes(room)
        for opening in room.openings
        if opening.kind == "window" and box.piece.name in TALL_OR_SOFT and _centred_at(room, box, opening)
    ]


def _centred_at(room: Room, box: Box, window: Opening) -> bool:
    back = {"north": box.z0, "south": room.depth - box.z1, "west": box.x0, "east": room.width - box.x1}[str(window.wall)] - FACE
    middle = box.middle[0] if window.wall in ("north", "south") else box.middle[1]
    return back < 0.2 and abs(middle - window.position) < CENTRED


def turned_away(room: Room) -> tuple[int, int]:
    """Returns how many armchairs of a room with a sofa look past sofa, coffee table and TV by more than 60 degrees; and all."""
    there = boxes(room)
    group = [box for box in there if box.piece.name in GROUP]
    chairs = [box for box in there if box.piece.name == "armchair"] if any(box.piece.name == "sofa" for box in group) else []
    return sum(not any(_looks_at(chair, box) for box in group) for chair in chairs), len(chairs)


def _looks_at(chair: Box, other: Box) -> bool:
    dx, dz = other.middle[0] - chair.middle[0], other.middle[1] - chair.middle[1]
    return dx * chair.ahead[0] + dz * chair.ahead[1] >= 0.5 * math.hypot(dx, dz)


def sight_free(room: Room) -> bool | None:
    """Tells whether the strip from the sofa's middle to the TV's holds nothing above SIGHT_HEIGHT; None without both."""
    there = boxes(room)
    sofa = next((box for box in there if box.piece.name == "sofa"), None)
    tv = next((box for box in there if box.piece.name == "tv"), None)
    if sofa is None or tv is None:
        return None
    if not _looks_at(sofa, tv):
        return False
    along = 0 if sofa.ahead[0] else 1
    low, high = sorted((sofa.front[along], tv.front[along]))
    others = [box for box in there if box.piece.id not in (sofa.piece.id, tv.piece.id, tv.piece.on) and box.top > SIGHT_HEIGHT]
    steps = 24
    for k in range(steps):
        here, there_ = low + (high - low) * k / steps, low + (high - low) * (k + 1) / steps
        share = (here + there_ - 2 * sofa.front[along]) / (2 * (tv.front[along] - sofa.front[along]) or 1)
        aside = sofa.middle[1 - along] + share * (tv.middle[1 - along] - sofa.middle[1 - along])
        a, b = aside - SIGHT_WIDTH / 2, aside + SIGHT_WIDTH / 2
        if any(box.meets(*((here, a, there_, b) if along == 0 else (a, here, b, there_))) for box in others):
            return False
    return True


def triangle(room: Room) -> tuple[float, float, float] | None:
    """Returns the distances between the middles of the fronts of sink, stove and refrigerator; None without all three."""
    there = boxes(room)
    fronts = [next((box.front for box in there if box.piece.name == name), None) for name in ("sink", "stove", "refrigerator")]
    if any(front is None for front in fronts):
        return None
    a, b, c = (front for front in fronts if front is not None)
    return math.dist(a, b), math.dist(b, c), math.dist(c, a)


def works(legs: tuple[float, float, float]) -> bool:
    """Tells whether a working triangle keeps the NKBA kitchen planning guidelines: legs of 1.2-2.7 m, 4.0-7.9 m in all."""
    return all(1.2 - 1e-3 <= leg <= 2.7 + 1e-3 for leg in legs) and 4.0 - 1e-3 <= sum(legs) <= 7.9 + 1e-3


def signature(room: Room) -> tuple[tuple[str, str], ...]:
    """Returns the pieces and the wall each stands at, in no order: what tells one arrangement from another at a glance."""
    return tuple(sorted((box.piece.name, _wall(room, box)) for box in boxes(room) if box.piece.on is None))


def _wall(room: Room, box: Box) -> str:
    dx, dz = box.ahead
    back = {(0, 1): box.z0, (0, -1): room.depth - box.z1, (1, 0): box.x0, (-1, 0): room.width - box.x1}[dx, dz]
    return {(0, 1): "north", (0, -1): "south", (1, 0): "west", (-1, 0): "east"}[dx, dz] if back - FACE < 0.06 else "free"


WISHED = {"toilet": ((0.18, "left"), (0.18, "right")), "dining_chair": ((0.3, "back"),), "office_chair": ((0.3, "back"),),
          "sofa": ((0.2, "front"),), "stove": ((0.9, "front"),), "sink": ((0.9, "front"),), "counter": ((0.9, "front"),),
          "refrigerator": ((0.9, "front"),), "dishwasher": ((0.9, "front"),)}  # fmt: skip
"""Floor that is comfortable to have free, m, by the piece's name."""


def comfort(room: Room) -> tuple[int, int]:
    """Returns how many pieces of WISHED have the floor about them free of pieces and walls; and how many there are."""
    there = boxes(room)
    mine = [box for box in there if box.piece.name in WISHED]
    return sum(all(_free(room, box, side, depth, there) for depth, side in WISHED[box.piece.name]) for box in mine), len(mine)


def _free(room: Room, box: Box, side: str, depth: float, there: list[Box]) -> bool:
    dx, dz = box.ahead
    dx, dz = {"front": (dx, dz), "back": (-dx, -dz), "right": (dz, -dx), "left": (-dz, dx)}[side]
    x0, x1 = (box.x1, box.x1 + depth) if dx > 0 else (box.x0 - depth, box.x0) if dx < 0 else (box.x0, box.x1)
    z0, z1 = (box.z1, box.z1 + depth) if dz > 0 else (box.z0 - depth, box.z0) if dz < 0 else (box.z0, box.z1)
    if min(x0, z0) < FACE - 1e-3 or x1 > room.width - FACE + 1e-3 or z1 > room.depth - FACE + 1e-3:
        return False
    others = [other for other in there if other is not box and other.piece.id != box.piece.on and other.piece.on != box.piece.id]
    return not any(other.meets(x0, z0, x1, z1) for other in others)
