"""The free floor of a room: where somebody can be, and whether everything stays within reach while they are there.

Within reach is exact, by the core: solver/core/floor/free_floor.hpp.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from struct import Struct
from typing import Final, NamedTuple

from solver.core import borrowed
from solver.free_places import FLAT_MM, RECT_BYTES, Block, decorations_in, furniture_in, nearest_place, rect_rows
from solver.geometry import Rect, wall_faced
from solver.pieces import Space
from solver.scene import WALLS, Room

HEADROOM_MM: Final = 2000
"""What hangs higher is walked under: the height of a door."""
WALL_NUMBERS: Final = {wall: number for number, wall in enumerate(WALLS)}
"""As the core numbers them."""
DOORWAY: Final = Struct("<2i4q")
"""A doorway as the core reads it: its wall, and behind an unused number its square."""
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

    `bodies` are the footprints of what stands in the way of walking, mm, `blocks` is what nobody can be in.
    """

    def __init__(self, space: Space, bodies: Iterable[Rect], goals: Iterable[Goal], blocks: Iterable[Block] = ()) -> None:
        self.space, self.blocks = space, list(blocks)
        self._goals = b"".join([goal.row() for goal in goals])
        self._bodies = rect_rows([*bodies, *(zone.rect for zone in space.zones if zone.cause == "outline")])
        outer, through = space.walked
        self._outer, self._doors = len(outer), len(outer) + len(through)
        self._doorways = b"".join([DOORWAY.pack(WALL_NUMBERS[door.wall], 0, *door.square) for door in (*outer, *through)])
        self._taken: dict[tuple[float, float], bytes] = {}

    @classmethod
    def of_room(cls, room: Room, space: Space, uses: Mapping[str, tuple[Sequence[str], bool]]) -> "FreeFloor":
        """Returns the floor of a furnished room without its people.

        `uses` are by name of piece the sides it is used from, and whether all of them have to be within reach.
        """
        furniture = furniture_in(room)
        goals = [
            Goal(piece.block.rect, tuple(wall_faced(side, piece.rotation) for side in sides), need_all)
            for piece in furniture
            for sides, need_all in [uses.get(piece.key[1], ((), False))]
            if sides
        ]
        high = [one for one in (*furniture, *decorations_in(room)) if one.key[4] * 1000 > FLAT_MM]
        kept_free = [Block(zone.rect, -math.inf, math.inf) for zone in space.zones if zone.above_mm < 0]
        standing = (one.block for one in high if one.key[0] == "furniture" or not one.rests)
        in_the_way = [block.rect for block in standing if block.low < HEADROOM_MM]
        return cls(space, in_the_way, goals, [*kept_free, *(one.block for one in high)])

    def add(self, block: Block, in_the_way: bool = True, is_goal: bool = False) -> None:
        """Notes that somebody or something is there; who sits is not in the way of those who walk.

        `is_goal`: it has to be come to, from any side.
        """
        self.blocks.append(block)
        self._taken.clear()
        if in_the_way:
            self._bodies += rect_rows([block.rect])
        if is_goal:
            self._goals += Goal.beside(block.rect).row()

    def obstacles(self, own: Block) -> list[Rect]:
        """Returns what is taken at the heights of a body."""
        low, high = own.low, own.high
        return [rect for rect, bottom, top, _ in self.blocks if bottom < high and low < top]

    def nearest(self, own: Block, gap_mm: int = 0) -> Rect | None:
        """Returns the free place nearest to a body with a gap all around, the gap included, or None where there is none."""
        heights = own.low, own.high
        if heights not in self._taken:
            self._taken[heights] = rect_rows(self.obstacles(own))
        return nearest_place(own.rect.shrunk(-gap_mm), self.space.clear, self._taken[heights])

    def is_free(self, own: Block, but: str) -> bool:
        """Tells whether a space is empty, the body of one id aside."""
        others = (block for block in self.blocks if block.id != but)
        return not any(own.rect.overlaps(block.rect) and block.between(own.low, own.high) for block in others)

    def connects(self, more: Sequence[Rect] = (), goals: Sequence[Goal] = ()) -> bool:
        """Tells whether one component of the floor meets every door and every goal, and is 0.25 m2 of centres.

        What meets doors that lead outside is one component, and one of these doors is enough. `more` are footprints, mm, and `goals` goals
        besides its own.
        """
        bodies, asked = self._bodies + rect_rows(more), b"".join([self._goals, *(goal.row() for goal in goals)])
        counts = len(bodies) // RECT_BYTES, self._doors, len(asked) // _GOAL.size
        header = _FLOOR.pack(*self.space.clear, self.space.robot_mm, *counts, self._outer)
        request = b"".join([header, bodies, self._doorways, asked])
        with borrowed() as core:
            return bool(core.call("connects", core.write(request), len(request)))


def sides_seen(walls: Iterable[str]) -> int:
    """Returns walls as the core reads them: a bit for each."""
    seen = 0
    for wall in walls:
        seen |= 1 << WALL_NUMBERS[wall]
    return seen
