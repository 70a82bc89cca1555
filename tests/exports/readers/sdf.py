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
    found = {}
    for model in models(text):
        found[model.findtext(ID, "")] = _seen(model, _values(model, "pose"))
        for inner in model.findall("model"):
            found[inner.findtext(ID, "")] = _seen(inner, _within(_values(model, "pose"), _values(inner, "pose")))
    return found


def models(text: bytes) -> list[ElementTree.Element]:
    """Returns the models of the world that are bodies; what they hold is within theirs."""
    every = ElementTree.fromstring(text).findall("world/model")
    return [model for model in every if model.find(ID) is not None and not is_leaf(model)]


def _within(outer: list[float], inner: list[float]) -> list[float]:
    cosine, sine = math.cos(outer[5]), math.sin(outer[5])
    x, y = inner[0] * cosine - inner[1] * sine, inner[0] * sine + inner[1] * cosine
    return [outer[0] + x, outer[1] + y, outer[2] + inner[2], 0.0, 0.0, outer[5] + inner[5]]


def is_leaf(model: ElementTree.Element) -> bool:
    """Tells whether a model is a door: its joint hangs on the world and moves."""
    return any(joint.findtext("parent") == "world" and joint.get("type") != "fixed" for joint in model.iter("joint"))


def _seen(model: ElementTree.Element, pose: list[float]) -> Seen:
    x, y, z, _, _, turn = pose
    spans = [_span(visual, link) for link in model.findall("link") for visual in link.iter("visual")]
    low, high = np.min([one for one, _ in spans], axis=0), np.max([one for _, one in spans], axis=0)
    mass = sum(float(link.findtext("inertial/mass", "")) for link in model.findall("link"))
    width, depth, height = (float(extent) for extent in high - low)
    return Seen(x, z, -y, math.degrees(turn) % 360, width, depth, height, mass)


def _span(visual: ElementTree.Element, link: ElementTree.Element) -> tuple[list[float], list[float]]:
    x, y, z, roll, pitch, _ = _values(visual, "pose")
    x, y, z = (at + own for at, own in zip((x, y, z), _values(link, "pose") or [0.0] * 3, strict=False))
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
