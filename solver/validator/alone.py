"""A room by itself as the core's rules read it, so that it can be judged again and again with its bodies elsewhere."""

from dataclasses import dataclass

from catalogs import Catalogs
from solver.scene import Scene
from solver.validator.kinds import kinds_of
from solver.validator.sent_rooms import NumberedKinds, room_bytes
from solver.validator.walk import judged_storey
from solver.validator.world import AnyBody, world_of


@dataclass(frozen=True)
class RoomAlone:
    """A room as a storey of its own: its rows as the core reads it, and furniture, small things, people in their order."""

    rows: bytes
    bodies: tuple[AnyBody, ...]


def room_alone(scene: Scene, catalogs: Catalogs) -> RoomAlone:
    """Returns the one room of a scene."""
    world, kinds = world_of(scene), NumberedKinds(kinds_of(catalogs))
    (place,) = world.places
    walk, _ = judged_storey(world, [(place, room_bytes(world, place, kinds))], kinds)
    return RoomAlone(walk.rows, place.bodies)
