"""Boxes a room, as ATISS and the layout models after it read 3D-FRONT: for training. Furniture alone, in the scene's frame (y up, m).

A folder a room, `<house>_<room>/boxes.npz`; dataset_stats.txt; house_splits.csv, which ATISS calls its annotation file. Sizes are half
extents, translations the boxes' centres relative to the middle of the floor's bounding box, angles radians about +y, 0 facing +z.
"""

import io
import json
import math
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from solver.exports.floor_grid import FloorGrid, floor_mask
from solver.exports.model import FloorPlate, HouseModel, ModelBody
from solver.exports.writers import ExportSettings, Files, zipped
from solver.free_names import FreeNames
from solver.geometry import rectangles_of

ROOM_SIDE: Final = 6.1
"""Half of the side of the square round a room's middle that `room_layout` shows, m: ATISS's for living rooms, as ours are mixed."""
PIXELS: Final = 256
Arrays = dict[str, npt.NDArray[Any]]


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes the rooms that have furniture; the same bytes for the same house."""
    furniture = [body for body in model.bodies if body.sort == "furniture"]
    classes = sorted({*model.kinds, *map(_class_of, furniture)})
    names = FreeNames()
    house = _plain(model.name)
    files: Files = {}
    splits: list[str] = []
    translations: list[npt.NDArray[np.float32]] = []
    for room in model.rooms:
        bodies = [body for body in furniture if body.room == room.id]
        if not bodies:
            continue
        scene = names.take(_plain(room.id)).replace("_", ".")
        arrays = _arrays(room, bodies, classes)
        translations.append(arrays["translations"])
        names_of = {"scene_id": scene, "scene_uid": f"{house}_{scene}", "scene_type": room.type, "json_path": house}
        files[f"{house}_{scene}/boxes.npz"] = packed_arrays({**arrays, **{key: np.array(text) for key, text in names_of.items()}})
        splits.append(f"{scene},train\n")
    files["house_splits.csv"] = "".join(splits).encode()
    files["dataset_stats.txt"] = _statistics(model, furniture, classes, translations)
    return files


def _plain(text: str) -> str:
    """Returns a text as a part of a folder's name: ATISS splits that at its underscore."""
    return re.sub(r"[^A-Za-z0-9-]", "-", text)[:60]


def _class_of(body: ModelBody) -> str:
    return body.kind or body.name


def _arrays(room: FloorPlate, bodies: Sequence[ModelBody], classes: Sequence[str]) -> Arrays:
    """Returns what a room's file holds but its names; a body a row, in the scene's order."""
    x, z = (min(values) / 2 + max(values) / 2 for values in zip(*room.corners, strict=True))
    centroid = np.array([x, room.elevation, z])
    vertices, faces = _floor(room)
    labels = np.zeros((len(bodies), len(classes) + 2), dtype=np.float32)
    labels[range(len(bodies)), [classes.index(_class_of(body)) for body in bodies]] = 1
    middles = np.array([(body.x, body.y + body.height / 2, body.z) for body in bodies])
    grid = FloorGrid(2 * ROOM_SIDE / PIXELS, x - ROOM_SIDE, z - ROOM_SIDE, PIXELS, PIXELS)
    return {
        "uids": np.array([body.id for body in bodies]),
        "jids": np.array([_class_of(body) for body in bodies]),
        "room_layout": np.where(floor_mask(grid, room), 255, 0).astype(np.uint8)[:, :, None],
        "room_side": np.array(ROOM_SIDE),
        "floor_plan_vertices": vertices,
        "floor_plan_faces": faces,
        "floor_plan_centroid": centroid,
        "class_labels": labels,
        "translations": (middles - centroid).astype(np.float32),
        "sizes": np.array([(body.width / 2, body.height / 2, body.depth / 2) for body in bodies], dtype=np.float32),
        "angles": np.array([[angle_of(body.turn)] for body in bodies], dtype=np.float32),
    }


def angle_of(turn: float) -> float:
    """Returns a turn in degrees as radians from -pi up to pi, exclusive."""
    return math.radians((turn + 180.0) % 360.0 - 180.0)


def _floor(room: FloorPlate) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """Returns a floor's corners and its triangles, seen from above counter-clockwise."""
    corners: list[tuple[float, float, float]] = []
    faces: list[tuple[int, int, int]] = []
    for x0, z0, x1, z1 in rectangles_of(room.corners):
        first = len(corners)
        corners += [(x0, room.elevation, z0), (x0, room.elevation, z1), (x1, room.elevation, z1), (x1, room.elevation, z0)]
        faces += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return np.array(corners), np.array(faces)


def _statistics(
    model: HouseModel, furniture: Sequence[ModelBody], classes: Sequence[str], translations: Sequence[npt.NDArray[np.float32]]
) -> bytes:
    """Returns what ATISS scales by and counts: of this house; to train on many, take the least and greatest of all."""
    rooms = {room.id for room in model.rooms}
    counted = [body for body in furniture if body.room in rooms]
    bounds: dict[str, Sequence[Sequence[float]]] = {
        "translations": np.concatenate([*translations, np.zeros((0 if translations else 1, 3), dtype=np.float32)]).tolist(),
        "sizes": [(body.width / 2, body.height / 2, body.depth / 2) for body in counted] or [(0.0, 0.0, 0.0)],
        "angles": [(angle_of(body.turn),) for body in counted] or [(0.0,)],
    }
    counts = dict(sorted(Counter(map(_class_of, counted)).items(), key=lambda one: (-one[1], one[0])))
    said: Mapping[str, object] = {
        **{f"bounds_{key}": [round(pick(at), 6) for pick in (min, max) for at in zip(*rows, strict=True)] for key, rows in bounds.items()},
        "class_labels": [*classes, "start", "end"],
        "object_types": classes,
        "class_frequencies": {name: round(count / len(counted), 6) for name, count in counts.items()},
        "class_order": {name: number for number, name in enumerate(counts)},
        "count_furniture": counts,
        "warnings": model.warnings,
    }
    return json.dumps(said).encode()


def packed_arrays(arrays: Mapping[str, npt.NDArray[Any]]) -> bytes:
    """Returns arrays as an .npz file of the same bytes for the same values."""
    files = {}
    for name, values in arrays.items():
        entry = io.BytesIO()
        np.lib.format.write_array(entry, np.asanyarray(values), allow_pickle=False)
        files[f"{name}.npy"] = entry.getvalue()
    return zipped(files)
