"""The kernel's arrays: what each holds and what each column means.

A room comes in as `RoomArrays` (read only), its problem is laid out in `Work`, the two axes' programmes in `Programs`, the tree's
nodes in `Nodes`, the free floor in `WalkGrid`. Integers are millimetres unless a name says otherwise, floats are metres and
costs. Everything is C-contiguous int64 or float64: another type would compile anew.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

ORIGIN: Final = -1
ABSENT: Final = -1

# RoomArrays.space
X0, Z0, X1, Z1, GAP, ROBOT, COVER, LEAST_FLOOR = range(8)
# RoomArrays.zones: a rectangle, above which height it counts, whether it is a wall (a part missing from the room)
ABOVE, WALL_ZONE = 4, 5
# RoomArrays.pieces
REQUIRED, CANDIDATE_0, CANDIDATE_1, LINK_0, LINK_1, SIDES_0, SIDES_1, GROUP_END, EMPTY = range(9)
EMPTY_FLOOR = 16
# EMPTY is EMPTY_FLOOR for floor that is asked for empty, as if a person stood all over it: no body, but apart from all bodies
# RoomArrays.sides: bits of the use sides that get a stand; without one: bits of which any, and of which all must be reached
STANDS, ANY_OF, ALL_OF = 0, 1, 2
FRONT, BACK, LEFT, RIGHT = 1, 2, 4, 8
# RoomArrays.candidates
(
    KIND,
    WIDTH,
    DEPTH,
    HEIGHT,
    TURN,
    WALL,
    ANCHOR_X,
    ANCHOR_Z,
    IN_X0,
    IN_Z0,
    IN_X1,
    IN_Z1,
    BOTTOM,
    PARENT,
    PARENT_KIND,
    ACROSS_0,
    ACROSS_1,
    ALONG_0,
    ALONG_1,
    SLOT,
    UNDER,
    ON,
    SLACK,
    KIN,
) = range(24)
NO_WALL, NORTH, SOUTH, EAST, WEST = -1, 0, 1, 2, 3
# RoomArrays.candidate_costs
WEIGHT_X, WEIGHT_Z, COST = range(3)
# RoomArrays.links, RoomArrays.link_costs
OF, LINK_TURN, LINK_WALLS, LINK_REQUIRED = range(4)
ANY_WALLS, SAME, OPPOSITE, OTHER, ADJACENT = range(5)
LINK_COST, ALIGN, NEAR, APART, APART_COST = range(5)
# Work.counts
N_ROWS, N_PARTS, N_CHOICES, N_PULLS, N_WIDE, ASSEMBLED = range(6)
# rows and options
AXIS, I, J, S = range(4)
# Work.parts
PIECE, STAND, VAR_X, VAR_Z, OFF_X, OFF_Z, EXT_X, EXT_Z, LOW, HIGH = range(10)
# Work.pulls
PULL_OFFSET, PULL_WEIGHT = range(2)
# results of a search
FOUND, EXHAUSTED, SOLVES, TURNED_DOWN, PICKS = range(5)

# Tree.counters
(
    STATES,
    HEAPED,
    ORDER,
    EVALUATED,
    CLOSED,
    DIVING,
    BEST,
    DEEPEST,
    REFUSED,
    DOUBTED,
    INCUMBENT,
    LAPSED,
    SOLVED_QPS,
    MOVES_LEFT,
) = range(14)
# what became of a piece: it stands, no way to stand it was found, the floor is covered enough, the budget is spent
PLACED, NO_WAY, COVERED, SPENT = range(4)
# verdicts of a proof
UNKNOWN, IMPOSSIBLE, POSSIBLE = range(3)

MANY: Final = 1_000_000
"""A limit that is none."""
PERSON_MM: Final = 1800
"""Height a standing person needs free, mm."""
OPTIONS: Final = 4
"""Options a choice has at most."""
TRIED_CHOICES: Final = 4
"""How many of the most violated choices are tried at a node."""
WIDENINGS: Final = 4
"""Widenings on one path of the tree."""
WIDE_CHILDREN: Final = 12
"""Children kept of one widening."""
MOST_NODES: Final = 4096
"""Open nodes of one search; where there would be more, the search stops as at its limit."""
MOST_PICKS: Final = 200_000
"""Children one search may create; as with the nodes."""


class RoomArrays(NamedTuple):
    """What placement is asked, as arrays; see the columns above."""

    space: Ints
    zones: Ints
    doors: Ints
    pieces: Ints
    skip_costs: Floats
    sides: Ints
    side_costs: Floats
    candidates: Ints
    candidate_costs: Floats
    links: Ints
    link_costs: Floats


class Work(NamedTuple):
    """A problem: bounds (2, variables), terms, rows, parts, choices; choice c has options 4c ... 4c + choice_size[c] - 1."""

    counts: Ints
    sizes: Ints
    """Number of variables along x and z."""
    low: Ints
    high: Ints
    anchor_weight: Floats
    anchor_at: Floats
    pulls: Ints
    pull_costs: Floats
    rows: Ints
    parts: Ints
    choice_size: Ints
    choice_parts: Ints
    options: Ints
    wide: Ints
    """Rows that widenings ask for; option number 4 * capacity + k."""
    body_part: Ints
    rotation: Ints
    taken_candidate: Ints
    taken_side: Ints
    marks: Ints
    """By piece: its decision, and sizes and counts once it was added."""
    marked_bounds: Ints


class Programs(NamedTuple):
    """The quadratic programmes of both axes over the free variables; see program.py."""

    size: Ints
    column: Ints
    value: Floats
    bounds: Floats
    inverse: Floats
    start: Floats
    start_cost: Floats
    fixed_rows: Ints
    rows: Ints
    row_s: Floats
    reach: Floats
    """By axis, least and most, variable: how far the rows let each free variable go, m."""
    columns: Floats
    factor: Floats
    vectors: Floats


class Nodes(NamedTuple):
    """Open nodes of the tree, by slot; `stack` and `spare` hold slots. A path is a chain of picks."""

    state: Ints
    x: Floats
    active: Ints
    multiplier: Floats
    active_size: Ints
    cost: Floats
    row_count: Ints
    last_pick: Ints
    widened: Ints
    stack: Ints
    spare: Ints
    pick_before: Ints
    pick_option: Ints
    positions: Floats
    worst: Ints
    order: Ints
    family: Ints
    best: Floats
    best_picks: Ints
    best_cost: Floats
    result: Ints
    task: Ints


class WalkGrid(NamedTuple):
    """The compressed grid of the walk; lengths in it are doubled millimetres."""

    state: Ints
    blocks: Ints
    """x0, z0, x1, z1 and the part, or -1 - its number for a zone."""
    targets: Ints
    """x0, z0, x1, z1 and a number: of the rectangles of one number any will do."""
    cuts: Ints
    labels: Ints
    queue: Ints
    areas: Ints
    reached: Ints
    positions: Ints


class Tree(NamedTuple):
    """Best-first search over prefixes; see grow.py."""

    counters: Ints
    budget: Floats
    decisions: Ints
    costs: Floats
    preferences: Floats
    depths: Ints
    heap: Ints
    heap_cost: Floats
    refused: Ints
    found: Ints
    found_cost: Floats
    trial: Ints
    moves: Ints
    move_cost: Floats
    shifted: Ints
    shifted_cost: Floats
    group: Ints
    own_limits: Ints


class Engine(NamedTuple):
    """All work space of one room."""

    room: RoomArrays
    work: Work
    programs: Programs
    nodes: Nodes
    grid: WalkGrid
    tree: Tree
