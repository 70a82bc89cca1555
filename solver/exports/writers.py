"""A house written in a format, and how its files travel as one."""

import io
import struct
import zipfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from importlib.util import find_spec
from typing import Any, Final

from solver.body_parts import BodyPart
from solver.errors import RequestError
from solver.export_formats import EXPORTERS
from solver.exports.asset_surfaces import CREDITS, credits_of
from solver.exports.model import HouseModel, ModelBody

Files = dict[str, bytes]
"""Contents by file name; folders with slashes."""
_EPOCH: Final = (1980, 1, 1, 0, 0, 0)
"""When all files of an archive were changed: its bytes must not depend on the day."""
_LOCAL_HEADER: Final = 30
_EXTRA_HEADER: Final = struct.Struct("<HH")
_PADDING: Final = 0x1986
"""What USD calls a field of padding in an archive's header."""


@dataclass(frozen=True)
class ExportSettings:
    """How to write: the format's name; what a format may ask for: the scene's document as JSON, and its rooms' free floor.

    `floors` returns for each room its id as `room`, and under `free` rectangles [x0, z0, x1, z1] that the robot covers, room-relative m;
    `scale` is a plan's, 1 to so much; `called` says what its room types are named, where not in English.
    """

    format: str
    scene_text: Callable[[], str] = lambda: "null"
    floors: Callable[[], Sequence[Mapping[str, Any]]] = tuple
    scale: int | None = None
    called: Mapping[str, str] | None = None


def written_as(model: HouseModel, settings: ExportSettings) -> Files:
    """Writes a house in a format.

    Raises:
        RequestError: there is no such format, or a library that it needs is not installed; says how to install it.
    """
    exporter = EXPORTERS.get(settings.format)
    if exporter is None:
        raise RequestError("format", f"unknown format {settings.format!r:.60}", ", ".join(EXPORTERS))
    if exporter.needs and not is_available(settings.format):
        problem = f"{settings.format} needs {exporter.needs[0]}, which is not installed"
        raise RequestError("format", problem, f"another format; or pip install 'compose-homes[{exporter.needs[1]}]'")
    shown = _shut(model) if exporter.shows_assets else without_assets(model)
    files: Files = import_module(f".formats.{exporter.module}", __package__).write(shown, settings)
    return {**files, CREDITS: credits_of(shown.assets)} if shown.assets else files


def without_assets(model: HouseModel) -> HouseModel:
    """Returns a house whose bodies are shown as their kinds' shapes."""
    if not model.assets:
        return model
    return replace(model, bodies=tuple(body._replace(asset=None) for body in model.bodies), assets={})


def _shut(model: HouseModel) -> HouseModel:
    """Returns a house in which bodies that are shown as assets have no fronts: nobody knows what of an asset opens."""
    solid: dict[int, tuple[BodyPart, ...]] = {}

    def shut(body: ModelBody) -> ModelBody:
        if not (body.asset and body.fronts):
            return body
        parts = solid.setdefault(id(body.parts), tuple(part._replace(front=None) for part in body.parts))
        return body._replace(fronts=(), parts=parts)

    return replace(model, bodies=tuple(map(shut, model.bodies))) if model.assets else model


def is_available(format: str) -> bool:
    """Tells whether the library that a format needs is installed."""
    needs = EXPORTERS[format].needs
    return needs is None or find_spec(needs[0]) is not None


def packed(files: Files, name: str, media_type: str) -> tuple[str, str, bytes]:
    """Returns what travels as one file: (its name, media type, content); several files as a ZIP archive of equal bytes."""
    if len(files) == 1:
        ((only, content),) = files.items()
        return only, media_type, content
    return f"{name}.zip", "application/zip", zipped(files)


def zipped(files: Files, aligned: int = 0) -> bytes:
    """Returns files as a ZIP archive: the same bytes on every day. `aligned`: not compressed, each begun at a multiple of so many bytes."""
    archive, kind = io.BytesIO(), zipfile.ZIP_STORED if aligned else zipfile.ZIP_DEFLATED
    with zipfile.ZipFile(archive, "w", kind) as opened:
        for path, content in files.items():
            info = zipfile.ZipInfo(path, _EPOCH)
            if aligned:
                padding = -(archive.tell() + _LOCAL_HEADER + len(path.encode()) + _EXTRA_HEADER.size) % aligned
                info.extra = _EXTRA_HEADER.pack(_PADDING, padding) + bytes(padding)
            opened.writestr(info, content, kind, 6)
    return archive.getvalue()
