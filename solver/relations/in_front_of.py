"""`in_front_of`: before another piece's front."""

from solver.relations.at_side import AtSide


class InFrontOf(AtSide):
    """Stands before another piece's front (or the `sides` named), centred if it can."""

    sides = ("front",)
    best_gap, sought_mm, held_mm = 0.4, (250, 650), (0, 700)
    best_align = "centre"
