"""Seeded rooms of the fuzz: a Space and wanted pieces with all that their types can say, in odd millimetres, many too tight.

Doors in any walls, windows, missing corners; pieces at walls, with slack, free, within a part of the room; size variants;
companions tied, sliding, tucked under and on top, at named slots; use sides, any and all; links, some of them required.
"""

from __future__ import annotations

from solver.geometry import ROTATION_AT_WALL, Rect, strip
from solver.pieces import Attach, Candidate, Doorway, Link, Piece, Space, Stand, Zone
from solver.streams import Stream

WALLS = tuple(ROTATION_AT_WALL)
SIDES = ("front", "back", "left", "right")
Size = tuple[int, int, int]


def fuzz_room(seed: int) -> tuple[Space, tuple[Piece, ...]]:
    """Returns the room of a seed: 1-9 pieces on 2.5-16 m2."""
    stream = Stream(seed, "fuzz")
    space = _space(stream)
    pieces: list[Piece] = []
    count = 1 + stream.below(9)
    required = stream.below(min(count, 5) + 1)
    for k in range(count):
        pieces.append(_wanted(space, stream, pieces, (f"piece_{k}", k < required)))
    return space, tuple(pieces)


def _space(stream: Stream) -> Space:
    width, depth = 1500 + stream.below(2500), 1500 + stream.below(2500)
    clear = Rect(50, 50, width - 50, depth - 50)
    walls, zones, doorways = list(WALLS), list[Zone](), list[Doorway]()
    stream.shuffle(walls)
    for k in range(stream.below(3) if stream.chance(0.5) else 1):
        wide = 650 + stream.below(300)
        low, high = clear.along(walls[k])
        at = low + stream.below(max(high - low - wide, 1))
        square = strip(Rect(0, 0, width, depth), walls[k], (at, at + wide), wide)
        doorways.append(Doorway(f"door_{k}", walls[k], square, "hall"))
        zones.append(Zone(square, -1, f"door_{k}"))
    if stream.chance(0.6):
        low, high = clear.along(walls[3])
        wide = 500 + stream.below(high - low - 500)
        at = low + stream.below(high - low - wide + 1)
        zones.append(Zone(strip(Rect(0, 0, width, depth), walls[3], (at, at + wide), 500), 700 + stream.below(500), "window_0"))
    corner = _corner(clear, stream)
    if stream.chance(0.2) and not any(corner.overlaps(door.square) for door in doorways):
        zones.append(Zone(corner, -1, "outline"))
    return Space("room", clear, tuple(zones), tuple(doorways), gap_mm=stream.pick((30, 30, 0)))


def _corner(clear: Rect, stream: Stream) -> Rect:
    """Returns a rectangle in a corner: what an L-shaped room lacks."""
    wide, deep = 200 + stream.below(clear.width // 3), 200 + stream.below(clear.depth // 3)
    x0 = stream.pick((clear.x0 - 50, clear.x1 + 50 - wide))
    z0 = stream.pick((clear.z0 - 50, clear.z1 + 50 - deep))
    return Rect(x0, z0, x0 + wide, z0 + deep)


def _size(stream: Stream) -> Size:
    return 200 + stream.below(1500), 200 + stream.below(700), 300 + stream.below(1800)


def _wanted(space: Space, stream: Stream, earlier: list[Piece], named: tuple[str, bool]) -> Piece:
    label, required = named
    floor = [piece for piece in earlier if not any(a.on for a in piece.candidates)]
    if floor and stream.chance(0.08):
        return Piece(label, required, _on_top(stream, stream.pick(floor), label))
    sizes = [_size(stream)]
    if stream.chance(0.3):
        sizes.append((max(sizes[0][0] * 2 // 3, 150), sizes[0][1], sizes[0][2]))
    alternatives: list[Candidate] = []
    for order, size in enumerate(sizes):
        kind, cost = f"{label}/{order}", 0.7 * order
        if floor and stream.chance(0.3):
            alternatives += _companions(stream, stream.pick(floor), (kind, size, cost))
        elif stream.chance(0.65):
            alternatives += _at_walls(space, stream, (kind, size, cost))
        else:
            alternatives += _free(space, stream, (kind, size, cost))
    stands = _stands(stream)
    links = (_link(stream, stream.pick(earlier)),) if earlier and stream.chance(0.25) else ()
    return Piece(label, required, tuple(alternatives), links, stands, stream.chance(0.3))


def _stands(stream: Stream) -> tuple[Stand, ...]:
    sides = [side for side in SIDES if stream.chance(0.3)] if stream.chance(0.5) else []
    return tuple(Stand(side) for side in sides)


def _at_walls(space: Space, stream: Stream, of: tuple[str, Size, float]) -> list[Candidate]:
    """One alternative or two for each of some walls, now and then with slack."""
    kind, size, cost = of
    found = []
    slack = stream.below(300) if stream.chance(0.1) else None
    for wall in [wall for wall in WALLS if stream.chance(0.75)] or [stream.pick(WALLS)]:
        low, high = space.clear.along(wall)
        for _ in range(1 + stream.below(2)):
            along = low + stream.below(high - low)
            anchor = (along, 0) if wall in ("north", "south") else (0, along)
            weights = (stream.pick((0.02, 0.3, 1.0, 20.0)), stream.pick((0.02, 0.3, 1.0, 20.0)))
            more = stream.below(30) / 10
            found.append(Candidate(kind, size, ROTATION_AT_WALL[wall], wall, anchor, weights, cost=cost + more, slack_mm=slack))
    return found


def _free(space: Space, stream: Stream, of: tuple[str, Size, float]) -> list[Candidate]:
    """Two or four rotations about one anchor, now and then kept within a part of the room."""
    kind, size, cost = of
    clear = space.clear
    anchor = (clear.x0 + stream.below(clear.width), clear.z0 + stream.below(clear.depth))
    within = None
    if stream.chance(0.15):
        x, z = clear.x0 + stream.below(clear.width // 2), clear.z0 + stream.below(clear.depth // 2)
        within = Rect(x, z, min(x + clear.width * 2 // 3, clear.x1), min(z + clear.depth * 2 // 3, clear.z1))
    turns = stream.pick(((0, 90), (0, 90, 180, 270), (180,)))
    return [Candidate(kind, size, turn, None, anchor, (0.5, 0.5), within, cost + 0.1 * k) for k, turn in enumerate(turns)]


def _companions(stream: Stream, parent: Piece, of: tuple[str, Size, float]) -> list[Candidate]:
    """One slot at each of some sides of every variant of an earlier piece."""
    kind, size, cost = of
    size = (min(size[0], 700), min(size[1], 600), size[2])
    found = []
    variants = {(a.kind, a.size_mm): None for a in parent.candidates}
    gap, slide = stream.below(400), stream.pick((0, 0, 150, 401))
    tucked = stream.chance(0.3)
    for parent_kind, (wide, deep, _) in variants:
        for order, side in enumerate(("front", "left", "right")):
            turn = {"front": 180, "left": 90, "right": 270}[side] if stream.chance(0.5) else 0
            own = size if turn % 180 == 0 else (size[1], size[0])
            reach = -min(own[1], 300) if tucked else gap
            along, across = (deep + own[1]) // 2 + reach, (wide + own[0]) // 2 + reach
            if side == "front":
                at = ((-slide, slide), (along, along))
            else:
                at = ((across, across) if side == "right" else (-across, -across), (-slide, slide))
            attach = Attach(parent.label, parent_kind, *at, slot=side if stream.chance(0.8) else "")
            under = parent.label if tucked else None
            found.append(Candidate(kind, size, turn, weights=(0.3, 0.3), cost=cost + 0.05 * order, attach=attach, under=under))
    return found


def _on_top(stream: Stream, parent: Piece, kind: str) -> tuple[Candidate, ...]:
    """Anywhere on top of every variant of an earlier piece."""
    variants = {(a.kind, a.size_mm): None for a in parent.candidates}
    wide, deep = (min(size[axis] for _, size in variants) for axis in (0, 1))
    size = (50 + stream.below(wide - 50), 50 + stream.below(deep - 50), 100 + stream.below(600))
    found = []
    for parent_kind, (parent_wide, parent_deep, high) in variants:
        room = ((parent_wide - size[0]) // 2, (parent_deep - size[1]) // 2)
        attach = Attach(parent.label, parent_kind, (-room[0], room[0]), (-room[1], room[1]), "top")
        found.append(Candidate(kind, size, 0, weights=(0.3, 0.3), bottom_mm=high, attach=attach, on=parent.label))
    return tuple(found)


def _link(stream: Stream, other: Piece) -> Link:
    turn = stream.pick((None, None, 0, 180))
    walls = stream.pick((None, "opposite", "same", "other", "adjacent"))
    pull = 0.2 if stream.chance(0.4) else 0.0
    return Link("linked", other.label, turn, walls, 0.5, stream.chance(0.3), align=pull, near=0.3 * pull, apart_m=1.0, apart_cost=0.2)
