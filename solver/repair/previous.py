"""Near the last answer: while a piece is dragged, the others stay where they were unless elsewhere is clearly better."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from solver.answers import Pose
from solver.geometry import Rect, rotate
from solver.pieces import Arrangement, Candidate, Piece
from solver.repair.bodies import squared

REACH_MM = 200
"""How far along each axis a piece may go from its last pose without having jumped."""
SAME_MM = 2
"""Two places that differ by no more are the same: odd millimetres turned by 90 degrees are."""

Poses = Mapping[str, Pose]


@dataclass(frozen=True)
class LastAnswer:
    """The last answer, as seen from the next question: its poses by id, of a room's pieces in its clear rectangle.

    What was just `moved` is not bound to its pose.
    """

    pieces: Sequence[Piece]
    clear: Rect
    poses: Poses
    moved: Collection[str]

    @cached_property
    def bound(self) -> frozenset[str]:
        """Labels of the pieces that are bound to a pose."""
        return frozenset(piece.label for piece in self.pieces if piece.label in self.poses and piece.label not in self.moved)

    def near(self, free: Collection[str] = ()) -> tuple[Piece, ...] | None:
        """Restricts pieces but those `free` to wall, rotation and neighbourhood of their last poses; None where one has no such way."""
        bound = self.bound.difference(free)
        found = [replace(piece, candidates=self._near(piece)) if piece.label in bound else piece for piece in self.pieces]
        return None if any(not piece.candidates for piece in found) else tuple(found)

    def jumped(self, answer: Arrangement) -> tuple[str, ...]:
        """Returns the labels of those who stand elsewhere in an answer; who is taken along by another does not jump."""
        here = [placed for placed in answer.placed if placed.label in self.bound and placed.chosen.attach is None]
        return tuple(p.label for p in here if _is_elsewhere(p.footprint, p.rotation, self.poses[p.label]))

    def _near(self, piece: Piece) -> tuple[Candidate, ...]:
        """Returns the ways that hold at a pose: at the parent's side where it was there, else near where it was."""
        ways, pose = piece.candidates, self.poses[piece.label]
        attached = tuple(way for way in ways if way.attach is not None)
        there = attached if len(attached) == len(ways) else tuple(way for way in attached if _was_there(pose, way, self.poses))
        if there:
            return there
        free = (_around(way, self.clear, pose) for way in ways if way.attach is None)
        return tuple(way for way in free if way is not None)


def _is_elsewhere(own: Rect, rotation: int, pose: Pose) -> bool:
    dx, dz = own.x0 + own.x1 - pose.x * 2000, own.z0 + own.z1 - pose.z * 2000
    return max(abs(dx), abs(dz)) > 2 * (REACH_MM + 1) or rotation != squared(pose.rotation)


def _was_there(own: Pose, way: Candidate, poses: Poses) -> bool:
    """Tells whether a piece stood in another's frame as a way lets it, turned so."""
    parent = poses.get(way.attach.parent) if way.attach else None
    if parent is None or way.attach is None or (squared(parent.rotation) + way.rotation - squared(own.rotation)) % 360:
        return False
    dx, dz = round((own.x - parent.x) * 1000), round((own.z - parent.z) * 1000)
    across, along = rotate(dx, dz, -squared(parent.rotation) % 360)
    ranges = ((across, way.attach.across_mm), (along, way.attach.along_mm))
    return all(low - SAME_MM <= at <= high + SAME_MM for at, (low, high) in ranges)


def _around(way: Candidate, clear: Rect, pose: Pose) -> Candidate | None:
    """Returns a way kept within reach of a pose, or None where it is another rotation or lies elsewhere."""
    width, depth = way.extent
    bounds = way.within or clear
    if (bounds.width, bounds.depth) == way.extent:
        return way
    if way.rotation != squared(pose.rotation):
        return None
    x, z = round(pose.x * 1000 - width / 2), round(pose.z * 1000 - depth / 2)
    near = Rect(x, z, x + width, z + depth).shrunk(-REACH_MM).common(bounds)
    return replace(way, within=near) if near.width >= width and near.depth >= depth else None
