"""The calls about long work; and the runner, which makes the calls of one job after another in the workers.

What was done is kept call by call: a job goes on where it was ended.
"""

import json
import logging
import secrets
import zlib
from collections.abc import AsyncIterator, Callable
from functools import partial
from typing import Any, Final

import anyio
from anyio import to_thread
from starlette.requests import Request
from starlette.responses import Response, StreamingResponse

from service import problems
from service.kept_contract import DONE, LEASE_S, JobBody, JobHead, JobList, JobResult
from service.openapi import DescribedCalls, refusals
from service.problems import Busy, NoSuchThing, StoreAway
from service.service_store import REFUSALS, WITH_BODY, ServiceStore, ask, id_in, id_type, number_in, number_type
from service.wire import body_of, format_sent, format_wanted, written
from solver.errors import ComposeError
from solver.exchange import load_text, read, write

POLL_S: Final = 0.5
"""How often a job is looked at while somebody listens, s."""
IDLE_S: Final = 5.0
"""How often a runner without work looks for some of other services', s."""
SILENCE_S: Final = 15.0
"""How long a stream of events is silent, s: what lies between would close it."""
_log = logging.getLogger("compose.service")


def asked_of(body: bytes, sent: str) -> tuple[str, bytes, int]:
    """Reads a job's body: its call, the bodies of its calls packed, and how many they are.

    Raises:
        FieldError: a field is wrong.
        SyntaxFault: it is no document.
    """
    found = read(JobBody, load_text(body, sent))
    bodies = [dict(found.body)] if found.seeds is None else [{**found.body, "seed": seed} for seed in dict.fromkeys(found.seeds)]
    return found.call, zlib.compress(json.dumps(bodies).encode()), len(bodies)


_of_store = partial(ask, ServiceStore.jobs)

EVENTS: Final[dict[int | str, dict[str, Any]]] = {200: {"content": {"text/event-stream": {"schema": {"type": "string"}}}}}
RESULT: Final[dict[int | str, dict[str, Any]]] = {200: {"content": {"application/json": {}}}}
jobs = DescribedCalls("/jobs", responses=REFUSALS)
OF_JOB: Final = {"job": id_type("job")}
OF_RESULT: Final = {**OF_JOB, "number": number_type(0)}


@jobs.call("POST", "", JobHead, takes={"body": JobBody}, status_code=202, responses=WITH_BODY)
async def add_job(request: Request) -> Response:
    """Takes on long work: a call, or a call of many seeds; answers at once where it is to be found."""
    body, sent = await body_of(request, request.app.settings.body_seconds), format_sent(request)
    call, asked, count = await to_thread.run_sync(asked_of, body, sent, limiter=request.app.store_threads)
    job = await _of_store(request, lambda kept, owner: kept.add(owner, call, asked, count))
    request.app.runner.wake()
    answer = written(write(job), format_wanted(request))
    answer.status_code = 202
    answer.headers["Location"] = f"{request.scope.get('root_path', '')}/jobs/{job.id}"
    return answer


@jobs.call("GET", "", JobList)
async def list_jobs(request: Request) -> Response:
    """Lists jobs, the newest first."""
    found = await _of_store(request, lambda kept, owner: kept.list(owner))
    return written({"jobs": [write(job) for job in found]}, format_wanted(request))


@jobs.call("GET", "/{job}", JobHead, takes=OF_JOB, responses=refusals(404))
async def read_job(request: Request) -> Response:
    """Says how far a job is."""
    return written(write(await _of_store(request, lambda kept, owner: kept.get(owner, id_in(request, "job")))), format_wanted(request))


@jobs.call("DELETE", "/{job}", takes=OF_JOB, status_code=204, responses=refusals(404))
async def remove_job(request: Request) -> Response:
    """Ends a job and removes it with its results."""
    await _of_store(request, lambda kept, owner: kept.remove(owner, id_in(request, "job")))
    return Response(status_code=204)


@jobs.call("GET", "/{job}/results/{number}", takes=OF_RESULT, response_class=Response, responses=refusals(404) | RESULT)
async def read_result(request: Request) -> Response:
    """Returns what one of a job's calls was answered by; `X-Call-Status` is its status."""
    id_of, number = id_in(request, "job"), number_in(request, "result", "the number of a call that has been made, from 0")
    found: JobResult = await _of_store(request, lambda kept, owner: kept.result(owner, id_of, number))
    headers = {"X-Call-Status": str(found.status), "Cache-Control": "private, no-cache"}
    return Response(zlib.decompress(found.content), media_type=found.media_type, headers=headers)


@jobs.call("GET", "/{job}/events", takes=OF_JOB, response_class=Response, responses=refusals(404) | EVENTS)
async def job_events(request: Request) -> Response:
    """Says how far a job is, each time that changes, as server-sent events, until it is done."""
    id_of = id_in(request, "job")
    first = await _of_store(request, lambda kept, owner: kept.get(owner, id_of))

    async def events() -> AsyncIterator[bytes]:
        job, told, silent = first, None, 0.0
        while True:
            if job != told:
                told, silent = job, 0.0
                event = "done" if job.state == DONE else "progress"
                yield f"event: {event}\ndata: {json.dumps(write(job))}\nid: {job.done}\n\n".encode()
            if job.state == DONE:
                return
            with anyio.move_on_after(POLL_S):
                await request.app.stopping.wait()
                return  # who listens would keep the stop waiting; they ask again
            silent += POLL_S
            if silent >= SILENCE_S:
                silent = 0.0
                yield b": still there\n\n"
            try:
                job = await _of_store(request, lambda kept, owner: kept.get(owner, id_of))
            except NoSuchThing:
                yield b"event: removed\ndata: {}\n\n"
                return
            except StoreAway:
                continue

    headers = {"Cache-Control": "no-cache", "X-Accel-Buffering": "no"}
    return StreamingResponse(events(), headers=headers, media_type="text/event-stream")


class Runner:
    """Makes the calls of jobs, one after another; what interactive calls need is left to them, since it takes one process at most."""

    def __init__(self, app: Any) -> None:
        self._app = app
        self._name = secrets.token_hex(8)
        self._woken = anyio.Event()

    def wake(self) -> None:
        """Says that there is work."""
        self._woken.set()

    async def run(self, is_first_asked: bool) -> None:
        """Runs until it is cancelled; `is_first_asked`: waits for the first job asked for here, since nobody else has the store."""
        while True:
            if not is_first_asked:
                await self._work_off()
            is_first_asked = False
            with anyio.move_on_after(IDLE_S if not self._app.store.is_temporary else None):
                await self._woken.wait()
            self._woken = anyio.Event()

    async def _work_off(self) -> None:
        try:
            while (taken := await self._in_thread(lambda kept: kept.take(self._name))) is not None:
                await self._make(*taken)
        except ComposeError as error:
            _log.info("jobs wait: %s", error)
        except Exception:
            _log.exception("a job failed")

    async def _make(self, job: JobHead, asked: bytes) -> None:
        bodies = json.loads(zlib.decompress(asked))
        async with anyio.create_task_group() as group:
            group.start_soon(self._live, job.id, group.cancel_scope)
            for number in range(job.done, job.count):
                result = await self._result(job.call, json.dumps(bodies[number]).encode())
                if not await self._in_thread(lambda kept, at=number, made=result: kept.put(self._name, job.id, at, made)):
                    break
            else:
                await self._in_thread(lambda kept: kept.finish(self._name, job.id))
            group.cancel_scope.cancel()

    async def _live(self, job: str, scope: anyio.CancelScope) -> None:
        """Says that the runner lives; ends the job where it was removed or is another's."""
        while await self._in_thread(lambda kept: kept.beat(self._name, job)):
            await anyio.sleep(min(LEASE_S / 10, 2.0))
        scope.cancel()

    async def _result(self, call: str, body: bytes) -> JobResult:
        while True:
            try:
                answer = await self._app.make(call, body, "json", "json")
            except Busy:
                await anyio.sleep(POLL_S)
                continue
            except ComposeError as error:
                answer = problems.of_error(None, error)
            except RuntimeError:
                _log.exception("a call of a job failed")
                answer = problems.unexpected()
            return JobResult(answer.status_code, str(answer.media_type), zlib.compress(bytes(answer.body)))

    async def _in_thread(self, question: Callable[..., Any]) -> Any:
        return await to_thread.run_sync(lambda: question(self._app.store.jobs()), limiter=self._app.store_threads)
