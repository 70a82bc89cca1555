"""The calls that are made in workers, from document to document: what HTTP and the command line share. Start reading here.

Each is one function, from the body that it takes to what it answers; route, reading and OpenAPI follow from these types. What it does is
imported when it does it: a command loads its own flow, and the service, whose workers do all of them, none.
"""

from __future__ import annotations

from base64 import b64decode, b64encode
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from time import perf_counter
from typing import TYPE_CHECKING, Any, Final, NamedTuple, cast, get_type_hints

from catalogs import Catalogs
from service import contract
from service.effort import limited_to
from service.generating import check_size, draw_seed, made_house
from solver.answers import Explained, Fixed, FurnishedPlan, Generated, ImportSettings, PlanImport
from solver.errors import FieldError
from solver.exchange import FORMATS, misspelt, read, scene_schema, write
from solver.export_formats import EXPORTERS, Freedom
from solver.plain import Document
from solver.request import NO_ACCESS, Request
from solver.scene import Scene
from solver.scene_bodies import body_ids, check_id, check_ids
from solver.view import report, view

if TYPE_CHECKING:
    from solver.exports import Files


@dataclass(frozen=True)
class Call:
    """A call: a function from a body and the catalogs to an answer, asked with a document and answering with one.

    The types of the function (`work`) say which documents; `reads` makes the body of one, by default as its type says.
    """

    work: Callable[..., Any]
    reads: Callable[[object], Any] | None = None

    @cached_property
    def types(self) -> tuple[Any, Any]:
        """What it takes and answers."""
        taken, *_, answered = get_type_hints(self.work, include_extras=True).values()
        return taken, answered

    def __call__(self, document: object, catalogs: Catalogs, *options: Any) -> Document:
        """Makes the call.

        Raises:
            FieldError: a field is wrong.
        """
        body = self.reads(document) if self.reads else read(self.types[0], document)
        return write(self.work(body, catalogs, *options))


CALLS: Final[dict[str, Call]] = {}
"""The calls that take a body, by the names of their routes."""


def _call(name: str, reads: Callable[[object], Any] | None = None) -> Callable[[Callable[..., Any]], Call]:
    """Makes a function the call of a name."""
    return lambda work: CALLS.setdefault(name, Call(work, reads))


@_call("generate", reads=lambda document: document)
def generate_house(body: Request | contract.RerollBody | contract.RestyleBody | None, catalogs: Catalogs) -> Generated:
    """Makes a furnished house, furnishes some rooms of one anew, or gives one another style."""
    return made_house(body, catalogs)


@_call("furnish")
def furnish_plan(body: contract.FurnishBody, catalogs: Catalogs) -> FurnishedPlan:
    """Furnishes the rooms of somebody's own plan; says what was guessed of it."""
    from solver.pipeline.own_plan import furnish

    check_size(body.scene)
    seed = draw_seed() if body.seed is None and body.scene.seed is None else body.seed
    with limited_to(body.effort) as work:
        made = furnish(
            body.scene, tuple(dict.fromkeys(body.rooms)), keep=body.keep, types=body.types, program=body.program, style=body.style,
            decorate=body.decorate, access=body.access, seed=seed, catalogs=catalogs, clock=perf_counter,
        )  # fmt: skip
    return replace(made, limited=work.limited())


@_call("fix")
def fix_scene(body: contract.FixBody, catalogs: Catalogs) -> Fixed:
    """Repairs a scene by moving as little as possible."""
    from solver import fix

    check_size(body.scene)
    locked, moved = tuple(dict.fromkeys(body.locked)), tuple(dict.fromkeys(body.moved))
    fixed = None
    with limited_to(body.effort) as work:
        if body.dragging:
            from solver import fix_frame

            fixed = fix_frame(body.scene, moved, locked=locked, previous=body.previous, catalogs=catalogs, clock=perf_counter)
        if fixed is None:
            fixed = fix(
                body.scene, locked=locked, moved=moved, on_conflict=body.on_conflict, previous=body.previous, catalogs=catalogs,
                clock=perf_counter,
            )  # fmt: skip
    return replace(fixed, limited=work.limited())


@_call("drag")
def take_in_hand(body: contract.DragBody, catalogs: Catalogs) -> contract.DragAnswer:
    """Prepares the room of a piece that is about to be dragged."""
    from solver import prepare_drag

    check_id("id", body.id, body_ids(body.scene))
    check_ids(body_ids(body.scene), locked=body.locked)
    with limited_to():
        taken = prepare_drag(body.scene, body.id, locked=tuple(dict.fromkeys(body.locked)), catalogs=catalogs)
    return contract.DragAnswer(None if taken.opening is None else b64encode(taken.opening).decode("ascii"), taken.bodies)


@_call("place")
def place_pieces(body: contract.PlaceBody, catalogs: Catalogs, engine: str = "osqp") -> contract.PlaceAnswer:
    """Places a list of pieces, with their relations, in a room of the caller's own."""
    from solver import place

    with limited_to(body.effort) as work:
        answer = place(
            body.room, body.pieces, alternatives=body.alternatives, wall_thickness=body.wall_thickness, robot_width=body.robot_width,
            height=body.height,
            catalogs=catalogs, engine=engine, clock=perf_counter,
        )  # fmt: skip
    best = answer.best
    return contract.PlaceAnswer(
        best.scene, best.relations, best.unplaced, answer.alternatives, answer.conflicts, best.issues, answer.timing_ms,
        answer.understood_as, work.limited(),
    )  # fmt: skip


@_call("validate")
def validate_scene(body: contract.ValidateBody, catalogs: Catalogs) -> contract.ValidateAnswer:
    """Lists which rules a scene breaks, and by how much."""
    from solver import validate
    from solver.understanding import understood
    from solver.validator import access_of, metrics

    scene, flagged = body.scene, tuple(dict.fromkeys(body.flagged or ()))
    check_ids(body_ids(scene), flagged=flagged)
    issues = validate(scene, catalogs)
    is_wanted = body.flagged is not None if body.report is None else body.report
    measured = metrics(scene, catalogs)
    words = contract.Lines(*report(scene, _areas(measured), issues, flagged)) if is_wanted else None
    access = None if body.access is None or body.access == NO_ACCESS else access_of(scene, body.access, catalogs).document()
    return contract.ValidateAnswer(
        tuple(issues), measured, understood(scene, catalogs).understood_as, words, access, misspelt(scene) or None
    )


@_call("view")
def view_scene(body: contract.ViewBody, _: Catalogs) -> contract.Lines:
    """Writes a scene as readable YAML, and which body each line is."""
    from solver.validator import metrics

    return contract.Lines(*view(body.scene, _areas(metrics(body.scene))))


def _areas(measured: Document) -> dict[str, float]:
    """Returns the clear floors of rooms by their ids, m2."""
    return {name: room["clear_area"] for name, room in measured["rooms"].items()}


@_call("explain")
def explain_place(body: contract.ExplainBody, catalogs: Catalogs) -> Explained:
    """Says where a piece of a generated home was wished, and what holds it back from there."""
    from solver import explain

    with limited_to():
        return explain(body.scene, body.id, catalogs=catalogs)


@_call("import")
def import_file(body: contract.ImportBody, catalogs: Catalogs) -> PlanImport:
    """Reads a floor plan of another program as a scene, and says all that is not as the file says."""
    from solver.pipeline.import_plan import import_plan

    if (body.file is None) == (body.document is None):
        raise FieldError(
            "file", "is missing" if body.file is None else "is given, and so is the document", "a file in base64, or a document"
        )
    try:
        content = b64decode(body.file or "", validate=True)
    except ValueError:
        raise FieldError("file", "is not base64", "a file in base64") from None
    return import_plan(content if body.document is None else dict(body.document), body.name, body.settings, catalogs=catalogs)


@_call("floor")
def floor_of(body: contract.FloorBody, catalogs: Catalogs) -> contract.FloorAnswer:
    """Says where the floor of rooms is clear of walls, kept free for doors and windows, and free to come to."""
    from solver.validator import floors

    check_ids([room.id for room in body.scene.rooms], rooms=body.rooms)
    return contract.FloorAnswer(tuple(floors(body.scene, body.rooms, catalogs)))


def _read_export(document: object) -> contract.ExportBody:
    if isinstance(document, Mapping) and "scene" not in document and "rooms" in document:
        document = {"scene": document}
    return read(contract.ExportBody, document)


@_call("export", reads=_read_export)
def export_scene(body: contract.ExportBody | contract.SceneByItself, catalogs: Catalogs) -> Scene:
    """Writes a scene as a file: JSON or YAML (and reads one that is), or what a simulator, an editor or a training set reads."""
    from solver.named_assets import with_assets, with_kinds

    scene = body if isinstance(body, Scene) else body.scene
    return with_assets(with_kinds(scene, catalogs), catalogs)


class ExportedFile(NamedTuple):
    """What an export travels as: its name, its media type, its content."""

    name: str
    media_type: str
    content: bytes


def export_files(document: object, catalogs: Catalogs, format: str) -> Files:
    """Returns the files of a scene, an `ExportBody` or a scene by itself, in one of EXPORTERS.

    Raises:
        FieldError: a field is wrong, or the format's library is not installed.
    """
    from solver import export

    body = _read_export(document)
    return export(
        body.scene, format, free=cast(Freedom, body.free), strict=body.strict, scale=body.scale, called=body.called, catalogs=catalogs
    )


def export_one(document: object, catalogs: Catalogs, format: str) -> ExportedFile:
    """Returns an export as one file, an archive where there are several.

    Raises:
        FieldError: as `export_files`.
    """
    from solver.exports import packed

    return ExportedFile(*packed(export_files(document, catalogs, format), format, EXPORTERS[format].media_type))


def import_content(content: object, catalogs: Catalogs, settings: ImportSettings | None = None, name: str = "") -> Document:
    """Reads a foreign floor plan from a file's bytes, or from the document in a JSON file.

    Raises:
        FieldError: the file cannot be read; names the place.
    """
    from solver.pipeline.import_plan import import_plan

    return write(import_plan(content, name, settings, catalogs=catalogs))


LIGHT: Final = frozenset({"drag", "floor", "validate", "view"})
"""Those that are quickly done where the body is small: they have a lane of their own."""
MAY_BE_EMPTY: Final = frozenset({"generate"})
"""Those whose body may be left out: it asks for all defaults then."""
EXPORT_FORMATS: Final = (*FORMATS, *EXPORTERS)
"""What /export writes."""


class Question(NamedTuple):
    """A call without a body: its name, the type of its answer, and what makes the answer's document."""

    name: str
    answers: Any
    answer: Callable[[Catalogs], Document]


def _catalog(catalogs: Catalogs) -> Document:
    """Returns the furniture, decorations, room types, styles and presets the service knows."""
    return catalogs.model_dump(mode="json")


def _exports(_: Catalogs) -> Document:
    """Lists the formats that /export writes, beside JSON and YAML."""
    from solver.exports import is_available

    formats = (contract.ExportFormat(name, one.words, is_available(name)) for name, one in EXPORTERS.items())
    return write(contract.ExportFormats(tuple(write(one) for one in formats)))


def _schema(_: Catalogs) -> Document:
    """Returns the JSON Schema of a scene."""
    return scene_schema()


def _healthz(_: Catalogs) -> Document:
    """Answers at once while the service lives."""
    return write(contract.Health())


QUESTIONS: Final = {
    "catalog": Question("catalog", Catalogs, _catalog),
    "export": Question("exports", contract.ExportFormats, _exports),
    "schema": Question("schema", dict[str, Any], _schema),
    "healthz": Question("healthz", contract.Health, _healthz),
}
"""The calls that take no body, by their paths."""
