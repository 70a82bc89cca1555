"""`around`: at one of the places around another piece, looking at it."""

from solver.relations.at_side import AtSide


class Around(AtSide):
    """Takes one of the places around another piece, facing it; long sides take several, filled in pairs."""

    turns = looks = True
    sides = ("front", "back", "left", "right")
    held_mm = (-10_000, 300)
