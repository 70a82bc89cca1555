"""`near_door`: within a distance of a door."""

from solver.relations.near import Near


class NearDoor(Near):
    """Is `near` a door."""

    about = ("door",)
