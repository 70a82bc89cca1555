"""A survey: many houses made in some processes, and the statistics of what they show, in the order of the seeds."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from catalogs import Catalogs
from service.many import in_processes
from service.packed_catalogs import unpacked
from solver import generate
from solver.exchange import read_request
from solver.plain import Document
from solver.request import MAX_SEED, Request
from solver.statistics import House, house_of, summary
from solver.validator import RULES, metrics


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
