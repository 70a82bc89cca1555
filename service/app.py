"""The HTTP service: every call that a worker makes (`calls`), those about what is kept (`homes`, `jobs`), and the page.

What a call takes and answers is declared here, for the document that FastAPI makes; a worker reads the body, and does it.
"""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from copy import deepcopy
from hashlib import sha256
from typing import Annotated, Any, Final

from anyio import Event, create_task_group
from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.middleware.cors import CORSMiddleware
from starlette.requests import Request
from starlette.responses import Response

from catalogs import Catalogs, load_catalogs
from service import calls, page, problems
from service.admission import FOR_OTHER_PAGES, Admission, Admitted
from service.admitting import admitted_of
from service.connections import Connections
from service.contract import USUAL_READING, ImportQuery
from service.docs import docs
from service.effort import Terms
from service.guard import ANY, Callers, Guard
from service.homes import homes
from service.jobs import Runner, jobs
from service.measures import Measures, Observed, metrics
from service.openapi import Answering, DescribedCalls, completed, query_of, query_types, refusals
from service.packed_catalogs import mark_of, packed, warm
from service.problems import Busy, NoSuchFormat
from service.service_settings import Settings
from service.service_store import NONE, TEMPORARY, ServiceStore, store_limiter
from service.wire import FILE, NOT_CHANGED, as_written, body_of, format_sent, format_wanted, is_known, not_changed, tagged, written
from service.work import Failure, Job, do_alone
from service.workers import Workers, unless_left
from solver.exchange import dump_plain, read
from solver.fields import OneOf

EMBEDDED: Final = Settings(allow_host=(ANY,), store=TEMPORARY)
"""The settings of an application that another server runs."""
OPENAPI: Final = "openapi"
"""What asks for the OpenAPI document, which is JSON as its path says."""


def _in_worker(name: str) -> Answering:
    """Returns what has a worker make a call; it reads the body, too."""

    async def answer(request: Request) -> Response:
        format = request.path_params.get("format")
        if format not in (None, *calls.EXPORT_FORMATS):
            raise NoSuchFormat("format", f"unknown format {format!r:.60}", ", ".join(calls.EXPORT_FORMATS))
        app: ComposeApp = request.app
        sent = format_sent(request, takes_files=name == "import")
        reading = read(ImportQuery, query_of(request, "level")) if sent == FILE else USUAL_READING
        body = await body_of(request, app.settings.body_seconds)
        return await unless_left(request.receive, app.make(name, body, sent, format or format_wanted(request), reading))

    return answer


def _at_once(name: str) -> Answering:
    """Returns what answers a call that takes no body and no time; documents are written in a thread, a word by the loop itself."""

    async def answer(request: Request) -> Response:
        app: ComposeApp = request.app
        wanted = "json" if name == OPENAPI else format_wanted(request)
        text, tag = app.told(name, wanted) if name == "healthz" else await run_in_threadpool(app.told, name, wanted)
        return not_changed(tag) if is_known(request, tag) else tagged(as_written(text, wanted), tag)

    return answer


FormatName = Annotated[str, OneOf(*calls.EXPORT_FORMATS)]


def _in_workers() -> DescribedCalls:
    """Declares the calls that take a body."""
    posts = DescribedCalls(responses=refusals(400, 401, 403, 405, 408, 413, 415, 421, 422, 429, 500, 503, 504))
    for name, call in calls.CALLS.items():
        takes, answers = call.types
        body = {"body": (takes, None) if name in calls.MAY_BE_EMPTY else takes}
        path: dict[str, Any] = {"path": f"/{name}", "takes": body}
        if name == "import":
            path["takes"] |= query_types(ImportQuery)
        if name == "export":
            path = {"path": "/export/{format}", "takes": {"format": FormatName, **body}, "responses": refusals(404)}
        posts.call("POST", answers=answers, name=name, description=call.work.__doc__, **path)(_in_worker(name))
    return posts


def _without_body() -> DescribedCalls:
    """Declares the calls that take none."""
    gets = DescribedCalls(responses=refusals(401, 405, 421, 429, 500) | NOT_CHANGED)
    for name, call in calls.QUESTIONS.items():
        gets.call("GET", f"/{name}", call.answers, name=call.name, description=call.answer.__doc__)(_at_once(name))
    return gets


CALLS: Final = (_in_workers(), _without_body(), homes, jobs)


class ComposeApp(Starlette):
    """The application with what its calls share."""

    def __init__(self, catalogs: Catalogs, settings: Settings) -> None:
        super().__init__(routes=[route for declared in CALLS for route in declared.routes()], lifespan=_started)
        self.router.redirect_slashes = False
        self.catalogs = catalogs
        content = packed(catalogs)
        self.mark = mark_of(content)
        self.settings = settings
        self.terms = Terms(settings.work, settings.most_effort, settings.judging)
        self.workers = Workers(settings, warm, content)
        self.connections = Connections(settings)
        self.store = ServiceStore(settings)
        self.store_threads = store_limiter()
        self.runner = Runner(self)
        self.stopping = Event()
        """Set when the service is told to stop, so that answers without an end of their own end."""
        self.measures = Measures(self.workers, self.connections)
        self.is_ready = False
        self._document: dict[str, Any] | None = None
        self._told: dict[tuple[str, str], tuple[bytes, str]] = {}

    async def make(self, call: str, body: bytes, sent: str, wanted: str, reading: ImportQuery = USUAL_READING) -> Response:
        """Makes one of `calls.CALLS` in a worker; `sent` is the format of its body, `wanted` that of the answer; `reading`: how a file is.

        Raises:
            Busy: too many calls wait.
            TooLong: it took too long.
            RuntimeError: a fault of ours.
        """
        is_light = call in calls.LIGHT and len(body) <= self.settings.light_bytes
        job = Job(call, body, sent, wanted, self.mark, self.terms, reading)
        done = await self.workers.run(do_alone, job, is_light=is_light)
        if not isinstance(done, Response):
            raise RuntimeError(f"/{call} failed in its worker:\n{done.trace if isinstance(done, Failure) else done}")
        return done

    def told(self, question: str, wanted: str) -> tuple[bytes, str]:
        """Returns the answer to one of `calls.QUESTIONS`, or `OPENAPI`, always the same, and its entity tag: both are made once."""
        if (question, wanted) not in self._told:
            answer = self.openapi() if question == OPENAPI else calls.QUESTIONS[question].answer(self.catalogs)
            text = dump_plain(answer, wanted)
            self._told[question, wanted] = text, f'"{sha256(text).hexdigest()[:32]}"'
        return self._told[question, wanted]

    def openapi(self) -> dict[str, Any]:
        """Returns the OpenAPI document."""
        if self._document is None:
            from service.described import described  # noqa: PLC0415 - FastAPI: nothing but this document needs it

            self._document = completed(deepcopy(described(CALLS)), self.catalogs)
        return self._document


@asynccontextmanager
async def _started(app: ComposeApp) -> AsyncIterator[None]:
    await app.workers.start()
    app.is_ready = True
    async with create_task_group() as group:
        if app.settings.store != NONE:
            group.start_soon(app.runner.run, app.store.is_temporary)
        yield
        group.cancel_scope.cancel()
    app.is_ready = False
    app.workers.stop()
    app.store.close()


async def readyz(request: Request) -> Response:
    """Tells balancers whether more calls are welcome: the processes are started, and not all places in the line are taken."""
    app: ComposeApp = request.app
    if not app.is_ready:
        raise Busy("service", "is starting", "another try in a moment")
    app.workers.check()
    return written({"status": "ready"}, "json")


def create_app(catalogs: Catalogs | None = None, settings: Settings = EMBEDDED, admitted: Admitted | None = None) -> ComposeApp:
    """Makes the application.

    Args:
        catalogs: the data to serve; by default our own.
        settings: its limits and names; by default all names are answered to, for whoever runs it within a server that looks after that.
        admitted: who may ask, and how much; by default what the settings say.

    Raises:
        CatalogError: our own catalogs cannot be read.
        FieldError: a key or an origin of the settings cannot be one.
        OSError: the file of keys cannot be read.
    """
    admitted = admitted or admitted_of(settings)
    app = ComposeApp(catalogs or load_catalogs(), settings)
    for kind in problems.ALL_STATUS:
        app.add_exception_handler(kind, problems.of_error)
    app.add_exception_handler(HTTPException, problems.of_http)
    app.add_route("/openapi.json", _at_once(OPENAPI))
    app.add_route("/", page.index)
    app.add_route("/embed", page.embed)
    app.add_route("/favicon.ico", page.icon)
    app.add_route("/core.wasm", page.core)
    app.add_route("/asset/{name}", page.asset)
    app.add_route("/docs", docs)
    app.add_route("/readyz", readyz)
    if settings.metrics:
        app.add_route("/metrics", metrics)
    app.mount("/assets", page.Assets())
    app.add_middleware(page.Packed)
    app.add_middleware(Admission, admitted)
    app.add_middleware(Callers, settings.allow_host, admitted.origins)
    if admitted.origins:
        app.add_middleware(CORSMiddleware, allow_origins=admitted.origins, **FOR_OTHER_PAGES)
    app.add_middleware(Guard)
    app.add_middleware(Observed, app.measures)
    return app
