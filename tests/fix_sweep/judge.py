"""What is wrong with a room whose walls are straight, by code that shares nothing with the solver or its validator.

Comes in: a scene and a room of it without an outline, all at right angles. Goes out: words, one a fault. Exact in tenths of a
millimetre; who can walk where is said by the flood of tests/oracles/walk.py.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from solver.geometry import Rect
from solver.pieces import Doorway, Space
from solver.scene import Furniture, Opening, Room, Scene
from tests.oracles.walk import missed, side_towards

Box = tuple[int, int, int, int]
"""West, north, east and south edge, 0.1 mm."""
Uses = Mapping[str, tuple[Sequence[str], bool]]
WALL_FAR, TUCKED_OUT, SQUARE, BEFORE_WINDOW, BESIDE_WINDOW, FLAT = 2000, 1500, 9000, 5000, 1000, 200
HEADROOM_M, ROBOT_MM = 2.0, 600


def tenths(metres: float) -> int:
    return round(metres * 10_000)


def box_of(piece: Furniture) -> Box:
    wide, deep = (piece.depth, piece.width) if piece.rotation % 180 else (piece.width, piece.depth)
    x, z, w, d = (tenths(2 * piece.x), tenths(2 * piece.z), tenths(wide), tenths(deep))
    return (x - w) // 2, (z - d) // 2, (x - w) // 2 + w, (z - d) // 2 + d


def meet(a: Box, b: Box) -> tuple[int, int]:
    """Along x and z, how much two boxes share."""
    return min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])


def before(room: Room, opening: Opening, deep: int, beside: int = 0) -> Box:
    """The floor before an opening, from the wall's line on."""
    low, high = (tenths(opening.position) + sign * (tenths(opening.width) // 2 + beside) for sign in (-1, 1))
    width, depth = tenths(room.width), tenths(room.depth)
    return {
        "north": (low, 0, high, deep),
        "south": (low, depth - deep, high, depth),
        "west": (0, low, deep, high),
        "east": (width - deep, low, width, high),
    }[opening.wall or ""]


def off_wall(room: Room, piece: Furniture, wall: str) -> float:
    """How far a piece is from a wall's line, m."""
    box, width, depth = box_of(piece), tenths(room.width), tenths(room.depth)
    return {"north": box[1], "west": box[0], "south": depth - box[3], "east": width - box[2]}[wall] / 10_000


def faults(scene: Scene, room: Room, uses: Uses) -> list[str]:
    """Lists what is wrong with a room's furniture, people left aside; how its doors' other sides are, too."""
    bodies = [piece for piece in room.furniture if tenths(piece.height) > FLAT]
    found = [*_out(scene, room, bodies), *_before_openings(room, bodies), *_together(bodies)]
    hung = [
        piece
        for piece in bodies
        if piece.wall and tenths(off_wall(room, piece, piece.wall)) > max(WALL_FAR, tenths(scene.wall_thickness) // 2 + 1500)
    ]
    found += [f"{piece.id} is far from its wall" for piece in hung]
    return found or [f"{label} cannot be reached" for label in _unreached(scene, room, bodies, uses)]


def _out(scene: Scene, room: Room, bodies: Sequence[Furniture]) -> Iterator[str]:
    half = tenths(scene.wall_thickness) // 2
    inner = (half, half, tenths(room.width) - half, tenths(room.depth) - half)
    for piece in bodies:
        box = box_of(piece)
        if box[0] < inner[0] or box[1] < inner[1] or box[2] > inner[2] or box[3] > inner[3]:
            yield f"{piece.id} leaves the room"


def _before_openings(room: Room, bodies: Sequence[Furniture]) -> Iterator[str]:
    for opening in room.openings:
        if opening.kind == "garage_door":
            continue
        window = opening.kind == "window"
        deep = BEFORE_WINDOW if window else min(tenths(opening.width), SQUARE)
        floor = before(room, opening, deep, BESIDE_WINDOW if window else 0)
        for piece in bodies:
            tall = not window or tenths(piece.y + piece.height) > tenths(opening.sill)
            if tall and min(meet(box_of(piece), floor)) > 0:
                yield f"{piece.id} is before {opening.id}"


def _together(bodies: Sequence[Furniture]) -> Iterator[str]:
    for a, b in combinations(bodies, 2):
        shared = meet(box_of(a), box_of(b))
        level = min(a.y + a.height, b.y + b.height) - max(a.y, b.y)
        if min(shared) <= 0 or tenths(level) <= 0 or a.on == b.id or b.on == a.id:
            continue
        for chair, table in ((a, b), (b, a)):
            if chair.under == table.id:
                depth = shared[0] if chair.rotation % 180 else shared[1]
                if depth > tenths(chair.depth) - TUCKED_OUT:
                    yield f"{chair.id} is too far under {table.id}"
                break
        else:
            yield f"{a.id} and {b.id} share space"
    there = {piece.id: piece for piece in bodies}
    for piece in bodies:
        below = there.get(piece.on or "")
        if below is not None and not (
            box_of(below)[0] <= tenths(piece.x) <= box_of(below)[2] and box_of(below)[1] <= tenths(piece.z) <= box_of(below)[3]
        ):
            yield f"{piece.id} is not over {below.id}"


def _unreached(scene: Scene, room: Room, bodies: Sequence[Furniture], uses: Uses) -> list[str]:
    half = tenths(scene.wall_thickness) // 20
    clear = Rect(half, half, tenths(room.width) // 10 - half, tenths(room.depth) // 10 - half)
    doors = tuple(
        Doorway(opening.id, opening.wall or "", _mm(before(room, opening, min(tenths(opening.width), SQUARE))), "")
        for opening in room.openings
        if opening.kind in ("door", "passage")
    )
    rects = {piece.id: _mm(box_of(piece)) for piece in bodies}
    used = [piece for piece in bodies if piece.name in uses]
    asked = [
        (piece.id, rects[piece.id], [side_towards(side, round(piece.rotation)) for side in uses[piece.name][0]], uses[piece.name][1])
        for piece in used
    ]
    solids = [rects[piece.id] for piece in bodies if piece.y < HEADROOM_M]
    return missed(Space(room.id, clear, (), doors, ROBOT_MM), solids, asked)


def _mm(box: Box) -> Rect:
    """Returns a box in whole millimetres, which those of our homes lie on."""
    return Rect(box[0] // 10, box[1] // 10, -(-box[2] // 10), -(-box[3] // 10))


def shapes(room: Room) -> bool:
    """Tells whether the judge can judge a room."""
    return room.outline is None and all(opening.wall for opening in room.openings)
