"""Single-room scenes of every room type: areas, aspects, doors and a window as a user might draw them."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass

from catalogs import load_catalogs
from solver import reroll
from solver.answers import Generated
from solver.scene import Opening, Room, Scene

SHORT_SIDE = 2.4
ASPECTS = (1.0, 1.5, 2.0)
DOOR_WALLS = (("south",), ("west",), ("south", "east"), ("south", "north"))
FACING = {"south": "north", "west": "east"}


@dataclass(frozen=True)
class Case:
    """One forced room: `share` is where along its wall each door's centre is; the window faces the first door."""

    room_type: str
    width: float
    depth: float
    doors: tuple[str, ...]
    share: float

    def __str__(self) -> str:
        where = "centred" if self.share == 0.5 else "off-centre"
        return f"{self.room_type} {self.width}x{self.depth} doors {'+'.join(self.doors)} {where}"

    def scene(self) -> Scene:
        """Returns the empty room as a scene."""
        known = load_catalogs().rooms[self.room_type]
        openings = [
            Opening(f"door_{k}", "door", wall, self._along(wall, 0.9), connects_to="EXTERIOR", main_entrance=k == 0)
            for k, wall in enumerate(self.doors)
        ]
        window_wall = next(w for w in ("north", "east", "west", "south") if w not in self.doors)
        middle = round(self._length(window_wall) / 2, 3)
        openings.append(Opening("window_0", "window", window_wall, middle, 1.2, 1.4, 0.9, "EXTERIOR"))
        room = Room(
            "room_0", 0, self.room_type, 0, 0.0, 0.0, self.width, self.depth, outdoor=known.outdoor,
            openings=tuple(openings),
        )  # fmt: skip
        return Scene(seed=7, wall_thickness=0.1, rooms=(room,))

    def furnished(self) -> Generated:
        """Furnishes the room through the public function."""
        return reroll(self.scene(), ["room_0"])

    def _length(self, wall: str) -> float:
        return self.width if wall in ("north", "south") else self.depth

    def _along(self, wall: str, width: float) -> float:
        length = self._length(wall)
        least = width / 2 + 0.1
        return round(min(max(length * self.share, least), length - least), 3)


def cases(room_types: list[str] | None = None) -> Iterator[Case]:
    """Yields every type at its minimum (by number of doors), typical and maximum area, 1:1, 1:1.5 and 1:2."""
    rooms = load_catalogs().rooms
    for name in room_types or sorted(rooms):
        area = rooms[name].area
        for doors, share in itertools.product(DOOR_WALLS, (0.5, 0.27)):
            sizes = [
                _size(square_metres, aspect)
                for square_metres in (area.min[min(len(doors), 2) - 1], area.typical, area.max)
                for aspect in ASPECTS
                if square_metres >= area.min[min(len(doors), 2) - 1]
            ]
            for width, depth in dict.fromkeys(sizes):
                yield Case(name, width, depth, doors, share)


def _size(area: float, aspect: float) -> tuple[float, float]:
    """Returns width and depth, m, no side shorter than SHORT_SIDE and no area smaller than asked."""
    depth = max(SHORT_SIDE, math.ceil(math.sqrt(area / aspect) * 100) / 100)
    return max(depth, math.ceil(area / depth * 100) / 100), depth
