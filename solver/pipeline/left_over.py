"""What is still broken once all rooms were repaired: named, with what helps; or taken out, the least important first.

Each way out is tried: the validator judges the house without the body.
"""

from collections.abc import Collection, Container, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from solver.answers import Conflict, Issue
from solver.placement import Budget
from solver.repair import RepairSettings, all_bodies, seated_along, without
from solver.scene import EXTERIOR, Room, Scene
from solver.scene_bodies import people_in
from solver.validator import FINDING_WORK, Checked

ROOM_WORK, BODY_WORK, WALKED_WORK = 15.0, 10.0, 2.0
"""What each room counts, each body of a room that changed, and each that is walked past anew; measured."""


def judged_again(house: Checked, scene: Scene, changed: Collection[str], budget: Budget) -> Checked:
    """Returns a house of which nothing but the bodies of some rooms, given by their ids, and people changed, with its issues.

    What is found wrong in the rooms that changed counts as it does anywhere: so a heap is judged less often, not refused.
    """
    bodies = {room.id: len(all_bodies(room)) for room in scene.rooms}
    own = sum(bodies[name] for name in changed)
    budget.left -= ROOM_WORK * len(bodies) + BODY_WORK * own + WALKED_WORK * sum(bodies.values())
    after = house.after(scene)
    budget.left -= FINDING_WORK * sum(len(case.judged.findings) for case in after.cases if case.room.room.id in changed)
    return after


def is_shut_by_itself(house: Checked, room: Room, budget: Budget) -> bool:
    """Tells whether nobody can come into a room of a house even where it is empty."""
    if all(issue.ids or issue.room != room.id for issue in house.errors):
        return False
    rooms = tuple(replace(one, furniture=(), decorations=()) if one.id == room.id else one for one in house.scene.rooms)
    return any(issue.room == room.id for issue in judged_again(house, replace(house.scene, rooms=rooms), (room.id,), budget).errors)


WAYS_IN = ("door", "passage", "garage_door")
"""Openings that lead into a room."""

WAITING = " as long as other conflicts last: "
"""What is said of a body whose error may end with other conflicts, between what it is and why."""
LEAVING_WORK = 200_000.0
"""Work that judging the house without one body and another may cost, in QPs of a small room, also where a call's searches spent theirs."""


def unexplained(house: Checked, conflicts: Sequence[Conflict], settings: RepairSettings) -> tuple[Conflict, ...]:
    """Names every error that is left and that no conflict explains.

    A room that no door leads into is said to be that. Of another that nobody can come to nothing is said where a conflict explains it:
    in the room, or elsewhere in the house; nor of what only somebody without a free place keeps out of reach.
    """
    left = _LeftOver(house, conflicts, settings, Budget(LEAVING_WORK, is_known=True))
    named = [(issue.room, conflict) for issue in _each_reason_once(house) if (conflict := left.named(issue)) is not None]
    return _waiting_together(named)


def _waiting_together(named: Sequence[tuple[str | None, Conflict]]) -> tuple[Conflict, ...]:
    """Returns conflicts, those of a room that last as long as others do, and are helped alike, as one that names all bodies."""
    told: dict[tuple[object, ...], list[Conflict]] = {}
    for number, (room, conflict) in enumerate(named):
        words, waits, _ = conflict.message.partition(WAITING)
        told.setdefault((room, words, str(conflict.repairs)) if waits else (number,), []).append(conflict)
    return tuple(_of_all(alike) if len(alike) > 1 else alike[0] for alike in told.values())


def _of_all(conflicts: Sequence[Conflict]) -> Conflict:
    ids = tuple(dict.fromkeys(label for one in conflicts for label in one.ids))
    words = conflicts[0].message.partition(WAITING)[0]
    return replace(conflicts[0], ids=ids, message=f"{words}{WAITING}{', '.join(ids)}")


def _each_reason_once(house: Checked) -> list[Issue]:
    """Returns a house's errors; of rooms that nobody can come to for the same reason the first, with the names of all in its message."""
    told: dict[tuple[str, ...], list[Issue]] = {}
    for number, issue in enumerate(house.errors):
        apart = _has_no_way_in(house.scene, issue.room) or _entry_apart_from(house.scene, issue)
        shut = issue.rule == "unreachable" and not issue.ids and not apart
        before, _, after = issue.message.partition(f" to {issue.room}")
        told.setdefault((before, after) if shut and (after or before != issue.message) else (str(number),), []).append(issue)
    return [
        replace(first, message=f"{reason[0]} to {', '.join(str(issue.room) for issue in (first, *others))}{reason[1]}") if others else first
        for reason, (first, *others) in told.items()
    ]


@dataclass(frozen=True)
class _LeftOver:
    house: Checked
    conflicts: Sequence[Conflict]
    settings: RepairSettings
    budget: Budget

    def named(self, issue: Issue) -> Conflict | None:
        """Returns an issue's conflict; None where another one explains it."""
        here = self._by_room.get(issue.room or "", ())
        if not issue.ids and _has_no_way_in(self.house.scene, issue.room):
            return Conflict((), f"{issue.room} has no way in: no door or passage leads into it")
        if not issue.ids and (entry := _entry_apart_from(self.house.scene, issue)):
            return Conflict((), f"{issue.room} has no way in from {entry}: no doors or passages join them")
        if not issue.ids and self.conflicts and (issue.rule, issue.room) not in self._lasting:
            return None
        if self._explained.intersection(issue.ids) or (issue.ids and self._waiting.issuperset(issue.ids)):
            return None
        if issue.rule == "unreachable" and any(self._people.issuperset(conflict.ids) for conflict in here):
            return None
        here = here or self._reaching_in(issue)
        if issue.ids and here and (issue.rule == "unreachable" or not self._locked.issuperset(issue.ids)):
            self._waiting.update(issue.ids)
            missing = "out of reach" if issue.rule == "unreachable" else "no repair"
            words = f"not found: {missing}{WAITING}{issue.message}"
            return Conflict(issue.ids, words, here[0].repairs if len(here) == 1 else ())
        helping = [one for one in issue.ids if self._is_due_to(one, issue)] if all(conflict.repairs for conflict in here) else ()
        return Conflict(issue.ids, self._why(issue), tuple({"action": "leave_out", "id": one} for one in helping))

    def _reaching_in(self, issue: Issue) -> Sequence[Conflict]:
        """Returns the conflicts about a body that leaves its own room and shuts a way in this one."""
        if issue.rule != "unreachable":
            return ()
        outside = {label for other in self.house.errors if other.rule == "out_of_bounds" for label in other.ids}
        members = dict.fromkeys(label for conflict in self.conflicts for label in conflict.ids)
        shuts = {label for label in members if label in outside and self._is_due_to(label, issue)}
        return [conflict for conflict in self.conflicts if shuts.intersection(conflict.ids)]

    def _is_due_to(self, label: str, issue: Issue) -> bool:
        """Tells whether an error ends where a body is left out."""
        if label not in self._left_without:
            trial = _house_without(self.house, label, self.budget)
            self._left_without[label] = None if trial is None else frozenset((other.rule, other.ids) for other in trial.errors)
        left = self._left_without[label]
        return left is not None and (issue.rule, issue.ids) not in left

    def _why(self, issue: Issue) -> str:
        if issue.ids and self._locked.issuperset(issue.ids):
            return f"locked where it cannot stand: {issue.message}"
        if issue.rule == "unreachable" and issue.ids:
            return f"not found: it can stand, but no way was found to reach it: {issue.message}"
        return f"not found: no repair for this: {issue.message}"

    @cached_property
    def _left_without(self) -> dict[str, frozenset[tuple[str, tuple[str, ...]]] | None]:
        """The rules, and whose they are, of the errors without each body that was tried; None where the budget was spent."""
        return {}

    @cached_property
    def _lasting(self) -> frozenset[tuple[str, str | None]]:
        """Which errors of no body's own last in the house without any body."""
        return _without_bodies(self.house, self.budget)

    @cached_property
    def _waiting(self) -> set[str]:
        """The bodies of which it was said that they are wrong as long as other conflicts last: of each once."""
        return set()

    @cached_property
    def _explained(self) -> frozenset[str]:
        return frozenset(label for conflict in self.conflicts for label in conflict.ids)

    @cached_property
    def _people(self) -> frozenset[str]:
        return frozenset(person.id for person in self.house.scene.dynamic)

    @cached_property
    def _locked(self) -> frozenset[str]:
        bodies = (body for room in self.house.scene.rooms for body in all_bodies(room))
        return self.settings.locked.union(body.id for body in bodies if self.settings.is_locked(body))

    @cached_property
    def _by_room(self) -> Mapping[str, Sequence[Conflict]]:
        """The conflicts by the id of the room that a member is in."""
        found: dict[str, list[Conflict]] = {}
        for room in self.house.scene.rooms:
            inside = _ids_in(self.house.scene, room)
            found[room.id] = [conflict for conflict in self.conflicts if inside.intersection(conflict.ids)]
        return found


def _ids_in(scene: Scene, room: Room) -> set[str]:
    return {body.id for body in (*all_bodies(room), *people_in(scene, room))}


def _has_no_way_in(scene: Scene, name: str | None) -> bool:
    """Tells whether no opening of a room, or of another into it, lets anybody in."""
    leading = {label for room in scene.rooms for one in room.openings if one.kind in WAYS_IN for label in (room.id, one.connects_to)}
    return name is not None and len(scene.rooms) > 1 and name not in leading


def _entry_apart_from(scene: Scene, issue: Issue) -> str | None:
    """Returns the room that one comes in by, where no openings, from room to room, join the room out of reach to any such; else None."""
    ways = [(room.id, one) for room in scene.rooms for one in room.openings if one.kind in WAYS_IN]
    outer = [room for room, one in ways if one.main_entrance]
    outer = outer or [room for room, one in ways if one.connects_to == EXTERIOR]
    joined = {(room, one.connects_to or room) for room, one in ways}
    reached = set(outer)
    while more := {two for a, b in joined for one, two in ((a, b), (b, a)) if one in reached and two != EXTERIOR} - reached:
        reached |= more
    return outer[0] if outer and issue.rule == "unreachable" and issue.room is not None and issue.room not in reached else None


def _house_without(house: Checked, label: str, budget: Budget) -> Checked | None:
    """Returns the house without a body and all that it carries; who sat there stands up. None where the budget is spent."""
    if budget.spent:
        return None
    scene = house.scene
    held = {room.id: without(room, (label,)) for room in scene.rooms if label in _ids_in(scene, room)}
    after = tuple(held.get(room.id, room) for room in scene.rooms)
    people = tuple(person for person in scene.dynamic if person.id != label)
    return judged_again(house, replace(scene, rooms=after, dynamic=seated_along(people, scene.rooms, after)), held, budget)


def cleaned(house: Checked, settings: RepairSettings) -> tuple[Checked, list[Conflict]]:
    """Takes bodies out, one at a time and the least important first, as long as that leaves less broken.

    Returns the house, and for each body that is gone the rule that it broke.
    """
    reasons, budget = list[Conflict](), Budget(LEAVING_WORK, is_known=True)
    lasting = _without_bodies(house, budget)
    while house.errors:
        better = _lighter(house, lasting, settings, budget)
        if better is None:
            break
        issue, label, house = better
        reasons.append(Conflict((label,), issue.message, ({"action": "leave_out", "id": label},)))
    return house, reasons


def _without_bodies(house: Checked, budget: Budget) -> frozenset[tuple[str, str | None]]:
    """Returns which errors of no body's own last in the house without any body: rule and room of each."""
    if all(issue.ids for issue in house.errors) or budget.spent:
        return frozenset()
    bare = tuple(replace(room, furniture=(), decorations=()) for room in house.scene.rooms)
    errors = judged_again(house, replace(house.scene, rooms=bare, dynamic=()), (), budget).errors
    return frozenset((issue.rule, issue.room) for issue in errors if not issue.ids)


def _breaches(house: Checked) -> tuple[int, int]:
    """Returns how much is broken, less being better: a room that nobody can enter hides what nobody can reach in it."""
    return sum(not issue.ids for issue in house.errors), len(house.errors)


def _lighter(
    house: Checked, lasting: Container[tuple[str, str | None]], settings: RepairSettings, budget: Budget
) -> tuple[Issue, str, Checked] | None:
    """Returns a house with less broken, with who is left out for it and the issue that is gone; nobody is for what is lasting."""
    order = {label: k for k, label in enumerate(_by_importance(house.scene, settings))}
    broken_by = {label: issue for issue in reversed(house.errors) for label in issue.ids}
    open_ways = [issue for issue in house.errors if not issue.ids and (issue.rule, issue.room) not in lasting]
    if not broken_by and open_ways:
        broken_by = dict.fromkeys(order, open_ways[0])
    before = _breaches(house)
    for label, issue in sorted(broken_by.items(), key=lambda pair: order.get(pair[0], len(order))):
        trial = _house_without(house, label, budget)
        if trial and _breaches(trial) < before:
            return issue, label, trial
    return None


def _by_importance(scene: Scene, settings: RepairSettings) -> list[str]:
    """Returns the ids of all bodies, the least important first: people, then loose before locked, wished before required, small ones."""
    people = [person.id for person in scene.dynamic if person.id not in settings.locked]
    bodies = [body for room in scene.rooms for body in all_bodies(room)]
    bodies.sort(key=lambda body: (settings.is_locked(body), body.name in settings.required_names, body.width * body.depth, body.id))
    return [*people, *(body.id for body in bodies)]
