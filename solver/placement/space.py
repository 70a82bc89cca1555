"""Work space for one room, in the memory of an instance of the core.

Comes in: a room's arrays and how large its problem may get. Goes out: an `Engine`.
"""

from __future__ import annotations

from itertools import islice
from math import prod
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.core import CoreInstance, taken
from solver.placement.layout import SEEN, Engine, RoomArrays

FLOATS = {"anchor_weight", "anchor_at", "pull_costs", "best", "best_cost", "best_multipliers", "budget", "found_cost"}
"""The arrays of floats; the others hold whole numbers."""
KINDS = [np.dtype(np.float64 if name in FLOATS else np.int64) for part in SEEN for name in part._fields]


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


def request_of(room: RoomArrays, sizes: Sizes) -> bytes:
    """Returns what the core is sent of a room: `RoomRequest` of solver/core/placement/space.hpp."""
    counts = [len(part) for part in (room.zones, room.doors, room.pieces, room.sides, room.candidates, room.links)]
    return b"".join(array.tobytes() for array in (np.array([*sizes, *counts], dtype=np.int64), *room))


def new_engine(room: RoomArrays, sizes: Sizes) -> Engine:
    """Returns all work space for a room, and the room in it.

    Raises:
        CoreFull: the core's memory is too small for it.
    """
    instance = taken(roomy=True)
    return _seen(instance, int(instance.call("new_desk", instance.write(request_of(room, sizes)))), None)


def without_search(engine: Engine) -> Engine:
    """Returns a copy of an engine without what only a search needs, in another instance; `nodes`, `tree` and `wide` are empty there.

    What the memory of one instance took for a search then serves the next room.
    """
    whole, instance = engine.instance, taken()
    start = instance.reserve(0)
    size = int(whole.view(engine.desk + 12 * len(KINDS), (1,), np.int32)[0]) - start
    instance.view(instance.reserve(size), (size,), np.uint8)[:] = whole.view(start, (size,), np.uint8)
    return _seen(instance, engine.desk, start + size)


def _seen(instance: CoreInstance, desk: int, end: int | None) -> Engine:
    """Returns what is seen of a desk in an instance's memory; what lies behind an end is empty."""
    shown = np.frombuffer(instance.read(desk, 12 * len(KINDS)), dtype=np.int32).reshape(-1, 3).tolist()
    memory = instance.lent()
    arrays = iter([_array(memory[:end], kind, *one) for kind, one in zip(KINDS, shown, strict=True)])
    seen: dict[str, Any] = {part.__name__: part(*islice(arrays, len(part._fields))) for part in SEEN}
    return Engine(
        room=seen["RoomSeen"],
        work=seen["Work"],
        nodes=seen["Nodes"],
        grid=seen["GridSeen"],
        tree=seen["Tree"],
        alone=seen["Alone"],
        call=seen["CallRows"],
        instance=instance,
        desk=desk,
    )


def _array(memory: NDArray[np.uint8], kind: np.dtype[Any], address: int, rows: int, columns: int) -> NDArray[Any]:
    shape = (rows, columns) if columns else (rows,)
    if address + 8 * prod(shape) > len(memory):
        shape, address = (0, *shape[1:]), 0
    return np.ndarray(shape, kind, memory, address)
