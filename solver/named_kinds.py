"""The kinds of a scene's bodies, written into it: chosen here, once, for whoever draws or exports it."""

from collections.abc import Iterable
from dataclasses import replace
from typing import TypeVar

from catalogs import Catalogs
from catalogs.kind_book import KindBook
from solver.scene import Decoration, Furniture, Room, Scene

Named = TypeVar("Named", Furniture, Decoration)


def with_kinds(scene: Scene, catalogs: Catalogs) -> Scene:
    """Returns a scene whose furniture and decorations name their kinds; one that the catalogs do not know names none."""
    book = KindBook(catalogs)
    return replace(scene, rooms=tuple(room_with_kinds(room, book) for room in scene.rooms))


def room_with_kinds(room: Room, book: KindBook) -> Room:
    """Returns a room whose furniture and decorations name their kinds."""
    return replace(room, furniture=naming("furniture", room.furniture, book), decorations=naming("decoration", room.decorations, book))


def naming(sort: str, bodies: Iterable[Named], book: KindBook) -> tuple[Named, ...]:
    """Returns bodies that name their kinds."""
    kinds = ((body, book.kind_of(sort, body.name, (body.width, body.depth, body.height), body.kind)) for body in bodies)
    return tuple(body if kind == body.kind else replace(body, kind=kind) for body, kind in kinds)
