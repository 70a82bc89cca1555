"""The rule `missing_required`: a piece that a room's type requires is not there."""

from collections.abc import Iterator, Mapping
from typing import Any, Final

from catalogs.schema import RoomType
from solver.body_rows import furniture_names
from solver.validator.judging import Finding, RuleCase
from solver.validator.world import PlacedRoom

_UNKNOWN: Final = "no reason is recorded"
_EMPTY: Final = "nothing stands in the room yet"
_AS_SENT: Final = "its furniture came with the scene as it is"
"""No certificate tells of the room: a plan's file, or a person, furnished it, or nobody did."""
_NEVER_TRIED: Final = "it was not asked for, or was taken away"
"""The certificate tells of the room what was left out, and not this."""


def missing_required(case: RuleCase) -> Iterator[Finding]:
    """A required piece is not there; the reason is what the scene's certificate gives, or that it tells nothing of the room."""
    place = case.room
    known = case.kinds.rooms.get(place.room.type)
    if known is None or not known.requires:
        return
    there = furniture_names(place.room)
    for line in known.requires:
        if any(there.count(name) >= count for name, count in line.items()):
            continue
        wanted = " or ".join(name if count == 1 else f"{count} {name}" for name, count in line.items())
        reason = _reason(case.world.scene.certificate, place, _labels(known, line))
        have = sum(map(there.count, line))
        short = f"has only {have} of {wanted}" if have else f"has no {wanted}"
        yield Finding((), 0, f"{place.room.id} ({place.room.type}) {short}: {reason}")


def _labels(known: RoomType | None, names: Mapping[str, int]) -> set[str]:
    """Returns under which labels of the room type a requirement may have been left out."""
    pieces = known.pieces if known else ()
    of_these = {piece.piece for piece in pieces if any(variant.kind in names for variant in piece.variants)}
    return of_these | set(names)


def _reason(certificate: Mapping[str, Any] | None, place: PlacedRoom, labels: set[str]) -> str:
    """Finds why a piece was left out, whatever shape the certificate of a foreign scene has."""
    rooms = (certificate or {}).get("rooms")
    entry = rooms.get(place.room.id) if isinstance(rooms, Mapping) else None
    if entry is None:
        return _AS_SENT if place.room.furniture else _EMPTY
    left_out = entry.get("left_out") if isinstance(entry, Mapping) else None
    if not isinstance(left_out, (list, tuple)) or not all(isinstance(item, Mapping) for item in left_out):
        return _UNKNOWN
    of_these = [item for item in left_out if _stem(item.get("piece")) in labels]
    if not of_these:
        return _NEVER_TRIED
    return next((str(item["reason"]) for item in of_these if item.get("reason")), _UNKNOWN)


def _stem(label: object) -> str:
    """Takes the number off a label: `bed_1` was wanted as `bed`."""
    head, _, tail = str(label).rpartition("_")
    return head if head and tail.isdigit() else str(label)
