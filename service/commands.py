"""What each command does. Nothing but the document goes to standard output; words for a person go to standard error.

A command imports what it needs when it runs: `compose schema` starts without the solver.
"""

import os
from argparse import Namespace
from collections.abc import Callable, Mapping
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from service.command_files import (
    checked,
    format_of_foreign,
    held_scene,
    listed,
    parsed,
    read_file,
    scene_of_file,
    spoken,
    told_as_sent,
    told_assets,
    told_kinds,
)
from service.service_settings import settings_of
from service.standard_streams import STREAM, give_up_output, put, read_content, say
from solver.errors import ComposeError, FieldError, system_words
from solver.exchange import dump_scene, dump_text, format_of_name, read_request, scene_schema, write
from solver.export_formats import EXPORTERS
from solver.plain import Document
from solver.request import Request
from solver.whole_files import write_whole

if TYPE_CHECKING:
    from catalogs import Catalogs
    from solver.answers import ImportSettings


CLEAN: Final = 0
ERRORS_FOUND: Final = 1
BAD_USE: Final = 2


def run(options: Namespace) -> int:
    """Runs the command that the options name and returns the exit status."""
    try:
        return COMMANDS[options.command](options)
    except BrokenPipeError:
        give_up_output()
        return BAD_USE
    except OSError as error:
        give_up_output()
        say(f"compose: {system_words(error)}")
        return BAD_USE
    except ComposeError as error:
        say(f"compose: {error}")
        return BAD_USE
    except MemoryError:
        say("compose: there is not enough memory for it")
        return BAD_USE


def _generate(options: Namespace) -> int:
    catalogs, request = _catalogs(options), _request(options)
    if options.count is not None:
        return _generate_many(options, request, catalogs)
    from service.generating import made_house

    made = checked(options.request, lambda: made_house(request, catalogs, options.engine))
    put(dump_scene(made.scene, _format(options)), options.output)
    return _judged([write(issue) for issue in made.issues])


def _generate_many(options: Namespace, request: Mapping[str, Any], catalogs: "Catalogs") -> int:
    """Makes a set of houses into a folder, one file a seed; goes on where it was ended."""
    from service.many import HouseSet, into_folder

    folder = Path(options.output)
    if options.output == STREAM or folder.is_file():
        raise FieldError("--output", f"{options.output} holds one document", "with --count, a folder")
    start = read_request({"seed": request.get("seed")}).seed or 0
    houses = HouseSet(request, folder, options.format or "yaml", options.engine)
    made = into_folder(houses, range(start, start + options.count), catalogs, options.workers)
    return checked(options.request, lambda: max((_judged(issues, f"seed {seed}: ") for seed, issues in made), default=CLEAN))


def _stats(options: Namespace) -> int:
    """Makes many houses, of one request or of every preset, and writes what they are like."""
    from service.many import survey
    from service.tables import report

    catalogs, request = _catalogs(options), {"decorate": True, **_request(options)}
    if options.presets and ("program" in request or not catalogs.presets):
        raise FieldError("--presets", "asks for every preset there is", "without --program, and with presets in the catalog")
    requests = [{**request, "program": name} for name in catalogs.presets] if options.presets else [request]
    found = checked(options.request, lambda: survey(requests, options.count, options.workers, catalogs))
    format = options.format or format_of_name(options.output) or "table"
    put(report(found).encode() if format == "table" else dump_text(found, format), options.output)
    return max(_exit_status(one["issues"]) for one in found["sets"])


def _answer(options: Namespace, **more: object) -> Document:
    """Makes the service's call of the command's name on its scene; what is wrong with that is said with its file's name."""
    return _answer_on(scene_of_file(options.scene), options, **more)


def _answer_on(scene: object, options: Namespace, **more: object) -> Document:
    from service.calls import CALLS

    catalogs = _catalogs(options)
    told_kinds(scene, catalogs)
    return checked(options.scene, lambda: CALLS[options.command]({"scene": scene, **more}, catalogs))


def _furnish(options: Namespace) -> int:
    from solver.answers import ImportSettings

    name, content = options.scene, read_content(options.scene)
    foreign = format_of_foreign(name, content)
    scene = _imported(name, content, options, ImportSettings())["scene"] if foreign else held_scene(parsed(name, content))
    given = {name: getattr(options, name) for name in ("program", "style", "decorate", "access", "seed")}
    more = {name: value for name, value in given.items() if value is not None}
    answer = _answer_on(scene, options, rooms=options.rooms, keep=options.keep, types=dict(options.types), effort=options.effort, **more)
    _write(answer["scene"], options)
    for guess in answer["guesses"]:
        say(f"guessed {guess['message']}" + (f"; else {guess['instead']}" if guess["instead"] else ""))
    if answer["entrance"]:
        say(answer["entrance"]["message"])
    _told_limited(answer)
    for room, reason in answer["left"].items():
        say(f"left {room}: {reason}")
    if options.keep == "all" and not options.rooms:
        told_as_sent(scene, answer["scene"])
    return _judged(answer["issues"])


def _fix(options: Namespace) -> int:
    answer = _answer(options, locked=options.locked, moved=options.moved, on_conflict=options.on_conflict, effort=options.effort)
    _write(answer["scene"], options)
    say(f"{len(answer['moves'])} moved, {len(answer['removed'])} removed, {len(answer['conflicts'])} in conflict")
    for entry in answer["removed"]:
        say(f"removed {entry['id']}: {entry['reason']}")
    _contested(answer)
    return _judged(answer["issues"])


def _place(options: Namespace) -> int:
    from service import calls

    given = read_file(options.request)
    given_here = {"alternatives": options.alternatives, "effort": options.effort}
    more = {name: value for name, value in given_here.items() if value is not None}
    body = {**given, **more} if isinstance(given, dict) else given
    answer = checked(options.request, lambda: calls.place_pieces(body, _catalogs(options), options.engine))
    _write(answer, options)
    for relation in answer["relations"]:
        if not relation["held"]:
            say(f"not held: {relation['piece']} {relation['type']} {relation['of'] or ''}".rstrip())
    for entry in answer["unplaced"]:
        say(f"unplaced {entry['id']}: {entry['reason']}")
    return max(_judged(answer["issues"]), _contested(answer))


def _validate(options: Namespace) -> int:
    answer = _answer(options, flagged=options.flagged, report=options.report, **({"access": options.access} if options.access else {}))
    if options.report:
        put(answer["report"]["text"].encode(), options.output)
    else:
        _write(answer, options)
    for place, meant in answer.get("misspelt", {}).items():
        say(f"{place} is not known, and kept; {meant}?")
    unmet = answer.get("access", {}).get("unmet", ())
    for words in unmet:
        say(f"access {options.access}: {words}")
    return max(_judged(answer["issues"]), ERRORS_FOUND if unmet else CLEAN)


def _view(options: Namespace) -> int:
    put(_answer(options)["text"].encode(), options.output)
    return CLEAN


def _explain(options: Namespace) -> int:
    _write(_answer(options, id=options.id), options)
    return CLEAN


def _export(options: Namespace) -> int:
    from service.calls import export_files

    format = options.format or _exporter_of(options.output) or "yaml"
    if format not in EXPORTERS:
        _write(_answer(options), options)
        return CLEAN
    scene, catalogs = scene_of_file(options.scene), _catalogs(options)
    told_kinds(scene, catalogs)
    told_assets(scene, catalogs)
    body = {"scene": scene, "free": options.free, "strict": options.strict, "scale": options.scale}
    files = checked(options.scene, lambda: export_files(body, catalogs, format))
    _put_files(files, options.output)
    return CLEAN


def _import(options: Namespace) -> int:
    from solver.answers import ImportSettings

    asked = ImportSettings(options.level, options.unit, options.furniture == "keep")
    answer = _imported(options.plan, read_content(options.plan), options, asked)
    _write(answer["scene"], options)
    if options.report is not None:
        told = {key: answer[key] for key in ("format", "changes", "guesses", "unread", "understood_as")}
        put(dump_text(told, format_of_name(options.report) or "yaml"), options.report)
    return _judged([issue for issue in answer["issues"] if issue["severity"] == "error"])


def _imported(name: str, content: bytes, options: Namespace, settings: "ImportSettings") -> Document:
    """Reads a plan of another program, and says all that is not as it is drawn."""
    from service.calls import import_content

    answer = checked(name, lambda: import_content(content, _catalogs(options), settings, "" if name == STREAM else name))
    say(f"read as {answer['format']}: {len(answer['scene']['rooms'])} rooms")
    for change in answer["changes"]:
        say(f"changed {change['of']}: {change['message']}")
    for guess in answer["guesses"]:
        say(f"guessed {guess['what']} of {guess['of']}: {guess['taken']}: {guess['message']}")
    for left in answer["unread"]:
        say(f"left out {left['place']}: {left['reason']}")
    return answer


def _exporter_of(name: str) -> str | None:
    """Returns the format that a file's name ends with, if there is one."""
    ending = Path(name).suffix.removeprefix(".").lower()
    return ending if ending in EXPORTERS else None


def _ends_as_file(name: str) -> bool:
    return any(letter.isalpha() for letter in Path(name).suffix)  # a folder may be called out0.4


def _put_files(files: Mapping[str, bytes], name: str) -> None:
    """Writes files into a folder; one alone also under a name that ends as a file's does, or to standard output. Several need a folder."""
    content = next(iter(files.values()))
    if name == STREAM or Path(name).is_file() or (_ends_as_file(name) and not Path(name).is_dir()):
        if len(files) > 1:
            raise FieldError("--output", f"{name} holds one file; there are {len(files)}", "a folder")
        put(content, name)
        return
    for path, content in files.items():
        target = Path(name, path)
        target.parent.mkdir(parents=True, exist_ok=True)
        write_whole(target, content)
    say(f"wrote {', '.join(str(Path(name, path)) for path in list(files)[:6])}{', ...' if len(files) > 6 else ''}")


def _catalog(options: Namespace) -> int:
    _write(_catalogs(options).model_dump(mode="json"), options)
    return CLEAN


def _schema(options: Namespace) -> int:
    _write(scene_schema(), options)
    return CLEAN


def _assets(options: Namespace) -> int:
    """Checks a folder of assets: says on standard error what is refused and what was guessed."""
    from catalogs.assets.asset_check import checked_folder
    from solver.exports.asset_surfaces import levels_of

    found = checked_folder(Path(options.folder), _catalogs(options), levels_of if options.surfaces else None)
    put(found.text.encode(), options.output)
    for words in found.notes:
        say(words)
    for file, reason in found.refused.items():
        say(f"refused {file}: {reason}")
    say(f"{len(found.entries)} assets, {len(found.refused)} refused, {found.guessed} with something guessed")
    return ERRORS_FOUND if found.refused else CLEAN


def _dataset(options: Namespace) -> int:
    from service.dataset.dataset_commands import run_dataset

    return run_dataset(options, _catalogs(options), {"decorate": True, **_request(options)})


def _serve(options: Namespace) -> int:
    from service.server import serve

    serve(settings_of(vars(options), os.environ), _catalogs(options))
    return CLEAN


COMMANDS: Final[Mapping[str, Callable[[Namespace], int]]] = {
    "generate": _generate, "furnish": _furnish, "fix": _fix, "place": _place, "validate": _validate, "view": _view,
    "explain": _explain, "export": _export, "serve": _serve, "catalog": _catalog, "schema": _schema, "stats": _stats,
    "assets": _assets, "import": _import, "dataset": _dataset,
}  # fmt: skip


def _catalogs(options: Namespace) -> "Catalogs":
    """Reads our catalogs, or a folder of the user's own laid over them, and the user's assets."""
    from catalogs import load_catalogs

    catalogs, assets = load_catalogs(getattr(options, "catalog", None) or None), getattr(options, "assets", None)
    if assets is None:
        return catalogs
    from catalogs import add_assets
    from catalogs.assets.asset_folder import ASSET_FILE, entries_of

    used = add_assets(catalogs, assets, options.license)
    if unused := entries_of(Path(assets) / ASSET_FILE).keys() - used.assets.keys():
        say(f"not used, as nobody says that their licence allows commercial use: {listed(sorted(unused))} (--license any uses them)")
    return used


def _request(options: Namespace) -> dict[str, Any]:
    """Reads the request's file, if there is one; what the options say goes before it."""
    document = {} if options.request is None else read_file(options.request)
    if not isinstance(document, dict):
        raise FieldError(f"{spoken(options.request)}request", "is not an object", "an object")
    given = {field.name: getattr(options, field.name) for field in fields(Request)}
    forced = {"force_types": dict(options.force_types)} if options.force_types else {}
    return {**document, **{name: value for name, value in given.items() if value is not None}, **forced}


def _write(document: Mapping[str, Any], options: Namespace) -> None:
    put(dump_text(document, _format(options)), options.output)


def _format(options: Namespace) -> str:
    """Returns the format of what is written: by the option, else by the output's name, else YAML; refuses the name of another format."""
    found = options.format or format_of_name(options.output)
    if found is None and _ends_as_file(options.output) and not options.output.endswith(".txt"):
        raise FieldError("--output", f"{options.output} names no format", ".yaml or .json; --format names it, of `export` any other, too")
    return found or "yaml"


def _contested(answer: Mapping[str, Any]) -> int:
    """Says what cannot stand together and returns the exit status."""
    _told_limited(answer)
    for conflict in answer["conflicts"]:
        say(f"conflict {', '.join(conflict['ids'])}: {conflict['message']}")
    return ERRORS_FOUND if answer["conflicts"] else CLEAN


def _told_limited(answer: Mapping[str, Any]) -> None:
    """Says where the limit of work ended a search."""
    if "limited" in answer:
        say(answer["limited"]["message"])


def _judged(issues: list[Document], prefix: str = "") -> int:
    """Says what breaks the rules and returns the exit status."""
    for issue in issues:
        say(f"{prefix}{issue['severity']} {issue['rule']} {issue['room'] or ''}: {issue['message']}")
    return _exit_status(issues)


def _exit_status(issues: list[Document]) -> int:
    return ERRORS_FOUND if any(issue["severity"] == "error" for issue in issues) else CLEAN
