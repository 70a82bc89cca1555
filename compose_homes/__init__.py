"""Compose as a library: lays out whole furnished homes, and proves they work.

    from compose_homes import Request, dump, generate

    house = generate(Request(seed=42, program="one_bed"))
    dump(house.scene, "house.yaml")

Everything that is public stands here. To import it costs nothing: every name is imported when it is first said, the compiled core when
something is first placed or judged.
"""

TYPE_CHECKING = False  # `typing` and `importlib` would be all that `compose` waits for

if TYPE_CHECKING:
    from compose_homes.files import dump, load
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
    from solver.answers import Conflict, Fixed, Generated, Issue, Move, Pose
    from solver.errors import ComposeError, FieldError, RequestError, SceneError, SyntaxFault
    from solver.pipeline.own_plan import furnish
    from solver.request import Request
    from solver.scene import Decoration, Dynamic, Flooring, Furniture, Level, Opening, Room, Scene, Sides, Size, WallFinish
    from solver.version import VERSION as __version__
else:
    _FLOWS = ("explain", "export", "fix", "fix_frame", "generate", "place", "reroll", "restyle", "validate")

    def __getattr__(name: str) -> object:
        """Imports a name when it is first said: before that `compose` has begun, and a scene's types cost no catalogs."""
        if name not in __all__:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from importlib import import_module  # noqa: PLC0415

        first = import_module(f"{__name__}.named_first")
        if name == "furnish":
            from solver.pipeline.own_plan import furnish  # noqa: PLC0415 - `solver.furnish` is a stage

            return furnish
        if name in _FLOWS:
            return first.flow(name)
        return getattr(first if name in first.__all__ else import_module(f"{__name__}.named_later"), name)


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
