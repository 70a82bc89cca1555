"""The tree's open nodes: their slots, the families of children that become nodes, and which node is next."""

from __future__ import annotations

from typing import Final

import numpy as np

from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import Floats, Ints, Nodes

STEPS: Final = 1e9
"""Costs and slacks are compared in steps of a nanometre or its like, so that rounding decides no tie."""
# Nodes.state
OPEN, SPARE, PICKED, BASE = range(4)


@compiled(
    lambda t: t.none(t.i8, t.i8, t.i8, t.i8, t.float_cubes, t.int_cubes, t.float_cubes, t.int_rows, t.float_rows, t.int_rows)
)  # fmt: skip
def copy_axis(
    parent: int, slot: int, axis: int, n: int, x: Floats, active: Ints, multiplier: Floats, size: Ints, cost: Floats, rows: Ints
) -> None:
    """Copies what a node knows of an axis with n free variables."""
    for k in range(n):
        x[slot, axis, k] = x[parent, axis, k]
    for k in range(size[parent, axis]):
        active[slot, axis, k] = active[parent, axis, k]
        multiplier[slot, axis, k] = multiplier[parent, axis, k]
    size[slot, axis], cost[slot, axis], rows[slot, axis] = size[parent, axis], cost[parent, axis], rows[parent, axis]


@compiled(lambda t: t.none(t.Nodes, t.i8, t.i8, t.i8))
def free(nodes: Nodes, first: int, last: int, keep: int) -> None:
    """Gives back the slots of a family's members first ... last - 1."""
    for k in range(first, last):
        if k >= keep:
            nodes.spare[nodes.state[SPARE]] = nodes.family[k, 0]
            nodes.state[SPARE] += 1


@compiled(lambda t: t.none(t.Nodes, t.i8, t.i8))
def sort(nodes: Nodes, first: int, last: int) -> None:
    """Sorts a family's members by cost, stably."""
    for k in range(first + 1, last):
        slot, key = nodes.family[k, 0], nodes.family[k, 1]
        at = k
        while at > first and nodes.family[at - 1, 1] > key:
            nodes.family[at, 0], nodes.family[at, 1] = nodes.family[at - 1, 0], nodes.family[at - 1, 1]
            at -= 1
        nodes.family[at, 0], nodes.family[at, 1] = slot, key


@compiled(lambda t: t.none(t.Nodes, t.i8, t.i8, t.i8))
def push(nodes: Nodes, parent: int, first: int, last: int) -> None:
    """Opens a family's members, the cheapest on top."""
    for k in range(last - 1, first - 1, -1):
        slot, pick = nodes.family[k, 0], nodes.state[PICKED]
        nodes.pick_option[pick] = nodes.last_pick[slot]
        nodes.pick_before[pick] = nodes.last_pick[parent]
        nodes.last_pick[slot] = pick
        nodes.state[PICKED] = pick + 1
        nodes.stack[nodes.state[OPEN]] = slot
        nodes.state[OPEN] += 1


@compiled(lambda t: t.none(t.Nodes))
def cheapest_on_top(nodes: Nodes) -> None:
    """Brings the cheapest open node to the top, of equal ones the upper; not where slots run short, since depth needs fewer."""
    if nodes.state[SPARE] < len(nodes.spare) // 2:
        return
    stack, cost, top = nodes.stack, nodes.cost, nodes.state[OPEN] - 1
    found, least = top, np.int64((cost[stack[top], 0] + cost[stack[top], 1]) * STEPS)
    for k in range(top - 1, -1, -1):
        key = np.int64((cost[stack[k], 0] + cost[stack[k], 1]) * STEPS)
        if key < least:
            found, least = k, key
    stack[top], stack[found] = stack[found], stack[top]
