"""A sent room -> wanted pieces whose anchors are the sent poses, and placed poses back: /fix is no second solver.

Comes in: a Room and what is locked, moved and known of kinds. Goes out: Wanted pieces in order of importance; the room with
the placed poses, what stands on or hangs over a piece moved and turned with it. May import: the ground floor. Not here:
solving (placement), where a room's furniture may stand (furnish).
"""

from solver.repair.as_sent import holders, wanted_as_sent
from solver.repair.backs import said
from solver.repair.bodies import Body, all_bodies, floor_bodies, squared
from solver.repair.changes import applied
from solver.repair.people import Crowd, followed, in_the_way, placed_people
from solver.repair.previous import Last
from solver.repair.resting import rested
from solver.repair.upon import put_upon
from solver.repair.ways import Walls
from solver.repair.wishes import Sides, Wishes
from solver.repair.written import without, written_back

__all__ = [
    "Body",
    "Crowd",
    "Last",
    "Sides",
    "Walls",
    "Wishes",
    "all_bodies",
    "applied",
    "floor_bodies",
    "followed",
    "holders",
    "in_the_way",
    "placed_people",
    "put_upon",
    "rested",
    "said",
    "squared",
    "wanted_as_sent",
    "without",
    "written_back",
]
