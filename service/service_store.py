"""The store of one service: opened when it is first needed, or at the start, where whoever runs it hears what is wrong.

And what the calls about homes and jobs share: threads that wait for it, ids and numbers in paths, the refusals of all of them.
"""

import os
import re
from collections.abc import Callable, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Lock
from typing import TYPE_CHECKING, Annotated, Any, Final

from annotated_types import Ge, Le, MaxLen, MinLen
from anyio import CapacityLimiter, to_thread
from starlette.requests import Request

from service.admission import owner_of
from service.openapi import refusals
from service.problems import NoSuchThing, StoreAway
from service.service_settings import Settings
from solver.fields import Matching, Says

if TYPE_CHECKING:
    from service.store.database import Database
    from service.store.saved_homes import SavedHomes
    from service.store.saved_jobs import SavedJobs


NONE: Final = "none"
TEMPORARY: Final = "temporary"
FILE_NAME: Final = "homes.sqlite"


class ServiceStore:
    """The store that the settings name: a file, a URL, NONE, or TEMPORARY for one that goes with the service; not yet opened."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._lock = Lock()
        self._folder: TemporaryDirectory[str] | None = None
        self._database: Database | None = None
        self._homes: SavedHomes | None = None

    def open(self) -> "SavedHomes":
        """Opens the store where it is not yet open, and returns what asks it for homes.

        Raises:
            StoreAway: it does not answer, or there is none.
            NoRoom: its disk is full.
            FieldError: its place cannot be one.
        """
        with self._lock:
            if self._homes is None:
                self._homes = self._opened()
            return self._homes

    @property
    def is_temporary(self) -> bool:
        """Whether it goes with the service, so that nobody else has it."""
        return self._settings.store == TEMPORARY

    def jobs(self) -> "SavedJobs":
        """Opens the store where it is not yet open, and returns what asks it for jobs. Raises as `open`."""
        from service.store.saved_jobs import SavedJobs  # noqa: PLC0415

        self.open()
        if self._database is None:
            raise StoreAway("store", "is closed", "another try in a moment")
        return SavedJobs(self._database)

    def _opened(self) -> "SavedHomes":
        from service.store.database import Database  # noqa: PLC0415 - who keeps nothing loads no database
        from service.store.saved_homes import Keeping, SavedHomes  # noqa: PLC0415

        place = self._settings.store or str(default_place(os.environ))
        if place == NONE:
            raise StoreAway("store", "is not there: this service keeps no homes", "a service that keeps homes (compose serve --store)")
        if place == TEMPORARY:
            self._folder = TemporaryDirectory(prefix="compose-")
            place = str(Path(self._folder.name) / FILE_NAME)
        self._database = Database(place)
        return SavedHomes(self._database, Keeping(self._settings.homes_each, self._settings.megabytes_each * 1_000_000))

    def close(self) -> None:
        """Closes the store; it is opened anew when it is needed again."""
        with self._lock:
            if self._database is not None:
                self._database.close()
            if self._folder is not None:
                self._folder.cleanup()
            self._database = self._homes = self._folder = None


def default_place(environment: Mapping[str, str]) -> Path:
    """Returns the file that homes are kept in where no other place is named: in the user's folder for data."""
    return Path(environment.get("XDG_DATA_HOME") or "~/.local/share").expanduser() / "compose-homes" / FILE_NAME


THREADS: Final = 8
"""How many calls wait for the store at once. Our choice: a call takes it a millisecond."""
ID: Final = re.compile(r"[\w-]{1,40}")
NUMBER: Final = re.compile(r"[0-9]{1,9}")
REFUSALS: Final = refusals(401, 403, 405, 421, 422, 429, 500, 503, 504, 507)
WITH_BODY: Final = refusals(400, 408, 409, 413, 415)


def store_limiter() -> CapacityLimiter:
    """Returns what bounds the calls that wait for the store."""
    return CapacityLimiter(THREADS)


async def ask(of: Callable[[ServiceStore], Any], request: Request, question: Callable[..., Any]) -> Any:
    """Asks a part of the store (`of`) something in a thread, for the owner of the request's key."""

    def answer() -> Any:
        return question(of(request.app.store), owner_of(request.scope))

    return await to_thread.run_sync(answer, limiter=request.app.store_threads)


def id_type(of: str) -> Any:
    """Returns the type of an id in a path, of a "home", say."""
    return Annotated[str, MinLen(1), MaxLen(40), Matching(r"^[A-Za-z0-9_-]+$"), Says(_id_of(of))]


def _id_of(of: str) -> str:
    return "the id of a home of yours" if of == "home" else "the id of a job of yours"


def number_type(least: int) -> Any:
    """Returns the type of a number in a path."""
    return Annotated[int, Ge(least), Le(999_999_999)]


def id_in(request: Request, of: str) -> str:
    """Returns the id in a request's path.

    Raises:
        NoSuchThing: it can be none.
    """
    found: str = request.path_params[of]
    if not ID.fullmatch(found):
        raise NoSuchThing(of, f"there is no {found!r:.40}", _id_of(of))
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
