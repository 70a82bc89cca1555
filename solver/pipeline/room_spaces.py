"""The space that each room of a scene has, doors that the room beyond alone lists among it; and rooms as they are to be repaired."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from math import inf

from catalogs import Catalogs
from solver.answers import Issue
from solver.furnish import space_of
from solver.furnish.zones import bounds_of, outline_edges
from solver.pieces import Doorway, Space, Walked
from solver.placement import with_joined_doors
from solver.repair import RepairSettings, RoomProblem, Walls
from solver.scene import EXTERIOR, WALLS, Room, Scene, robot_width_of
from solver.scene_bodies import said_height
from solver.streams import Stream


def spaces_in(scene: Scene) -> Callable[[Room], Space]:
    """Returns what tells the space of a scene's room."""
    listed = {(opening.id, room.id) for room in scene.rooms for opening in room.openings}
    beyond: dict[str, dict[str, Room]] = {}
    for room in scene.rooms:
        for opening in room.openings:
            if opening.connects_to and (opening.id, opening.connects_to) not in listed:
                beyond.setdefault(opening.connects_to, {})[room.id] = room
    robot_width = robot_width_of(scene)

    def space(room: Room) -> Space:
        return as_joined(room, space_of(room, scene.wall_thickness, robot_width, tuple(beyond.get(room.id, {}).values())), scene.rooms)

    return space


def as_joined(room: Room, space: Space, rooms: Sequence[Room]) -> Space:
    """Returns a room's space with those doors to be joined that its empty floor joins: those to which the others lead."""
    return with_joined_doors(space, _led_to(room, rooms)) if room.outline and len(space.doorways) > 1 else space


def _led_to(room: Room, rooms: Sequence[Room]) -> set[str]:
    """Returns the ids of the doors that one comes to from a storey's entrances without walking through a room."""
    ends: dict[str, set[str]] = {}
    for one in rooms:
        for opening in one.openings:
            if one.level == room.level and opening.kind != "window":
                ends.setdefault(opening.id, set()).update({one.id, opening.connects_to or EXTERIOR} - {room.id, EXTERIOR})
    found, more = set[str](), {name for level, name in entrances_of(rooms) if level == room.level}
    while more:
        found |= more
        inside = {name for door in more for name in ends[door]}
        more = {door for door, either in ends.items() if not either.isdisjoint(inside)} - found
    return found


def entrances_of(rooms: Iterable[Room]) -> set[tuple[int, str]]:
    """Returns level and id of each storey's main entrance; where it has none, of all its doors to the outside."""
    ways = [(room.level, one) for room in rooms for one in room.openings if one.kind != "window"]
    main = {(level, one.id) for level, one in ways if one.main_entrance}
    with_main = {level for level, _ in main}
    return main | {(level, one.id) for level, one in ways if one.connects_to == EXTERIOR and level not in with_main}


def as_walked_in(scene: Scene) -> Callable[[RoomProblem], RoomProblem]:
    """Returns what leaves in a room's problem the doors that the rule `unreachable` asks for.

    One comes in by one of the storey's entrances, whichever. What else leads outside, or to no room of the storey, need not be come to.
    """
    levels, entrances = {room.id: room.level for room in scene.rooms}, entrances_of(scene.rooms)

    def use(door: Doorway, level: int) -> Walked:
        if (level, door.id) in entrances:
            return "in"
        return "through" if levels.get(door.connects_to) == level else "not"

    def walked(problem: RoomProblem) -> RoomProblem:
        doorways = (door._replace(walked=use(door, problem.room.level)) for door in problem.space.doorways)
        return replace(problem, space=replace(problem.space, doorways=tuple(doorways)))

    return walked


def room_problem(scene: Scene, room: Room, errors: Iterable[Issue], settings: RepairSettings) -> RoomProblem:
    """Returns a room as it is to be repaired; `errors` are its own."""
    space = space_of(room, scene.wall_thickness, robot_width_of(scene), scene.rooms)
    lines = bounds_of(room)
    edges = outline_edges(room) or [(wall, lines.line(wall), *lines.along(wall)) for wall in WALLS]
    said = None if room.outdoor else said_height(scene, room.level)
    walls = Walls(space.clear, space.clear.x0 - lines.x0, tuple(edges))
    return RoomProblem(room, space, walls, settings, tuple(errors), inf if said is None else said)


def cover_mm2(room: Room, catalogs: Catalogs, seed: int) -> int:
    """Draws how much of a room's floor its furniture shall cover at least, mm2; 0 where its type does not say."""
    room_type = catalogs.rooms.get(room.type)
    if room_type is None or room_type.cover is None:
        return 0
    share = Stream(seed, "cover", room.index).uniform(*room_type.cover)
    return round((1e6 * room.floor_m2 if room.outline else 1e6 * room.width * room.depth) * share)
