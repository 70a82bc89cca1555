"""What a room wants, in Python: as the core's furnish stage, which it judges, but written for reading and sharing no code with it.

Comes in and goes out: as `solver.furnish.wanted_pieces`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

from catalogs.schema import Catalogs, PieceSpec, RelationSpec, RoomType
from solver.furnish import scope_of
from solver.furnish.compiled_types import floors_about
from solver.geometry import Rect, rotate, strip, to_mm, turned, wall_faced
from solver.pieces import Candidate, Piece, Space, Stand
from solver.relations.subject import Kind, Scope
from solver.scene import Room
from solver.streams import Stream
from tests.furnish.reference.comfort import with_comfort
from tests.furnish.reference.drawn import CountedPiece, Preferences, count, drawn_preferences, ordered
from tests.furnish.reference.effects import Effect, behind_gate, effect_of, kept_in
from tests.furnish.reference.occupancy import TakenWalls, off_boards, opened_off_boards
from tests.furnish.reference.openings import opened
from tests.furnish.reference.own_places import DRAW, own_candidates
from tests.furnish.reference.run_plans import OFF_PLAN_COST, planned_run
from tests.furnish.reference.slots import SIDES, faces
from tests.furnish.reference.subject import Parent, Subject, wished_footprint

GIVE_PLACE = (*SIDES, "on")

TOUCH_MM = 20
"""Overlaps up to this between meant places do not matter."""
LIMIT = 40
"""Most candidates a piece gets: placement's time is linear in them."""
TAKEN_COST = 1.5
"""What it costs a free piece to be wished where an earlier piece is meant to stand: small things do not herd."""
WALL_COST, AHEAD_MM = 1.5, 1000
"""What it costs an armchair to look at a wall nearer than this."""
GATE_MM = 1000
"""Depth of the floor before a garage door where only cars are wished."""

Effects = Sequence[tuple[RelationSpec, Effect]]


class _Meant(NamedTuple):
    """Where a piece is meant to stand: its kind, centre (x, z), mm, and rotation."""

    kind: str
    centre: tuple[int, int]
    rotation: int


def wanted_pieces(room: Room, space: Space, catalogs: Catalogs, stream: Stream) -> tuple[Piece, ...]:
    """Returns what a room wants, required pieces first, each with its candidates.

    Args:
        room: with its type and openings; a type the catalogs do not know wants nothing.
        space: the room's `space_of`.
        catalogs: what there is, and the rules.
        stream: the room's own; it draws optional pieces and which of equal walls is preferred.
    """
    room_type = catalogs.rooms.get(room.type)
    if room_type is None:
        return ()
    scope = scope_of(room, space)
    gates = tuple(strip(space.clear, one.wall, one.interval, GATE_MM) for one in opened(scope, "garage_door"))
    opens = partial(_opened_within, scope, space, catalogs)
    furnisher = _Furnisher(scope, TakenWalls(space, gates, opens), catalogs)
    if not any(opening.main_entrance for opening in room.openings):
        room_type = room_type.model_copy(update={"pieces": tuple(spec for spec in room_type.pieces if not spec.entered)})
    counted = _counted(room_type, catalogs, room.floor_m2, stream)
    there = {one.spec.piece: one for one in counted if one.copies}
    run = planned_run(scope, furnisher.walls, room_type.run, there, stream) if room_type.run else {}
    orders = room_type.run.orders if room_type.run else ()
    in_run = {name for order in orders for name in order} if run else set()
    for one in counted:
        if one.spec.piece in in_run and one.spec.piece not in run and not one.spec.required:
            continue
        for number in range(1, one.copies + 1):
            if not furnisher.add(one, number, drawn_preferences(stream), run.get(one.spec.piece)):
                break
    worktop = room_type.run.worktop if room_type.run else ()
    wanted = with_comfort(furnisher.pieces, catalogs, {name for order in orders for name in order}, worktop)
    return tuple(opened_off_boards(piece, opens) for piece in wanted)


def _opened_within(scope: Scope, space: Space, catalogs: Catalogs, kind: str) -> Rect | None:
    """Returns where the fronts of a kind open; None for one without doors that go along a side of it."""
    spec = catalogs.furniture.get(kind)
    opens = spec and any(one.along_side for one in floors_about(spec, catalogs.shapes.get(kind, ())))
    return off_boards(scope, space, to_mm(spec.size[2])) if spec and opens else None


def _counted(room_type: RoomType, catalogs: Catalogs, area: float, stream: Stream) -> list[CountedPiece]:
    """Returns the pieces of a room of some area, m2, in order, with the kinds that suit it and how many of each are wanted."""
    specs = ordered([_in_area(spec, area) for spec in room_type.pieces if not spec.without], stream)
    found = []
    for spec in specs:
        anywhere = [variant for variant in spec.variants if not variant.corner]
        suited = [one for one in anywhere if one.min_area <= area and (one.max_area is None or area < one.max_area)] or anywhere
        variants = tuple((Kind.of(one.kind, catalogs), one.cost) for one in suited)
        corners = tuple((one.corner, Kind.of(one.kind, catalogs), one.cost) for one in spec.variants if one.corner)
        found.append(CountedPiece(spec, variants, count(spec, area, stream), corners))
    return found


def _in_area(spec: PieceSpec, area: float) -> PieceSpec:
    """Returns a piece as it is in a room of some area, m2: what is required from an area on is optional below it."""
    return spec.model_copy(update={"required": area >= spec.min_area, "min_area": 0.0}) if spec.required else spec


class _Furnisher:
    """The pieces of one room, each made when those before it are known.

    Args:
        scope: the room as relations see it.
        walls: its walls; where pieces are meant to stand is marked there.
        catalogs: of the kinds of pieces.
    """

    def __init__(self, scope: Scope, walls: TakenWalls, catalogs: Catalogs) -> None:
        self.scope, self.walls, self._catalogs = scope, walls, catalogs
        self.pieces: list[Piece] = []
        self._labels: dict[str, tuple[str, ...]] = {}
        self._standing: dict[str, tuple[Parent, ...]] = {}
        self._meant: dict[str, _Meant] = {}

    def add(self, counted: CountedPiece, number: int, preferences: Preferences, planned: Candidate | None) -> bool:
        """Adds a copy of a piece; False where a relation it cannot do without has nothing to hold on to."""
        spec = counted.spec
        subject = Subject(self.scope, counted.variants, spec.rules, dict(self._labels), dict(self._standing))
        effects = [(rule, effect_of(subject, rule)) for rule in spec.rules]
        candidates = [replace(slot, within=behind_gate(subject, slot)) for slot in _slots(effects, subject, preferences)]
        if not any(rule.required and rule.type in GIVE_PLACE for rule in spec.rules):
            candidates += self._alone(subject, effects, preferences)
        if not candidates:
            return False
        candidates.sort(key=lambda candidate: round(candidate.cost, 9))
        if planned is not None and number == 1:
            candidates = [planned, *(replace(other, cost=other.cost + OFF_PLAN_COST) for other in candidates[: LIMIT - 1])]
        piece = _piece(spec, number, subject.kind, candidates[:LIMIT], effects)
        self.pieces.append(piece)
        self._labels[spec.piece] = (*self._labels.get(spec.piece, ()), piece.label)
        names = dict.fromkeys(candidate.kind for candidate in piece.candidates)
        self._standing[piece.label] = tuple(Parent(piece.label, Kind.of(name, self._catalogs)) for name in names)
        self._intend(piece)
        return True

    def _alone(self, subject: Subject, effects: Effects, preferences: Preferences) -> list[Candidate]:
        """Returns the ways to stand at walls and in the room, costed by every relation, the best few of each sort."""
        missed = sum(rule.cost for rule, effect in effects if effect.slots)
        pull = max(DRAW, *(effect.weight for _, effect in effects)) if effects else DRAW
        found: list[Candidate] = []
        for candidate in own_candidates(subject, self.walls, [effect for _, effect in effects]):
            cost = candidate.cost + missed + preferences.cost(candidate, subject)
            if candidate.wall is None:
                cost += self._in_the_way(subject, wished_footprint(candidate)) + _facing_wall(subject, candidate)
            cost += sum(effect.cost_of(candidate) for _, effect in effects if effect.cost_of)
            if cost < math.inf:
                found.append(replace(candidate, cost=round(cost, 6), weights=(pull, pull), within=kept_in(subject, candidate)))
        return _best_of_each(subject, found)

    def _in_the_way(self, subject: Subject, rect: Rect) -> float:
        """Returns what a free place costs where another piece is meant to stand or a garage door opens."""
        before_gate = any(rect.overlaps(gate) for gate in self.walls.gates) and not faces(subject, ("garage_door",))
        return TAKEN_COST * (before_gate + self.walls.occupied(rect))

    def _intend(self, piece: Piece) -> None:
        """Marks where a piece would like best to stand, so that later pieces are first wished elsewhere."""
        for candidate in piece.candidates:
            meant = _meant(candidate, self._meant)
            if meant is not None:
                rect = Rect.around(meant.centre, turned(*candidate.size_mm[:2], meant.rotation))
                if candidate.attach is None or not self.walls.occupied(rect.shrunk(TOUCH_MM)):
                    self._meant[piece.label] = meant
                    if not (candidate.on or candidate.under):
                        self.walls.occupy(rect)
                    return


def _piece(spec: PieceSpec, number: int, kind: Kind, candidates: Sequence[Candidate], effects: Effects) -> Piece:
    return Piece(
        f"{spec.piece}_{number}",
        spec.required,
        tuple(candidates),
        links=tuple(link for _, effect in effects for link in effect.links),
        stands=tuple(Stand(side) for side in spec.approach) or kind.stands,
        need_all=bool(spec.approach) or kind.need_all,
        skip_cost=math.inf if spec.required else spec.skip_cost,
        with_next=spec.with_next,
    )


def _slots(effects: Effects, subject: Subject, preferences: Preferences) -> list[Candidate]:
    """Returns the slots; one that meets a relation pays for the other relations with slots that it misses."""
    must = [i for i, (rule, _) in enumerate(effects) if rule.required and rule.type in GIVE_PLACE]
    found: list[Candidate] = []
    for i, (_, effect) in enumerate(effects):
        if not must or i in must:
            missed = sum(other.cost for j, (other, theirs) in enumerate(effects) if j != i and theirs.slots)
            found += (replace(slot, cost=round(round(slot.cost + missed, 6) + preferences.cost(slot, subject), 6)) for slot in effect.slots)
    return found


def _facing_wall(subject: Subject, candidate: Candidate) -> float:
    """Returns what it costs a piece used from its front only to stand so near to a wall that it looks at nothing else."""
    if _kind(subject, candidate).use_sides != ("front",):
        return 0.0
    ahead = wished_footprint(candidate).wall_distance(wall_faced("front", candidate.rotation), subject.scope.clear)
    return WALL_COST if ahead < AHEAD_MM else 0.0


def _kind(subject: Subject, candidate: Candidate) -> Kind:
    return next(kind for kind, _ in subject.variants if kind.name == candidate.kind)


def _best_of_each(subject: Subject, found: Sequence[Candidate]) -> list[Candidate]:
    """Keeps, for every variant, wall and way round, the cheapest anchors: a few for the wanted variant, one for the others."""
    corners = any(rule.type == "in_corner" for rule in subject.relations)
    kept: dict[tuple[str, str | None, int], list[Candidate]] = {}
    for candidate in sorted(found, key=lambda one: one.cost):
        # Used from two opposite sides alike, turning it round changes only its looks.
        alike = set(_kind(subject, candidate).use_sides) in ({"left", "right"}, {"front", "back"})
        group = kept.setdefault((candidate.kind, candidate.wall, candidate.rotation % (180 if alike else 360)), [])
        few = 4 if corners and candidate.wall is None else 2
        room = few if candidate.kind == subject.kind.name else few // 2
        if len(group) < room and all(candidate.anchor_mm != other.anchor_mm for other in group):
            group.append(candidate)
    return [candidate for group in kept.values() for candidate in group]


def _meant(candidate: Candidate, others: Mapping[str, _Meant]) -> _Meant | None:
    """Returns where a candidate would be if the pieces before it stood where they are meant to; None if it is void then."""
    attach = candidate.attach
    if attach is None:
        return _Meant(candidate.kind, candidate.anchor_mm, candidate.rotation)
    parent = others.get(attach.parent)
    if parent is None or parent.kind != attach.parent_kind:
        return None
    dx, dz = rotate(sum(attach.across_mm) // 2, sum(attach.along_mm) // 2, parent.rotation)
    return _Meant(candidate.kind, (parent.centre[0] + dx, parent.centre[1] + dz), (parent.rotation + candidate.rotation) % 360)
