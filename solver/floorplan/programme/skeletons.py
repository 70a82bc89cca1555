"""Skeletons: which of them suit a programme, and which outlines they make.

What each is like: solver/core/homes/drafts.hpp.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from solver.floorplan.programme.planned_rooms import PlannedRoom

TWO_WINGS: Final = 4
"""Least private rooms of a home with two wings."""


def kinds_for(planned: Sequence[PlannedRoom]) -> tuple[str, ...]:
    """Returns the skeletons that suit a programme: by how many rooms need a hallway, and whether cars come in.

    Where rows suit, the others are only for homes that rows fail.

    The ranch stands thrice: it is drawn more often than the others, whose hallways are half as long again.
    """
    private = sum(not one.kind.plan.way_through and one.owner is None and not one.garage for one in planned)
    sleeping = sum(one.kind.plan.habitable and not one.public for one in planned)
    if sleeping <= 1 and private <= 3:
        return ("rows", "full", "ranch") if any(one.garage for one in planned) else ("rows", "full")
    public = sum(one.public for one in planned)
    kinds = ["full"]
    if public >= 2:
        kinds += ["ranch"] * 3
    if not any(one.garage for one in planned) and any(one.entry for one in planned):
        kinds.append("axial")
    return tuple(kinds)


def outlines_for(planned: Sequence[PlannedRoom]) -> tuple[str, ...]:
    """Returns the outlines that a programme's home may have."""
    kinds = kinds_for(planned)
    if kinds[0] == "rows":
        return ("rectangle", "L", "T")
    if "ranch" not in kinds:
        return ("rectangle",)
    private = sum(not one.public and not one.entry and not one.garage and one.owner is None for one in planned)
    return ("rectangle", "L", "T", "U") if private >= TWO_WINGS else ("rectangle", "L", "T")


def bent_kind(planned: Sequence[PlannedRoom], outline: str) -> str:
    """Returns the skeleton that makes an outline which is no rectangle."""
    if outline == "U":
        return "winged"
    return "rows" if kinds_for(planned)[0] == "rows" else "ranch"
