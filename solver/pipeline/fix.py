"""fix(): an edited or foreign scene -> the same scene repaired with least movement, or the reasons why not.

Comes in: a Scene. Goes out: Fixed. May import: every stage. Not here: what a stage does inside.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from catalogs import Catalogs, load_catalogs
from solver.furnish import space_of
from solver.pipeline.mend import Mended, Terms, mend_room
from solver.pipeline.timing import Clock, Timing
from solver.placement import ROOM_WORK
from solver.repair import Wishes, all_bodies
from solver.scene import Conflict, Fixed, Issue, Move, Scene, check_ids, robot_width_of
from solver.validate import validate

SCENE_WORK = 400_000.0
"""Work one scene may cost, in QPs of a small room, dealt to its rooms alike: by their number, not by how many are broken,
so that a repaired scene is repaired on the same terms again."""
MOVED = 0.001
"""A body that moved by more, m, is listed in `moves` (contract)."""


def fix(  # noqa: PLR0913 - keyword-only options of the public door
    scene: Scene,
    *,
    locked: Sequence[str] = (),
    moved: Sequence[str] = (),
    on_conflict: str = "report",
    catalogs: Catalogs | None = None,
    clock: Clock | None = None,
) -> Fixed:
    """Repairs a scene with least movement; a clean room comes back untouched.

    Args:
        scene: an edited or foreign scene.
        locked: ids that stay to the millimetre, besides those with `locked: true`.
        moved: ids that are held most strongly.
        on_conflict: "report" leaves what cannot stand as sent and names it; "remove" takes the least important out.
        catalogs: whose kinds and room types are known; ours by default.
        clock: a clock in seconds, to fill `timing_ms`.

    Raises:
        SceneError: an id is not in the scene.
    """
    known = catalogs or load_catalogs()
    ids = [body.id for room in scene.rooms for body in all_bodies(room)]
    check_ids("locked", locked, ids)
    check_ids("moved", moved, ids)
    timing = Timing(clock)
    broken = {issue.room for issue in validate(scene, known) if issue.severity == "error"}
    timing.lap("validate")
    wishes = Wishes(frozenset(locked), frozenset(moved), _required_kinds(known))
    terms = Terms(wishes, scene.wall_thickness, on_conflict, min(ROOM_WORK, SCENE_WORK / max(len(scene.rooms), 1)))
    mended = []
    for room in scene.rooms:
        if room.id in broken:
            space = space_of(room, scene.wall_thickness, robot_width_of(scene))
            mended.append(mend_room(room, space, terms))
        else:
            mended.append(Mended(room))
    fixed = replace(scene, rooms=tuple(result.room for result in mended)) if broken else scene
    timing.lap("placement")
    issues = validate(fixed, known)
    timing.lap("validate_again")
    removed = tuple(removal for result in mended for removal in result.removed)
    conflicts = tuple(conflict for result in mended for conflict in result.conflicts)
    unsolved = _unsolved(issues, conflicts)
    return Fixed(fixed, _moves(scene, fixed), removed, (*conflicts, *unsolved), issues, timing.ms)


def _unsolved(issues: Sequence[Issue], conflicts: Sequence[Conflict]) -> tuple[Conflict, ...]:
    """Names every error that is left and that no conflict explains."""
    named = {member for conflict in conflicts for member in conflict.ids}
    return tuple(
        Conflict(issue.ids, f"not found: no repair for this: {issue.message}")
        for issue in issues
        if issue.severity == "error" and not named & set(issue.ids)
    )


def _required_kinds(catalogs: Catalogs) -> frozenset[str]:
    return frozenset(kind for room in catalogs.rooms.values() for either in room.requires for kind in either)


def _moves(before: Scene, after: Scene) -> tuple[Move, ...]:
    """Lists what moved by more than a millimetre, or turned."""
    moves = []
    for old_room, new_room in zip(before.rooms, after.rooms, strict=True):
        sent = {body.id: body for body in all_bodies(old_room)}
        for body in all_bodies(new_room):
            old = sent[body.id]
            dx, dz = round(body.x - old.x, 4), round(body.z - old.z, 4)
            if abs(dx) > MOVED or abs(dz) > MOVED or (body.rotation - old.rotation) % 360:
                moves.append(Move(body.id, dx, dz, body.rotation))
    return tuple(moves)
