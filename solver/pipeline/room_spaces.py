"""The space that each room of a scene has, doors that the room beyond alone lists among it.

Comes in: a scene. Goes out: what tells a room's space. May import: furnish.
"""

from __future__ import annotations

from collections.abc import Callable

from solver.furnish import space_of
from solver.pieces import Space
from solver.scene import Room, Scene, robot_width_of


def spaces_in(scene: Scene) -> Callable[[Room], Space]:
    """Returns what tells the space of a scene's room."""
    listed = {(opening.id, room.id) for room in scene.rooms for opening in room.openings}
    beyond: dict[str, dict[str, Room]] = {}
    for room in scene.rooms:
        for opening in room.openings:
            if opening.connects_to and (opening.id, opening.connects_to) not in listed:
                beyond.setdefault(opening.connects_to, {})[room.id] = room
    robot_width = robot_width_of(scene)
    return lambda room: space_of(room, scene.wall_thickness, robot_width, tuple(beyond.get(room.id, {}).values()))
