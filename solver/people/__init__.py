"""People and pets of a furnished house: who is where, on free floor or on a seat, never in the way.

Comes in: furnished (and decorated) rooms with their spaces, the catalogs, a seed. Goes out: the scene's `dynamic`. May import: the
ground floor, catalogs. Not here: what becomes of people who are in the way of a repair (repair).

`household` draws who is there and finds each a place; the ground floor's `free_floor` tells exactly what is free and whether everything
stays within reach.
"""

from solver.people.household import Household, peopled

__all__ = ["Household", "peopled"]
