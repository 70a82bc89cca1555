"""What tells a room's type: its floor, doors and windows, what stands in it."""

from collections import Counter
from collections.abc import Iterable, Sequence, Set
from dataclasses import dataclass, replace
from typing import Final

from solver.guessing.doors_between import WAYS, doors_between
from solver.scene import EXTERIOR, Opening, Room

SMALL_WINDOW: Final = (1.2, 0.6)
"""A window with so high a sill, m, or of no more area, m2, is one of a bathroom."""
LEAST_M: Final = 0.001
"""As how long a side of a room counts that is shorter, m: there is a logarithm for every area."""


@dataclass(frozen=True)
class RoomMarks:
    """What can be told of a room without its type.

    Args:
        area: of its floor between wall lines, m2.
        short, long: sides of its bounding rectangle, m; `short` is that of its floor spread over the long side, where it has an outline.
        ways: the rooms it leads to, by their place in the list, and whether an opening without a leaf leads there.
        front: how its doors lead outside: "main", "door", or "" where none does.
        large, small: numbers of windows.
        pieces: what stands there, by the catalogs' names.
        behind: the one room through which one comes here from outside, by its place in the list; None where it is not one.
    """

    area: float
    short: float
    long: float
    ways: tuple[tuple[int, bool], ...]
    front: str
    large: int
    small: int
    garage_door: bool
    outdoor: bool
    pieces: frozenset[str]
    behind: int | None = None


def marks_of(rooms: Sequence[Room]) -> list[RoomMarks]:
    """Returns what can be told of each room; its furniture is under the catalogs' names."""
    joints = list(doors_between(rooms))
    ways, inner = _ways(joints, len(rooms)), {opening.id for _, _, opening in joints}
    found = [_marks(room, ways[k], inner) for k, room in enumerate(rooms)]
    return [replace(one, behind=behind) for one, behind in zip(found, _behind(found), strict=True)]


def _behind(marks: Sequence[RoomMarks]) -> list[int | None]:
    """Returns of each room the only one of its neighbours that is nearer to the main entrance, else to a door that leads outside."""
    fronts = [{k for k, one in enumerate(marks) if one.front == front} for front in ("main", "door")]
    steps: dict[int, int] = {}
    here = fronts[0] or fronts[1]
    while here:
        steps |= dict.fromkeys(here, len({*steps.values()}))
        here = {there for k in here for there, _ in marks[k].ways} - steps.keys()
    nearer = [[there for there, _ in one.ways if steps.get(there, k) < steps[k]] if k in steps else [] for k, one in enumerate(marks)]
    return [those[0] if len(those) == 1 else None for those in nearer]


def _ways(joints: Iterable[tuple[int, int, Opening]], count: int) -> list[dict[int, bool]]:
    """Returns where each room leads to: doors that one of two rooms lists lead both ways."""
    found: list[dict[int, bool]] = [{} for _ in range(count)]
    for here, there, opening in joints:
        is_open = opening.kind == "passage"
        for a, b in ((here, there), (there, here)):
            found[a][b] = found[a].get(b, False) or is_open
    return found


def _marks(room: Room, ways: dict[int, bool], inner: Set[str]) -> RoomMarks:
    """Returns what can be told of a room; a door between two rooms leads to the other, even where it says outside."""
    area = max(room.floor_m2, LEAST_M * LEAST_M)
    long = max(room.width, room.depth, LEAST_M)
    windows = Counter(_is_small(opening) for opening in room.openings if opening.kind == "window")
    outside = [opening for opening in room.openings if opening.connects_to == EXTERIOR and opening.id not in inner]
    doors = [opening for opening in outside if opening.kind in WAYS]
    front = "main" if any(opening.main_entrance for opening in doors) else "door" if doors else ""
    short = max(min(room.width, room.depth, area / long), LEAST_M)
    return RoomMarks(
        area, short, long, tuple(sorted(ways.items())), front, windows[False], windows[True],
        any(opening.kind == "garage_door" for opening in room.openings), room.outdoor, frozenset(piece.name for piece in room.furniture),
    )  # fmt: skip


def _is_small(window: Opening) -> bool:
    return window.sill >= SMALL_WINDOW[0] or window.width * window.height <= SMALL_WINDOW[1]
