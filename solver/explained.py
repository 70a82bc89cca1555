"""What an explanation of a piece's place says."""

from dataclasses import dataclass
from typing import Annotated

from solver.fields import OneOf, Record, Says

HOLDERS = ("wall", "piece", "use_side", "door", "window", "outline", "floor", "way", "relation")
"""What may hold a piece."""
FloorPoint = Annotated[tuple[float, float], Says("x, z of the footprint's centre in the room, m")]


@dataclass(frozen=True)
class Hold(Record):
    """What keeps a piece from going on in one direction, and what a metre more room there would save.

    `by` is the id of a piece or an opening, or null; `what` is `use_side` where it is the floor that a person needs to use that piece,
    `floor` where it is floor at a side of that piece that is better kept free.
    """

    by: str | None
    what: Annotated[str, OneOf(*HOLDERS)]
    towards: Annotated[str, OneOf("north", "east", "south", "west")]
    cost_per_m: float
    message: str


@dataclass(frozen=True)
class MovedPiece(Record):
    """How a piece would stand: its footprint's centre in the room, m, its rotation, degrees, and its kind, perhaps another size of it.

    `y` is its underside, m, and `on` what it would stand on.
    """

    id: str
    kind: str
    x: float
    y: float
    z: float
    rotation: int
    width: float
    depth: float
    height: float
    on: str | None


@dataclass(frozen=True)
class OtherWay(Record):
    """Another way to stand: at which wall and how it is turned, and what the room would have cost more with it; null: it could not.

    `moves` is all that would then stand elsewhere, the piece itself too; `left_out` who would have no place.
    """

    wall: Annotated[str, OneOf("north", "east", "south", "west")] | None
    rotation: int
    cost: float | None
    moves: tuple[MovedPiece, ...]
    left_out: tuple[str, ...]
    message: str


@dataclass(frozen=True)
class Explained(Record):
    """Why a piece stands where it does: where it was wished, what holds it back from there, and how else it could stand."""

    id: str
    room: str
    stands: FloorPoint
    wished: FloorPoint | None
    holds: tuple[Hold, ...]
    notes: tuple[str, ...]
    ways: tuple[OtherWay, ...] = ()
