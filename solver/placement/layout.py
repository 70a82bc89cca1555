"""The core's arrays of one room, as Python sees them, and the columns that Python reads or writes.

A room comes in as bytes (encode), its problem is laid out in `Work`, what a search finds is left in `Nodes`. Integers are millimetres
unless a name says otherwise, floats are metres and costs; everything is C-contiguous int64 or float64. What all columns mean is said
in solver/core/placement/room.hpp and engine.hpp: a row is a struct, a column one of its fields.
"""

from collections.abc import Iterator
from functools import cached_property
from typing import Any, Final, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from solver.core import CoreInstance

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Seen = TypeVar("Seen")

ABSENT: Final = -1

# RoomSeen: of the space, a piece, a candidate
CANDIDATE_0, CANDIDATE_1, SIDES_0, GROUP_END = 1, 2, 5, 7
KIN = 23
# Work.counts, Work.parts
N_ROWS, N_PARTS, N_CHOICES, N_PULLS = range(4)
VAR_X, OFF_X, EXT_X = 2, 4, 6
# Nodes.result
FOUND, EXHAUSTED, SOLVES = range(3)
# Tree.counters
CLOSED, BEST, DEEPEST = 4, 6, 7
# what became of a piece: it stands, no way to stand it was found, the floor is covered enough, the budget is spent; of a required one,
# that it certainly cannot stand, or that no place was found for it
PLACED, NO_WAY, COVERED, SPENT, CANNOT_STAND, NOT_FOUND = range(6)
# verdicts of a proof
UNKNOWN, IMPOSSIBLE, POSSIBLE = range(3)

MANY: Final = 1_000_000
"""A limit that is none."""
PERSON_MM: Final = 1800
"""Height a standing person needs free, mm."""


class RoomSeen(NamedTuple):
    """What is read of a room again: the engine's copies of its arrays."""

    space: Ints
    pieces: Ints
    candidates: Ints


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
    """Rows that widenings ask for; option number len(options) + k."""
    body_part: Ints
    rotation: Ints


class Nodes(NamedTuple):
    """What a search found: positions (2, variables + 1), m, cost, counts."""

    best: Floats
    best_cost: Floats
    result: Ints


class GridSeen(NamedTuple):
    """Positions (2, variables + 1), mm, to ask about; the last column is the origin's and 0."""

    positions: Ints


class Tree(NamedTuple):
    """Best-first search over prefixes: its states' decisions, and the ways found for one piece."""

    counters: Ints
    budget: Floats
    decisions: Ints
    found: Ints
    found_cost: Floats


class CallRows(NamedTuple):
    """What calls hand over and bring back; decisions and fates by piece."""

    decisions: Ints
    fates: Ints
    limits: Ints
    group: Ints
    report: Ints
    taken: Ints
    """Rows that the choices took."""


SEEN = (RoomSeen, Work, Nodes, GridSeen, Tree, CallRows)
"""What is seen of an engine, in the order in which the core tells where it is (`show_all` in solver/core/placement/space.cpp)."""
FLOATS = {"anchor_weight", "anchor_at", "pull_costs", "best", "best_cost", "budget", "found_cost"}
"""The arrays of floats; the others hold whole numbers."""
COUNT: Final = sum(len(part._fields) for part in SEEN)
SHOWN_BYTES: Final = 12
"""What the core tells of one array: its address, rows and columns, 32 bits each."""


def _seen(part: type[Seen]) -> cached_property[Seen]:
    """Returns a part of an engine, made when it is first named."""
    return cached_property(lambda engine: part(*engine.arrays(part)))


class Engine:
    """All work space of one room: arrays in the memory of an instance of the core, made when they are first named.

    `desk` is the room's address there.
    """

    def __init__(self, instance: CoreInstance, desk: int) -> None:
        self.instance, self.desk = instance, desk
        self._memory = instance.lent()
        self._shown = np.frombuffer(instance.read(desk, SHOWN_BYTES * COUNT), dtype=np.int32).reshape(-1, 3)

    room = _seen(RoomSeen)
    work = _seen(Work)
    nodes = _seen(Nodes)
    grid = _seen(GridSeen)
    tree = _seen(Tree)
    call = _seen(CallRows)

    def arrays(self, part: type[Any]) -> Iterator[NDArray[Any]]:
        """Yields the arrays of a part."""
        first = sum(len(before._fields) for before in SEEN[: SEEN.index(part)])
        names: tuple[str, ...] = part._fields
        for name, (address, rows, columns) in zip(names, self._shown[first : first + len(names)].tolist(), strict=True):
            kind, shape = np.float64 if name in FLOATS else np.int64, (rows, columns) if columns else (rows,)
            yield np.ndarray(shape, kind, self._memory, address)
