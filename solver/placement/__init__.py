"""Anchors -> exact places: the heart.

Comes in: rooms as (Space, wanted pieces). Goes out: Arrangements on the millimetre lattice, with reasons for what was
left out. May import: the ground floor. Not here: rules of room types (furnish), the contract's rules (validate).
"""

from solver.placement.arrange import feasible
from solver.placement.as_wished import arrange_as_wished, brought_from
from solver.placement.budget import ROOM_WORK, Budget
from solver.placement.explain import minimal_conflict
from solver.placement.settle import place, settle

__all__ = ["ROOM_WORK", "Budget", "arrange_as_wished", "brought_from", "feasible", "minimal_conflict", "place", "settle"]
