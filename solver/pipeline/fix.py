"""fix(): an edited or foreign scene -> the same scene repaired with least movement, or the reasons why not."""

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace

from catalogs import Catalogs, load_catalogs
from solver.answers import ON_CONFLICT, Conflict, Fixed, Issue, Pose
from solver.certificate import certified
from solver.errors import RequestError
from solver.named_assets import with_assets
from solver.pipeline.conflicts import conflicts_of
from solver.pipeline.left_over import cleaned, unexplained
from solver.pipeline.repair_room import ROUNDS, RoomRepair, repair_room, unchanged, unreached_in, until_nothing_changes, with_joined
from solver.pipeline.room_spaces import as_walked_in, room_problem
from solver.pipeline.timing import Clock, Timing
from solver.placement import is_call_spent
from solver.repair import RepairSettings, all_bodies, people_out_of_the_way, put_to_rest, seated_along, with_walls_told
from solver.scene import Room, Scene
from solver.scene_bodies import body_ids, check_ids, check_listed, moves_between, people_in
from solver.understanding import understood
from solver.validator import RULES, Checked, check

MOST_ROOM_WORK = 300_000.0
"""Work each attempt at a room, and its explanation, may cost, in QPs of a small room: about a third of a second."""
SCENE_WORK = 400_000.0
"""Work one scene may cost, in QPs of a small room, dealt to its rooms alike: by their number, not by how many are broken,
so that a repaired scene is repaired on the same terms again; as much again for saying why not, dealt to the broken ones."""
WHY_SHARE = 10
"""Of the work of saying why not, where nothing is offered that would help, this part: what is found at all is mostly found at once."""


def fix(  # noqa: PLR0913 - keyword-only options of a public function
    scene: Scene,
    *,
    locked: Sequence[str] = (),
    moved: Sequence[str] = (),
    on_conflict: str = "report",
    previous: Sequence[Pose] = (),
    repairs: bool = True,
    catalogs: Catalogs | None = None,
    clock: Clock | None = None,
) -> Fixed:
    """Repairs a scene with least movement; a clean room comes back untouched.

    Args:
        scene: an edited or foreign scene.
        locked: ids that stay to the millimetre, besides those with `locked: true`.
        moved: ids that are held most strongly.
        on_conflict: "report" leaves what cannot stand as sent and names it; "remove" takes the least important out.
        previous: poses of the last answer, while something is dragged: pieces stay near them, unless elsewhere is clearly better.
        repairs: whether conflicts are to say what would help; telling why costs less without.
        catalogs: whose kinds and room types are known; ours by default.
        clock: a clock in seconds, to fill `timing_ms`.

    Raises:
        RequestError: `on_conflict` is none of the two.
        SceneError: an id is not in the scene.

    Example:
        >>> from compose_homes import Furniture, Room, Scene, fix
        >>> sofa = Furniture("sofa", "sofa", x=-0.5, z=2.0, width=2.0, depth=0.9, height=0.8)
        >>> fixed = fix(Scene(rooms=(Room("den", width=4, depth=4, furniture=(sofa,)),)))
        >>> [(move.id, move.dx) for move in fixed.moves]
        [('sofa', 1.5)]
    """
    if on_conflict not in ON_CONFLICT:
        raise RequestError("on_conflict", f"is {on_conflict!r}", ", ".join(ON_CONFLICT))
    timing, known = Timing(clock), catalogs or load_catalogs()
    words = understood(scene, known)
    check_ids(body_ids(scene), locked=locked, moved=moved)
    check_listed("previous", previous, Pose, "a Pose")
    seats = {person.on for person in scene.dynamic if person.on is not None and person.id in locked}
    settings = RepairSettings(
        known,
        locked=frozenset(locked) | seats,
        moved=frozenset(moved),
        walk=RULES["unreachable"] == "error",
        remove=on_conflict == "remove",
        previous={pose.id: pose for pose in previous},
        work=_share(len(scene.rooms)),
        offering=repairs,
    )
    house = check(words.scene, known)
    timing.lap("validate")
    house = _all_at_rest(house, house.errors, settings, settings.moved)
    house, repaired = _rooms_repaired(house, settings)
    conflicts = [conflict for repair in repaired for conflict in conflicts_of(house, repair)]
    house = _walls_told(house, settings)
    floating = [issue for issue in house.errors if issue.rule == "floating"]
    house = _all_at_rest(house, floating, settings, set(body_ids(house.scene)).difference(*(issue.ids for issue in floating)))
    house, stuck = _people_repaired(house, settings)
    conflicts += stuck
    timing.lap("placement")
    if settings.remove:
        house, reasons = cleaned(house, settings)
        conflicts += reasons
    timing.lap("validate_again")
    more = unexplained(house, conflicts, settings)
    conflicts = [*(one for one in more if not one.ids), *conflicts, *(one for one in more if one.ids)]
    removed = _removed(scene, house.scene, conflicts)
    answer = certified(words.in_their_words(with_assets(house.scene, known)))
    return Fixed(answer, moves_between(scene, answer), removed, tuple(conflicts), house.issues, timing.ms, words.understood_as)


def _share(rooms: int) -> float:
    """Returns the work that each of so many rooms may cost."""
    return min(MOST_ROOM_WORK, SCENE_WORK / max(rooms, 1))


def _by_room(issues: Iterable[Issue]) -> Mapping[str | None, Sequence[Issue]]:
    found = defaultdict[str | None, list[Issue]](list)
    for issue in issues:
        found[issue.room].append(issue)
    return found


def _with_rooms(house: Checked, rooms: Mapping[str, Room]) -> Checked:
    """Returns the house with some rooms changed, checked again; who sits goes along with the seat."""
    scene = house.scene
    if all(rooms.get(room.id, room) is room for room in scene.rooms):
        return house
    after = tuple(rooms.get(room.id, room) for room in scene.rooms)
    return house.after(replace(scene, rooms=after, dynamic=seated_along(scene.dynamic, scene.rooms, after)))


def _all_at_rest(house: Checked, errors: Sequence[Issue], settings: RepairSettings, moved: Collection[str]) -> Checked:
    """Puts what floats on what carries it, at its wall or on the floor; some things were just moved away from under others."""
    here = _by_room(errors)
    problems = [room_problem(house.scene, room, here[room.id], settings) for room in house.scene.rooms if room.id in here]
    return _with_rooms(house, {problem.room.id: put_to_rest(problem, moved) for problem in problems})


def _rooms_repaired(house: Checked, settings: RepairSettings) -> tuple[Checked, list[RoomRepair]]:
    """Repairs the rooms that break a rule without their people: each alone, then those again that still do, in the repaired house."""
    if not house.errors:
        return house, []
    alone = house.after(replace(house.scene, dynamic=()))
    broken = _rooms_to_look_at(alone.scene, alone.errors)
    settings = replace(settings, explaining_work=_share(len(broken)) / (1 if settings.offering else WHY_SHARE))
    here, closed = _by_room(alone.errors), _closed_rooms(alone.errors)
    leading = broken - here.keys()
    walked = as_walked_in(alone.scene)
    problems = {room.id: walked(room_problem(alone.scene, room, here[room.id], settings)) for room in alone.scene.rooms}
    repairs = {
        name: repair_room(problem) if name in broken and not is_call_spent() else unchanged(problem) for name, problem in problems.items()
    }
    alone = _with_rooms(alone, {name: repair.answer for name, repair in repairs.items()})
    if is_call_spent():
        alone, repairs = _as_few_lost(alone, repairs)
    if closed and closed <= _closed_rooms(alone.errors):  # nothing was gained in the rooms that lead there
        repairs |= {name: unchanged(problem) for name, problem in problems.items() if name in leading}
        alone = _with_rooms(alone, {name: repair.answer for name, repair in repairs.items()})
    open_rooms = {issue.room for issue in alone.errors if issue.rule != "floating"}  # what floats is put to rest without moving any piece
    again = {name: until_nothing_changes(repair) for name, repair in repairs.items() if repair.whole and name in open_rooms}
    alone = _with_rooms(alone, {name: repair.answer for name, repair in again.items()})
    repairs |= again
    sound = {name: repair.sound for name, repair in repairs.items() if not repair.whole}
    here = _by_room(_with_rooms(alone, sound).errors)  # of what only a body that leaves its room shuts its own conflict tells
    for name in (*again, *sound):
        repairs[name] = replace(repairs[name], unreached=unreached_in(repairs[name], here[name]))
    return _with_rooms(house, {name: repair.answer for name, repair in repairs.items()}), list(repairs.values())


def _as_few_lost(alone: Checked, repairs: Mapping[str, RoomRepair]) -> tuple[Checked, dict[str, RoomRepair]]:
    """Leaves of rooms that the end of the call's work left broken the way in which fewest bodies are wrong or missing.

    That is as sent, as the search left them, or with their pieces having stood in turn. No place was found for those alone that are wrong;
    where nobody can come in, for whom the search found none.
    """
    now, kept = _by_room(alone.errors), {}
    joined = {name: with_joined(repair) for name, repair in repairs.items() if now[name] or repair.unplaced}
    then = _by_room(_with_rooms(alone, {name: repair.answer for name, repair in joined.items()}).errors)
    for name, in_turn in joined.items():
        repair, remove = repairs[name], in_turn.problem.settings.remove
        sent = [] if remove else [(replace(repair, room=repair.asked), repair.problem.errors)]
        chosen, errors = min([*sent, (repair, now[name]), (in_turn, then[name])], key=lambda way: _lost(*way))
        wrong = {label for issue in errors for label in issue.ids or chosen.unplaced}
        kept[name] = chosen if remove else replace(chosen, unplaced=tuple(label for label in chosen.unplaced if label in wrong))
    return _with_rooms(alone, {name: repair.answer for name, repair in kept.items()}), {**repairs, **kept}


def _lost(repair: RoomRepair, errors: Iterable[Issue]) -> int:
    """Returns how many bodies of a room break a rule, or are not in its answer any more."""
    wrong = {label for error in errors for label in error.ids}
    return len(wrong) + len(all_bodies(repair.problem.room)) - len(all_bodies(repair.answer))


def _rooms_to_look_at(scene: Scene, issues: Sequence[Issue]) -> set[str | None]:
    """Returns the rooms that break a rule, and those next to rooms that nobody can enter: the way there may end in them."""
    closed = _closed_rooms(issues)
    doors = [(room.id, opening.connects_to) for room in scene.rooms for opening in room.openings if opening.kind != "window"]
    leading = {room for door in doors for room, other in (door, door[::-1]) if other in closed}
    return {issue.room for issue in issues} | leading


def _closed_rooms(issues: Iterable[Issue]) -> set[str | None]:
    """Returns the rooms that nobody can enter."""
    return {issue.room for issue in issues if issue.rule == "unreachable" and not issue.ids}


def _people_repaired(house: Checked, settings: RepairSettings) -> tuple[Checked, list[Conflict]]:
    """Moves people out of the way; while there is no place for some, again from where they came to, until nothing changes."""
    for _ in range(ROUNDS):
        sent, (house, stuck) = house.scene, _people_moved(house, settings)
        if not stuck or house.scene == sent:
            break
    words = {label: f"not found: no free place for {label} in {room} is in nobody's way" for label, room in stuck.items()}
    conflicts = [Conflict((label,), why, ({"action": "leave_out", "id": label},)) for label, why in words.items()]
    staying = tuple(person for person in house.scene.dynamic if not (settings.remove and person.id in stuck))
    return house.after(replace(house.scene, dynamic=staying)), conflicts


def _people_moved(house: Checked, settings: RepairSettings) -> tuple[Checked, dict[str, str]]:
    """Moves people and pets who break a rule, or keep others from something, to the nearest free place; tells who found none, and where."""
    scene = house.scene
    wrong = _rooms_to_look_at(scene, house.errors)
    closed = _rooms_to_look_at(scene, [issue for issue in house.errors if issue.rule == "unreachable"])
    people = {person.id: person for person in scene.dynamic}
    errors, walked = _by_room(house.errors), as_walked_in(scene)
    stuck: dict[str, str] = {}
    for room in scene.rooms:
        here = people_in(scene, room)
        if here and room.id in wrong:
            crowd = people_out_of_the_way(walked(room_problem(scene, room, errors[room.id], settings)), here, room.id in closed)
            people |= {person.id: person for person in crowd.people}
            stuck |= dict.fromkeys(crowd.stuck, room.id)
    return house.after(replace(scene, dynamic=tuple(people.values()))), stuck


def _walls_told(house: Checked, settings: RepairSettings) -> Checked:
    """Returns the house in which moved pieces say at which walls they are."""
    touched = [room for room in house.scene.rooms if any(piece.id in settings.moved for piece in room.furniture)]
    return _with_rooms(house, {room.id: with_walls_told(room_problem(house.scene, room, (), settings)) for room in touched})


def _removed(before: Scene, after: Scene, conflicts: Sequence[Conflict]) -> tuple[Mapping[str, str], ...]:
    """Lists what was taken out, and why."""
    there, carried = set(body_ids(after)), "what carries it was removed"
    reasons = {label: conflict.message for conflict in reversed(conflicts) for label in conflict.ids}
    return tuple({"id": label, "reason": reasons.get(label, carried)} for label in body_ids(before) if label not in there)
