"""Compose's solver: request -> scene, and scene -> repaired scene.

Comes in: a Request, a Scene, or a Room and Wishes. Goes out: Generated, Fixed, Answered, issues.
May import: catalogs. Not here: HTTP and files' names.
"""

from solver.pipeline import fix, generate, place, reroll
from solver.requested import Wish
from solver.scene import Request, Scene
from solver.validate import validate

__all__ = ["Request", "Scene", "Wish", "fix", "generate", "place", "reroll", "validate"]
