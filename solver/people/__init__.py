"""People and pets of a furnished house: who is where, on free floor or on a seat, never in the way.

Comes in: furnished (and dressed) rooms with their spaces, the catalogs, a seed. Goes out: the scene's `dynamic`. May import: the
ground floor, catalogs. Not here: what becomes of people who are in the way of a repair (repair).

`household` draws who is there, `floor` holds what a room leaves free, `standing`, `sitting` and `pets` find a pose, the ground floor's
`ways` tells exactly whether everything stays within reach.
"""

from solver.people.household import Home, peopled

__all__ = ["Home", "peopled"]
