"""The free floor of a room: where somebody can be, and whether everything stays within reach while they are there.

Within reach is exact, by the core: solver/core/floor/free_floor.hpp.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from struct import Struct
from typing import Final, NamedTuple

from solver.body_rows import BODY, furniture_names, furniture_turns
from solver.core import ask, borrowed
from solver.free_places import RECT, Block, decorations_as_told, furniture_as_told, nearest_place, rect_rows
from solver.geometry import Rect, wall_faced
from solver.pieces import DOORWAY, Space
from solver.scene import WALL_NUMBERS, WALLS, Room

HEADROOM_MM: Final = 2000
"""What hangs higher is walked under: the height of a door."""
_FLOOR: Final = Struct("<5q4i")
_GOAL: Final = Struct("<4q2i")


class Goal(NamedTuple):
    """Something to come to: a body's footprint, mm, and the walls its sides look to; any of them, or `all`."""

    rect: Rect
    sides: tuple[str, ...]
    need_all: bool = False

    @classmethod
    def beside(cls, rect: Rect) -> "Goal":
        """Returns somebody or something that may be come to from any side."""
        return cls(rect, WALLS)

    def row(self) -> bytes:
        """Returns it as the core reads it."""
        return _GOAL.pack(*self.rect, sides_seen(self.sides), self.need_all)


class FreeFloor:
    """What a room's furniture leaves free, and what has to stay within reach over it: doors and use sides, the `goals`.

    `bodies` are the footprints of what stands in the way of walking, mm, `blocks` is what nobody can be in, `goals` are rows. `room` is one
    whose furniture and small things are in the way, too.
    """

    def __init__(
        self, space: Space, bodies: Iterable[Rect], goals: Iterable[Goal], blocks: Iterable[Block] = (), room: Room | None = None
    ) -> None:
        self.space, self._blocks = space, list(blocks)
        self._told = (furniture_as_told(room), decorations_as_told(room)) if room else (b"", b"")
        self._goals = b"".join([goal.row() for goal in goals])
        self._bodies = rect_rows([*bodies, *(zone.rect for zone in space.zones if zone.cause == "outline")])
        self._bodies += self._taken_between(-math.inf, HEADROOM_MM, loose=True)
        self._taken: dict[tuple[float, float], bytes] = {}

    @classmethod
    def of_room(cls, room: Room, space: Space, uses: Mapping[str, tuple[Sequence[str], bool]]) -> "FreeFloor":
        """Returns the floor of a furnished room without its people.

        `uses` are by name of piece the sides it is used from, and whether all of them have to be within reach.
        """
        kept_free = [Block(zone.rect, -math.inf, math.inf) for zone in space.zones if zone.above_mm < 0]
        return cls(space, (), _goals_in(room, uses), kept_free, room)

    def _taken_between(self, low: float, high: float, loose: bool = False) -> bytes:
        """Returns the footprints of the room's bodies that are between two heights; `loose`: of things those on the floor."""
        return ask("taken_between", *self._told, numbers=[low, high, loose]) if any(self._told) else b""

    def add(self, block: Block, in_the_way: bool = True, is_goal: bool = False) -> None:
        """Notes that somebody or something is there; who sits is not in the way of those who walk.

        `is_goal`: it has to be come to, from any side.
        """
        self._blocks.append(block)
        self._taken.clear()
        if in_the_way:
            self._bodies += rect_rows([block.rect])
        if is_goal:
            self._goals += Goal.beside(block.rect).row()

    def obstacles(self, own: Block) -> list[Rect]:
        """Returns what is taken at the heights of a body."""
        return [Rect(*row) for row in RECT.iter_unpack(self._taken_at(own))]

    def _taken_at(self, own: Block) -> bytes:
        low, high = own.low, own.high
        known = self._taken.get((low, high))
        if known is None:
            rects = [rect for rect, bottom, top, _ in self._blocks if bottom < high and low < top]
            known = self._taken[low, high] = rect_rows(rects) + self._taken_between(low, high)
        return known

    def nearest(self, own: Block, gap_mm: int = 0) -> Rect | None:
        """Returns the free place nearest to a body with a gap all around, the gap included, or None where there is none."""
        return nearest_place(own.rect.shrunk(-gap_mm), self.space.clear, self._taken_at(own))

    def is_free(self, own: Block, but: Block) -> bool:
        """Tells whether a space is empty, one of the bodies there aside."""
        taken = self.obstacles(own)
        if but.between(own.low, own.high) and but.rect in taken:
            taken.remove(but.rect)
        return not any(map(own.rect.overlaps, taken))

    def connects(self, more: Sequence[Rect] = (), goals: Sequence[Goal] = ()) -> bool:
        """Tells whether one component of the floor meets every door and every goal, and is 0.25 m2 of centres.

        What meets doors that lead outside is one component, and one of these doors is enough. `more` are footprints, mm, and `goals` goals
        besides its own.
        """
        bodies, asked = self._bodies + rect_rows(more), b"".join([self._goals, *(goal.row() for goal in goals)])
        doorways = self.space.rows[1]
        counts = len(bodies) // RECT.size, len(doorways) // DOORWAY.size, len(asked) // _GOAL.size
        header = _FLOOR.pack(*self.space.clear, self.space.robot_mm, *counts, self.space.outer)
        request = b"".join([header, bodies, doorways, asked])
        with borrowed() as core:
            return bool(core.call("connects", core.write(request), len(request)))


def _goals_in(room: Room, uses: Mapping[str, tuple[Sequence[str], bool]]) -> Iterator[Goal]:
    """Yields what has to be come to of a room's furniture."""
    rows = BODY.iter_unpack(furniture_as_told(room))
    for name, (_, rotation), row in zip(furniture_names(room), furniture_turns(room), rows, strict=True):
        if name in uses:
            sides, need_all = uses[name]
            yield Goal(Rect(*row[8:12]), tuple(wall_faced(side, rotation) for side in sides), need_all)


def sides_seen(walls: Iterable[str]) -> int:
    """Returns walls as the core reads them: a bit for each."""
    seen = 0
    for wall in walls:
        seen |= 1 << WALL_NUMBERS[wall]
    return seen
