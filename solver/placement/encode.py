"""A room and its pieces -> the kernel's arrays, once a room."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import chain, islice
from struct import pack
from typing import Final

from solver.geometry import LEAST_FLOOR_MM2
from solver.pieces import DOORWAY, Candidate, Link, Piece, Space, Stance
from solver.placement.budget import charge
from solver.placement.kernel import new_engine
from solver.placement.layout import Engine
from solver.placement.why_left_out import why_nowhere
from solver.scene import WALL_NUMBERS

SIDES = {"front": 1, "back": 2, "left": 4, "right": 8}
EMPTY_FLOOR = 16
"""Floor that is asked for empty, as if a person stood all over it: no body, but apart from all bodies."""
STANDS = 2
"""A piece that is there already, in place of whether it is required."""
_RELATIONS = (None, "same", "opposite", "other", "adjacent")
"""Of walls, as the core numbers them."""
OTHER_SIDE_COST = 0.05
"""What using the second of several allowed sides costs: order, not preference."""
LINK_COSTS = 5
"""Numbers a link costs by."""


def _side_choices(piece: Piece, walk: str) -> list[tuple[tuple[str, ...], tuple[int, int, int, int], float]]:
    """Returns the choices of use sides: names; bits that get a stand, of which any, and of which all count, and their inset; cost."""
    if not piece.stands or walk == "none":
        return [((), (0, 0, 0, 0), 0.0)]
    names = tuple(stand.side for stand in piece.stands)
    bits, inset = [SIDES[name] for name in names], max(stand.inset_mm for stand in piece.stands)
    still = walk == "loose" and all(way.stays for way in piece.candidates)
    if walk == "test" or still or (walk in ("mixed", "loose") and len(bits) > 1):
        return [(names, (0, 0, sum(bits), inset) if piece.need_all else (0, sum(bits), 0, inset), 0.0)]
    if piece.need_all:
        return [(names, (sum(bits), 0, 0, inset), 0.0)]
    return [((name,), (bit, 0, 0, inset), OTHER_SIDE_COST * k) for k, (name, bit) in enumerate(zip(names, bits, strict=True))]


def _longs(values: Sequence[int]) -> bytes:
    return pack(f"<{len(values)}q", *values)


def _doubles(values: Sequence[float]) -> bytes:
    return pack(f"<{len(values)}d", *values)


class Tables:
    """The rows of a room's tables, one behind the other, and numbers for names: pieces by label, kinds, slots."""

    def __init__(self, space: Space, pieces: Sequence[Piece]) -> None:
        self.space, self.pieces = space, pieces
        self.piece = {piece.label: k for k, piece in enumerate(pieces)}
        self.kinds: dict[tuple[str, Stance | None], int] = {}
        self.slots: dict[str, int] = {}
        self.rows: list[list[int]] = []
        self.alts: list[int] = []
        self.alt_costs: list[float] = []
        self.links: list[int] = []
        self.link_costs: list[float] = []
        self.sides: list[int] = []
        self.side_costs: list[float] = []
        self.side_names: list[tuple[str, ...]] = []
        self.candidates: list[Candidate] = []

    def add(self, piece: Piece, walk: str) -> None:
        """Adds a piece with its candidates, links and choices of sides."""
        starts = self._counts()
        for a in piece.candidates:
            parent = -1 if a.attach is None else self.piece.get(a.attach.parent)
            if parent is None or (parent >= len(self.rows) and self.pieces[parent].left_out):
                continue
            if parent >= len(self.rows):
                raise ValueError(f"{piece.label} must come after what it is attached to")
            self.alts += self._candidate(a)
            self.alt_costs += (*a.weights, a.cost)
            self.candidates.append(a)
        for link in piece.links:
            if self.piece.get(link.of, len(self.rows)) < len(self.rows):  # to pieces before it
                self._link(link)
        for side_names, bits, cost in _side_choices(piece, walk):
            self.side_names.append(side_names)
            self.sides += bits
            self.side_costs.append(cost)
        ranges = chain.from_iterable(zip(starts, self._counts(), strict=True))
        empty = EMPTY_FLOOR if piece.is_floor else 0
        required = STANDS if piece.is_there else -piece.left_out or int(piece.required)
        self.rows.append([required, *ranges, int(piece.with_next), empty])

    def label_of(self, piece: int) -> str:
        """Returns the label of a piece."""
        return self.pieces[piece].label

    def kind_of(self, number: int) -> str:
        """Returns the name of a kind."""
        return next(islice(self.kinds, number, None))[0]

    def ways_of(self, candidates: Iterable[int]) -> list[Candidate]:
        """Returns candidates by their numbers."""
        return [self.candidates[number] for number in candidates]

    def why_nowhere(self, piece: int) -> str:
        """Says why a piece has no way to stand at all."""
        return why_nowhere(self.space, self.pieces[piece])

    def _counts(self) -> tuple[int, int, int]:
        """Returns how many candidates, links and choices of sides there are so far."""
        return len(self.candidates), len(self.link_costs) // LINK_COSTS, len(self.side_names)

    def _candidate(self, a: Candidate) -> tuple[int, ...]:
        """Returns a candidate's row; the core derives which are of one kin."""
        kind = self.kinds.setdefault((a.kind, a.stance), len(self.kinds))
        slack = -1 if a.slack_mm is None else a.slack_mm
        if a.attach is None:
            anchor, attach = a.anchor_mm, tuple[int, ...]((-1, -1, 0, 0, 0, 0, -1))
        else:
            parent, slot = self.piece.get(a.attach.parent, -1), -1
            if a.attach.slot:
                slot = self.slots.setdefault(a.attach.slot, len(self.slots))
            parent_kind = self.kinds.setdefault((a.attach.parent_kind, a.attach.parent_stance), len(self.kinds))
            anchor, attach = a.attach.wish_twice_mm, (parent, parent_kind, *a.attach.across_mm, *a.attach.along_mm, slot)
        under, on = self.piece.get(a.under or "", -1), self.piece.get(a.on or "", -1)
        own = (kind, *a.size_mm, a.rotation % 360, WALL_NUMBERS[a.wall], *anchor, *(a.within or self.space.clear), a.bottom_mm)
        return (*own, *attach, under, on, slack, 0)

    def _link(self, link: Link) -> None:
        turn = -1 if link.turn is None else link.turn
        self.links += (self.piece[link.of], turn, _RELATIONS.index(link.walls), int(link.required))
        self.link_costs += (link.cost, link.align, link.near, link.apart_m, link.apart_cost)


ROOM_ROWS_WORK: Final = 100.0
"""What laying a room out counts of a call's work, in QPs of a small room."""
CANDIDATE_WORK: Final = 20.0
"""The same for each candidate: finding it and writing its row."""
ZONE_WORK: Final = 10.0
"""The same for each zone."""


@dataclass(frozen=True)
class Encoded:
    """A room as the kernel sees it, and what its numbers mean."""

    tables: Tables
    walk: str
    engine: Engine

    @property
    def space(self) -> Space:
        """Where the room's furniture may stand."""
        return self.tables.space

    @property
    def pieces(self) -> Sequence[Piece]:
        """Its pieces."""
        return self.tables.pieces


def encode(space: Space, pieces: Sequence[Piece], walk: str = "stands") -> Encoded:
    """Lays a room out for the kernel.

    Args:
        space: where the room's furniture may stand.
        pieces: pieces, parents before what is attached to them.
        walk: "stands" gives every use side to be reached a person's square; "test" only asks the walk for them; "mixed"
            does that where there are several sides, "loose" also where the piece stays; "none" asks for no use sides at all.

    Raises:
        ValueError: a piece comes before the one it is attached to.
    """
    tables, request = lay_out(space, pieces, walk)
    return Encoded(tables, walk, new_engine(request))


def problem_bytes(space: Space, pieces: Sequence[Piece]) -> bytes:
    """Returns a room's problem as the core reads it (`RoomRequest`), use sides to be tested.

    Raises:
        ValueError: as `encode`.
    """
    return lay_out(space, pieces, "test")[1]


def lay_out(space: Space, pieces: Sequence[Piece], walk: str) -> tuple[Tables, bytes]:
    """Returns what the numbers stand for that `encode` tells the kernel, and what it is sent: `RoomRequest` of placement/space.hpp."""
    tables = Tables(space, tuple(pieces))
    for piece in pieces:
        tables.add(piece, walk)
    charge(ROOM_ROWS_WORK + CANDIDATE_WORK * len(tables.candidates) + ZONE_WORK * len(space.zones))
    zones, doorways = space.rows
    counts = len(space.zones), len(doorways) // DOORWAY.size, len(pieces), len(tables.side_names), len(tables.candidates)
    least_floor = 0 if walk == "none" else LEAST_FLOOR_MM2
    asked = *space.clear, space.gap_mm, space.robot_mm, space.cover_mm2, least_floor, space.ways_mm, -1 if space.closed else space.outer
    return tables, b"".join([
        _longs([*counts, len(tables.link_costs) // LINK_COSTS, *asked]), zones, doorways, _longs([*chain(*tables.rows)]),
        _doubles([piece.skip_cost for piece in pieces]), _longs(tables.sides), _doubles(tables.side_costs), _longs(tables.alts),
        _doubles(tables.alt_costs), _longs(tables.links), _doubles(tables.link_costs),
    ])  # fmt: skip
