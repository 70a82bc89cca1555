"""Questions about everything in a scene at once: how much there is, under which ids.

Comes in: a scene, or its rooms and people. Goes out: counts, ids. May import: scene, errors.
"""

from __future__ import annotations

from collections.abc import Sequence

from solver.dressed import count_decorations
from solver.errors import SceneError
from solver.scene import Dynamic, Room, Scene


def counted(rooms: Sequence[Room], people: Sequence[Dynamic]) -> dict[str, int]:
    """Returns how many there are in a house of everything that is counted; a door that two rooms list is one."""
    openings = {opening.id: opening.kind for room in rooms for opening in room.openings}
    windows = sum(kind == "window" for kind in openings.values())
    return {
        "rooms": len(rooms),
        "doors": len(openings) - windows,
        "windows": windows,
        "furniture": sum(len(room.furniture) for room in rooms),
        "decorations": sum(map(count_decorations, rooms)),
        "dynamic": len(people),
    }


def body_ids(scene: Scene) -> list[str]:
    """Returns the ids of all bodies of a scene: furniture and decorations room by room, then people and pets."""
    things = [[*(piece.id for piece in room.furniture), *(item.id for item in room.decorations)] for room in scene.rooms]
    return [*(name for names in things for name in names), *(person.id for person in scene.dynamic)]


def check_ids(field_name: str, wanted: Sequence[str], known: Sequence[str]) -> None:
    """Refuses ids that a scene does not have.

    Raises:
        SceneError: names the entry and some ids that would do.
    """
    have = set(known)
    for k, name in enumerate(wanted):
        if name not in have:
            shown = ", ".join(known[:12]) + (", ..." if len(known) > 12 else "")
            raise SceneError(f"{field_name}[{k}]", f"nothing in the scene has the id {name!r}", f"one of {shown}")
