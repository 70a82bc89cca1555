"""Runs of pieces: what a room type says of those that stand in one row, planned as a whole."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from catalogs.entries import Cost, Entry, Words


class Leaving(Entry):
    """A piece that comes after a run, which had better leave it a place with so much `floor` at its front and back, m.

    `cost` is what leaving none costs.
    """

    to: str
    floor: Annotated[float, Field(ge=0)]
    cost: Cost


class Run(Entry):
    """Pieces that stand in one run, along a wall, round a corner or at two opposite walls, planned as a whole.

    `orders` are the orders they may stand in, either way round; optional ones may be missing. `worktop` are pieces with a
    top to work on: the run may go round a corner at one that is wide enough. `landing` are those that want worktop right
    beside them at both sides, `ends` those that belong at an end of the run, `triangle` the three a cook walks between. It
    `leaves` places to pieces that come after it, where they are wanted.
    """

    orders: tuple[Annotated[Words, Field(max_length=21)], ...] = Field(min_length=1)
    worktop: Words = ()
    landing: Words = ()
    ends: Words = ()
    triangle: Words = ()
    leaves: tuple[Leaving, ...] = ()
