"""Pieces with their candidates -> exact places: the heart.

Comes in: rooms as (Space, pieces). Goes out: Arrangements on the millimetre lattice, with reasons for what was
left out. May import: the ground floor. Not here: rules of room types (furnish), the rules (validator).
"""

from solver.placement.arrange import arrange, feasible, walkable_when_empty, with_joined_doors
from solver.placement.budget import ROOM_WORK, Budget, CallWork, charge, is_call_spent, work_of_call
from solver.placement.displacement import can_be_used, move_least, moved_back
from solver.placement.encode import problem_bytes
from solver.placement.finish import finish, place
from solver.placement.left_out import minimal_conflict
from solver.placement.made_rooms import SolvedRoom
from solver.placement.neighbourhood import in_the_way, joined_in_turn, standing
from solver.placement.open_rooms import OpenRoom, opened
from solver.placement.whole_rooms import place_wanted

__all__ = [
    "ROOM_WORK", "Budget", "CallWork", "OpenRoom", "SolvedRoom", "arrange", "can_be_used", "charge", "feasible", "finish",
    "in_the_way", "is_call_spent", "joined_in_turn", "minimal_conflict", "move_least", "moved_back", "opened", "place",
    "place_wanted", "problem_bytes", "standing", "walkable_when_empty", "with_joined_doors", "work_of_call",
]  # fmt: skip
