"""Best-first search over prefixes: pieces that stand together or not at all are added one by one.

A child's bound is its parent's exact cost plus the way's own preference cost (every term is >= 0, and walking only gets worse
as pieces are added), so the first complete prefix popped is the best. Once the limit is spent the search dives: deepest prefixes
first, for as many evaluations again.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from solver.placement.kernel.assembly import assemble
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    ABSENT,
    BEST,
    CLOSED,
    DEEPEST,
    DIVING,
    DOUBTED,
    EVALUATED,
    EXHAUSTED,
    FOUND,
    HEAPED,
    INCUMBENT,
    KIN,
    LAPSED,
    MANY,
    N_CHOICES,
    ORDER,
    REFUSED,
    SOLVED_QPS,
    SOLVES,
    STATES,
    TURNED_DOWN,
    Engine,
    Floats,
    Ints,
    RoomArrays,
    Tree,
)
from solver.placement.kernel.nodes import STEPS
from solver.placement.kernel.options import open_decisions
from solver.placement.kernel.search import search

# Tree.heap
RANK, BOUND, AGE, STATE, DECISION = range(5)
EXPANDED: Final = -1
"""Decision of a heap entry that stands for the state itself."""
MODULUS: Final = 2147483647


@compiled(lambda t: t.b1(t.Engine, t.ints, t.i8, t.f8, t.b1))
def evaluate(engine: Engine, decisions: Ints, limit: int, ceiling: float, walk: bool) -> bool:
    """Assembles and searches; tells whether a placement was found. Pays from the budget, in QPs of a small room."""
    nodes, work = engine.nodes, engine.work
    nodes.result[:] = 0
    nodes.result[EXHAUSTED] = 1
    if not assemble(engine.room, work, decisions):
        return False
    size = (work.sizes[0] + work.sizes[1]) / 40
    scale = 1 + size * size  # a dense QP grows with its square
    left = engine.tree.budget[0]
    allowed = int(max(left / scale, 0.0))
    search(engine, limit if limit < allowed else allowed, ceiling, walk)
    engine.tree.budget[0] = left - nodes.result[SOLVES] * scale - work.counts[N_CHOICES] / 4  # reading the choices costs too
    engine.tree.counters[SOLVED_QPS] += nodes.result[SOLVES]
    return nodes.result[FOUND] == 1


@compiled(lambda t: t.i8(t.RoomArrays, t.ints))
def fingerprint(room: RoomArrays, decisions: Ints) -> int:
    """Returns a number for what decides feasibility: decisions that agree in it differ only in their anchors."""
    one, two = 1, 1
    for piece in range(len(decisions)):
        value = 0
        if decisions[piece] != ABSENT:
            value = 8 * room.candidates[decisions[piece] // 8, KIN] + decisions[piece] % 8 + 1
        one = (one * 48271 + value) % MODULUS
        two = (two * 69621 + value + 12345) % MODULUS
    return one * MODULUS + two


@compiled(lambda t: t.b1(t.Tree, t.i8, t.b1))
def refused(tree: Tree, number: int, add: bool) -> bool:
    """Tells whether a fingerprint is among the refused; adds it where asked."""
    size = len(tree.refused)
    at = number % size
    while tree.refused[at] != 0:
        if tree.refused[at] == number:
            return True
        at = (at + 1) % size
    if add and tree.counters[REFUSED] < size // 2:
        tree.refused[at] = number
        tree.counters[REFUSED] += 1
    return False


@compiled(lambda t: t.b1(t.Tree, t.i8, t.i8))
def _before(tree: Tree, a: int, b: int) -> bool:
    for k in range(3):
        if tree.heap[a, k] != tree.heap[b, k]:
            return tree.heap[a, k] < tree.heap[b, k]
    return False


@compiled(lambda t: t.none(t.Tree, t.i8, t.i8))
def _swap(tree: Tree, a: int, b: int) -> None:
    for k in range(5):
        tree.heap[a, k], tree.heap[b, k] = tree.heap[b, k], tree.heap[a, k]
    tree.heap_cost[a], tree.heap_cost[b] = tree.heap_cost[b], tree.heap_cost[a]


@compiled(lambda t: t.none(t.Tree, t.i8))
def _sift_up(tree: Tree, at: int) -> None:
    while at > 0 and _before(tree, at, (at - 1) // 2):
        _swap(tree, at, (at - 1) // 2)
        at = (at - 1) // 2


@compiled(lambda t: t.b1(t.Tree, t.f8, t.i8, t.i8, t.f8, t.i8))
def _push(tree: Tree, bound: float, state: int, decision: int, cost: float, depth: int) -> bool:
    """Adds an entry; False where the heap is full."""
    at = tree.counters[HEAPED]
    if at >= len(tree.heap):
        return False
    entry = tree.heap[at]
    entry[RANK] = -depth if tree.counters[DIVING] else 0
    entry[BOUND], entry[AGE], entry[STATE], entry[DECISION] = np.int64(bound * STEPS), tree.counters[ORDER], state, decision
    tree.heap_cost[at] = cost
    tree.counters[ORDER] += 1
    tree.counters[HEAPED] += 1
    _sift_up(tree, at)
    return True


@compiled(lambda t: t.none(t.Tree))
def _pop(tree: Tree) -> None:
    """Moves the least entry to the place behind the heap's end."""
    last = tree.counters[HEAPED] - 1
    _swap(tree, 0, last)
    tree.counters[HEAPED] = last
    at = 0
    while True:
        least = at
        for child in range(2 * at + 1, min(2 * at + 3, last)):
            if _before(tree, child, least):
                least = child
        if least == at:
            return
        _swap(tree, at, least)
        at = least


@compiled(lambda t: t.none(t.Tree))
def _dive(tree: Tree) -> None:
    """Sorts the heap by depth first from now on."""
    tree.counters[DIVING], tree.counters[CLOSED] = 1, 0
    for k in range(tree.counters[HEAPED]):
        tree.heap[k, RANK] = -tree.depths[tree.heap[k, STATE]]
        _sift_up(tree, k)


@compiled(lambda t: t.i8(t.Tree, t.ints, t.f8, t.f8, t.i8))
def _state(tree: Tree, decisions: Ints, cost: float, chosen: float, depth: int) -> int:
    """Stores a state; returns its number, or -1 where there is no room."""
    k = tree.counters[STATES]
    if k >= len(tree.costs):
        return -1
    for piece in range(len(decisions)):
        tree.decisions[k, piece] = decisions[piece]
    tree.costs[k], tree.preferences[k], tree.depths[k] = cost, chosen, depth
    tree.counters[STATES] = k + 1
    return k


@compiled(lambda t: t.b1(t.Engine, t.i8, t.i8, t.i8))
def _expand(engine: Engine, state: int, piece: int, depth: int) -> bool:
    """Pushes every way the next piece may join a state; False where the heap is full."""
    tree = engine.tree
    count = open_decisions(engine.room, tree.decisions[state], piece, tree.found, tree.found_cost)
    for k in range(count):
        if not _push(tree, tree.costs[state] + tree.found_cost[k], state, tree.found[k], tree.found_cost[k], depth):
            return False
    return True


@compiled(lambda t: t.b1(t.Engine, t.i8, t.i8, t.i8, t.ints, t.b1))
def _try_entry(engine: Engine, entry: int, piece: int, total: int, limits: Ints, walk: bool) -> bool:
    """Evaluates a way; pushes the grown state. False where there is no room to store it.

    What costs more than the best complete state found so far is cut off: costs only grow.
    """
    tree, result = engine.tree, engine.nodes.result
    state, depth = tree.heap[entry, STATE], tree.depths[tree.heap[entry, STATE]]
    for k in range(len(tree.trial)):
        tree.trial[k] = tree.decisions[state, k]
    tree.trial[piece] = tree.heap[entry, DECISION]
    number = fingerprint(engine.room, tree.trial)
    if refused(tree, number, False):
        return True
    tree.counters[EVALUATED] += 1
    chosen, incumbent = tree.preferences[state] + tree.heap_cost[entry], tree.counters[INCUMBENT]
    ceiling = tree.costs[incumbent] - chosen if incumbent >= 0 else np.inf
    if not evaluate(engine, tree.trial, limits[1], ceiling, walk):
        if incumbent < 0 and (limits[2] < MANY or (result[TURNED_DOWN] == 0 and result[EXHAUSTED] == 1)):
            refused(tree, number, True)
        if result[TURNED_DOWN] > 0:
            tree.counters[DOUBTED] = 1
        if result[EXHAUSTED] == 0:
            tree.counters[CLOSED] = 0
            tree.counters[LAPSED] += 1
        return True
    grown = _state(tree, tree.trial, engine.nodes.best_cost[0] + chosen, chosen, depth + 1)
    if grown < 0:
        return False
    if depth + 1 == total and (incumbent < 0 or tree.costs[grown] < tree.costs[incumbent]):
        tree.counters[INCUMBENT] = grown
    deepest = tree.counters[DEEPEST]
    if deepest < 0 or depth + 1 > tree.depths[deepest]:
        tree.counters[DEEPEST] = grown
    return _push(tree, tree.costs[grown], grown, EXPANDED, 0.0, depth + 1)


@compiled(lambda t: t.b1(t.Engine, t.ints, t.floats, t.ints, t.ints, t.b1))
def best_first(engine: Engine, start: Ints, start_cost: Floats, group: Ints, limits: Ints, walk: bool) -> bool:
    """Finds the cheapest way for the pieces group[0] ... group[1] - 1 to join the decisions `start`.

    Args:
        engine: the work space. The answer's number is left in tree.counters[BEST] (-1: none), the deepest prefix in
            DEEPEST (-1: none); CLOSED tells whether the answer is exact within the search, DOUBTED whether a placement was
            turned down for the walk alone, so that "none" is strong evidence, not proof.
        start: decisions so far.
        start_cost: their cost, of it the preferences, and the cost above which no answer counts.
        group: first piece, and the one after the last.
        limits: evaluations before the dive, QPs an evaluation, evaluations that may end at that limit before the search gives
            up (then a way that failed also speaks for those that differ from it only in their anchor).
        walk: whether doors and use sides must be joined.
    """
    tree, first, total = engine.tree, group[0], group[1] - group[0]
    counters = tree.counters
    for k in range(SOLVED_QPS):
        counters[k] = 0
    counters[CLOSED], counters[BEST], counters[DEEPEST], counters[INCUMBENT] = 1, -1, -1, -1
    tree.refused[:] = 0
    limit = limits[0]
    root = _state(tree, start, start_cost[0], start_cost[1], 0)
    _push(tree, start_cost[0], root, EXPANDED, 0.0, 0)
    while counters[HEAPED] > 0:
        _pop(tree)
        entry = counters[HEAPED]
        state, depth = tree.heap[entry, STATE], tree.depths[tree.heap[entry, STATE]]
        if tree.heap[entry, BOUND] >= start_cost[2] * STEPS:
            if counters[DIVING]:
                continue
            return False
        if tree.heap[entry, DECISION] != EXPANDED:
            stored = _try_entry(engine, entry, first + depth, total, limits, walk)
        elif depth == total:
            counters[BEST] = state
            return True
        else:
            stored = _expand(engine, state, first + depth, depth)
        if not stored or tree.budget[0] <= 0:
            counters[CLOSED] = 0
            return False
        if counters[EVALUATED] >= limit or counters[LAPSED] > limits[2]:
            if counters[DIVING] or limits[2] < MANY:
                counters[CLOSED] = 0
                counters[BEST] = counters[INCUMBENT]
                return counters[INCUMBENT] >= 0
            _dive(tree)
            limit *= 2
    return False
