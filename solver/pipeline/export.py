"""export(): a scene -> files in the format of a simulator, an editor or a training set."""

from collections.abc import Mapping, Sequence
from typing import Final

from catalogs import Catalogs, load_catalogs
from solver.answers import Issue
from solver.demanded import demand
from solver.errors import SceneError
from solver.exchange import as_read, dump_scene
from solver.export_formats import EXPORTERS, SCENE_FILE, Freedom
from solver.exports import ExportSettings, Files, describe, written_as
from solver.named_assets import with_assets
from solver.scene import Scene
from solver.scene_bodies import check_scene
from solver.validator import floors, validate

LEAST_SIDE_M: Final = 0.001
"""The shortest side of a room that any format can say, m: the lattice of all footprints."""
TOLD: Final = 20
"""How many errors of a scene a file tells of; the rest is counted."""


def export(  # noqa: PLR0913 - keyword-only options of a public function
    scene: Scene,
    format: str,
    *,
    free: Freedom = "light",
    strict: bool = False,
    scale: int | None = None,
    called: Mapping[str, str] | None = None,
    catalogs: Catalogs | None = None,
) -> Files:
    """Writes a scene in a format.

    Args:
        scene: any scene.
        format: one of `compose_homes.EXPORT_FORMATS`: glb, usd, mjcf and so on.
        free: what a simulator may move: "none", "light" things that stand, or all that is "standing".
        strict: refuses a scene with errors; else the files say them.
        scale: of an SVG plan, 1 to so much; by default the largest that A3 holds.
        called: what an SVG plan calls room types, by type; by default in English.
        catalogs: what kinds of bodies look like and weigh; ours by default.

    Returns:
        Contents by file name; folders with slashes. Beside several files is the scene, `compose_scene.json`.

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
    scene = as_read(scene)  # one made in Python may have lists, and whole numbers or NumPy's
    issues = validate(scene, known)
    errors = [issue for issue in issues if issue.severity == "error"]
    if errors and strict:
        raise SceneError("scene", f"has {len(errors)} errors: {errors[0].message}", "a scene without errors, or without strict")
    return export_each(scene, (format,), known, issues, free, scale=scale, called=called)[format]


def export_each(  # noqa: PLR0913 - what export() is asked for, and what it has found out
    scene: Scene,
    formats: Sequence[str],
    catalogs: Catalogs,
    issues: Sequence[Issue],
    free: Freedom,
    *,
    scale: int | None = None,
    called: Mapping[str, str] | None = None,
) -> dict[str, Files]:
    """Returns the files of a scene in several formats, described once.

    Args:
        scene: judged already; no side of a room is under a millimetre.
        formats: of `compose_homes.EXPORT_FORMATS`.
        catalogs: what kinds of bodies look like and weigh.
        issues: what the validator says of the scene.
        free: what a simulator may move.
        scale: of an SVG plan, 1 to so much.
        called: what an SVG plan calls room types, by type.

    Raises:
        RequestError: there is no such format, or what it needs is not installed.
    """
    errors = [issue for issue in issues if issue.severity == "error"]
    shown = with_assets(scene, catalogs)
    bodies = sum(len(room.furniture) + len(room.decorations) for room in scene.rooms) + len(scene.dynamic)
    demand(bodies * sum(EXPORTERS[name].body_work for name in formats if name in EXPORTERS))
    model = describe(shown, catalogs, free, _told(errors))
    kept = shown if model.assets else scene

    def text() -> str:
        return dump_scene(kept, "json").decode().rstrip()

    written = {name: written_as(model, ExportSettings(name, text, lambda: floors(scene), scale, called)) for name in formats}
    return {name: files if len(files) == 1 else {**files, SCENE_FILE: f"{text()}\n".encode()} for name, files in written.items()}


def _check_sides(scene: Scene) -> None:
    check_scene(scene)
    for k, room in enumerate(scene.rooms):
        for side in ("width", "depth"):
            if getattr(room, side) < LEAST_SIDE_M:
                raise SceneError(f"rooms[{k}].{side}", "is under a millimetre, which no format can say", f"at least {LEAST_SIDE_M} m")


def _told(errors: list[Issue]) -> list[str]:
    told = [f"{issue.rule} {issue.room or ''}: {issue.message}" for issue in errors[:TOLD]]
    return told + ([f"and {len(errors) - TOLD} more errors"] if len(errors) > TOLD else [])
