"""Reads SDF as XML; libsdformat reads it in `python -m tests.targets physics`, where it is installed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from xml.etree import ElementTree

import numpy as np

from tests.exports.readers import Seen

ID = "{compose-scene}id"


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    (text,) = (content for name, content in files.items() if name.endswith(".sdf"))
    models = ElementTree.fromstring(text).iter("model")
    return {model.findtext(ID, ""): _seen(model) for model in models if model.find(ID) is not None and model.find("joint") is None}


def _seen(model: ElementTree.Element) -> Seen:
    x, y, z, _, _, turn = _values(model, "pose")
    spans = [_span(visual) for visual in model.iter("visual")]
    low, high = np.min([one for one, _ in spans], axis=0), np.max([one for _, one in spans], axis=0)
    (mass,) = _values(model, "link/inertial/mass")
    width, depth, height = (float(extent) for extent in high - low)
    return Seen(x, z, -y, math.degrees(turn) % 360, width, depth, height, mass)


def _span(visual: ElementTree.Element) -> tuple[list[float], list[float]]:
    x, y, z, roll, pitch, _ = _values(visual, "pose")
    geometry = visual.find("geometry")
    assert geometry is not None
    if geometry.find("cylinder") is not None:
        (radius,), (length,) = _values(geometry, "cylinder/radius"), _values(geometry, "cylinder/length")
        across = 2 * radius
        size = [length if pitch else across, length if roll else across, across if pitch or roll else length]
    else:
        size = _values(geometry, "box/size" if geometry.find("box") is not None else "mesh/scale")
    return [at - extent / 2 for at, extent in zip((x, y, z), size, strict=True)], [
        at + extent / 2 for at, extent in zip((x, y, z), size, strict=True)
    ]


def _values(element: ElementTree.Element, path: str) -> list[float]:
    return [float(word) for word in element.findtext(path, "").split()]
