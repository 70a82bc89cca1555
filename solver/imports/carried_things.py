"""Small things of a foreign plan -> what carries each: the top it lies on, the piece it lies in, or the wall behind it."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

from solver.geometry import ALONG_X, INWARDS, WALL_BEHIND, to_mm, walls_round
from solver.scene import Decoration, Furniture, Room, WallName

RESTING: Final = 0.06
"""A thing whose underside is so near another's top, m, stands on it."""
LYING: Final = 0.01
"""Where it stands in a piece, m."""
HANGING: Final = 0.1
"""A thing above the floor whose back is so near a wall's face, m, hangs there."""


def with_carriers(rooms: Sequence[Room], wall_thickness: float) -> list[Room]:
    """Gives decorations above the floor of rectilinear rooms what carries them; those that nothing does stay as they are."""
    return [replace(room, decorations=tuple(_with_carrier(one, room, wall_thickness / 2) for one in room.decorations)) for room in rooms]


def covers(one: Furniture | Decoration, x: float, z: float) -> bool:
    """Tells whether a spot of the room lies over a body, taken at the nearest right angle."""
    reach = (one.depth, one.width) if round(one.rotation / 90) % 2 else (one.width, one.depth)
    return abs(x - one.x) <= reach[0] / 2 and abs(z - one.z) <= reach[1] / 2


def _with_carrier(one: Decoration, room: Room, half_wall: float) -> Decoration:
    if one.y <= RESTING:
        return one
    bodies: list[Furniture | Decoration] = [*room.furniture, *room.decorations]
    below = [other for other in bodies if other.y < one.y and covers(other, one.x, one.z)]
    nearest = min(((abs(other.y + other.height - one.y), other.id) for other in below), default=(RESTING + 1.0, ""))
    around = [piece.id for piece in room.furniture if piece.y < one.y <= piece.y + piece.height and covers(piece, one.x, one.z)]
    if around and nearest[0] > LYING:
        return replace(one, parent=around[0])
    if nearest[0] <= RESTING:
        return replace(one, parent=nearest[1])
    wall = next((name for far, _, name in sorted(_walls(one, room, half_wall)) if far <= HANGING), None)
    return replace(one, mounted_on_wall=wall)


def _walls(one: Decoration, room: Room, half_wall: float) -> Iterator[tuple[float, bool, WallName]]:
    """Yields how far a thing is from each stretch of wall that its middle is before, m, the one behind it first among equals."""
    behind, reach = WALL_BEHIND[round(one.rotation / 90) % 4 * 90], (one.width, one.depth)
    if round(one.rotation / 90) % 2:
        reach = reach[::-1]
    for name, line, low, high in walls_round([(to_mm(x), to_mm(z)) for x, z in room.corners]):
        along, across, half = (one.x, one.z, reach[1] / 2) if name in ALONG_X else (one.z, one.x, reach[0] / 2)
        if low <= along * 1000 <= high:
            face = line / 1000 + INWARDS[name] * half_wall
            yield abs(face + INWARDS[name] * half - across), name != behind, name
