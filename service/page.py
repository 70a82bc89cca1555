"""The built page, `static/index.html`, the page of frames, `static/embed.html`, and the files they load."""

import gzip
from functools import lru_cache
from pathlib import Path
from typing import Any, Final

from starlette.concurrency import run_in_threadpool
from starlette.datastructures import Headers
from starlette.exceptions import HTTPException
from starlette.middleware.gzip import GZipResponder, IdentityResponder
from starlette.requests import Request
from starlette.responses import FileResponse, PlainTextResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Receive, Scope, Send

from service.guard import EMBED_POLICY, WORKER_POLICY
from service.wire import takes_gzip
from solver.core import WASM

STATIC: Final = Path(__file__).parent / "static"
WORKER: Final = "core_worker-"
"""How the name of the worker's file begins."""
ALIKE: Final = frozenset({"/", "/embed", "/catalog", "/core.wasm", "/openapi.json"})
"""What is the same for all who ask, beside the page's files: it is packed once."""
ONCE: Final = ("/export/", "/docs")
"""How paths of what is written for one who asks begin: files, and /docs with its address. It is packed quickly, and not kept."""
WHOLE: Final = 1 << 24
"""Files of fewer bytes are sent in one go, so that they can be packed once for all."""
SMALL: Final = 500
"""What has fewer bytes is not packed."""
NOT_BUILT: Final = "The page is not built here (`make run` builds it). The calls answer all the same; they are described at /docs.\n"


async def index(request: Request) -> Response:
    """Serves the page; looks for it at every call, so that building it needs no restart."""
    return _built(request, "index.html")


async def embed(request: Request) -> Response:
    """Serves the page that others show in a frame: it changes and keeps nothing."""
    response = _built(request, "embed.html")
    response.headers["Content-Security-Policy"] = EMBED_POLICY
    return response


def _built(request: Request, name: str) -> Response:
    built = STATIC / name
    return _newest(request, built) if built.is_file() else PlainTextResponse(NOT_BUILT, 503)


def _newest(request: Request, path: Path) -> Response:
    """Sends a file that browsers ask for every time; no more than that it is the same to one that has it."""
    response = WholeFiles().file_response(path, path.stat(), request.scope)
    response.headers["Cache-Control"] = "no-cache"
    return response


async def core(request: Request) -> Response:
    """Serves the core, which the page runs as well; it is asked every time whether it is still the same."""
    if not WASM.is_file():
        return PlainTextResponse("The core is not built here: `make core` builds it.\n", 503)
    return _newest(request, WASM)


async def icon(request: Request) -> Response:
    """Serves the page's icon where browsers look for one beside answers that name none, such as /healthz."""
    found = next((STATIC / "assets").glob("icon-*.svg"), None)
    return Response(status_code=204) if found is None else _newest(request, found)


async def asset(request: Request) -> Response:
    """Serves the file of one of the user's own assets, by its name."""
    found = request.app.catalogs.assets.get(request.path_params["name"])
    if found is None or not Path(found.path).is_file():
        raise HTTPException(404)
    response = _newest(request, Path(found.path))
    response.headers["Content-Type"] = "model/gltf-binary"
    return response


class WholeFiles(StaticFiles):
    """Files that are sent in one go, and not again to who has them."""

    def file_response(self, *args: Any, **kwargs: Any) -> Response:
        """Reads as much of the file at once as may be packed."""
        response = super().file_response(*args, **kwargs)
        if isinstance(response, FileResponse):
            response.chunk_size = WHOLE
        return response


class Assets(WholeFiles):
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


class Packed:
    """Packs what is alike for all, and what is written for one, for who takes it so; other answers are as they are: streams would wait."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answers."""
        answer, path = self._app, scope.get("path", "")
        is_alike = path in ALIKE or path.startswith("/assets/")
        if scope["type"] == "http" and (is_alike or path.startswith(ONCE)):
            if not takes_gzip(Headers(scope=scope)):
                answer = IdentityResponder(answer, SMALL)
            else:
                answer = _Packing(answer, SMALL) if is_alike else GZipResponder(answer, SMALL, compresslevel=1)
        await answer(scope, receive, send)


class _Packing(GZipResponder):
    async def apply_compression(self, body: bytes, *, more_body: bool) -> bytes:
        if self._compressor or more_body:  # of what is too large to keep
            return await super().apply_compression(body, more_body=more_body)
        return await run_in_threadpool(_packed, body)


@lru_cache(maxsize=32)
def _packed(body: bytes) -> bytes:
    """Packs what hardly changes while a process runs: once, for all who ask."""
    return gzip.compress(body, mtime=0)
