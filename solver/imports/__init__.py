"""Foreign floor plans -> an unfurnished or furnished scene: read, units, straighten, wall lines, join openings, report.

Comes in: the bytes of a file. Goes out: a `PlanImport`: a scene, and everything that was changed, guessed or left out on the way.
May import: the ground floor, catalogs. Not here: repairing furniture, judging (the pipeline does both).

One module a format in `formats/` (file -> `DrawnPlan`), one module a step: `units`, `straighten`, `line_growing`, `joining`, `to_scene`.
"""

from solver.imports.bounded_files import unpacked
from solver.imports.drawn import PlanNotes
from solver.imports.plan_reading import READERS, PlanFile, format_of_plan, imported
from solver.imports.units import in_metres, scene_unit

__all__ = ["READERS", "PlanFile", "PlanNotes", "format_of_plan", "imported", "in_metres", "scene_unit", "unpacked"]
