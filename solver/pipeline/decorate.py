"""Furnished rooms of a scene -> the same rooms decorated."""

from __future__ import annotations

from collections.abc import Callable, Container
from dataclasses import replace

from catalogs import Catalogs
from solver.body_rows import count_decorations
from solver.decorations import BareRoom, DecorationSettings, decorated_rooms
from solver.pieces import Space
from solver.pipeline.accessible import floors_asked_for
from solver.pipeline.room_spaces import spaces_in
from solver.records import changed
from solver.scene import Room, Scene
from solver.scene_bodies import storey_height
from solver.streams import Stream


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
