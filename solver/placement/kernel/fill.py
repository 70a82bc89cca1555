"""Optional pieces, by importance, with everything movable: each joins as cheaply as it can, else one other piece makes room.

A group (a desk and its chair) joins as a whole or not at all. Pieces are added while the floor covered is below the target.
"""

from __future__ import annotations

from typing import Final

from solver.placement.kernel.grow import best_first, evaluate
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    ABSENT,
    BEST,
    BOTTOM,
    CANDIDATE_0,
    CANDIDATE_1,
    CLOSED,
    COVER,
    COVERED,
    DEPTH,
    DOUBTED,
    EMPTY,
    EVALUATED,
    EXHAUSTED,
    GROUP_END,
    KIN,
    LINK_0,
    LINK_1,
    MANY,
    MOVES_LEFT,
    NO_WAY,
    OF,
    PARENT,
    PLACED,
    REQUIRED,
    SIDES_0,
    SIDES_1,
    SOLVED_QPS,
    SPENT,
    UNDER,
    WIDTH,
    Engine,
    Floats,
    Ints,
    RoomArrays,
    Tree,
)
from solver.placement.kernel.options import preference, total_preference

MOVES: Final = 48
"""Other ways of other pieces that are looked at before the cheapest are tried."""
# limits of a room
REQUIRED_EVALUATIONS, REQUIRED_QPS, OPTIONAL_EVALUATIONS, OPTIONAL_QPS, OPTIONAL_LAPSES, MOVE_EVALUATIONS, FINAL_QPS = range(7)


@compiled(lambda t: t.i8(t.RoomArrays, t.ints))
def covered(room: RoomArrays, decisions: Ints) -> int:
    """Returns the floor that the decided pieces cover, mm2."""
    area = 0
    for piece in range(len(decisions)):
        if decisions[piece] != ABSENT:
            candidate = room.candidates[decisions[piece] // 8]
            if candidate[BOTTOM] == 0 and candidate[UNDER] < 0 and room.pieces[piece, EMPTY] == 0:
                area += candidate[WIDTH] * candidate[DEPTH]
    return area


@compiled(lambda t: t.b1(t.RoomArrays, t.i8))
def _on_floor(room: RoomArrays, piece: int) -> bool:
    """Tells whether a piece may cover floor of its own: a chair at its table, a screen on its stand and kept floor do not."""
    if room.pieces[piece, EMPTY] != 0:
        return False
    for candidate in range(room.pieces[piece, CANDIDATE_0], room.pieces[piece, CANDIDATE_1]):
        if room.candidates[candidate, BOTTOM] == 0 and room.candidates[candidate, UNDER] < 0:
            return True
    return False


@compiled(lambda t: t.b1(t.RoomArrays, t.ints, t.i8))
def _fatherless(room: RoomArrays, decisions: Ints, piece: int) -> bool:
    """Tells whether what a piece stands at is not there, in any of its ways."""
    for candidate in range(room.pieces[piece, CANDIDATE_0], room.pieces[piece, CANDIDATE_1]):
        if room.candidates[candidate, PARENT] < 0 or decisions[room.candidates[candidate, PARENT]] != ABSENT:
            return False
    return True


@compiled(lambda t: t.b1(t.Engine, t.ints, t.floats, t.ints, t.ints, t.b1))
def _join(engine: Engine, start: Ints, costs: Floats, group: Ints, limits: Ints, walk: bool) -> bool:
    """Adds a group to the decisions where it can stand for less than leaving it out costs; changes `start` and `costs`."""
    tree = engine.tree
    if not best_first(engine, start, costs, group, limits, walk):
        return False
    best = tree.counters[BEST]
    for piece in range(len(start)):
        start[piece] = tree.decisions[best, piece]
    costs[0], costs[1] = tree.costs[best], tree.preferences[best]
    return True


@compiled(lambda t: t.b1(t.RoomArrays, t.ints, t.i8))
def _depended(room: RoomArrays, decisions: Ints, piece: int) -> bool:
    """Tells whether the preferences of another piece that stands speak of this one."""
    for other in range(len(decisions)):
        if decisions[other] == ABSENT or other == piece:
            continue
        if room.candidates[decisions[other] // 8, PARENT] == piece:
            return True
        for link in range(room.pieces[other, LINK_0], room.pieces[other, LINK_1]):
            if room.links[link, OF] == piece:
                return True
    return False


@compiled(lambda t: t.none(t.Tree, t.i8, t.i8, t.f8, t.i8))
def _note_move(tree: Tree, piece: int, decision: int, cost: float, count: int) -> None:
    """Inserts a move into the list of the cheapest, `count` long so far."""
    moves, costs, at = tree.moves, tree.move_cost, count
    while at > 0 and costs[at - 1] > cost:
        at -= 1
    if at == MOVES:
        return
    for k in range(min(count, MOVES - 1), at, -1):
        moves[k, 0], moves[k, 1], costs[k] = moves[k - 1, 0], moves[k - 1, 1], costs[k - 1]
    moves[at, 0], moves[at, 1], costs[at] = piece, decision, cost


@compiled(lambda t: t.i8(t.Engine, t.ints, t.floats))
def _moves(engine: Engine, decisions: Ints, costs: Floats) -> int:
    """Lists other ways of the pieces that stand, by the preference cost of all then; returns how many."""
    room, tree, count = engine.room, engine.tree, 0
    candidates, pieces = room.candidates, room.pieces
    for piece in range(len(decisions)):
        kept = decisions[piece]
        if kept == ABSENT:
            continue
        first, depended = pieces[piece, SIDES_0], _depended(room, decisions, piece)
        own = preference(room, decisions, piece, kept // 8) + room.side_costs[first + kept % 8]
        for candidate in range(pieces[piece, CANDIDATE_0], pieces[piece, CANDIDATE_1]):
            if candidates[candidate, PARENT] != candidates[kept // 8, PARENT]:
                continue
            for side in range(first, pieces[piece, SIDES_1]):
                decision = 8 * candidate + side - first
                if candidates[candidate, KIN] == candidates[kept // 8, KIN] and decision % 8 == kept % 8:
                    continue
                decisions[piece] = decision
                if depended:
                    cost = total_preference(room, decisions)
                else:
                    cost = preference(room, decisions, piece, candidate)
                    if cost >= 0:
                        cost += costs[1] - own + room.side_costs[side]
                if cost >= 0:
                    _note_move(tree, piece, decision, cost, count)
                    count = min(count + 1, MOVES)
        decisions[piece] = kept
    return count


@compiled(lambda t: t.b1(t.Engine, t.ints, t.floats, t.ints, t.ints, t.b1))
def _join_by_move(engine: Engine, decisions: Ints, costs: Floats, group: Ints, limits: Ints, walk: bool) -> bool:
    """Moves one other piece so that the group can join; the first success counts."""
    tree = engine.tree
    counters = tree.counters
    count = _moves(engine, decisions, costs)
    terms, ceiling = costs[0] - costs[1], costs[2]
    own = tree.own_limits
    for k in range(count):
        if counters[MOVES_LEFT] <= 0 or tree.budget[0] <= 0:
            return False
        if terms + tree.move_cost[k] >= ceiling:
            return False
        for piece in range(len(decisions)):
            tree.shifted[piece] = decisions[piece]
        tree.shifted[tree.moves[k, 0]] = tree.moves[k, 1]
        tree.shifted_cost[0], tree.shifted_cost[1], tree.shifted_cost[2] = terms + tree.move_cost[k], tree.move_cost[k], ceiling
        own[0], own[1], own[2] = min(counters[MOVES_LEFT], 6), limits[OPTIONAL_QPS], 1
        joined = _join(engine, tree.shifted, tree.shifted_cost, group, own, walk)
        counters[MOVES_LEFT] -= max(counters[EVALUATED], 1)
        if joined:
            for piece in range(len(decisions)):
                decisions[piece] = tree.shifted[piece]
            costs[0], costs[1] = tree.shifted_cost[0], tree.shifted_cost[1]
            return True
    return False


@compiled(lambda t: t.none(t.Engine, t.ints, t.floats, t.ints, t.ints, t.b1))
def fill(engine: Engine, decisions: Ints, costs: Floats, fates: Ints, limits: Ints, walk: bool) -> None:
    """Adds the optional pieces to the decisions of the required ones.

    Args:
        engine: the work space.
        decisions: changed in place.
        costs: total and preference cost of the decisions; changed in place. The third is scratch.
        fates: what becomes of each optional piece; written.
        limits: see the constants above.
        walk: whether the room must stay walkable.
    """
    room, tree, group = engine.room, engine.tree, engine.tree.group
    tree.counters[MOVES_LEFT] = limits[MOVE_EVALUATIONS]
    piece = 0
    while piece < len(decisions):
        end = room.pieces[piece, GROUP_END]
        if room.pieces[piece, REQUIRED]:
            piece = end
            continue
        group[0], group[1] = piece, end
        fate, skip = NO_WAY, 0.0
        for member in range(piece, end):
            skip += room.skip_costs[member]
        empty = room.pieces[piece, EMPTY] != 0
        if tree.budget[0] <= 0:
            fate = SPENT
        elif empty and _fatherless(room, decisions, piece):
            fate = NO_WAY
        elif room.space[COVER] > 0 and _on_floor(room, piece) and covered(room, decisions) >= room.space[COVER]:
            fate = COVERED
        else:
            costs[2] = costs[0] + skip
            tree.own_limits[0], tree.own_limits[1] = limits[OPTIONAL_EVALUATIONS], limits[OPTIONAL_QPS]
            tree.own_limits[2] = limits[OPTIONAL_LAPSES]
            if _join(engine, decisions, costs, group, tree.own_limits, walk) or (
                not empty and tree.counters[MOVES_LEFT] > 0 and _join_by_move(engine, decisions, costs, group, limits, walk)
            ):
                fate = PLACED
        for member in range(piece, end):
            fates[member] = fate
        piece = end


@compiled(lambda t: t.none(t.Engine, t.ints, t.floats, t.ints, t.ints, t.ints, t.b1))
def arrange_room(engine: Engine, decisions: Ints, costs: Floats, fates: Ints, limits: Ints, report: Ints, walk: bool) -> None:
    """Arranges a whole room: required pieces, optional pieces, and a final search over all choices.

    Args:
        engine: the work space; the final placement is left in `work` and `nodes`.
        decisions: written; ABSENT where a piece is left out.
        costs: written: total and preference cost.
        fates: written for optional pieces.
        limits: see the constants above.
        report: written: whether all required pieces stand, whether the arrangement of the required ones is exact, whether the
            final placement is proven, QPs.
        walk: whether doors and use sides must be joined.
    """
    room, tree = engine.room, engine.tree
    required = 0
    while required < len(room.pieces) and room.pieces[required, REQUIRED]:
        required += 1
    decisions[:] = ABSENT
    tree.counters[SOLVED_QPS] = 0
    tree.group[0], tree.group[1] = 0, required
    tree.own_limits[0], tree.own_limits[1], tree.own_limits[2] = limits[REQUIRED_EVALUATIONS], limits[REQUIRED_QPS], MANY
    costs[0], costs[1], costs[2] = 0.0, 0.0, 1e12
    report[:] = 0
    if required > 0 and not _join(engine, decisions, costs, tree.group, tree.own_limits, walk):
        report[1] = tree.counters[CLOSED] * (1 - tree.counters[DOUBTED])
        report[3] = tree.counters[SOLVED_QPS]
        return
    report[0], report[1] = 1, tree.counters[CLOSED] if required > 0 else 1
    fill(engine, decisions, costs, fates, limits, walk)
    evaluate(engine, decisions, limits[FINAL_QPS], costs[0] - costs[1] + 1e-6, walk)
    report[2] = engine.nodes.result[EXHAUSTED]
    report[3] = tree.counters[SOLVED_QPS]
