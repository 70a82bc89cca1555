"""Floor kept empty: as a piece of its own, and a layout round it, in which every use side touches it, so that all is within reach.

Not here: least movement, and any proof.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from solver.geometry import ALONG_X, LEAST_FLOOR_MM2, Rect, outwards, strip
from solver.pieces import Attach, Candidate, Piece, Space
from solver.placement.budget import Budget
from solver.placement.core import Core, Limits
from solver.placement.encode import encode
from solver.placement.layout import PERSON_MM
from solver.placement.walkable import WalkablePlace

SHAPES_MM = ((1110, 1110), (900, 1450), (1450, 900), (760, 2200), (2200, 760))
"""Rectangles of floor in which a person of 0.6 m has the 0.25 m2 of free centres that a room must have."""
FLOOR = "(floor)"
"""Label and kind of a piece that stands for floor to be kept empty."""
PULL = (0.02, 0.02)
SHARES = (0.5, 0.75, 1.0)
"""Lengths of floor that a layout lies round, in shares of the room's."""
SEARCH = Limits(required=300, required_qps=300)
"""What one shape of floor may try."""

Tie = tuple[Candidate, Candidate, tuple[str, ...]]
"""A candidate tied to the floor by a use side, the same without that, and the side."""


def empty_floor(space: Space) -> Piece:
    """Returns a piece that stands for floor kept empty, in one of several shapes: bodies keep out, people do not."""
    more = space.robot_mm - 600
    return _floor(space, [(width + more, depth + more) for width, depth in SHAPES_MM])


def _floor(space: Space, shapes: Sequence[tuple[int, int]]) -> Piece:
    candidates = tuple(Candidate(FLOOR, (*shape, PERSON_MM), 0, None, space.clear.centre, PULL) for shape in shapes)
    return Piece(FLOOR, True, candidates, is_floor=True)


def places_round_a_floor(space: Space, pieces: Sequence[Piece], budget: Budget) -> Iterator[tuple[WalkablePlace, ...]]:
    """Yields where all pieces are, in their order, round an empty rectangle, by those of several shapes that help.

    Whether a person comes there is not tested.
    """
    for shape in _shapes(space):
        found = _places_round(space, pieces, shape, budget)
        if found:
            yield found
        if budget.spent:
            return


def _shapes(space: Space) -> Iterator[tuple[int, int]]:
    """Returns rectangles that hold the least free centres, from square to as long as the room."""
    robot, clear = space.robot_mm, space.clear
    square = math.isqrt(LEAST_FLOOR_MM2) + 10
    yield robot + square, robot + square
    for share in SHARES:
        deep, wide = int(clear.depth * share) - robot, int(clear.width * share) - robot
        if deep > square:
            yield robot + LEAST_FLOOR_MM2 // deep + 10, robot + deep
        if wide > square:
            yield robot + wide, robot + LEAST_FLOOR_MM2 // wide + 10


def _places_round(space: Space, pieces: Sequence[Piece], shape: tuple[int, int], budget: Budget) -> tuple[WalkablePlace, ...]:
    """Looks for places round one shape of floor."""
    ties = [_ties(space, piece, shape) for piece in pieces]
    tied = [
        replace(piece, candidates=tuple(tie[0] for tie in own), stands=(), need_all=False) if own else piece
        for piece, own in zip(pieces, ties, strict=True)
    ]
    core = Core(encode(space, (_floor(space, [shape]), *tied), "stands"))
    decisions, _ = core.stand_together(SEARCH, budget, False)
    if decisions is None or not core.evaluate(decisions, SEARCH.required_qps, budget, False):
        return ()
    rects = core.bodies()
    found = []
    for k, (piece, own) in enumerate(zip(pieces, ties, strict=True), start=1):
        candidate = core.decided(int(decisions[k]))
        tie = next((tie for tie in own if tie[0] is candidate), (candidate, candidate, core.sides_of(k, int(decisions[k]))))
        found.append(WalkablePlace(piece, tie[1], tie[2], rects[k]))
    return tuple(found)


def _ties(space: Space, piece: Piece, shape: tuple[int, int]) -> list[Tie]:
    """Returns how a piece may touch the floor with a use side; nothing where it needs several sides or stays where it is."""
    fixed = any(one.stays for one in piece.candidates)
    if (piece.need_all and len(piece.stands) > 1) or fixed:
        return []
    free = [one for one in piece.candidates if not one.attach]
    return [(_tied(space, one, stand.side, shape), one, (stand.side,)) for one in free for stand in piece.stands]


def _tied(space: Space, candidate: Candidate, side: str, shape: tuple[int, int]) -> Candidate:
    """Returns a candidate with one of its sides at an edge of the floor, so that a person on the floor can stand before it."""
    extents, direction = candidate.extent, outwards(side, candidate.rotation)
    reach = []
    for axis in (0, 1):
        floor, own, half = shape[axis], extents[axis], (space.robot_mm + 1) // 2
        shift = (floor - own) // 2  # from the floor's low end to the piece's where their centres meet, as the kernel rounds it
        low, high = (half - own, floor - half) if not direction[axis] else ((floor, floor) if direction[axis] < 0 else (-own, -own))
        reach.append((low - shift, high - shift))
    within = candidate.within if candidate.wall is None else _at_wall(space, candidate, candidate.wall)
    attach = Attach(FLOOR, FLOOR, reach[0], reach[1])
    return replace(candidate, wall=None, slack_mm=None, within=within, weights=PULL, attach=attach)


def _at_wall(space: Space, candidate: Candidate, wall: str) -> Rect:
    """Returns where a candidate's footprint may be at its wall."""
    across = candidate.extent[1 if wall in ALONG_X else 0]
    far = space.gap_mm if candidate.slack_mm is None else candidate.slack_mm
    return strip(space.clear, wall, space.clear.along(wall), across + far)
