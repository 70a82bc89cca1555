"""A room by itself as the core's rules read it, so that it can be judged again and again with its bodies elsewhere."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from catalogs import Catalogs
from solver.scene import WALLS, Furniture, Scene
from solver.validator.kinds import Kinds, kinds_of
from solver.validator.sent_rooms import room_bytes
from solver.validator.walk import judged_storey
from solver.validator.world import AnyBody, side_of, world_of

_BIT: Final = {wall: 1 << number for number, wall in enumerate(WALLS)}


@dataclass(frozen=True)
class RoomAlone:
    """A room as a storey of its own: its rows as the core reads it, and furniture, small things, people in their order.

    `uses` are of each body the walls its use sides look to, as bits: of which one must be come to, and which all must.
    """

    rows: bytes
    bodies: tuple[AnyBody, ...]
    uses: tuple[tuple[int, int], ...]


def room_alone(scene: Scene, catalogs: Catalogs) -> RoomAlone:
    """Returns the one room of a scene."""
    world, kinds = world_of(scene), kinds_of(catalogs)
    (place,) = world.places
    walk, _ = judged_storey(world, [(place, room_bytes(world, place, kinds))])
    return RoomAlone(walk.rows, place.bodies, tuple(_use(body, kinds) for body in place.bodies))


def _use(body: AnyBody, kinds: Kinds) -> tuple[int, int]:
    if not isinstance(body, Furniture):
        return 0, 0
    use = kinds.use_of(("furniture", body.name, body.width, body.depth, body.height, body.kind))
    bits = sum({_BIT[side_of(body.rotation, side)] for side in use.sides}) if use else 0
    return (0, bits) if use and use.need == "all" else (bits, 0)
