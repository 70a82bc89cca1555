"""The built page: `static/index.html` and the files it loads."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

from starlette.requests import Request
from starlette.responses import FileResponse, PlainTextResponse, Response
from starlette.staticfiles import StaticFiles

STATIC: Final = Path(__file__).parent / "static"
NOT_BUILT: Final = "The page is not built here (`make run` builds it). The calls answer all the same; they are described at /docs.\n"


async def index(_: Request) -> Response:
    """Serves the page; looks for it at every call, so that building it needs no restart."""
    built = STATIC / "index.html"
    if not built.is_file():
        return PlainTextResponse(NOT_BUILT, 503)
    return FileResponse(built, headers={"Cache-Control": "no-cache"})


class Assets(StaticFiles):
    """The page's files. Their names carry a digest of their content, so they may be kept for ever."""

    def __init__(self) -> None:
        super().__init__(directory=STATIC / "assets", check_dir=False)

    async def check_config(self) -> None:
        """Lets a missing folder be: its files are then simply not found."""

    def file_response(self, *args: Any, **kwargs: Any) -> Response:
        """Adds how long the file may be kept."""
        response = super().file_response(*args, **kwargs)
        response.headers["Cache-Control"] = "public, max-age=31536000, immutable"
        return response
