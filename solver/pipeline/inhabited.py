"""Rooms of a scene peopled: by whom its home has, in nobody's way."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from catalogs import Catalogs
from solver.people import Household, peopled
from solver.pipeline.accessible import access_in
from solver.pipeline.elsewhere import held
from solver.records import changed
from solver.scene import Dynamic, Room, Scene
from solver.scene_bodies import counted


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
