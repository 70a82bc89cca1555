"""Furnish: a room -> its space, and every piece to be placed with its candidates; by the rules of its type, or by a user's list.

Comes in: a `scene.Room` with openings, the catalogs, the room's stream, or a list of requests. Goes out: `pieces.Space` and
`pieces.Piece`. May import: catalogs and the ground floor. Not here: choosing among candidates and exact places (placement).
"""

from solver.furnish.compiled_types import opened_about
from solver.furnish.habits import Habits, habits_of
from solver.furnish.listed_pieces import ListedPieces, Listing, tucks
from solver.furnish.room_types import LowRooms, as_low_as, unwanted_pieces, wanted_pieces, wanted_rows
from solver.furnish.zones import scope_of, space_of

__all__ = [
    "Habits", "ListedPieces", "Listing", "LowRooms", "as_low_as", "habits_of", "opened_about", "scope_of", "space_of", "tucks",
    "unwanted_pieces", "wanted_pieces", "wanted_rows",
]  # fmt: skip
