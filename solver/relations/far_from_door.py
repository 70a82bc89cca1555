"""`far_from_door`: at least a distance from every door."""

from solver.relations.far_from import FarFrom


class FarFromDoor(FarFrom):
    """Is `far_from` every door."""

    about = ("door",)
