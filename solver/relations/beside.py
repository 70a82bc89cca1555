"""`beside`: at the left or right of another piece, close to it."""

from solver.relations.at_side import AtSide


class Beside(AtSide):
    """Stands at a side of another piece (left or right unless `sides` says otherwise), backs in line if it can."""

    among_copies = True
    best_align = "back"
