"""The built page, `static/index.html`, the page of frames, `static/embed.html`, and the files they load."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from starlette.exceptions import HTTPException
from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import Request
from starlette.responses import FileResponse, PlainTextResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import Receive, Scope, Send

from service.guard import EMBED_POLICY, WORKER_POLICY
from solver.core import WASM

STATIC: Final = Path(__file__).parent / "static"
WORKER: Final = "core_worker-"
"""How the name of the worker's file begins."""
LOADED: Final = frozenset({"/", "/embed", "/catalog", "/core.wasm"})
"""What the page loads beside its files."""
NOT_BUILT: Final = "The page is not built here (`make run` builds it). The calls answer all the same; they are described at /docs.\n"


async def index(_: Request) -> Response:
    """Serves the page; looks for it at every call, so that building it needs no restart."""
    return _built("index.html")


async def embed(_: Request) -> Response:
    """Serves the page that others show in a frame: it changes and keeps nothing."""
    return _built("embed.html", {"Content-Security-Policy": EMBED_POLICY})


def _built(name: str, headers: Mapping[str, str] = {}) -> Response:
    built = STATIC / name
    if not built.is_file():
        return PlainTextResponse(NOT_BUILT, 503)
    return FileResponse(built, headers={"Cache-Control": "no-cache", **headers})


async def core(_: Request) -> Response:
    """Serves the core, which the page runs as well; it is asked every time whether it is still the same."""
    if not WASM.is_file():
        return PlainTextResponse("The core is not built here: `make core` builds it.\n", 503)
    return FileResponse(WASM, media_type="application/wasm", headers={"Cache-Control": "no-cache"})


async def icon(_: Request) -> Response:
    """Serves the page's icon where browsers look for one beside answers that name none, such as /healthz."""
    found = next((STATIC / "assets").glob("icon-*.svg"), None)
    return Response(status_code=204) if found is None else FileResponse(found, headers={"Cache-Control": "no-cache"})


async def asset(request: Request) -> Response:
    """Serves the file of one of the user's own assets, by its name."""
    found = request.app.catalogs.assets.get(request.path_params["name"])
    if found is None or not Path(found.path).is_file():
        raise HTTPException(404)
    return FileResponse(found.path, media_type="model/gltf-binary", headers={"Cache-Control": "no-cache"})


class Assets(StaticFiles):
    """The page's files. Their names carry a digest of their content, so they may be kept for ever."""

    def __init__(self) -> None:
        super().__init__(directory=STATIC / "assets", check_dir=False)

    async def check_config(self) -> None:
        """Lets a missing folder be: its files are then simply not found."""

    def file_response(self, *args: Any, **kwargs: Any) -> Response:
        """Adds how long the file may be kept, and what the worker may do."""
        response = super().file_response(*args, **kwargs)
        response.headers["Cache-Control"] = "public, max-age=31536000, immutable"
        if Path(args[0]).name.startswith(WORKER):
            response.headers["Content-Security-Policy"] = WORKER_POLICY
        return response


class Packed(GZipMiddleware):
    """Packs what the page loads for who takes it so; other answers go as they are: some are streams, which packing would hold back."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answers."""
        is_loaded = scope["type"] == "http" and (scope["path"] in LOADED or scope["path"].startswith("/assets/"))
        await (super().__call__ if is_loaded else self.app)(scope, receive, send)
