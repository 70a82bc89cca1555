"""Issues of a scene -> the rooms that a repair has to look at.

Comes in: a scene, what the validator says of it. Goes out: ids of rooms. May import: scene.
"""

from __future__ import annotations

from collections.abc import Sequence

from solver.scene import Issue, Scene


def concerned(scene: Scene, issues: Sequence[Issue]) -> set[str | None]:
    """Returns the rooms that break a rule, and those next to rooms that nobody can enter: the way there may end in them."""
    closed = {issue.room for issue in issues if issue.rule == "unreachable" and not issue.ids}
    doors = [(room.id, opening.connects_to) for room in scene.rooms for opening in room.openings if opening.kind != "window"]
    leading = {room for door in doors for room, other in (door, door[::-1]) if other in closed}
    return {issue.room for issue in issues} | leading
