"""The guessing stage: rooms of somebody's own plan -> their types, and its main entrance; each guess with what told it."""

from solver.guessing.doors_between import with_entrance
from solver.guessing.room_types_of_plan import guessed_types, is_shaft, with_types

__all__ = ["guessed_types", "is_shaft", "with_entrance", "with_types"]
