"""Small hand-made worlds for the rules: a room of 4 x 4 m or a house of them, a piece or two, catalogs of a few kinds."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from catalogs import Catalogs
from catalogs.entries import Use
from catalogs.schema import Area, FurnitureSpec, PieceSpec, RoomType, Variant
from solver.answers import Issue
from solver.scene import Furniture, Opening, Room, Scene
from solver.validator import validate

SIDE = 4.0
TURNED = {"north": 0, "west": 90, "south": 180, "east": 270}
"""The rotation of a piece with its back to a wall."""
WALLS = tuple(TURNED)


def kind(**more: Any) -> FurnitureSpec:
    values: dict[str, Any] = {"category": "misc", "size": (1.0, 1.0, 1.0), "color": "#000000", "mass": 1.0, "stands": "free", **more}
    return FurnitureSpec(**values)


def room_type(requires: Iterable[dict[str, int]] = (), pieces: Iterable[PieceSpec] = ()) -> RoomType:
    area = Area(min=(1.0, 1.0), typical=10.0, max=20.0)
    return RoomType(area=area, flooring="wood", accent="#000000", requires=tuple(requires), pieces=tuple(pieces))


SLEEPING = (Variant(kind="bed"), Variant(kind="single_bed"))
CATALOGS = Catalogs(
    furniture={
        "sofa": kind(use=Use(sides=("front",))),
        "bed": kind(use=Use(sides=("left", "right"))),
        "wide_bed": kind(name="bed"),
        "stove": kind(use=Use(sides=("front", "left"), need="all")),
        "corner_desk": kind(name="desk", use=Use(sides=("right",))),
        "crate": kind(),
    },
    floorings={},
    rooms={
        "bedroom": room_type([{"bed": 1, "single_bed": 1}], [PieceSpec(piece="sleep", kinds=SLEEPING)]),
        "dining_room": room_type([{"table": 1}, {"dining_chair": 2}]),
    },
    fingerprint="0" * 12,
)


def piece(x: float, z: float, width: float = 1.0, depth: float = 1.0, **more: Any) -> Furniture:
    values: dict[str, Any] = {"id": "crate_1", "name": "crate", "height": 1.0, **more}
    return Furniture(x=x, z=z, width=width, depth=depth, **values)


def opening(wall: str | None = "north", position: float = 2.0, **more: Any) -> Opening:
    values: dict[str, Any] = {"id": "door_1", **more}
    return Opening(wall=wall, position=position, **values)


def room(*furniture: Furniture, **more: Any) -> Room:
    values: dict[str, Any] = {"id": "room_0", "width": SIDE, "depth": SIDE, **more}
    return Room(furniture=tuple(furniture), **values)


def scene(*rooms: Room, **more: Any) -> Scene:
    return Scene(rooms=rooms, **more)


def issues(document: Scene, rule: str) -> list[Issue]:
    """What a rule says of a scene."""
    return [issue for issue in validate(document, CATALOGS) if issue.rule == rule]


def along(wall: str, position: float, distance: float) -> tuple[float, float]:
    """The point at a position along a wall of the 4 x 4 m room, so far from its line."""
    return {
        "north": (position, distance),
        "south": (position, SIDE - distance),
        "west": (distance, position),
        "east": (SIDE - distance, position),
    }[wall]
