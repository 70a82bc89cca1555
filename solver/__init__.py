"""Compose's solver: request -> scene, and scene -> repaired scene.

Comes in: a Request or a Scene. Goes out: Generated, Fixed, issues. May import: catalogs. Not here: HTTP and files' names.
"""

from solver.pipeline import fix, generate, reroll
from solver.scene import Request, Scene
from solver.validate import validate

__all__ = ["Request", "Scene", "fix", "generate", "reroll", "validate"]
