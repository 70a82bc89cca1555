"""What each command does. Nothing but the document goes to standard output; words for a person go to standard error."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import Callable, Mapping
from importlib import import_module
from pathlib import Path
from typing import Any, Final, TypeVar

from tqdm import tqdm

from catalogs import CatalogError, Catalogs, load_catalogs
from service import calls, survey
from service.cli import NUMBERS, SWITCHES, WORDS
from service.documents import Document, format_of_content, format_of_name, parse
from service.tables import report
from solver.errors import ComposeError, FieldError, SyntaxFault
from solver.exchange import dump_text, read_request
from solver.scene import MAX_SEED

T = TypeVar("T")

CLEAN: Final = 0
ERRORS_FOUND: Final = 1
BAD_USE: Final = 2
STREAM: Final = "-"
"""The file name that stands for a standard stream."""


def run(options: Namespace) -> int:
    """Runs the command that the options name and returns the exit status."""
    try:
        return COMMANDS[options.command](options)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return BAD_USE
    except (ComposeError, CatalogError, OSError) as error:
        _say(f"compose: {error}")
        return BAD_USE


def _generate(options: Namespace) -> int:
    catalogs, request = _catalogs(options), _request(options)
    if options.count is not None:
        return _generate_many(options, request, catalogs)
    answer = _made(options, request, catalogs)
    _write(answer["scene"], options)
    return _judged(answer)


def _made(options: Namespace, request: Mapping[str, Any], catalogs: Catalogs) -> Document:
    return _checked(options.request, lambda: calls.generate_house(request, catalogs, options.engine))


def _generate_many(options: Namespace, request: Mapping[str, Any], catalogs: Catalogs) -> int:
    """Makes a set of houses into a folder, one file a seed."""
    folder = Path(options.output)
    if options.output == STREAM or folder.is_file():
        raise FieldError("--output", f"{options.output} holds one document", "with --count, a folder")
    folder.mkdir(parents=True, exist_ok=True)
    given = read_request({"seed": request.get("seed")}).seed
    start = calls.draw_seed() if given is None else given
    status, format = CLEAN, options.format or "yaml"
    for number in tqdm(range(options.count), unit="house", disable=None):
        seed = (start + number) % (MAX_SEED + 1)
        answer = _made(options, {**request, "seed": seed}, catalogs)
        (folder / f"{seed}.{format}").write_bytes(dump_text(answer["scene"], format))
        status = max(status, _judged(answer, f"seed {seed}: "))
    return status


def _stats(options: Namespace) -> int:
    """Makes many houses, of one request or of every preset, and writes what they are like."""
    catalogs, request = _catalogs(options), {"decorate": True, **_request(options)}
    if options.presets and ("program" in request or not catalogs.presets):
        raise FieldError("--presets", "asks for every preset there is", "without --program, and with presets in the catalog")
    requests = [{**request, "program": name} for name in catalogs.presets] if options.presets else [request]
    found = _checked(options.request, lambda: survey.statistics(requests, options.count, options.workers, catalogs))
    format = options.format or format_of_name(options.output) or "table"
    _put(report(found).encode() if format == "table" else dump_text(found, format), options.output)
    broken = any(entry["severity"] == "error" for one in found["sets"] for entry in one["issues"])
    return ERRORS_FOUND if broken else CLEAN


def _fix(options: Namespace) -> int:
    body = {"scene": _scene(options), "locked": options.lock, "moved": options.moved, "on_conflict": options.on_conflict}
    answer = _checked(options.scene, lambda: calls.fix_scene(body, _catalogs(options)))
    _write(answer["scene"], options)
    _say(f"{len(answer['moves'])} moved, {len(answer['removed'])} removed, {len(answer['conflicts'])} in conflict")
    for entry in answer["removed"]:
        _say(f"removed {entry['id']}: {entry['reason']}")
    _contested(answer)
    return _judged(answer)


def _place(options: Namespace) -> int:
    given = _read(options.request)
    more = {} if options.alternatives is None else {"alternatives": options.alternatives}
    body = {**given, **more} if isinstance(given, dict) else given
    answer = _checked(options.request, lambda: calls.place_pieces(body, _catalogs(options), options.engine))
    _write(answer, options)
    for relation in answer["relations"]:
        if not relation["held"]:
            _say(f"not held: {relation['piece']} {relation['type']} {relation['of'] or ''}".rstrip())
    for entry in answer["unplaced"]:
        _say(f"unplaced {entry['id']}: {entry['reason']}")
    return max(_judged(answer), _contested(answer))


def _contested(answer: Mapping[str, Any]) -> int:
    """Says what cannot stand together and returns the exit status."""
    for conflict in answer["conflicts"]:
        _say(f"conflict {', '.join(conflict['ids'])}: {conflict['message']}")
    return ERRORS_FOUND if answer["conflicts"] else CLEAN


def _validate(options: Namespace) -> int:
    body = {"scene": _scene(options), "flagged": options.flag, "report": options.report}
    answer = _checked(options.scene, lambda: calls.validate_scene(body, _catalogs(options)))
    if options.report:
        _put(answer["report"]["text"].encode(), options.output)
    else:
        _write(answer, options)
    return _judged(answer)


def _view(options: Namespace) -> int:
    body = {"scene": _scene(options)}
    answer = _checked(options.scene, lambda: calls.view_scene(body))
    _put(answer["text"].encode(), options.output)
    return CLEAN


def _export(options: Namespace) -> int:
    body = {"scene": _scene(options)}
    _write(_checked(options.scene, lambda: calls.export_scene(body)), options)
    return CLEAN


def _catalog(options: Namespace) -> int:
    _write(calls.catalog_document(_catalogs(options)), options)
    return CLEAN


def _schema(options: Namespace) -> int:
    _write(calls.schema_document(), options)
    return CLEAN


def _serve(options: Namespace) -> int:
    import_module("service.server").serve(options.host, options.port, _catalogs(options))
    return CLEAN


COMMANDS: Final[Mapping[str, Callable[[Namespace], int]]] = {
    "serve": _serve,
    "generate": _generate,
    "stats": _stats,
    "fix": _fix,
    "place": _place,
    "validate": _validate,
    "view": _view,
    "export": _export,
    "catalog": _catalog,
    "schema": _schema,
}


def _say(words: str) -> None:
    print(words, file=sys.stderr)


def _catalogs(options: Namespace) -> Catalogs:
    return load_catalogs(options.catalog and Path(options.catalog))


def _read(name: str) -> object:
    """Reads a file or standard input, by its name's ending or else by its first character."""
    content = sys.stdin.buffer.read() if name == STREAM else Path(name).read_bytes()
    format = format_of_name(name) or format_of_content(content)
    return _checked(name, lambda: parse(content, format))


def _checked(name: str | None, work: Callable[[], T]) -> T:
    """Does some work on a document; what is wrong with the document is said with its file's name."""
    try:
        return work()
    except FieldError as error:
        raise FieldError(f"{_spoken(name)}{error.field}", error.problem, error.allowed) from None
    except SyntaxFault as fault:
        raise SyntaxFault(f"{_spoken(name)}{fault}") from None


def _spoken(name: str | None) -> str:
    return "" if name is None else f"{'standard input' if name == STREAM else name}: "


def _scene(options: Namespace) -> object:
    """Reads a scene; of an answer that holds one, that one."""
    document = _read(options.scene)
    held = isinstance(document, dict) and "scene" in document and "rooms" not in document
    return document["scene"] if held and isinstance(document, dict) else document


def _request(options: Namespace) -> dict[str, Any]:
    document = {} if options.request is None else _read(options.request)
    if not isinstance(document, dict):
        raise FieldError(f"{_spoken(options.request)}request", "is not an object", "an object")
    given = {name: getattr(options, name) for name in (*NUMBERS, *SWITCHES, *WORDS) if getattr(options, name) is not None}
    forced = {"force_types": dict(options.force_types)} if options.force_types else {}
    return {**document, **given, **forced}


def _write(document: Mapping[str, Any], options: Namespace) -> None:
    format: str = options.format or format_of_name(options.output) or "yaml"
    _put(dump_text(document, format), options.output)


def _put(content: bytes, name: str) -> None:
    if name != STREAM:
        Path(name).write_bytes(content)
        return
    sys.stdout.buffer.write(content)
    sys.stdout.buffer.flush()


def _judged(answer: Mapping[str, Any], prefix: str = "") -> int:
    """Says what breaks the rules and returns the exit status."""
    for issue in answer["issues"]:
        _say(f"{prefix}{issue['severity']} {issue['rule']} {issue['room'] or ''}: {issue['message']}")
    return ERRORS_FOUND if calls.has_errors(answer["issues"]) else CLEAN
