"""What is asked of the core about one room, the functions of solver/core/placement/entry.cpp; and its work space in an instance."""

from solver.core import taken
from solver.placement.layout import Engine, Floats, Ints


def new_engine(request: bytes) -> Engine:
    """Returns all work space for a room, and the room in it.

    Raises:
        CoreFull: the core's memory is too small for it.
    """
    instance = taken(roomy=True)
    return Engine(instance, int(instance.call("new_desk", instance.write(request))))


def assemble(engine: Engine, decisions: Ints) -> bool:
    """Writes the problem of the decisions to `work`; False where the bounds alone rule them out."""
    engine.call.decisions[:] = decisions
    return bool(engine.instance.call("assemble", engine.desk))


def open_decisions(engine: Engine, decisions: Ints, piece: int) -> tuple[Ints, Floats]:
    """Returns the decisions possible for a piece beside those decided, and their preference costs; views of the engine."""
    engine.call.decisions[:] = decisions
    count = engine.instance.call("open_decisions", engine.desk, piece)
    return engine.tree.found[:count], engine.tree.found_cost[:count]


def walkable(engine: Engine) -> bool:
    """Tells whether doors and use sides are joined with the bodies of `work` at grid.positions."""
    return bool(engine.instance.call("walkable", engine.desk))


def new_proof(engine: Engine, most: int) -> int:
    """Takes space for a proof's open nodes, for so many at most; returns its address."""
    return int(engine.instance.call("new_proof", engine.desk, most))


def prove(engine: Engine, nodes: int, most: int) -> tuple[int, int]:
    """Proves that the assembled pieces cannot be used together, or finds where they can: that is then in grid.positions.

    Looks at `most` nodes at most, in the space at `nodes`. Returns IMPOSSIBLE, POSSIBLE or UNKNOWN, and how many nodes were looked at.
    """
    verdict = int(engine.instance.call("prove", engine.desk, nodes, most))
    return verdict, int(engine.call.report[0])
