"""How a floor plan treats a room type."""

from __future__ import annotations

from typing import Annotated

from catalogs.entries import ROOM_TYPE, Entry, Metres


class KeptWall(Entry):
    """A stretch of wall that a floor plan keeps whole where it can, by moving openings along their walls.

    `length` along the wall and `depth` of the floor before it, m, without doors and the squares that stay free at them.
    `under_windows`: windows do not break it. `round_corners`: it may go round one corner. `across`: it faces such a stretch of the
    opposite wall, which is at most so far away; in rooms whose walls are all farther apart that is not asked.
    """

    length: Metres
    depth: Metres
    under_windows: bool = False
    round_corners: bool = False
    across: Metres | None = None


class Plan(Entry):
    """How a floor plan treats the type.

    `habitable`: wants daylight. `wet`: wants its pipes beside other wet rooms. `way_through`: one may walk through it to
    other rooms. `entrance`: the front door may open into it, lower numbers first. `street`: needs an outside wall.
    `swings_in`: leaves open into it (not into hallways). `behind`: types it may lie behind, besides a way through.
    """

    habitable: bool = False
    wet: bool = False
    way_through: bool = False
    entrance: int | None = None
    street: bool = False
    swings_in: bool = True
    passage: bool = False
    """Between two rooms with `passage` an opening without a leaf is cut instead of a door."""
    behind: tuple[Annotated[str, ROOM_TYPE], ...] = ()
    windows: bool = True
    garage_door: bool = False
    keeps: tuple[KeptWall, ...] = ()
    """Walls that are kept whole for what stands along them."""
