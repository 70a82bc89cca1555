"""Stage: a scene into the formats of simulators, editors and training: described once, written by a module a format.

Comes in: a scene, catalogs, a format's name. Goes out: files by name. May import: the ground floor, catalogs. Not here: what is
wrong with a scene (validator).
"""

from solver.exports.describing import describe
from solver.exports.model import HouseModel
from solver.exports.writers import ExportSettings, Files, is_available, packed, written_as

__all__ = ["ExportSettings", "Files", "HouseModel", "describe", "is_available", "packed", "written_as"]
