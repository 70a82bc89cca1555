"""export(): a scene -> files in the format of a simulator, an editor or a training set.

Comes in: Scene. Goes out: files by name. May import: every stage. Not here: what a stage does inside.
"""

from __future__ import annotations

from typing import Final

from catalogs import Catalogs, load_catalogs
from solver.errors import SceneError
from solver.exchange import FORMATS, write_scene
from solver.export_formats import Freedom
from solver.exports import ExportSettings, Files, describe, written_as
from solver.named_assets import with_assets
from solver.named_kinds import with_kinds
from solver.scene import Issue, Scene
from solver.validator import validate

LEAST_SIDE_M: Final = 0.001
"""The shortest side of a room that any format can say, m: the lattice of all footprints."""
TOLD: Final = 20
"""How many errors of a scene a file tells of; the rest is counted."""


def export(scene: Scene, format: str, *, free: Freedom = "light", strict: bool = False, catalogs: Catalogs | None = None) -> Files:
    """Writes a scene in a format.

    Args:
        scene: any scene.
        format: one of `compose_homes.EXPORT_FORMATS`: glb, usd, mjcf and so on.
        free: what a simulator may move: "none", "light" things that stand, or all that is "standing".
        strict: refuses a scene with errors; else the files say them.
        catalogs: what kinds of bodies look like and weigh; ours by default.

    Returns:
        Contents by file name; folders with slashes.

    Raises:
        RequestError: there is no such format, or what it needs is not installed.
        SceneError: a room has a side under a millimetre; or the scene has errors and `strict` is set.

    Example:
        >>> from compose_homes import Room, Scene, export
        >>> list(export(Scene(rooms=(Room("den", width=4, depth=3),)), "csv"))
        ['house.csv']
    """
    known = catalogs or load_catalogs()
    _check_sides(scene)
    errors = [issue for issue in validate(scene, known) if issue.severity == "error"]
    if errors and strict:
        raise SceneError("scene", f"has {len(errors)} errors: {errors[0].message}", "a scene without errors, or without strict")
    shown = with_assets(with_kinds(scene, known), known)
    model = describe(shown, known, free, _told(errors))
    kept = shown if model.assets else scene
    return written_as(model, ExportSettings(format, lambda: FORMATS["json"].dump(write_scene(kept)).rstrip()))


def _check_sides(scene: Scene) -> None:
    for k, room in enumerate(scene.rooms):
        for side in ("width", "depth"):
            if getattr(room, side) < LEAST_SIDE_M:
                raise SceneError(f"rooms[{k}].{side}", "is under a millimetre, which no format can say", f"at least {LEAST_SIDE_M} m")


def _told(errors: list[Issue]) -> list[str]:
    told = [f"{issue.rule} {issue.room or ''}: {issue.message}" for issue in errors[:TOLD]]
    return told + ([f"and {len(errors) - TOLD} more errors"] if len(errors) > TOLD else [])
