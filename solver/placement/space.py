"""Work space for one room, in the memory of an instance of the core."""

import numpy as np

from solver.core import taken
from solver.placement.layout import COUNT, SHOWN_BYTES, Engine, RoomArrays

OF_ROOM = [0] * 9
"""In place of how large a room's problem may get (`struct Sizes` of solver/core/placement/space.hpp): as large as follows from the room."""


def request_of(room: RoomArrays) -> bytes:
    """Returns what the core is sent of a room: `RoomRequest` of solver/core/placement/space.hpp."""
    counts = [len(part) for part in (room.zones, room.doors, room.pieces, room.sides, room.candidates, room.links)]
    return b"".join(array.tobytes() for array in (np.array([*OF_ROOM, *counts], dtype=np.int64), *room))


def new_engine(room: RoomArrays) -> Engine:
    """Returns all work space for a room, and the room in it.

    Raises:
        CoreFull: the core's memory is too small for it.
    """
    instance = taken(roomy=True)
    return Engine(instance, int(instance.call("new_desk", instance.write(request_of(room)))))


def without_search(engine: Engine) -> Engine:
    """Returns a copy of an engine without what only a search needs, in another instance; `nodes`, `tree` and `wide` are empty there.

    What the memory of one instance took for a search then serves the next room.
    """
    whole, instance = engine.instance, taken()
    start = instance.reserve(0)
    kept, walked = (whole.view(engine.desk + SHOWN_BYTES * COUNT, (2,), np.int32) - start).tolist()
    instance.view(instance.reserve(walked), (kept,), np.uint8)[:] = whole.view(start, (kept,), np.uint8)
    return Engine(instance, engine.desk, start + walked)
