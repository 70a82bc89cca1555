"""The calls, from document to document: what HTTP and the command line share."""

from __future__ import annotations

from base64 import b64decode, b64encode
from collections.abc import Callable, Mapping
from dataclasses import replace
from time import perf_counter
from typing import Final, NamedTuple, TypeAlias, cast

from catalogs import Catalogs
from service.contract import (
    DragAnswer,
    DragBody,
    ExplainBody,
    ExportBody,
    ExportFormat,
    ExportFormats,
    FixBody,
    FloorAnswer,
    FloorBody,
    FurnishBody,
    Health,
    ImportBody,
    Lines,
    PlaceAnswer,
    PlaceBody,
    ValidateAnswer,
    ValidateBody,
    ViewBody,
)
from service.effort import limited_to
from service.generating import check_size, draw_seed, generate_house
from solver import explain, export, fix, fix_frame, place, prepare_drag, validate
from solver.errors import FieldError
from solver.exchange import FORMATS, read, scene_schema, write, write_scene
from solver.export_formats import EXPORTERS, Freedom
from solver.exports import Files, is_available, packed
from solver.imported import ImportSettings
from solver.named_assets import with_assets
from solver.named_kinds import with_kinds
from solver.pipeline.import_plan import import_plan
from solver.pipeline.own_plan import furnish
from solver.plain import Document
from solver.requested import PieceRequest
from solver.scene import NO_ACCESS
from solver.scene_bodies import body_ids, check_ids
from solver.understanding import understood
from solver.validator import access_of, floors, metrics
from solver.view import report, view

Call: TypeAlias = Callable[[object, Catalogs], Document]


def furnish_plan(document: object, catalogs: Catalogs) -> Document:
    """Furnishes the rooms of somebody's own plan.

    Args:
        document: a `FurnishBody`.
        catalogs: the data to furnish from.

    Raises:
        FieldError: a field is wrong.
    """
    body = read(FurnishBody, document)
    check_size(body.scene)
    seed = draw_seed() if body.seed is None and body.scene.seed is None else body.seed
    with limited_to(body.effort) as work:
        made = furnish(
            body.scene, tuple(dict.fromkeys(body.rooms)), keep=body.keep, types=body.types, program=body.program, style=body.style,
            decorate=body.decorate, access=body.access, seed=seed, catalogs=catalogs, clock=perf_counter,
        )  # fmt: skip
    return write(replace(made, limited=work.limited()))


def fix_scene(document: object, catalogs: Catalogs) -> Document:
    """Repairs a scene with least movement.

    Args:
        document: a `FixBody`.
        catalogs: what the pieces' kinds are.

    Raises:
        FieldError: a field is wrong.
    """
    body = read(FixBody, document)
    check_size(body.scene)
    locked, moved = tuple(dict.fromkeys(body.locked)), tuple(dict.fromkeys(body.moved))
    fixed = None
    with limited_to(body.effort) as work:
        if body.dragging:
            fixed = fix_frame(body.scene, moved, locked=locked, previous=body.previous, catalogs=catalogs, clock=perf_counter)
        if fixed is None:
            fixed = fix(
                body.scene, locked=locked, moved=moved, on_conflict=body.on_conflict, previous=body.previous, catalogs=catalogs,
                clock=perf_counter,
            )  # fmt: skip
    return write(replace(fixed, limited=work.limited()))


def take_in_hand(document: object, catalogs: Catalogs) -> Document:
    """Prepares the room of a piece that is about to be dragged.

    Args:
        document: a `DragBody`.
        catalogs: what the pieces' kinds are.

    Raises:
        FieldError: a field is wrong.
    """
    body = read(DragBody, document)
    check_ids("id", (body.id,), body_ids(body.scene))
    check_ids("locked", body.locked, body_ids(body.scene))
    with limited_to():
        taken = prepare_drag(body.scene, body.id, locked=tuple(dict.fromkeys(body.locked)), catalogs=catalogs)
    return write(DragAnswer(None if taken.opening is None else b64encode(taken.opening).decode("ascii"), taken.bodies))


def place_pieces(document: object, catalogs: Catalogs, engine: str = "osqp") -> Document:
    """Places a list of pieces in a room.

    Args:
        document: a `PlaceBody`.
        catalogs: what pieces are whose sizes are not given.
        engine: the engine of the final QP.

    Raises:
        FieldError: a field is wrong.
    """
    body = read_place(document)
    with limited_to(body.effort) as work:
        answer = place(
            body.room, body.pieces, alternatives=body.alternatives, wall_thickness=body.wall_thickness, robot_width=body.robot_width,
            catalogs=catalogs, engine=engine, clock=perf_counter,
        )  # fmt: skip
    best = answer.best
    return write(
        PlaceAnswer(
            best.scene, best.relations, best.unplaced, answer.alternatives, answer.conflicts, best.issues, answer.timing_ms,
            answer.understood_as, work.limited(),
        )
    )  # fmt: skip


def read_place(document: object) -> PlaceBody:
    """Reads the body of /place; a piece without an id is called by its name, and the other way round.

    Raises:
        FieldError: a field is wrong.
    """
    body = read(PlaceBody, document)
    return replace(body, pieces=tuple(_named(index, wish) for index, wish in enumerate(body.pieces)))


def _named(index: int, wish: PieceRequest) -> PieceRequest:
    if not wish.id and not wish.name:
        raise FieldError(f"pieces[{index}].id", "is missing, and so is the name", "an id, or a name")
    return replace(wish, id=wish.id or wish.name, name=wish.name or wish.id)


def validate_scene(document: object, catalogs: Catalogs) -> Document:
    """Lists what breaks the rules in a scene, and measures it.

    Args:
        document: a `ValidateBody`.
        catalogs: which sides of a piece are used, and what rooms require.

    Raises:
        FieldError: a field is wrong.
    """
    body = read(ValidateBody, document)
    scene, flagged = body.scene, tuple(dict.fromkeys(body.flagged or ()))
    check_ids("flagged", flagged, body_ids(scene))
    issues = validate(scene, catalogs)
    is_wanted = body.flagged is not None if body.report is None else body.report
    measured = metrics(scene, catalogs)
    words = Lines(*report(scene, _areas(measured), issues, flagged)) if is_wanted else None
    access = None if body.access is None or body.access == NO_ACCESS else access_of(scene, body.access, catalogs).document()
    return write(ValidateAnswer(tuple(issues), measured, understood(scene, catalogs).understood_as, words, access))


def view_scene(document: object, _: Catalogs | None = None) -> Document:
    """Writes a scene for a person to read.

    Args:
        document: a `ViewBody`.

    Raises:
        FieldError: a field is wrong.
    """
    scene = read(ViewBody, document).scene
    return write(Lines(*view(scene, _areas(metrics(scene)))))


def _areas(measured: Document) -> dict[str, float]:
    """Returns the clear floors of rooms by their ids, m2."""
    return {name: room["clear_area"] for name, room in measured["rooms"].items()}


def explain_place(document: object, catalogs: Catalogs) -> Document:
    """Says where a piece was wished and what holds it back from there.

    Args:
        document: an `ExplainBody`.
        catalogs: what the house was furnished with.

    Raises:
        FieldError: a field is wrong.
    """
    body = read(ExplainBody, document)
    with limited_to():
        return write(explain(body.scene, body.id, catalogs=catalogs))


def import_file(document: object, catalogs: Catalogs) -> Document:
    """Reads a foreign floor plan.

    Args:
        document: an `ImportBody`.
        catalogs: whose room types and kinds are known.

    Raises:
        FieldError: a field is wrong, or the file cannot be read.
    """
    body = read(ImportBody, document)
    if (body.file is None) == (body.document is None):
        raise FieldError(
            "file", "is missing" if body.file is None else "is given, and so is the document", "a file in base64, or a document"
        )
    try:
        content = b64decode(body.file or "", validate=True)
    except ValueError:
        raise FieldError("file", "is not base64", "a file in base64") from None
    settings = ImportSettings(body.level, body.unit, body.furniture == "keep")
    return import_content(content if body.document is None else dict(body.document), catalogs, settings, body.name)


def import_content(content: object, catalogs: Catalogs, settings: ImportSettings | None = None, name: str = "") -> Document:
    """Reads a foreign floor plan from a file's bytes, or from the document in a JSON file.

    Raises:
        FieldError: the file cannot be read; names the place.
    """
    return write(import_plan(content, name, settings, catalogs=catalogs))


def floor_of(document: object, catalogs: Catalogs | None = None) -> Document:
    """Says where the floor of rooms is clear, kept free, and free to come to.

    Args:
        document: a `FloorBody`.
        catalogs: where profiles of access are; ours by default.

    Raises:
        FieldError: a field is wrong.
    """
    body = read(FloorBody, document)
    check_ids("rooms", body.rooms, [room.id for room in body.scene.rooms])
    return write(FloorAnswer(tuple(floors(body.scene, body.rooms, catalogs))))


def export_scene(document: object, catalogs: Catalogs) -> Document:
    """Returns a scene as a document of its own, every default and every body's kind written out: what a file of it holds.

    Args:
        document: an `ExportBody`; or a scene by itself, as such a file holds it.
        catalogs: the kinds.

    Raises:
        FieldError: a field is wrong.
    """
    return write_scene(with_assets(with_kinds(_sent(document).scene, catalogs), catalogs))


class ExportedFile(NamedTuple):
    """What an export travels as: its name, its media type, its content."""

    name: str
    media_type: str
    content: bytes


def export_files(document: object, catalogs: Catalogs, format: str) -> Files:
    """Returns the files of a scene in the format of a simulator, an editor or a training set.

    Args:
        document: an `ExportBody`; or a scene by itself.
        catalogs: what kinds of bodies look like and weigh.
        format: one of EXPORTERS.

    Raises:
        FieldError: a field is wrong, or the format's library is not installed.
    """
    body = _sent(document)
    return export(
        body.scene, format, free=cast(Freedom, body.free), strict=body.strict, scale=body.scale, called=body.called, catalogs=catalogs
    )


def export_one(document: object, catalogs: Catalogs, format: str) -> ExportedFile:
    """Returns an export as one file, an archive where there are several.

    Raises:
        FieldError: as `export_files`.
    """
    return ExportedFile(*packed(export_files(document, catalogs, format), format, EXPORTERS[format].media_type))


def _sent(document: object) -> ExportBody:
    """Reads a body of /export."""
    if isinstance(document, Mapping) and "scene" not in document and "rooms" in document:
        document = {"scene": document}
    return read(ExportBody, document)


def formats_document(_: Catalogs | None = None) -> Document:
    """Returns the formats that /export writes, beside the scene's own."""
    formats = (ExportFormat(name, one.words, is_available(name)) for name, one in EXPORTERS.items())
    return write(ExportFormats(tuple(write(one) for one in formats)))


def catalog_document(catalogs: Catalogs) -> Document:
    """Returns all that the service knows: kinds of furniture, floorings, room types."""
    return catalogs.model_dump(mode="json")


def schema_document(_: Catalogs | None = None) -> Document:
    """Returns the JSON Schema of a scene."""
    return scene_schema()


CALLS: Final[Mapping[str, Call]] = {
    "generate": generate_house, "furnish": furnish_plan, "fix": fix_scene, "drag": take_in_hand, "place": place_pieces,
    "validate": validate_scene, "view": view_scene, "export": export_scene, "explain": explain_place, "floor": floor_of,
    "import": import_file,
}  # fmt: skip
"""The calls that take a body, by the names of their routes."""
LIGHT: Final = frozenset({"drag", "floor", "validate", "view"})
"""Those that are quickly done where the body is small: they have a lane of their own."""
MAY_BE_EMPTY: Final = frozenset({"generate"})
"""Those whose body may be left out: it asks for all defaults then."""
QUESTIONS: Final[Mapping[str, Callable[[Catalogs], Document]]] = {
    "catalog": catalog_document, "schema": schema_document, "exports": formats_document, "healthz": lambda _: write(Health()),
}  # fmt: skip
"""Those that take none."""


EXPORT_FORMATS: Final = (*FORMATS, *EXPORTERS)
"""What /export writes."""
