"""Hand-made rooms and catalogs, and where an alternative would put a piece, by trigonometry of its own."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from catalogs.schema import Catalogs, FlooringSpec, FurnitureSpec, RoomType
from solver.furnish import space_of, wanted_pieces
from solver.pieces import Candidate, Piece, Space
from solver.scene import Opening, Room
from solver.streams import Stream

Box = tuple[float, float, float, float]
"""west, north, east, south, mm."""
KINDS: dict[str, dict[str, Any]] = {
    "shelf": {"size": (1.0, 0.3, 1.8), "stands": "wall", "use": {"sides": ("front",)}},
    "couch": {"size": (2.0, 0.9, 0.8), "stands": "wall", "use": {"sides": ("front",)},
              "surfaces": ({"name": "seat", "height": 0.45},)},
    "short_couch": {"name": "couch", "size": (1.4, 0.8, 0.8), "stands": "wall", "use": {"sides": ("front",)}},
    "table": {"size": (1.6, 0.8, 0.7), "stands": "free", "surfaces": ({"name": "top", "height": 0.7},)},
    "chair": {"size": (0.4, 0.6, 0.8), "stands": "free", "use": {"sides": ("front",)}},
    "pot": {"size": (0.4, 0.4, 1.0), "stands": "free"},
    "box": {"size": (0.4, 0.2, 0.2), "stands": "free"},
    "wagon": {"size": (1.8, 4.0, 1.5), "stands": "free", "use": {"sides": ("left", "right")}},
}  # fmt: skip


def catalog(pieces: Sequence[dict[str, Any]]) -> Catalogs:
    """Returns a catalog of one room type, `den`, that holds these pieces."""
    common = {"category": "misc", "color": "#808080", "mass": 10}
    furniture = {kind: FurnitureSpec.model_validate({**common, **entry}) for kind, entry in KINDS.items()}
    den = RoomType.model_validate(
        {"area": {"min": (4, 4), "typical": 12, "max": 60}, "flooring": "wood", "accent": "#808080", "pieces": list(pieces)}
    )
    return Catalogs(furniture=furniture, floorings={"wood": FlooringSpec(color="#808080")}, rooms={"den": den}, fingerprint="0")


DOOR = Opening("door_1", "door", "south", 2.5, 0.9, connects_to="hall")
WINDOW = Opening("window_1", "window", "north", 1.5, 1.2, 1.4, 0.9)


def den(*openings: Opening, width: float = 5.0, depth: float = 4.0) -> Room:
    """Returns a den with wall lines 5 x 4 m: its clear floor is [50, 4950] x [50, 3950] mm."""
    return Room("den_0", 0, "den", width=width, depth=depth, openings=openings)


def ask(room: Room, *pieces: dict[str, Any], seed: int = 1) -> tuple[Piece, ...]:
    """Returns what the room wants of these pieces."""
    return wanted_pieces(room, space_of(room, 0.1), catalog(pieces), Stream(seed, "furnish", 0))


def piece(kind: str, *rules: dict[str, Any], **more: Any) -> dict[str, Any]:
    """Returns a piece called by its kind, with these rules."""
    return {"piece": kind, "rules": list(rules), **more}


def box_of(alternative: Candidate, parent: tuple[float, float, float] | None = None, at: tuple[float, float] = (0.5, 0.5)) -> Box:
    """Returns the footprint of an alternative; `parent` is the pose (x, z, rotation) of what it is attached to.

    `at` tells where in its slot's intervals it stands, from 0 to 1.
    """
    x, z, turn = float(alternative.anchor_mm[0]), float(alternative.anchor_mm[1]), alternative.rotation
    attach = alternative.attach
    if attach is not None and parent is not None:
        across = attach.across_mm[0] + at[0] * (attach.across_mm[1] - attach.across_mm[0])
        along = attach.along_mm[0] + at[1] * (attach.along_mm[1] - attach.along_mm[0])
        angle = math.radians(parent[2])
        # Counter-clockwise seen from above with z south: the front (0, 1) turns to the east (1, 0) at 90 degrees.
        x = parent[0] + across * math.cos(angle) + along * math.sin(angle)
        z = parent[1] - across * math.sin(angle) + along * math.cos(angle)
        turn += round(parent[2])
    width, depth = alternative.size_mm[:2]
    if turn % 180:
        width, depth = depth, width
    return (x - width / 2, z - depth / 2, x + width / 2, z + depth / 2)


def front_of(rotation: float) -> tuple[int, int]:
    """Returns the unit vector (x, z) of a front: 0 faces south, 90 east, 180 north, 270 west."""
    return round(math.sin(math.radians(rotation))), round(math.cos(math.radians(rotation)))


def gap(a: Box, b: Box) -> float:
    """Returns the free space between two boxes along the axis that parts them, mm; negative where they overlap."""
    return max(b[0] - a[2], a[0] - b[2], b[1] - a[3], a[1] - b[3])


def cheapest(wanted: Piece) -> Candidate:
    """Returns the alternative that costs least."""
    return min(wanted.candidates, key=lambda alternative: alternative.cost)


def clear_of_zones(space: Space, alternative: Candidate) -> bool:
    """Tells whether an alternative at its anchor lies in the clear rectangle and out of the zones that concern it."""
    west, north, east, south = box_of(alternative)
    clear = space.clear
    if west < clear.x0 or north < clear.z0 or east > clear.x1 or south > clear.z1:
        return False
    top = alternative.bottom_mm + alternative.size_mm[2]
    return not any(
        west < zone.rect.x1 and zone.rect.x0 < east and north < zone.rect.z1 and zone.rect.z0 < south and top > zone.above_mm
        for zone in space.zones
    )
