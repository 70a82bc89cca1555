"""What lies on what: a room's bodies in sections, each followed by what it carries."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Final, NamedTuple

from solver.scene import Decoration, Dynamic, Furniture, Room, Scene
from solver.scene_bodies import home_of

DEEPEST: Final = 6
"""How many levels of things on things are indented; what lies deeper is shown at the last. Our choice."""

ShownBody = Furniture | Decoration | Dynamic


class Section(NamedTuple):
    """Bodies under one title, none of them lying on another."""

    title: str
    bodies: Sequence[ShownBody]


def sections(room: Room, people: Sequence[Dynamic], carried: Mapping[str, Sequence[Decoration]]) -> Iterator[Section]:
    """Yields the sections of a room that are not empty."""
    hanging = _carried_ids(room, carried)
    free = [item for item in room.decorations if item.id not in hanging]
    every = (
        Section("furniture", room.furniture),
        Section("wall_decorations", [item for item in free if item.mounted_on_wall]),
        Section("floor_decorations", [item for item in free if not item.mounted_on_wall]),
        Section("dynamic", people),
    )
    yield from (section for section in every if section.bodies)


def strangers(scene: Scene) -> list[Dynamic]:
    """Returns the people and pets that are in no room of the scene."""
    known = {room.id for room in scene.rooms}
    return [person for person in scene.dynamic if home_of(scene, person) not in known]


def carried_by(room: Room) -> dict[str, list[Decoration]]:
    """Returns the decorations that lie on each body of the room."""
    bodies = {piece.id for piece in room.furniture} | {item.id for item in room.decorations}
    carried: dict[str, list[Decoration]] = {}
    for item in room.decorations:
        if item.parent in bodies and item.parent is not None:
            carried.setdefault(item.parent, []).append(item)
    return carried


def _carried_ids(room: Room, carried: Mapping[str, Sequence[Decoration]]) -> set[str]:
    """Returns what hangs together with a piece or with a free decoration; a ring of parents carries nothing."""
    roots: list[str] = [piece.id for piece in room.furniture]
    inner = {item.id for items in carried.values() for item in items}
    roots += [item.id for item in room.decorations if item.id not in inner]
    found: set[str] = set()
    while roots:
        for item in carried.get(roots.pop(), ()):
            found.add(item.id)
            roots.append(item.id)
    return found


def together(body: ShownBody, carried: Mapping[str, Sequence[Decoration]], shown: set[str]) -> Iterator[tuple[int, ShownBody]]:
    """Yields a body and everything on it, each after what carries it, with its depth; `shown` keeps what was yielded."""
    stack: list[tuple[int, ShownBody]] = [(0, body)]
    while stack:
        depth, item = stack.pop()
        if item.id not in shown:
            shown.add(item.id)
            yield depth, item
            stack += [(min(depth + 1, DEEPEST), child) for child in reversed(carried.get(item.id, ()))]


def remarks(body: ShownBody) -> Iterator[str]:
    """Says what else a body is to the room: on which wall, under or on what, locked."""
    if isinstance(body, Decoration) and body.mounted_on_wall:
        yield f"mounted on {body.mounted_on_wall} wall"
    if isinstance(body, Furniture) and body.under:
        yield f"under {body.under}"
    if isinstance(body, Furniture | Dynamic) and body.on:
        yield f"on {body.on}"
    if isinstance(body, Furniture) and body.locked:
        yield "locked"
