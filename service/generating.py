"""The call that makes houses: apart from the others, so that a command that makes one loads nothing else."""

import secrets
from collections.abc import Mapping
from dataclasses import replace
from time import perf_counter
from typing import TYPE_CHECKING, Final

from service.effort import limited_to
from solver.answers import Generated
from solver.errors import FieldError
from solver.exchange import read, read_request
from solver.request import MAX_SEED
from solver.scene import Scene

if TYPE_CHECKING:
    from catalogs import Catalogs


def made_house(document: object, catalogs: "Catalogs", engine: str = "osqp") -> Generated:
    """Makes a house (`Request`), furnishes some rooms of one anew (`RerollBody`), or gives it another style (`RestyleBody`).

    Raises:
        FieldError: a field is wrong.
    """
    if _is_restyling(document):
        from service.contract import RestyleBody
        from solver import restyle

        wish = read(RestyleBody, document)
        check_size(wish.scene)
        return restyle(wish.scene, style=wish.style, decorate=wish.decorate, catalogs=catalogs, clock=perf_counter)
    if isinstance(document, Mapping) and not {"scene", "reroll"}.isdisjoint(document):
        from service.contract import RerollBody
        from solver import reroll

        body = read(RerollBody, document)
        check_size(body.scene)
        rooms, seed = tuple(dict.fromkeys(body.reroll)), draw_seed() if body.seed is None else body.seed
        with limited_to(body.effort) as work:
            made = reroll(body.scene, rooms, seed=seed, catalogs=catalogs, clock=perf_counter)
        return replace(made, limited=work.limited())
    from solver import generate

    request = read_request(document, "body")
    seeded = request if request.seed is not None else replace(request, seed=draw_seed())
    with limited_to() as work:
        house = generate(seeded, catalogs=catalogs, engine=engine, clock=perf_counter)
    return replace(house, limited=work.limited())


def _is_restyling(document: object) -> bool:
    named = set(document) if isinstance(document, Mapping) else set()
    return "scene" in named and "reroll" not in named and not named.isdisjoint(("style", "decorate"))


MOST_ROOMS: Final = 2048
"""Rooms of a scene that is furnished or repaired in one call, as many as a plain house has: each takes a millisecond."""


def check_size(scene: Scene) -> None:
    """Lets through a scene that one call can work on.

    Raises:
        FieldError: it has more than MOST_ROOMS rooms.
    """
    if len(scene.rooms) > MOST_ROOMS:
        raise FieldError("scene.rooms", f"are {len(scene.rooms)}", f"at most {MOST_ROOMS} in one call")


def draw_seed() -> int:
    """Draws a seed for a request that has none."""
    return secrets.randbelow(MAX_SEED + 1)
