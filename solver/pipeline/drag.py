"""While a piece is dragged: its room, prepared once; then a frame is where the piece is wished and where all was -> where all is.

A room is prepared as bytes for the core (solver/core/drag), which the page runs as well; `Dragging` runs them here. Not here: frames as
scenes (drag_frames), what becomes of a piece once it is let go (fix).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from struct import Struct
from typing import Final, NamedTuple

from catalogs import Catalogs
from solver.core import taken
from solver.pipeline.room_spaces import room_problem
from solver.placement import problem_bytes
from solver.repair import RepairSettings, in_hand
from solver.scene import EXTERIOR, Room, Scene
from solver.scene_bodies import people_in
from solver.validator import RULES, room_alone

VERSION: Final = 1
_HEAD: Final = Struct("<6q")
_MOVER: Final = Struct("<2q")
_RIDER: Final = Struct("<3q")
NOBODY: Final = -1
NO_ANSWER, PLACED, DRAWN, STAYED = range(4)
"""What becomes of a frame: `enum class Outcome` of solver/core/drag/drag.hpp."""

Spots = Sequence[float]
"""x and z, m, of the middle of every body in turn: furniture, decorations, people, in the order of the document."""


class FrameAnswer(NamedTuple):
    """Where all is now.

    `outcome` is NO_ANSWER where no valid place was found; `work` counts the QPs and walks it took.
    """

    outcome: int
    work: int
    spots: tuple[float, ...]


def alone(scene: Scene, room: Room) -> Scene:
    """Returns the scene with one room only, and who is in it; its doors are the ways into it."""
    ways = tuple(replace(one, connects_to=EXTERIOR) if one.kind != "window" else one for one in room.openings)
    return replace(scene, rooms=(replace(room, openings=ways),), dynamic=people_in(scene, room), certificate=None)


def opening_of(scene: Scene, label: str, locked: Sequence[str], catalogs: Catalogs) -> bytes | None:
    """Prepares a room, a scene as `alone` returns it, for a drag of the piece of an id, which need not stand at a wall.

    `locked` are ids that stay, besides pieces that say so themselves. Returns bytes for the core; None where the piece cannot be dragged by
    itself: it is locked, flat, or stands on another.
    """
    settings = RepairSettings(catalogs, locked=frozenset(locked), moved=frozenset((label,)), walk=RULES["unreachable"] == "error")
    (room,) = scene.rooms
    room = replace(room, furniture=tuple(replace(one, wall=None) if one.id == label else one for one in room.furniture))
    task = room_problem(scene, room, (), settings)
    hand = in_hand(task, label, scene.dynamic)
    if hand is None:
        return None
    judged = room_alone(replace(scene, rooms=(room,)), catalogs)
    numbers = {body.id: number for number, body in enumerate(judged.bodies)}
    if len(numbers) < len(judged.bodies):
        return None
    problem = problem_bytes(task.space, hand.pieces)
    movers = [_MOVER.pack(numbers[piece.label], reach) for piece, reach in zip(hand.pieces, hand.reaches, strict=True)]
    riders = [_RIDER.pack(hand.riders.get(body.id, NOBODY), *use) for body, use in zip(judged.bodies, judged.uses, strict=True)]
    head = _HEAD.pack(VERSION, len(problem), len(judged.rows), len(movers), len(riders), hand.held)
    return b"".join((head, problem, judged.rows, *movers, *riders))


def riders_of(opening: bytes, ids: Sequence[str]) -> frozenset[str]:
    """Returns the ids of the piece in hand and of all that goes along with it, of the ids of all bodies in turn."""
    bodies, held = _HEAD.unpack_from(opening)[4:]
    rows = _RIDER.iter_unpack(opening[len(opening) - bodies * _RIDER.size :])
    return frozenset(label for label, (piece, *_) in zip(ids, rows, strict=True) if piece == held)


class Dragging:
    """A drag under way, in an instance of the core of its own, as `opening_of` prepared it.

    Raises:
        CoreFailed: the bytes are none of `opening_of`.
        CoreFull: the core's memory is too small for the room.
    """

    def __init__(self, opening: bytes) -> None:
        self._instance = taken(roomy=True)
        self._bodies = _HEAD.unpack_from(opening)[4]
        self._drag = self._instance.call("open_drag", self._instance.write(opening), len(opening))
        self._row = Struct(f"<{2 + 2 * self._bodies}d")
        self._at = self._instance.reserve(self._row.size)
        self._memory = self._instance.lent()  # once this is gone the instance is idle again

    def frame(self, x: float, z: float, spots: Spots) -> FrameAnswer:
        """Answers one frame: where the middle of the piece in hand is wished, m, and where all was in the last frame.

        Spots are not a number where that is unknown.

        Raises:
            CoreFailed: the core ended the call.
        """
        self._memory[self._at : self._at + self._row.size] = bytearray(self._row.pack(x, z, *spots))
        self._instance.call("answer_frame", self._drag, self._at)
        outcome, work, *found = self._row.unpack(self._memory[self._at : self._at + self._row.size].tobytes())
        return FrameAnswer(int(outcome), int(work), tuple(found))
