"""The command line: what there is to say, and no more; `commands` does the work and is not imported before there is any."""

import gc
import os
import sys
from argparse import Action, ArgumentParser, ArgumentTypeError, BooleanOptionalAction, _SubParsersAction
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any, Final, TypeAlias

from service.effort import EFFORTS, NORMAL, YOUNG

Commands: TypeAlias = "_SubParsersAction[ArgumentParser]"

THREADED: Final = ("OMP", "OPENBLAS", "MKL", "NUMEXPR")
"""Libraries below numpy whose threads would only cost on small matrices, and whose sums must not depend on the machine."""
STATUSES: Final = "Exit status: 0 clean, 1 errors found in the scene, 2 bad use, 130 ended by Ctrl-C."
INTERRUPTED: Final = 130
"""What shells call a program that Ctrl-C ended."""


def forced(text: str) -> tuple[str, str]:
    """Reads a room's number and the type it shall have, such as 3=kitchen."""
    index, equals, room_type = text.partition("=")
    if not (index.isdecimal() and equals and room_type):
        raise ArgumentTypeError(f"{text!r} is not INDEX=TYPE, such as 3=kitchen")
    return index, room_type


def typed(text: str) -> tuple[str, str]:
    """Reads a room's id and the type it shall have, such as room_3=kitchen."""
    room, equals, room_type = text.rpartition("=")
    if not (room and equals and room_type):
        raise ArgumentTypeError(f"{text!r} is not ROOM=TYPE, such as room_3=kitchen")
    return room, room_type


def program(text: str) -> str | dict[str, int]:
    """Reads a preset's name, or counts such as bedrooms=3,bathrooms=2."""
    if "=" not in text:
        return text
    counts: dict[str, int] = {}
    for part in text.split(","):
        word, equals, number = part.partition("=")
        if not (word and equals and number.isdecimal()) or word in counts:
            raise ArgumentTypeError(f"{text!r} is no preset and not WORD=N,WORD=N, such as bedrooms=3,bathrooms=2")
        counts[word] = int(number)
    return counts


def outline(text: str) -> str | list[list[float]]:
    """Reads a word, or corners such as "0,0 8,0 8,6 0,6"."""
    if "," not in text:
        return text
    try:
        return [[float(x), float(z)] for x, z in (corner.split(",") for corner in text.split())]
    except ValueError:
        raise ArgumentTypeError(f"{text!r:.60} is no word and not corners, such as '0,0 8,0 8,6 0,6'") from None


def _whole(least: int, most: int, text: str) -> int:
    """Reads a whole number from `least` to `most`."""
    if not text.isdecimal() or not least <= int(text) <= most:
        raise ArgumentTypeError(f"{text!r} is not a whole number from {least} to {most}")
    return int(text)


_COUNT: Final = partial(_whole, 1, 10**9)


def _task(tasks: tuple[str, ...], text: str) -> str:
    """Reads which task a command is to do; a folder comes behind it."""
    if text not in tasks:
        raise ArgumentTypeError(f"{text!r} is no task: {' or '.join(tasks)}, then a folder")
    return text


def seeds(text: str) -> tuple[int, int]:
    """Reads the first and the last seed of a range, such as 0-999."""
    first, dash, last = text.partition("-")
    if not (first.isdecimal() and dash and last.isdecimal() and len(last) <= 16 and int(first) <= int(last) < 2**53):
        raise ArgumentTypeError(f"{text!r} is not A-B, such as 0-999, from 0 to 2^53-1")
    return int(first), int(last)


def _listed(words: Any, text: str) -> tuple[str, ...]:
    """Reads several words of `words`, with commas between."""
    given = tuple(dict.fromkeys(text.split(",")))
    if unknown := [word for word in given if word not in words]:
        raise ArgumentTypeError(f"{unknown[0]!r} is none of {', '.join(words)}")
    return given


def _command(commands: Commands, name: str, words: str) -> ArgumentParser:
    return commands.add_parser(name, help=words, description=words, epilog=STATUSES, allow_abbrev=False)


class _Version(Action):
    """Says which version this is, and ends; looked up late, since `--help` loads nothing."""

    def __call__(self, parser: ArgumentParser, *_: object) -> None:
        from solver.version import VERSION

        print(parser.prog, VERSION)
        parser.exit()


class _ExportWords:
    """The words `before`, then those that solver.export_formats has under a name: looked up late, since `--help` loads nothing."""

    def __init__(self, name: str, *before: str) -> None:
        self._name, self._before = name, before

    def __iter__(self) -> Iterator[str]:
        from solver import export_formats

        return iter((*self._before, *getattr(export_formats, self._name)))

    def __contains__(self, word: object) -> bool:
        return word in tuple(self)


def _add_output(command: ArgumentParser, what: str, formats: tuple[str, ...] = ("yaml", "json")) -> None:
    command.add_argument("-o", "--output", metavar="FILE", default="-", help=f"where to write {what} (standard output)")
    command.add_argument("-f", "--format", choices=formats, help=f"of what is written (by the output's name, else {formats[0]})")


def _add_catalog(command: ArgumentParser) -> None:
    command.add_argument("--catalog", metavar="DIR", help="a folder of your own catalog files, laid over ours (catalogs/example)")
    command.add_argument("--assets", metavar="DIR", help="a folder of your own .glb files with an assets.yaml, which bodies are shown as")
    words = "assets of these licences are used: those that allow commercial use (commercial), or any"
    command.add_argument("--license", choices=("commercial", "any"), default="commercial", help=words)


def _add_engine(command: ArgumentParser) -> None:
    command.add_argument("--engine", choices=("osqp", "reference"), default="osqp", help="of the final QP (osqp)")


def _add_workers(command: ArgumentParser) -> None:
    command.add_argument("--workers", type=_COUNT, default=os.cpu_count() or 1, metavar="N", help="processes for many houses (one a core)")


def _add_effort(command: ArgumentParser) -> None:
    command.add_argument("--effort", choices=tuple(EFFORTS), default=NORMAL, help="how much work the search may do (normal)")


def _add_scene(command: ArgumentParser) -> None:
    command.add_argument("scene", nargs="?", default="-", metavar="SCENE", help="a scene, YAML or JSON (standard input)")


def _add_request(command: ArgumentParser, seed: str, decorated: str) -> None:
    """Adds the request file and an option for each field of `Request`, under the field's name."""
    command.add_argument("request", nargs="?", metavar="REQUEST", help="a request, YAML or JSON; - for standard input")
    _add_request_keys(command, seed, decorated)


def _add_request_keys(command: ArgumentParser, seed: str, decorated: str) -> None:
    """Adds an option for each field of `Request`; the words say what the seed is to the command, and if homes are decorated unasked."""
    add = command.add_argument
    add("--seed", type=int, metavar="N", help=seed)
    add("--program", type=program, metavar="PRESET|WORD=N,...", help="the rooms of a home: family; bedrooms=3,bathrooms=2")
    add("--area", type=float, metavar="N", help="of the house's floor, m2: a home is planned for it")
    add("--outline", type=outline, metavar="WHICH", help="of a planned home: rectangle, L, T, U or any (any); or corners: x,z x,z ...")
    add("--width", type=float, metavar="N", help="of the house, m (20, or what the programme needs)")
    add("--depth", type=float, metavar="N", help="of the house, m (15, or what the programme needs)")
    add("--style", metavar="NAME", help="the style of the house")
    add("--min-room-size", type=float, metavar="N", help="shortest side of a room, m (3)")
    add("--max-depth", type=int, metavar="N", help="how often the plan is split (5)")
    add("--access", metavar="PROFILE", help="a standard that the home is made for: none, din_18040_2, din_18040_2_r, ada (none)")
    add("--robot-width", type=float, metavar="N", help="of what must be able to walk everywhere, m (0.6)")
    add("--wall-thickness", type=float, metavar="N", help="of inner walls, m (0.1)")
    add("--outer-wall-thickness", type=float, metavar="N", help="of outer walls, m (as inner ones)")
    add("--force-type", dest="force_types", action="append", type=forced, metavar="INDEX=TYPE", help="a room's type")
    switch = partial(add, action=BooleanOptionalAction)
    switch("--use-spine", help="a hallway through the house (on)")
    switch("--outdoor", help="turn rooms at the outside into a backyard and a patio (off)")
    switch("--decorate", help=f"decorate surfaces, walls and floors ({decorated})")
    switch("--people", help="people and pets, as the catalogs say (on)")


def _add_generate(commands: Commands) -> None:
    command = _command(commands, "generate", "Make a furnished house; options win over the request file.")
    _add_request(command, "0 ... 2^53-1 (drawn; with --count the first one's, 0)", "off")
    command.add_argument("-n", "--count", type=_COUNT, metavar="N", help="make N houses of successive seeds into the folder -o")
    _add_workers(command)
    _add_engine(command)
    _add_output(command, "the scene")
    _add_catalog(command)


def _add_furnish(commands: Commands) -> None:
    command = _command(commands, "furnish", "Furnish the rooms of a plan of your own; says what was guessed of it.")
    command.add_argument("scene", nargs="?", default="-", metavar="PLAN", help="a scene, or what import reads (standard input)")
    add = command.add_argument
    add("--room", dest="rooms", action="append", default=[], metavar="ID", help="a room to furnish (every empty one); may be repeated")
    add("--keep", choices=("all", "locked", "none"), default="all", help="what stays in them (all)")
    words = "a room's type, instead of what the plan says or what would be guessed; may be repeated"
    add("--type", dest="types", action="append", default=[], type=typed, metavar="ROOM=TYPE", help=words)
    add("--program", type=program, metavar="PRESET|WORD=N,...", help="what rooms the home has, to guess by: family; bedrooms=3")
    add("--style", metavar="NAME", help="the style of the home")
    add("--seed", type=int, metavar="N", help="0 ... 2^53-1; the plan's own, else drawn")
    add("--decorate", action=BooleanOptionalAction, help="decorate surfaces, walls and floors (as the plan says, else off)")
    add(
        "--access",
        metavar="PROFILE",
        help="furnish as a standard asks: none, din_18040_2, din_18040_2_r, ada (as the plan says, else none)",
    )
    _add_effort(command)
    _add_output(command, "the scene")
    _add_catalog(command)


def _add_fix(commands: Commands) -> None:
    command = _command(commands, "fix", "Repair a scene by moving as little as possible.")
    _add_scene(command)
    command.add_argument(
        "--lock", dest="locked", action="append", default=[], metavar="ID", help="a body that stays where it is; may be repeated"
    )
    command.add_argument("--moved", action="append", default=[], metavar="ID", help="a body that was just moved; may be repeated")
    command.add_argument("--on-conflict", choices=("report", "remove"), default="report", help="what becomes of what cannot stand")
    _add_effort(command)
    _add_output(command, "the scene")
    _add_catalog(command)


def _add_place(commands: Commands) -> None:
    command = _command(commands, "place", "Place a list of pieces in a room; writes the placement with its relations and reasons.")
    command.add_argument("request", nargs="?", default="-", metavar="REQUEST", help="room and pieces, YAML or JSON (standard input)")
    command.add_argument("-n", "--alternatives", type=_COUNT, metavar="N", help="find up to N truly different placements")
    command.add_argument("--effort", choices=tuple(EFFORTS), help="how much work the search may do (what the request says, else normal)")
    _add_engine(command)
    _add_output(command, "the answer")
    _add_catalog(command)


def _add_readers(commands: Commands) -> None:
    validate = _command(commands, "validate", "List which rules a scene breaks.")
    _add_scene(validate)
    validate.add_argument("--report", action="store_true", help="write all there is in words, what is wrong marked >>")
    validate.add_argument(
        "--flag", dest="flagged", action="append", default=[], metavar="ID", help="a body to mark PROBLEMATIC in the report"
    )
    validate.add_argument("--access", metavar="PROFILE", help="judge as a standard asks: din_18040_2, din_18040_2_r, ada")
    _add_output(validate, "issues and metrics")
    _add_catalog(validate)
    view = _command(commands, "view", "Write a scene for a person to read.")
    _add_scene(view)
    view.add_argument("-o", "--output", metavar="FILE", default="-", help="where to write the text (standard output)")
    _add_catalog(view)
    explain = _command(commands, "explain", "Say where a piece of a generated home was wished, and what holds it back from there.")
    explain.add_argument("scene", metavar="SCENE", help="a scene, YAML or JSON; - for standard input")
    explain.add_argument("id", metavar="ID", help="of a piece of furniture")
    _add_output(explain, "the answer")
    _add_catalog(explain)
    export = _command(commands, "export", "Write a scene for a simulator, an editor or a training set; or as a scene, all written out.")
    _add_scene(export)
    add = export.add_argument
    add("-o", "--output", metavar="FILE", default="-", help="a folder, or of a format of one file home.glb, say (standard output)")
    formats: Any = _ExportWords("EXPORTERS", "yaml", "json")
    add("-f", "--format", metavar="FORMAT", choices=formats, help="%(choices)s; by default that of the output's name, else yaml")
    freedoms: Any = _ExportWords("FREEDOMS")
    add("--free", metavar="WHAT", choices=freedoms, default="light", help="what a simulator may move: %(choices)s (light)")
    export.add_argument("--scale", metavar="N", type=int, help="of an SVG plan, 1 to so much (the largest that A3 holds)")
    export.add_argument("--strict", action="store_true", help="refuse a scene with errors; else the files say them")
    _add_catalog(export)


def _add_import(commands: Commands) -> None:
    command = _command(commands, "import", "Read a floor plan of another program as a scene; says what is not as the file says.")
    command.add_argument("plan", nargs="?", default="-", metavar="FILE", help="a plan: docs/plans.md names the formats (standard input)")
    command.add_argument("--level", type=int, metavar="N", help="the storey to take (the lowest with rooms)")
    command.add_argument("--unit", metavar="UNIT", help="of the file, where it does not say: m, cm, mm, in, ft, or a number of metres")
    command.add_argument("--furniture", choices=("keep", "none"), default="keep", help="whether the file's furniture comes along (keep)")
    command.add_argument("--report", metavar="FILE", help="where to write all changes, guesses and what was left out, YAML or JSON")
    _add_output(command, "the scene")
    _add_catalog(command)


def _add_serve(commands: Commands, everything: bool) -> None:
    command = _command(commands, "serve", "Answer over HTTP, with the page at /.")
    if everything:
        _add_settings(command)
        _add_catalog(command)


def _add_settings(command: ArgumentParser) -> None:
    from service.service_settings import FILE, PREFIX, all_settings  # the help of the other commands needs none of it

    words = f"a file of these settings, request_seconds: 5 for --request-seconds 5; or in the environment, {PREFIX}REQUEST_SECONDS=5"
    command.add_argument(f"--{FILE}", metavar="FILE", help=words)
    for one in all_settings():
        default = "" if one.default in ((), None) else f" ({one.default})"
        words = one.words + ("; may be given several times" if one.is_list else default)
        command.add_argument(one.option, metavar="VALUE", action="append" if one.is_list else "store", help=words)


def _add_tellers(commands: Commands) -> None:
    catalog = _command(commands, "catalog", "Write all furniture, decorations, room types, styles and presets there are.")
    _add_output(catalog, "it")
    _add_catalog(catalog)
    _add_output(_command(commands, "schema", "Write the JSON Schema of a scene."), "it")


def _add_assets(commands: Commands) -> None:
    words = "Check a folder of your own .glb files; writes its assets.yaml, what is not said measured or guessed, and marked so."
    command = _command(commands, "assets", words)
    command.add_argument("task", type=partial(_task, ("check",)), metavar="TASK", help="check: measure all, refuse what cannot be used")
    command.add_argument("folder", metavar="DIR", help="holds .glb files, and an assets.yaml if there is one already")
    command.add_argument("--surfaces", action="store_true", help="find where things may lie, too: reads all points of the files")
    command.add_argument("-o", "--output", metavar="FILE", default="-", help="where to write assets.yaml (standard output)")
    command.add_argument("--catalog", metavar="DIR", help="a folder of your own catalog files, laid over ours (catalogs/example)")


def _add_stats(commands: Commands) -> None:
    words = "Make many houses and say what they are like; --seed is the first one's (0), and they are decorated if nothing else is said."
    command = _command(commands, "stats", words)
    _add_request(command, "of the first house, 0 ... 2^53-1 (0)", "on")
    command.add_argument("-n", "--count", type=_COUNT, default=100, metavar="N", help="how many houses (100)")
    command.add_argument("--presets", action="store_true", help="as many of each preset, side by side")
    _add_workers(command)
    _add_output(command, "it", ("table", "yaml", "json"))
    _add_catalog(command)


def _add_dataset(commands: Commands) -> None:
    words = "Make homes by the thousand in files that training reads; make one of them again; check that all is as it was made."
    command = _command(commands, "dataset", words)
    add = command.add_argument
    add("task", nargs="?", type=partial(_task, ("make", "check")), metavar="TASK", help="make: its home of --seed anew; check: all of it")
    add("folder", nargs="?", metavar="DIR", help="of the task: a dataset")
    add("--out", metavar="DIR", help="where the dataset is made, or gone on with")
    add("--seeds", type=seeds, metavar="A-B", help="the first and the last seed")
    formats: Any = _ExportWords("EXPORTERS", "json", "yaml")
    words = "json (default), and formats of export; of make: yaml or json (by the output's name, else json)"
    add("-f", "--format", "--formats", dest="formats", type=partial(_listed, formats), metavar="F,...", help=words)
    add("--request", metavar="FILE", help="a request, YAML or JSON; options win over it")
    _add_request_keys(command, "of make: the home's", "on")
    add("--vary", metavar="FILE", help="how requests differ: weights by key, YAML or JSON (docs/datasets.md)")
    add("--shard-size", type=partial(_whole, 1, 100_000), default=250, metavar="N", help="homes that are made and written together (250)")
    _add_workers(command)
    add("--ray", nargs="?", const="local", metavar="ADDRESS", help="spread over a Ray cluster (this machine's own)")
    add("--sample", type=_COUNT, metavar="N", help="of check: homes that are made again and validated (100)")
    add("--all", action="store_true", help="of check: every home")
    add("-o", "--output", metavar="FILE", default="-", help="of make: where to write the scene (standard output)")
    _add_catalog(command)


def parser(everything: bool = True) -> ArgumentParser:
    """Returns the parser of the whole command line, the commands in the order of their use: what takes long comes last.

    `everything`: `serve` has its options, too, for which types must be loaded.
    """
    words = "Lays out whole furnished homes and proves they work."
    whole = ArgumentParser("compose", description=words, epilog=STATUSES, allow_abbrev=False)
    whole.add_argument("--version", action=_Version, nargs=0, help="show the version and exit")
    commands = whole.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for add in (
        _add_generate,
        _add_furnish,
        _add_fix,
        _add_place,
        _add_readers,
        _add_import,
        partial(_add_serve, everything=everything),
        _add_tellers,
        _add_assets,
        _add_stats,
        _add_dataset,
    ):
        add(commands)
    return whole


def main(arguments: Sequence[str] | None = None, begin: Callable[[], object] = bool) -> int:
    """Runs a command.

    Args:
        arguments: the words after the program's name; by default the process's own.
        begin: called when all is read that the command needs to begin; from here on Ctrl-C is told.

    Returns:
        The exit status: 0 clean, 1 errors found, 2 bad use, 130 ended by Ctrl-C.
    """
    words = sys.argv[1:] if arguments is None else arguments
    options = parser("serve" in words).parse_args(words)
    for library in THREADED:
        os.environ.setdefault(f"{library}_NUM_THREADS", "1")
    gc.set_threshold(YOUNG)  # what a command loads stays: to look it through again and again took an eighth of a short one
    try:
        from service.commands import run  # --help needs none of it

        begin()
        return run(options)
    except KeyboardInterrupt:
        from service.standard_streams import give_up_output, say

        give_up_output()
        say("compose: ended")
        return INTERRUPTED
