"""fix_frame(): a frame of a drag, from scene to scene: what /fix answers while a piece is dragged.

A room is prepared once as bytes for the core (solver/core/drag), which the page runs as well; `Dragging` runs them here. Not here: the
whole repair once the piece is let go (fix).

The last few rooms in hand are kept prepared: preparing one takes ten times as long as answering a frame. A frame is of the same drag where
its room differs from the one prepared in nothing but where the piece in hand, and what goes along with it, is. What it carries may be
sent where it was, too.
"""

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from struct import Struct
from typing import Final, NamedTuple, TypeVar

from catalogs import Catalogs, load_catalogs
from solver.answers import Conflict, Fixed, Pose
from solver.certificate import certified
from solver.core import taken
from solver.errors import RequestError
from solver.free_places import footprint
from solver.pipeline.room_spaces import room_problem
from solver.pipeline.timing import Clock, Timing
from solver.placement import problem_bytes
from solver.repair import RepairSettings, all_bodies, in_hand
from solver.scene import EXTERIOR, Decoration, Dynamic, Furniture, Room, Scene
from solver.scene_bodies import SentBody, bodies_of, body_ids, check_ids, check_listed, moves_between, people_in
from solver.understanding import understood
from solver.validator import RULES, room_alone

MOST_KEPT: Final = 4
"""Drags that are kept prepared: one a person who drags, of a few."""
SAME_M: Final = 2e-4
"""Two ways that bodies went which differ by no more are the same: poses are written to a tenth of a millimetre."""
Body = TypeVar("Body", Furniture, Decoration, Dynamic)


@dataclass(frozen=True)
class PreparedDrag:
    """A room prepared for a drag: bytes for the core, None where the piece cannot be dragged by itself; ids in the order of a frame."""

    opening: bytes | None
    bodies: tuple[str, ...]


def prepare_drag(scene: Scene, label: str, *, locked: Sequence[str] = (), catalogs: Catalogs) -> PreparedDrag:
    """Prepares the room of a piece that is taken in hand.

    Args:
        scene: the house, every piece where it stands.
        label: the piece's id.
        locked: ids that stay, besides pieces that say so themselves.
        catalogs: whose kinds are known.
    """
    scene = understood(scene, catalogs).scene
    room = _room_of(scene, label)
    if room is None:
        return PreparedDrag(None, ())
    own = alone(scene, room)
    return PreparedDrag(opening_of(own, label, locked, catalogs), tuple(body_ids(own)))


def _room_of(scene: Scene, label: str) -> Room | None:
    return next((room for room in scene.rooms if any(body.id == label for body in all_bodies(room))), None)


@dataclass(frozen=True)
class _Kept:
    """A drag that was prepared: from which room, what is in hand, what goes along with it; None in place of `drag` where that cannot be."""

    scene: Scene
    label: str
    locked: frozenset[str]
    catalogs: Catalogs
    going: frozenset[str]
    drag: "Dragging | None"

    def is_of(self, scene: Scene, label: str, locked: frozenset[str], catalogs: Catalogs) -> bool:
        """Tells whether a frame belongs to this drag."""
        if (label, locked) != (self.label, self.locked) or catalogs is not self.catalogs:
            return False
        before, now = bodies_of(self.scene), bodies_of(scene)
        if len(before) != len(now) or _empty(self.scene) != _empty(scene):
            return False
        pairs = list(zip(before, now, strict=True))
        held = next((pair for pair in pairs if pair[0].id == label), None)
        if held is None or held[1].id != label:
            return False
        way = held[1].x - held[0].x, held[1].z - held[0].z
        return all(a is b or a == b or (a.id in self.going and _went(a, b, way)) for a, b in pairs)


_kept: deque[_Kept] = deque(maxlen=MOST_KEPT)


def fix_frame(  # noqa: PLR0913 - keyword-only options of a public function
    scene: Scene,
    moved: Sequence[str],
    *,
    locked: Sequence[str] = (),
    previous: Sequence[Pose] = (),
    catalogs: Catalogs | None = None,
    clock: Clock | None = None,
) -> Fixed | None:
    """Answers a frame of a drag, quickly: where all in the room of the piece in hand is now (docs/fix.md). No issues are listed.

    Args:
        scene: the piece in hand where it is wished, with all that goes along with it, the rest where it was before the drag.
        moved: id of the piece in hand, and no other.
        locked: ids that stay, besides pieces that say so themselves.
        previous: poses of the last frame.
        catalogs: whose kinds are known; ours by default.
        clock: a clock in seconds, to fill `timing_ms`.

    Returns:
        The scene as it is now, as sent and with a conflict where no place was found; None where the piece cannot be dragged by itself:
        `fix` answers then.

    Raises:
        RequestError: `moved` does not name one piece.
        SceneError: an id is not in the scene.

    Example:
        >>> from compose_homes import Furniture, Room, Scene, fix_frame
        >>> sofa = Furniture("sofa", "sofa", x=-0.5, z=2.0, width=2.0, depth=0.9, height=0.8)
        >>> frame = fix_frame(Scene(rooms=(Room("den", width=4, depth=4, furniture=(sofa,)),)), ["sofa"])
        >>> frame.scene.rooms[0].furniture[0].x
        1.0
    """
    check_ids(body_ids(scene), locked=locked, moved=moved)
    check_listed("previous", previous, Pose, "a Pose")
    if len(moved) != 1:
        raise RequestError("moved", f"names {len(moved)} bodies", "the one that is dragged")
    label, timing, known = moved[0], Timing(clock), catalogs or load_catalogs()
    words = understood(scene, known)
    room = _room_of(words.scene, label)
    if room is None:
        return None
    own, last = alone(words.scene, room), {pose.id: pose for pose in previous}
    kept = _taken(own, label, frozenset(locked), known, last)
    try:
        if kept.drag is None:
            return None
        answer = _answered(own, label, kept.drag, last)
    finally:
        _kept.append(kept)
    message = f"not found while it is dragged: a place for {label} and those around it"
    conflicts = (Conflict((label,), message, ()),) if answer.outcome == NO_ANSWER else ()
    after = certified(words.in_their_words(_after(words.scene, own, answer)))
    timing.lap("placement")
    return Fixed(after, moves_between(scene, after), (), conflicts, (), {**timing.ms, "work": float(answer.work)}, words.understood_as)


def _taken(scene: Scene, label: str, locked: frozenset[str], catalogs: Catalogs, previous: Mapping[str, Pose]) -> _Kept:
    """Takes a drag out of those that are kept, so that no other thread asks it; or prepares one."""
    for kept in tuple(_kept):
        if kept.is_of(scene, label, locked, catalogs):
            try:
                _kept.remove(kept)
            except ValueError:  # another thread took it
                continue
            return kept
    last = previous.get(label)
    if last is not None and _left_behind(scene, label, previous):
        room = scene.rooms[0]
        scene = replace(scene, rooms=(_moved_room(room, {label: (last.x, last.z)}),))
    opening = opening_of(scene, label, sorted(locked), catalogs)
    going = frozenset({label}) if opening is None else riders_of(opening, body_ids(scene))
    return _Kept(scene, label, locked, catalogs, going, None if opening is None else Dragging(opening))


def _left_behind(scene: Scene, label: str, previous: Mapping[str, Pose]) -> bool:
    """Tells whether something that goes along with a body was sent where it was, and not where the body is wished."""
    bodies = {body.id: body for body in bodies_of(scene)}
    below = footprint(bodies[label])
    for body in bodies.values():
        carrier = body.parent if isinstance(body, Decoration) else body.on
        hangs = isinstance(body, Decoration) and body.mounted_on_wall is not None
        if hangs or label not in (carrier, body.under if isinstance(body, Furniture) else None):
            continue
        was = previous.get(body.id)
        if was is not None and _spot(body) == _spot(was):
            return _spot(bodies[label]) != _spot(previous[label])
        if carrier == label and not (below.x0 <= body.x * 1000 <= below.x1 and below.z0 <= body.z * 1000 <= below.z1):
            return True
    return False


def _spot(body: SentBody | Pose) -> tuple[float, float]:
    return body.x, body.z


def _answered(own: Scene, label: str, drag: "Dragging", previous: Mapping[str, Pose]) -> "FrameAnswer":
    bodies = bodies_of(own)
    wish = next(body for body in bodies if body.id == label)
    poses = [previous.get(body.id, body) for body in bodies]
    return drag.frame(wish.x, wish.z, [value for pose in poses for value in (pose.x, pose.z)])


def _after(scene: Scene, own: Scene, answer: "FrameAnswer") -> Scene:
    """Returns the scene with the bodies of one room where the core says; as it is where it found no place."""
    if answer.outcome == NO_ANSWER:
        return scene
    spots = dict(zip(body_ids(own), zip(answer.spots[::2], answer.spots[1::2], strict=True), strict=True))
    rooms = tuple(_moved_room(room, spots) if room.id == own.rooms[0].id else room for room in scene.rooms)
    return replace(scene, rooms=rooms, dynamic=_moved(scene.dynamic, spots))


def _moved_room(room: Room, spots: Mapping[str, tuple[float, float]]) -> Room:
    return replace(room, furniture=_moved(room.furniture, spots), decorations=_moved(room.decorations, spots))


def _moved(bodies: Sequence[Body], spots: Mapping[str, tuple[float, float]]) -> tuple[Body, ...]:
    return tuple(body if spots.get(body.id, (body.x, body.z)) == (body.x, body.z) else _at(body, spots[body.id]) for body in bodies)


def _at(body: Body, spot: tuple[float, float]) -> Body:
    x, z = spot
    return replace(body, x=x, z=z)


def _empty(scene: Scene) -> Scene:
    return replace(scene, rooms=tuple(replace(room, furniture=(), decorations=()) for room in scene.rooms), dynamic=())


def _went(before: SentBody, now: SentBody, way: tuple[float, float]) -> bool:
    """Tells whether a body went that way and is the same in all else."""
    near = abs(now.x - before.x - way[0]) <= SAME_M and abs(now.z - before.z - way[1]) <= SAME_M
    return near and replace(now, x=before.x, z=before.z) == before


VERSION: Final = 4
_HEAD: Final = Struct("<6q")
_MOVER: Final = Struct("<2q")
_RIDER: Final = Struct("<q")
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
    riders = [_RIDER.pack(hand.riders.get(body.id, NOBODY)) for body in judged.bodies]
    head = _HEAD.pack(VERSION, len(problem), len(judged.rows), len(movers), len(riders), hand.held)
    return b"".join((head, problem, judged.rows, *movers, *riders))


def riders_of(opening: bytes, ids: Sequence[str]) -> frozenset[str]:
    """Returns the ids of the piece in hand and of all that goes along with it, of the ids of all bodies in turn."""
    bodies, held = _HEAD.unpack_from(opening)[4:]
    rows = _RIDER.iter_unpack(opening[len(opening) - bodies * _RIDER.size :])
    return frozenset(label for label, (piece,) in zip(ids, rows, strict=True) if piece == held)


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
