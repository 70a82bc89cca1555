"""A home of a dataset as its row of the table of houses, and as files of archives."""

from __future__ import annotations

import io
import tarfile
from collections.abc import Iterator, Mapping
from pathlib import PurePosixPath
from typing import Any, Final

from service.dataset.dataset_plan import JSON, DatasetPlan, MadeHome, request_text
from service.packed_catalogs import unpacked
from solver.exchange import FORMATS
from solver.exports import packed
from solver.pipeline.export import export_each
from solver.plain import Document
from solver.scene import Scene
from solver.scene_bodies import counted
from solver.version import VERSION

CLEAN, WITH_ERRORS, REFUSED = "clean", "errors", "refused"
"""What became of a home: it breaks no rule that must hold; it breaks one; its request cannot be met."""
_MISSING: Final = "missing_required"


def house_row(plan: DatasetPlan, home: MadeHome, split: str) -> Document:
    """Returns a home's row of the table of houses, by its columns; what it does not say is null."""
    asked = home.request.program
    errors = sum(issue.severity == "error" for issue in home.issues)
    row: Document = {
        "seed": home.request.seed,
        "id": f"house_{home.request.seed}",
        "split": split,
        "status": REFUSED if home.scene is None else WITH_ERRORS if errors else CLEAN,
        "program": asked if asked is None or isinstance(asked, str) else FORMATS[JSON].dump(dict(asked)).strip(),
        "request": request_text(home.request),
        "catalog": home.catalog,
        "catalog_fingerprint": plan.fingerprints[home.catalog],
        "version": VERSION,
        "errors": errors,
        "warnings": len(home.issues) - errors,
        "missing": sum(issue.rule == _MISSING for issue in home.issues),
        "issues": [f"{issue.severity} {issue.rule} {issue.room or ''}: {issue.message}" for issue in home.issues],
        "refused": home.refused,
        "digest": home.digest or None,
    }
    return row if home.scene is None else {**row, **_figures(home.scene), "scene": home.text.decode() if JSON in plan.formats else None}


def _figures(scene: Scene) -> Document:
    certificate: Mapping[str, Any] = scene.certificate or {}
    counts, reports = counted(scene.rooms, scene.dynamic), list(certificate["rooms"].values())
    size = scene.size
    return {
        "style": (scene.request or {}).get("style"),
        "width": size.width if size else None,
        "depth": size.depth if size else None,
        "area": round(sum(room.floor_m2 for room in scene.rooms if not room.outdoor), 4),
        **{name: counts[name] for name in ("rooms", "doors", "windows", "furniture", "decorations")},
        "people": counts["dynamic"],
        "proven": sum(bool(report["proven"]) for report in reports),
        "best": sum(bool(report["best"]) for report in reports),
        "left_out": sum(len(report["left_out"]) for report in reports),
        "unjoined": [" ".join(pair) for pair in certificate["unjoined"]],
        "notes": list(certificate["notes"]),
    }


def members_of(plan: DatasetPlan, home: MadeHome) -> Iterator[tuple[tarfile.TarInfo, io.BytesIO]]:
    """Yields a home's files as an archive takes them, `<seed>.<format>` as webdataset groups them; several of one format as one ZIP.

    Files of one format refer to each other by their names, which webdataset could not tell from keys.
    """
    if home.scene is None:
        return
    if JSON in plan.formats:
        yield _member(f"{home.request.seed}.{JSON}", home.text)
    catalogs = unpacked(plan.catalogs[home.catalog])
    written = export_each(home.scene, plan.exported, catalogs, home.issues, "light")
    for format, files in written.items():
        name, _, content = packed(files, format, "")
        suffix = PurePosixPath(name).suffix
        yield _member(f"{home.request.seed}.{format if suffix == f'.{format}' else f'{format}{suffix}'}", content)


def _member(name: str, content: bytes) -> tuple[tarfile.TarInfo, io.BytesIO]:
    """Returns a file for an archive whose bytes must not depend on the day or on who writes it."""
    info = tarfile.TarInfo(name)
    info.size = len(content)
    return info, io.BytesIO(content)
