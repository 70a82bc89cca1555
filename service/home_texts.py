"""Homes between what is sent and what is kept: read, packed, and written again. The first runs in a worker."""

import json
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from starlette.responses import Response

from service import problems
from service.kept_contract import HomeBody, HomeChange, HomeHead, PackedScene
from solver.errors import ComposeError, FieldError
from solver.exchange import GLB, dump_scene, load_text, read, write
from solver.scene import Scene


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
        return HomeSent(texts, None if found.scene is None else packed_scene(found.scene))
    except ComposeError as error:
        return problems.of_error(None, error)


def packed_scene(scene: Scene) -> PackedScene:
    """Packs a scene as it is kept."""
    return PackedScene(zlib.compress(dump_scene(scene, "json"), 6), len(scene.rooms))


def home_text(home: HomeHead, scene: bytes) -> bytes:
    """Writes a home with its packed scene as JSON; the scene is not read for it."""
    head = json.dumps(write(home), ensure_ascii=False).encode()
    return head[:-1] + b', "scene": ' + zlib.decompress(scene).strip() + b"}"
