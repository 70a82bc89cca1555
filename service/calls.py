"""The calls, from document to document: what HTTP and the command line share."""

from __future__ import annotations

import secrets
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, replace
from time import perf_counter
from typing import Any, Final, TypeAlias

from catalogs import Catalogs
from service.documents import Document
from service.placing import read_place
from service.refusals import BodyError
from solver import fix, generate, place, reroll, validate
from solver.errors import SceneError
from solver.exchange import read_poses, read_request, read_scene, scene_schema, write_scene
from solver.requested import Placement
from solver.scene import MAX_SEED, Generated, Scene, body_ids, check_ids
from solver.validate import floors, metrics
from solver.view import report, view

Call: TypeAlias = Callable[[object, Catalogs], Document]

ON_CONFLICT: Final = ("report", "remove")
OF_ANSWERS: Final = frozenset({"issues", "timing_ms", "moves", "removed", "conflicts"})
"""What answers that hold a scene say beside it."""


def generate_house(document: object, catalogs: Catalogs, engine: str = "osqp") -> Document:
    """Makes a house, or furnishes some rooms of one anew.

    Args:
        document: a request; or `scene`, `reroll` (ids of its rooms) and, if wanted, `seed`.
        catalogs: the data to furnish from.
        engine: the engine of the final QP.

    Raises:
        FieldError: a field is wrong.
    """
    body = _body(document)
    if "scene" in body or "reroll" in body:
        made = _rerolled(body, catalogs)
    else:
        request = read_request(body)
        seeded = request if request.seed is not None else replace(request, seed=draw_seed())
        made = generate(seeded, catalogs=catalogs, engine=engine, clock=perf_counter)
    return {"scene": write_scene(made.scene), "issues": _listed(made.issues), "timing_ms": dict(made.timing_ms)}


def fix_scene(document: object, catalogs: Catalogs) -> Document:
    """Repairs a scene with least movement.

    Args:
        document: `scene`, and if wanted `locked`, `moved` (ids of bodies), `on_conflict` (report or remove) and `previous`
            (poses of the last answer, while something is dragged).
        catalogs: what the pieces' kinds are.

    Raises:
        FieldError: a field is wrong.
    """
    body = _body(document, ("scene", "locked", "moved", "on_conflict", "previous"))
    scene = _scene(body)
    locked, moved = _ids(body, "locked"), _ids(body, "moved")
    on_conflict = body.get("on_conflict", ON_CONFLICT[0])
    if on_conflict not in ON_CONFLICT:
        raise BodyError("on_conflict", f"is {on_conflict!r}", " or ".join(ON_CONFLICT))
    previous = read_poses(body.get("previous", []))
    fixed = fix(
        scene, locked=locked, moved=moved, on_conflict=on_conflict, previous=previous, catalogs=catalogs, clock=perf_counter
    )  # fmt: skip
    return {
        "scene": write_scene(fixed.scene),
        "moves": _listed(fixed.moves),
        "removed": [dict(entry) for entry in fixed.removed],
        "conflicts": _listed(fixed.conflicts),
        "issues": _listed(fixed.issues),
        "timing_ms": dict(fixed.timing_ms),
    }


def place_pieces(document: object, catalogs: Catalogs, engine: str = "osqp") -> Document:
    """Places a list of pieces in a room.

    Args:
        document: `room`, `pieces`, and if wanted `alternatives`, `wall_thickness`, `robot_width`.
        catalogs: what pieces are whose sizes are not given.
        engine: the engine of the final QP.

    Raises:
        FieldError: a field is wrong.
    """
    room, wishes, terms = read_place(_body(document))
    answer = place(
        room, wishes, alternatives=terms.alternatives, wall_thickness=terms.wall_thickness, robot_width=terms.robot_width,
        catalogs=catalogs, engine=engine, clock=perf_counter,
    )  # fmt: skip
    others = [{**_placed(other), "issues": _listed(other.issues), "cost": other.cost} for other in answer.alternatives]
    return {
        **_placed(answer.best),
        "alternatives": others,
        "conflicts": _listed(answer.conflicts),
        "issues": _listed(answer.best.issues),
        "timing_ms": dict(answer.timing_ms),
    }


def _placed(placement: Placement) -> Document:
    return {
        "scene": write_scene(placement.scene),
        "relations": _listed(placement.relations),
        "unplaced": _listed(placement.unplaced),
    }


def validate_scene(document: object, catalogs: Catalogs) -> Document:
    """Lists what breaks the rules in a scene, and measures it.

    Args:
        document: `scene`; and if a report is wanted, `flagged` (ids of bodies a person finds problematic) or `report: true`.
        catalogs: which sides of a piece are used, and what rooms require.

    Raises:
        FieldError: a field is wrong.
    """
    body = _body(document, ("scene", "flagged", "report"))
    scene, flagged, wanted = _scene(body), _ids(body, "flagged"), body.get("report", "flagged" in body)
    if not isinstance(wanted, bool):
        raise BodyError("report", f"is {_word(wanted)}", "true or false")
    check_ids("flagged", flagged, body_ids(scene))
    issues = validate(scene, catalogs)
    answer: Document = {"issues": _listed(issues), "metrics": metrics(scene, catalogs)}
    return {**answer, "report": _lined(*report(scene, issues, flagged))} if wanted else answer


def view_scene(document: object, _: Catalogs | None = None) -> Document:
    """Writes a scene for a person to read.

    Args:
        document: `scene`.

    Raises:
        FieldError: a field is wrong.
    """
    return _lined(*view(_scene(_body(document, ("scene",)))))


def floor_of(document: object, _: Catalogs | None = None) -> Document:
    """Says where the floor of rooms is clear, kept free, and free to come to.

    Args:
        document: `scene`, and if wanted `rooms` (ids of its rooms; all of them by default).

    Raises:
        FieldError: a field is wrong.
    """
    body = _body(document, ("scene", "rooms"))
    scene, rooms = _scene(body), _ids(body, "rooms")
    check_ids("rooms", rooms, [room.id for room in scene.rooms])
    return {"rooms": floors(scene, rooms)}


def _lined(text: str, lines: Sequence[str | None]) -> Document:
    return {"text": text, "lines": list(lines)}


def export_scene(document: object, _: Catalogs | None = None) -> Document:
    """Returns a scene as a document of its own, every default written out: what a file of it holds.

    Args:
        document: `scene`; or a scene by itself, as such a file holds it; or an answer of /generate or /fix.

    Raises:
        FieldError: a field is wrong.
    """
    body = _body(document)
    if "scene" not in body and "rooms" in body:
        return write_scene(_scene({"scene": body}))
    _only({key: value for key, value in body.items() if key not in OF_ANSWERS}, ("scene",))
    return write_scene(_scene(body))


def catalog_document(catalogs: Catalogs) -> Document:
    """Returns all that the service knows: kinds of furniture, floorings, room types."""
    return catalogs.model_dump(mode="json")


def schema_document(_: Catalogs | None = None) -> Document:
    """Returns the JSON Schema of a scene."""
    return scene_schema()


CALLS: Final[Mapping[str, Call]] = {
    "generate": generate_house, "fix": fix_scene, "place": place_pieces, "validate": validate_scene, "view": view_scene,
    "export": export_scene, "floor": floor_of,
}  # fmt: skip
"""The calls that take a body, by the last word of their path."""


def draw_seed() -> int:
    """Draws a seed for a request that has none."""
    return secrets.randbelow(MAX_SEED + 1)


def has_errors(issues: Sequence[Mapping[str, Any]]) -> bool:
    """Tells whether any issue of an answer is an error, so that the scene is not clean."""
    return any(issue["severity"] == "error" for issue in issues)


def _rerolled(body: Document, catalogs: Catalogs) -> Generated:
    _only(body, ("scene", "reroll", "seed"))
    scene = _scene(body)
    if not body.get("reroll"):
        raise BodyError("reroll", "is missing or empty", "ids of the rooms to furnish anew")
    seed = read_request({"seed": body.get("seed")}).seed
    return reroll(scene, _ids(body, "reroll"), seed=draw_seed() if seed is None else seed, catalogs=catalogs, clock=perf_counter)


def _listed(records: Sequence[Any]) -> list[Document]:
    return [asdict(record) for record in records]


def _body(document: object, keys: Sequence[str] = ()) -> Document:
    if not isinstance(document, dict):
        raise BodyError("body", f"is {_word(document)}", "an object")
    if keys:
        _only(document, keys)
    return document


def _only(body: Document, keys: Sequence[str]) -> None:
    for key in body:
        if key not in keys:
            raise BodyError(str(key), "is not a key of this call", ", ".join(keys))


def _scene(body: Document) -> Scene:
    if "scene" not in body:
        raise BodyError("scene", "is missing", "a scene, as GET /schema describes it")
    try:
        return read_scene(body["scene"])
    except SceneError as error:
        field = "scene" if error.field in ("", "scene") else f"scene.{error.field}"
        raise SceneError(field, error.problem, error.allowed) from None


def _ids(body: Document, key: str) -> tuple[str, ...]:
    given = body.get(key, [])
    if not isinstance(given, list):
        raise BodyError(key, f"is {_word(given)}", "a list of ids")
    for index, name in enumerate(given):
        if not isinstance(name, str):
            raise BodyError(f"{key}[{index}]", f"is {_word(name)}", "an id, a text")
    return tuple(dict.fromkeys(given))


def _word(value: object) -> str:
    names = {bool: "true or false", int: "a number", float: "a number", str: "a text", list: "a list", dict: "an object"}
    return "null" if value is None else names.get(type(value), type(value).__name__)
