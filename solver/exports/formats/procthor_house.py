"""ProcTHOR: a house as AI2-THOR's `CreateHouse` takes it, schema 1.0.0. Assets are named by our kinds, which its build does not hold.

AI2-THOR's frame is left-handed: x east, y up, z north, m; yaw clockwise from above in degrees, 0 facing north. An object's position is the
middle of its box, and its front is where ProcTHOR's assets have theirs, towards +z. What the schema has no word for stands under
`compose`, which its reader passes over.
"""

import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, Final, NamedTuple

from solver.exports.model import FloorPlate, HouseModel, ModelBody, PlacedOpening
from solver.exports.paints import PLAIN_WALL, srgb
from solver.exports.wall_bands import NEGLIGIBLE
from solver.exports.writers import ExportSettings, Files
from solver.geometry import ALONG_X, FloorRectangle, rectangles_of, walls_round

SCHEMA: Final = "1.0.0"
SOLID: Final = "PureWhite"
"""The material of AI2-THOR that takes a colour."""
CEILING: Final = "#f4f1ea"
EYES: Final = 0.95
"""Height of the agent's middle above the floor, m: where AI2-THOR can put it down."""
_ROOM_TYPES: Final = {"bedroom_master": "Bedroom", "kids_bedroom": "Bedroom"}
HouseJson = dict[str, Any]


class _WallSide(NamedTuple):
    """A piece of a room's outline with at most one opening in it: from `a` to `b` in the house, the room on the right."""

    room: FloorPlate
    a: tuple[float, float]
    b: tuple[float, float]
    opening: PlacedOpening | None

    @property
    def span(self) -> str:
        """Where it is in AI2-THOR's plan: the same for the two rooms that it parts."""
        (x0, x1), (z0, z1) = sorted((self.a[0], self.b[0])), sorted((-self.a[1], -self.b[1]))
        return "|".join(f"{value + 0.0:.3f}" for value in (x0, z0, x1, z1))

    @property
    def wall(self) -> str:
        """The id of the wall that the room sees."""
        return f"wall|{self.room.id}|{self.span}"

    @property
    def outer_wall(self) -> str:
        """The id of the wall that is seen from behind, where no room is."""
        return f"wall|exterior|{self.room.level}|{self.span}"


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.json`."""
    sides = [side for room in model.rooms for side in _sides(room, model)]
    seen = Counter((side.room.level, side.span) for side in sides)
    outer = [side for side in sides if seen[side.room.level, side.span] == 1]
    carried: dict[str | None, list[ModelBody]] = {}
    ids = {body.id for body in model.bodies}
    for body in model.bodies:
        carried.setdefault(body.parent if body.parent in ids else None, []).append(body)
    holes = {one.id: [side for side in sides if side.opening is one] for one in model.openings}
    house: HouseJson = {
        "id": model.name,
        "rooms": [_room(room) for room in model.rooms],
        "walls": [
            *(_wall(side.wall, side.room, side.a, side.b) for side in sides),
            *(_wall(side.outer_wall, side.room, side.b, side.a) for side in outer),
        ],
        "doors": [_hole(one, holes[one.id]) for one in model.openings if one.kind != "window" and holes[one.id]],
        "windows": [_hole(one, holes[one.id]) for one in model.openings if one.kind == "window" and holes[one.id]],
        "objects": [_object(body, carried) for body in carried.get(None, ())],
        "proceduralParameters": _parameters(model),
        "metadata": {"schema": SCHEMA, "agent": _agent(model), "compose": {"warnings": model.warnings, "wall_thickness": model.thickness}},
    }
    return {f"{model.name}.json": (json.dumps(house, separators=(",", ":")) + "\n").encode()}


def yaw_of_turn(turn: float) -> float:
    """Returns AI2-THOR's yaw of a turn, degrees: 0 faces north there and south here, and its turns are clockwise."""
    return round((180.0 - turn) % 360.0, 6)


def _at(x: float, y: float, z: float) -> HouseJson:
    return {"x": round(x, 6) + 0.0, "y": round(y, 6) + 0.0, "z": round(-z, 6) + 0.0}


def _material(color: str) -> HouseJson:
    return {"name": SOLID, "color": dict(zip("rgb", (round(share, 4) for share in srgb(color)), strict=True))}


def _room(room: FloorPlate) -> HouseJson:
    return {
        "id": room.id,
        "roomType": _ROOM_TYPES.get(room.type) or "".join(word.capitalize() for word in room.type.split("_")),
        "floorPolygon": [_at(x, room.elevation, z) for x, z in room.corners],
        "floorMaterial": _material(room.paint.color),
        "ceilings": [],
        "children": [],
        "compose": {"type": room.type, "area": room.area, "outdoor": room.outdoor, "level": room.level}
        | ({"name": room.name} if room.name else {})
        | ({"wall_thickness": list(room.outer)} if room.outer else {}),
    }


def _sides(room: FloorPlate, model: HouseModel) -> Iterator[_WallSide]:
    """Yields a room's outline cut where a neighbour's wall ends and between openings: AI2-THOR cuts one hole into a wall."""
    for wall, line, low, high in walls_round(room.corners):
        axis = "x" if wall in ALONG_X else "z"
        here = [
            one
            for one in model.openings
            if (one.axis, one.level) == (axis, room.level) and abs(one.line - line) <= one.thickness / 2 + NEGLIGIBLE
            if low <= one.start and one.end <= high
        ]
        level = [other for other in model.rooms if other.level == room.level]
        cuts = {low, high} | {at for other in level for at in _ends(other, axis, line) if low < at < high}
        here.sort(key=lambda one: one.start)
        cuts |= {round((one.end + other.start) / 2, 4) for one, other in pairwise(here)}
        cuts = {at for at in cuts if not any(one.start < at < one.end for one in here)}
        stops = sorted(cuts, reverse=wall in ("south", "west"))
        for start, end in pairwise(stops):
            inside = [one for one in here if min(start, end) <= one.start and one.end <= max(start, end)]
            ends = [(at, line) if axis == "x" else (line, at) for at in (start, end)]
            yield _WallSide(room, ends[0], ends[1], inside[0] if inside else None)


def _ends(room: FloorPlate, axis: str, line: float) -> Iterator[float]:
    """Yields where a room's walls on a line along an axis end."""
    for wall, at, low, high in walls_round(room.corners):
        if at == line and (wall in ALONG_X) == (axis == "x"):
            yield from (low, high)


def _wall(name: str, room: FloorPlate, a: tuple[float, float], b: tuple[float, float]) -> HouseJson:
    """Returns a wall that is seen from its right, on the way from `a` to `b`."""
    corners = [_at(x, y, z) for y in (room.elevation, room.ceiling) for x, z in (a, b)]
    return {"id": name, "roomId": room.id, "polygon": corners, "material": _material(PLAIN_WALL.color)}


def _hole(one: PlacedOpening, sides: Sequence[_WallSide]) -> HouseJson:
    """Returns a door or window: its hole is counted from the first wall's start; a leaf swings away from that wall's room."""
    ahead = one.rooms[0] if one.towards == 1 else one.rooms[1]
    near, *others = sorted(sides, key=lambda side: side.room.id == ahead)
    along = 0 if one.axis == "x" else 1
    ends = sorted(abs(at - near.a[along]) for at in (one.start, one.end))
    wide, tall = one.end - one.start, one.head - one.sill
    inside = others[0] if others else near
    said: HouseJson = {
        "id": one.id,
        "room0": near.room.id,
        "room1": inside.room.id,
        "wall0": near.wall,
        "wall1": others[0].wall if others else near.outer_wall,
        "assetId": one.kind,
        "assetPosition": {"x": round(ends[0] + wide / 2, 6), "y": round(one.sill + tall / 2, 6), "z": 0.0},
        "holePolygon": [
            {"x": round(ends[0], 6), "y": round(one.sill, 6), "z": 0.0},
            {"x": round(ends[1], 6), "y": round(one.head, 6), "z": 0.0},
        ],
        "compose": {"hinge": one.hinge, "towards": one.towards, "axis": one.axis, "main_entrance": one.is_main_entrance},
    }
    if one.kind != "window":
        swings = one.kind == "door"
        said |= {"openable": swings, "openness": 0.0 if swings else 1.0}
    return said


def _object(body: ModelBody, carried: Mapping[str | None, Sequence[ModelBody]]) -> HouseJson:
    """Returns a body and, as its children, what it carries."""
    return {
        "id": body.id,
        "assetId": body.kind or body.name,
        "position": _at(body.x, body.y + body.height / 2, body.z),
        "rotation": {"x": 0.0, "y": yaw_of_turn(body.turn), "z": 0.0},
        "kinematic": body.fixed,
        "room": body.room,
        "children": [_object(child, carried) for child in carried.get(body.id, ())],
        "compose": {
            "sort": body.sort,
            "name": body.name,
            "category": body.category,
            "size": {"x": round(body.width, 6), "y": round(body.height, 6), "z": round(body.depth, 6)},
            "mass": body.mass,
        },
    }


def _parameters(model: HouseModel) -> HouseJson:
    lights = [
        {
            "id": f"light_{number}",
            "type": "point",
            "position": _at((west + east) / 2, room.ceiling - 0.2, (north + south) / 2),
            "intensity": 0.75,
            "range": 15.0,
            "rgb": {"r": 1.0, "g": 0.855, "b": 0.722},
        }
        for number, room in enumerate(model.rooms)
        if not room.outdoor
        for west, north, east, south in [max(rectangles_of(room.corners), key=_area, default=(*room.corners[0], *room.corners[0]))]
    ]
    return {
        "ceilingMaterial": _material(CEILING),
        "floorColliderThickness": 1.0,
        "receptacleHeight": 0.7,
        "skyboxId": "SkyAlbany",
        "lights": lights,
        "reflections": [],
    }


def _area(rectangle: FloorRectangle) -> float:
    west, north, east, south = rectangle
    return (east - west) * (south - north)


def _agent(model: HouseModel) -> HouseJson:
    """Returns where an agent begins: a step inside the main entrance, looking in; else in the middle of the first room."""
    for one in model.openings:
        if one.is_main_entrance and any(one.rooms):
            inwards = 1 if one.rooms[0] else -1
            middle, across = (one.start + one.end) / 2, one.line + inwards * 0.5
            x, z = (middle, across) if one.axis == "x" else (across, middle)
            turn = (0.0 if inwards == 1 else 180.0) if one.axis == "x" else (90.0 if inwards == 1 else 270.0)
            return _pose(x, z, turn, model)
    first = [one for room in model.rooms[:1] for one in rectangles_of(room.corners)]
    west, north, east, south = max(first, key=_area, default=(0.0, 0.0, 0.0, 0.0))
    return _pose((west + east) / 2, (north + south) / 2, 0.0, model)


def _pose(x: float, z: float, turn: float, model: HouseModel) -> HouseJson:
    floor = model.rooms[0].elevation if model.rooms else 0.0
    return {"position": _at(x, floor + EYES, z), "rotation": {"x": 0.0, "y": yaw_of_turn(turn), "z": 0.0}, "standing": True, "horizon": 0}
