"""People and pets of a furnished scene -> those who are covered placed anew.

Comes in: a scene and what the validator says of it. Goes out: its people, conflicts, removals. Not here: where there is a
free place (repair).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from solver.pipeline.attempt import Terms
from solver.pipeline.concerned import concerned
from solver.repair import in_the_way, placed_people
from solver.scene import Conflict, Dynamic, Issue, Scene
from solver.wanted import Space


@dataclass(frozen=True)
class People:
    """The answer for the people of a scene."""

    people: tuple[Dynamic, ...]
    conflicts: tuple[Conflict, ...] = ()
    removed: tuple[Mapping[str, str], ...] = ()


def mend_people(scene: Scene, spaces: Mapping[str, Space], terms: Terms, issues: Sequence[Issue]) -> People:
    """Moves people and pets who break a rule, or keep others from something, to the nearest free place in their room.

    Args:
        scene: its furniture repaired.
        spaces: of each room.
        terms: who is locked, and what becomes of whom there is no place for.
        issues: what the validator says of the scene.
    """
    covered = _covered(scene, terms, issues)
    unreached = [issue for issue in issues if issue.rule == "unreachable" and terms.wishes.uses]
    closed = concerned(scene, unreached)
    after = {person.id: person for person in scene.dynamic}
    stuck: dict[str, str] = {}
    for room in scene.rooms:
        here = [person for person in scene.dynamic if person.room in (room.id, None if len(scene.rooms) == 1 else room.id)]
        moving = covered & {person.id for person in here}
        if here and room.id in closed:
            staying = [person for person in here if person.id not in moving]
            moving |= in_the_way(staying, room, spaces[room.id], terms.wishes.uses) - terms.wishes.locked
        if moving:
            crowd = placed_people(here, room, spaces[room.id], moving, terms.wishes.uses)
            after |= {person.id: person for person in crowd.people}
            stuck |= {label: f"{label} finds no free place in {room.id}" for label in crowd.stuck}
    conflicts = tuple(Conflict((label,), message, ({"action": "leave_out", "id": label},)) for label, message in stuck.items())
    gone = stuck if terms.on_conflict == "remove" else {}
    kept = tuple(after[person.id] for person in scene.dynamic if person.id not in gone)
    return People(kept, conflicts, tuple({"id": label, "reason": message} for label, message in gone.items()))


def _covered(scene: Scene, terms: Terms, issues: Sequence[Issue]) -> set[str]:
    """Returns who has to move: who breaks a rule alone, and of two left in one place the later, unless that one is locked."""
    rank = {person.id: k for k, person in enumerate(scene.dynamic)}
    broken = [[label for label in issue.ids if label in rank] for issue in issues if issue.severity == "error"]
    found: set[str] = set()
    for people in sorted(broken, key=len):
        free = [label for label in people if label not in terms.wishes.locked]
        if free and not found & set(people):
            found.add(max(free, key=lambda label: rank[label]))
    return found
