"""Indices and ids: made up where a document leaves them out, refused where they are given twice; what an outline must be to be one.

What is made up depends on the document alone, so the same document gets the same ids.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, TypeAlias, TypeVar, cast

from solver.free_names import FreeNames
from solver.geometry import doubled_area
from solver.plain import Wrong
from solver.scene import Decoration, Dynamic, Furniture, Opening, Room, Scene

Named = TypeVar("Named", Furniture, Decoration, Opening, Dynamic, Room)
_Way: TypeAlias = tuple[str | int, ...]


def _deep(wrong: Wrong, *way: str | int) -> Wrong:
    """Returns what is wrong, that deep inside a scene."""
    for step in reversed(way):
        wrong = wrong.inside(step)
    return wrong


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


class _Ids(FreeNames):
    """The ids in use; hands out new ones."""

    def __init__(self, given: Iterable[tuple[_Way, str]]) -> None:
        super().__init__()
        for way, name in given:
            if name and name in self.given:
                raise _deep(Wrong(f"is {name!r:.80}, which another one has too", "ids that no two share"), *way, "id")
            self.given.add(name)


def _named(items: Sequence[Named], name: Callable[[Named], str]) -> tuple[Named, ...]:
    """Returns items with an id each: its own, else the one that it is given."""
    return tuple(item if item.id else replace(item, id=name(item)) for item in items)


def identified(scene: Scene) -> Scene:
    """Returns the scene with an id on every room, opening and body.

    Rooms become `<type>_<index>`, bodies `<room id>/<name>_<n>`, openings `<room id>/<kind>_<n>`, people `<kind>_<n>`.

    Raises:
        Wrong: two rooms, two bodies or two openings of one room share an id, or two levels an index.
    """
    _check_levels(scene)
    for place, room in enumerate(scene.rooms):
        _Ids(_given(room.openings, "rooms", place, "openings"))
    room_ids = _Ids(_given(scene.rooms, "rooms"))
    rooms = _named(scene.rooms, lambda room: room_ids.take(f"{room.type}_{room.index}"))
    body_ids = _Ids(_body_ids(scene))
    openings = {opening.id: opening for room in scene.rooms for opening in room.openings}  # both rooms of a door list it
    opening_ids = _Ids(_given([*openings.values()]))
    rooms = tuple(_filled(room, body_ids, opening_ids) for room in rooms)
    dynamic = _named(scene.dynamic, lambda body: body_ids.count(body.kind))
    return replace(scene, rooms=rooms, dynamic=dynamic)


def _check_levels(scene: Scene) -> None:
    found = set[int]()
    for place, level in enumerate(scene.levels):
        if level.index in found:
            raise _deep(Wrong(f"is {level.index}, which another level has too", "a number for each level"), "levels", place, "index")
        found.add(level.index)


def _body_ids(scene: Scene) -> Iterator[tuple[_Way, str]]:
    for place, room in enumerate(scene.rooms):
        yield from _given(room.furniture, "rooms", place, "furniture")
        yield from _given(room.decorations, "rooms", place, "decorations")
    yield from _given(scene.dynamic, "dynamic")


def _given(named: Sequence[Named], *way: str | int) -> Iterator[tuple[_Way, str]]:
    return (((*way, index), one.id) for index, one in enumerate(named))


def _filled(room: Room, bodies: _Ids, openings: _Ids) -> Room:
    return replace(
        room,
        openings=_named(room.openings, lambda item: openings.count(f"{room.id}/{item.kind}")),
        furniture=_named(room.furniture, lambda item: bodies.count(f"{room.id}/{item.name}")),
        decorations=_named(room.decorations, lambda item: bodies.count(f"{room.id}/{item.name}")),
    )


def check_outlines(scene: Scene) -> None:
    """Checks that outlines are rectilinear (to the micrometre) and enclose something, that openings are at their edges.

    Raises:
        Wrong: a line runs at an angle, or everything lies on one line; or an opening or a thickness is of an edge that is not there.
    """
    for place, room in enumerate(scene.rooms):
        try:
            _check_outline(room)
        except Wrong as wrong:
            raise wrong.inside(place).inside("rooms") from None


def _check_outline(room: Room) -> None:
    if room.outline is not None:
        _check_corners(room.outline)
    lines = len(room.outline or "nesw")
    if room.wall_thickness is not None and len(room.wall_thickness) > lines:
        raise Wrong(f"has {len(room.wall_thickness)} numbers", f"at most one for each of the room's {lines} lines").inside("wall_thickness")
    for index, opening in enumerate(room.openings):
        edges = len(room.outline or ())
        if opening.edge is not None and opening.edge >= edges:
            allowed = f"0 to {edges - 1}" if edges else "none: the room has no outline"
            raise Wrong(f"is {opening.edge}", allowed).inside("edge").inside(index).inside("openings")


def _check_corners(outline: tuple[tuple[float, float], ...]) -> None:
    corners = [(round(x * 1e6), round(z * 1e6)) for x, z in outline]
    for index, (x, z) in enumerate(corners):
        next_x, next_z = corners[(index + 1) % len(corners)]
        if (x, z) == (next_x, next_z):
            raise (
                Wrong("is the same corner as the next one", "corners that differ, the last from the first, too")
                .inside(index)
                .inside("outline")
            )
        if x != next_x and z != next_z:
            raise Wrong("begins a line that runs at an angle", "corners joined along x or z").inside(index).inside("outline")
    if doubled_area(corners) == 0:
        raise Wrong("encloses nothing", "at least 4 corners around some floor").inside("outline")
