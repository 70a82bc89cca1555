"""A sent room -> pieces whose anchors are the sent poses, and placed poses back: /fix is no second solver.

Comes in: a RoomProblem. Goes out: pieces in order of importance; the room with the placed poses, what stands on or hangs over
a piece moved and turned with it. May import: the ground floor, catalogs. Not here: solving (placement), where a room's furniture
may stand (furnish).
"""

from solver.repair.as_sent import as_it_stands, holders, pieces_as_sent
from solver.repair.bodies import (
    Body,
    Repair,
    all_bodies,
    applied,
    floor_bodies,
    root_of,
    seated_along,
    squared,
    with_bodies,
    with_walls_told,
    without,
    written_back,
)
from solver.repair.in_hand import InHand, LastAnswer, in_hand
from solver.repair.moved_people import Crowd, people_out_of_the_way
from solver.repair.resting import put_to_rest
from solver.repair.room_problem import RepairSettings, RoomProblem, Walls

__all__ = [
    "Body", "Crowd", "InHand", "LastAnswer", "Repair", "RepairSettings", "RoomProblem", "Walls", "all_bodies", "applied",
    "as_it_stands", "floor_bodies", "holders", "in_hand", "people_out_of_the_way", "pieces_as_sent", "put_to_rest", "root_of",
    "seated_along", "squared", "with_bodies", "with_walls_told", "without", "written_back",
]  # fmt: skip
