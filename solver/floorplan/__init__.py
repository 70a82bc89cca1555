"""Request -> floor plan -> typed rooms -> openings.

Comes in: `Request` (with a seed), `Catalogs`. Goes out: `FloorPlan`. May import: the ground floor and catalogs; no other
stage. Not here: furniture, wall occupancy, validation.

    bsp, spine   rectangles that tile the house         access     who is entered through whom, the main entrance
    classify     a type for every room (fitness)        openings          doors and windows on the lattice
    plan         rooms as the scene has them, doors moved afterwards
"""

from solver.floorplan.draw import draw, wall_thickness_of
from solver.floorplan.plan import FloorPlan, door_positions, with_door_at
from solver.floorplan.programme.planned_rooms import program_counts, program_of

__all__ = ["FloorPlan", "door_positions", "draw", "program_counts", "program_of", "wall_thickness_of", "with_door_at"]
