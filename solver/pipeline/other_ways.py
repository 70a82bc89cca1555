"""The other ways a piece could stand in its room, and what each would have cost: the room is furnished once more with only that way left.

Not here: what holds the piece where it stands (explain).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf

from solver.explained import MovedPiece, OtherWay
from solver.geometry import to_m
from solver.pieces import Candidate, Piece, Placed, Space
from solver.placement import SolvedRoom, arrange, finish, is_call_spent

MOST_WAYS = 8
"""At most so many other ways are tried: the ones that the piece itself likes best."""
FAR_MM = 20
"""A piece that would stand farther away than this is named."""
FACING = {0: "south", 90: "east", 180: "north", 270: "west"}
"""Where a front looks, by rotation."""

_Stance = tuple[str | None, int]


@dataclass(frozen=True)
class AsFurnished:
    """A room as it was furnished: what was wanted, what came of it, and the ids of its pieces by their labels."""

    space: Space
    wanted: Sequence[Piece]
    solved: SolvedRoom
    ids: Mapping[str, str]


def other_ways(room: AsFurnished, label: str) -> tuple[OtherWay, ...]:
    """Returns the other walls and rotations that a piece may take, each with what the room would have cost with it, cheapest first.

    A piece that has its place at another one has no other ways; nor are ways tried once a call's work is spent.
    """
    piece = next(piece for piece in room.wanted if piece.label == label)
    now = next(chosen.candidate for chosen in room.solved.chosen if chosen.piece.label == label)
    if now.attach is not None:
        return ()
    (made,) = finish([room.solved], tidy=True)
    before = {placed.label: placed for placed in made.placed}
    liked: dict[_Stance, float] = {}
    for candidate in piece.candidates:
        if candidate.attach is None and _stance(candidate) != _stance(now):
            liked[_stance(candidate)] = min(candidate.cost, liked.get(_stance(candidate), candidate.cost))
    found = []
    for stance in sorted(liked, key=lambda one: (liked[one], str(one)))[:MOST_WAYS]:
        if is_call_spent():
            break
        found.append(_tried(room, piece, stance, before))
    return tuple(sorted(found, key=lambda way: (way.cost is None, way.cost or 0.0)))


def _stance(candidate: Candidate) -> _Stance:
    return candidate.wall, candidate.rotation


def _tried(room: AsFurnished, piece: Piece, stance: _Stance, before: Mapping[str, Placed]) -> OtherWay:
    """Furnishes the room with a piece that may stand in one way only."""
    only = replace(piece, candidates=tuple(one for one in piece.candidates if one.attach is None and _stance(one) == stance))
    solved = arrange(room.space, [only if one.label == piece.label else one for one in room.wanted], wide=True)
    (made,) = finish([solved], tidy=True)
    placed = {one.label: one for one in made.placed}
    words = _words(stance)
    if piece.label not in placed:
        return OtherWay(stance[0], stance[1], None, (), (), f"{words}: no place was found for it so")
    gone = tuple(room.ids[label] for label in before if label not in placed)
    moves = tuple(_moved(room.ids, one) for label, one in placed.items() if label in before and _distance(before[label], one) > 0)
    far = [label for label, one in placed.items() if label in before and _distance(before[label], one) > FAR_MM]
    others = [room.ids[label] for label in far if label != piece.label]
    cost = round(solved.cost - room.solved.cost, 2)
    return OtherWay(stance[0], stance[1], cost, moves, gone, f"{words}: {_said(cost, gone)}{_consequences(others, gone)}")


def _words(stance: _Stance) -> str:
    wall, rotation = stance
    facing = FACING.get(rotation, f"{rotation} degrees")
    return f"with its back at the {wall} wall" if wall else f"away from the walls, its front to the {facing}"


def _said(cost: float, gone: Sequence[str]) -> str:
    """Returns what a way costs in words. Pieces are decided one after another: what is cheapest for the first need not be in all."""
    if cost >= 0:
        return f"{cost:.2f} more"
    return f"{-cost:.2f} less" if gone else f"{-cost:.2f} less in all, though not for what is decided first"


def _consequences(others: Sequence[str], gone: Sequence[str]) -> str:
    moved = f"; {_several(others)} would stand elsewhere" if others else ""
    return moved + (f"; {_several(gone)} would be left out" if gone else "")


def _several(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _moved(ids: Mapping[str, str], placed: Placed) -> MovedPiece:
    rect, way = placed.footprint, placed.chosen
    x, z = round(to_m(rect.x0 + rect.x1) / 2, 4), round(to_m(rect.z0 + rect.z1) / 2, 4)
    on = None if way.on is None else ids[way.on]
    width, depth, height = map(to_m, way.size_mm)
    return MovedPiece(ids[placed.label], way.kind, x, to_m(way.bottom_mm), z, placed.rotation, width, depth, height, on)


def _distance(a: Placed, b: Placed) -> float:
    """How far a piece would be moved, mm; without end where it is turned, of another size or on another piece."""
    one, other = a.footprint, b.footprint
    if (a.rotation, a.chosen.size_mm, a.chosen.on) != (b.rotation, b.chosen.size_mm, b.chosen.on):
        return inf
    return max(abs(one.x0 - other.x0), abs(one.z0 - other.z0))
