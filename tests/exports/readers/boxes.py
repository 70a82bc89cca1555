"""Reads boxes as ATISS's cached dataset does: NumPy, no pickles, folders by the part of their name behind the underscore."""

from __future__ import annotations

import io
import json
import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from tests.exports.readers import Seen


def rooms_of(files: Mapping[str, bytes]) -> dict[str, dict[str, Any]]:
    """The arrays of each room, by the folder's name; of the scenes that the splits list."""
    scenes = {line.split(",")[0] for line in files["house_splits.csv"].decode().splitlines()}
    folders = {name.split("/")[0] for name in files}
    kept = sorted(folder for folder in folders if folder.split("_")[1] in scenes)
    return {folder: dict(np.load(io.BytesIO(files[f"{folder}/boxes.npz"]), allow_pickle=False)) for folder in kept}


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    """The furniture; masses are not in the format."""
    found = {}
    labels = json.loads(files["dataset_stats.txt"])["class_labels"]
    for room in rooms_of(files).values():
        rows = zip(room["uids"], room["translations"], room["sizes"], room["angles"], room["class_labels"], room["jids"], strict=True)
        for name, at, half, (angle,), label, kind in rows:
            assert labels[int(label.argmax())] == kind and label.sum() == 1
            x, y, z = (at + room["floor_plan_centroid"]).tolist()
            width, height, depth = (2 * half.astype(float)).tolist()
            found[str(name)] = Seen(x, y - height / 2, z, math.degrees(float(angle)) % 360, width, depth, height)
    return found
