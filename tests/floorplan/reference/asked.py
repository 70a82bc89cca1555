"""What walls ask of the search, mm: the width of hallways between lines, of axial ones, and the shortest shared wall that takes a door."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from solver.floorplan.programme.home_search import CENTRE_MM
from solver.floorplan.tiling import USUAL_WALLS, HouseWalls

_walls = [USUAL_WALLS]


@contextmanager
def between(walls: HouseWalls) -> Iterator[None]:
    """Has homes be searched for between such walls for a block."""
    _walls.append(walls)
    yield
    _walls.pop()


def hallway() -> int:
    """How wide a hallway is."""
    return _walls[-1].hallway


def centre() -> int:
    """How wide an axial hallway is."""
    return CENTRE_MM + _walls[-1].more


def door_wall() -> int:
    """How long a shared wall is that takes a door."""
    return _walls[-1].door_wall
