"""Homes for Sweet Home 3D, read as its reader does: `Home.xml` in an archive, cm, angles clockwise, heights above the storey."""

from __future__ import annotations

import io
import math
import zipfile
from collections.abc import Mapping
from xml.etree import ElementTree

from tests.exports.readers import Seen


def opened(files: Mapping[str, bytes]) -> tuple[ElementTree.Element, zipfile.ZipFile]:
    """The home, and the archive with its models."""
    (content,) = files.values()
    archive = zipfile.ZipFile(io.BytesIO(content))
    return ElementTree.fromstring(archive.read("Home.xml")), archive


def properties(element: ElementTree.Element) -> dict[str, str]:
    """What is said of a piece."""
    return {one.attrib["name"]: one.attrib["value"] for one in element.findall("property")}


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    """The bodies by id; what is a part of the house has no mass."""
    home, _ = opened(files)
    floors = {level.get("id"): float(level.attrib["elevation"]) for level in home.findall("level")}
    found: dict[str, Seen] = {}
    for piece in home.findall("pieceOfFurniture"):
        said = properties(piece)
        if "mass" in said:
            x, z, y, width, depth, height = (float(piece.attrib[key]) for key in ("x", "y", "elevation", "width", "depth", "height"))
            lengths = (x, y + floors.get(piece.get("level"), 0.0), z, width, depth, height)
            x, y, z, width, depth, height = (length / 100 for length in lengths)
            found[said["id"]] = Seen(x, y, z, -math.degrees(float(piece.attrib["angle"])), width, depth, height, float(said["mass"]))
    return found
