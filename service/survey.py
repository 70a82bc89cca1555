"""Statistics over many houses: makes them in some processes and hands their figures on, in the order of the seeds."""

from __future__ import annotations

import multiprocessing
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from typing import Any, Final

from tqdm import tqdm

from catalogs import Catalogs
from service.documents import Document
from service.work import packed, unpacked
from solver.errors import FieldError, RequestError
from solver.exchange import read_request
from solver.pipeline.survey import survey
from solver.scene import MAX_SEED, Request
from solver.statistics import House, summary
from solver.validate import RULES

BATCH: Final = 4
"""Houses that a process is given at a time: enough that handing them over costs nothing, few enough for a smooth bar."""
_CATALOGS: dict[str, Catalogs] = {}
"""What a process of ours furnishes with."""


@dataclass(frozen=True)
class Refusal:
    """What is wrong with a request, in a form that can be sent between processes."""

    field: str
    problem: str
    allowed: str


def statistics(requests: Sequence[Mapping[str, Any]], count: int, workers: int, catalogs: Catalogs) -> Document:
    """Makes sets of houses and returns what they show; the number of processes changes nothing in it.

    Args:
        requests: one a set; `seed` is that of the first house (0), the others follow.
        count: houses of each set.
        workers: processes; with one all is done in this one.
        catalogs: what to furnish with.

    Raises:
        FieldError: a request is wrong, or no house can meet it.
    """
    read = [read_request(request) for request in requests]
    jobs = [replace(one, seed=((one.seed or 0) + k) % (MAX_SEED + 1)) for one in read for k in range(count)]
    houses = list(_told(_made(jobs, workers, catalogs), len(jobs)))
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


def _told(found: Iterable[House | Refusal], total: int) -> Iterator[House]:
    """Shows how far it is; a refusal becomes the error again."""
    for one in tqdm(found, total=total, unit="house", disable=None):
        if isinstance(one, Refusal):
            raise RequestError(one.field, one.problem, one.allowed)
        yield one


def _made(jobs: Sequence[Request], workers: int, catalogs: Catalogs) -> Iterator[House | Refusal]:
    if min(workers, len(jobs)) == 1:
        yield from (_house(job, catalogs) for job in jobs)
        return
    # Processes start empty: one that is a copy of this one would share whatever its threads hold.
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(workers, context, initializer=_furnish_with, initargs=(packed(catalogs),))
    try:
        yield from pool.map(_house_here, jobs, chunksize=BATCH)
    finally:
        pool.shutdown(cancel_futures=True)


def _furnish_with(catalogs: bytes) -> None:
    """Prepares a process."""
    _CATALOGS["here"] = unpacked(catalogs)


def _house_here(request: Request) -> House | Refusal:
    return _house(request, _CATALOGS["here"])


def _house(request: Request, catalogs: Catalogs) -> House | Refusal:
    try:
        return survey(request, catalogs)
    except FieldError as error:
        return Refusal(error.field, error.problem, error.allowed)
