"""The OpenAPI document: what each call takes and answers, derived from the types that read and write it."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any, Final

from fastapi import FastAPI
from pydantic import TypeAdapter
from pydantic.alias_generators import to_camel
from starlette.responses import Response

from catalogs import Catalogs
from service.calls import OF_ANSWERS, ON_CONFLICT
from service.documents import Document
from service.placing import PlaceTerms
from service.problems import MEDIA_TYPE, STATUS
from service.wire import MEDIA_TYPES
from solver.exchange import request_schema, scene_schema
from solver.exchange.fields import aliases
from solver.requested import Held, Unplaced
from solver.scene import Conflict, Issue, Move, Pose, Request

REFERENCES: Final = "#/components/schemas/"
_IDS: Final = {"type": "array", "items": {"type": "string"}}
_NUMBERS: Final = {"type": "object", "additionalProperties": {"type": "number"}}


def _ref(name: str) -> Document:
    return {"$ref": REFERENCES + name}


def _list_of(name: str) -> Document:
    return {"type": "array", "items": _ref(name)}


def _record(required: tuple[str, ...], properties: Document) -> Document:
    return {"type": "object", "properties": properties, "required": list(required), "additionalProperties": False}


def _answer(**properties: Document) -> Document:
    return _record(tuple(properties), properties)


def _request() -> Document:
    """The request's schema, with its defaults and its other spellings."""
    schema = request_schema()
    defaults = asdict(Request())
    own = {name: {**part, "default": defaults[name]} for name, part in schema["properties"].items()}
    camel = {spelling: {**own[name], "deprecated": True} for spelling, name in aliases(Request).items()}
    return {**schema, "properties": own | camel}


def _generate_body() -> Document:
    seed = request_schema()["properties"]["seed"]
    reroll = _record(("scene", "reroll"), {"scene": _ref("Scene"), "reroll": {**_IDS, "minItems": 1}, "seed": seed})
    return {"anyOf": [_ref("Request"), reroll]}


def _bodies() -> Document:
    scene = {"scene": _ref("Scene")}
    conflict = {"enum": list(ON_CONFLICT), "default": ON_CONFLICT[0]}
    return {
        "GenerateBody": _generate_body(),
        "FixBody": _record(("scene",), {**scene, "locked": _IDS, "moved": _IDS, "on_conflict": conflict, "previous": _list_of("Pose")}),
        "ValidateBody": _record(("scene",), {**scene, "flagged": _IDS, "report": {"type": "boolean"}}),
        "ViewBody": _record(("scene",), scene),
        "FloorBody": _record(("scene",), {**scene, "rooms": _IDS}),
        "ExportBody": {"anyOf": [_record(("scene",), {**scene, **{key: {} for key in sorted(OF_ANSWERS)}}), _ref("Scene")]},
    }


def _place_body() -> Document:
    """The schema of the type that reads the body, in both spellings; the room is a scene's."""
    schema = TypeAdapter(PlaceTerms).json_schema(by_alias=False)
    own = {**schema["properties"], "room": _ref("Room")}
    camel = {to_camel(name): {**part, "deprecated": True} for name, part in own.items() if to_camel(name) != name}
    return {**schema, "properties": own | camel}


def _answers() -> Document:
    removed = {"type": "array", "items": _answer(id={"type": "string"}, reason={"type": "string"})}
    made = {"scene": _ref("Scene"), "issues": _list_of("Issue"), "timing_ms": _NUMBERS}
    placed = {"scene": _ref("Scene"), "relations": _list_of("Held"), "unplaced": _list_of("Unplaced")}
    others = {"type": "array", "items": _answer(**placed, issues=_list_of("Issue"), cost={"type": "number"})}
    validated = {"issues": _list_of("Issue"), "metrics": {"type": "object"}, "report": _ref("ViewAnswer")}
    lines = {"type": "array", "items": {"type": ["string", "null"]}}
    return {
        "GenerateAnswer": _answer(**made),
        "FixAnswer": _answer(**made, moves=_list_of("Move"), removed=removed, conflicts=_list_of("Conflict")),
        "PlaceAnswer": _answer(
            **made, relations=_list_of("Held"), unplaced=_list_of("Unplaced"), conflicts=_list_of("Conflict"), alternatives=others
        ),
        "ValidateAnswer": _record(("issues", "metrics"), validated),
        "ViewAnswer": _answer(text={"type": "string"}, lines=lines),
        "FloorAnswer": _answer(rooms={"type": "array", "items": _floor()}),
        "ExportAnswer": _ref("Scene"),
        "SchemaAnswer": {"type": "object"},
        "HealthAnswer": _answer(status={"const": "ok"}),
        "Problem": _answer(
            type={"type": "string"},
            title={"type": "string"},
            status={"type": "integer"},
            detail={"type": "string"},
            errors={"type": "array", "items": _answer(field={"type": "string"}, problem={"type": "string"}, allowed={"type": "string"})},
        ),
    }


def _hoisted(name: str, schema: Document, prefix: str = "") -> Document:
    """Moves a schema's own definitions among the document's, under a prefix, and its references with them."""
    whole = _repointed(schema, prefix)
    definitions = {prefix + inner: part for inner, part in whole.pop("$defs", {}).items()}
    return {**definitions, name: {key: value for key, value in whole.items() if key not in ("$id", "$schema")}}


def _repointed(node: Any, prefix: str) -> Any:
    if isinstance(node, list):
        return [_repointed(item, prefix) for item in node]
    if not isinstance(node, dict):
        return node
    moved = {key: _repointed(value, prefix) for key, value in node.items()}
    if isinstance(moved.get("$ref"), str):
        moved["$ref"] = moved["$ref"].replace("#/$defs/", REFERENCES + prefix)
    return moved


def _components() -> Document:
    types = _hoisted("CatalogAnswer", TypeAdapter(Catalogs).json_schema(mode="serialization"), "Catalog")
    for kind in (Issue, Move, Conflict, Held, Unplaced):
        types |= _hoisted(kind.__name__, TypeAdapter(kind).json_schema(mode="serialization"))
    types |= _hoisted("PlaceBody", _place_body(), "Place")
    types |= _hoisted("Pose", {**TypeAdapter(Pose).json_schema(), "additionalProperties": False})
    return types | _hoisted("Scene", scene_schema()) | _hoisted("Request", _request()) | _bodies() | _answers()


def _floor() -> Document:
    box = {"type": "array", "items": {"type": "number"}, "minItems": 4, "maxItems": 4}
    boxes = {"type": "array", "items": box}
    return _answer(room={"type": "string"}, clear=box, doors=boxes, windows=boxes, free=boxes)


def _content(name: str) -> Document:
    return {media_type: {"schema": _ref(name)} for media_type in MEDIA_TYPES}


def _problem(title: str) -> Document:
    return {"description": title, "content": {MEDIA_TYPE: {"schema": _ref("Problem")}}}


def described(name: str) -> dict[str, Any]:
    """Returns what a route declares: the schemas `<name>Body` (where there is one) and `<name>Answer`, and its problems."""
    takes_body = name == "Place" or f"{name}Body" in _bodies()
    refusals = {status: _problem(title) for status, title in STATUS.values() if takes_body}
    answers = {200: {"description": "The answer", "content": _content(f"{name}Answer")}, **refusals}
    body = {"requestBody": {"required": True, "content": _content(f"{name}Body")}} if takes_body else {}
    return {"response_class": Response, "responses": answers, "openapi_extra": body, "name": name.lower()}


class DescribedApp(FastAPI):
    """An application whose OpenAPI document also holds the schemas that its routes refer to."""

    def openapi(self) -> dict[str, Any]:
        """Returns the OpenAPI document."""
        document = super().openapi()
        document.setdefault("components", {}).setdefault("schemas", {}).update(_components())
        return document
