"""The HTTP service: every call in one page. Start reading here."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from http import HTTPStatus
from typing import Final, cast

from fastapi import Request
from fastapi.routing import APIRouter
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.responses import Response

from catalogs import Catalogs, load_catalogs
from service import calls, page, problems
from service.describe import DescribedApp, described
from service.docs import docs
from service.documents import Document
from service.guard import Guard
from service.wire import body_of, format_sent, format_wanted, written
from service.work import Failure, Job, do_alone, packed, warm
from service.workers import Workers
from solver.exchange import FORMATS
from solver.pipeline.generate import VERSION

router = APIRouter()
DESCRIPTION: Final = "Lays out whole furnished homes and proves they work. JSON and YAML, in by Content-Type and out by Accept."


@router.post("/generate", **described("Generate"))
async def post_generate(request: Request) -> Response:
    """Makes a furnished house, or furnishes some rooms of one anew."""
    return await _called(request, "generate")


@router.post("/fix", **described("Fix"))
async def post_fix(request: Request) -> Response:
    """Repairs a scene by moving as little as possible."""
    return await _called(request, "fix")


@router.post("/place", **described("Place"))
async def post_place(request: Request) -> Response:
    """Places a list of pieces, with their relations, in a room of the caller's own."""
    return await _called(request, "place")


@router.post("/validate", **described("Validate"))
async def post_validate(request: Request) -> Response:
    """Lists which rules a scene breaks, and by how much."""
    return await _called(request, "validate")


@router.post("/view", **described("View"))
async def post_view(request: Request) -> Response:
    """Writes a scene as readable YAML, and which body each line is."""
    return await _called(request, "view")


@router.post("/floor", **described("Floor"))
async def post_floor(request: Request) -> Response:
    """Says where the floor of rooms is clear of walls, kept free for doors and windows, and free to come to."""
    return await _called(request, "floor")


@router.post("/export/{format}", **described("Export"))
async def post_export(request: Request, format: str) -> Response:
    """Writes a scene as a file, JSON or YAML; also reads one that is."""
    if format not in FORMATS:
        raise HTTPException(HTTPStatus.NOT_FOUND)
    return await _called(request, "export", format)


@router.get("/catalog", **described("Catalog"))
async def get_catalog(request: Request) -> Response:
    """Returns the furniture, decorations, room types, styles and presets the service knows."""
    return await _asked(request, calls.catalog_document)


@router.get("/schema", **described("Schema"))
async def get_schema(request: Request) -> Response:
    """Returns the JSON Schema of a scene."""
    return await _asked(request, calls.schema_document)


@router.get("/healthz", **described("Health"))
async def get_healthz(request: Request) -> Response:
    """Answers at once while the service lives."""
    return written({"status": "ok"}, format_wanted(request))


async def _called(request: Request, call: str, format: str | None = None) -> Response:
    sent, wanted, app = format_sent(request), format or format_wanted(request), cast(ComposeApp, request.app)
    job = Job(call, await body_of(request), sent, wanted, app.packed_catalogs)
    done = await app.workers.run(do_alone, job)
    if isinstance(done, Failure):
        raise RuntimeError(f"/{call} failed in its worker:\n{done.trace}")
    return done


async def _asked(request: Request, call: Callable[[Catalogs], Document]) -> Response:
    wanted, app = format_wanted(request), cast(ComposeApp, request.app)
    return await run_in_threadpool(lambda: written(call(app.catalogs), wanted))


class ComposeApp(DescribedApp):
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
        self.workers = Workers()


@asynccontextmanager
async def _started(app: ComposeApp) -> AsyncIterator[None]:
    await app.workers.start(warm, app.packed_catalogs)
    yield


def create_app(catalogs: Catalogs | None = None) -> ComposeApp:
    """Makes the application.

    Args:
        catalogs: the data to serve; by default our own.

    Raises:
        CatalogError: our own catalogs cannot be read.
    """
    app = ComposeApp(catalogs or load_catalogs())
    for kind in problems.STATUS:
        app.add_exception_handler(kind, problems.of_error)
    app.add_exception_handler(HTTPException, problems.of_http)
    app.include_router(router)
    app.add_route("/", page.index, include_in_schema=False)
    app.add_route("/docs", docs, include_in_schema=False)
    app.mount("/assets", page.Assets())
    app.add_middleware(Guard)
    return app
