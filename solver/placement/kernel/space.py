"""Work space for one room, allocated once; and an example of every tuple, for the signatures."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from solver.placement.kernel.layout import (
    MOST_NODES,
    MOST_PICKS,
    OPTIONS,
    Engine,
    Floats,
    Ints,
    Nodes,
    Programs,
    RoomArrays,
    Tree,
    WalkGrid,
    Work,
)

SPARE_PATH = 16
"""Rows a path may have beside one for every choice: its widenings."""
MOST_WIDE = 8192
"""Rows that the widenings of one search may ask for."""


class Sizes(NamedTuple):
    """How large a room's problem may get: variables along an axis, parts, choices, fixed rows, pulls, and so on."""

    pieces: int
    variables: int
    choices: int
    rows: int
    pulls: int
    walls: int
    doors: int
    decisions: int
    states: int


def _ints(*shape: int) -> Ints:
    return np.empty(shape, dtype=np.int64)


def _floats(*shape: int) -> Floats:
    return np.empty(shape, dtype=np.float64)


def new_work(sizes: Sizes) -> Work:
    """Returns space for a problem."""
    v, c = sizes.variables, sizes.choices
    return Work(
        counts=np.zeros(8, dtype=np.int64),
        sizes=np.zeros(2, dtype=np.int64),
        low=_ints(2, v),
        high=_ints(2, v),
        anchor_weight=_floats(2, v),
        anchor_at=_floats(2, v),
        pulls=_ints(sizes.pulls, 3),
        pull_costs=_floats(sizes.pulls, 2),
        rows=_ints(sizes.rows, 4),
        parts=_ints(v, 10),
        choice_size=_ints(c),
        choice_parts=_ints(c, 2),
        options=_ints(4 * c, 4),
        wide=_ints(MOST_WIDE, 4),
        body_part=_ints(sizes.pieces),
        rotation=_ints(sizes.pieces),
        taken_candidate=_ints(sizes.pieces),
        taken_side=_ints(sizes.pieces),
        marks=_ints(sizes.pieces, 7),
        marked_bounds=_ints(sizes.pieces, 4, v),
    )


def new_programs(sizes: Sizes) -> Programs:
    """Returns space for the programmes of both axes."""
    v, r = sizes.variables, sizes.rows + sizes.choices + SPARE_PATH
    return Programs(
        size=_ints(2),
        column=_ints(2, v),
        value=_floats(2, v),
        bounds=_floats(2, 2, v),
        inverse=_floats(2, v, v),
        start=_floats(2, v),
        start_cost=_floats(2),
        fixed_rows=_ints(2),
        rows=_ints(2, 2, r),
        row_s=_floats(2, r),
        reach=_floats(2, 2, v),
        columns=_floats(2, v + 1, v),
        factor=_floats(2, v + 1, v + 1),
        vectors=_floats(2, 2, v + 1),
    )


def new_nodes(sizes: Sizes) -> Nodes:
    """Returns space for the tree's open nodes."""
    v, n = sizes.variables, min(MOST_NODES, 4 * sizes.choices + 128)
    return Nodes(
        state=_ints(5),
        x=_floats(n, 2, v),
        active=_ints(n, 2, v),
        multiplier=_floats(n, 2, v),
        active_size=_ints(n, 2),
        cost=_floats(n, 2),
        row_count=_ints(n, 2),
        last_pick=_ints(n),
        widened=_ints(n),
        stack=_ints(n),
        spare=_ints(n),
        pick_before=_ints(MOST_PICKS),
        pick_option=_ints(MOST_PICKS),
        positions=np.zeros((2, v + 1)),
        worst=_ints(8, 2),
        order=_ints(OPTIONS, 2),
        family=_ints(256, 2),
        best=np.zeros((2, v + 1)),
        best_picks=_ints(sizes.choices + SPARE_PATH),
        best_cost=_floats(1),
        result=np.zeros(8, dtype=np.int64),
        task=_ints(6),
    )


def new_grid(sizes: Sizes) -> WalkGrid:
    """Returns space for the walk's compressed grid."""
    blocks = sizes.pieces + sizes.walls
    cuts = 2 * blocks + 2
    cells = (cuts - 1) ** 2
    return WalkGrid(
        state=np.zeros(8, dtype=np.int64),
        blocks=_ints(blocks, 5),
        targets=_ints(sizes.doors + 4 * sizes.pieces, 5),
        cuts=_ints(2, cuts),
        labels=_ints(cells),
        queue=_ints(cells),
        areas=_ints(cells + 1),
        reached=_ints(cells + 1, 2),
        positions=_ints(2, sizes.variables + 1),
    )


def new_tree(sizes: Sizes) -> Tree:
    """Returns space for the best-first search."""
    n, p = sizes.states, sizes.pieces
    heap = sizes.decisions * (n // 4 + 8)
    return Tree(
        counters=np.zeros(16, dtype=np.int64),
        budget=np.zeros(1),
        decisions=_ints(n, p),
        costs=_floats(n),
        preferences=_floats(n),
        depths=_ints(n),
        heap=_ints(heap, 5),
        heap_cost=_floats(heap),
        refused=_ints(4096),
        found=_ints(sizes.decisions),
        found_cost=_floats(sizes.decisions),
        trial=_ints(p),
        moves=_ints(64, 2),
        move_cost=_floats(64),
        shifted=_ints(p),
        shifted_cost=_floats(3),
        group=_ints(2),
        own_limits=_ints(3),
    )


def example_room() -> RoomArrays:
    """Returns a room of nothing, for its type."""
    rows, values = _ints(1, 1), _floats(1, 1)
    return RoomArrays(_ints(1), rows, rows, rows, _floats(1), rows, _floats(1), rows, values, rows, values)


def new_engine(room: RoomArrays, sizes: Sizes) -> Engine:
    """Returns all work space for a room."""
    return Engine(room, new_work(sizes), new_programs(sizes), new_nodes(sizes), new_grid(sizes), new_tree(sizes))


def example_engine() -> Engine:
    """Returns the smallest engine, for its type."""
    return new_engine(example_room(), Sizes(1, 1, 1, 1, 1, 1, 1, 1, 1))
