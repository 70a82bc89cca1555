"""Which ways a piece may stand beside what is decided already, and what they cost by preference.

A decision is 8 * candidate + number of the choice of sides. Preference costs are the candidate's, its sides', and those of
the links that do not hold; a required link that does not hold rules the way out.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    ABSENT,
    ADJACENT,
    ANCHOR_X,
    ANY_WALLS,
    APART,
    APART_COST,
    CANDIDATE_0,
    CANDIDATE_1,
    COST,
    KIND,
    LINK_0,
    LINK_1,
    LINK_COST,
    LINK_REQUIRED,
    LINK_TURN,
    LINK_WALLS,
    NO_WALL,
    OF,
    OPPOSITE,
    OTHER,
    PARENT,
    PARENT_KIND,
    SAME,
    SIDES_0,
    SIDES_1,
    SLOT,
    TURN,
    WALL,
    Floats,
    Ints,
    RoomArrays,
)

RULED_OUT: Final = -1.0


@compiled(lambda t: t.i8(t.RoomArrays, t.ints, t.i8))
def rotation_of(room: RoomArrays, decisions: Ints, piece: int) -> int:
    """Returns the absolute rotation of a decided piece."""
    turn = 0
    while True:
        candidate = decisions[piece] // 8
        turn += room.candidates[candidate, TURN]
        piece = room.candidates[candidate, PARENT]
        if piece < 0:
            return turn % 360


@compiled(lambda t: t.b1(t.RoomArrays, t.ints, t.i8, t.i8))
def _fits_parent(room: RoomArrays, decisions: Ints, piece: int, candidate: int) -> bool:
    """Tells whether the parent is there in the variant the slot is for, and the slot free."""
    candidates = room.candidates
    parent = candidates[candidate, PARENT]
    if parent < 0:
        return True
    if decisions[parent] == ABSENT or candidates[decisions[parent] // 8, KIND] != candidates[candidate, PARENT_KIND]:
        return False
    if candidates[candidate, SLOT] < 0:
        return True
    for other in range(len(decisions)):
        if other != piece and decisions[other] != ABSENT:
            taken = decisions[other] // 8
            if candidates[taken, PARENT] == parent and candidates[taken, SLOT] == candidates[candidate, SLOT]:
                return False
    return True


@compiled(lambda t: t.b1(t.i8, t.i8, t.i8))
def _walls_hold(relation: int, own: int, other: int) -> bool:
    if relation == ANY_WALLS:
        return True
    if own == NO_WALL or other == NO_WALL:
        return False
    same = own == other
    opposite = own // 2 == other // 2 and not same
    if relation == SAME:
        return same
    if relation == OPPOSITE:
        return opposite
    if relation == ADJACENT:
        return not same and not opposite
    return relation == OTHER and not same


@compiled(lambda t: t.f8(t.RoomArrays, t.ints, t.i8, t.i8))
def preference(room: RoomArrays, decisions: Ints, piece: int, candidate: int) -> float:
    """Returns the preference cost of an candidate beside the other decided pieces before it, or RULED_OUT."""
    if not _fits_parent(room, decisions, piece, candidate):
        return RULED_OUT
    candidates, links, total = room.candidates, room.links, room.candidate_costs[candidate, COST]
    turn = candidates[candidate, TURN]
    if candidates[candidate, PARENT] >= 0:
        turn += rotation_of(room, decisions, candidates[candidate, PARENT])
    for link in range(room.pieces[piece, LINK_0], room.pieces[piece, LINK_1]):
        of = links[link, OF]
        if decisions[of] == ABSENT:
            continue
        other = decisions[of] // 8
        wished = links[link, LINK_TURN]
        turns = wished < 0 or (turn - rotation_of(room, decisions, of) - wished) % 360 == 0
        if not turns or not _walls_hold(links[link, LINK_WALLS], candidates[candidate, WALL], candidates[other, WALL]):
            if links[link, LINK_REQUIRED]:
                return RULED_OUT
            total += room.link_costs[link, LINK_COST]
        cost = room.link_costs[link, APART_COST]
        if cost > 0 and candidates[candidate, PARENT] < 0 and candidates[other, PARENT] < 0:
            dx = candidates[candidate, ANCHOR_X] - candidates[other, ANCHOR_X]
            dz = candidates[candidate, ANCHOR_X + 1] - candidates[other, ANCHOR_X + 1]
            total += cost * max(0.0, room.link_costs[link, APART] - np.sqrt(float(dx * dx + dz * dz)) / 1000)
    return total


@compiled(lambda t: t.f8(t.RoomArrays, t.ints))
def total_preference(room: RoomArrays, decisions: Ints) -> float:
    """Returns the preference cost of all decisions together, or RULED_OUT."""
    total = 0.0
    for piece in range(len(decisions)):
        if decisions[piece] == ABSENT:
            continue
        cost = preference(room, decisions, piece, decisions[piece] // 8)
        if cost < 0:
            return RULED_OUT
        total += cost + room.side_costs[room.pieces[piece, SIDES_0] + decisions[piece] % 8]
    return total


@compiled(lambda t: t.i8(t.RoomArrays, t.ints, t.i8, t.ints, t.floats))
def open_decisions(room: RoomArrays, decisions: Ints, piece: int, found: Ints, costs: Floats) -> int:
    """Writes the decisions possible for a piece and their preference costs, in the order given; returns how many."""
    count = 0
    first, last = room.pieces[piece, SIDES_0], room.pieces[piece, SIDES_1]
    for candidate in range(room.pieces[piece, CANDIDATE_0], room.pieces[piece, CANDIDATE_1]):
        cost = preference(room, decisions, piece, candidate)
        if cost < 0:
            continue
        for side in range(first, last):
            found[count] = 8 * candidate + side - first
            costs[count] = cost + room.side_costs[side]
            count += 1
    return count
