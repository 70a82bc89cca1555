"""Nav2 (ROS 2): a map a storey as its map_server reads it, and rooms, doors and places to stand at as JSON.

The map's frame: x east, y north, z up, m; yaw in radians about +z, 0 facing east. A cell is occupied if anything below 1.5 m touches it.
Doors stand open. People and pets are left out.
"""

import json
import math
from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt

from solver.exports.floor_grid import FloorGrid, Mask, floor_mask, grid_of, largest_stretch, obstacles, squared_distances
from solver.exports.model import DoorLeaf, HouseModel, ModelBody, PlacedOpening
from solver.exports.plan_storeys import opening_box
from solver.exports.writers import ExportSettings, Files

RESOLUTION: Final = 0.05
"""Side of a cell, m."""
ROBOT_HEIGHT: Final = 1.5
"""What begins higher above the floor is driven under, m. Our choice, more than the height of common indoor robots."""
ROBOT_RADIUS: Final = 0.28
"""Inscribed radius of the robot that rooms' points are for, m: one 0.6 m wide, less what rounding to cells takes."""
MARGIN: Final = 0.5
"""How far the map goes beyond the rooms, m."""
Grey = npt.NDArray[np.uint8]
OCCUPIED, FREE, UNKNOWN = 0, 254, 205
"""Grey values as map_server's `trinary` mode reads them: (255 - grey) / 255 below 0.196 is free, above 0.65 occupied, unknown between."""


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `map.pgm` and `map.yaml` (`map_level_1` and so on for further storeys) and `rooms.json`."""
    files: Files = {}
    rooms: list[dict[str, object]] = []
    maps: list[dict[str, object]] = []
    for number, level in enumerate(model.levels):
        name = f"map_level_{level}" if number else "map"
        grid = grid_of(model, level, RESOLUTION, MARGIN)
        taken = obstacles(model, level, grid, ROBOT_HEIGHT)
        cells = _cells(model, level, grid, taken)
        files[f"{name}.pgm"] = _picture(model, cells)
        files[f"{name}.yaml"] = _yaml(model, name, grid)
        maps.append({"image": f"{name}.pgm", "level": level})
        rooms += _rooms(model, level, grid, cells)
    leaves = model.leaves_by_opening
    document = {
        "export": "nav2",
        "frame": "x east, y north, z up; m; yaw in radians about +z, 0 facing east",
        "warnings": model.warnings,
        "maps": maps,
        "rooms": rooms,
        "doors": [_door(one, leaves.get(one.id, [])) for one in model.openings if one.kind != "window"],
        "poses": [pose for body in model.bodies for pose in _poses(body)],
    }
    lines = json.dumps(document, separators=(",", ":")).replace('{"id"', '\n{"id"').replace('{"body"', '\n{"body"')
    files["rooms.json"] = f"{lines}\n".encode()
    return files


def _cells(model: HouseModel, level: int, grid: FloorGrid, taken: Mask) -> Grey:
    """Returns a map's cells as grey values, north at the top."""
    cells = np.full(grid.shape, UNKNOWN, dtype=np.uint8)
    for room in model.rooms:
        if room.level == level:
            cells[floor_mask(grid, room)] = FREE
    for one in model.openings:
        if one.level == level and one.kind != "window":
            cells[grid.centred(*opening_box(one))] = FREE
    cells[taken] = OCCUPIED
    return cells


def _picture(model: HouseModel, cells: Grey) -> bytes:
    """Returns a map as a PGM picture."""
    comments = "".join(f"# {_line(warning)}\n" for warning in model.warnings)
    return f"P5\n{comments}{cells.shape[1]} {cells.shape[0]}\n255\n".encode() + cells.tobytes()


def _yaml(model: HouseModel, name: str, grid: FloorGrid) -> bytes:
    lines = [
        *(f"# {_line(warning)}" for warning in model.warnings),
        f"image: {name}.pgm",
        "mode: trinary",
        f"resolution: {grid.cell}",
        f"origin: [{round(grid.x, 3)}, {_plain(-grid.south)}, 0]",
        "negate: 0",
        "occupied_thresh: 0.65",
        "free_thresh: 0.196",
    ]
    return ("\n".join(lines) + "\n").encode()


def _line(text: str) -> str:
    """Returns a text as one line of ASCII: what a comment may hold."""
    return json.dumps(text)[1:-1]


def _plain(value: float) -> float:
    """Returns a coordinate in whole tenths of a millimetre, without a zero's sign."""
    return round(value, 4) + 0.0


def _rooms(model: HouseModel, level: int, grid: FloorGrid, cells: Grey) -> list[dict[str, object]]:
    """Returns the rooms of a level, each with the point farthest from everything that a robot can drive to, if there is any."""
    floors = [(room, floor_mask(grid, room)) for room in model.rooms if room.level == level]
    squares = squared_distances(cells == OCCUPIED)
    apart = squares * grid.cell**2 > ROBOT_RADIUS**2 + 1e-9
    reached = largest_stretch((cells == FREE) & apart)
    made: list[dict[str, object]] = []
    for room, floor in floors:
        known = floor & reached
        reachable = bool(known.any())
        here = np.flatnonzero(known if reachable else floor)
        row, column = divmod(int(here[squares.flat[here].argmax()]) if len(here) else 0, grid.columns)
        x, z = grid.centre(row, column)
        clearance = math.sqrt(int(squares[row, column])) * grid.cell if len(here) else 0.0
        made.append(
            {
                "id": room.id,
                "type": room.type,
                "level": level,
                "outdoor": room.outdoor,
                "area": room.area,
                "polygon": [[_plain(x), _plain(-z)] for x, z in room.corners],
                "point": [_plain(x), _plain(-z)] if clearance else None,
                "clearance": round(clearance, 3),
                "reachable": reachable,
            }
        )
    return made


def _door(one: PlacedOpening, leaves: Sequence[DoorLeaf]) -> dict[str, object]:
    """Returns an opening that is gone through; its yaw looks through it, towards the first of its rooms."""
    x, z = one.middle
    door: dict[str, object] = {
        "id": one.id,
        "kind": one.kind,
        "level": one.level,
        "position": [_plain(x), _plain(-z)],
        "yaw": round(-math.pi / 2 if one.axis == "x" else 0.0, 6),
        "width": round(one.end - one.start, 4),
        "rooms": one.rooms,
        "main_entrance": one.is_main_entrance,
    }
    turning = [_leaf(leaf) for leaf in leaves if leaf.motion == "swing"]
    for leaf in turning[:1]:
        door |= leaf
    for leaf in turning[1:]:
        door["second_leaf"] = leaf
    return door


def _leaf(leaf: DoorLeaf) -> dict[str, object]:
    return {
        "hinge": [_plain(leaf.hinge[0]), _plain(-leaf.hinge[2])],
        "leaf_width": round(leaf.width, 4),
        "closed_yaw": round(math.radians(leaf.closed), 6),
        "open_yaw": round(math.radians(leaf.closed + leaf.swing), 6),
    }


def _poses(body: ModelBody) -> list[dict[str, object]]:
    """Returns where somebody stands who uses a body, facing it."""
    return [
        {"body": body.id, "name": body.name, "room": body.room, "position": [_plain(x), _plain(-z)], "yaw": yaw_of(turn)}
        for x, z, turn in body.uses
    ]


def yaw_of(turn: float) -> float:
    """Returns the yaw in the map, radians, of what faces a turn of the scene: 0 faces south there, and east in the map."""
    quarter = (turn - 90.0) % 360.0
    return round(math.radians(quarter - 360.0 if quarter > 180.0 else quarter), 6)
