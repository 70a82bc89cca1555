"""The house JSON of ProcTHOR and AI2-THOR (`CreateHouse`), and what our own export adds under `compose`.

Its frame is left-handed: x east, y up, z north, m; yaw clockwise in degrees, 0 facing north. Rooms are drawn along wall lines.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from typing import Any, Final, NamedTuple

from solver.errors import FieldError
from solver.imports.drawn import (
    MOST_POINTS,
    MOST_ROOMS,
    DrawnLevel,
    DrawnOpening,
    DrawnPiece,
    DrawnPlan,
    DrawnRoom,
    OpeningKind,
    Spot,
    check_count,
)
from solver.imports.plain_values import a_list, a_number, a_text, an_object
from solver.scene import OPENING_KINDS

FRAME: Final = "doorframe"
"""An asset called so is a doorway without a leaf."""
DEEPEST: Final = 8
"""How deep things may lie on things."""
Json = Mapping[str, Any]


class _RoomStorey(NamedTuple):
    """The level of a room, and how high its floor lies, m."""

    level: int
    floor: float


GROUND: Final = _RoomStorey(0, 0.0)
"""Whose things are in no room that the file names."""


def read_procthor(document: Json) -> DrawnPlan:
    """Reads a house.

    Raises:
        FieldError: something in it cannot be read; names its place.
    """
    check_count("rooms", len(a_list(document["rooms"], "rooms")), MOST_ROOMS)
    rooms = tuple(_room(an_object(room, f"rooms[{at}]"), f"rooms[{at}]") for at, room in enumerate(document["rooms"]))
    walls = {}
    for at, wall in enumerate(a_list(document.get("walls", []), "walls")):
        walls[a_text(an_object(wall, f"walls[{at}]"), "id", f"walls[{at}]")] = (wall, f"walls[{at}]")
    levels = {room.id: room.level for room in rooms}
    openings = []
    for key in ("doors", "windows"):
        check_count(key, len(a_list(document.get(key, []), key)), MOST_POINTS)
        for at, one in enumerate(document.get(key, [])):
            openings.append(_opening(key == "windows", an_object(one, f"{key}[{at}]"), f"{key}[{at}]", walls, levels))
    storeys = {room.id: _RoomStorey(room.level, _floor(document, at)) for at, room in enumerate(rooms)}
    pieces = tuple(islice(_pieces(document.get("objects", []), "objects", (), storeys), MOST_POINTS + 1))
    said = an_object(document.get("metadata") or {}, "metadata").get("compose")
    thickness = a_number(an_object(said, "metadata.compose"), "wall_thickness", "metadata.compose", None) if said else None
    floors = {level: min(one.floor for one in storeys.values() if one.level == level) for level in sorted(set(levels.values()))}
    named = tuple(DrawnLevel(level, elevation=floor) for level, floor in floors.items()) if said else ()
    return DrawnPlan(rooms, tuple(openings), pieces=pieces, levels=named, wall_thickness=thickness)


def _ours(said: Json, where: str) -> Json:
    """Returns what our own export says beside the format's words."""
    return an_object(said.get("compose") or {}, f"{where}.compose")


def _spot(said: object, where: str) -> Spot:
    point = an_object(said, where)
    return a_number(point, "x", where), -a_number(point, "z", where)


def _room(said: Json, where: str) -> DrawnRoom:
    points = a_list(said.get("floorPolygon"), f"{where}.floorPolygon")
    check_count(f"{where}.floorPolygon", len(points), MOST_POINTS)
    spots = tuple(_spot(point, f"{where}.floorPolygon[{at}]") for at, point in enumerate(points))
    ours = _ours(said, where)
    kind, place = a_text(said, "roomType", where), f"{where}.compose.wall_thickness"
    outer = (a_number({"": one}, "", place, None) for one in a_list(ours.get("wall_thickness") or [], place))
    return DrawnRoom(
        spots, a_text(ours, "name", where) if ours else kind, where, a_text(ours, "type", where) or kind,
        round(a_number(ours, "level", where, 0.0)), bool(ours.get("outdoor")) if ours else None, a_text(said, "id", where),
        outer=tuple(outer),
    )  # fmt: skip


def _floor(document: Json, at: int) -> float:
    """Returns how high a room's floor lies, m."""
    where = f"rooms[{at}].floorPolygon[0]"
    return a_number(an_object(next(iter(document["rooms"][at]["floorPolygon"]), {}), where), "y", where, 0.0)


def _opening(is_window: bool, said: Json, where: str, walls: Mapping[str, tuple[Json, str]], levels: Mapping[str, int]) -> DrawnOpening:
    """Reads a door or window; its hole is counted from the first wall's first corner."""
    name = a_text(said, "wall0", where)
    if name not in walls:
        raise FieldError(f"{where}.wall0", f"is {name!r:.80}", "the id of a wall")
    wall, place = walls[name]
    corners = [_spot(corner, f"{place}.polygon") for corner in a_list(wall.get("polygon"), f"{place}.polygon")[:2]]
    if len(corners) < 2 or not math.dist(*corners):
        raise FieldError(f"{place}.polygon", "has no length", "four corners, the two at the floor first")
    (low, sill), (high, head) = _hole(said, where)
    (x0, z0), (x1, z1) = corners
    length = math.dist(*corners)
    way = ((x1 - x0) / length, (z1 - z0) / length)
    start, end = ((x0 + way[0] * at, z0 + way[1] * at) for at in (low, high))
    ours, rooms = _ours(said, where), (a_text(said, "room0", where), a_text(said, "room1", where))
    kind = _kind(said, where, is_window)
    main = bool(ours["main_entrance"]) if "main_entrance" in ours else None
    return DrawnOpening(
        kind, start, end, where, head - sill, sill, levels.get(rooms[0], 0), _hinge(ours, start, end), _towards(ours, start), main,
        rooms, a_text(said, "id", where) if ours else "",
    )  # fmt: skip


def _hole(said: Json, where: str) -> tuple[Spot, Spot]:
    """Returns a hole's lower and upper corner: along the wall, and above the floor."""
    if "holePolygon" in said:
        place = f"{where}.holePolygon"
        corners: list[Any] = list(a_list(said["holePolygon"], place))
    else:
        place = f"{where}.boundingBox"
        box = an_object(said.get("boundingBox"), place)
        corners = [box.get("min"), box.get("max")]
    points = [an_object(corner, place) for corner in corners]
    along, up = ([a_number(point, key, place) for point in points] for key in ("x", "y"))
    if len(points) < 2:
        raise FieldError(place, f"has {len(points)} corners", "two")
    return (min(along), min(up)), (max(along), max(up))


def _kind(said: Json, where: str, is_window: bool) -> OpeningKind:
    asset = a_text(said, "assetId", where)
    if is_window:
        return "window"
    if asset in OPENING_KINDS:
        return asset  # type: ignore[return-value]
    return "passage" if FRAME in asset.lower() else "door"


def _hinge(ours: Json, start: Spot, end: Spot) -> Any:
    """Returns the end that our export says carries the leaf: it counts from the west or north."""
    hinge = ours.get("hinge")
    if hinge not in ("start", "end"):
        return None
    return hinge if start <= end else "end" if hinge == "start" else "start"


def _towards(ours: Json, start: Spot) -> Spot | None:
    """Returns a point on the side that a leaf swings to, as our export says it."""
    side = ours.get("towards")
    if side not in (1, -1):
        return None
    return (start[0], start[1] + side) if ours.get("axis") == "x" else (start[0] + side, start[1])


def _pieces(
    objects: object, where: str, below: Sequence[DrawnPiece], storeys: Mapping[str, _RoomStorey], storey: _RoomStorey = GROUND
) -> Iterator[DrawnPiece]:
    """Yields things and what lies on them; `below` is what these lie on, the lowest first; what names no room is on the `storey`."""
    if len(below) > DEEPEST:
        raise FieldError(where, "lies too deep", f"at most {DEEPEST} things on each other")
    check_count(where, len(a_list(objects, where)), MOST_POINTS)
    for at, said in enumerate(a_list(objects, where)):
        place = f"{where}[{at}]"
        one = an_object(said, place)
        ours, position = _ours(one, place), an_object(one.get("position"), f"{place}.position")
        x, z = _spot(position, f"{place}.position")
        name, asset = a_text(one, "id", place), a_text(one, "assetId", place)
        size = _size(ours, place)
        yaw = a_number(an_object(one.get("rotation") or {}, f"{place}.rotation"), "y", f"{place}.rotation", 0.0)
        own = storeys.get(str(one.get("room")), storey)
        middle = a_number(position, "y", f"{place}.position", 0.0) - own.floor
        carrier = below[0] if below else None
        height = 2 * (middle - (carrier.height or 0.0 if carrier else 0.0))
        piece = DrawnPiece(
            a_text(ours, "name", place) or _called(name.split("|")[0], asset), x, z,
            middle - size[1] / 2 if size else 0.0, (180.0 - yaw) % 360,
            size and (size[0], size[2], size[1]), place, own.level, id=name if ours else "",
            decoration=ours.get("sort") == "decoration" if ours else bool(below), kind=asset if ours else None,
            height=max(0.0, round(height, 3)) if height > 0 or not below else None, middle=middle, on=carrier.where if carrier else "",
        )  # fmt: skip
        yield piece
        yield from _pieces(one.get("children") or [], f"{place}.children", (*below, piece), storeys, own)


def _called(name: str, asset: str) -> str:
    """Returns a name, with its words apart where its asset's name is the same and has them so."""
    return asset if asset.replace("_", "") == name else name


def _size(ours: Json, where: str) -> tuple[float, float, float] | None:
    if "size" not in ours:
        return None
    size = an_object(ours["size"], f"{where}.compose.size")
    x, y, z = (a_number(size, key, f"{where}.compose.size") for key in "xyz")
    return x, y, z
