"""Exact search over the choices: branch only on violated ones, bound by the QP of the rows taken so far.

Root = bounds and fixed rows. At a node the most violated choices are tried: each option appends one row to one axis and that
axis is solved on from the parent's active set; the choice whose cheapest child is dearest is branched on, or one that has only
one child left. A choice is given up at its first child that is cheaper than another's cheapest. What is infeasible or dearer than
the incumbent is pruned; ties go to the option that misses least, then to the lowest number. The search goes down to the cheapest
child, and where there is none to the cheapest open node. A placement at which every choice holds must also pass the walk, where
one is asked for; what blocks it is widened. The search stops on a count of QPs, never on time.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from solver.placement.kernel.dual import SOLVED, build_base
from solver.placement.kernel.grid import walkable
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    AXIS,
    EXHAUSTED,
    FOUND,
    N_CHOICES,
    N_WIDE,
    OPTIONS,
    PICKS,
    SOLVES,
    TRIED_CHOICES,
    TURNED_DOWN,
    WIDE_CHILDREN,
    WIDENINGS,
    Engine,
    Floats,
    I,
    Ints,
    J,
    Nodes,
    Programs,
    S,
    Work,
)
from solver.placement.kernel.nodes import BASE, OPEN, PICKED, SPARE, STEPS, cheapest_on_top, copy_axis, free, push, sort
from solver.placement.kernel.program import append_row, prepare, solve_axis
from solver.placement.kernel.reach import possible, propagate
from solver.placement.kernel.widen import links

COST_TOLERANCE: Final = 1e-9
VIOLATED: Final = 1e-8
"""An option holds when it misses by less than this, m."""
FEWER_FIRST: Final = 1_000_000_000_000
"""Sorts choices with fewer options within reach before those violated more; more than any slack in steps."""
MANY_CHOICES: Final = 500
"""With more choices than this the most violated come first whatever is left to them: nothing is proven there anyway."""
DEAD: Final = -1


@compiled(lambda t: t.none(t.Work, t.Programs, t.Nodes, t.i8))
def _open_node(work: Work, programs: Programs, nodes: Nodes, slot: int) -> None:
    """Brings a node's path back: its rows to the programmes, its positions to nodes.positions."""
    options, wide, option_of, before, task = work.options, work.wide, nodes.pick_option, nodes.pick_before, nodes.task
    column, value, rows, row_s = programs.column, programs.value, programs.rows, programs.row_s
    task[0] = programs.fixed_rows[0] + nodes.row_count[slot, 0]
    task[1] = programs.fixed_rows[1] + nodes.row_count[slot, 1]
    pick = nodes.last_pick[slot]
    while pick >= 0:
        k = option_of[pick]
        if k < len(options):
            axis, i, j, s = options[k, AXIS], options[k, I], options[k, J], options[k, S]
        else:
            k -= len(options)
            axis, i, j, s = wide[k, AXIS], wide[k, I], wide[k, J], wide[k, S]
        task[axis] -= 1
        append_row(column, value, rows, row_s, axis, task[axis], i, j, s)
        pick = before[pick]
    x, positions = nodes.x, nodes.positions
    for axis in range(2):
        for v in range(work.sizes[axis]):
            positions[axis, v] = value[axis, v] if column[axis, v] < 0 else x[slot, axis, column[axis, v]]
    nodes.state[BASE] = nodes.state[BASE + 1] = 0


@compiled(lambda t: t.i8(t.ints, t.int_rows, t.int_rows, t.float_rows, t.float_cubes, t.i8))
def _possible_options(choice_size: Ints, options: Ints, column: Ints, value: Floats, reach: Floats, choice: int) -> int:
    """Returns how many options of a choice are still within reach."""
    count = 0
    for k in range(4 * choice, 4 * choice + choice_size[choice]):
        if possible(column, value, reach, options[k, AXIS], options[k, I], options[k, J], options[k, S]):
            count += 1
    return count


@compiled(lambda t: t.i8(t.Work, t.Programs, t.Nodes, t.i8))
def _violated(work: Work, programs: Programs, nodes: Nodes, slot: int) -> int:
    """Writes the violated choices to try to nodes.worst; returns how many.

    Those with the fewest options left within reach come first, then the most violated, then the lowest number. A choice with
    one option left is written alone; DEAD is returned where one has none.
    """
    p, worst, options, choice_size, count = nodes.positions, nodes.worst, work.options, work.choice_size, 0
    column, value, reach, known = programs.column, programs.value, programs.reach, False
    few = work.counts[N_CHOICES] <= MANY_CHOICES
    for c in range(work.counts[N_CHOICES]):
        slack = -np.inf
        for k in range(4 * c, 4 * c + choice_size[c]):
            axis = options[k, AXIS]
            slack = max(slack, p[axis, options[k, J]] - p[axis, options[k, I]] - options[k, S] / 1000)
            if slack >= -VIOLATED:
                break
        if slack >= -VIOLATED:
            continue
        if not known:
            known = True
            for axis in range(2):
                m = programs.fixed_rows[axis] + nodes.row_count[slot, axis]
                propagate(axis, programs.size[axis], m, programs.bounds, programs.rows, programs.row_s, reach)
        left = _possible_options(choice_size, options, column, value, reach, c)
        if left <= 1:
            worst[0, 0] = c
            return DEAD if left == 0 else 1
        key = (left * FEWER_FIRST if few else 0) + np.int64(slack * STEPS)
        at = count
        while at > 0 and worst[at - 1, 1] > key:
            at -= 1
        if at < TRIED_CHOICES:
            count = min(count + 1, TRIED_CHOICES)
            for move in range(count - 1, at, -1):
                worst[move, 0], worst[move, 1] = worst[move - 1, 0], worst[move - 1, 1]
            worst[at, 0], worst[at, 1] = c, key
    return count


@compiled(lambda t: t.i8(t.Work, t.Programs, t.Nodes, t.i8, t.i8, t.f8), inlined=True)
def _child(work: Work, programs: Programs, nodes: Nodes, parent: int, option: int, ceiling: float) -> int:
    """Solves the parent with one row more; returns the child's slot, or -1 where it is infeasible or too dear."""
    capacity, state, size = len(work.options), nodes.state, programs.size
    table = work.options if option < capacity else work.wide
    k = option if option < capacity else option - capacity
    axis = table[k, AXIS]
    x, active, multiplier, active_size = nodes.x, nodes.active, nodes.multiplier, nodes.active_size
    cost, row_count, rows = nodes.cost, nodes.row_count, programs.rows
    at = programs.fixed_rows[axis] + row_count[parent, axis]
    if at >= rows.shape[2]:
        return -1
    nodes.result[SOLVES] += 1
    i, j, s, row_s = table[k, I], table[k, J], table[k, S], programs.row_s
    if not append_row(programs.column, programs.value, rows, row_s, axis, at, i, j, s):
        return -1
    if state[BASE + axis] == 0:
        q = active_size[parent, axis]
        build_base(axis, parent, size[axis], q, programs.inverse, rows, active, programs.columns, programs.factor)
    slot, other = nodes.spare[state[SPARE] - 1], cost[parent, 1 - axis]
    copy_axis(parent, slot, axis, size[axis], x, active, multiplier, active_size, cost, row_count)
    status = solve_axis(programs, nodes, slot, axis, at + 1, 2 * size[axis] + at, ceiling - other)
    state[BASE + axis] = 1 - nodes.task[5]
    if status != SOLVED or cost[slot, axis] + other >= ceiling:
        return -1
    copy_axis(parent, slot, 1 - axis, size[1 - axis], x, active, multiplier, active_size, cost, row_count)
    row_count[slot, axis] += 1
    nodes.last_pick[slot] = option  # becomes a pick when the child is kept
    nodes.widened[slot] = nodes.widened[parent]
    state[SPARE] -= 1
    return slot


@compiled(lambda t: t.none(t.Work, t.Nodes, t.i8))
def _order(work: Work, nodes: Nodes, choice: int) -> None:
    """Writes the numbers of a choice's options to nodes.order, those that miss least at nodes.positions first."""
    options, p, order = work.options, nodes.positions, nodes.order
    for o in range(work.choice_size[choice]):
        k = 4 * choice + o
        axis, at = options[k, AXIS], o
        slack = np.int64((p[axis, options[k, J]] - p[axis, options[k, I]] - options[k, S] / 1000) * STEPS)
        while at > 0 and order[at - 1, 1] < slack:
            order[at, 0], order[at, 1] = order[at - 1, 0], order[at - 1, 1]
            at -= 1
        order[at, 0], order[at, 1] = k, slack


@compiled(lambda t: t.i8(t.Work, t.Programs, t.Nodes, t.i8, t.i8, t.i8, t.i8, t.f8), inlined=True)
def _children(work: Work, programs: Programs, nodes: Nodes, parent: int, choice: int, first: int, dearest: int, ceiling: float) -> int:
    """Solves the children of a choice and writes them to the family from `first` on; returns where they end.

    DEAD as soon as one is no dearer than `dearest`, the cheapest child of another choice: there is more to gain from that one.
    """
    options, column, value, reach, last = work.options, programs.column, programs.value, programs.reach, first
    _order(work, nodes, choice)
    for o in range(work.choice_size[choice]):
        k = nodes.order[o, 0]
        if not possible(column, value, reach, options[k, AXIS], options[k, I], options[k, J], options[k, S]):
            continue
        slot = _child(work, programs, nodes, parent, k, ceiling)
        if slot < 0:
            continue
        key = np.int64((nodes.cost[slot, 0] + nodes.cost[slot, 1]) * STEPS)
        nodes.family[last, 0], nodes.family[last, 1] = slot, key
        last += 1
        if key <= dearest:
            free(nodes, first, last, 0)
            return DEAD
    sort(nodes, first, last)
    return last


@compiled(lambda t: t.none(t.Work, t.Programs, t.Nodes, t.i8, t.i8, t.f8))
def _branch(work: Work, programs: Programs, nodes: Nodes, parent: int, count: int, ceiling: float) -> None:
    """Opens the children of the first choice that has only one, else of the choice whose cheapest child is dearest."""
    family, kept, dearest = nodes.family, 0, -1
    for w in range(count):
        last = _children(work, programs, nodes, parent, nodes.worst[w, 0], kept, dearest, ceiling)
        if last == DEAD:
            continue
        free(nodes, 0, kept, 0)
        if last == kept:
            return
        dearest = family[kept, 1]
        for k in range(kept, last):
            family[k - kept, 0], family[k - kept, 1] = family[k, 0], family[k, 1]
        kept = last - kept
        if kept == 1:
            break
    push(nodes, parent, 0, kept)


@compiled(lambda t: t.none(t.Engine, t.i8, t.f8))
def _widen(engine: Engine, parent: int, ceiling: float) -> None:
    """Opens the placements in which one of the pairs that block the way leaves room for a person."""
    work, nodes = engine.work, engine.nodes
    last = 0
    for k in range(links(engine.room, work, engine.grid), work.counts[N_WIDE]):
        slot = _child(work, engine.programs, nodes, parent, len(work.options) + k, ceiling)
        if slot < 0:
            continue
        nodes.widened[slot] += 1
        nodes.family[last, 0] = slot
        nodes.family[last, 1] = np.int64((nodes.cost[slot, 0] + nodes.cost[slot, 1]) * STEPS)
        last += 1
        if last == len(nodes.family) or nodes.state[SPARE] < TRIED_CHOICES * OPTIONS:
            break
    sort(nodes, 0, last)
    free(nodes, 0, last, WIDE_CHILDREN)
    push(nodes, parent, 0, min(last, WIDE_CHILDREN))


@compiled(lambda t: t.none(t.Work, t.Programs, t.Nodes, t.i8))
def _keep_best(work: Work, programs: Programs, nodes: Nodes, slot: int) -> None:
    best, positions = nodes.best, nodes.positions
    for axis in range(2):
        for v in range(work.sizes[axis]):
            best[axis, v] = positions[axis, v]
    nodes.best_cost[0] = nodes.cost[slot, 0] + nodes.cost[slot, 1]
    pick, count = nodes.last_pick[slot], 0
    while pick >= 0:
        nodes.best_picks[count] = nodes.pick_option[pick]
        count += 1
        pick = nodes.pick_before[pick]
    nodes.result[FOUND], nodes.result[PICKS] = 1, count


@compiled(lambda t: t.b1(t.Work, t.Programs, t.Nodes))
def _root(work: Work, programs: Programs, nodes: Nodes) -> bool:
    """Opens the root; False where it is infeasible."""
    choice_size = work.choice_size
    for c in range(work.counts[N_CHOICES]):
        if choice_size[c] == 0:
            return False
    if not prepare(work, programs, nodes):
        return False
    slot = nodes.spare[nodes.state[SPARE] - 1]
    for axis in range(2):
        for k in range(programs.size[axis]):
            nodes.x[slot, axis, k] = programs.start[axis, k]
        nodes.active_size[slot, axis] = nodes.row_count[slot, axis] = 0
        nodes.cost[slot, axis] = programs.start_cost[axis]
        nodes.result[SOLVES] += 1
        if solve_axis(programs, nodes, slot, axis, programs.fixed_rows[axis], -1, np.inf) != SOLVED:
            return False
    nodes.last_pick[slot], nodes.widened[slot] = -1, 0
    nodes.state[SPARE] -= 1
    nodes.stack[0] = slot
    nodes.state[OPEN] = 1
    return True


@compiled(lambda t: t.b1(t.Engine))
def _passes(engine: Engine) -> bool:
    """Tells whether the open node's placement, rounded to millimetres, is walkable."""
    nodes, grid, work = engine.nodes, engine.grid, engine.work
    rounded, positions = grid.positions, nodes.positions
    for axis in range(2):
        for v in range(work.sizes[axis]):
            rounded[axis, v] = np.int64(np.floor(positions[axis, v] * 1000 + 0.5))
    return walkable(engine.room, work, grid, grid.positions)


@compiled(lambda t: t.none(t.Engine, t.i8, t.f8, t.b1))
def search(engine: Engine, limit: int, ceiling: float, walk: bool) -> None:
    """Finds the cheapest placement of the problem in `work` at which every choice holds.

    Args:
        engine: the work space; the outcome is left in nodes.result, best_cost, best and best_picks.
        limit: QPs after which to stop; EXHAUSTED is then 0.
        ceiling: only placements cheaper than this count.
        walk: whether doors and use sides must be joined.
    """
    work, programs, nodes = engine.work, engine.programs, engine.nodes
    nodes.result[:] = 0
    nodes.state[OPEN], nodes.state[SPARE], nodes.state[PICKED] = 0, len(nodes.spare), 0
    spare = nodes.spare
    for k in range(len(spare)):
        spare[k] = k
    work.counts[N_WIDE] = 0
    nodes.best_cost[0] = ceiling
    nodes.result[EXHAUSTED] = 1
    if not _root(work, programs, nodes):
        return
    room_for, opened = TRIED_CHOICES * OPTIONS + WIDE_CHILDREN, 0
    while nodes.state[OPEN] > 0:
        if nodes.state[OPEN] < opened:
            cheapest_on_top(nodes)
        opened = nodes.state[OPEN]
        nodes.state[OPEN] -= 1
        slot = nodes.stack[nodes.state[OPEN]]
        cost, best = nodes.cost[slot, 0] + nodes.cost[slot, 1], nodes.best_cost[0] - COST_TOLERANCE
        if cost < best:
            full = nodes.state[SPARE] <= room_for or nodes.state[PICKED] + room_for >= len(nodes.pick_option)
            if nodes.result[SOLVES] >= limit or full:
                nodes.result[EXHAUSTED] = 0
                return
            _open_node(work, programs, nodes, slot)
            count = _violated(work, programs, nodes, slot)
            if count > 0:
                _branch(work, programs, nodes, slot, count, best)
            elif count == DEAD:
                nodes.result[SOLVES] += 1  # costs about as much as a QP
            elif not walk or _passes(engine):
                _keep_best(work, programs, nodes, slot)
            else:
                nodes.result[TURNED_DOWN] += 1
                if nodes.widened[slot] < WIDENINGS:
                    _widen(engine, slot, best)
        nodes.spare[nodes.state[SPARE]] = slot
        nodes.state[SPARE] += 1
