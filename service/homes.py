"""The calls about homes that are kept: declared as in `app`, and done here, in threads that wait for the store.

Comes in: requests, whose owner `admission` knows. Goes out: answers; refusals as errors of the table in `problems`.
"""

from __future__ import annotations

import re
import zlib
from collections.abc import Callable
from typing import Annotated, Any, Final

from anyio import CapacityLimiter, to_thread
from fastapi import Header, Path, Query
from starlette.requests import Request
from starlette.responses import Response

from service.admission import owner_of
from service.described import Answering, DescribedCalls
from service.home_texts import HomeSent, as_yaml, head_document, home_text, moment, read_home
from service.kept_contract import (
    AFTER,
    LINES,
    LISTED,
    MOST_LISTED,
    MOST_NAME,
    HomeBody,
    HomeChange,
    HomeHead,
    HomeList,
    HomeQuery,
    HomeTag,
    HomeVersions,
    KeptHome,
)
from service.openapi import refusals
from service.refusals import NoSuchThing, TooLarge, WrongMediaType
from service.store.saved_homes import ANY_REVISION, SavedHome, SavedHomes, Wanted
from service.wire import body_of, format_sent, format_wanted, written
from solver.errors import FieldError
from solver.exchange import FORMATS, read

THREADS: Final = 8
"""How many calls wait for the store at once. Our choice: a call takes it a millisecond."""
MOST_PICTURE: Final = 512 * 1024
"""Largest picture, bytes. Our choice."""
PICTURES: Final = {"image/png": b"\x89PNG\r\n\x1a\n", "image/jpeg": b"\xff\xd8\xff", "image/webp": b"RIFF"}
"""The pictures that are kept, and how each begins."""
PICTURE_POLICY: Final = "default-src 'none'; style-src 'unsafe-inline'; sandbox"
HOME: Final = re.compile(r"[\w-]{1,40}")
TAG: Final = re.compile(r'(?:W/)?"(\d{1,9})(?:-yaml)?"')


def by_name(name: str) -> Answering:
    """Returns what answers a call that asks the store: it has the call's name in HANDLERS."""
    return HANDLERS[name]


async def _asked(request: Request, question: Callable[[SavedHomes, str], Any]) -> Any:
    """Asks the store something in a thread, for the owner of the request's key."""

    def ask() -> Any:
        return question(request.app.kept_homes(), owner_of(request.scope))

    return await to_thread.run_sync(ask, limiter=request.app.store_threads)


def _home(request: Request) -> str:
    home: str = request.path_params["home"]
    if not HOME.fullmatch(home):
        raise NoSuchThing("home", f"there is no {home!r:.40}", "the id of a home of yours")
    return home


def _revision(request: Request) -> int | None:
    """Returns the revision that If-Match names, ANY_REVISION for a star; None where there is none."""
    said = request.headers.get("if-match")
    if said is None or said.strip() == "*":
        return None if said is None else ANY_REVISION
    found = TAG.fullmatch(said.strip())
    return int(found.group(1)) if found else 0


def _tagged(answer: Response, home: SavedHome, wanted: str) -> Response:
    answer.headers["ETag"] = f'"{home.revision}"' if wanted == "json" else f'"{home.revision}-{wanted}"'
    answer.headers["Cache-Control"] = "private, no-cache"
    return answer


async def _sent(request: Request, is_change: bool) -> HomeSent:
    body, sent = await body_of(request, request.app.settings.body_seconds), format_sent(request)
    is_light = len(body) <= request.app.settings.light_bytes
    done = await request.app.workers.run(read_home, body, sent, is_change, is_light=is_light)
    if isinstance(done, Response):
        raise _Answered(done)
    found: HomeSent = done
    return found


class _Answered(Exception):
    """A call that has its answer already."""

    def __init__(self, answer: Response) -> None:
        super().__init__()
        self.answer = answer


def _answering(handler: Answering) -> Answering:
    async def answer(request: Request) -> Response:
        try:
            return await handler(request)
        except _Answered as answered:
            return answered.answer

    return answer


async def _save(request: Request) -> Response:
    sent, wanted = await _sent(request, False), format_wanted(request)
    scene = sent.scene
    assert scene is not None, "a HomeBody has one"
    home = await _asked(request, lambda homes, owner: homes.add(owner, sent.texts, scene))
    answer = _tagged(written(head_document(home), wanted), home, wanted)
    answer.status_code = 201
    answer.headers["Location"] = f"{request.scope.get('root_path', '')}/homes/{home.id}"
    return answer


async def _list(request: Request) -> Response:
    given = request.query_params
    asked: dict[str, object] = {name: given[name] for name in ("search", "after") if name in given}
    if "limit" in given:
        asked["limit"] = int(given["limit"]) if re.fullmatch(r"\d{1,9}", given["limit"]) else given["limit"]
    query = read(HomeQuery, {**asked, "tag": given.getlist("tag")})
    changed, _, home = query.after.partition("-")
    wanted = Wanted(query.search, query.tag, (int(changed), home) if query.after else None, query.limit)
    found = await _asked(request, lambda homes, owner: homes.list(owner, wanted))
    document = {"homes": [head_document(one) for one in found.homes], "total": found.total, "after": found.after}
    return written(document, format_wanted(request))


async def _read(request: Request) -> Response:
    home = _home(request)
    return await _whole(request, home, None)


async def _version(request: Request) -> Response:
    number = request.path_params["number"]
    if not re.fullmatch(r"[0-9]{1,9}", number):
        raise NoSuchThing("version", f"{number!r:.40} is no number", "the number of a version")
    return await _whole(request, _home(request), int(number))


async def _whole(request: Request, id_of: str, version: int | None) -> Response:
    home, scene = await _asked(request, lambda homes, owner: homes.get(owner, id_of, version))
    wanted = format_wanted(request)
    shown = home if version is None else None
    if shown and f'"{home.revision}{"" if wanted == "json" else "-yaml"}"' in request.headers.get("if-none-match", ""):
        return _tagged(Response(status_code=304, headers={"Vary": "Accept"}), home, wanted)
    text = await to_thread.run_sync(home_text, home, scene, limiter=request.app.store_threads)
    if wanted != "json":
        text = await request.app.workers.run(as_yaml, text)
    answer = Response(text, media_type=FORMATS[wanted].media_type, headers={"Vary": "Accept"})
    return _tagged(answer, home, wanted) if shown else answer


async def _change(request: Request) -> Response:
    id_of, revision = _home(request), _revision(request)
    sent, wanted = await _sent(request, True), format_wanted(request)
    home = await _asked(request, lambda homes, owner: homes.change(owner, id_of, revision, sent.texts, sent.scene))
    return _tagged(written(head_document(home), wanted), home, wanted)


async def _remove(request: Request) -> Response:
    id_of, revision = _home(request), _revision(request)
    await _asked(request, lambda homes, owner: homes.remove(owner, id_of, revision))
    return Response(status_code=204)


async def _versions(request: Request) -> Response:
    id_of = _home(request)
    found = await _asked(request, lambda homes, owner: homes.versions(owner, id_of))
    return written({"versions": [{"number": number, "made": moment(made)} for number, made in found]}, format_wanted(request))


async def _picture(request: Request) -> Response:
    id_of = _home(request)
    found = await _asked(request, lambda homes, owner: homes.picture(owner, id_of))
    if found is None:
        _, scene = await _asked(request, lambda homes, owner: homes.get(owner, id_of))
        drawn = await request.app.make("export", b'{"scene": ' + zlib.decompress(scene) + b"}", "json", "svg")
        if drawn.status_code != 200:
            return Response(drawn.body, drawn.status_code, media_type=drawn.media_type)
        found = bytes(drawn.body), "image/svg+xml"
    headers = {"Content-Security-Policy": PICTURE_POLICY, "Cache-Control": "private, no-cache"}
    return Response(found[0], media_type=found[1], headers=headers)


async def _put_picture(request: Request) -> Response:
    id_of, kind = _home(request), request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if kind not in PICTURES:
        raise WrongMediaType("Content-Type", f"{kind!r:.60} is no picture that is kept", ", ".join(PICTURES))
    content = await body_of(request, request.app.settings.body_seconds)
    if len(content) > MOST_PICTURE:
        raise TooLarge("body", "is a larger picture than is kept", f"at most {MOST_PICTURE} bytes")
    if not content.startswith(PICTURES[kind]):
        raise FieldError("body", f"is no {kind}", "a picture of the type that it is sent as")
    await _asked(request, lambda homes, owner: homes.put_picture(owner, id_of, content, kind))
    return Response(status_code=204)


HANDLERS: Final[dict[str, Answering]] = {
    "save_home": _answering(_save), "list_homes": _list, "read_home": _read, "change_home": _answering(_change), "remove_home": _remove,
    "list_versions": _versions, "read_version": _version, "read_picture": _picture, "put_picture": _put_picture,
}  # fmt: skip

IF_MATCH: Final = "the ETag that the home was read with; * for whichever there is"
HomeId = Annotated[str, Path(min_length=1, max_length=40, pattern=r"^[A-Za-z0-9_-]+$", description="of a home of yours")]
IfMatch = Annotated[str | None, Header(alias="If-Match", description=IF_MATCH, json_schema_extra={"examples": ['"1"']})]

PICTURE_CONTENT: Final = {kind: {"schema": {"type": "string", "format": "binary"}} for kind in (*PICTURES, "image/svg+xml")}
NOT_CHANGED: Final[dict[int | str, dict[str, Any]]] = {304: {"description": "The revision is the one of If-None-Match"}}

homes = DescribedCalls(by_name, responses=refusals(401, 403, 405, 421, 422, 429, 500, 503, 504, 507), prefix="/homes")
WITH_BODY: Final = refusals(400, 408, 409, 413, 415)


@homes.post("", status_code=201, responses=WITH_BODY)
def save_home(body: HomeBody) -> HomeHead:  # type: ignore[empty-body]
    """Keeps a home; answers where it is to be found."""


@homes.get("")
def list_homes(  # type: ignore[empty-body]
    search: Annotated[
        str, Query(max_length=MOST_NAME, pattern=LINES.pattern, description="words that are all somewhere in name, notes and tags")
    ] = "",
    tag: Annotated[list[HomeTag], Query(description="tags that it has, all of them")] = [],  # noqa: B006 - FastAPI reads it
    limit: Annotated[int, Query(ge=1, le=MOST_LISTED)] = LISTED,
    after: Annotated[str, Query(pattern=AFTER, description="`after` of the page before")] = "",
) -> HomeList:
    """Lists homes, the last changed first."""


@homes.get("/{home}", name="read_home", responses=refusals(404) | NOT_CHANGED)
def read_one(home: HomeId) -> KeptHome:  # type: ignore[empty-body]
    """Returns a home with its scene; its ETag names the revision."""


@homes.patch("/{home}", responses=WITH_BODY | refusals(404, 412, 428))
def change_home(home: HomeId, body: HomeChange, if_match: IfMatch = None) -> HomeHead:  # type: ignore[empty-body]
    """Changes a home; a scene becomes its next version."""


@homes.delete("/{home}", status_code=204, responses=refusals(404, 412, 428))
def remove_home(home: HomeId, if_match: IfMatch = None) -> None:
    """Removes a home with all its versions."""


@homes.get("/{home}/versions", responses=refusals(404))
def list_versions(home: HomeId) -> HomeVersions:  # type: ignore[empty-body]
    """Lists the versions of a home that are kept."""


@homes.get("/{home}/versions/{number}", responses=refusals(404))
def read_version(home: HomeId, number: Annotated[int, Path(ge=1, le=999_999_999)]) -> KeptHome:  # type: ignore[empty-body]
    """Returns a home as one of its versions was."""


@homes.get("/{home}/picture", response_class=Response, responses=refusals(404) | {200: {"content": PICTURE_CONTENT}})
def read_picture(home: HomeId) -> Response:  # type: ignore[empty-body]
    """Returns the picture that was given to a home, else its plan, drawn."""


@homes.put(
    "/{home}/picture", status_code=204, responses=WITH_BODY | refusals(404),
    openapi_extra={"requestBody": {"required": True, "content": {kind: PICTURE_CONTENT[kind] for kind in PICTURES}}},
)  # fmt: skip
def put_picture(home: HomeId) -> None:
    """Gives a home a picture: PNG, JPEG or WebP. That is no change of the home."""


def store_limiter() -> CapacityLimiter:
    """Returns what bounds the calls that wait for the store."""
    return CapacityLimiter(THREADS)
