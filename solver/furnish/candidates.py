"""Ways to stand that need no other piece: along the clear stretches of each wall, in corners, and free in the room."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from catalogs.schema import Furniture
from solver.furnish.ask import Ask, Effect, Size
from solver.geometry import ROTATION_AT_WALL, turned
from solver.scene import WALLS
from solver.wanted import Alternative

DRAW = 0.05
"""Pull towards an anchor that no rule asks to be firm, m^-2."""

INTENDED_COST = 0.3
"""What a place at a wall costs where an earlier piece is meant to stand: it may not be taken after all."""


def candidates(ask: Ask, effects: Sequence[Effect]) -> list[Alternative]:
    """Returns the ways a piece may stand by itself, each with its variant's cost.

    Where no wall has a clear stretch for any variant, every wall is tried nevertheless: placement says why it is not there.
    """
    found = list(_standing(ask, effects))
    return found or [
        at_wall(ask, variant.kind, wall, sum(ask.scope.space.clear.along(wall)) // 2, variant.cost)
        for variant in ask.piece.variants
        for wall in WALLS
    ]


def _standing(ask: Ask, effects: Sequence[Effect]) -> Iterator[Alternative]:
    backs = any(effect.backs for effect in effects)
    for variant in ask.piece.variants:
        entry, size = ask.scope.entry(variant.kind), ask.scope.size(variant.kind)
        if entry.stands == "wall" or backs:
            for wall in WALLS:
                for centre, cost in _centres(ask, effects, wall, variant.kind):
                    yield at_wall(ask, variant.kind, wall, centre, variant.cost + cost)
        if entry.stands == "free":
            for spot in _spots(ask, effects, variant.kind):
                for rotation in _rotations(entry, size):
                    yield Alternative(
                        variant.kind, size, rotation, anchor_mm=spot(turned(size[0], size[1], rotation)),
                        weights=(DRAW, DRAW), cost=variant.cost,
                    )  # fmt: skip


def at_wall(ask: Ask, kind: str, wall: str, centre_mm: int, cost: float) -> Alternative:
    """Returns the alternative with its back at a wall, its middle at a coordinate along it."""
    size, clear, gap = ask.scope.size(kind), ask.scope.space.clear, ask.scope.space.gap_mm
    across = gap + size[1] // 2
    anchor = {
        "north": (centre_mm, clear.z0 + across),
        "south": (centre_mm, clear.z1 - across),
        "west": (clear.x0 + across, centre_mm),
        "east": (clear.x1 - across, centre_mm),
    }[wall]
    return Alternative(kind, size, ROTATION_AT_WALL[wall], wall, anchor, (DRAW, DRAW), cost=cost)


def _centres(ask: Ask, effects: Sequence[Effect], wall: str, kind: str) -> list[tuple[int, float]]:
    """Returns the centres to try along a wall, with what each costs: first clear of where earlier pieces are meant to stand."""
    size = ask.scope.size(kind)
    proposed = [p for effect in effects for on_wall, of_kind, p in effect.positions if (on_wall, of_kind) == (wall, kind)]
    for occupied, cost in ((True, 0.0), (False, INTENDED_COST)):
        stretches = ask.scope.walls.stretches(wall, size[1], size[2], occupied)
        found = [centre for stretch in stretches for centre in _in_stretch(ask, wall, stretch, size[0], proposed)]
        if found:
            return [(centre, cost) for centre in dict.fromkeys(found)]
    return []


def _in_stretch(ask: Ask, wall: str, stretch: tuple[int, int], width: int, proposed: Sequence[int]) -> list[int]:
    """Returns the centres to try in one clear stretch: what the rules propose, its ends and its middle."""
    a, b = stretch
    clear, gap, half = ask.scope.space.clear.along(wall), ask.scope.space.gap_mm, width // 2
    spare = b - a - width
    if spare < 0:
        return []
    low = a + half + (min(gap, spare) if a == clear[0] else 0)
    high = b - half - (min(gap, spare) if b == clear[1] else 0)
    return [*(min(max(p, a + half), b - half) for p in proposed), low, high, (a + b) // 2]


class _Spot:
    """An anchor that depends on the footprint's extents: a corner, or a fixed point."""

    def __init__(self, ask: Ask, corner: tuple[int, int] | None, point: tuple[int, int] = (0, 0)) -> None:
        self._clear, self._gap = ask.scope.space.clear, ask.scope.space.gap_mm
        self._corner, self._point = corner, point

    def __call__(self, extent: tuple[int, int]) -> tuple[int, int]:
        """Returns the anchor, mm."""
        if self._corner is None:
            return self._point
        low, high = (self._clear.x0, self._clear.z0), (self._clear.x1, self._clear.z1)
        x, z = (
            high[axis] - self._gap - extent[axis] // 2 if self._corner[axis] else low[axis] + self._gap + extent[axis] // 2
            for axis in (0, 1)
        )
        return x, z


def _spots(ask: Ask, effects: Sequence[Effect], kind: str) -> list[_Spot]:
    """Returns the free anchors to try: what the rules propose, else the room's middle and the middles of its quarters."""
    spots = [_Spot(ask, None, point) for effect in effects for of_kind, point in effect.spots if of_kind == kind]
    if any(effect.corners for effect in effects):
        spots += [_Spot(ask, (x, z)) for z in (0, 1) for x in (0, 1)]
    if spots:
        return spots
    clear = ask.scope.space.clear
    at = [(clear.x0 + clear.width * x // 4, clear.z0 + clear.depth * z // 4) for z in (1, 3) for x in (1, 3)]
    middle = ((clear.x0 + clear.x1) // 2, (clear.z0 + clear.z1) // 2)
    return [_Spot(ask, None, point) for point in (middle, *at)]


def _rotations(entry: Furniture, size: Size) -> tuple[int, ...]:
    """Returns the rotations that differ: four for what has a front, two for what is only longer one way, else one."""
    if entry.use and len(entry.use.sides) < 4:
        return (0, 90, 180, 270)
    return (0,) if size[0] == size[1] else (0, 90)
