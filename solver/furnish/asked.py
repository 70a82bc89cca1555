"""From a list of pieces with relations, asked for by a user, to wanted pieces whose ways to stand hold those relations.

Unlike a room type's rules, which cost by degree, a relation asked for is held or not. So every way to stand says which it
holds: by a rectangle its footprint stays in (regions), or by its place in another piece's frame (boxes, slots); what it
does not hold, it pays for.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from catalogs.checks import OPENINGS
from catalogs.schema import Catalogs, Piece, Rule
from solver.furnish.ask import Ask, Effect, Scope, Size
from solver.furnish.openings import openings_of
from solver.furnish.relations import RELATIONS, SLOTTED
from solver.furnish.relations.boxes import ANYWHERE, BOXES, Box, Fit, shared
from solver.furnish.relations.regions import REGIONS, Way, within_both
from solver.furnish.walls import WallOccupancy
from solver.geometry import ROTATION_AT_WALL, Rect, turned
from solver.scene import WALLS, Room, Sides
from solver.wanted import Alternative, Attach, Link, Space, Stand, Wanted

PULL = 0.03
"""Pull of a piece to where a way to stand would like it best, m^-2: order, not preference."""
LOOSE_COST = 0.1
"""What a place that slides costs more than the exact one: pieces line up where they can."""
FREE_COST = 0.2
"""What standing in the middle of the room costs a piece that may also stand at a wall."""
UNSURE = 0.25
"""The part of a relation's cost that a way pays which neither holds nor breaks it."""
LIMIT = 32
"""Most ways of a piece."""
EACH = 3
"""Most ways of one wall or rotation that differ in what they hold."""
NEAR_PULL, ALIGN_PULL = 0.5, 2.0
"""Weights, m^-2, of the pulls of near and facing, and of opposite and aligned_with."""


@dataclass(frozen=True)
class _Asking:
    """One copy of a piece with its rules, those to the room apart from those to other pieces."""

    ask: Ask
    to_room: tuple[Rule, ...]
    to_pieces: tuple[Rule, ...]

    @property
    def kind(self) -> str:
        return self.ask.piece.variants[0].kind

    @property
    def size(self) -> Size:
        return self.ask.scope.size(self.kind)

    @property
    def at_walls(self) -> bool:
        return self.ask.scope.entry(self.kind).stands == "wall"


def asked_pieces(room: Room, space: Space, catalogs: Catalogs, pieces: Sequence[Piece], standing: Sequence[Wanted]) -> tuple[Wanted, ...]:
    """Returns the wanted pieces of a list, in its order, behind those that stand already.

    Args:
        room: with its openings.
        space: the room's `space_of`.
        catalogs: with the kinds of the pieces and of what stands already.
        pieces: each after those its rules refer to; a rule to a later one is left to the caller.
        standing: what stands in the room already, one way each.
    """
    openings = openings_of(room)
    area = room.width * room.depth
    scope = Scope(space, WallOccupancy(space), catalogs, openings, room.exterior_walls or Sides(), area)
    wanted = list(standing)
    earlier: dict[str, tuple[str, ...]] = {one.label: (one.label,) for one in standing}
    kinds: dict[str, tuple[str, ...]] = {one.label: (one.alternatives[0].kind,) for one in standing}
    for piece in pieces:
        for number in range(1, piece.count + 1):
            label = piece.piece if piece.count == 1 else f"{piece.piece}_{number}"
            wanted.append(_wanted(Ask(scope, piece, number, dict(earlier), dict(kinds)), label))
            earlier[piece.piece] = (*earlier.get(piece.piece, ()), label)
            kinds[label] = (piece.variants[0].kind,)
    return tuple(wanted)


def _wanted(ask: Ask, label: str) -> Wanted:
    rules = [rule for rule in ask.piece.rules if not rule.of or set(rule.of) & set(OPENINGS) or ask.labels(rule.of)]
    to_room = tuple(rule for rule in rules if not ask.labels(rule.of))
    asking = _Asking(ask, to_room, tuple(rule for rule in rules if rule not in to_room))
    ways = [*_own_ways(asking), *_exact_slots(asking), *_loose_slots(asking)]
    ways = [way for way in ways if way.cost < math.inf] or [replace(way, cost=0.0) for way in _anywhere(asking)]
    ways.sort(key=lambda way: round(way.cost, 9))
    use = ask.scope.entry(asking.kind).use
    return Wanted(
        label,
        ask.piece.required,
        tuple(ways[:LIMIT]),
        links=tuple(_links(asking)),
        stands=tuple(Stand(side) for side in (use.sides if use else ())),
        need_all=bool(use and use.need == "all"),
        skip_cost=ask.piece.skip_cost,
    )


def _anywhere(asking: _Asking) -> Iterator[Alternative]:
    """Yields the ways of a piece whose hard relations no way can hold, so that placement can say so."""
    bare = _Asking(asking.ask, (), ())
    yield from _own_ways(bare)


def _missed(rule: Rule) -> float:
    return math.inf if rule.required else rule.cost


def _own_ways(asking: _Asking) -> Iterator[Alternative]:
    """Yields the ways to stand at walls and in the room."""
    pairs = sum(_unsure(rule) for rule in asking.to_pieces)
    for way in _stances(asking):
        for rect, cost in _kept(asking, way)[:EACH]:
            free = FREE_COST if way.wall is None else 0.0
            yield Alternative(
                asking.kind, asking.size, way.rotation, way.wall, _anchor(asking, way, rect), (PULL, PULL),
                within=rect, cost=cost + pairs + free,
            )  # fmt: skip


def _unsure(rule: Rule) -> float:
    """Returns what a way pays that is not tied to the piece a rule names."""
    if rule.type in SLOTTED and rule.wall != "adjacent":
        return _missed(rule)
    return 0.0 if rule.type == "opposite" else rule.cost * UNSURE


def _stances(asking: _Asking) -> Iterator[Way]:
    clear, gap = asking.ask.scope.space.clear, asking.ask.scope.space.gap_mm
    width, depth, _ = asking.size
    for wall in WALLS:
        extent = turned(width, depth, ROTATION_AT_WALL[wall])
        band = {
            "north": Rect(clear.x0, clear.z0 + gap, clear.x1, clear.z0 + gap + depth),
            "south": Rect(clear.x0, clear.z1 - gap - depth, clear.x1, clear.z1 - gap),
            "west": Rect(clear.x0 + gap, clear.z0, clear.x0 + gap + depth, clear.z1),
            "east": Rect(clear.x1 - gap - depth, clear.z0, clear.x1 - gap, clear.z1),
        }[wall]
        if asking.at_walls or any(rule.type in ("against_wall", "in_row", "opposite") for rule in asking.ask.piece.rules):
            yield Way(extent, ROTATION_AT_WALL[wall], wall, band)
    if not asking.at_walls:
        for rotation in _turns(asking):
            yield Way(turned(width, depth, rotation), rotation, None, clear)


def _turns(asking: _Asking) -> tuple[int, ...]:
    """Returns the rotations that make a difference to a free piece."""
    use = asking.ask.scope.entry(asking.kind).use
    turns = any(rule.type in ("facing", "opposite", "around", "under", "in_row") for rule in asking.ask.piece.rules)
    if turns or (use and len(use.sides) < 4):
        return (0, 90, 180, 270)
    return (0,) if asking.size[0] == asking.size[1] else (0, 90)


def _kept(asking: _Asking, way: Way) -> list[tuple[Rect, float]]:
    """Returns rectangles for a stance with what it costs to stand there, cheapest first: each holds some of the room's relations."""
    found = [(way.reach, 0.0)] if within_both(way.reach, way.reach, way.extent) else []
    for rule in asking.to_room:
        regions = REGIONS[rule.type](asking.ask.scope, rule, way)
        held = [(both, cost) for rect, cost in found for region in regions if (both := within_both(rect, region, way.extent))]
        found = _best([*held, *((rect, cost + _missed(rule)) for rect, cost in found)])
    return found


def _best(found: Sequence[tuple[Rect, float]]) -> list[tuple[Rect, float]]:
    """Sorts by cost and drops what lies within a rectangle that costs no more."""
    best: list[tuple[Rect, float]] = []
    for rect, cost in sorted(found, key=lambda entry: (entry[1], -entry[0].area_m2)):
        if cost < math.inf and not any(other.contains(rect) for other, _ in best):
            best.append((rect, cost))
    return best[:12]


def _anchor(asking: _Asking, way: Way, rect: Rect) -> tuple[int, int]:
    """Returns where in its rectangle a piece would like to stand: in the middle of the longest clear stretch of its wall."""
    x, z = (rect.x0 + rect.x1) // 2, (rect.z0 + rect.z1) // 2
    if way.wall is None:
        return x, z
    along = 0 if way.wall in ("north", "south") else 1
    low, high = rect.along(way.wall)
    cut = [(max(a, low), min(b, high)) for a, b in asking.ask.scope.walls.stretches(way.wall, asking.size[1], asking.size[2])]
    a, b = max(cut, key=lambda stretch: stretch[1] - stretch[0], default=(low, high))
    middle = (a + b) // 2 if b > a else (low + high) // 2
    return (middle, z) if along == 0 else (x, middle)


def _exact_slots(asking: _Asking) -> Iterator[Alternative]:
    """Yields the vocabulary's own places at other pieces, each with what it misses."""
    for rule in asking.to_pieces:
        if rule.type not in SLOTTED:
            continue
        effect: Effect = RELATIONS[rule.type](asking.ask, rule)
        for slot in effect.slots:
            missed = sum(_missed_in(asking, other, slot) for other in asking.to_pieces if other is not rule)
            yield replace(slot, cost=slot.cost + missed + _unsure_of_room(asking, slot.rotation))


def _unsure_of_room(asking: _Asking, turn: int) -> float:
    """Returns what a place at another piece pays for relations to the room, which depend on where that piece stands."""
    return sum(rule.cost * UNSURE for rule in asking.to_room)


def _missed_in(asking: _Asking, rule: Rule, slot: Alternative) -> float:
    """Returns what a place at another piece pays for another rule: nothing where it surely holds there."""
    attach = slot.attach
    if attach is None or attach.parent not in asking.ask.labels(rule.of):
        return _unsure(rule)
    if rule.type == "on":
        return 0.0 if slot.on == attach.parent else _missed(rule)
    box = (attach.across_mm, attach.along_mm)
    fit = _fit(asking, rule, attach.parent_kind, slot.rotation)
    return 0.0 if any(shared(box, other) == box for other in BOXES[rule.type](fit)) else _missed(rule)


def _fit(asking: _Asking, rule: Rule, parent_kind: str, turn: int) -> Fit:
    parent = asking.ask.scope.size(parent_kind)
    return Fit(rule, (parent[0], parent[1]), turned(asking.size[0], asking.size[1], turn), turn)


def _loose_slots(asking: _Asking) -> Iterator[Alternative]:
    """Yields places that slide in another piece's frame, where several relations to that piece hold together."""
    if any(rule.type == "on" for rule in asking.to_pieces):
        return
    names = tuple(dict.fromkeys(name for rule in asking.to_pieces for name in rule.of))
    for label, parent_kind in asking.ask.parents(names):
        for turn in _turns(asking) if not asking.at_walls else (0,):
            yield from _in_frame(asking, label, parent_kind, turn)


def _in_frame(asking: _Asking, label: str, parent_kind: str, turn: int) -> Iterator[Alternative]:
    rules = [rule for rule in asking.to_pieces if label in asking.ask.labels(rule.of)]
    if asking.at_walls:
        rules = [rule for rule in rules if rule.type in ("beside", "in_row")]
        rules = [rule.model_copy(update={"align": "back"}) for rule in rules if rule.align in (None, "back")]
    if not rules:
        return
    others = sum(_unsure(rule) for rule in asking.to_pieces if label not in asking.ask.labels(rule.of))
    found: list[tuple[Box, float]] = [((ANYWHERE, ANYWHERE), 0.0)]
    for rule in rules:
        boxes = BOXES[rule.type](_fit(asking, rule, parent_kind, turn))
        held = [(both, cost) for box, cost in found for other in boxes if (both := shared(box, other))]
        found = sorted([*held, *((box, cost + _missed(rule)) for box, cost in found)], key=lambda entry: entry[1])[:8]
    clear = asking.ask.scope.space.clear
    far = max(clear.width, clear.depth)
    for box, cost in found[:EACH]:
        if box != (ANYWHERE, ANYWHERE) and cost < math.inf:
            across, along = (_clipped(interval, far) for interval in box)
            under = label if any(rule.type == "under" or (rule.gap and rule.gap[0] < 0) for rule in rules) else None
            attach = Attach(label, parent_kind, across, along)
            total = cost + others + _unsure_of_room(asking, turn) + LOOSE_COST
            yield Alternative(asking.kind, asking.size, turn, weights=(PULL, PULL), cost=total, attach=attach, under=under)


def _clipped(interval: tuple[int, int], far: int) -> tuple[int, int]:
    """Cuts an interval without an end off where the room ends, so that its middle means something."""
    low, high = interval
    if low <= ANYWHERE[0]:
        low = min(-far, high)
    if high >= ANYWHERE[1]:
        high = max(far, low)
    return low, high


def _links(asking: _Asking) -> Iterator[Link]:
    for rule in asking.to_pieces:
        label = next(iter(asking.ask.labels(rule.of)))
        if rule.wall is not None:
            yield Link(rule.type, label, walls=rule.wall, cost=rule.cost, required=rule.required)
        if rule.type == "opposite":
            yield Link("opposite", label, turn=180, walls="opposite", cost=rule.cost, required=rule.required, align=ALIGN_PULL)
        elif rule.type == "facing" and asking.at_walls:
            yield Link("facing", label, turn=180, cost=rule.cost * UNSURE, align=NEAR_PULL)
        elif rule.type in ("near", "in_row", "beside"):
            yield Link(rule.type, label, near=NEAR_PULL)
        elif rule.type == "aligned_with":
            yield Link("aligned_with", label, align=ALIGN_PULL)
        elif rule.type == "far_from":
            distance = 2.0 if rule.distance is None else rule.distance
            yield from (
                Link("far_from", other, apart_m=distance + 1.0, apart_cost=rule.cost / (distance + 1.0))
                for other in asking.ask.labels(rule.of)
            )
