"""Furnished rooms of a scene -> the same rooms decorated.

Comes in: a Scene, which rooms. Goes out: the Scene; furniture stays as it is. May import: every stage.
"""

from __future__ import annotations

from collections.abc import Container
from dataclasses import replace

from catalogs import Catalogs
from solver.decorations import DecorationSettings, decorated_room
from solver.furnish import space_of
from solver.pipeline.accessible import floors_asked_for
from solver.scene import Room, Scene, robot_width_of
from solver.streams import Stream


def decorated(scene: Scene, rooms: Container[str], catalogs: Catalogs, seed: int) -> Scene:
    """Decorates the rooms of those ids anew if the scene's request asks for it, each from a stream of its own.

    Args:
        scene: furnished; its request also names the style.
        rooms: ids; what decorated them before goes.
        catalogs: what to decorate with.
        seed: decides.
    """
    asked = scene.request or {}
    wanted, style = asked.get("decorate") is True, asked.get("style")
    name = style if isinstance(style, str) else ""
    kept = floors_asked_for(scene, catalogs) if wanted else {}
    settings = DecorationSettings(catalogs, catalogs.styles.get(name), name, scene.size.height if scene.size else 2.8, kept)

    def done(room: Room) -> Room:
        if not wanted:
            return replace(room, decorations=()) if room.decorations else room
        space = space_of(room, scene.wall_thickness, robot_width_of(scene), scene.rooms)
        return decorated_room(room, space, settings, Stream(seed, "decorations", room.index))

    return replace(scene, rooms=tuple(done(room) if room.id in rooms else room for room in scene.rooms))
