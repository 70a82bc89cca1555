"""What an outline must be to be one."""

from __future__ import annotations

from solver.geometry import doubled_area
from solver.plain import Wrong
from solver.scene import Room, Scene


def check_outlines(scene: Scene) -> None:
    """Checks that outlines are rectilinear (to the micrometre) and enclose something, that openings are at their edges.

    Raises:
        Wrong: a line runs at an angle, or everything lies on one line; or an opening or a thickness is of an edge that is not there.
    """
    for place, room in enumerate(scene.rooms):
        try:
            _check_outline(room)
        except Wrong as wrong:
            raise wrong.inside(place).inside("rooms") from None


def _check_outline(room: Room) -> None:
    if room.outline is not None:
        _check_corners(room.outline)
    lines = len(room.outline or "nesw")
    if room.wall_thickness is not None and len(room.wall_thickness) > lines:
        raise Wrong(f"has {len(room.wall_thickness)} numbers", f"at most one for each of the room's {lines} lines").inside("wall_thickness")
    for index, opening in enumerate(room.openings):
        edges = len(room.outline or ())
        if opening.edge is not None and opening.edge >= edges:
            allowed = f"0 to {edges - 1}" if edges else "none: the room has no outline"
            raise Wrong(f"is {opening.edge}", allowed).inside("edge").inside(index).inside("openings")


def _check_corners(outline: tuple[tuple[float, float], ...]) -> None:
    corners = [(round(x * 1e6), round(z * 1e6)) for x, z in outline]
    for index, (x, z) in enumerate(corners):
        next_x, next_z = corners[(index + 1) % len(corners)]
        if (x, z) == (next_x, next_z):
            raise (
                Wrong("is the same corner as the next one", "corners that differ, the last from the first, too")
                .inside(index)
                .inside("outline")
            )
        if x != next_x and z != next_z:
            raise Wrong("begins a line that runs at an angle", "corners joined along x or z").inside(index).inside("outline")
    if doubled_area(corners) == 0:
        raise Wrong("encloses nothing", "at least 4 corners around some floor").inside("outline")
