"""How far fronts open, as the rule finds it."""

from __future__ import annotations

from catalogs import Catalogs
from solver.scene import Scene
from solver.validator.kinds import kinds_of
from solver.validator.opening import FrontTravel, travels_of
from solver.validator.sent_rooms import room_bytes
from solver.validator.world import world_of


def front_travels(scene: Scene, catalogs: Catalogs) -> dict[str, list[FrontTravel]]:
    """The fronts of a scene, by room."""
    world, kinds = world_of(scene), kinds_of(catalogs)
    return {place.room.id: travels_of(world, place, kinds, room_bytes(world, place, kinds)) for place in world.places}
