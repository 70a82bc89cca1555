"""Long work in a store: asked for, taken by a runner, carried on after a crash, and its results."""

import secrets
import time
from collections.abc import Callable
from typing import Any, Final

from sqlalchemy import Connection, Row, and_, delete, func, insert, or_, select, update

from service.kept_contract import DONE, LEASE_S, RUNNING, WAITING, JobHead, JobResult, moment
from service.problems import NoSuchThing, TooManyKept
from service.store.database import JOBS, RESULTS, Database

MOST_JOBS: Final = 20
"""Jobs that an owner may have, those that are done included. Our choice."""
TOLD: Final = tuple(JOBS.c[name] for name in ("id", "call", "state", "count", "done", "refused", "created", "changed"))


class SavedJobs:
    """The jobs of a store. After `lease_s` without a word of its runner a job is carried on by another.

    The clock counts nanoseconds since 1970, UTC.
    """

    def __init__(self, database: Database, lease_s: float = LEASE_S, clock: Callable[[], int] = time.time_ns) -> None:
        self._database, self._lease, self._clock = database, round(lease_s * 1e6), clock

    def add(self, owner: str, call: str, asked: bytes, count: int) -> JobHead:
        """Keeps a job that waits.

        Raises:
            TooManyKept: the owner has as many as may be.
        """
        now = self._clock() // 1000
        row = {
            "id": secrets.token_urlsafe(12), "owner": owner, "call": call, "asked": asked, "state": WAITING, "count": count, "done": 0,
            "refused": 0, "created": now, "changed": now, "beat": 0, "runner": "",
        }  # fmt: skip
        with self._database.writing() as connection:
            if (connection.scalar(select(func.count()).select_from(JOBS).where(JOBS.c.owner == owner)) or 0) >= MOST_JOBS:
                raise TooManyKept("jobs", "are as many as may be kept", f"{MOST_JOBS}; remove one first")
            connection.execute(insert(JOBS), row)
            return _found_job(connection, owner, str(row["id"]))

    def get(self, owner: str, job: str) -> JobHead:
        """Returns a job.

        Raises:
            NoSuchThing: this owner has no such job.
        """
        with self._database.reading() as connection:
            return _found_job(connection, owner, job)

    def list(self, owner: str) -> list[JobHead]:
        """Returns an owner's jobs, the newest first."""
        with self._database.reading() as connection:
            rows = connection.execute(select(*TOLD).where(JOBS.c.owner == owner).order_by(JOBS.c.created.desc(), JOBS.c.id))
            return [_job(row) for row in rows]

    def remove(self, owner: str, job: str) -> None:
        """Removes a job with its results; its runner ends it.

        Raises:
            NoSuchThing: this owner has no such job.
        """
        with self._database.writing() as connection:
            _found_job(connection, owner, job)
            connection.execute(delete(JOBS).where(JOBS.c.id == job))

    def result(self, owner: str, job: str, number: int) -> JobResult:
        """Returns what came of one of a job's calls.

        Raises:
            NoSuchThing: this owner has no such job, or the call has not been made.
        """
        with self._database.reading() as connection:
            _found_job(connection, owner, job)
            asked = select(RESULTS.c.status, RESULTS.c.media_type, RESULTS.c.content)
            row = connection.execute(asked.where(RESULTS.c.job == job, RESULTS.c.number == number)).first()
        if row is None:
            raise NoSuchThing("result", f"{number} is not there", "the number of a call that has been made, from 0")
        return JobResult(*row)

    def take(self, runner: str) -> tuple[JobHead, bytes] | None:
        """Takes the job that has waited longest, or whose runner is silent; returns it with what is asked, or None."""
        now = self._clock() // 1000
        # A word from the future was said before the clock was put back: a runner that lives says another one within the lease.
        is_silent = or_(JOBS.c.beat < now - self._lease, JOBS.c.beat > now + self._lease)
        is_free = or_(JOBS.c.state == WAITING, and_(JOBS.c.state == RUNNING, is_silent))
        with self._database.writing() as connection:
            found = select(JOBS.c.asked, *TOLD).where(is_free).order_by(JOBS.c.created, JOBS.c.id).limit(1)
            row = connection.execute(found.with_for_update(skip_locked=True)).first()
            if row is None:
                return None
            connection.execute(update(JOBS).where(JOBS.c.id == row.id).values(state=RUNNING, runner=runner, beat=now, changed=now))
            return _job(row), row.asked

    def beat(self, runner: str, job: str) -> bool:
        """Says that a runner lives; returns whether the job is still its own."""
        with self._database.writing() as connection:
            return self._held(connection, runner, job, {})

    def put(self, runner: str, job: str, number: int, result: JobResult) -> bool:
        """Keeps what came of a call, and that it is done, at once; returns whether the job is still the runner's own."""
        more = {"done": number + 1, "refused": JOBS.c.refused + int(result.status >= 400), "changed": self._clock() // 1000}
        with self._database.writing() as connection:
            if not self._held(connection, runner, job, more):
                return False
            row = {"job": job, "number": number, "status": result.status, "media_type": result.media_type, "content": result.content}
            connection.execute(insert(RESULTS), row)
            return True

    def finish(self, runner: str, job: str) -> None:
        """Says that all calls of a job have been made."""
        with self._database.writing() as connection:
            self._held(connection, runner, job, {"state": DONE, "changed": self._clock() // 1000})

    def _held(self, connection: Connection, runner: str, job: str, more: dict[str, Any]) -> bool:
        is_own = and_(JOBS.c.id == job, JOBS.c.runner == runner, JOBS.c.state == RUNNING)
        return connection.execute(update(JOBS).where(is_own).values(beat=self._clock() // 1000, **more)).rowcount == 1


def _job(row: Row[Any]) -> JobHead:
    told = {column.name: row._mapping[column] for column in TOLD}
    return JobHead(**told | {name: moment(told[name]) for name in ("created", "changed")})


def _found_job(connection: Connection, owner: str, job: str) -> JobHead:
    row = connection.execute(select(*TOLD).where(JOBS.c.id == job, JOBS.c.owner == owner)).first()
    if row is None:
        raise NoSuchThing("job", f"there is no {job!r:.40}", "the id of a job of yours")
    return _job(row)
