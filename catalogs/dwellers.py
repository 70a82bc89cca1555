"""The types of who is in a home: people and pets, in which rooms, how likely, and how they stand or sit there."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from catalogs.entries import ORDERED, Category, Entry, Metres, Probability, RoomTypeNames, Words
from catalogs.references import Names


class Seats(Entry):
    """What somebody sits on, and how large they are there.

    A surface of furniture of one of the `categories` is sat on when it lies at `heights`, least and most, m. `size` is that of
    who sits: width, depth and height above the seat, m.
    """

    categories: Annotated[tuple[Category, ...], Field(min_length=1)]
    heights: Annotated[tuple[Metres, Metres], ORDERED]
    size: tuple[Metres, Metres, Metres]


class Dweller(Entry):
    """People, or pets, that may be in a home.

    `kinds` are kinds of furniture.yaml, one as likely as another. With `per: room` each room of the types `rooms` has one with
    probability `chance`, until there are `most` in the home; with `per: home` the home has one with that probability, in one of
    `rooms`, or where none of them has a place in one of `otherwise`. `poses` are tried in random order: who `stands` looks at
    something near, who `sits` does so on a seat as `seats` says, who `roams` is anywhere on free floor.
    """

    kinds: Annotated[Words, Names("kind of people or pets", "a key of furniture.yaml")] = Field(min_length=1)
    per: Literal["room", "home"]
    chance: Probability
    most: Annotated[int, Field(ge=1, le=100)] = 1
    rooms: RoomTypeNames
    otherwise: RoomTypeNames = ()
    poses: Annotated[tuple[Literal["stands", "sits", "roams"], ...], Field(min_length=1)]
    seats: Seats | None = None

    @model_validator(mode="after")
    def _complete(self) -> Dweller:
        if ("sits" in self.poses) != (self.seats is not None):
            raise ValueError("`seats` goes with the pose `sits`")
        if self.otherwise and self.per == "room":
            raise ValueError("`otherwise` goes with `per: home`")
        return self
