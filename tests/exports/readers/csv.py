"""Reads the table as a spreadsheet does: an apostrophe before a formula's sign is not part of the text."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping

from tests.exports.readers import Seen


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    (content,) = files.values()
    rows = csv.DictReader(io.StringIO(content.decode(), newline=""))
    return {_text(row["id"]): _seen(row) for row in rows}


def _text(cell: str) -> str:
    return cell[1:] if cell[:1] == "'" and cell[1:2] in ("=", "+", "-", "@", "\t", "\r") else cell


def _seen(row: dict[str, str]) -> Seen:
    return Seen(*(float(row[key]) for key in ("x", "y", "z", "rotation", "width", "depth", "height", "mass")))
