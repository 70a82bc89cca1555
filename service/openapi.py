"""What FastAPI cannot know of the OpenAPI document: that documents are YAML too, problems, examples, the catalogs' words.

And calls that it describes and does not make (`described`).
"""

import re
from collections.abc import Awaitable, Callable, Iterator, Mapping
from dataclasses import fields
from functools import lru_cache
from http import HTTPStatus
from inspect import cleandoc
from pathlib import Path
from typing import Any, Final, NamedTuple, get_type_hints

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from catalogs import Catalogs
from catalogs.entries import Entry
from service.admission import PARAMETER
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


Responses = Mapping[int | str, dict[str, Any]]
Answering = Callable[[Request], Awaitable[Response]]


class Declared(NamedTuple):
    """A call that is declared: what answers it, what it takes by name, and what else is said of it."""

    method: str
    path: str
    answering: Answering
    takes: Mapping[str, Any]
    described: dict[str, Any]


class DescribedCalls:
    """Calls of one kind: the prefix of their paths, and what the document says of all of them, as FastAPI takes it."""

    def __init__(self, prefix: str = "", *, responses: Responses) -> None:
        self._prefix, self._responses = prefix, responses
        self._declared: list[Declared] = []

    def call(self, method: str, path: str, answers: Any = None, **described: Any) -> Callable[[Answering], Answering]:
        """Declares a call by what answers it: its name and its docstring are the call's.

        `answers` is the type of the answer's document, where it is one; `takes` are the types of what it takes, by name, those that need
        not be there with their default; all else is as `FastAPI.add_api_route` takes it.
        """
        takes = described.pop("takes", {})

        def declare(answering: Answering) -> Answering:
            said = {"name": answering.__name__, "description": cleandoc(answering.__doc__ or ""), "response_model": answers, **described}
            said["responses"] = {**self._responses, **described.get("responses", {})}
            self._declared.append(Declared(method, path, answering, takes, said))
            return answering

        return declare

    def routes(self) -> list[Route]:
        """Returns what answers the calls."""
        return [Route(one.path, one.answering, methods=[one.method], name=one.described["name"]) for one in self]

    def __iter__(self) -> Iterator[Declared]:
        """Yields the calls, each by its whole path."""
        return (one._replace(path=self._prefix + one.path) for one in self._declared)


def query_types(record: type[Any]) -> dict[str, tuple[Any, Any]]:
    """Returns what a call takes that is asked in its query by the fields of a record; each has a default."""
    types = get_type_hints(record, include_extras=True)
    return {part.name: (types[part.name], part.default) for part in fields(record)}


def query_of(request: Request, whole: str) -> dict[str, object]:
    """Returns what a query asks, that of one name as a whole number where it is one."""
    asked: dict[str, object] = {name: value for name, value in request.query_params.items() if name != PARAMETER}
    number = request.query_params.get(whole, "")
    return {**asked, whole: int(number)} if re.fullmatch(r"-?\d{1,9}", number) else asked
