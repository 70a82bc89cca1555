"""What FastAPI cannot know of the OpenAPI document: that documents are YAML too, problems, examples, the catalogs' words."""

from __future__ import annotations

from functools import lru_cache
from http import HTTPStatus
from pathlib import Path
from typing import Any, Final

from catalogs import Catalogs
from catalogs.entries import Entry
from service.contract import ProblemDocument
from service.problems import MEDIA_TYPE, STATUS, STORE_STATUS
from service.wire import FILE_TYPES, MEDIA_TYPES
from solver.exchange import load_text, tell_keys
from solver.export_formats import EXPORTERS
from solver.fields import Record

REFERENCES: Final = "#/components/schemas/"
EXAMPLES: Final = Path(__file__).parent / "examples.yaml"
JSON: Final = "application/json"
BINARY: Final[dict[str, Any]] = {"schema": {"type": "string", "format": "binary"}}
TITLES: Final = {**dict(STORE_STATUS.values()), **dict(STATUS.values())}


def refusals(*statuses: int) -> dict[int | str, dict[str, Any]]:
    """Returns what a route declares of the problem documents it may answer with."""
    return {status: {"model": ProblemDocument, "description": TITLES.get(status, HTTPStatus(status).phrase)} for status in statuses}


@lru_cache
def examples() -> dict[str, Any]:
    """Returns an example of every call by its path: `body` where it takes one, and `answer`."""
    read: dict[str, Any] = load_text(EXAMPLES.read_bytes(), "yaml")  # type: ignore[assignment]
    return read


def completed(document: dict[str, Any], catalogs: Catalogs) -> dict[str, Any]:
    """Completes the document that FastAPI made."""
    for path, verbs in document["paths"].items():
        for verb, call in verbs.items():
            _complete(call, examples().get(f"{verb.upper()} {path}") or examples().get(path, {}))
    _export_answers(document["paths"]["/export/{format}"]["post"]["responses"]["200"]["content"])
    document["paths"]["/import"]["post"]["requestBody"]["content"] |= dict.fromkeys(FILE_TYPES, BINARY)
    _name_words(document["components"]["schemas"], catalogs)
    tell_keys(document["components"]["schemas"], Record, Entry)
    return document


def _complete(call: dict[str, Any], example: dict[str, Any]) -> None:
    if JSON in call.get("requestBody", {}).get("content", ()):
        sent = call["requestBody"]
        options = [option for option in sent["content"][JSON]["schema"].get("anyOf", ()) if option != {"type": "null"}]
        schema = {"anyOf": options} if options else sent["content"][JSON]["schema"]
        sent["content"] = {media_type: {"schema": schema, "example": example["body"]} for media_type in MEDIA_TYPES}
    for status, answer in call["responses"].items():
        media = answer.get("content", {}).get(JSON)
        if media is None:
            continue
        if status.startswith("2") and "answer" not in example:
            continue  # files
        if status.startswith("2"):
            answer["content"] = {media_type: {**media, "example": example["answer"]} for media_type in MEDIA_TYPES}
        else:
            answer["content"] = {MEDIA_TYPE: media}


def _export_answers(content: dict[str, Any]) -> None:
    """Adds the files that /export answers with beside scenes; some are JSON too."""
    files = ", ".join(name for name, exporter in EXPORTERS.items() if exporter.media_type == JSON)
    content[JSON]["schema"] = {"anyOf": [content[JSON]["schema"], {"type": "object", "description": f"a file of another format: {files}"}]}
    for exporter in EXPORTERS.values():
        content.setdefault(exporter.media_type, BINARY)
    content.setdefault("application/zip", BINARY)


def _name_words(schemas: dict[str, Any], catalogs: Catalogs) -> None:
    """Puts the words of the catalogs into the schemas of what is asked."""
    words = {"style": sorted(catalogs.styles), "access": sorted(catalogs.access)}
    for body in ("Request", "RestyleBody", "FurnishBody", "ValidateBody"):
        for name in words.keys() & schemas[body]["properties"].keys():
            for part in schemas[body]["properties"][name]["anyOf"]:
                if part["type"] == "string":
                    part["enum"] = words[name]
    for body in ("Request", "FurnishBody"):
        (access,) = (part for part in schemas[body]["properties"]["access"]["anyOf"] if part["type"] == "string")
        access["enum"] = ["none", *words["access"]]
