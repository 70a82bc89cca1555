"""One call from bytes to answer, in a process of its own: what comes in and what goes out can be sent between processes."""

import sys
from collections import Counter
from dataclasses import dataclass
from traceback import format_exc
from typing import Final

from starlette.responses import Response

from catalogs import Catalogs, yaml_reading  # noqa: F401 - loaded before processes are forked
from service import calls, problems
from service.contract import USUAL_READING, ImportQuery
from service.effort import USUAL, Terms, on_terms
from service.measures import ISSUES_HEADER, RETRIED_HEADER, WORK_HEADER
from service.packed_catalogs import KNOWN
from service.wire import FILE, attached, written
from solver.core import CoreFailed, CoreFull
from solver.demanded import demanding_at_most
from solver.errors import ComposeError, TooMuch
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
        reading: how a foreign file is read.
        catalogs: the mark (`mark_of`) of catalogs that the process has packed or unpacked.
        terms: how much work it may do.
    """

    call: str
    body: bytes
    sent: str
    wanted: str
    catalogs: str
    terms: Terms = USUAL
    reading: ImportQuery = USUAL_READING


@dataclass(frozen=True)
class Failure:
    """A fault of ours: its trace, for the log."""

    trace: str


def do(job: Job) -> Response | Failure:
    """Makes a call; what is wrong with the request becomes a problem document."""
    try:
        return _measured(job, KNOWN[job.catalogs])
    except ComposeError as error:
        return problems.of_error(None, error)
    except MemoryError:
        return problems.of_error(None, TooMuch("body", f"takes more than {MEMORY_LIMIT >> 30} GB of memory", TooMuch.SMALLER))
    except Exception:
        return Failure(format_exc())


def _measured(job: Job, catalogs: Catalogs) -> Response:
    """Answers, and says in headers what it took; once more on a fresh instance where the core ended in a trap."""
    with on_terms(job.terms) as bill:
        try:
            answer, retried = _answered(job, catalogs), False
        except CoreFull:
            raise
        except CoreFailed:
            answer, retried = _answered(job, catalogs), True
    answer.headers[WORK_HEADER] = str(round(bill.done))
    if retried:
        answer.headers[RETRIED_HEADER] = "1"
    return answer


def _answered(job: Job, catalogs: Catalogs) -> Response:
    with demanding_at_most(job.terms.judging):
        return _asked(job, catalogs)


def _asked(job: Job, catalogs: Catalogs) -> Response:
    if job.sent in (FILE, GLB) and job.call == "import":
        return written(calls.import_content(job.body, catalogs, job.reading.settings, job.reading.name), job.wanted)
    document = load_text(job.body, job.sent) if job.body.strip() or job.call not in calls.MAY_BE_EMPTY else {}
    if job.sent == GLB:
        document = {"scene": document}
    if job.call == "export" and job.wanted not in FORMATS:
        return attached(calls.export_one(document, catalogs, job.wanted))
    made = calls.CALLS[job.call](document, catalogs)
    answer = written(made, job.wanted)
    if found := Counter(issue["severity"] for issue in made.get("issues", ())):
        answer.headers[ISSUES_HEADER] = ",".join(f"{severity}={number}" for severity, number in sorted(found.items()))
    return answer


def do_alone(job: Job) -> Response | Failure:
    """Makes a call in a process that does nothing else, with bounded memory."""
    if sys.platform != "win32":
        _, most = resource.getrlimit(resource.RLIMIT_DATA)
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY_LIMIT, most))  # not RLIMIT_AS: the core reserves addresses that it never uses
    return do(job)
