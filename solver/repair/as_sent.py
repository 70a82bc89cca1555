"""A room as sent -> pieces to place, every one of them to be kept, as near as can be to where it was sent."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

from solver.free_places import footprint, rounded_mm
from solver.geometry import ALONG_X, INWARDS, OPPOSITE, ROTATION_AT_WALL, Rect, rotate, strip, walls_beside
from solver.pieces import Attach, Candidate, Piece, Stand
from solver.repair.bodies import (
    AT_TABLE_MM,
    UNTUCKED_MM,
    Body,
    below,
    bounding_size,
    carriers,
    drawn_out,
    floor_bodies,
    root_of,
    size_of,
    squared,
    tables_of,
    too_deep_mm,
)
from solver.repair.room_problem import RepairSettings, RoomProblem, Walls
from solver.scene import Furniture, Room

SEAT_COST = 1.0
"""What another place at its table costs a chair."""
SLIDE_COST = 0.003
"""What sliding over another piece costs one on it, besides the way: as much as moving 5 cm."""
FREE_COST = 1.5
"""What leaving its table costs a tucked chair: more than another place at it, also where the table goes and the chair stays."""
MOVED_WEIGHT = 20.0
"""Weight of a piece the user has just moved against 1 for the others."""
SEAT_PULL = (0.02, 0.02)
"""Weights of a chair's wish for the middle of its side of a table: order, not preference."""
TURN_AT_SIDE = {"front": 180, "back": 0, "left": 90, "right": 270}
"""How a chair that looks at its table is turned against it, by the table's side."""
OTHER_WALL_COST = 4.0
"""What standing at another wall than the sent one costs: as much as moving 2 m."""
TURN_COST = 1.0
"""What it costs that a piece whose back was not at its wall is turned so, or one on another as that one is."""
OTHER_EDGE_COST = 0.05
"""What standing at another stretch of the sent wall costs, where an outline has several; and what being drawn in does, besides the way."""
WALL_FAR_MM = 200
"""Contract, rule wall_far: a piece whose wall is set stays within this of the wall's line,"""
FACE_FAR_MM = 150
"""or within this of its face, where the wall is thick."""


@dataclass(frozen=True)
class _Floor:
    """The bodies on the floor of a room: which table each tucked chair is under, who stays as sent, and which share space with which."""

    problem: RoomProblem
    tables: Mapping[str, Body]
    held: Mapping[str, tuple[str, ...]]
    crossing: tuple[tuple[str, ...], ...]


def pieces_as_sent(problem: RoomProblem) -> tuple[Piece, ...]:
    """Turns a sent room into pieces to place, most important first; they ask for their use sides."""
    room, settings = problem.room, problem.settings
    bodies = floor_bodies(room)
    crossing = tuple(issue.ids for issue in problem.errors if issue.rule == "overlap")
    floor = _Floor(problem, tables_of(bodies), holders(room, settings), crossing)
    bodies.sort(key=lambda body: _importance(body, settings))
    pieces = [_piece(body, _candidates(body, floor), settings) for body in bodies]
    return (*pieces, *_pieces_on_others(floor, {body.id: body for body in bodies}))


def holders(room: Room, settings: RepairSettings) -> dict[str, tuple[str, ...]]:
    """Returns for every body that stays as sent, on the floor or on others, the locked ids that make it: its own, or what it carries."""
    bodies = floor_bodies(room)
    by_id, parents = {body.id: body for body in bodies}, carriers(room)
    found: dict[str, list[str]] = {body.id: [body.id] for body in bodies if settings.is_locked(body)}
    for chair, table in tables_of(bodies).items():
        if settings.is_locked(by_id[chair]) and not too_deep_mm(by_id[chair], table):
            found.setdefault(table.id, []).append(chair)
    for piece in room.furniture:
        if piece.id in parents and root_of(piece.id, parents) in by_id and settings.is_locked(piece):
            for label in (piece.id, *below(piece.id, parents)):
                found.setdefault(label, []).append(piece.id)
    return {label: tuple(ids) for label, ids in found.items()}


def _importance(body: Body, settings: RepairSettings) -> tuple[bool, bool, bool, bool, float, str]:
    """Sorts locked before moved before required before large; what is tucked under something comes after it; ids tell equal ones apart."""
    tucked = isinstance(body, Furniture) and body.under is not None
    required = body.name in settings.required_names
    return (not settings.is_locked(body), tucked, body.id not in settings.moved, not required, -body.width * body.depth, body.id)


def _piece(body: Body, candidates: tuple[Candidate, ...], settings: RepairSettings) -> Piece:
    sides, need_all = settings.use_sides.get(body.name, ((), False)) if isinstance(body, Furniture) else ((), False)
    whole = body if candidates[0].stays else replace(body, x=body.width / 2, z=body.depth / 2, rotation=0)  # goes to whole millimetres
    stands = tuple(Stand(side, rounded_mm(whole)) for side in sides)
    return Piece(body.id, True, candidates, stands=stands, need_all=need_all)


def _pieces_on_others(floor: _Floor, bodies: Mapping[str, Body]) -> list[Piece]:
    """What stands on other pieces, in the frame of the one below it: rigid there, or sliding out of another's space."""
    room, settings = floor.problem.room, floor.problem.settings
    parents = carriers(room)
    crowded = {parents[label] for ids in floor.crossing for label in ids if label in parents}
    upon = [piece for piece in room.furniture if root_of(piece.id, parents) in bodies.keys() - {piece.id}]
    known, pieces = {**bodies, **{piece.id: piece for piece in upon}}, []
    for piece in sorted(upon, key=lambda piece: (len(below(piece.id, parents)), piece.id)):
        own = piece if settings.is_locked(piece) else replace(piece, rotation=squared(piece.rotation))
        carrier = known[parents[piece.id]]
        ways = _ways_upon(own, carrier)
        if piece.id in floor.held:
            ways = ways[:1]
        elif carrier.id in crowded:
            ways = (*ways, _sliding(ways[0], carrier))
        pieces.append(_piece(piece, ways, settings))
    return pieces


def _ways_upon(piece: Furniture, carrier: Body) -> tuple[Candidate, ...]:
    """Returns how a piece stands on another, turned as sent or as that one is: where it was sent, or drawn in where it juts out."""
    turned = [replace(piece, rotation=carrier.rotation)] if squared(piece.rotation - carrier.rotation) else []
    found: list[tuple[Furniture, float]] = []
    for one, cost in zip((piece, *turned), (0.0, TURN_COST), strict=False):
        there, whole = _brought_back(one, carrier), _drawn_in(one, carrier)
        found.append((there, cost))
        far = math.hypot(whole.x - there.x, whole.z - there.z)
        found += [(whole, cost + OTHER_EDGE_COST + far**2)] if far else []
    bottom = round(piece.y * 1000)
    return tuple(replace(_in_frame(one, carrier), on=carrier.id, bottom_mm=bottom, cost=cost) for one, cost in found)


def _sliding(upon: Candidate, carrier: Body) -> Candidate:
    """Returns a piece's way anywhere on what carries it, all of it over that, wished where it stands."""
    assert upon.attach is not None
    (x, z), below = (upon.attach.across_mm[0], upon.attach.along_mm[0]), bounding_size(carrier, footprint(carrier))
    half = [max(0, (long - own) // 2) for long, own in zip(below, upon.extent, strict=False)]
    across, along = ((min(-far, at), max(far, at)) for far, at in zip(half, (x, z), strict=True))
    return replace(upon, cost=SLIDE_COST, attach=upon.attach._replace(across_mm=across, along_mm=along, wish_mm=(x, z)))


def _candidates(body: Body, floor: _Floor) -> tuple[Candidate, ...]:
    """Returns the ways a body on the floor may stand, least costly first."""
    table = floor.tables.get(body.id)
    if body.id in floor.held:
        fits_under = table is not None and not too_deep_mm(body, table)
        return (replace(as_it_stands(body), under=table.id if table and fits_under else None),)
    ways = _loose(body, floor.problem)
    if table is None or not isinstance(body, Furniture):
        return ways
    straight = replace(body, rotation=squared(body.rotation))  # as it will stand, wherever it goes
    if not footprint(straight).overlaps(footprint(table).shrunk(-AT_TABLE_MM)):
        return (*ways, *_seats(straight, table, floor.problem.settings))
    free = tuple(replace(way, cost=way.cost + FREE_COST) for way in ways)
    as_sent = replace(_in_frame(drawn_out(straight, table), table), under=table.id, weights=ways[0].weights)
    crowded = any(body.id in ids and all(floor.tables.get(label) is table for label in ids) for ids in floor.crossing)
    seats = _seats(straight, table, floor.problem.settings, as_sent if crowded else None)
    slides = any(way.attach is not None and way.attach.wish_mm for way in seats)
    return (*(() if slides else (as_sent,)), *seats, *free)


def _seats(chair: Furniture, table: Body, settings: RepairSettings, as_sent: Candidate | None = None) -> tuple[Candidate, ...]:
    """Returns a chair's places along the sides of its table that people use, looking at it: as it is turned first.

    At the side where it was sent, if it may slide along it, it is wished there; at others in the middle.
    """
    wide, deep, _ = size = bounding_size(chair, footprint(chair))
    long, broad, _ = bounding_size(table, footprint(table))
    used = settings.use_sides.get(table.name, ((), False))[0] or tuple(TURN_AT_SIDE)
    own, found = (squared(chair.rotation) - squared(table.rotation)) % 360, []
    for side in sorted(used, key=lambda side: TURN_AT_SIDE[side] != own):
        turn = TURN_AT_SIDE[side]
        half, out = ((long - wide) // 2, broad) if turn % 180 == 0 else ((broad - wide) // 2, long)
        if half > 0:
            near, far = (out + deep + 1) // 2 - max(deep - UNTUCKED_MM, 0), (out + deep) // 2  # at either side, where that is odd
            ends, wish, weights, cost = [(-half, -near), (half, -far)], None, SEAT_PULL, SEAT_COST
            if as_sent is not None and as_sent.attach is not None and turn == own:
                sent = as_sent.attach.across_mm[0], as_sent.attach.along_mm[0]
                if rotate(*sent, -turn)[1] <= 1 - near:  # it is at this side
                    ends, wish, weights, cost = [*ends, rotate(*sent, -turn)], sent, as_sent.weights, 0.0
            across, along = zip(*(rotate(x, z, turn) for x, z in ends), strict=True)
            attach = Attach(table.id, table.name, (min(across), max(across)), (min(along), max(along)), wish_mm=wish)
            found.append(Candidate(chair.name, size, turn, weights=weights, cost=cost, attach=attach, under=table.id))
    return tuple(found)


def as_it_stands(body: Body) -> Candidate:
    """Returns the one candidate of a body that stays: its bounding rectangle where it is."""
    rect = footprint(body)
    return Candidate(
        body.name,
        bounding_size(body, rect),
        squared(body.rotation),
        anchor_mm=rect.centre,
        within=rect,
        bottom_mm=round(body.y * 1000),
    )


def _in_frame(child: Body, parent: Body) -> Candidate:
    """The one way of a body that keeps its place in another's frame."""
    turn = squared(parent.rotation)
    own, other = footprint(child), footprint(parent)
    dx = own.x0 - other.x0 - (other.width - own.width) // 2  # as the core counts, so that nothing drifts where one is odd
    dz = own.z0 - other.z0 - (other.depth - own.depth) // 2
    across, along = rotate(dx, dz, -turn % 360)
    attach = Attach(parent.id, parent.name, (across, across), (along, along))
    rotation = (squared(child.rotation) - turn) % 360
    return Candidate(child.name, bounding_size(child, own), rotation, attach=attach)


def _brought_back(piece: Furniture, carrier: Body) -> Furniture:
    """Returns a carried piece brought back over what carries it, where its centre is not over it any more."""
    below, own = footprint(carrier), footprint(piece)
    x, z = piece.x, piece.z
    if not below.x0 <= x * 1000 <= below.x1:
        x = _nearest(x, below.x0, below.x1, own.width)
    if not below.z0 <= z * 1000 <= below.z1:
        z = _nearest(z, below.z0, below.z1, own.depth)
    return replace(piece, x=x, z=z)


def _drawn_in(piece: Furniture, carrier: Body) -> Furniture:
    """Returns a carried piece moved by the shortest way to where all of it is over what carries it; to the middle where it is larger."""
    below, own = footprint(carrier), footprint(piece)
    x, z = _nearest(piece.x, below.x0, below.x1, own.width), _nearest(piece.z, below.z0, below.z1, own.depth)
    return replace(piece, x=x, z=z)


def _nearest(at: float, low: int, high: int, extent: int) -> float:
    """Returns the centre nearest to `at`, m, at which the extent lies within [low, high], mm, or their middle."""
    first, last = low + extent / 2, high - extent / 2
    return (low + high) / 2000 if first > last else min(max(at, first / 1000), last / 1000)


def _loose(body: Body, problem: RoomProblem) -> tuple[Candidate, ...]:
    """The ways of a loose body, least costly first: as sent; for one with a wall also at the other walls."""
    weight = MOVED_WEIGHT if body.id in problem.settings.moved else 1.0
    anchor = (math.floor(body.x * 1000 + 0.5), math.floor(body.z * 1000 + 0.5))  # the snap takes halves down again
    bottom = round(body.y * 1000)
    sent = Candidate(body.name, size_of(body), squared(body.rotation), None, anchor, (weight, weight), bottom_mm=bottom)
    wall = body.wall if isinstance(body, Furniture) else None
    if wall is None:
        return (sent,)
    rect, found = footprint(body), list[Candidate]()
    away = all(_outside(rect, region) for _, region in _at_wall(sent, wall, problem.walls))
    turn = 0 if away and body.name in problem.settings.wall_names else (sent.rotation - ROTATION_AT_WALL[wall]) % 360
    for other in (wall, *walls_beside(wall), OPPOSITE[wall]):
        way = replace(sent, rotation=(ROTATION_AT_WALL[other] + turn) % 360, cost=0.0 if other == wall else OTHER_WALL_COST)
        at_wall = _at_wall(way, other, problem.walls)
        if other == wall:
            at_wall.sort(key=lambda stretch: _outside(rect, stretch[1]))
            at_wall[1:] = [(replace(later, cost=OTHER_EDGE_COST), region) for later, region in at_wall[1:]]
            if turn and body.name in problem.settings.wall_names:
                back = replace(way, rotation=ROTATION_AT_WALL[wall], cost=TURN_COST)
                at_wall += _at_wall(back, wall, problem.walls)
        drawn = away or other != wall
        found += [_drawn_to(way, other, region, problem.space.gap_mm) if drawn else way for way, region in at_wall]
    return tuple(found)


def _drawn_to(way: Candidate, wall: str, region: Rect, gap_mm: int) -> Candidate:
    """Returns a way of a piece that was away from a wall: wished at it, what the way there costs counted as a cost of its own."""
    axis = 1 if wall in ALONG_X else 0
    anchor = list(way.anchor_mm)
    anchor[axis] = region.line(wall) + INWARDS[wall] * (gap_mm + way.extent[axis] // 2)
    far = (anchor[axis] - way.anchor_mm[axis]) / 1000
    return replace(way, anchor_mm=(anchor[0], anchor[1]), cost=way.cost + way.weights[axis] * far**2)


def most_away(half_mm: int) -> int:
    """Returns how far from its face a piece may be whose wall is that thick by half, mm."""
    return max(WALL_FAR_MM - half_mm, FACE_FAR_MM)


def _at_wall(way: Candidate, wall: str, walls: Walls) -> list[tuple[Candidate, Rect]]:
    """Returns a way at each stretch of one wall, and where its footprint may be there: at inner edges at least half before them."""
    width, depth = way.extent
    across, along = (depth, width) if wall in ALONG_X else (width, depth)
    slack = most_away(walls.half_mm)
    outer = strip(walls.clear, wall, walls.clear.along(wall), across + slack)
    found = [(replace(way, wall=wall, slack_mm=slack), outer)]
    for name, line, start, end in walls.inner:
        if name == wall:
            region = walls.before((name, line, start - along // 2, end + along // 2), across + slack).common(walls.clear)
            found.append((replace(way, wall=None, within=region, stretch_of=wall), region))
    return found


def _outside(rect: Rect, region: Rect) -> int:
    """Returns how far a footprint has to move to lie in a region, mm, both axes added."""
    return max(0, region.x0 - rect.x0, rect.x1 - region.x1) + max(0, region.z0 - rect.z0, rect.z1 - region.z1)
