"""A layout round a floor kept empty: every piece that is used touches the floor with a use side, so that all are within reach.

Comes in: a space and pieces that no placement with least movement makes usable. Goes out: where they can be used. Not here: least
movement, and any proof.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from solver.geometry import Rect, rotate, strip, turned
from solver.placement.budget import Budget
from solver.placement.core import Core, Limits
from solver.placement.encode import FREE_CENTRES_MM2, encode
from solver.placement.kernel.assembly import PERSON_MM
from solver.placement.usable import Found
from solver.wanted import EMPTY_FLOOR, Alternative, Attach, Space, Wanted

OUTWARDS = {"front": (0, 1), "back": (0, -1), "left": (-1, 0), "right": (1, 0)}
FLOOR = "floor"
PULL = (0.02, 0.02)
SHARES = (0.5, 0.75, 1.0)
"""Lengths of floor, in shares of the room's."""
SEARCH = Limits(required=300, required_qps=300)
"""What one shape of floor may try."""


def around_a_floor(space: Space, pieces: Sequence[Wanted], budget: Budget) -> Iterator[tuple[Found, ...]]:
    """Looks for places round an empty rectangle, of several shapes.

    Args:
        space: the room's.
        pieces: all of them are asked for.
        budget: the work it may cost.

    Yields:
        Where the pieces are, in their order, by the shapes that help. Whether a person comes there is not tested.
    """
    for shape in _shapes(space):
        found = _around(space, pieces, shape, budget)
        if found:
            yield found
        if budget.spent:
            return


def _shapes(space: Space) -> Iterator[tuple[int, int]]:
    """Returns rectangles that hold the least free centres, from square to as long as the room."""
    robot, clear = space.robot_mm, space.clear
    square = math.isqrt(FREE_CENTRES_MM2) + 10
    yield robot + square, robot + square
    for share in SHARES:
        deep, wide = int(clear.depth * share) - robot, int(clear.width * share) - robot
        if deep > square:
            yield robot + FREE_CENTRES_MM2 // deep + 10, robot + deep
        if wide > square:
            yield robot + wide, robot + FREE_CENTRES_MM2 // wide + 10


def _around(space: Space, pieces: Sequence[Wanted], shape: tuple[int, int], budget: Budget) -> tuple[Found, ...]:
    """Looks for places round one shape of floor."""
    clear = space.clear
    middle = ((clear.x0 + clear.x1) // 2, (clear.z0 + clear.z1) // 2)
    floor = Wanted(EMPTY_FLOOR, True, (Alternative(FLOOR, (*shape, PERSON_MM), 0, None, middle, PULL),))
    ties = [_ties(space, piece, shape) for piece in pieces]
    tied = [_tied(piece, own) for piece, own in zip(pieces, ties, strict=True)]
    core = Core(encode(space, (floor, *tied), "stands"))
    decisions, _ = core.stand_together(SEARCH, budget, False)
    if decisions is None or not core.evaluate(decisions, SEARCH.required_qps, budget, False):
        return ()
    rects = core.bodies()
    found = []
    for k, (piece, own) in enumerate(zip(pieces, ties, strict=True), start=1):
        way, sides = core.decided(k, int(decisions[k]))
        tie = next((tie for tie in own if tie[0] is way), (way, way, sides))
        found.append(Found(piece, tie[1], tie[2], rects[k]))
    return tuple(found)


Tie = tuple[Alternative, Alternative, tuple[str, ...]]
"""A way tied to the floor by a use side, the way it is without that, and the side."""


def _tied(piece: Wanted, ties: Sequence[Tie]) -> Wanted:
    return replace(piece, alternatives=tuple(tie[0] for tie in ties), stands=(), need_all=False) if ties else piece


def _ties(space: Space, piece: Wanted, shape: tuple[int, int]) -> list[Tie]:
    """Returns the ways of a piece to touch the floor with a use side; none where it needs several sides or stays where it is."""
    if not piece.stands or (piece.need_all and len(piece.stands) > 1) or any(_fixed(way) for way in piece.alternatives):
        return []
    return [
        (_tie(space, way, stand.side, shape), way, (stand.side,)) for way in piece.alternatives for stand in piece.stands if not way.attach
    ]


def _fixed(way: Alternative) -> bool:
    extents = turned(way.size_mm[0], way.size_mm[1], way.rotation)
    return way.within is not None and (way.within.width, way.within.depth) == extents


def _tie(space: Space, way: Alternative, side: str, shape: tuple[int, int]) -> Alternative:
    """Returns a way with one of its sides at an edge of the floor, so that a person on the floor can stand before it."""
    extents = turned(way.size_mm[0], way.size_mm[1], way.rotation)
    outwards = rotate(*OUTWARDS[side], way.rotation)
    reach = []
    for axis in (0, 1):
        floor, own, half = shape[axis], extents[axis], space.robot_mm // 2
        shift = (floor - own) // 2  # from the floor's low end to the piece's where their centres meet, as the kernel rounds it
        low, high = (half - own, floor - half) if not outwards[axis] else ((floor, floor) if outwards[axis] < 0 else (-own, -own))
        reach.append((low - shift, high - shift))
    within = way.within if way.wall is None else _at_wall(space, way, extents)
    attach = Attach(EMPTY_FLOOR, FLOOR, reach[0], reach[1])
    return replace(way, wall=None, slack_mm=None, within=within, weights=PULL, attach=attach)


def _at_wall(space: Space, way: Alternative, extents: tuple[int, int]) -> Rect:
    """Returns where a way's footprint may be at its wall."""
    wall = way.wall or ""
    across = extents[1] if wall in ("north", "south") else extents[0]
    far = space.gap_mm if way.slack_mm is None else way.slack_mm
    return strip(space.clear, wall, space.clear.along(wall), across + far)
