"""Plans as SVG, read as XML: where each symbol stands, and what is said of it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from xml.etree import ElementTree

from tests.exports.readers import Seen

SVG = "{http://www.w3.org/2000/svg}"
LINK = "{http://www.w3.org/1999/xlink}href"
PLACED = re.compile(r"translate\(([^ ]+) ([^)]+)\)(?:rotate\(([^)]+)\))?")


def plans(files: Mapping[str, bytes]) -> Iterator[ElementTree.Element]:
    """The root of each storey's plan."""
    yield from (ElementTree.fromstring(content) for content in files.values())


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    """The bodies by id."""
    found: dict[str, Seen] = {}
    for root in plans(files):
        sizes = {symbol.get("id"): symbol.attrib["data-size"] for symbol in root.iter(f"{SVG}g") if "data-size" in symbol.attrib}
        for use in root.iter(f"{SVG}use"):
            width, depth, height = map(float, sizes[use.attrib[LINK][1:]].split())
            at = PLACED.fullmatch(use.attrib["transform"])
            assert at
            x, z, turn = (float(value or 0) for value in at.groups())
            place = x / 1000, float(use.attrib["data-y"]), z / 1000, -turn
            found[use.attrib["data-id"]] = Seen(*place, width, depth, height, float(use.attrib["data-mass"]))
    return found
