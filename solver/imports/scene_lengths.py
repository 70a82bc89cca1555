"""Scenes of ours that others wrote in another unit than metres: told by their doors, else by their rooms, as other plans are.

Comes in: a scene as a document. Goes out: its unit, the document in metres. May import: drawn, units.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final

from solver.imports.drawn import DrawnOpening, DrawnPlan, DrawnRoom, PlanNotes
from solver.imports.units import unit_of

LENGTHS: Final = frozenset(("x", "y", "z", "width", "depth", "height", "position", "sill", "elevation", "outline", "wallthickness", "slab"))
"""Keys of lengths, without what parts their words."""
FARTHEST: Final = 1e9
LARGEST: Final = 100.0
"""The median room of a scene without doors is no wider, m."""


def scene_unit(document: Mapping[str, Any], asked: str | None, notes: PlanNotes) -> float:
    """Returns the length of a scene's unit, m; where it is not 1 that is noted.

    Raises:
        FieldError: it is none that its doors or rooms tell.
    """
    rooms = list(_parts(document, "rooms"))
    sides = [(one["width"], one["depth"]) for one in rooms if _is_number(one.get("width")) and _is_number(one.get("depth"))]
    widths: list[Any] = [one.get("width") for room in rooms for one in _parts(room, "openings") if one.get("kind", "door") == "door"]
    doors = tuple(DrawnOpening("door", (0.0, 0.0), (width, 0.0), "") for width in widths if _is_number(width))
    drawn = tuple(DrawnRoom(((0.0, 0.0), (x, 0.0), (x, z), (0.0, z)), "", "") for x, z in sides)
    is_told = bool(doors) or all(min(one) <= LARGEST for one in sides)
    return unit_of(DrawnPlan(drawn, doors, metres=1.0 if is_told else None), asked, notes)


def in_metres(value: Any, metres: float, is_length: bool = False) -> Any:
    """Returns a document whose lengths are in another unit with all of them in m."""
    if isinstance(value, Mapping):
        return {key: in_metres(one, metres, "".join(str(key).split("_")).lower() in LENGTHS) for key, one in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [in_metres(one, metres, is_length) for one in value]
    return round(value * metres, 6) if is_length and _is_number(value) else value


def _parts(document: Mapping[str, Any], key: str) -> Iterator[Mapping[str, Any]]:
    found = document.get(key)
    yield from (one for one in found if isinstance(one, Mapping)) if isinstance(found, Sequence) else ()


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < FARTHEST
