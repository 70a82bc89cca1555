"""The walk of a room being dressed, against the validator's: they agree wherever all doors and use sides must be met."""

from __future__ import annotations

import pytest

from catalogs import load_catalogs
from solver.dress.walking import Walking
from solver.furnish import space_of
from solver.geometry import Rect
from solver.scene import Furniture, Opening, Room, Scene
from solver.streams import Stream
from solver.validate import validate
from solver.ways import Goal, Ways

KNOWN = load_catalogs()


def drawn(seed: int) -> Room:
    """A small room with a door and some cupboards at millimetre places, gaps of the robot's width among them."""
    stream = Stream(seed, "boxes")
    width, depth = (2400 + stream.below(2000)) / 1000, (2200 + stream.below(2000)) / 1000
    pieces: list[Furniture] = []
    for k in range(1 + stream.below(5)):
        wide, deep = (200 + 2 * stream.below(500)) / 1000, (200 + 2 * stream.below(400)) / 1000
        low, high = 50 + round(wide * 500), round(width * 1000) - 50 - round(wide * 500)
        near, far = 50 + round(deep * 500), round(depth * 1000) - 50 - round(deep * 500)
        if low < high and near < far:
            x, z = (low + stream.below(high - low + 1)) / 1000, (near + stream.below(far - near + 1)) / 1000
            if stream.chance(0.5) and pieces:
                x = round(pieces[-1].x + pieces[-1].width / 2 + 0.6 + wide / 2, 4)
            pieces.append(Furniture(f"r/box_{k}", "dresser" if stream.chance(0.3) else "box", x=x, z=z, width=wide, depth=deep, height=1.0))
    wall = stream.pick(("north", "south"))
    door = Opening("d", wall=wall, position=0.7 + stream.unit() * (width - 1.4), connects_to="EXTERIOR", main_entrance=True)
    return Room("r", width=width, depth=depth, furniture=tuple(pieces), openings=(door,))


def rect(piece: Furniture) -> Rect:
    x, z, wide, deep = (round(value * 1000) for value in (piece.x, piece.z, piece.width / 2, piece.depth / 2))
    return Rect(x - wide, z - deep, x + wide, z + deep)


@pytest.mark.parametrize("start", range(0, 600, 100))
def test_the_validator_agrees(start: int) -> None:
    seen = {True: 0, False: 0}
    for seed in range(start, start + 100):
        room = drawn(seed)
        space = space_of(room, 0.1)
        bodies = [rect(piece) for piece in room.furniture]
        square = space.doorways[0].square
        if any(body.overlaps(square) for body in bodies):
            continue
        used = [Goal(body, ("south",), False) for body, piece in zip(bodies, room.furniture, strict=True) if piece.name == "dresser"]
        issues = validate(Scene(wall_thickness=0.1, rooms=(room,)), KNOWN)
        told = [issue for issue in issues if issue.rule == "unreachable"]
        walking = Walking(Ways(space, bodies, used))
        assert walking.sound == (not told), (seed, told)
        seen[walking.sound] += 1
        if bodies:
            before = Walking(Ways(space, bodies[:-1], used if room.furniture[-1].name != "dresser" else used[:-1]))
            if before.sound and room.furniture[-1].name != "dresser":
                assert before.passes(bodies[-1]) == walking.sound
    assert min(seen.values()) > 5
