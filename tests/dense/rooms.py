"""Seeded empty rooms of four types in the sizes people have, with doors and windows where they may be.

Comes in: a type and a seed. Goes out: a `Room` of the scene, 10 cm walls, doors to the outside. A second door only where
the type's area allows one (its catalog's minimum for two doors).
"""

from __future__ import annotations

from dataclasses import dataclass

from solver.geometry import Rect, strip
from solver.scene import EXTERIOR, WALLS, Opening, Room
from solver.streams import Stream

ASPECT = 1.6
DOOR_DEPTH_MM = 900
MARGIN_MM = 100
"""Between an opening and the end of its wall or the next opening."""
TRIES = 50


@dataclass(frozen=True)
class Kind:
    """A type of room: its ranges of area, m2, dense and tight, what two doors need, m2, and the width of its doors, mm.

    `cover` is how much of the floor people cover: a room's wish is drawn from it. `windows` are the least and greatest width
    of a window, mm; `sill` its height, m.
    """

    room_type: str
    dense: tuple[float, float]
    tight: tuple[float, float]
    two_doors: float
    short_side: float
    cover: tuple[float, float]
    door: int = 900
    windows: tuple[int, int] = (900, 1800)
    sill: float = 0.9


KINDS = {
    "bedroom": Kind("dense_bedroom", (9.0, 14.0), (6.5, 8.0), 7.5, 2.4, (0.40, 0.48)),
    "bathroom": Kind("dense_bathroom", (4.0, 7.0), (3.5, 7.0), 7.0, 2.0, (0.43, 0.49), door=800, windows=(500, 900), sill=1.3),
    "kitchen": Kind("dense_kitchen", (8.0, 14.0), (6.0, 9.0), 9.0, 2.4, (0.40, 0.47), windows=(800, 1400), sill=1.0),
    "living": Kind("dense_living_room", (15.0, 30.0), (9.0, 10.0), 9.0, 2.4, (0.31, 0.39)),
}


def dense_room(name: str, seed: int, tight: bool = False) -> Room:
    """Returns the room of a seed; `tight` draws near the type's minimum area and gives any room two doors as often."""
    kind = KINDS[name]
    least = 1.7 if tight and name == "bathroom" else kind.short_side
    return _room(kind, name, seed, (least, tight))


def drawn_room(kind: Kind, name: str, seed: int) -> Room:
    """Returns the room of a seed, of any kind; `name` tells its streams from others'."""
    return _room(kind, name, seed, (kind.short_side, False))


def _room(kind: Kind, name: str, seed: int, how: tuple[float, bool]) -> Room:
    least, tight = how
    stream = Stream(seed, "dense", f"{name}{'/tight' if tight else ''}")
    area = stream.uniform(*(kind.tight if tight else kind.dense))
    short = min(least, area**0.5)
    deep = max((area / stream.uniform(1.0, ASPECT)) ** 0.5, short)
    sides = (round(area / deep, 2), round(deep, 2))
    width, depth = sides if stream.chance(0.5) else sides[::-1]
    doors = 1 + (stream.chance(0.5) and (tight or area >= kind.two_doors))
    openings = _openings(Rect(0, 0, round(1000 * width), round(1000 * depth)), kind, stream, doors)
    return Room(f"{name}_{seed}", 0, kind.room_type, width=width, depth=depth, openings=openings)


def cover_wish(name: str, seed: int) -> float:
    """Returns the share of its floor that a seed's room wishes covered."""
    return Stream(seed, "dense", f"{name}/cover").uniform(*KINDS[name].cover)


def _openings(lines: Rect, kind: Kind, stream: Stream, doors: int) -> tuple[Opening, ...]:
    """Draws doors whose squares lie apart, then one or two windows, nothing over anything on one wall."""
    taken: list[tuple[str, int, int]] = []
    squares: list[Rect] = []
    found: list[Opening] = []
    wanted = [("door", kind.door)] * doors
    wanted += [
        ("window", kind.windows[0] + 10 * stream.below((kind.windows[1] - kind.windows[0]) // 10 + 1)) for _ in range(1 + stream.below(2))
    ]
    for sort, width in wanted:
        at = _free_place(lines, stream, (sort, width), taken, squares)
        if at is None:
            continue
        wall, start = at
        taken.append((wall, start, start + width))
        if sort == "door":
            squares.append(strip(lines, wall, (start, start + width), DOOR_DEPTH_MM))
        found.append(_opening(sort, len(found), wall, (start, width), kind))
    return tuple(found)


def _free_place(
    lines: Rect, stream: Stream, of: tuple[str, int], taken: list[tuple[str, int, int]], squares: list[Rect]
) -> tuple[str, int] | None:
    sort, width = of
    for _ in range(TRIES):
        wall = stream.pick(WALLS)
        low, high = lines.along(wall)
        low, high = low + 50 + MARGIN_MM, high - 50 - MARGIN_MM - width
        if high < low:
            continue
        start = low + 10 * stream.below((high - low) // 10 + 1)
        square = strip(lines, wall, (start, start + width), DOOR_DEPTH_MM)
        beside = all(wall != w or start >= b + MARGIN_MM or start + width <= a - MARGIN_MM for w, a, b in taken)
        if beside and not (sort == "door" and any(square.overlaps(other) for other in squares)):
            return wall, start
    return None


def _opening(sort: str, number: int, wall: str, span: tuple[int, int], kind: Kind) -> Opening:
    start, width = span
    position, wide = (start + width / 2) / 1000, width / 1000
    if sort == "door":
        return Opening(f"door_{number}", "door", wall, position, wide, connects_to=EXTERIOR, main_entrance=number == 0)
    return Opening(f"window_{number}", "window", wall, position, wide, 1.2, kind.sill, EXTERIOR)
