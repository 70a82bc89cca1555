"""Indices and ids: made up where a document leaves them out, refused where they are given twice.

What is made up depends on the document alone, so the same document gets the same ids.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, TypeVar, cast

from solver.plain import Wrong
from solver.scene import Decoration, Dynamic, Furniture, Opening, Room, Scene

Named = TypeVar("Named", Furniture, Decoration, Opening, Dynamic, Room)


def indexed(document: object) -> object:
    """Gives rooms without an index their place in the list, or the next number that no room has."""
    rooms = document.get("rooms") if isinstance(document, Mapping) else None
    if not isinstance(rooms, (list, tuple)):
        return document
    taken = {room["index"] for room in rooms if isinstance(room, Mapping) and isinstance(room.get("index"), int)}
    numbered = []
    for place, room in enumerate(rooms):
        if isinstance(room, Mapping) and room.get("index") is None:
            index = place if place not in taken else max(taken) + 1
            taken.add(index)
            numbered.append({**room, "index": index})
        else:
            numbered.append(room)
    return {**cast(Mapping[str, Any], document), "rooms": numbered}


class _Ids:
    """The ids in use; hands out new ones."""

    def __init__(self, given: Iterator[tuple[str, str]]) -> None:
        self._taken: set[str] = set()
        self._last: dict[str, int] = {}
        for path, name in given:
            if name and name in self._taken:
                raise Wrong(f"is {name!r:.80}, which another one has too", "ids that no two share").inside(path)
            self._taken.add(name)

    def take(self, item: Named, wanted: str) -> Named:
        """Returns the item with an id: its own, or the wanted one if it is free, else that with the next number."""
        if item.id:
            return item
        name = wanted
        while name in self._taken:
            self._last[wanted] = self._last.get(wanted, 1) + 1
            name = f"{wanted}_{self._last[wanted]}"
        self._taken.add(name)
        return replace(item, id=name)

    def count(self, item: Named, stem: str) -> Named:
        """Returns the item with an id: its own, or the stem with the next free number from 1."""
        if item.id:
            return item
        while True:
            self._last[stem] = self._last.get(stem, 0) + 1
            name = f"{stem}_{self._last[stem]}"
            if name not in self._taken:
                self._taken.add(name)
                return replace(item, id=name)


def identified(scene: Scene) -> Scene:
    """Returns the scene with an id on every room, opening and body.

    Rooms become `<type>_<index>`, bodies `<room id>/<name>_<n>`, openings `<room id>/<kind>_<n>`, people `<kind>_<n>`.

    Raises:
        Wrong: two rooms or two bodies share an id.
    """
    room_ids = _Ids((f"rooms[{place}].id", room.id) for place, room in enumerate(scene.rooms))
    rooms = tuple(room_ids.take(room, f"{room.type}_{room.index}") for room in scene.rooms)
    body_ids = _Ids(_body_ids(scene))
    opening_ids = _Ids(("", opening.id) for opening in _openings_once(scene))
    rooms = tuple(_filled(room, body_ids, opening_ids) for room in rooms)
    dynamic = tuple(body_ids.count(body, body.kind) for body in scene.dynamic)
    return replace(scene, rooms=rooms, dynamic=dynamic)


def _openings_once(scene: Scene) -> Iterator[Opening]:
    """Yields an opening of each given id: both rooms of a door list it."""
    return iter({opening.id: opening for room in scene.rooms for opening in room.openings}.values())


def _body_ids(scene: Scene) -> Iterator[tuple[str, str]]:
    for place, room in enumerate(scene.rooms):
        yield from _given(f"rooms[{place}].furniture", room.furniture)
        yield from _given(f"rooms[{place}].decorations", room.decorations)
    yield from _given("dynamic", scene.dynamic)


def _given(path: str, bodies: Sequence[Furniture | Decoration | Dynamic]) -> Iterator[tuple[str, str]]:
    return ((f"{path}[{index}].id", body.id) for index, body in enumerate(bodies))


def _filled(room: Room, bodies: _Ids, openings: _Ids) -> Room:
    return replace(
        room,
        openings=tuple(openings.count(item, f"{room.id}/{item.kind}") for item in room.openings),
        furniture=tuple(bodies.count(item, f"{room.id}/{item.name}") for item in room.furniture),
        decorations=tuple(bodies.count(item, f"{room.id}/{item.name}") for item in room.decorations),
    )
