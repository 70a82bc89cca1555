"""Compose as a library: lays out whole furnished homes, and proves they work.

    from compose_homes import Request, dump, generate

    house = generate(Request(seed=42, program="one_bed"))
    dump(house.scene, "house.yaml")

Everything that is public stands here. To import it costs little: what stands on the catalogs is imported when it is first named, the
compiled core when something is first placed or judged.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from compose_homes.files import dump, load
from solver.answers import Conflict, Fixed, Generated, Issue, Move, Pose
from solver.errors import ComposeError, FieldError, RequestError, SceneError, SyntaxFault
from solver.request import Request
from solver.scene import Decoration, Dynamic, Flooring, Furniture, Level, Opening, Room, Scene, Sides, Size, WallFinish
from solver.version import VERSION as __version__

if TYPE_CHECKING:
    from compose_homes.named_later import (
        EXPORT_FORMATS,
        Answered,
        CatalogError,
        Catalogs,
        ChosenEntrance,
        Explained,
        FurnishedPlan,
        Held,
        Hold,
        ImportSettings,
        PieceRequest,
        Placement,
        PlanImport,
        RelationSpec,
        RoomGuess,
        Unplaced,
        add_assets,
        import_plan,
        load_catalogs,
    )
    from solver import explain, export, fix, fix_frame, generate, place, reroll, restyle, validate
    from solver.pipeline.own_plan import furnish
else:
    from solver import __getattr__ as _flow

    _FLOWS = ("explain", "export", "fix", "fix_frame", "generate", "place", "reroll", "restyle", "validate")

    def __getattr__(name: str) -> object:
        if name == "furnish":
            from solver.pipeline.own_plan import furnish  # noqa: PLC0415 - `solver.furnish` is a stage

            return furnish
        return _flow(name) if name in _FLOWS else getattr(import_module(f"{__name__}.named_later"), name)


__all__ = [
    "EXPORT_FORMATS",
    "Answered",
    "CatalogError",
    "Catalogs",
    "ChosenEntrance",
    "ComposeError",
    "Conflict",
    "Decoration",
    "Dynamic",
    "Explained",
    "FieldError",
    "Fixed",
    "Flooring",
    "FurnishedPlan",
    "Furniture",
    "Generated",
    "Held",
    "Hold",
    "ImportSettings",
    "Issue",
    "Level",
    "Move",
    "Opening",
    "PieceRequest",
    "Placement",
    "PlanImport",
    "Pose",
    "RelationSpec",
    "Request",
    "RequestError",
    "Room",
    "RoomGuess",
    "Scene",
    "SceneError",
    "Sides",
    "Size",
    "SyntaxFault",
    "Unplaced",
    "WallFinish",
    "__version__",
    "add_assets",
    "dump",
    "explain",
    "export",
    "fix",
    "fix_frame",
    "furnish",
    "generate",
    "import_plan",
    "load",
    "load_catalogs",
    "place",
    "reroll",
    "restyle",
    "validate",
]  # fmt: skip
