"""Compose's solver: request -> scene, and scene -> repaired scene.

Comes in: a Request, a Scene, or a Room and a list of pieces. Goes out: Generated, Fixed, Answered, issues.
May import: catalogs. Not here: HTTP and files' names.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from solver.request import Request
from solver.scene import Scene

if TYPE_CHECKING:
    from solver.pipeline.drag import fix_frame, prepare_drag
    from solver.pipeline.explain import explain
    from solver.pipeline.export import export
    from solver.pipeline.fix import fix
    from solver.pipeline.generate import generate, reroll
    from solver.pipeline.place import place
    from solver.pipeline.restyle import restyle
    from solver.validator import validate
else:
    _MODULES = {
        "fix_frame": "pipeline.drag",
        "prepare_drag": "pipeline.drag",
        "reroll": "pipeline.generate",
        "validate": "validator",
    }

    def __getattr__(name: str) -> object:
        """Imports a flow when it is first named: the scene's types cost none of them, and one costs none of the others."""
        if name not in __all__:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        return getattr(import_module(f"{__name__}.{_MODULES.get(name, 'pipeline.' + name)}"), name)


__all__ = [
    "Request", "Scene", "explain", "export", "fix", "fix_frame", "generate", "place", "prepare_drag", "reroll", "restyle", "validate",
]  # fmt: skip
