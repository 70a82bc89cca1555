"""`under`: at a side of another piece, looking at it and reaching under it."""

from solver.relations.at_side import AtSide
from solver.relations.relation import HELD, Fit, LeastMost

UNTUCKED_MM = 160
"""How much of a tucked piece's depth stays outside its table where places are sought."""


class Under(AtSide):
    """Stands at a side of another piece and reaches under it, facing it."""

    turns = looks = True
    sides = ("front",)
    sought_mm, held_mm = (-10_000, -50), (-10_000, -10)

    def gap(self, fit: Fit) -> LeastMost:
        """Returns a gap with which it does reach under the other; none (low above high) where the relation's own does not."""
        low, high = super().gap(fit)
        if fit.tolerance is HELD:
            return low, min(high, -1)
        depth = fit.own[1] if fit.turn % 180 == 0 else fit.own[0]
        low = max(low, UNTUCKED_MM - depth)
        return (low, high) if high < 0 else (0, -1)
