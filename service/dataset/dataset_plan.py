"""What a dataset is made of: everything that a process needs to make a part of it, and to make one home again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any, Final, NamedTuple

from catalogs import Catalogs, load_catalogs
from service.dataset.varied_requests import OURS, VariedRequest
from service.packed_catalogs import packed, unpacked
from solver import generate
from solver.answers import Issue
from solver.errors import ComposeError, FieldError
from solver.exchange import FORMATS, dump_scene, load_text, read_request, write_request
from solver.plain import Document
from solver.request import Request
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
    requests: VariedRequest
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
    return FORMATS[JSON].dump(write_request(request)).strip()


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
