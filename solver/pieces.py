"""What furnish hands to placement: a room's space, and every wanted piece with all its candidates.

All in integer millimetres, room-relative (the north-west corner of the room's wall *lines* is the origin). Placement never has to ask back:
what a piece may do is all here.

Cost is one number for everything: quadratic terms are weight x metres squared, preference costs are added to them.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from struct import Struct
from typing import Final, Literal, NamedTuple

from solver.body_rows import Look
from solver.geometry import Rect, turned
from solver.records import kept, late, maker_in
from solver.scene import WALL_NUMBERS

Extents = tuple[int, int, int]
"""Unrotated width, depth and height, mm."""

NamedKind = tuple[str, Extents]
"""Name and size of a kind."""

ZONE: Final = Struct("<6q")
DOORWAY: Final = Struct("<2i4q")
"""How the core reads zones and doorways."""


class Zone(NamedTuple):
    """A fixed rectangle that bodies reaching above `above_mm` must stay out of.

    `cause` names it in reasons: an opening's id, or `outline` for a part that is missing from the rectangle.
    """

    rect: Rect
    above_mm: int
    cause: str


Walked = Literal["in", "through", "not"]
"""What a door is to who walks in a room: one of those by which one comes into the house, to be joined with the others, or neither."""


class Doorway(NamedTuple):
    """A door or passage as the walk sees it: its square inside the room, and the wall it is in.

    The square begins at the line of an outer wall, at the face of a wall that only part of the room reaches to.
    """

    id: str
    wall: str
    square: Rect
    connects_to: str
    walked: Walked = "through"
    swings_in: bool = False

    def row(self) -> bytes:
        """Returns it as the core reads it."""
        return DOORWAY.pack(WALL_NUMBERS[self.wall], self.swings_in, *self.square)


class Opened(NamedTuple):
    """An opening of the room: its kind, wall, and the ends of its stretch along that wall, mm."""

    kind: str
    wall: str
    interval: tuple[int, int]
    across: int


@dataclass(frozen=True)
class Space:
    """Where a room's furniture may stand.

    `clear` is the rectangle of the wall lines moved in by half a wall; `gap_mm` is how far a wall-hugging body's back
    stands from the wall's face (30 for what we generate).
    """

    room: str
    clear: Rect
    zones: tuple[Zone, ...]
    doorways: tuple[Doorway, ...]
    robot_mm: int = 600
    gap_mm: int = 30
    ways_mm: int = 0
    """How wide the ways from door to door shall be where that is wider than who walks."""
    cover_mm2: int = 0
    """Optional pieces are added while less floor than this is covered, mm2; 0: whatever is covered."""
    openings: tuple[Opened, ...] = ()
    """Those of the room's openings whose wall it tells."""
    approaches: tuple[Rect, ...] = ()
    """The floor before doors that a standard asks for."""
    closed: bool = False
    """Whether nobody comes in by any door: one walks in the largest part of the floor."""

    @kept
    def rows(self) -> tuple[bytes, bytes]:
        """Its zones, and the doorways to be joined, as the core reads them."""
        zones = [ZONE.pack(*rect, above, cause == "outline") for rect, above, cause in self.zones]
        return b"".join(zones), b"".join([door.row() for use in ("in", "through") for door in self.doorways if door.walked == use])

    @property
    def outer(self) -> int:
        """By how many of its doors, the first that the core reads, one comes into the house."""
        return sum(door.walked == "in" for door in self.doorways)


class Stance(NamedTuple):
    """What of a piece's pose its neighbours' candidates may depend on: its rotation, the wall at its back, how high it stands."""

    rotation: int
    wall: str | None = None
    bottom_mm: int = 0


class Attach(NamedTuple):
    """Stands at a slot of another piece, in that piece's own frame.

    The own centre minus the parent's centre lies within `across_mm` along the parent's +x side and within `along_mm`
    along its front (both as at rotation 0: left is -x, front is +z). An interval of one value is a rigid tie.
    `parent_kind` and `parent_stance` are the parent's way to stand that the numbers are for: where the parent's chosen
    candidate differs in its `kind` or its `stance`, this one is void.
    """

    parent: str
    parent_kind: str
    across_mm: tuple[int, int]
    along_mm: tuple[int, int]
    slot: str = ""
    """Name of the slot; two pieces never take the same slot of one parent."""
    parent_stance: Stance | None = None
    wish_mm: tuple[int, int] | None = None
    """Where within the intervals it is wished; None for the middle."""

    @property
    def wish_twice_mm(self) -> tuple[int, int]:
        """Twice where it is wished: the middle of an interval may lie between whole millimetres."""
        across, along = self.wish_mm or (None, None)
        return (sum(self.across_mm) if across is None else 2 * across, sum(self.along_mm) if along is None else 2 * along)


@dataclass(frozen=True)
class Stand:
    """A use side: where a person stands to use the piece. `side` is of the unrotated body."""

    side: str
    """front | back | left | right (left is -x at rotation 0)."""
    inset_mm: int = 0
    """How much of either end of the side does not count: what is rounded outwards of a body between whole millimetres."""


@dataclass(frozen=True)
class Candidate:
    """One way for a piece to stand.

    Args (units mm, degrees):
        kind: the catalog's name, a size variant; or what the user calls it.
        size_mm: unrotated width, depth, height.
        rotation: absolute; with `attach` relative to the parent's.
        wall: the wall whose face its back stands `gap_mm` from (that coordinate is then fixed), or None.
        anchor_mm: the wished footprint centre (x, z) in the room; ignored along a fixed coordinate and with `attach`.
        weights: cost per metre squared of leaving the anchor along x and along z; within [0.02, 20].
        within: where the footprint must stay; None means the space's clear rectangle.
        cost: preference cost, >= 0: 0 for the best.
        bottom_mm: the underside's height, > 0 for what stands on another piece.
        slack_mm: where set, the piece is not flush at `wall`: its back is at most this far from the wall's face (used by /fix).
    """

    kind: str
    size_mm: Extents
    rotation: int
    wall: str | None = None
    anchor_mm: tuple[int, int] = (0, 0)
    weights: tuple[float, float] = (1.0, 1.0)
    within: Rect | None = None
    cost: float = 0.0
    bottom_mm: int = 0
    attach: Attach | None = None
    under: str | None = None
    """The label of the table it is tucked under; these two may overlap."""
    on: str | None = None
    """The label of the piece it stands on; these two may overlap in plan."""
    slack_mm: int | None = None
    stretch_of: str | None = None
    """The wall of an outline before whose stretch `within` lies (used by /fix)."""
    stance: Stance | None = None
    """How it stands in the room, where others' candidates depend on that (`Attach.parent_stance`)."""

    @property
    def extent(self) -> tuple[int, int]:
        """The extents of its footprint along x and z; with `attach` in the parent's frame."""
        return turned(self.size_mm[0], self.size_mm[1], self.rotation)

    @property
    def stays(self) -> bool:
        """Whether it leaves a piece one place only: all of where the footprint must stay."""
        return self.within is not None and (self.within.width, self.within.depth) == self.extent


LOOKS_AT = 360
"""The turn of a link by which one piece looks at the other."""


@dataclass(frozen=True)
class Link:
    """A relation between two pieces that is not a slot: a condition on their candidates, and quadratic terms.

    Args:
        relation: the vocabulary's word, for reasons.
        of: the other piece's label.
        turn: wished rotation minus the other's, 0, 90, 180 or 270 degrees; `LOOKS_AT`: the other's anchor is wished before its
            front instead, no farther aside than ahead, or a turn of 180 where either stands at a slot; None where any will do.
        walls: "opposite" | "same" | "other" | "adjacent" | None: the wished relation of the two walls.
        cost: added when `turn` or `walls` does not hold.
        required: the candidates are incompatible when it does not hold.
        align: weight of (own centre - other's centre)^2 along the other's width, m^-2; 0 for none.
        near: weight of the squared distance of the centres along both axes, m^-2; 0 for none.
        apart_m, apart_cost: cost per metre that the two, each where it is wished, lie closer than apart_m, by the free distance.
    """

    relation: str
    of: str
    turn: int | None = None
    walls: str | None = None
    cost: float = 0.0
    required: bool = False
    align: float = 0.0
    near: float = 0.0
    apart_m: float = 0.0
    apart_cost: float = 0.0


@dataclass(frozen=True)
class Piece:
    """A piece to be placed. Order in the room's list is its importance, required pieces first.

    Args:
        label: unique in the room, `<piece>_<number>`.
        required: left out last of all.
        candidates: the ways it may stand; their costs need not be sorted.
        links: conditions and terms against pieces earlier in the list.
        stands: its use sides; `need_all` tells whether all of them must be reachable or any one.
        skip_cost: what leaving it out costs; infinite where its room type requires it.
        with_next: an optional piece that stands only together with the next one.
        is_floor: it stands for floor to be kept empty: no body, but bodies keep out of it.
        is_there: it stands already, and need not keep apart from zones and from others that do.
        left_out: not 0 where it is left out already and only told of: why (`Fate` of solver/core/placement/fill.hpp).
        only: name and size of its kind where it is of one, for reasons: it may have no candidate.
    """

    label: str
    required: bool
    candidates: tuple[Candidate, ...]
    links: tuple[Link, ...] = ()
    stands: tuple[Stand, ...] = ()
    need_all: bool = False
    skip_cost: float = 10.0
    with_next: bool = False
    is_floor: bool = False
    is_there: bool = False
    left_out: int = 0
    only: NamedKind | None = None

    @property
    def parents(self) -> set[str | None]:
        """Labels of the pieces at which it may stand, None where it may stand at none; empty where it has no candidate."""
        return {way.attach.parent if way.attach else None for way in self.candidates}


def with_relying(pieces: Iterable[Piece], labels: Iterable[str]) -> set[str]:
    """Returns labels with those of all pieces that stand only at one of them, or nowhere."""
    found = set(labels)
    for piece in pieces:  # what stands at another comes after it
        if piece.parents <= found:
            found.add(piece.label)
    return found


NamedKinds = tuple[NamedKind, ...]
"""Names and sizes of kinds, by their numbers."""


class WantedRows(NamedTuple):
    """What the core furnishes and places in one go: a room and its type as bytes, and what the numbers of its answer mean.

    `kinds` are those of the room's type, `looks` is how furniture of each looks. `label` returns the label of a wanted piece from
    rows of spec, number and side of floor (NameRow of core/rooms/made.hpp) and its place among them, `candidate` a candidate from its row
    and all labels.
    """

    space: Space
    type_rows: bytes
    room_rows: bytes
    kinds: NamedKinds
    looks: Sequence[Look]
    label: Callable[[Sequence[tuple[int, int, int]], int], str]
    candidate: Callable[[bytes, Sequence[str]], Candidate]


@dataclass(frozen=True)
class Placed:
    """Where a piece stands: the chosen candidate, and its footprint on the lattice (mm, room-relative)."""

    label: str
    chosen: Candidate
    rotation: int
    wall: str | None
    footprint: Rect


class StandingRows(NamedTuple):
    """Pieces that stand as bodies (`BODY` of body_rows.py), the kinds that they are of, and how each looks."""

    content: bytes
    kinds: NamedKinds
    looks: Sequence[Look]


class Residuals(NamedTuple):
    """How exactly an independent solver finds the same optimum: powers of ten that are not exceeded."""

    primal: int
    """By how much any constraint is broken, m."""
    dual: int
    """By how much anything is still drawn, m^-1."""
    gap: int
    """By how much the cost and its lower bound differ."""


@dataclass(frozen=True)
class Arrangement:
    """A room's result.

    `cost` counts terms and preferences where the pieces stand at last; `proven` tells that the search for these candidates
    closed below its limit; `best` that no other candidates of the required pieces are cheaper, within the widenings tried:
    both of the placement before slivers were tidied away, which costs at most 0.8 (core/placement/tidy.hpp). `left_out` pairs a label
    with the reason, for a person; `skipped` tells what doing without each of these costs (`Piece.skip_cost`). `insisted` is the
    label of the piece that was asked for as if it were required.
    """

    room: str
    placed: tuple[Placed, ...] = late(())
    left_out: tuple[tuple[str, str], ...] = ()
    cost: float = 0.0
    proven: bool = True
    solves: int = 0
    notes: tuple[str, ...] = field(default=())
    best: bool = True
    residuals: Residuals | None = None
    skipped: Mapping[str, float] = field(default_factory=dict)
    insisted: str | None = None

    @property
    def standing(self) -> StandingRows | None:
        """The pieces as rows, where the core told them so; None where they were placed one by one."""
        found: StandingRows | None = getattr(maker_in(self, "placed"), "standing", None)
        return found
