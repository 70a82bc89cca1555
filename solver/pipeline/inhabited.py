"""Rooms of a scene decorated, and peopled by whom its home has, in nobody's way; and what of a home's rooms others ask for.

A table to eat at stands once in a home: a room that asks wants a piece where no other room holds such.
"""

from collections.abc import Callable, Collection, Container, Iterable, Mapping, Sequence
from dataclasses import replace

from catalogs import Catalogs
from solver.body_rows import count_decorations
from solver.decorations import BareRoom, DecorationSettings, decorated_rooms
from solver.furnished import names_placed
from solver.people import Household, peopled
from solver.pieces import Arrangement, Space
from solver.pipeline.accessible import access_in, floors_asked_for
from solver.pipeline.room_spaces import spaces_in
from solver.records import changed
from solver.scene import Dynamic, Room, Scene
from solver.scene_bodies import counted, storey_height
from solver.streams import Stream


def needed(room: Room, catalogs: Catalogs) -> set[str]:
    """Returns the labels of what a room wants where no other room has such: the table that stands nowhere else, not each chair at it."""
    kind = catalogs.rooms.get(room.type)
    return {f"{name}_1" for piece in kind.pieces for name in piece.unless_elsewhere} if kind else set()


def held(rooms: Iterable[Room], catalogs: Catalogs) -> set[str]:
    """Returns the names of all pieces in rooms that do not ask themselves."""
    return {piece.name for room in parted(rooms, catalogs)[0] for piece in room.furniture}


def arranged(arrangements: Mapping[str, Arrangement], catalogs: Catalogs) -> set[str]:
    """Returns the names of all pieces of some arrangements."""
    return {name for one in arrangements.values() for name in names_placed(one, catalogs)}


def parted(rooms: Iterable[Room], catalogs: Catalogs) -> tuple[list[Room], list[Room]]:
    """Returns the rooms that are furnished first, and those that ask what stands in them."""
    asking, parts = catalogs.asking_types(), (list[Room](), list[Room]())
    for room in rooms:
        parts[room.type in asking].append(room)
    return parts


def home_catalogs(scene: Scene, known: Catalogs, but: Collection[str] = ()) -> Catalogs:
    """Returns the catalogs as they are for a scene's home: planned for a programme or an area, or plain.

    `but` are ids of rooms whose furniture does not count.
    """
    request = scene.request or {}
    planned = request.get("program") is not None or request.get("area") is not None
    known, types = known.for_access(access_in(scene)), [room.type for room in scene.rooms]
    of_home = known.of_home(types, planned)
    return of_home.holding(held((room for room in scene.rooms if room.id not in but), of_home))


def inhabited(scene: Scene, rooms: Sequence[Room], household: Household, before: Sequence[Dynamic] | None = None) -> Scene:
    """Returns a scene with people and pets in some of its rooms; nobody comes where its request says so.

    `before` is who was in the house, where only these rooms are peopled anew; those elsewhere stay. None: all come anew.
    """
    if (scene.request or {}).get("people") is False:
        household = replace(household, catalogs=household.catalogs.model_copy(update={"people": {}}))
    people = peopled(rooms, household, before)
    return changed(scene, dynamic=people, certificate={**(scene.certificate or {}), "counts": counted(scene.rooms, people)})


def decorated(scene: Scene, rooms: Container[str], catalogs: Catalogs, seed: int, space_of: Callable[[Room], Space] | None = None) -> Scene:
    """Decorates the rooms of those ids anew if the scene's request asks for it, each from a stream of its own.

    The request names the style, too; what decorated the rooms before goes. `space_of` tells a room's space, where that is known.
    """
    asked = scene.request or {}
    wanted, style = asked.get("decorate") is True, asked.get("style")
    name = style if isinstance(style, str) else ""
    kept = floors_asked_for(scene, catalogs) if wanted else {}
    anew = [room for room in scene.rooms if room.id in rooms]
    if wanted:
        space = space_of or spaces_in(scene)
        done = dict[str, Room]()
        for level in sorted({room.level for room in anew}):
            settings = DecorationSettings(catalogs, catalogs.styles.get(name), name, storey_height(scene, level), kept)
            bare = (BareRoom(room, space(room), Stream(seed, "decorations", room.index)) for room in anew if room.level == level)
            done |= {room.id: room for room in decorated_rooms(bare, settings)}
    else:
        done = {room.id: replace(room, decorations=()) for room in anew if count_decorations(room)}
    return changed(scene, rooms=tuple(done.get(room.id, room) for room in scene.rooms))
