"""fix_frame(): a frame of a drag, from scene to scene: what /fix answers while a piece is dragged.

Not here: the whole repair once the piece is let go (fix).

The last few rooms in hand are kept prepared: preparing one takes ten times as long as answering a frame. A frame is of the same drag where
its room differs from the one prepared in nothing but where the piece in hand, and what goes along with it, is. What it carries may be
sent where it was, too.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final, TypeVar

from catalogs import Catalogs, load_catalogs
from solver.answers import Conflict, Fixed, Pose
from solver.certificate import certified
from solver.errors import RequestError
from solver.free_places import footprint
from solver.pipeline.drag import NO_ANSWER, Dragging, FrameAnswer, alone, opening_of, riders_of
from solver.pipeline.timing import Clock, Timing
from solver.repair import all_bodies
from solver.scene import Decoration, Dynamic, Furniture, Room, Scene
from solver.scene_bodies import SentBody, bodies_of, body_ids, check_ids, moves_between
from solver.understanding import understood

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
    drag: Dragging | None

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


def _answered(own: Scene, label: str, drag: Dragging, previous: Mapping[str, Pose]) -> FrameAnswer:
    bodies = bodies_of(own)
    wish = next(body for body in bodies if body.id == label)
    poses = [previous.get(body.id, body) for body in bodies]
    return drag.frame(wish.x, wish.z, [value for pose in poses for value in (pose.x, pose.z)])


def _after(scene: Scene, own: Scene, answer: FrameAnswer) -> Scene:
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
