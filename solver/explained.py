"""What an explanation of a piece's place says."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from solver.fields import OneOf, Record, Says

HOLDERS = ("wall", "piece", "use_side", "door", "window", "outline", "way", "relation")
"""What may hold a piece."""
FloorPoint = Annotated[tuple[float, float], Says("x, z of the footprint's centre in the room, m")]


@dataclass(frozen=True)
class Hold(Record):
    """What keeps a piece from going on in one direction, and what a metre more room there would save.

    `by` is the id of a piece or an opening, or null; `what` is `use_side` where it is the floor that a person needs to use that piece.
    """

    by: str | None
    what: Annotated[str, OneOf(*HOLDERS)]
    towards: Annotated[str, OneOf("north", "east", "south", "west")]
    cost_per_m: float
    message: str


@dataclass(frozen=True)
class Explained(Record):
    """Why a piece stands where it does: where it was wished, what holds it back from there, and what is to be said besides."""

    id: str
    room: str
    stands: FloorPoint
    wished: FloorPoint | None
    holds: tuple[Hold, ...]
    notes: tuple[str, ...]
