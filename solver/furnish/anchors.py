"""From a room type's pieces and rules to wanted pieces: which are asked for, in which order, and how each may stand."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from catalogs.schema import Catalogs, Piece, Rule
from solver.furnish.ask import Ask, Effect, Opened, Scope, Size
from solver.furnish.candidates import DRAW, candidates
from solver.furnish.openings import openings_of
from solver.furnish.relations import RELATIONS, SLOTTED
from solver.furnish.relations.places import footprint
from solver.furnish.runs import OFF_PLAN_COST, planned_run
from solver.furnish.walls import WallOccupancy
from solver.furnish.whims import Whims, count, drawn, ordered
from solver.geometry import FACING, Rect, rotate, strip
from solver.scene import Room, Sides
from solver.streams import Stream
from solver.wanted import Alternative, Link, Space, Stand, Wanted

Pose = tuple[str, Size, tuple[int, int], int]
"""Kind, size, centre (x, z) in mm and rotation of a piece where it is meant to stand."""
TOUCH_MM = 20
"""Overlaps up to this between meant places do not matter."""
LIMIT = 40
"""Most alternatives a piece gets: placement's time is linear in them."""
TAKEN_COST = 1.5
"""What it costs a free piece to be wished where an earlier piece is meant to stand: small things do not herd."""
WALL_COST, AHEAD_MM = 1.5, 1000
"""What it costs an armchair to look at a wall nearer than this."""
GATE_MM = 1000
"""Depth of the floor before a garage door where only cars are wished."""


def wanted_pieces(room: Room, space: Space, catalogs: Catalogs, stream: Stream) -> tuple[Wanted, ...]:
    """Returns what a room wants, required pieces first, each with all the ways it may stand.

    Args:
        room: with its type and openings; a type the catalogs do not know wants nothing.
        space: the room's `space_of`.
        catalogs: what there is, and the rules.
        stream: the room's own; it draws optional pieces and which of equal walls is preferred.
    """
    room_type = catalogs.rooms.get(room.type)
    if room_type is None:
        return ()
    openings = openings_of(room)
    scope = Scope(
        space, WallOccupancy(space, _gates(space, openings)), catalogs, openings, room.exterior_walls or Sides(), room.width * room.depth
    )
    pieces = ordered([piece for piece in room_type.pieces if not piece.without], stream)
    wanted: list[Wanted] = []
    earlier: dict[str, tuple[str, ...]] = {}
    kinds: dict[str, tuple[str, ...]] = {}
    poses: dict[str, Pose] = {}
    counted = [(suited, count(suited, scope.area, stream)) for suited in (_suited(piece, scope.area) for piece in pieces)]
    there = {piece.piece: piece for piece, copies in counted if copies}
    run = planned_run(scope, room_type.run, there, stream) if room_type.run else {}
    for piece, copies in counted:
        for number in range(1, copies + 1):
            one = _wanted(Ask(scope, piece, number, dict(earlier), dict(kinds)), drawn(stream))
            if one is None:
                break
            one = _in_run(one, run[piece.piece]) if number == 1 and piece.piece in run else one
            wanted.append(one)
            earlier[piece.piece] = (*earlier.get(piece.piece, ()), one.label)
            kinds[one.label] = tuple(dict.fromkeys(alternative.kind for alternative in one.alternatives))
            _intend(scope.walls, one, poses)
    return tuple(wanted)


def _in_run(one: Wanted, place: Alternative) -> Wanted:
    """Returns a piece of a run with its planned place as the cheapest way to stand."""
    others = [replace(way, cost=way.cost + OFF_PLAN_COST) for way in one.alternatives]
    return replace(one, alternatives=(place, *others[: LIMIT - 1]))


def _gates(space: Space, openings: Sequence[Opened]) -> tuple[Rect, ...]:
    """Returns the floor before each garage door, which its car needs."""
    return tuple(
        strip(space.clear, opening.wall, opening.interval, GATE_MM) for opening in openings if opening.kind == "garage_door"
    )  # fmt: skip


def _suited(piece: Piece, area: float) -> Piece:
    """Returns the piece with the size variants that suit a room of that area, m2."""
    return piece.model_copy(update={"kinds": tuple(variant for variant in piece.kinds if variant.min_area <= area)})


def _wanted(ask: Ask, whims: Whims) -> Wanted | None:
    """Returns one copy of a piece with its alternatives; None where a rule it cannot do without has nothing to hold on to."""
    piece, scope = ask.piece, ask.scope
    effects = [(rule, RELATIONS[rule.type](ask, rule)) for rule in piece.rules]
    clear = scope.space.clear
    alternatives = [replace(slot, cost=round(slot.cost + whims.cost(slot, piece, clear), 6)) for slot in _slotted(effects)]
    if not any(rule.required and rule.type in SLOTTED for rule, _ in effects):
        alternatives += _judged(ask, effects, whims)
    if not alternatives:
        return None
    alternatives.sort(key=lambda alternative: round(alternative.cost, 9))
    use = scope.entry(piece.variants[0].kind).use
    sides = piece.approach or (use.sides if use else ())
    return Wanted(
        f"{piece.piece}_{ask.number}",
        piece.required,
        tuple(alternatives[:LIMIT]),
        links=_links(effects),
        stands=tuple(Stand(side) for side in sides),
        need_all=bool(piece.approach or (use and use.need == "all")),
        skip_cost=piece.skip_cost,
        with_next=piece.with_next,
    )


def _links(effects: Sequence[tuple[Rule, Effect]]) -> tuple[Link, ...]:
    return tuple(link for _, effect in effects for link in effect.links)


def _slotted(effects: Sequence[tuple[Rule, Effect]]) -> Iterator[Alternative]:
    """Yields the slots; one that meets a rule pays for the other rules with slots that it misses."""
    must = [i for i, (rule, _) in enumerate(effects) if rule.required and rule.type in SLOTTED]
    for i, (_, effect) in enumerate(effects):
        if must and i not in must:
            continue
        missed = sum(other.cost for j, (other, theirs) in enumerate(effects) if j != i and theirs.slots)
        yield from (replace(slot, cost=round(slot.cost + missed, 6)) if missed else slot for slot in effect.slots)


def _judged(ask: Ask, effects: Sequence[tuple[Rule, Effect]], whims: Whims) -> list[Alternative]:
    """Returns the ways to stand at walls and in the room, costed by every rule, the best few of each sort."""
    missed = sum(rule.cost for rule, effect in effects if effect.slots)
    weight = max((effect.weight for _, effect in effects), default=0.0)
    found: list[tuple[float, Alternative]] = []
    for alternative in candidates(ask, [effect for _, effect in effects]):
        cost = alternative.cost + missed + whims.cost(alternative, ask.piece, ask.scope.space.clear)
        if alternative.wall is None:
            cost += _in_the_way(ask, footprint(alternative)) + _facing_wall(ask, alternative)
        cost += sum(effect.judge(alternative) for _, effect in effects if effect.judge)
        if cost < math.inf:
            found.append((round(cost, 6), alternative))
    pull = max(weight, DRAW)
    return [replace(alternative, cost=cost, weights=(pull, pull)) for cost, alternative in _best_of_each(ask, found)]


def _in_the_way(ask: Ask, rect: Rect) -> float:
    """Returns what a free place costs where another piece is meant to stand or a garage door opens."""
    walls = ask.scope.walls
    before_gate = any(rect.overlaps(gate) for gate in walls.gates) and not ask.faces(("garage_door",))
    return TAKEN_COST * (before_gate + walls.occupied(rect))


def _facing_wall(ask: Ask, alternative: Alternative) -> float:
    """Returns what it costs a piece used from its front only to stand so near to a wall that it looks at nothing else."""
    use = ask.scope.entry(alternative.kind).use
    if use is None or use.sides != ("front",):
        return 0.0
    rect, clear = footprint(alternative), ask.scope.space.clear
    dx, dz = FACING[alternative.rotation]
    ahead = {1: clear.x1 - rect.x1, -1: rect.x0 - clear.x0}[dx] if dx else {1: clear.z1 - rect.z1, -1: rect.z0 - clear.z0}[dz]
    return WALL_COST if ahead < AHEAD_MM else 0.0


def _best_of_each(ask: Ask, found: Sequence[tuple[float, Alternative]]) -> list[tuple[float, Alternative]]:
    """Keeps, for every variant, wall and way round, the cheapest anchors: a few for the wanted variant, one for the others."""
    wanted_kind = ask.piece.variants[0].kind
    corners = any(rule.type == "in_corner" for rule in ask.piece.rules)
    kept: dict[tuple[str, str | None, int], list[tuple[float, Alternative]]] = {}
    for cost, alternative in sorted(found, key=lambda entry: entry[0]):
        turn = alternative.rotation % (180 if _reversible(ask, alternative.kind) else 360)
        group = kept.setdefault((alternative.kind, alternative.wall, turn), [])
        few = 4 if corners and alternative.wall is None else 2
        room = few if alternative.kind == wanted_kind else few // 2
        if len(group) < room and all(alternative.anchor_mm != other.anchor_mm for _, other in group):
            group.append((cost, alternative))
    return [entry for group in kept.values() for entry in group]


def _reversible(ask: Ask, kind: str) -> bool:
    """Tells whether a kind is used from both of two opposite sides alike, so that turning it round changes only its looks."""
    use = ask.scope.entry(kind).use
    return use is not None and set(use.sides) in ({"left", "right"}, {"front", "back"})


def _intend(walls: WallOccupancy, wanted: Wanted, poses: dict[str, Pose]) -> None:
    """Marks where a piece would like best to stand, so that later pieces are first wished elsewhere."""
    for alternative in wanted.alternatives:
        pose = _pose(alternative, poses)
        if pose is not None:
            kind, size, centre, rotation = pose
            rect = footprint(replace(alternative, kind=kind, size_mm=size, anchor_mm=centre, rotation=rotation))
            if alternative.attach is None or not walls.occupied(rect.shrunk(TOUCH_MM)):
                poses[wanted.label] = pose
                if not (alternative.on or alternative.under):
                    walls.occupy(rect)
                return


def _pose(alternative: Alternative, poses: dict[str, Pose]) -> Pose | None:
    """Returns the pose an alternative would have if the pieces before it stood where they are meant to; None if void."""
    attach = alternative.attach
    if attach is None:
        return alternative.kind, alternative.size_mm, alternative.anchor_mm, alternative.rotation
    if attach.parent not in poses or poses[attach.parent][0] != attach.parent_kind:
        return None
    _, _, (x, z), turn = poses[attach.parent]
    dx, dz = rotate(sum(attach.across_mm) // 2, sum(attach.along_mm) // 2, turn)
    return alternative.kind, alternative.size_mm, (x + dx, z + dz), (turn + alternative.rotation) % 360
