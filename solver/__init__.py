"""Compose's solver: request -> scene, and scene -> repaired scene.

Comes in: a Request, a Scene, or a Room and a list of pieces. Goes out: Generated, Fixed, Answered, issues.
May import: catalogs. Not here: HTTP and files' names.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from solver.scene import Request, Scene

if TYPE_CHECKING:
    from solver.pipeline import explain, export, fix, generate, place, prepare_drag, reroll, validate
else:

    def __getattr__(name: str) -> object:
        """Imports the flows when one is first named: the scene's types cost none of them."""
        return getattr(import_module(f"{__name__}.pipeline"), name)


__all__ = ["Request", "Scene", "explain", "export", "fix", "generate", "place", "prepare_drag", "reroll", "validate"]
