"""Candidates that need no other piece: along the clear stretches of each wall, in corners, and free in the room."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from solver.geometry import ALONG_X, INWARDS, ROTATION_AT_WALL, turned
from solver.pieces import Candidate
from solver.relations.subject import Kind, Scope
from solver.scene import WALLS
from tests.furnish.reference.effects import Effect
from tests.furnish.reference.occupancy import TakenWalls
from tests.furnish.reference.subject import Subject

DRAW = 0.05
"""Pull towards an anchor that no rule asks to be firm, m^-2."""
INTENDED_COST = 0.3
"""What a place at a wall costs where an earlier piece is meant to stand: it may not be taken after all."""

Anchor = Callable[[tuple[int, int]], tuple[int, int]]
"""Extents along x and z -> the centre (x, z) wished for a footprint of them, mm."""


def own_candidates(subject: Subject, walls: TakenWalls, effects: Sequence[Effect]) -> list[Candidate]:
    """Returns the ways a piece may stand by itself, each with its variant's cost.

    Where no wall has a clear stretch for any variant, every wall is tried nevertheless: placement says why it is not there.
    """
    found = list(_standing(subject, walls, effects))
    return found or [
        at_wall(subject.scope, kind, wall, sum(subject.scope.clear.along(wall)) // 2, cost)
        for kind, cost in subject.variants
        for wall in WALLS
    ]


def _standing(subject: Subject, walls: TakenWalls, effects: Sequence[Effect]) -> Iterator[Candidate]:
    backs = any(effect.backs for effect in effects)
    for kind, cost in subject.variants:
        if kind.at_walls or backs:
            for wall in WALLS:
                for centre, more in _centres(walls, effects, wall, kind):
                    yield at_wall(subject.scope, kind, wall, centre, cost + more)
        if not kind.at_walls:
            for anchor in _anchors(subject.scope, effects, kind):
                for rotation in rotations(kind):
                    at = anchor(turned(*kind.size[:2], rotation))
                    yield Candidate(kind.name, kind.size, rotation, anchor_mm=at, weights=(DRAW, DRAW), cost=cost)


def at_wall(scope: Scope, kind: Kind, wall: str, centre_mm: int, cost: float) -> Candidate:
    """Returns the candidate with its back at a wall, its middle at a coordinate along it."""
    across = scope.clear.line(wall) + INWARDS[wall] * (scope.gap_mm + kind.size[1] // 2)
    anchor = (centre_mm, across) if wall in ALONG_X else (across, centre_mm)
    return Candidate(kind.name, kind.size, ROTATION_AT_WALL[wall], wall, anchor, (DRAW, DRAW), cost=cost)


def _centres(walls: TakenWalls, effects: Sequence[Effect], wall: str, kind: Kind) -> list[tuple[int, float]]:
    """Returns the centres to try along a wall, with what each costs: first clear of where earlier pieces are meant to stand."""
    width, depth, height = kind.size
    proposed = [p for effect in effects for on_wall, of_kind, p in effect.positions if (on_wall, of_kind) == (wall, kind.name)]
    for occupied, cost in ((True, 0.0), (False, INTENDED_COST)):
        stretches = walls.stretches(wall, depth, height, occupied)
        found = [centre for stretch in stretches for centre in _in_stretch(walls, wall, stretch, width, proposed)]
        if found:
            return [(centre, cost) for centre in dict.fromkeys(found)]
    return []


def _in_stretch(walls: TakenWalls, wall: str, stretch: tuple[int, int], width: int, proposed: Sequence[int]) -> list[int]:
    """Returns the centres to try in one clear stretch: what the relations propose, its ends and its middle."""
    a, b = stretch
    clear, gap, half = walls.space.clear.along(wall), walls.space.gap_mm, width // 2
    spare = b - a - width
    if spare < 0:
        return []
    low = a + half + (min(gap, spare) if a == clear[0] else 0)
    high = b - half - (min(gap, spare) if b == clear[1] else 0)
    return [*(min(max(p, a + half), b - half) for p in proposed), low, high, (a + b) // 2]


def _anchors(scope: Scope, effects: Sequence[Effect], kind: Kind) -> list[Anchor]:
    """Returns the free anchors to try: what the relations propose, else the room's middle and the middles of its quarters."""
    found = [_point(at) for effect in effects for of_kind, at in effect.spots if of_kind == kind.name]
    if any(effect.corners for effect in effects):
        found += [_corner(scope, east, south) for south in (False, True) for east in (False, True)]
    clear = scope.clear
    quarters = [(clear.x0 + clear.width * x // 4, clear.z0 + clear.depth * z // 4) for z in (1, 3) for x in (1, 3)]
    return found or [_point(at) for at in (clear.centre, *quarters)]


def _point(at: tuple[int, int]) -> Anchor:
    return lambda _: at


def _corner(scope: Scope, east: bool, south: bool) -> Anchor:
    """Returns the anchor in a corner, the usual gap from both its walls."""
    clear, gap = scope.clear, scope.gap_mm
    return lambda extent: (
        clear.x1 - gap - extent[0] // 2 if east else clear.x0 + gap + extent[0] // 2,
        clear.z1 - gap - extent[1] // 2 if south else clear.z0 + gap + extent[1] // 2,
    )


def rotations(kind: Kind) -> tuple[int, ...]:
    """Returns the rotations that differ: four for what has a front, two for what is only longer one way, else one."""
    if 0 < len(kind.use_sides) < 4:
        return (0, 90, 180, 270)
    return (0,) if kind.size[0] == kind.size[1] else (0, 90)
