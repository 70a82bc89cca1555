"""What the calls about homes and jobs share: threads that wait for the store, ids and numbers in paths, the refusals of all of them."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Annotated, Any, Final

from anyio import CapacityLimiter, to_thread
from fastapi import Path
from starlette.requests import Request

from service.admission import owner_of
from service.openapi import refusals
from service.refusals import NoSuchThing
from service.service_store import ServiceStore

THREADS: Final = 8
"""How many calls wait for the store at once. Our choice: a call takes it a millisecond."""
ID: Final = re.compile(r"[\w-]{1,40}")
NUMBER: Final = re.compile(r"[0-9]{1,9}")
REFUSALS: Final = refusals(401, 403, 405, 421, 422, 429, 500, 503, 504, 507)
WITH_BODY: Final = refusals(400, 408, 409, 413, 415)


def store_limiter() -> CapacityLimiter:
    """Returns what bounds the calls that wait for the store."""
    return CapacityLimiter(THREADS)


async def ask(of: Callable[[ServiceStore], Any], request: Request, question: Callable[[Any, str], Any]) -> Any:
    """Asks a part of the store (`of`) something in a thread, for the owner of the request's key."""

    def answer() -> Any:
        return question(of(request.app.store), owner_of(request.scope))

    return await to_thread.run_sync(answer, limiter=request.app.store_threads)


def id_type(of: str) -> Any:
    """Returns the type of an id in a path, of a "home", say."""
    return Annotated[str, Path(min_length=1, max_length=40, pattern=r"^[A-Za-z0-9_-]+$", description=f"of a {of} of yours")]


def number_type(least: int) -> Any:
    """Returns the type of a number in a path."""
    return Annotated[int, Path(ge=least, le=999_999_999)]


def id_in(request: Request, of: str) -> str:
    """Returns the id in a request's path.

    Raises:
        NoSuchThing: it can be none.
    """
    found: str = request.path_params[of]
    if not ID.fullmatch(found):
        raise NoSuchThing(of, f"there is no {found!r:.40}", "the id of a home of yours" if of == "home" else "the id of a job of yours")
    return found


def number_in(request: Request, of: str, allowed: str) -> int:
    """Returns the number in a request's path.

    Raises:
        NoSuchThing: it is none.
    """
    found: str = request.path_params["number"]
    if not NUMBER.fullmatch(found):
        raise NoSuchThing(of, f"{found!r:.40} is no number", allowed)
    return int(found)
