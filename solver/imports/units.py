"""Second step: how long the file's unit is, by what the file says or by how wide its doors are."""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import median
from typing import Final

from solver.errors import FieldError
from solver.geometry import doubled_area
from solver.imported import ALLOWED_UNITS, UNITS
from solver.imports.drawn import DrawnOpening, DrawnPlan, PlanNotes

DOOR_WIDTHS: Final = (0.7, 1.0)
"""Between these, m, lies the median width of a home's doors."""
POSSIBLE_DOORS: Final = (0.1, 10.0)
"""Where the median is not even between these, m, the file says a unit in which it is not drawn."""
LIKELY_ROOM: Final = (1.5, 8.0)
"""Between these, m, lies the median of the square roots of rooms' areas, where there are no doors to tell."""


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
    doors = [math.dist(one.start, one.end) for one in plan.openings if one.kind == "door"]
    if plan.metres is not None:
        return _corrected(plan.metres, plan.unit_words, median(doors) if doors else None, notes)
    if doors:
        found, told, size = _within(median(doors), DOOR_WIDTHS), "doors' median width", median(doors)
    else:
        sides = [(abs(doubled_area(room.points)) / 2) ** 0.5 for room in plan.rooms]
        size = median(sides) if sides else 0.0
        found, told = _within(size, LIKELY_ROOM), "rooms' median side"
    if len(found) != 1:
        raise FieldError("unit", f"is not said, and cannot be told: {told} is {size:g}", ALLOWED_UNITS)
    notes.guess("plan", "unit", found[0], f"the file does not say its unit; {told} is {size * UNITS[found[0]]:.2f} m in {found[0]}")
    return UNITS[found[0]]


def _corrected(metres: float, words: str, door: float | None, notes: PlanNotes) -> float:
    """Returns the length of the unit that a file says, m; where no door is so wide, of the one in which doors are as wide as doors."""
    other = None if door is None or _may_be(door * metres) else _one_within(door)
    if other is not None and door is not None:
        said = f"the file says a unit of {metres:.5g} m, but doors' median width would be {door * metres:.3g} m"
        notes.guess("plan", "unit", other, f"{said}; it is {door * UNITS[other]:.2f} m in {other}")
        return UNITS[other]
    if words:
        notes.guess("plan", "unit", f"{metres:.5g}", words)
    return metres


def told_by_doors(openings: Sequence[DrawnOpening], said: float | None) -> float | None:
    """Returns the length of the unit, m: what is said, but where no door is so wide the one in which doors are as wide as doors."""
    doors = [math.dist(one.start, one.end) for one in openings if one.kind == "door"]
    if not doors or (said is not None and _may_be(median(doors) * said)):
        return said
    found = _one_within(median(doors))
    return said if found is None else UNITS[found]


def _may_be(door: float) -> bool:
    """Tells whether doors' median width may be so many metres."""
    return POSSIBLE_DOORS[0] <= door <= POSSIBLE_DOORS[1]


def _one_within(door: float) -> str | None:
    """Returns the one unit in which a door is as wide as doors, None where there is none or more."""
    found = _within(door, DOOR_WIDTHS)
    return found[0] if len(found) == 1 else None


def _within(size: float, limits: tuple[float, float]) -> list[str]:
    return [name for name, metres in UNITS.items() if limits[0] <= size * metres <= limits[1]]
