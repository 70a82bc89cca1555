"""What whoever runs the service may set: declared once, as fields, for options, environment, file and `--help`.

A setting has one name in all three: `request_seconds` in a file, `--request-seconds` as an option, `COMPOSE_HOMES_REQUEST_SECONDS` in the
environment. Options go before the environment, that before the file, that before the defaults.
"""

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Annotated, Any, Final, get_args, get_origin, get_type_hints

from annotated_types import Ge, Gt, Le

from service.effort import EFFORTS, NORMAL_JUDGING, NORMAL_WORK
from solver.errors import ComposeError, FieldError, system_words
from solver.fields import STRICT, WHOLE, Flag, Name, OneOf, Record, Says

PREFIX: Final = "COMPOSE_HOMES_"
"""How the names of environment variables begin that are ours."""
FILE: Final = "settings"
"""The option, and with PREFIX the environment variable, that names the file of settings."""
Seconds = Annotated[float, STRICT, Gt(0), Le(86_400)]


@dataclass(frozen=True)
class Settings(Record):
    """The settings of a service. What each means stands in its `Says`."""

    host: Annotated[Name, Says("address to listen at")] = "127.0.0.1"
    port: Annotated[int, Ge(0), Le(65_535), WHOLE, Says("port to listen at; 0 for any free one")] = 8000
    allow_host: Annotated[
        tuple[Name, ...], Says("a name that it answers to, beside the host and those of this machine's own loop; * for any")
    ] = ()
    processes: Annotated[int, Ge(0), Le(1024), WHOLE, Says("calls that run at once; 0 for one a core, and two at least")] = 0
    light_processes: Annotated[int, Ge(1), Le(1024), WHOLE, Says("more processes, for calls that are quickly done")] = 2
    light_bytes: Annotated[int, Ge(0), Le(2**30), WHOLE, Says("the largest body of such a call, bytes")] = 256 * 1024
    waiting: Annotated[int, Ge(0), Le(100_000), WHOLE, Says("calls that may wait in each lane; the next is answered by 503")] = 32
    work: Annotated[int, Ge(1000), Le(10**12), WHOLE, Says("work that a call of normal effort may do, in searches of a small room")] = (
        NORMAL_WORK
    )
    judging: Annotated[int, Ge(1000), Le(10**12), WHOLE, Says("work that a call may do beside its searches, in the same unit")] = (
        NORMAL_JUDGING
    )
    most_effort: Annotated[str, OneOf(*EFFORTS), Says(f"the most that may be asked for: {', '.join(EFFORTS)}")] = list(EFFORTS)[-1]
    request_seconds: Annotated[Seconds, Says("how long a call may run, s")] = 60.0
    metrics: Annotated[Flag, Says("whether /metrics tells Prometheus figures: true or false")] = True
    access_log: Annotated[str, OneOf("off", "json"), Says("a line for each request on standard error: off or json")] = "off"
    grace_seconds: Annotated[Seconds, Says("how long accepted calls may go on when the service is told to stop, s")] = 60.0
    header_seconds: Annotated[Seconds, Says("how long the headers of a request may take to arrive, s")] = 10.0
    body_seconds: Annotated[Seconds, Says("how long its body may take to arrive, and a client not to take the answer, s")] = 30.0
    idle_seconds: Annotated[Seconds, Says("how long a connection may be idle between requests, s")] = 5.0
    connections: Annotated[int, Ge(1), Le(100_000), WHOLE, Says("open connections; those that wait for their client give way")] = 512
    client_connections: Annotated[int, Ge(0), Le(100_000), WHOLE, Says("connections of an address; 0 for any number, as of a proxy")] = 128
    keys_file: Annotated[Name | None, Says("a file of keys of those who may ask, YAML: name: key a line; without keys everybody may")] = (
        None
    )
    keys: Annotated[tuple[Name, ...], Says("name=key of one who may ask; best in the environment, as others can read options")] = ()
    key_calls: Annotated[int, Ge(0), Le(1_000_000), WHOLE, Says("calls a minute that the owner of a key may make; 0 for any number")] = 0
    key_work: Annotated[float, STRICT, Ge(0), Le(1e9), Says("work a day that the owner of a key may have, s; 0 for any")] = 0.0
    address_calls: Annotated[int, Ge(0), Le(1_000_000), WHOLE, Says("calls a minute that an address may make; 0 for any number")] = 0
    address_work: Annotated[float, STRICT, Ge(0), Le(1e9), Says("work a day that an address may have, s; 0 for any")] = 0.0
    allow_origin: Annotated[tuple[Name, ...], Says("a place such as https://homes.example whose pages may ask")] = ()
    store: Annotated[
        Name | None, Says("where homes are kept: a file, postgresql://..., temporary or none; by default the user's data folder")
    ] = None
    homes_each: Annotated[int, Ge(1), Le(10_000_000), WHOLE, Says("homes that the owner of a key may keep")] = 1000
    megabytes_each: Annotated[int, Ge(1), Le(10_000_000), WHOLE, Says("how large they may be together, MB")] = 500

    def running(self) -> int:
        """Returns how many calls run at once."""
        return self.processes or max(2, os.cpu_count() or 1)


class WrongSetting(ComposeError):
    """A setting that cannot be used; says which, and where it was said."""


@dataclass(frozen=True)
class Setting:
    """One setting, as `--help` and options know it: its field's name, what it means, its value where nobody says anything.

    `is_list`: it may be given several times (with commas between, in the environment).
    """

    name: str
    words: str
    default: object
    is_list: bool

    @property
    def option(self) -> str:
        """Its option."""
        return "--" + self.name.replace("_", "-")

    @property
    def variable(self) -> str:
        """Its environment variable."""
        return PREFIX + self.name.upper()


def all_settings() -> Iterator[Setting]:
    """Yields every setting, in the order of `--help`."""
    hints = get_type_hints(Settings, include_extras=True)
    for part in fields(Settings):
        hint = hints[part.name]
        words = next(one.words for one in get_args(hint) if isinstance(one, Says))
        yield Setting(part.name, words, part.default, get_origin(get_args(hint)[0]) is tuple)


def settings_of(options: Mapping[str, Any], environment: Mapping[str, str]) -> Settings:
    """Returns the settings that are said anywhere.

    Args:
        options: words by setting's name, a list of words where it may be given several times, None where it is not given; and FILE.
        environment: of the process.

    Raises:
        WrongSetting: one is unknown or cannot be used; the file cannot be read.
    """
    known = {one.name: one for one in all_settings()}
    said: dict[str, object] = {}
    places: dict[str, str] = {}

    def take(found: Mapping[str, object], place: str) -> None:
        said.update(found)
        places.update({name: place.format(known[name]) for name in found if name in known})

    file = options.get(FILE) or environment.get(PREFIX + FILE.upper())
    if file:
        take(_in_file(str(file)), f"{file}: {{0.name}}")
    take(_in_environment(environment, known), "{0.variable}")
    take({name: _value(one, options[name]) for name, one in known.items() if options.get(name) not in (None, [])}, "{0.option}")
    return _checked(said, places)


def _in_environment(environment: Mapping[str, str], known: Mapping[str, Setting]) -> dict[str, object]:
    ours = {key: words for key, words in environment.items() if key.startswith(PREFIX) and key != PREFIX + FILE.upper()}
    variables = {one.variable: one for one in known.values()}
    if unknown := sorted(ours.keys() - variables.keys()):
        raise WrongSetting(f"{unknown[0]} is no setting; there are {', '.join(variables)}")
    return {variables[key].name: _value(variables[key], words) for key, words in ours.items()}


def _in_file(name: str) -> dict[str, object]:
    from solver.exchange import format_of_file, load_text  # noqa: PLC0415 - --help needs none of it

    try:
        content = Path(name).read_bytes()
    except OSError as error:
        raise WrongSetting(f"the settings cannot be read: {system_words(error)}") from None
    document = load_text(content, format_of_file(name, content)) if content.strip() else {}
    if not isinstance(document, dict):
        raise WrongSetting(f"{name} holds no settings, name by name")
    return document


def _value(one: Setting, said: object) -> object:
    """Returns what words of the command line or the environment mean: what is not a text is written as in YAML."""
    if one.is_list:
        words = [said] if isinstance(said, str) else list(said)  # type: ignore[call-overload]
        return [part.strip() for word in words for part in str(word).split(",") if part.strip()]
    if isinstance(one.default, str) or one.default is None:
        return said
    from solver.exchange import load_text  # noqa: PLC0415

    return load_text(str(said).encode(), "yaml")


def _checked(said: Mapping[str, object], places: Mapping[str, str]) -> Settings:
    from solver.exchange import read  # noqa: PLC0415

    try:
        return read(Settings, said)
    except FieldError as error:
        name = error.field.partition("[")[0]
        raise WrongSetting(f"{places.get(name, error.field)} {error.problem}; allowed: {error.allowed}") from None
