"""One call from bytes to answer, in a process of its own: what comes in and what goes out can be sent between processes."""

from __future__ import annotations

import gc
import pickle
import sys
from dataclasses import dataclass
from functools import lru_cache
from hashlib import sha256
from traceback import format_exc
from typing import Final, cast

from starlette.responses import Response

from catalogs import Catalogs
from service import calls, problems
from service.refusals import TooMuch
from service.wire import FILE, attached, written
from solver.core import load_core
from solver.errors import ComposeError
from solver.exchange import FORMATS, GLB, load_text

if sys.platform != "win32":
    import resource

MEMORY_LIMIT: Final = 2 << 30
"""Memory that a worker may write to, bytes; the core only reserves address space beyond that. A house takes less than a tenth of it."""


@dataclass(frozen=True)
class Job:
    """A call to be made.

    Args:
        call: one of `calls.CALLS`.
        body: the request's body.
        sent: the body's format.
        wanted: the answer's format.
        catalogs: the catalogs, packed by `packed`; or their mark (`mark_of`), where the process may know them.
    """

    call: str
    body: bytes
    sent: str
    wanted: str
    catalogs: bytes | str


@dataclass(frozen=True)
class UnknownCatalogs:
    """The process does not know the catalogs of that mark: the job has to be sent again with them."""


@dataclass(frozen=True)
class Failure:
    """A fault of ours: its trace, for the log."""

    trace: str


def packed(catalogs: Catalogs) -> bytes:
    """Packs catalogs for the way to a worker."""
    return pickle.dumps(catalogs, pickle.HIGHEST_PROTOCOL)


_known: Final[dict[str, Catalogs]] = {}
"""The last catalogs that were sent to this process, by their mark."""


def mark_of(catalogs: bytes) -> str:
    """Returns a mark of packed catalogs: it is sent in their place, as they are large beside a request."""
    return sha256(catalogs).hexdigest()


@lru_cache(maxsize=1)
def unpacked(catalogs: bytes) -> Catalogs:
    """Unpacks catalogs; those of the last call are kept."""
    found = cast(Catalogs, pickle.loads(catalogs))
    _known.clear()
    _known[mark_of(catalogs)] = found
    return found


def do(job: Job) -> Response | Failure | UnknownCatalogs:
    """Makes a call; what is wrong with the request becomes a problem document."""
    if isinstance(job.catalogs, str) and job.catalogs not in _known:
        return UnknownCatalogs()
    catalogs = _known[job.catalogs] if isinstance(job.catalogs, str) else unpacked(job.catalogs)
    try:
        if job.sent in (FILE, GLB) and job.call == "import":
            return written(calls.import_content(job.body, catalogs), job.wanted)
        document = load_text(job.body, job.sent) if job.body.strip() or job.call not in calls.MAY_BE_EMPTY else {}
        if job.sent == GLB:
            document = {"scene": document}
        if job.call == "export" and job.wanted not in FORMATS:
            return attached(calls.export_one(document, catalogs, job.wanted))
        return written(calls.CALLS[job.call](document, catalogs), job.wanted)
    except ComposeError as error:
        return problems.of_error(None, error)
    except MemoryError:
        return problems.of_error(None, TooMuch("body", f"takes more than {MEMORY_LIMIT >> 30} GB of memory", TooMuch.SMALLER))
    except Exception:
        return Failure(format_exc())


def do_alone(job: Job) -> Response | Failure | UnknownCatalogs:
    """Makes a call in a process that does nothing else, with bounded memory."""
    if sys.platform != "win32":
        _, most = resource.getrlimit(resource.RLIMIT_DATA)
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY_LIMIT, most))  # not RLIMIT_AS: the core reserves addresses that it never uses
    return do(job)


def warm(catalogs: bytes) -> None:
    """Does nothing but load what calls need; the collector of cycles leaves that alone from then on."""
    unpacked(catalogs)
    load_core()
    gc.collect()
    gc.freeze()
