"""fix(): an edited or foreign scene -> the same scene repaired with least movement, or the reasons why not.

Comes in: a Scene. Goes out: Fixed. May import: every stage. Not here: what a stage does inside.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from catalogs import Catalogs, load_catalogs
from solver.certificate import certified
from solver.furnish import space_of
from solver.pipeline.attempt import Terms, walls_of
from solver.pipeline.concerned import concerned
from solver.pipeline.mend import Mended, explain_unreached, mend_room, settle_room
from solver.pipeline.people import People, mend_people
from solver.pipeline.timing import Clock, Timing
from solver.repair import Body, Sides, Wishes, all_bodies, followed, put_upon, rested, said
from solver.scene import Conflict, Dynamic, Fixed, Furniture, Issue, Move, Pose, Room, Scene, check_ids, robot_width_of
from solver.validate import RULES, validate
from solver.wanted import Space

MOST_ROOM_WORK = 300_000.0
"""Work each attempt at a room, and its explanation, may cost, in QPs of a small room: about a third of a second."""
SCENE_WORK = 400_000.0
"""Work one scene may cost, in QPs of a small room, dealt to its rooms alike: by their number, not by how many are broken,
so that a repaired scene is repaired on the same terms again; as much again for saying why not, dealt to the broken ones."""
MOVED = 0.001
"""A body that moved by more, m, is listed in `moves` (contract)."""


@dataclass(frozen=True)
class _Answers:
    """What became of a scene's rooms and people."""

    scene: Scene
    rooms: tuple[Mended, ...]
    people: People


def fix(  # noqa: PLR0913 - keyword-only options of the public door
    scene: Scene,
    *,
    locked: Sequence[str] = (),
    moved: Sequence[str] = (),
    on_conflict: str = "report",
    previous: Sequence[Pose] = (),
    catalogs: Catalogs | None = None,
    clock: Clock | None = None,
) -> Fixed:
    """Repairs a scene with least movement; a clean room comes back untouched.

    Args:
        scene: an edited or foreign scene.
        locked: ids that stay to the millimetre, besides those with `locked: true`.
        moved: ids that are held most strongly.
        on_conflict: "report" leaves what cannot stand as sent and names it; "remove" takes the least important out.
        previous: poses of the last answer, while something is dragged: pieces stay near them, at the same sides and walls,
            unless elsewhere is clearly better. Ids that are not in the scene are passed over.
        catalogs: whose kinds and room types are known; ours by default.
        clock: a clock in seconds, to fill `timing_ms`.

    Raises:
        SceneError: an id is not in the scene.
    """
    known = catalogs or load_catalogs()
    ids = [body.id for room in scene.rooms for body in all_bodies(room)] + [person.id for person in scene.dynamic]
    check_ids("locked", locked, ids)
    check_ids("moved", moved, ids)
    timing = Timing(clock)
    errors = _errors(scene, known)
    timing.lap("validate")
    kept = frozenset(locked) | _seats(scene, locked)
    wishes = Wishes(kept, frozenset(moved), _required_kinds(known), use_sides(known) if _walks() else {})
    work = min(MOST_ROOM_WORK, SCENE_WORK / max(len(scene.rooms), 1))
    terms = Terms(wishes, scene.wall_thickness, on_conflict, work, {pose.id: pose for pose in previous})
    lying = _put_back(_put_upon(scene, errors, wishes, known), errors, wishes, known)
    answers = _repaired(lying, terms, errors if lying is scene else _errors(lying, known), known)
    timing.lap("placement")
    answers = replace(answers, scene=_honest(answers.scene, terms, known))
    issues = validate(answers.scene, known)
    lying = _put_back_all(answers.scene, issues, wishes, known)
    if lying is not answers.scene:
        answers, issues = replace(answers, scene=lying), validate(lying, known)
    timing.lap("validate_again")
    removed = (*(removal for room in answers.rooms for removal in room.removed), *answers.people.removed)
    conflicts = (*(conflict for room in answers.rooms for conflict in room.conflicts), *answers.people.conflicts)
    unsolved = _unsolved(issues, conflicts, answers.scene, _locked_ids(scene, wishes))
    return Fixed(certified(answers.scene), _moves(scene, answers.scene), removed, (*conflicts, *unsolved), issues, timing.ms)


def _put_upon(scene: Scene, errors: Sequence[Issue], wishes: Wishes, known: Catalogs) -> Scene:
    """Returns the scene with floating furniture on what carries it, or on the floor; locked pieces stay, who sits goes along.

    Of what was moved on what carries it, also what is in the way there.
    """
    wrong = {label: issue.rule == "floating" for issue in sorted(errors, key=lambda one: one.rule == "floating") for label in issue.ids}
    rooms = []
    for room in scene.rooms:
        free = [piece for piece in room.furniture if piece.on is not None and piece.id in wrong and not wishes.is_locked(piece)]
        here = {piece.id for piece in free if wrong[piece.id] or piece.id in wishes.moved}
        rooms.append(put_upon(room, _space(scene, room), here, wishes.moved, known) if here else room)
    return scene if tuple(rooms) == scene.rooms else _with_rooms(scene, tuple(rooms))


def _put_back_all(scene: Scene, issues: Sequence[Issue], wishes: Wishes, known: Catalogs) -> Scene:
    """Returns a repaired scene with all that floats back on what carries it: what turned square is narrower than it was."""
    floating = [issue for issue in issues if issue.rule == "floating"]
    still = frozenset(piece.id for piece in _furniture(scene.rooms)).difference(*(issue.ids for issue in floating))
    return _put_back(_put_upon(scene, floating, replace(wishes, moved=still), known), floating, wishes, known)


def _put_back(scene: Scene, issues: Iterable[Issue], wishes: Wishes, known: Catalogs) -> Scene:
    """Returns the scene with floating decorations back on what carries them; locked ones stay."""
    floating = {label for issue in issues if issue.rule == "floating" for label in issue.ids} - wishes.locked
    if not floating:
        return scene
    rooms = tuple(
        rested(room, floating, known, scene.wall_thickness) if any(thing.id in floating for thing in room.decorations) else room
        for room in scene.rooms
    )
    return scene if rooms == scene.rooms else replace(scene, rooms=rooms)


def _repaired(scene: Scene, terms: Terms, errors: Sequence[Issue], known: Catalogs) -> _Answers:
    """Repairs the rooms that break a rule without their people, then the people who are in the way."""
    if not errors:
        return _Answers(scene, (), People(scene.dynamic))
    alone = _without_people(scene, errors, known)
    broken = concerned(scene, alone)
    terms = replace(terms, telling=min(MOST_ROOM_WORK, SCENE_WORK / max(len(broken), 1)))
    mended = tuple(_mended(scene, room, terms, alone) if room.id in broken else Mended(room) for room in scene.rooms)
    furnished, left = _with(scene, mended), errors
    if broken:
        mended, left = _settled(replace(scene, dynamic=()), mended, terms, known)
        furnished = _with(scene, mended)
        left = _errors(furnished, known) if scene.dynamic else left
    moved = mend_people(furnished, {room.id: _space(scene, room) for room in scene.rooms}, terms, left)
    return _Answers(replace(furnished, dynamic=moved.people), mended, moved)


def _without_people(scene: Scene, errors: Sequence[Issue], known: Catalogs) -> list[Issue]:
    """Returns the errors of a scene that its furniture makes by itself; who stands in the way makes things unreachable."""
    people = {person.id for person in scene.dynamic}
    if people and any(issue.rule == "unreachable" for issue in errors):
        return _errors(replace(scene, dynamic=()), known)
    return [issue for issue in errors if not people & set(issue.ids)]


def _mended(scene: Scene, room: Room, terms: Terms, errors: Sequence[Issue]) -> Mended:
    return mend_room(room, _space(scene, room), terms, [issue for issue in errors if issue.room == room.id])


def _settled(scene: Scene, mended: Sequence[Mended], terms: Terms, known: Catalogs) -> tuple[tuple[Mended, ...], list[Issue]]:
    """Settles the rooms that still break a rule although all their pieces found a place, and says what is out of reach."""
    furnished = _with(scene, mended)
    left = _errors(furnished, known)
    open_rooms = {issue.room for issue in left if issue.rule != "floating"}  # what floats is put back without moving any piece
    settles = [result.whole and not result.conflicts and result.room.id in open_rooms for result in mended]
    if not any(settles):
        return tuple(mended), left
    spaces = [_space(scene, room) for room in scene.rooms]
    every = list(zip(settles, scene.rooms, mended, spaces, strict=True))
    settled = tuple(settle_room(room, result, space, terms) if does else result for does, room, result, space in every)
    left = _errors(_with(scene, settled), known)
    explained = []
    for (does, room, _, space), result in zip(every, settled, strict=True):
        here = [issue for issue in left if issue.room == room.id]
        explained.append(explain_unreached(room, result, space, terms, here) if does else result)
    return tuple(explained), left


def _honest(scene: Scene, terms: Terms, known: Catalogs) -> Scene:
    """Returns the scene in which moved pieces say at which walls they are."""
    if not terms.wishes.moved:
        return scene
    hugging = {name for name, kind in known.kinds_by_name().items() if kind.stands == "wall"}
    touched = {room.id for room in scene.rooms if any(piece.id in terms.wishes.moved for piece in room.furniture)}
    honest = (
        said(room, walls_of(room, _space(scene, room), terms), terms.wishes, hugging) if room.id in touched else room
        for room in scene.rooms
    )
    return replace(scene, rooms=tuple(honest))


def _errors(scene: Scene, known: Catalogs) -> list[Issue]:
    return [issue for issue in validate(scene, known) if issue.severity == "error"]


def _with(scene: Scene, mended: Sequence[Mended]) -> Scene:
    """Returns the scene with its rooms repaired; who sits goes along with the seat."""
    return _with_rooms(scene, tuple(result.room for result in mended))


def _with_rooms(scene: Scene, rooms: tuple[Room, ...]) -> Scene:
    return replace(scene, rooms=rooms, dynamic=followed(scene.dynamic, _furniture(scene.rooms), _furniture(rooms)))


def _furniture(rooms: Iterable[Room]) -> list[Furniture]:
    return [piece for room in rooms for piece in room.furniture]


def _seats(scene: Scene, locked: Sequence[str]) -> frozenset[str]:
    """Returns the seats of those who stay where they sit."""
    return frozenset(person.on for person in scene.dynamic if person.on is not None and person.id in locked)


def _space(scene: Scene, room: Room) -> Space:
    return space_of(room, scene.wall_thickness, robot_width_of(scene), scene.rooms)


def _unsolved(issues: Iterable[Issue], conflicts: Iterable[Conflict], scene: Scene, locked: frozenset[str]) -> tuple[Conflict, ...]:
    """Names every error that is left and that no conflict explains; one of a whole room any conflict in that room explains."""
    named = {member for conflict in conflicts for member in conflict.ids}
    rooms = {room.id for room in scene.rooms if any(body.id in named for body in all_bodies(room))}
    left = [issue for issue in issues if issue.severity == "error" and not named & set(issue.ids)]
    told = [issue for issue in left if issue.ids or issue.room not in rooms]
    return tuple(Conflict(issue.ids, _words(issue, locked, issue.room in rooms)) for issue in told)


def _words(issue: Issue, locked: frozenset[str], contested: bool) -> str:
    """Says why an error is left; ways are only kept free where everything can be kept, so not in a contested room."""
    if issue.ids and locked.issuperset(issue.ids):
        return f"locked where it cannot stand: {issue.message}"
    if issue.rule == "unreachable" and contested:
        return f"out of reach as long as the room's other conflicts last: {issue.message}"
    if issue.rule == "unreachable" and issue.ids:
        return f"not found: it can stand, but no way was found to reach it: {issue.message}"
    return f"not found: no repair for this: {issue.message}"


def _locked_ids(scene: Scene, wishes: Wishes) -> frozenset[str]:
    own = (body.id for room in scene.rooms for body in all_bodies(room) if wishes.is_locked(body))
    return wishes.locked.union(own)


def _walks() -> bool:
    """Tells whether a repair keeps the ways to use sides free: where the rule calls it an error, it must."""
    return RULES["unreachable"] == "error"


def _required_kinds(catalogs: Catalogs) -> frozenset[str]:
    return frozenset(kind for room in catalogs.rooms.values() for either in room.requires for kind in either)


def use_sides(catalogs: Catalogs) -> dict[str, Sides]:
    """Returns from which sides the pieces of each name are used, and whether all of them are needed."""
    return {name: (entry.use.sides, entry.use.need == "all") for name, entry in catalogs.kinds_by_name().items() if entry.use}


def _moves(before: Scene, after: Scene) -> tuple[Move, ...]:
    """Lists what moved by more than a millimetre, or turned."""
    pairs = zip(before.rooms, after.rooms, strict=True)
    found = [move for old, new in pairs for move in _steps(all_bodies(old), all_bodies(new))]
    return (*found, *_steps(before.dynamic, after.dynamic))


def _steps(before: Iterable[Body | Dynamic], after: Iterable[Body | Dynamic]) -> list[Move]:
    sent, moves = {body.id: body for body in before}, []
    for body in after:
        old = sent[body.id]
        dx, dz = round(body.x - old.x, 4), round(body.z - old.z, 4)
        if abs(dx) > MOVED or abs(dz) > MOVED or (body.rotation - old.rotation) % 360:
            moves.append(Move(body.id, dx, dz, body.rotation))
    return moves
