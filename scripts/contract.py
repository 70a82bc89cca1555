"""Writes web/src/served.ts: TypeScript's types of what the service takes and answers, from its OpenAPI document.

Usage: python -m scripts.contract. The page's own types (web/src/contract.ts) are made from these.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from service.app import create_app

FILE = Path(__file__).parent.parent / "web" / "src" / "served.ts"
PAGE = (
    *(
        "Generated",
        "PlanImport",
        "Fixed",
        "FixBody",
        "DragAnswer",
        "ValidateAnswer",
        "Explained",
        "PlaceAnswer",
        "Lines",
        "FloorAnswer",
        "ProblemDocument",
        "Request",
        "HomeHead",
        "HomeList",
        "HomeVersions",
        "HomeWithScene",
        "JobHead",
        "JobList",
        "FurnishedPlan",
        "ExportFormats",
    ),
    *("FurnitureSpec", "Solid", "Material", "WallPaint", "Preset", "Asset"),
)
"""What the page takes and sends; what these refer to comes with them."""
HEAD = "/** What the service takes and answers; `python -m scripts.contract` writes it. Lengths in metres, angles in degrees. */\n"
WORDS = {"number": "number", "integer": "number", "string": "string", "boolean": "boolean", "null": "null"}


def contract() -> str:
    """Returns the text of the file."""
    schemas = create_app().openapi()["components"]["schemas"]
    shown = {_name(name): schema for name, schema in schemas.items() if not name.endswith("-Input")}
    wanted, seen = list(PAGE), dict[str, str]()
    while wanted:
        name = wanted.pop()
        if name not in seen:
            seen[name] = "\n".join(_declared(name, shown[name]))
            wanted += [_name(other) for other in _references(shown[name])]
    return HEAD + "".join(f"\n{seen[name]}" for name in sorted(seen))


def _references(node: Any) -> Iterator[str]:
    if isinstance(node, dict):
        if isinstance(node.get("$ref"), str):
            yield node["$ref"].rpartition("/")[2]
        node = list(node.values())
    for inner in node if isinstance(node, list) else ():
        yield from _references(inner)


def _name(name: str) -> str:
    return name.removesuffix("-Output").removesuffix("-Input")


def _declared(name: str, schema: dict[str, Any]) -> Iterator[str]:
    lines = [*_comment(schema, ""), f"export interface {name} {{"]
    for key, part in schema.get("properties", {}).items():
        if not part.get("deprecated"):
            optional = "" if key in schema.get("required", ()) else "?"
            lines += [*_comment(part, "  "), f"  readonly {key}{optional}: {_type(part)};"]
    yield "\n".join([*lines, "}", ""])


def _comment(schema: dict[str, Any], indent: str) -> list[str]:
    words = schema.get("description", "").split("\n\n")[0].replace("\n", " ")
    return [f"{indent}/** {words} */"] if words else []


def _type(schema: dict[str, Any]) -> str:
    if "$ref" in schema:
        return _name(schema["$ref"].rpartition("/")[2])
    if "anyOf" in schema:
        return " | ".join(dict.fromkeys(_type(option) for option in schema["anyOf"]))
    if "const" in schema or "enum" in schema:
        return " | ".join(f'"{word}"' for word in schema.get("enum", [schema.get("const")]))
    if "prefixItems" in schema:
        return f"readonly [{', '.join(map(_type, schema['prefixItems']))}]"
    if schema.get("type") == "array":
        item = _type(schema["items"])
        return f"readonly ({item})[]" if " " in item else f"readonly {item}[]"
    if schema.get("type") == "object":
        more = schema.get("additionalProperties")
        return f"Readonly<Record<string, {_type(more) if isinstance(more, dict) and more else 'unknown'}>>"
    return WORDS.get(schema.get("type", ""), "unknown")


if __name__ == "__main__":
    FILE.write_text(contract(), encoding="utf-8")
