"""The JSON Schema (2020-12) of a scene and of a request, from the same table as the reader.

Comes in: nothing. Goes out: a schema as plain values. May import: scene.
"""

from __future__ import annotations

import inspect
from typing import Any

from solver.exchange.fields import Counted, Field, Flag, Free, Indexed, Number, Record, Several, Shape, Text, keeps_extra, table
from solver.scene import FORMAT, Request, Scene

DIALECT = "https://json-schema.org/draft/2020-12/schema"


def scene_schema() -> dict[str, Any]:
    """Returns the JSON Schema of a scene document: what `read_scene` asks for, unknown keys welcome."""
    return _schema(Scene, FORMAT)


def request_schema() -> dict[str, Any]:
    """Returns the JSON Schema of a request in snake_case."""
    return _schema(Request, "compose-request/1")


def _schema(of: type[Any], title: str) -> dict[str, Any]:
    definitions: dict[str, Any] = {}
    root = _record(of, definitions)
    return {"$schema": DIALECT, "title": title, **root, "$defs": {name: definitions[name] for name in sorted(definitions)}}


def _record(of: type[Any], definitions: dict[str, Any]) -> dict[str, Any]:
    rows = table(of)
    schema: dict[str, Any] = {"type": "object", "description": inspect.cleandoc(of.__doc__ or "").split("\n\n")[0].replace("\n", " ")}
    schema["properties"] = {row.name: _property(row, definitions) for row in rows}
    required = [row.name for row in rows if row.required]
    if required:
        schema["required"] = required
    return schema if keeps_extra(of) else {**schema, "additionalProperties": False}


def _property(row: Field, definitions: dict[str, Any]) -> dict[str, Any]:
    schema = _shape(row.shape, definitions)
    if row.says:
        schema["description"] = row.says
    if not row.nullable:
        return schema
    if "type" in schema and "enum" not in schema:
        return {**schema, "type": [schema["type"], "null"]}
    return {"anyOf": [schema, {"type": "null"}]}


def _shape(shape: Shape, definitions: dict[str, Any]) -> dict[str, Any]:
    match shape:
        case Text():
            return {"type": "string", "enum": list(shape.choices)} if shape.choices else {"type": "string"}
        case Number():
            low = {"exclusiveMinimum": 0} if shape.positive else {"minimum": shape.least}
            return {"type": "integer" if shape.whole else "number", **low, "maximum": shape.most}
        case Flag():
            return {"type": "boolean"}
        case Indexed():
            return {"type": "object", "propertyNames": {"pattern": "^[0-9]{1,9}$"}, "additionalProperties": {"type": "string"}}
        case Counted():
            counts = {"type": "integer", "minimum": shape.least, "maximum": shape.most}
            return {"anyOf": [{"type": "string"}, {"type": "object", "additionalProperties": counts}]}
        case Several():
            return _several(shape, definitions)
        case Record():
            return _reference(shape.of, definitions)
        case Free():
            return {"type": "object"}


def _several(shape: Several, definitions: dict[str, Any]) -> dict[str, Any]:
    schema: dict[str, Any] = {"type": "array", "items": _shape(shape.item, definitions)}
    if shape.length is not None:
        return {**schema, "minItems": shape.length, "maxItems": shape.length}
    return {**schema, "minItems": shape.at_least} if shape.at_least else schema


def _reference(of: type[Any], definitions: dict[str, Any]) -> dict[str, Any]:
    if of.__name__ not in definitions:
        definitions[of.__name__] = {}
        definitions[of.__name__] = _record(of, definitions)
    return {"$ref": f"#/$defs/{of.__name__}"}
