"""PNG: a picture of the home from above, and maps of 2 cm a pixel that say what is where: class, thing, room, free floor. North at the top.

A map's pixels are numbers, coloured by a palette; palette.json says what they mean and where in the house a pixel is. A pixel shows what
its middle is in; of several things the highest. Footprints count, not parts.
"""

import colorsys
import io
import json
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
import numpy.typing as npt
from PIL import Image

from solver.exports.floor_grid import WALKED_ON, FloorGrid, floor_mask, grid_of, inside, obstacles
from solver.exports.home_picture import picture_of
from solver.exports.model import HouseModel, ModelBody
from solver.exports.paints import channels
from solver.exports.plan_storeys import drawing_ranks, on_line, opening_box
from solver.exports.writers import ExportSettings, Files

PIXEL: Final = 0.02
"""Side of a map's pixel, m."""
MARGIN: Final = 0.3
HEAD: Final = 2.0
"""What begins higher above the floor does not take floor away, m: it is walked under."""
SURFACES: Final = {
    "outside": "#f4f1ec", "bare_floor": "#d9cdb8", "outdoor_floor": "#a9c48c", "wall": "#4b4743", "door": "#b5793a", "window": "#8fc7e8",
}  # fmt: skip
"""The classes that are no things, numbered from 0, and their colours."""
FREE: Final = {"outside": "#f4f1ec", "free": "#ffffff", "taken": "#30343b"}
Numbers = npt.NDArray[np.uint16]


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `picture.png`, `semantic.png`, `instance.png` (16 bits), `rooms.png`, `free_floor.png`; palette.json for all storeys."""
    known = dict.fromkeys([*SURFACES, *model.categories])
    classes = {name: number for number, name in enumerate(known | dict.fromkeys(body.category for body in model.bodies))}
    files: Files = {}
    maps: list[dict[str, object]] = []
    for number, level in enumerate(model.levels):
        end = f"_level_{level}.png" if number else ".png"
        grid = grid_of(model, level, PIXEL, MARGIN)
        semantic, instance, rooms = _maps(model, level, grid, classes)
        taken = obstacles(model, level, grid, HEAD)
        free = np.where(taken, 2, np.where(rooms > 0, 1, 0))
        files[f"picture{end}"] = picture_of(model, level)
        files[f"semantic{end}"] = _paletted(semantic, _class_colors(classes))
        files[f"instance{end}"] = _file(Image.fromarray(instance))
        files[f"rooms{end}"] = _paletted(rooms, ["#f4f1ec", *_hues(len(model.rooms))])
        files[f"free_floor{end}"] = _paletted(free, list(FREE.values()))
        maps.append({"level": level, "ending": end, "pixel": PIXEL, "north_west": [grid.x, grid.z], "size": [grid.columns, grid.rows]})
    files["palette.json"] = _palette(model, classes, maps)
    return files


def _maps(model: HouseModel, level: int, grid: FloorGrid, classes: Mapping[str, int]) -> tuple[Numbers, Numbers, Numbers]:
    """Returns each pixel's class, the number of the body there from 1, and that of the room from 1."""
    semantic, instance, rooms = (np.zeros(grid.shape, dtype=np.uint16) for _ in range(3))
    levels = {room.id: room.level for room in model.rooms}
    for number, room in enumerate(model.rooms, 1):
        if room.level == level:
            floor = floor_mask(grid, room)
            rooms[floor] = number
            semantic[floor] = classes["outdoor_floor" if room.outdoor else "bare_floor"]
    for panel in model.panels:
        if panel.level == level:
            strip = on_line(panel.axis, (panel.start, panel.end), panel.line, panel.thickness / 2)
            semantic[grid.centred(*strip)] = classes["wall"]
    for fitting in model.fittings:
        if fitting.surface == "railing":
            semantic[grid.touched(fitting.box.x0, fitting.box.z0, fitting.box.x1, fitting.box.z1)] = classes["wall"]
    for one in model.openings:
        if one.level == level:
            said = "bare_floor" if one.kind == "passage" else "window" if one.kind == "window" else "door"
            semantic[grid.centred(*opening_box(one))] = classes[said]
    numbered = [(body, number) for number, body in enumerate(model.bodies, 1) if levels.get(body.room or "") == level]
    ranks = drawing_ranks(model.bodies)
    for body, number in sorted(numbered, key=lambda one: ranks[one[0].id]):
        _mark(grid, body, (semantic, classes[body.category]), (instance, number))
    return semantic, instance, rooms


def _mark(grid: FloorGrid, body: ModelBody, *layers: tuple[Numbers, int]) -> None:
    """Writes a number into each layer where a body's footprint holds the middle of a pixel."""
    window = grid.centred(*body.footprint)
    where = ... if body.turn % 90 == 0 else inside(grid, body, window, touching=False)
    for layer, number in layers:
        layer[window][where] = number


def _class_colors(classes: Mapping[str, int]) -> list[str]:
    return [*SURFACES.values(), *_hues(len(classes) - len(SURFACES))]


def _hues(count: int) -> list[str]:
    """Returns colours that differ, neighbours the most: hues by the golden angle, in three strengths."""
    strengths = ((0.45, 0.95), (0.65, 0.8), (0.3, 0.7))
    made = (colorsys.hsv_to_rgb(number * 0.381966 % 1.0, *strengths[number % 3]) for number in range(count))
    return ["#" + "".join(f"{round(channel * 255):02x}" for channel in color) for color in made]


def _paletted(numbers: npt.NDArray[Any], colors: Sequence[str]) -> bytes:
    """Returns a map of at most 256 numbers as a PNG with a palette; of more in 16 bits."""
    if len(colors) > 256:
        return _file(Image.fromarray(numbers.astype(np.uint16)))
    picture = Image.fromarray(numbers.astype(np.uint8))
    picture.putpalette([channel for color in colors for channel in channels(color)])
    return _file(picture)


def _file(picture: Image.Image) -> bytes:
    content = io.BytesIO()
    picture.save(content, "PNG")
    return content.getvalue()


def _palette(model: HouseModel, classes: Mapping[str, int], maps: Sequence[Mapping[str, object]]) -> bytes:
    colors = _class_colors(classes)
    rooms = zip(model.rooms, _hues(len(model.rooms)), strict=True)
    said = {
        "export": "png",
        "frame": "x east, z south, m; a pixel's north-west corner is north_west + pixel * (column, row)",
        "warnings": model.warnings,
        "maps": maps,
        "semantic": [{"number": number, "name": name, "color": colors[number]} for name, number in classes.items()],
        "free_floor": [{"number": number, "name": name, "color": color} for number, (name, color) in enumerate(FREE.items())],
        "rooms": [{"number": number, "id": room.id, "type": room.type, "color": color} for number, (room, color) in enumerate(rooms, 1)],
        "instance": [
            {"number": number, "id": body.id, "kind": body.kind, "name": body.name, "category": body.category}
            for number, body in enumerate(model.bodies, 1)
        ],
        "taken": {"from": WALKED_ON, "to": HEAD},
    }
    return (json.dumps(said).replace('{"number"', '\n{"number"') + "\n").encode()
