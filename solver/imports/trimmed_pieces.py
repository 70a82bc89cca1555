"""Furniture drawn a hair's breadth into a wall, or into what stands beside it, is taken so much smaller: it stays where it is drawn."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from typing import Final

from solver.geometry import to_mm
from solver.imports.drawn import PlanNotes
from solver.imports.rectilinear import edges_of_corners
from solver.scene import Furniture, Room

HAIR: Final = 10
"""So much is cut off at most, mm."""
ASKEW: Final = 2.0
"""What is turned from a right angle by so little, degrees, is drawn at it."""
LEAST: Final = 100
"""Nothing is cut to less, mm."""
FaceMove = tuple[int, int]
"""Which of a box's six faces (west, east, north, south, under, top) comes to lie where, mm."""


class _DrawnBox:
    """A piece at a right angle: its faces, mm, and by how much it was cut."""

    def __init__(self, piece: Furniture) -> None:
        self.piece = piece
        reach = (piece.depth, piece.width) if round(piece.rotation / 90) % 2 else (piece.width, piece.depth)
        x, z = ((to_mm(at - size / 2), to_mm(at + size / 2)) for at, size in zip((piece.x, piece.z), reach, strict=True))
        self.faces = [*x, *z, to_mm(piece.y), to_mm(piece.y + piece.height)]
        self.cut = 0

    def length(self, axis: int) -> int:
        return self.faces[2 * axis + 1] - self.faces[2 * axis]

    def move(self, face: int, to: int) -> None:
        """Moves a face inwards, where enough is left."""
        by = abs(self.faces[face] - to)
        if by <= HAIR and self.length(face // 2) - by >= LEAST:
            self.cut, self.faces[face] = max(self.cut, by), to

    def made(self) -> Furniture:
        """Returns the piece as large as its faces say."""
        x0, x1, z0, z1 = self.faces[:4]
        width, depth = (z1 - z0, x1 - x0) if round(self.piece.rotation / 90) % 2 else (x1 - x0, z1 - z0)
        turn = _squared(self.piece) % 360
        return replace(self.piece, rotation=turn, x=(x0 + x1) / 2000, z=(z0 + z1) / 2000, width=width / 1000, depth=depth / 1000)


def _squared(piece: Furniture) -> float:
    return round(piece.rotation / 90) * 90.0


def trimmed(room: Room, half_wall: int, notes: PlanNotes) -> Room:
    """Returns a room of whose furniture what reaches up to HAIR into walls or other pieces is cut, and noted.

    Its outline is rectilinear; its clear floor begins `half_wall` mm inside of its lines.
    """
    boxes = {piece.id: _DrawnBox(piece) for piece in room.furniture if abs(piece.rotation - _squared(piece)) <= ASKEW}
    for box in boxes.values():
        for face, to in _walls(room, box, half_wall):
            box.move(face, to)
    for one, other in combinations(boxes.values(), 2):
        _part(one, other)
    for name, box in boxes.items():
        askew = abs(box.piece.rotation - _squared(box.piece))
        if askew:
            notes.change("furniture", name, 0.0, f"turned by {askew:.2g} degrees: it is drawn along the walls but for that")
        if box.cut:
            words = "taken so much smaller: it is drawn into a wall or into what stands beside it"
            notes.change("furniture", name, box.cut / 1000, words)
    found = (boxes[piece.id].made() if piece.id in boxes else piece for piece in room.furniture)
    return replace(room, furniture=tuple(found))


def _walls(room: Room, box: _DrawnBox, half_wall: int) -> Iterator[FaceMove]:
    """Yields the faces of a box that reach a hair's breadth into a wall, and where the wall's own face is."""
    for edge in edges_of_corners(0, [(to_mm(x), to_mm(z)) for x, z in room.corners]):
        along, across = (0, 1) if edge.axis == "x" else (1, 0)
        face, to = 2 * across + (edge.out > 0), edge.at - edge.out * half_wall
        shared = min(edge.high, box.faces[2 * along + 1]) - max(edge.low, box.faces[2 * along])
        if shared > HAIR and 0 < edge.out * (box.faces[face] - to) <= HAIR:
            yield face, to


def _part(one: _DrawnBox, other: _DrawnBox) -> None:
    """Cuts the longer of two boxes that share a hair's breadth along x or z."""
    if one.piece.under == other.piece.id or other.piece.under == one.piece.id:
        return
    shared = [min(one.faces[2 * k + 1], other.faces[2 * k + 1]) - max(one.faces[2 * k], other.faces[2 * k]) for k in range(3)]
    if min(shared) <= 0 or min(shared[:2]) > HAIR:
        return
    axis = 0 if shared[0] <= shared[1] else 1
    longer, shorter = (one, other) if one.length(axis) >= other.length(axis) else (other, one)
    is_high = longer.faces[2 * axis] < shorter.faces[2 * axis]
    longer.move(2 * axis + is_high, shorter.faces[2 * axis + (not is_high)])
