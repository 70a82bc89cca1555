"""HTTP's side of documents: content types, the limit on bodies, JSON or YAML by what the caller accepts."""

import asyncio
import re
from collections.abc import Iterator
from typing import Any, Final
from urllib.parse import quote

from starlette.datastructures import Headers
from starlette.requests import Request
from starlette.responses import Response

from service.calls import ExportedFile
from service.problems import TooLarge, TooSlow, WrongMediaType
from solver.exchange import FORMATS, GLB, dump_plain
from solver.plain import Document

BODY_LIMIT: Final = 8 * 1024 * 1024
"""Largest body, bytes. Our choice: a furnished house of 30 x 20 m is 0.1 MB."""
DRAIN_LIMIT: Final = 4 * BODY_LIMIT
"""How much of a too large body is read and dropped, bytes, so that its sender hears the answer before the line closes."""
MEDIA_TYPES: Final = tuple(format.media_type for format in FORMATS.values())
_TEXTS: Final = {
    **{format.media_type: name for name, format in FORMATS.items()},
    "": "json",
    "application/x-www-form-urlencoded": "json",  # what `curl -d` says of any body
    "application/x-yaml": "yaml",
    "text/yaml": "yaml",
    "text/x-yaml": "yaml",
}
GLB_TYPE: Final = "model/gltf-binary"
FILE: Final = "file"
FILE_TYPES: Final = (
    "application/octet-stream", "application/zip", "application/xml", "text/xml", "application/geo+json", "application/x-sweethome3d",
    "image/svg+xml", "image/vnd.dxf", "application/dxf", "application/x-step",
)  # fmt: skip
"""What /import takes as it is; the other calls take none of it."""
READ_AS: Final = {**_TEXTS, GLB_TYPE: GLB, **dict.fromkeys(FILE_TYPES, FILE)}
"""The format a body is read in, by its content type."""
ACCEPTED: Final = {**_TEXTS, "*/*": "json", "application/*": "json"}
"""The format that satisfies a media range of an Accept header."""

TAG: Final = re.compile(r'"[^"]*"')
"""What is opaque of an entity tag (RFC 9110, 8.8.3)."""
NOT_CHANGED: Final[dict[int | str, dict[str, Any]]] = {304: {"description": "It is what If-None-Match names"}}


def format_sent(request: Request, takes_files: bool = False) -> str:
    """Tells the format of a request's body; a file of another program is one where the call `takes_files`.

    Raises:
        WrongMediaType: its content type or encoding is none of ours.
    """
    encoding = request.headers.get("content-encoding", "identity")
    if encoding.strip().lower() not in ("", "identity"):
        raise WrongMediaType("Content-Encoding", f"{encoding!r} is not decoded here", "identity")
    given = request.headers.get("content-type", "")
    found = READ_AS.get(given.partition(";")[0].strip().lower())
    if found is None or (found == FILE and not takes_files):
        texts = ", ".join(MEDIA_TYPES)
        raise WrongMediaType(
            "Content-Type", f"{given!r} is not read here",
            f"{texts}; {GLB_TYPE} for a .glb that was exported; {', '.join(FILE_TYPES)} for a file as it is"
            if takes_files else f"{texts}; {GLB_TYPE} for a .glb that was exported",
        )  # fmt: skip
    return found


def format_wanted(request: Request) -> str:
    """Tells the format a caller accepts: YAML where it is named and liked better than JSON, else JSON."""
    liked = {"json": 0.0, "yaml": 0.0}
    for name, quality in _ranges(request.headers.get("accept", "")):
        found = ACCEPTED.get(name)
        if found is not None:
            liked[found] = max(liked[found], quality)
    return "yaml" if liked["yaml"] > liked["json"] else "json"


def takes_gzip(headers: Headers) -> bool:
    """Tells whether a caller accepts an answer that is packed by gzip."""
    liked = dict(_ranges(headers.get("accept-encoding", "")))
    return liked.get("gzip", liked.get("*", 0.0)) > 0


def _ranges(accepted: str) -> Iterator[tuple[str, float]]:
    """Yields what a header accepts, in small letters, and how well each is liked, 0 to 1."""
    for item in accepted.split(","):
        name, _, parameters = item.partition(";")
        yield name.strip().lower(), _quality(parameters)


def _quality(parameters: str) -> float:
    for parameter in parameters.split(";"):
        name, _, value = parameter.partition("=")
        if name.strip().lower() == "q":
            try:
                return min(max(float(value), 0.0), 1.0)
            except ValueError:
                return 0.0
    return 1.0


async def body_of(request: Request, seconds: float) -> bytes:
    """Reads a request's body, which may take so many seconds to arrive.

    Raises:
        TooLarge: it holds, or says it holds, more than BODY_LIMIT bytes.
        TooSlow: it did not arrive in time.
    """
    announced = request.headers.get("content-length", "")
    large = announced.isdecimal() and (len(announced) > 18 or int(announced) > BODY_LIMIT)
    if large and (len(announced) > 18 or int(announced) > DRAIN_LIMIT or "expect" in request.headers):
        raise _too_large()
    try:
        async with asyncio.timeout(seconds):
            return await _received(request)
    except TimeoutError:
        raise TooSlow("body", f"did not arrive in {seconds:g} s") from None


async def _received(request: Request) -> bytes:
    chunks, size = [], 0
    async for chunk in request.stream():
        size += len(chunk)
        if size > DRAIN_LIMIT:
            break
        if size <= BODY_LIMIT:
            chunks.append(chunk)
    if size > BODY_LIMIT:
        raise _too_large()
    return b"".join(chunks)


def _too_large() -> TooLarge:
    return TooLarge("body", "is larger than this service reads", f"at most {BODY_LIMIT} bytes ({BODY_LIMIT >> 20} MB)")


def written(document: Document, format: str) -> Response:
    """Writes a document as a response in that format."""
    return as_written(dump_plain(document, format), format)


def as_written(text: bytes | str, format: str) -> Response:
    """Returns a response of what is written in that format."""
    return Response(text, media_type=FORMATS[format].media_type, headers={"Vary": "Accept"})


def tags_in(request: Request, header: str) -> set[str] | None:
    """Returns the entity tags that If-Match or If-None-Match lists, weak ones as strong ones, or a star; None without it."""
    said = ", ".join(request.headers.getlist(header)).strip()
    found = {said} if said == "*" else set(TAG.findall(said))
    return found if header in request.headers else None


def is_known(request: Request, tag: str) -> bool:
    """Tells whether the caller has the answer of that entity tag, and asks for another one alone."""
    return not {"*", tag}.isdisjoint(tags_in(request, "if-none-match") or ())


def tagged(answer: Response, tag: str) -> Response:
    """Gives an answer its entity tag, which whoever keeps the answer asks about each time."""
    answer.headers.update({"ETag": tag, "Cache-Control": "private, no-cache"})
    return answer


def not_changed(tag: str) -> Response:
    """Answers who has the answer of that entity tag."""
    return tagged(Response(status_code=304, headers={"Vary": "Accept"}), tag)


def attached(file: ExportedFile) -> Response:
    """Writes a file as a response that browsers save under its name."""
    name = quote(file.name, safe="")
    return Response(file.content, media_type=file.media_type, headers={"Content-Disposition": f"attachment; filename*=UTF-8''{name}"})
