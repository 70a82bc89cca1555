"""A room's openings, by kind."""

from __future__ import annotations

from solver.geometry import ALONG_X
from solver.pieces import Opened
from solver.relations.subject import Scope


def opened(scope: Scope, *kinds: str) -> list[Opened]:
    """Returns the room's openings of some kinds; passages are doors here, and so is the front door."""
    alike = {"door": ("door", "passage", "front_door")}
    return [one for kind in kinds for one in scope.openings if one.kind in alike.get(kind, (kind,))]


def middle_of(one: Opened) -> tuple[int, int]:
    """Returns the middle of an opening on its wall's line (x, z), mm."""
    along = sum(one.interval) // 2
    return (along, one.across) if one.wall in ALONG_X else (one.across, along)
