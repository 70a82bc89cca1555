"""Second step: how long the file's unit is, by what the file says or by how wide its doors are; so it is with scenes of ours, too."""

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from statistics import median
from typing import Any, Final, NamedTuple

from solver.answers import ALLOWED_UNITS, UNITS
from solver.errors import FieldError
from solver.imports.drawn import DrawnOpening, DrawnPlan, DrawnRoom, PlanNotes

DOOR_WIDTHS: Final = (0.7, 1.0)
"""Between these, m, lies the median width of a home's doors."""
POSSIBLE_DOORS: Final = (0.1, 10.0)
"""Where the median is not even between these, m, the file says a unit in which it is not drawn."""
LIKELY_ROOM: Final = (1.5, 8.0)
"""Between these, m, lies the median of the square roots of rooms' areas, where there are no doors to tell."""
LARGEST: Final = 100.0
"""Without doors no room is larger than a square of such sides, m, nor is the median room of a scene longer."""
LARGEST_ASSUMED: Final = 30.0
"""Nor is one than this where a usual door alone tells the unit."""
LIKELY_DOOR: Final = 0.9
"""So wide, m, are most doors, where no unit makes them so."""
LEAST_AREAS: Final = 2
"""So many rooms at least tell a unit by the areas that are written in them."""
NEARLY: Final = 0.06
"""By this share lengths that are taken from areas differ from one another: they are measured with or without plaster."""
SURELY: Final = 0.02
"""The same where rooms are drawn along walls' faces, as areas are, or nothing but a usual door tells the unit."""
FAR: Final = 0.25
"""Rooms along the lines of walls may be so much longer than what is written in them; a unit that has a name is kept within it."""
SQUARE_FOOT: Final = 0.3048**2
AREA: Final = re.compile(
    r"(?:\b[AF]\s*[:=]\s*)?(?<![\d.,])(?P<size>\d{1,4}(?:[.,]\d{1,3})?)\s*"
    r"(?:(?:m\s?[²2]|m\^2|㎡|qm|sq\.?\s?m|м\s?[²2]|кв\.?\s?м)(?![\w/])|(?P<feet>sq\.?\s?f(?:t|eet)|ft\s?[²2]|sf)(?!\w))\.?",
    re.IGNORECASE,
)
"""An area in a text: 24,5 m², 12.30 m2, 130 sq ft."""
DOORS: Final = "doors' median width"
GAPS: Final = "the median gap in walls"
ASSUMED: Final = "the file does not say how long its unit is"


class PlanUnit(NamedTuple):
    """The length of a plan's unit, m, None where nothing tells; what told it, where the file does not say it itself."""

    metres: float | None
    words: str = ""


def unit_named(word: str | None) -> float | None:
    """Returns the length of a unit by its name or as a number of metres; None for None.

    Raises:
        FieldError: it is neither.
    """
    if word is None:
        return None
    try:
        metres = UNITS[word] if word in UNITS else float(word)
    except ValueError:
        metres = math.nan
    if not 1e-6 <= metres <= 1000:
        raise FieldError("unit", f"is {word!r:.40}", ALLOWED_UNITS)
    return metres


def unit_of(plan: DrawnPlan, asked: str | None, notes: PlanNotes) -> float:
    """Returns the length of a plan's unit, m; what was guessed is noted.

    `asked` is what the caller says: a unit's name or a number of metres.

    Raises:
        FieldError: nobody says, and the doors do not tell.
    """
    said = unit_named(asked)
    if said is not None:
        return said
    metres, words = told_by_doors(plan.openings, plan.metres)
    if metres is None:
        metres, words = _by_rooms(plan)
    if words or plan.unit_words:
        taken = next((name for name, length in UNITS.items() if length == metres), f"{metres:.5g}")
        notes.guess("plan", "unit", taken, words or plan.unit_words)
    return metres


def _by_rooms(plan: DrawnPlan) -> tuple[float, str]:
    """Returns the unit in which rooms are as large as rooms, where there are no doors to tell; refuses a plan of none, or of several."""
    doors, sides = _doors(plan.openings), _sides(plan)
    size, told = (median(doors), DOORS) if doors else (median(sides) if sides else 0.0, "rooms' median side")
    found = [] if doors else _within(size, LIKELY_ROOM)
    if len(found) != 1:
        raise FieldError("unit", f"is not said, and cannot be told: {told} is {size:g}", ALLOWED_UNITS)
    return UNITS[found[0]], _told(found[0], size, told)


def check_size(plan: DrawnPlan, metres: float) -> None:
    """Refuses a plan whose rooms are larger than any in a unit, m, that no doors tell.

    Raises:
        FieldError: they are.
    """
    largest = max(_sides(plan), default=0.0) * metres
    is_assumed = plan.unit_words.startswith(ASSUMED)
    if largest > (LARGEST_ASSUMED if is_assumed else LARGEST) and (is_assumed or not _doors(plan.openings)):
        known = "assumed" if is_assumed else "told"
        raise FieldError("unit", f"is {known} to be {metres:.5g} m, in which the largest room has {largest**2:.0f} m2", ALLOWED_UNITS)


def _sides(plan: DrawnPlan) -> list[float]:
    return [room.area**0.5 for room in plan.rooms]


def told_by_doors(openings: Sequence[DrawnOpening], said: float | None) -> PlanUnit:
    """Returns the unit that is said, m; but where no door is so wide, or none is said, the one in which doors are as wide as doors."""
    doors = _doors(openings)
    if not doors or (said is not None and POSSIBLE_DOORS[0] <= median(doors) * said <= POSSIBLE_DOORS[1]):
        return PlanUnit(said)
    found = _within(median(doors), DOOR_WIDTHS)
    if len(found) != 1:
        return PlanUnit(said)
    (name,), metres, size = found, UNITS[found[0]], median(doors)
    if said is None:
        return PlanUnit(metres, _told(name, size, DOORS))
    return PlanUnit(
        metres, f"the file says a unit of {said:.5g} m, but {DOORS} would be {size * said:.3g} m; it is {size * metres:.2f} m in {name}"
    )


def without_area(words: str) -> tuple[str, float]:
    """Returns a text without the area in it, and that, m2; 0 where it says none."""
    found = AREA.search(words)
    if not found:
        return words, 0.0
    return AREA.sub("", words), float(found["size"].replace(",", ".")) * (SQUARE_FOOT if found["feet"] else 1.0)


def told_by_areas(rooms: Sequence[tuple[float, float]], plan: DrawnPlan) -> PlanUnit | None:
    """Returns the unit in which rooms are as large as what is written in them, if most agree on one, and that is not the plan's.

    Each room is given by its area as it is drawn and as it is written, m2.
    """
    lengths = [math.sqrt(said / drawn) for drawn, said in rooms if drawn]
    if len(lengths) < LEAST_AREAS:
        return None
    is_sure = plan.drawn == "inner" or plan.unit_words.startswith(ASSUMED)
    middle, within = median(lengths), FAR if plan.metres in UNITS.values() else SURELY if is_sure else NEARLY
    alike = sum(abs(one - middle) <= NEARLY * middle for one in lengths)
    metres = next((length for length in UNITS.values() if abs(length - middle) <= within * length), middle)
    if 3 * alike < 2 * len(lengths) or abs((plan.metres or 0.0) - metres) <= within * metres:
        return None
    return PlanUnit(metres, f"in a unit of {metres:.5g} m {alike} rooms are as large as what is written in them")


def assumed(openings: Sequence[DrawnOpening], told: str = DOORS) -> PlanUnit:
    """Returns the length in which the median opening is as wide as most doors, for drawings in a length of their own, such as pixels."""
    doors = [math.dist(one.start, one.end) for one in openings if one.kind in ("door", "passage")]
    if not doors or not median(doors):
        return PlanUnit(None)
    words = f"{ASSUMED}; {told} is taken as {LIKELY_DOOR:.2f} m, `unit` says another length"
    return PlanUnit(LIKELY_DOOR / median(doors), words)


def _doors(openings: Sequence[DrawnOpening]) -> list[float]:
    return [math.dist(one.start, one.end) for one in openings if one.kind == "door"]


def _told(name: str, size: float, told: str) -> str:
    return f"the file does not say its unit; {told} is {size * UNITS[name]:.2f} m in {name}"


def _within(size: float, limits: tuple[float, float]) -> list[str]:
    return [name for name, metres in UNITS.items() if limits[0] <= size * metres <= limits[1]]


LENGTHS: Final = frozenset(("x", "y", "z", "width", "depth", "height", "position", "sill", "elevation", "outline", "wallthickness", "slab"))
"""Keys of lengths, without what parts their words."""
FARTHEST: Final = 1e9


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
