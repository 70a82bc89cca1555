"""A room as it is when one of its pieces is taken in hand -> the pieces that may move while it is dragged, and what goes along with each.

While a piece is dragged nothing turns, changes its wall or leaves its table: that waits for the piece to be let go. The others stay near
the last answer, unless elsewhere is clearly better.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from solver.answers import Pose
from solver.free_places import footprint
from solver.geometry import ALONG_X, Rect, rotate, strip
from solver.pieces import Arrangement, Attach, Candidate, Piece
from solver.repair.as_sent import as_it_stands, most_away, pieces_as_sent
from solver.repair.bodies import Body, all_bodies, below, parents_of, squared, tables_of
from solver.repair.room_problem import RoomProblem
from solver.scene import Decoration, Dynamic, Furniture

REACH_MM = 140
"""How far along each axis a neighbour may go between two frames: less than 0.2 m in all."""
HELD_REACH_MM = 450
"""How much farther from where it is wished the piece in hand may go in a frame: back from what gives way, not to the room's other end."""
PERSON_REACH_MM = 800
"""The same of somebody who stands in the way."""
PERSON_WEIGHT = 0.05
"""Weight of somebody who stands, against 1 for furniture: people step aside."""


@dataclass(frozen=True)
class InHand:
    """What may move in a room: pieces, each with its ways, parents before what is attached to them, and the number of the one in hand.

    `reaches` is how far each piece may go between frames, mm, the one in hand away from its wish; `riders` has by id of everything in the
    room that moves the number of the piece, standing free, that takes it along.
    """

    pieces: tuple[Piece, ...]
    held: int
    reaches: tuple[int, ...]
    riders: Mapping[str, int]


def in_hand(problem: RoomProblem, label: str, people: Sequence[Dynamic]) -> InHand | None:
    """Returns what may move while a piece is dragged; None where it cannot move by itself: it is locked, flat, or stands on another."""
    bodies: dict[str, Body] = {body.id: body for body in all_bodies(problem.room)}
    tables = tables_of(problem.room.furniture)
    pieces = []
    for piece in pieces_as_sent(problem):
        table = tables.get(piece.label) if piece.label == label else None
        pieces.append(replace(piece, candidates=_ways(piece, bodies[piece.label], table, problem)))
    standing = {person.id: person for person in people if person.on is None}
    pieces += [_person(person, person.id in problem.settings.locked) for person in standing.values()]
    numbers = {piece.label: k for k, piece in enumerate(pieces)}
    held = numbers.get(label)
    if held is None or len(numbers) < len(pieces) or not _is_free(pieces[held]):
        return None
    reaches = [PERSON_REACH_MM if piece.label in standing else REACH_MM for piece in pieces]
    reaches[held] = HELD_REACH_MM
    return InHand(tuple(pieces), held, tuple(reaches), _riders(problem, pieces, numbers, people))


def _ways(piece: Piece, body: Body, table: Body | None, problem: RoomProblem) -> tuple[Candidate, ...]:
    """Returns the ways of a piece that neither turn it nor take it from its table; in hand, at its table, it may be anywhere under that."""
    ways = [way for way in piece.candidates if way.rotation == piece.candidates[0].rotation or way.attach is not None]
    if table is not None and ways[-1].attach is None:
        ways = [replace(ways[-1], cost=0.0, under=table.id)]
    elif ways[0].attach is not None:
        ways = ways[:1]
    size = ways[0].size_mm if body.rotation % 90 == 0 else as_it_stands(body).size_mm
    return tuple(replace(_within_strip(way, problem), cost=0.0, size_mm=size) for way in ways)


def _within_strip(way: Candidate, problem: RoomProblem) -> Candidate:
    """Returns a way at an outer wall with the strip before the wall named as where it may be."""
    if way.wall is None or way.within is not None:
        return way
    width, depth = way.extent
    deep = (depth if way.wall in ALONG_X else width) + most_away(problem.walls.half_mm)
    clear = problem.walls.clear
    return replace(way, within=strip(clear, way.wall, clear.along(way.wall), deep))


def _person(person: Dynamic, locked: bool) -> Piece:
    """Returns somebody who stands as a piece of its own."""
    rect = footprint(person)
    width, depth, height = rect.width, rect.depth, round(person.height * 1000)
    weights = (PERSON_WEIGHT, PERSON_WEIGHT)
    way = Candidate(person.kind, (width, depth, height), 0, anchor_mm=rect.centre, weights=weights, bottom_mm=round(person.y * 1000))
    return Piece(person.id, True, (replace(way, within=rect) if locked else way,))


def _is_free(piece: Piece) -> bool:
    """Tells whether a piece is bound to no other, and may move."""
    way = piece.candidates[0]
    return way.attach is None and not (way.within is not None and (way.within.width, way.within.depth) == way.extent)


def _riders(problem: RoomProblem, pieces: Sequence[Piece], numbers: Mapping[str, int], people: Sequence[Dynamic]) -> dict[str, int]:
    """Returns with which piece everything moves; what hangs at a wall, and what stands on nothing that moves, is left out."""
    parents = parents_of(problem.room)
    attached: dict[str, Attach | None] = {piece.label: piece.candidates[0].attach for piece in pieces}
    found: dict[str, int] = {}

    def goes_with(label: str) -> int | None:
        for carrier in (label, *below(label, parents)):
            if carrier in attached:
                own = attached[carrier]
                return numbers[carrier] if own is None else goes_with(own.parent)
        return None

    for body in (*all_bodies(problem.room), *people):
        hangs = isinstance(body, Decoration) and body.mounted_on_wall is not None
        seat = body.on if isinstance(body, Dynamic) and body.on is not None else body.id
        own = None if hangs or (isinstance(body, Furniture) and problem.settings.is_locked(body)) else goes_with(seat)
        if own is not None:
            found[body.id] = own
    return found


JUMP_MM = 200
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

    def near(self) -> tuple[Piece, ...] | None:
        """Restricts bound pieces to wall, rotation and neighbourhood of their last poses; None where one has no such way."""
        found = [replace(piece, candidates=self._near(piece)) if piece.label in self.bound else piece for piece in self.pieces]
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
    return max(abs(dx), abs(dz)) > 2 * (JUMP_MM + 1) or rotation != squared(pose.rotation)


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
    near = Rect(x, z, x + width, z + depth).shrunk(-JUMP_MM).common(bounds)
    return replace(way, within=near) if near.width >= width and near.depth >= depth else None
