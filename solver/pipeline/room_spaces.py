"""The space that each room of a scene has, doors that the room beyond alone lists among it; and rooms as they are to be repaired.

Comes in: a scene. Goes out: what tells a room's space, `RoomProblem`s. May import: furnish, repair.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from solver.furnish import space_of
from solver.furnish.zones import bounds_of, outline_edges
from solver.pieces import Space
from solver.repair import RepairSettings, RoomProblem, Walls
from solver.scene import WALLS, Issue, Room, Scene, robot_width_of


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


def room_problem(scene: Scene, room: Room, errors: Iterable[Issue], settings: RepairSettings) -> RoomProblem:
    """Returns a room as it is to be repaired; `errors` are its own."""
    space = space_of(room, scene.wall_thickness, robot_width_of(scene), scene.rooms)
    lines = bounds_of(room)
    edges = outline_edges(room) or [(wall, lines.line(wall), *lines.along(wall)) for wall in WALLS]
    return RoomProblem(room, space, Walls(space.clear, space.clear.x0 - lines.x0, tuple(edges)), settings, tuple(errors))
