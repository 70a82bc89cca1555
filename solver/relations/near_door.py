"""`near_door`: within a distance of a door."""

from __future__ import annotations

from solver.relations.near import Near


class NearDoor(Near):
    """Is `near` a door."""

    about = ("door",)
