"""Many houses, of successive seeds, made in some processes: the number of processes changes neither their order nor a byte.

A folder holds a file a house, each whole or not there, and `made_from.json`, which says what they were made from; so the same command goes
on where it was ended. A survey keeps none of them: it says what they show.
"""

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import tee
from pathlib import Path
from typing import Any, Final, TypeVar

from catalogs import Catalogs
from service.generating import made_house
from service.packed_catalogs import packed, unpacked, warm
from service.pool import spread
from service.progress import progress
from solver import generate
from solver.errors import ComposeError, FieldError
from solver.exchange import dump_scene, read_request, write
from solver.plain import Document
from solver.request import MAX_SEED, Request
from solver.statistics import House, house_of, summary
from solver.validator import RULES, metrics
from solver.version import VERSION
from solver.whole_files import write_whole

Asked = TypeVar("Asked")
Made = TypeVar("Made")

BATCH: Final = 4
"""Houses that a process is given at a time: enough that handing them over costs nothing, few enough for a smooth bar."""
MADE_FROM: Final = "made_from.json"
"""The file of a folder that says what its houses were made from."""


@dataclass(frozen=True)
class HouseSet:
    """A folder of houses that differ by their seeds alone, one file a seed; made where there is none.

    `request` is that of every house, its own seed does not count; `format` is yaml or json, `engine` that of the final QP.
    """

    request: Mapping[str, Any]
    folder: Path
    format: str
    engine: str

    def file(self, seed: int) -> Path:
        """Returns the file of a seed's house."""
        return self.folder / f"{seed}.{self.format}"

    def made_from(self, catalogs: Catalogs) -> bytes:
        """Returns what the folder says of its houses."""
        shown = {name: value for name, value in self.request.items() if name != "seed"}
        said = {"version": VERSION, "catalog": catalogs.fingerprint, "engine": self.engine, "request": shown}
        return (json.dumps(said, indent=2, sort_keys=True) + "\n").encode()


def in_processes(
    make: Callable[[bytes, Asked], Made], jobs: Iterable[Asked], count: int, workers: int, catalogs: Catalogs
) -> Iterator[Made]:
    """Yields what a function of a module makes of the packed catalogs and each job, in their order, and says how far it is.

    Jobs, `count` at most, are taken as they are needed, so that there may be any number of them. With one worker all is done in this
    process.
    """
    known = packed(catalogs)
    with progress(count, "house") as update:
        for made in spread(partial(make, known), jobs, min(workers, count), partial(warm, known), BATCH):
            update(1)
            yield made


def into_folder(houses: HouseSet, seeds: range, catalogs: Catalogs, workers: int) -> Iterator[tuple[int, list[Document]]]:
    """Makes houses into their folder and yields each seed with its house's issues; files that are there stay.

    After the greatest seed comes 0.

    Raises:
        FieldError: a request is wrong, no house can meet it, or the folder's houses were made from something else.
    """
    _claim(houses.folder, houses.made_from(catalogs))
    todo, asked = tee(seed for seed in (seed % (MAX_SEED + 1) for seed in seeds) if not houses.file(seed).exists())
    for seed, made in zip(todo, in_processes(partial(_file_made, houses), asked, len(seeds), workers, catalogs), strict=True):
        if isinstance(made, ComposeError):
            raise made
        yield seed, made


def _claim(folder: Path, made_from: bytes) -> None:
    """Says in a folder what its houses are made from; refuses one with houses that were made from something else."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / MADE_FROM
    if path.exists() and path.read_bytes() == made_from:
        return
    if path.exists() and any(other.stem.isdecimal() for other in folder.iterdir()):
        raise FieldError("--output", f"{folder} holds houses of another version, catalog or request", f"what {path} says, or a new folder")
    write_whole(path, made_from)


def _file_made(houses: HouseSet, catalogs: bytes, seed: int) -> list[Document] | ComposeError:
    """Makes a house and writes it; returns its issues."""
    try:
        made = made_house({**houses.request, "seed": seed}, unpacked(catalogs), houses.engine)
    except ComposeError as error:
        return error
    write_whole(houses.file(seed), dump_scene(made.scene, houses.format))
    return [write(issue) for issue in made.issues]


def survey(requests: Sequence[Mapping[str, Any]], count: int, workers: int, catalogs: Catalogs) -> Document:
    """Makes sets of `count` houses and returns what they show; the number of processes changes nothing in it.

    A request's `seed` is that of the first house of its set (0), the others follow.

    Raises:
        FieldError: a request is wrong, or no house can meet it.
    """
    read = [read_request(request) for request in requests]
    jobs = (replace(one, seed=((one.seed or 0) + k) % (MAX_SEED + 1)) for one in read for k in range(count))
    houses = list(in_processes(_house, jobs, len(read) * count, workers, catalogs))
    sets = []
    for k, request in enumerate(requests):
        shown = {name: value for name, value in request.items() if name != "seed"}
        found = summary(houses[k * count : (k + 1) * count], RULES)
        sets.append({"name": _name(read[k]), "request": shown, "first_seed": read[k].seed or 0, **found})
    return {"catalog": catalogs.fingerprint, "sets": sets}


def _name(request: Request) -> str:
    """Says in a few words what a set's houses were asked to be."""
    words = [f"{request.area:g} m2"] if request.area is not None else []
    if isinstance(request.program, str):
        return ", ".join([request.program, *words])
    words = [f"{number} {word}" for word, number in (request.program or {}).items()] + words
    return ", ".join(words) if request.planned else "{:g} x {:g} m".format(*request.extents)


def _house(catalogs: bytes, request: Request) -> House:
    """Makes a house and returns what it shows."""
    known = unpacked(catalogs)
    made = generate(request, catalogs=known)
    return house_of(made.scene, made.issues, metrics(made.scene, known))
