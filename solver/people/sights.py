"""What a person who stands in a room looks at: seats, screens, worktops, windows and doors."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from catalogs import Catalogs
from solver.free_places import footprint
from solver.geometry import OPPOSITE, Rect, strip, to_mm, wall_faced
from solver.pieces import Space
from solver.scene import Dynamic, Furniture, Room

NEAR_MM: Final = 2000
"""How far from somebody what they look at may be: a person's length and a bit; our choice."""
FULLY: Final = math.cos(math.radians(40))
"""Somebody faces a thing when its middle and its nearest point both lie within this angle of their front: 45 degrees are asked
for, the rest is for whoever measures to another point of it."""
OPENINGS: Final = ("door", "garage_door", "window")
SCREEN: Final = "tv"
_kinds_by_name: Final = lru_cache(maxsize=64)(Catalogs.kinds_by_name)


@dataclass(frozen=True)
class Sight:
    """A rectangle to look at, mm (flat for an opening), and the wall that whoever looks at it has behind."""

    rect: Rect
    seen_from: str


def sights(room: Room, space: Space, catalogs: Catalogs) -> list[Sight]:
    """Returns what there is to look at: the room's furniture in its order, then its openings."""
    named = _kinds_by_name(catalogs)
    found = []
    for piece in room.furniture:
        kind = named.get(piece.name)
        is_worktop = kind is not None and kind.category == "table" and kind.use is not None
        if piece.category == "seating" or piece.name == SCREEN or is_worktop:
            found.append(Sight(footprint(piece), _open_side(piece)))
    return found + list(_openings(room, space))


def _open_side(piece: Furniture) -> str:
    """Returns the side a piece is looked at from: a chair at a table from behind, all else from the front."""
    return wall_faced("back" if piece.under else "front", piece.rotation)


def _openings(room: Room, space: Space) -> Iterator[Sight]:
    """Yields the openings of a rectangular room, and the doorways of any other."""
    if room.outline is not None:
        for door in space.doorways:
            yield Sight(door.square, OPPOSITE[door.wall])
        return
    for opening in room.openings:
        if opening.kind in OPENINGS and opening.wall is not None:
            middle, half = to_mm(opening.position), to_mm(opening.width) // 2
            yield Sight(strip(space.clear, opening.wall, (middle - half, middle + half), 0), OPPOSITE[opening.wall])


def faces(person: Dynamic, sight: Sight) -> bool:
    """Tells whether somebody's front is turned to a thing that is near."""
    x, z = person.x * 1000, person.z * 1000
    rect = sight.rect
    middle = ((rect.x0 + rect.x1) / 2 - x, (rect.z0 + rect.z1) / 2 - z)
    nearest = (min(max(x, rect.x0), rect.x1) - x, min(max(z, rect.z0), rect.z1) - z)
    angle = math.radians(person.rotation)
    front = (math.sin(angle), math.cos(angle))
    turned = all(front[0] * dx + front[1] * dz >= FULLY * math.hypot(dx, dz) > 0 for dx, dz in (middle, nearest))
    return turned and math.hypot(*nearest) <= NEAR_MM
