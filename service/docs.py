"""/docs: the OpenAPI document as one plain page, without a script and without anything from elsewhere."""

import json
from base64 import b64encode
from hashlib import sha256
from html import escape
from typing import Any, Final

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response

from service.openapi import REFERENCES

STYLE: Final = """
body { font: 16px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; color: #1d2125; background: #fff }
h2 { margin: 2.5rem 0 0.3rem; border-top: 1px solid #d0d5da; padding-top: 1rem }
h2 b { display: inline-block; min-width: 4rem; color: #1f5fa8 }
code, pre { font: 14px/1.45 ui-monospace, monospace; background: #f2f4f6; border-radius: 4px; padding: 0.1em 0.3em }
pre { padding: 0.8rem; overflow-x: auto }
table { border-collapse: collapse; margin: 0.3rem 0 } th, td { text-align: left; padding: 0.15rem 1.2rem 0.15rem 0; vertical-align: top }
summary { cursor: pointer }
@media (prefers-color-scheme: dark) {
body { color: #e4e7ea; background: #16191c } code, pre { background: #24292e } h2 b { color: #7db8ff } }
"""
POLICY: Final = (
    f"default-src 'none'; style-src 'sha256-{b64encode(sha256(STYLE.encode()).digest()).decode()}'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
"""The style sheet above by its digest, and nothing else."""


async def docs(request: Request) -> Response:
    """Serves the page."""
    document = await run_in_threadpool(request.app.openapi)
    html = await run_in_threadpool(_page, document, str(request.base_url))
    return HTMLResponse(html, headers={"Content-Security-Policy": POLICY})


def _page(document: dict[str, Any], base: str) -> str:
    calls = "".join(_call(path, verb, call, base) for path, verbs in document["paths"].items() for verb, call in verbs.items())
    schemas = "".join(_schema(name, schema) for name, schema in sorted(document["components"]["schemas"].items()))
    title = f"{document['info']['title']} {document['info']['version']}"
    return (
        f'<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
        f"<title>{escape(title)}</title><style>{STYLE}</style></head><body><h1>{escape(title)}</h1>"
        f"<p>{escape(document['info'].get('description', ''))} Machine-readable: <a href='openapi.json'>openapi.json</a>.</p>"
        f"{calls}<h2>Schemas</h2>{schemas}</body></html>"
    )


def _call(path: str, verb: str, call: dict[str, Any], base: str) -> str:
    takes = _linked(_first_schema(call["requestBody"]["content"])) if "requestBody" in call else "nothing"
    rows = "".join(
        f"<tr><td>{escape(status)}</td><td>{escape(answer['description'])}</td><td>{_answered(answer)}</td></tr>"
        for status, answer in call["responses"].items()
    )
    asked = _example(call["requestBody"]) if "requestBody" in call else None
    sent = {"get": "", "post": ""}.get(verb, f" -X {verb.upper()}") + (f" -d '{_shown(asked)}'" if asked is not None else "")
    shown = _example(next(answer for status, answer in call["responses"].items() if status.startswith("2")))
    example = f"curl{sent} {base}{path.removeprefix('/')}" + (f"\n\n{_shown(shown)}" if shown is not None else "")
    return (
        f"<h2><b>{escape(verb.upper())}</b> {escape(path)}</h2><p>{escape(call.get('description', ''))}</p>"
        f"<pre>{escape(example)}</pre><p>Takes {takes}.</p><table>{rows}</table>"
    )


def _schema(name: str, schema: dict[str, Any]) -> str:
    rows = "".join(_row(key, part, key in schema.get("required", ())) for key, part in schema.get("properties", {}).items())
    source = escape(json.dumps(schema, indent=1))
    return (
        f'<h3 id="{escape(name)}">{escape(name)}</h3><p>{escape(schema.get("description", ""))}</p><table>{rows}</table>'
        f"<details><summary>JSON Schema</summary><pre>{source}</pre></details>"
    )


def _row(key: str, part: dict[str, Any], required: bool) -> str:
    limits = [f"{word} {json.dumps(part[word])}" for word in ("minimum", "maximum", "default", "enum") if word in part]
    notes = [*(["required"] if required else []), *(["other spelling"] if part.get("deprecated") else []), *limits]
    cells = (f"<code>{escape(key)}</code>", _linked(part), escape(", ".join(notes)), escape(part.get("description", "")))
    return "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"


def _linked(schema: dict[str, Any]) -> str:
    """Names a schema's type, with a link where it has a place of its own on the page."""
    if "$ref" in schema:
        name = escape(schema["$ref"].removeprefix(REFERENCES))
        return f'<a href="#{name}">{name}</a>'
    if "anyOf" in schema:
        return " or ".join(_linked(part) for part in schema["anyOf"])
    if schema.get("type") == "array" and isinstance(schema.get("items"), dict):
        return f"list of {_linked(schema['items'])}"
    kind = schema.get("type", "any")
    return escape(" or ".join(kind) if isinstance(kind, list) else str(kind))


def _example(part: dict[str, Any]) -> Any:
    first: dict[str, Any] = next(iter(part.get("content", {}).values()), {})
    return first.get("example")


def _answered(answer: dict[str, Any]) -> str:
    return _linked(_first_schema(answer["content"])) if answer.get("content") else "nothing"


def _shown(example: Any) -> str:
    return json.dumps(example, ensure_ascii=False)


def _first_schema(content: dict[str, Any]) -> dict[str, Any]:
    return dict(next(iter(content.values())).get("schema", {}))
