"""The one validator: the rules of docs/scene.md, one function each.

Comes in: a scene and the catalogs. Goes out: issues in a fixed order, and measures. Serves /generate, /fix, /validate, the page
and the tests. May import: scene, errors, catalogs, core. Shares no geometry with the solver: where the solver linearises, this is
exact, in integers (lattice.py). What breaks a rule is found in solver/core/validate; here are the words. `check` keeps what it
found, so that a changed scene is checked again only where it changed. Adding a rule: CONTRIBUTING.md.
"""

from solver.validator.accessibility import access_of
from solver.validator.checking import Checked, RoomAlone, check, check_made, room_alone, validate
from solver.validator.judging import FINDING_WORK
from solver.validator.metrics import floors, metrics
from solver.validator.room_rules import sharing_floor
from solver.validator.rules import RULES

__all__ = [
    "FINDING_WORK",
    "RULES",
    "Checked",
    "RoomAlone",
    "access_of",
    "check",
    "check_made",
    "floors",
    "metrics",
    "room_alone",
    "sharing_floor",
    "validate",
]
