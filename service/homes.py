"""The calls about homes that are kept, in threads that wait for the store; what is sent is read and packed in a worker."""

import json
import re
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, Final

from anyio import to_thread
from starlette.requests import Request
from starlette.responses import Response

from service import problems
from service.kept_contract import (
    ANY_REVISION,
    HomeBody,
    HomeChange,
    HomeHead,
    HomeList,
    HomeQuery,
    HomeVersions,
    HomeWithScene,
    PackedScene,
    Revisions,
    moment,
)
from service.openapi import DescribedCalls, query_of, query_types, refusals
from service.problems import TooLarge, WrongMediaType
from service.service_store import REFUSALS, WITH_BODY, ServiceStore, ask, id_in, id_type, number_in, number_type
from service.wire import NOT_CHANGED, as_written, body_of, format_sent, format_wanted, is_known, not_changed, tagged, tags_in, written
from solver.errors import ComposeError, FieldError
from solver.exchange import FORMATS, GLB, dump_scene, load_text, read, write


@dataclass(frozen=True)
class HomeSent:
    """What a body says of a home: texts by name, and its scene."""

    texts: Mapping[str, Any]
    scene: PackedScene | None


def read_sent_home(body: bytes, sent: str, is_change: bool) -> HomeSent | Response:
    """Reads the body of a home, or of a change of one, as it was sent; what is wrong with it becomes a problem document."""
    try:
        document = load_text(body, sent)
        document = {"scene": document} if sent == GLB else document
        found: HomeBody | HomeChange = read(HomeChange, document) if is_change else read(HomeBody, document)
        texts = {name: getattr(found, name) for name in ("name", "notes", "tags") if getattr(found, name) is not None}
        if is_change and not texts and found.scene is None:
            raise FieldError("body", "changes nothing", "at least one of name, notes, tags and scene")
        if "tags" in texts:
            texts["tags"] = tuple(dict.fromkeys(texts["tags"]))
        scene = None if found.scene is None else PackedScene(zlib.compress(dump_scene(found.scene, "json"), 6), len(found.scene.rooms))
        return HomeSent(texts, scene)
    except ComposeError as error:
        return problems.of_error(None, error)


def home_text(home: HomeHead, scene: bytes) -> bytes:
    """Writes a home with its packed scene as JSON; the scene is not read for it."""
    head = json.dumps(write(home), ensure_ascii=False).encode()
    return head[:-1] + b', "scene": ' + zlib.decompress(scene).strip() + b"}"


MOST_PICTURE: Final = 512 * 1024
"""Largest picture, bytes. Our choice."""
PICTURES: Final = {"image/png": b"\x89PNG\r\n\x1a\n", "image/jpeg": b"\xff\xd8\xff", "image/webp": b"RIFF"}
"""The pictures that are kept, and how each begins."""
PICTURE_POLICY: Final = "default-src 'none'; style-src 'unsafe-inline'; sandbox"
REVISION: Final = re.compile(r'"(\d{1,9})(?:-yaml)?"')


_asked = partial(ask, ServiceStore.open)


def _revisions(request: Request) -> Revisions:
    """Returns the revisions that If-Match names; None where there is none."""
    tags = tags_in(request, "if-match")
    if tags is None or "*" in tags:
        return None if tags is None else ANY_REVISION
    return {int(one.group(1)) for tag in tags if (one := REVISION.fullmatch(tag))}


def _etag(home: HomeHead, wanted: str) -> str:
    return f'"{home.revision}"' if wanted == "json" else f'"{home.revision}-{wanted}"'


def _tagged(answer: Response, home: HomeHead, wanted: str) -> Response:
    return tagged(answer, _etag(home, wanted))


async def _sent(request: Request, is_change: bool) -> HomeSent | Response:
    """Returns what is said of a home, or the refusal of it."""
    body, sent = await body_of(request, request.app.settings.body_seconds), format_sent(request)
    is_light = len(body) <= request.app.settings.light_bytes
    done: HomeSent | Response = await request.app.workers.run(read_sent_home, body, sent, is_change, is_light=is_light)
    return done


IF_MATCH: Final[dict[str, Any]] = {
    "name": "If-Match",
    "in": "header",
    "description": "the ETag that the home was read with; * for whichever there is",
    "schema": {"type": "string", "examples": ['"1"']},
}

PICTURE_CONTENT: Final = {kind: {"schema": {"type": "string", "format": "binary"}} for kind in (*PICTURES, "image/svg+xml")}

homes = DescribedCalls("/homes", responses=REFUSALS)
OF_HOME: Final = {"home": id_type("home")}
OF_REVISION: Final = {"parameters": [IF_MATCH]}
OF_VERSION: Final = {**OF_HOME, "number": number_type(1)}


@homes.call("POST", "", HomeHead, takes={"body": HomeBody}, status_code=201, responses=WITH_BODY)
async def save_home(request: Request) -> Response:
    """Keeps a home; answers where it is to be found."""
    sent, wanted = await _sent(request, False), format_wanted(request)
    if isinstance(sent, Response):
        return sent
    scene = sent.scene
    assert scene is not None, "a HomeBody has one"
    home = await _asked(request, lambda kept, owner: kept.add(owner, sent.texts, scene))
    answer = _tagged(written(write(home), wanted), home, wanted)
    answer.status_code = 201
    answer.headers["Location"] = f"{request.scope.get('root_path', '')}/homes/{home.id}"
    return answer


@homes.call("GET", "", HomeList, takes=query_types(HomeQuery))
async def list_homes(request: Request) -> Response:
    """Lists homes, the last changed first."""
    query = read(HomeQuery, {**query_of(request, "limit"), "tag": request.query_params.getlist("tag")})
    found = await _asked(request, lambda kept, owner: kept.list(owner, query))
    document = {"homes": [write(one) for one in found.homes], "total": found.total, "after": found.after}
    return written(document, format_wanted(request))


@homes.call("GET", "/{home}", HomeWithScene, takes=OF_HOME, responses=refusals(404) | NOT_CHANGED)
async def read_home(request: Request) -> Response:
    """Returns a home with its scene; its ETag names the revision."""
    return await _whole(request, id_in(request, "home"), None)


async def _whole(request: Request, id_of: str, version: int | None) -> Response:
    home, scene = await _asked(request, lambda kept, owner: kept.get(owner, id_of, version))
    wanted = format_wanted(request)
    shown = home if version is None else None
    if shown and is_known(request, _etag(home, wanted)):
        return not_changed(_etag(home, wanted))
    text = await to_thread.run_sync(home_text, home, scene, limiter=request.app.store_threads)
    if wanted != "json":
        text = await request.app.workers.run(FORMATS[wanted].of_json, text)
    answer = as_written(text, wanted)
    return _tagged(answer, home, wanted) if shown else answer


@homes.call(
    "PATCH", "/{home}", HomeHead, takes={"body": HomeChange, **OF_HOME}, openapi_extra=OF_REVISION,
    responses=WITH_BODY | refusals(404, 412, 428),
)  # fmt: skip
async def change_home(request: Request) -> Response:
    """Changes a home; a scene becomes its next version."""
    id_of, revisions = id_in(request, "home"), _revisions(request)
    sent, wanted = await _sent(request, True), format_wanted(request)
    if isinstance(sent, Response):
        return sent
    home = await _asked(request, lambda kept, owner: kept.change(owner, id_of, revisions, sent.texts, sent.scene))
    return _tagged(written(write(home), wanted), home, wanted)


@homes.call("DELETE", "/{home}", takes=OF_HOME, openapi_extra=OF_REVISION, status_code=204, responses=refusals(404, 412, 428))
async def remove_home(request: Request) -> Response:
    """Removes a home with all its versions."""
    await _asked(request, lambda kept, owner: kept.remove(owner, id_in(request, "home"), _revisions(request)))
    return Response(status_code=204)


@homes.call("GET", "/{home}/versions", HomeVersions, takes=OF_HOME, responses=refusals(404))
async def list_versions(request: Request) -> Response:
    """Lists the versions of a home that are kept."""
    found = await _asked(request, lambda kept, owner: kept.versions(owner, id_in(request, "home")))
    return written({"versions": [{"number": number, "made": moment(made)} for number, made in found]}, format_wanted(request))


@homes.call("GET", "/{home}/versions/{number}", HomeWithScene, takes=OF_VERSION, responses=refusals(404))
async def read_version(request: Request) -> Response:
    """Returns a home as one of its versions was."""
    number = number_in(request, "version", "the number of a version")
    return await _whole(request, id_in(request, "home"), number)


@homes.call("GET", "/{home}/picture", takes=OF_HOME, response_class=Response, responses=refusals(404) | {200: {"content": PICTURE_CONTENT}})
async def read_picture(request: Request) -> Response:
    """Returns the picture that was given to a home, else its plan, drawn."""
    id_of = id_in(request, "home")
    found = await _asked(request, lambda kept, owner: kept.picture(owner, id_of))
    if found is None:
        _, scene = await _asked(request, lambda kept, owner: kept.get(owner, id_of))
        drawn = await request.app.make("export", b'{"scene": ' + zlib.decompress(scene) + b"}", "json", "svg")
        if drawn.status_code != 200:
            return Response(drawn.body, drawn.status_code, media_type=drawn.media_type)
        found = bytes(drawn.body), "image/svg+xml"
    headers = {"Content-Security-Policy": PICTURE_POLICY, "Cache-Control": "private, no-cache"}
    return Response(found[0], media_type=found[1], headers=headers)


@homes.call(
    "PUT", "/{home}/picture", takes=OF_HOME, status_code=204, responses=WITH_BODY | refusals(404),
    openapi_extra={"requestBody": {"required": True, "content": {kind: PICTURE_CONTENT[kind] for kind in PICTURES}}},
)  # fmt: skip
async def put_picture(request: Request) -> Response:
    """Gives a home a picture: PNG, JPEG or WebP. That is no change of the home."""
    id_of, kind = id_in(request, "home"), request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if kind not in PICTURES:
        raise WrongMediaType("Content-Type", f"{kind!r:.60} is no picture that is kept", ", ".join(PICTURES))
    content = await body_of(request, request.app.settings.body_seconds)
    if len(content) > MOST_PICTURE:
        raise TooLarge("body", "is a larger picture than is kept", f"at most {MOST_PICTURE} bytes")
    if not content.startswith(PICTURES[kind]):
        raise FieldError("body", f"is no {kind}", "a picture of the type that it is sent as")
    await _asked(request, lambda kept, owner: kept.put_picture(owner, id_of, content, kind))
    return Response(status_code=204)
