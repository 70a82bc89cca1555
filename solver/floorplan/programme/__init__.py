"""A programme -> a home: the rooms' types are dealt first, then their widths are solved (solver/core/homes/).

Comes in: `Request` with a programme or an area, `Catalogs`. Goes out: `PlannedHome`: a layout, its types and its tree of doors.
May import: the ground floor, catalogs, the floor plan's layout and fitness. Not here: where in a wall a door stands.

    planned_rooms  counts or a preset's name -> rooms with sizes
    home_search    which skeletons and outlines suit them; the cheapest home of a counted number: core
    yard           who is entered through whom; a garden beside or behind the house
    home           all of it, top to bottom
"""

from solver.floorplan.programme.home import plan_home
from solver.floorplan.programme.yard import PlannedHome

__all__ = ["PlannedHome", "plan_home"]
