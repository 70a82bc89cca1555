"""What a dataset is made of: everything that a process needs to make a part of it, and to make one home again.

And how its requests differ: {program: {studio: 1, family: 3}, area: {from: 60, to: 140, step: 5}} says it. Each key draws from a stream of
its own: to add a key changes nothing that others drew.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, fields
from hashlib import sha256
from itertools import accumulate
from pathlib import Path
from typing import Any, Final, NamedTuple

from catalogs import Catalogs, load_catalogs
from service.packed_catalogs import packed, unpacked
from solver import generate
from solver.answers import Issue
from solver.errors import ComposeError, FieldError
from solver.exchange import dump_plain, dump_scene, load_text, read_request, write_request
from solver.plain import Document
from solver.request import NO_ACCESS, Request
from solver.scene import Scene
from solver.streams import Stream
from solver.version import VERSION

SPLITS: Final = {"train": 90, "validation": 5, "test": 5}
"""Parts of a hundred. By the seed's hash alone, so that a home stays in its split however large the set grows."""
JSON: Final = "json"
"""The format that stands for the scenes in the table of houses, beside those of `export`, in archives."""


class Shard(NamedTuple):
    """Homes of consecutive seeds that are made and written together: all from `first` on, `last` included, of part `number`."""

    number: int
    first: int
    last: int

    @property
    def name(self) -> str:
        """What its files are called."""
        return f"{self.number:06}"

    @property
    def seeds(self) -> range:
        """Its homes' seeds."""
        return range(self.first, self.last + 1)


class MadeHome(NamedTuple):
    """A home of a dataset: its request, the name of its catalogs, the scene, issues; or why there is none.

    `text` is the scene as JSON, `digest` its SHA-256.
    """

    request: Request
    catalog: str
    scene: Scene | None
    issues: tuple[Issue, ...]
    text: bytes
    digest: str
    refused: str | None


@dataclass(frozen=True)
class DatasetPlan:
    """What to make.

    Args:
        folder: where.
        requests: what each seed's home is asked to be.
        formats: JSON, and those of `export`.
        shard_size: seeds of a shard.
        catalogs: by name, packed; `fingerprints` go with them.
        fingerprints: of the catalogs.
        vary: the document that `requests` was read from; None where all requests are alike.
    """

    folder: Path
    requests: "VariedRequest"
    formats: tuple[str, ...]
    shard_size: int
    catalogs: Mapping[str, bytes]
    fingerprints: Mapping[str, str]
    vary: Document | None

    @property
    def exported(self) -> tuple[str, ...]:
        """The formats that go into archives."""
        return tuple(name for name in self.formats if name != JSON)

    @property
    def identity(self) -> Document:
        """What all homes of a folder have in common: with anything else no home may be added."""
        return {
            "format": "compose-dataset/1",
            "version": VERSION,
            "catalogs": dict(self.fingerprints),
            "request": {name: value for name, value in self.requests.request.items() if name != "seed"},
            "vary": self.vary,
            "formats": list(self.formats),
            "shard_size": self.shard_size,
            "split_shares": SPLITS,
        }

    def shards(self, first: int, last: int) -> list[Shard]:
        """Returns the shards of a range of seeds; a seed's shard does not depend on the range."""
        size = self.shard_size
        return [Shard(k, max(first, k * size), min(last, (k + 1) * size - 1)) for k in range(first // size, last // size + 1)]

    def home(self, seed: int) -> MadeHome:
        """Makes a seed's home; one that cannot be made says why, and is kept."""
        document, catalog = self.requests.drawn(seed)
        return made_home(document, catalog, unpacked(self.catalogs[catalog]))


def made_home(document: Mapping[str, Any], catalog: str, catalogs: Catalogs) -> MadeHome:
    """Makes a home of a request with its seed."""
    request = read_request(document)
    try:
        made = generate(request, catalogs=catalogs)
    except ComposeError as error:
        return MadeHome(request, catalog, None, (), b"", "", str(error))
    text = dump_scene(made.scene, JSON)
    return MadeHome(request, catalog, made.scene, made.issues, text, sha256(text).hexdigest(), None)


def again(row: Mapping[str, Any], catalogs: Catalogs) -> tuple[Any, str, Catalogs]:
    """Returns what a home is made from again: the request of its row, the name of its catalogs, the catalogs.

    Raises:
        FieldError: the row was made by another version, or from other catalogs.
    """
    name = row["catalog"]
    known = catalogs if name == OURS else load_catalogs(name)
    for what, there, here in (("version", row["version"], VERSION), ("catalog", row["catalog_fingerprint"], known.fingerprint)):
        if there != here:
            raise FieldError("dataset", f"its {what} is {there}, and here is {here}", f"Compose with that {what}")
    return load_text(row["request"], "json"), name, known


def request_text(request: Request) -> str:
    """Returns a request with its seed as one line of JSON."""
    return dump_plain(write_request(request), JSON).decode().strip()


def packed_all(catalogs: Mapping[str, Catalogs]) -> dict[str, bytes]:
    """Packs catalogs for the way to other processes."""
    return {name: packed(one) for name, one in catalogs.items()}


def split_of(seed: int) -> str:
    """Returns the split that a seed's home belongs to."""
    at = Stream(seed, "split").below(sum(SPLITS.values()))
    for name, share in SPLITS.items():
        at -= share
        if at < 0:
            return name
    raise AssertionError


CATALOG: Final = "catalog"
"""The key that chooses among folders of catalogs; its value `ours` is the set's own."""
OURS: Final = "ours"
KEYS: Final = (*(field.name for field in fields(Request) if field.name != "seed"), CATALOG)
RANGE: Final = frozenset({"from", "to", "step"})
_PLAIN: Final[Mapping[Any, Any]] = {"null": None, "true": True, "false": False}
"""What keys of a document, which are texts, stand for as values."""
MOST_STEPS: Final = 100_000
"""Most values of a range; our choice."""


@dataclass(frozen=True)
class WeightedValues:
    """The values that a key may have, and what each weighs."""

    values: tuple[Any, ...]
    weights: tuple[float, ...]

    def drawn(self, seed: int, key: str) -> Any:
        """Returns the value of a seed's home."""
        sums = list(accumulate(self.weights))
        at = Stream(seed, "vary", key).uniform(0.0, sums[-1])
        return self.values[next((k for k, end in enumerate(sums) if at < end), len(sums) - 1)]


@dataclass(frozen=True)
class VariedRequest:
    """A request whose keys are drawn where `choices` names them."""

    request: Mapping[str, Any]
    choices: Mapping[str, WeightedValues]

    def drawn(self, seed: int) -> tuple[dict[str, Any], str]:
        """Returns the request of a seed's home, and the name of its catalogs."""
        found = {key: choice.drawn(seed, key) for key, choice in self.choices.items()}
        catalog = found.pop(CATALOG, OURS)
        return {**self.request, **{key: value for key, value in found.items() if value is not None}, "seed": seed}, catalog

    @property
    def catalogs(self) -> tuple[str, ...]:
        """The names of all catalogs that a home may be furnished with."""
        return tuple(dict.fromkeys((OURS, *self.choices[CATALOG].values))) if CATALOG in self.choices else (OURS,)


def varied(request: Mapping[str, Any], document: object) -> VariedRequest:
    """Reads how requests differ.

    Args:
        request: what all have in common.
        document: by key of a request, or `catalog`: weights by value; or a list of {value, weight}; or a range {from, to, step}.

    Raises:
        FieldError: names the key and what is allowed.
    """
    if not isinstance(document, Mapping):
        raise FieldError("vary", "is not a mapping", "keys of a request, such as {program: {studio: 1, family: 3}}")
    choices = {}
    for key, given in document.items():
        if key not in KEYS:
            raise FieldError(f"vary.{key}", "is no key of a request", ", ".join(KEYS))
        choices[str(key)] = choice = _choice(f"vary.{key}", given)
        for value in choice.values:
            _check(str(key), value, request)
    return VariedRequest(request, choices)


def check_names(requests: VariedRequest, catalogs: Collection[Catalogs]) -> None:
    """Refuses names that none of the catalogs knows: every home that drew one would be refused.

    Raises:
        FieldError: names the key and the names that there are.
    """
    known = {
        "program": {name for one in catalogs for name in one.presets},
        "style": {name for one in catalogs for name in one.styles},
        "access": {NO_ACCESS, *(name for one in catalogs for name in one.access)},
    }
    for key, names in known.items():
        varies = key in requests.choices
        for value in requests.choices[key].values if varies else (requests.request.get(key),):
            if isinstance(value, str) and value not in names:
                raise FieldError(f"vary.{key}" if varies else key, f"{value!r} is in none of the catalogs", ", ".join(sorted(names)))


def _check(key: str, value: Any, request: Mapping[str, Any]) -> None:
    if key != CATALOG:
        try:
            read_request({**request, **({} if value is None else {key: value})})
        except FieldError as error:
            raise FieldError(f"vary.{error.field}", error.problem, error.allowed) from None
    elif not isinstance(value, str):
        raise FieldError(f"vary.{key}", f"is {value!r}", f"{OURS}, or a folder")


def _choice(field: str, given: object) -> WeightedValues:
    if isinstance(given, Mapping) and {"from", "to"} <= given.keys() <= RANGE:
        return _range(field, given)
    if isinstance(given, Mapping):
        pairs = [(_PLAIN.get(value, value), weight) for value, weight in given.items()]
    elif isinstance(given, Sequence) and not isinstance(given, str) and all(isinstance(one, Mapping) and "value" in one for one in given):
        pairs = [(one["value"], one.get("weight", 1)) for one in given]
    else:
        raise FieldError(field, "is neither weights nor a range", "{value: weight, ...}, a list of {value, weight}, or {from, to, step}")
    weights = tuple(_number(f"{field}.{value}", weight) for value, weight in pairs)
    if not weights or min(weights) < 0 or sum(weights) <= 0:
        raise FieldError(field, "has no value that may be drawn", "weights from 0, one above it")
    return WeightedValues(tuple(value for value, _ in pairs), weights)


def _range(field: str, given: Mapping[str, object]) -> WeightedValues:
    low, high, step = (_number(f"{field}.{name}", given.get(name, 1)) for name in ("from", "to", "step"))
    if not (low <= high and step > 0 and (high - low) / step <= MOST_STEPS):
        raise FieldError(field, f"goes from {low:g} to {high:g} by {step:g}", f"from <= to, step above 0, at most {MOST_STEPS} values")
    values = tuple(round(low + k * step, 9) for k in range(int((high - low) / step + 1e-9) + 1))
    return WeightedValues(values, (1.0,) * len(values))


def _number(field: str, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) < 1e12:
        raise FieldError(field, f"is {value!r}", "a number")
    return float(value)
