"""The HTTP service: every call in one page. Start reading here.

The functions declare what a call takes and answers, and FastAPI describes it; `calls` does it, in a worker that reads the body.
"""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Collection, Coroutine
from contextlib import asynccontextmanager
from dataclasses import replace
from typing import Annotated, Any, Final

from fastapi import FastAPI, Path, Request
from fastapi.routing import APIRoute, APIRouter
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.responses import Response

from catalogs import Catalogs, load_catalogs
from service import calls, contract, page, problems
from service.callers import ANY, Callers
from service.docs import docs
from service.guard import Guard
from service.openapi import completed, refusals
from service.refusals import NoSuchFormat
from service.wire import body_of, format_sent, format_wanted, written
from service.work import Failure, Job, UnknownCatalogs, do_alone, mark_of, packed, warm
from service.workers import Workers
from solver.explained import Explained
from solver.guessed import FurnishedPlan
from solver.imported import PlanImport
from solver.scene import Fixed, Generated, Scene
from solver.scene import Request as HouseRequest
from solver.version import VERSION

DESCRIPTION: Final = "Lays out whole furnished homes and proves they work. JSON and YAML, in by Content-Type and out by Accept."


class WorkerRoute(APIRoute):
    """A call that a worker makes: it reads the body, so that FastAPI does not."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Returns what answers a request."""

        async def answer(request: Request) -> Response:
            format = request.path_params.get("format")
            if format not in (None, *calls.EXPORT_FORMATS):
                raise NoSuchFormat("format", f"unknown format {format!r:.60}", ", ".join(calls.EXPORT_FORMATS))
            app: ComposeApp = request.app
            sent = format_sent(request, takes_files=self.name == "import")
            job = Job(self.name, await body_of(request), sent, format or format_wanted(request), app.mark)
            done = await app.workers.run(do_alone, job)
            if isinstance(done, UnknownCatalogs):  # a process that was started since
                done = await app.workers.run(do_alone, replace(job, catalogs=app.packed_catalogs))
            if not isinstance(done, Response):
                raise RuntimeError(f"/{self.name} failed in its worker:\n{done.trace if isinstance(done, Failure) else done}")
            return done

        return answer


class PlainRoute(APIRoute):
    """A call that takes no body and no time."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Returns what answers a request."""

        async def answer(request: Request) -> Response:
            app: ComposeApp = request.app
            wanted = format_wanted(request)
            return await run_in_threadpool(lambda: written(calls.QUESTIONS[self.name](app.catalogs), wanted))

        return answer


FormatName = Annotated[str, Path(json_schema_extra={"enum": list(calls.EXPORT_FORMATS)})]

posts = APIRouter(route_class=WorkerRoute, responses=refusals(400, 403, 405, 408, 413, 415, 421, 422, 500, 503))
gets = APIRouter(route_class=PlainRoute, responses=refusals(405, 421, 500))


@posts.post("/generate")
def generate(body: HouseRequest | contract.RerollBody | contract.RestyleBody | None = None) -> Generated:  # type: ignore[empty-body]
    """Makes a furnished house, furnishes some rooms of one anew, or gives one another style."""


@posts.post("/furnish")
def furnish(body: contract.FurnishBody) -> FurnishedPlan:  # type: ignore[empty-body]
    """Furnishes the rooms of somebody's own plan; says what was guessed of it."""


@posts.post("/fix")
def fix(body: contract.FixBody) -> Fixed:  # type: ignore[empty-body]
    """Repairs a scene by moving as little as possible."""


@posts.post("/drag")
def drag(body: contract.DragBody) -> contract.DragAnswer:  # type: ignore[empty-body]
    """Prepares the room of a piece that is about to be dragged."""


@posts.post("/place")
def place(body: contract.PlaceBody) -> contract.PlaceAnswer:  # type: ignore[empty-body]
    """Places a list of pieces, with their relations, in a room of the caller's own."""


@posts.post("/validate")
def validate(body: contract.ValidateBody) -> contract.ValidateAnswer:  # type: ignore[empty-body]
    """Lists which rules a scene breaks, and by how much."""


@posts.post("/view")
def view(body: contract.ViewBody) -> contract.Lines:  # type: ignore[empty-body]
    """Writes a scene as readable YAML, and which body each line is."""


@posts.post("/explain")
def explain(body: contract.ExplainBody) -> Explained:  # type: ignore[empty-body]
    """Says where a piece of a generated home was wished, and what holds it back from there."""


@posts.post("/import", name="import")
def import_(body: contract.ImportBody) -> PlanImport:  # type: ignore[empty-body]
    """Reads a floor plan of another program as a scene, and says all that is not as the file says."""


@posts.post("/floor")
def floor(body: contract.FloorBody) -> contract.FloorAnswer:  # type: ignore[empty-body]
    """Says where the floor of rooms is clear of walls, kept free for doors and windows, and free to come to."""


@posts.post("/export/{format}", responses=refusals(404))
def export(format: FormatName, body: contract.ExportBody | contract.SceneByItself) -> Scene:  # type: ignore[empty-body]
    """Writes a scene as a file: JSON or YAML (and reads one that is), or what a simulator, an editor or a training set reads."""


@gets.get("/catalog")
def catalog() -> Catalogs:  # type: ignore[empty-body]
    """Returns the furniture, decorations, room types, styles and presets the service knows."""


@gets.get("/export")
def exports() -> contract.ExportFormats:  # type: ignore[empty-body]
    """Lists the formats that /export writes, beside JSON and YAML."""


@gets.get("/schema")
def schema() -> dict[str, Any]:  # type: ignore[empty-body]
    """Returns the JSON Schema of a scene."""


@gets.get("/healthz")
def healthz() -> contract.Health:  # type: ignore[empty-body]
    """Answers at once while the service lives."""


class ComposeApp(FastAPI):
    """The application with what its calls share.

    Args:
        catalogs: the data to serve.
    """

    def __init__(self, catalogs: Catalogs) -> None:
        super().__init__(
            title="Compose", version=VERSION, description=DESCRIPTION,
            docs_url=None, redoc_url=None, redirect_slashes=False, lifespan=_started,
        )  # fmt: skip
        self.catalogs = catalogs
        self.packed_catalogs = packed(catalogs)
        self.mark = mark_of(self.packed_catalogs)
        self.workers = Workers()

    def openapi(self) -> dict[str, Any]:
        """Returns the OpenAPI document."""
        self.openapi_schema = self.openapi_schema or completed(super().openapi(), self.catalogs)
        return self.openapi_schema


@asynccontextmanager
async def _started(app: ComposeApp) -> AsyncIterator[None]:
    await app.workers.start(warm, app.packed_catalogs)
    yield


def create_app(catalogs: Catalogs | None = None, hosts: Collection[str] = (ANY,)) -> ComposeApp:
    """Makes the application.

    Args:
        catalogs: the data to serve; by default our own.
        hosts: the names that it answers to; by default all, for whoever runs it within a server that looks after that.

    Raises:
        CatalogError: our own catalogs cannot be read.
    """
    app = ComposeApp(catalogs or load_catalogs())
    for kind in problems.STATUS:
        app.add_exception_handler(kind, problems.of_error)
    app.add_exception_handler(HTTPException, problems.of_http)
    app.include_router(posts)
    app.include_router(gets)
    app.add_route("/", page.index, include_in_schema=False)
    app.add_route("/core.wasm", page.core, include_in_schema=False)
    app.add_route("/asset/{name}", page.asset, include_in_schema=False)
    app.add_route("/docs", docs, include_in_schema=False)
    app.mount("/assets", page.Assets())
    app.add_middleware(Callers, hosts)
    app.add_middleware(Guard)
    return app
