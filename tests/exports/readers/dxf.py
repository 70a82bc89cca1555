"""Plans as DXF, read by ezdxf: where each block is inserted, and its attributes."""

from __future__ import annotations

import io
from collections.abc import Iterator, Mapping
from typing import Any

from ezdxf.filemanagement import read as read_document
from ezdxf.tools.text import caret_decode

from tests.exports.readers import Seen


def drawings(files: Mapping[str, bytes]) -> Iterator[Any]:
    """Each storey's drawing."""
    yield from (read_document(io.StringIO(content.decode())) for content in files.values())


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    """The bodies by id."""
    found: dict[str, Seen] = {}
    for drawing in drawings(files):
        for insert in drawing.modelspace().query("INSERT"):
            said = {attribute.dxf.tag: caret_decode(attribute.dxf.text) for attribute in insert.attribs}
            x, y, _ = insert.dxf.insert
            width, depth, height = map(float, said["SIZE"].split())
            place = x, float(said["Y"]), -y, insert.dxf.rotation
            found[said["ID"]] = Seen(*place, width, depth, height, float(said["MASS"]))
    return found
