"""The body of /place: a document -> what `solver.place` takes, checked field by field."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated, Any, Final

from pydantic import BaseModel, ConfigDict, Field, ValidationError
from pydantic.alias_generators import to_camel
from pydantic_core import ErrorDetails

from catalogs.schema import Rule
from service.documents import Document
from service.refusals import BodyError
from solver.errors import SceneError
from solver.exchange import read_scene
from solver.requested import LEAST_LENGTH, MOST_ALTERNATIVES, MOST_LENGTH, MOST_PIECES, MOST_RELATIONS, Wish
from solver.scene import ROBOT_WIDTH, Room

Extent = Annotated[float, Field(strict=True, ge=LEAST_LENGTH, le=MOST_LENGTH, allow_inf_nan=False)]
NUMBERS: Final = ("distance", "cost", "weight")
"""Keys of a relation that hold one number."""


class AskedPiece(BaseModel):
    """A piece wanted in the room. Without `id` it is called by its `name`, and the other way round.

    Sizes (m, unrotated: across the front, front to back, up) may be left out where `name` is a kind of the catalog.
    `relations` are rules of the catalogs' vocabulary; `of` names ids of other pieces or of what stands in the room, or an
    opening: door, garage_door, window.
    """

    model_config = ConfigDict(extra="forbid")

    id: Annotated[str, Field(strict=True, min_length=1, max_length=100)] | None = None
    name: Annotated[str, Field(strict=True, min_length=1, max_length=100)] | None = None
    width: Extent | None = None
    depth: Extent | None = None
    height: Extent | None = None
    count: Annotated[int, Field(strict=True, ge=1, le=MOST_PIECES)] = 1
    required: Annotated[bool, Field(strict=True)] = True
    relations: Annotated[tuple[Rule, ...], Field(max_length=MOST_RELATIONS)] = ()


class PlaceTerms(BaseModel):
    """What /place takes besides the room."""

    model_config = ConfigDict(extra="forbid", alias_generator=to_camel, populate_by_name=True)

    room: dict[str, Any]
    pieces: Annotated[tuple[AskedPiece, ...], Field(max_length=MOST_PIECES)]
    alternatives: Annotated[int, Field(strict=True, ge=1, le=MOST_ALTERNATIVES)] = 1
    wall_thickness: Annotated[float, Field(strict=True, ge=0, le=1, allow_inf_nan=False)] = 0.0
    robot_width: Annotated[float, Field(strict=True, ge=0.1, le=2.0, allow_inf_nan=False)] = ROBOT_WIDTH


def read_place(body: Document) -> tuple[Room, tuple[Wish, ...], PlaceTerms]:
    """Reads the body of /place.

    Raises:
        BodyError: a field is wrong; names it, with what is allowed.
        SceneError: a field of the room is wrong.
    """
    _refuse_words(body.get("pieces"))
    try:
        terms = PlaceTerms.model_validate(body)
    except ValidationError as error:
        raise _refused(error.errors()[0]) from None
    wishes = tuple(_wish(f"pieces[{k}]", piece) for k, piece in enumerate(terms.pieces))
    return _room(terms), wishes, terms


def _wish(field: str, piece: AskedPiece) -> Wish:
    name, label = piece.name or piece.id, piece.id or piece.name
    if name is None or label is None:
        raise BodyError(f"{field}.id", "is missing, and so is the name", "an id, or a name")
    return Wish(label, name, piece.width, piece.depth, piece.height, piece.count, piece.required, piece.relations)


def _room(terms: PlaceTerms) -> Room:
    try:
        return read_scene({"wall_thickness": terms.wall_thickness, "rooms": [terms.room]}).rooms[0]
    except SceneError as error:
        raise SceneError(error.field.replace("rooms[0]", "room", 1), error.problem, error.allowed) from None


def _refuse_words(pieces: object) -> None:
    """Refuses texts and flags where a relation wants a number: catalogs are read more forgivingly than requests."""
    for k, piece in enumerate(pieces if isinstance(pieces, list) else ()):
        relations = piece.get("relations") if isinstance(piece, Mapping) else None
        for j, rule in enumerate(relations if isinstance(relations, list) else ()):
            for key in NUMBERS if isinstance(rule, Mapping) else ():
                value = rule.get(key)
                if value is not None and (isinstance(value, bool) or not isinstance(value, int | float)):
                    raise BodyError(f"pieces[{k}].relations[{j}].{key}", f"is {value!r:.60}", "a number")


def _refused(error: ErrorDetails) -> BodyError:
    """Says in our words what pydantic found."""
    path = _path(error["loc"])
    if error["type"] == "extra_forbidden":
        return BodyError(path, "is not a key of this call", ", ".join(_keys(error["loc"])))
    if error["type"] == "missing":
        return BodyError(path, "is missing", {"room": "a scene's room", "pieces": "a list of pieces"}.get(path, "a value"))
    wrong = error["input"]
    problem = f"is {wrong!r:.60}" if isinstance(wrong, str | int | float | None) else f"is a {type(wrong).__name__} that cannot be used"
    return BodyError(path, problem, error["msg"].removeprefix("Input should be ").removeprefix("Value error, "))


def _keys(loc: Sequence[int | str]) -> list[str]:
    """Returns the keys that are known where an unknown one was found."""
    fields = {1: PlaceTerms.model_fields, 3: AskedPiece.model_fields}.get(len(loc), Rule.model_fields)
    return list(fields)


def _path(loc: Sequence[int | str]) -> str:
    text = ""
    for step in loc:
        text += f"[{step}]" if isinstance(step, int) else f".{step}" if text else step
    return text
