"""CSV: a line a body, for spreadsheets and data frames, in the scene's frame (x east, y up, z south, m and degrees)."""

import csv
import io
from typing import Final

from solver.exports.model import HouseModel, ModelBody
from solver.exports.writers import ExportSettings, Files

COLUMNS: Final = (
    "id", "sort", "kind", "name", "category", "room", "x", "y", "z", "rotation", "width", "depth", "height", "mass", "parent", "fixed",
)  # fmt: skip
_FORMULA: Final = ("=", "+", "-", "@", "\t", "\r")
"""What begins a formula in a spreadsheet."""


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.csv`: bodies in the scene's order, sizes unrotated, a decoration's group as its category, UTF-8."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\r\n")
    table.writerow(COLUMNS)
    for body in model.bodies:
        table.writerow([harmless(value) for value in _row(body)])
    return {f"{model.name}.csv": text.getvalue().encode()}


def _row(body: ModelBody) -> tuple[object, ...]:
    pose = (body.x, body.y, body.z, body.turn)
    size = (body.width, body.depth, body.height, body.mass)
    return (body.id, body.sort, body.kind, body.name, body.category, body.room, *pose, *size, body.parent, "yes" if body.fixed else "no")


def harmless(value: object) -> object:
    """Returns a value that no spreadsheet takes for a formula: words that begin like one get an apostrophe, as spreadsheets write it."""
    return f"'{value}" if isinstance(value, str) and value.startswith(_FORMULA) else value
