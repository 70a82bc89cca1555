"""The one validator: the contract's rules, one function each.

Comes in: a scene and the catalogs. Goes out: issues in a fixed order, and measures. Serves /generate, /fix, /validate, the page
and the tests. May import: scene, errors, catalogs. Shares no code with the solver: where the solver linearises, this is
exact, in integers (lattice.py). Adding a rule: one function, a row in RULES, its two-body test.
"""

from solver.validate.floor import floors
from solver.validate.metrics import metrics
from solver.validate.rules import RULES, validate

__all__ = ["RULES", "floors", "metrics", "validate"]
