"""What both views of a scene share: how words, numbers and sizes are written for a person, and what lies on what."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

from solver.certificate import true_of
from solver.scene import EXTERIOR, Decoration, Dynamic, Furniture, Opening, Room, Scene
from solver.scene_bodies import home_of


@dataclass(frozen=True)
class TextLine:
    """A line of text and the id of the body it shows."""

    text: str
    shows: str | None = None


def written(lines: Sequence[TextLine]) -> tuple[str, tuple[str | None, ...]]:
    """Returns the text of the lines, and for each of them the id of the body it shows, or None."""
    return "\n".join(line.text for line in lines) + "\n", tuple(line.shows for line in lines)


def number(metres: float) -> str:
    """Writes metres to the millimetre, without needless zeros."""
    return f"{metres:.3f}".rstrip("0").rstrip(".")


def decimal(metres: float) -> str:
    """Writes metres with at least one digit after the point."""
    written = number(metres + 0.0)
    return written if "." in written else f"{written}.0"


def visible(value: Any) -> str:
    """Writes what a line may hold: everything printable, so that a name is never two lines."""
    return "".join(letter if letter.isprintable() else f"\\U{ord(letter):08x}" for letter in str(value))


def target_of(opening: Opening) -> str:
    """Says where a door or passage leads."""
    return "outside" if opening.connects_to == EXTERIOR else opening.connects_to or "nowhere given"


def room_certificates(scene: Scene) -> dict[str, Mapping[str, Any]]:
    """Returns what the certificate says that still is true of each room, whatever shape that of a foreign scene has."""
    entries = (scene.certificate or {}).get("rooms")
    if not isinstance(entries, Mapping):
        return {}
    rooms = {room.id: room for room in scene.rooms}
    known = {str(name): entry for name, entry in entries.items() if isinstance(entry, Mapping)}
    return {name: true_of(rooms[name], entry) if name in rooms else entry for name, entry in known.items()}


def is_changed(entry: Mapping[str, Any]) -> bool:
    """Tells whether a room's part of the certificate spoke of furniture as it stands no longer."""
    return "of" in entry and "proven" not in entry


def proofs(scene: Scene) -> str:
    """Says in how many rooms the placement is proven optimal; empty where nothing is known. Rooms left as they were have notes alone."""
    entries = [entry for entry in room_certificates(scene).values() if entry.keys() != {"notes"}]
    if not entries:
        return ""
    changed = sum(map(is_changed, entries))
    proven = f"proven optimal in {sum(entry.get('proven') is True for entry in entries)} of {len(entries)} rooms"
    return proven + (f", {changed} changed since" if changed else "")


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
