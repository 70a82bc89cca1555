"""How numbers, names and sizes are written for a person, each on one line."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from solver.certificate import true_of
from solver.scene import EXTERIOR, Opening, Scene


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
