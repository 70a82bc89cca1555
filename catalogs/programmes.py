"""What a programme is made of: how large rooms are in a planned home, and named programmes."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, model_validator

from catalogs.entries import Entry, Metres
from catalogs.references import Names


class Home(Entry):
    """How large rooms of a type are in a home planned for a programme. Types without it cannot be asked for.

    `area` is least, typical and most, m2, between wall lines; `width` the least short side, `aspect` the most of the long
    side over it, `length` the least extent away from the street, m. A programme counts the type by `word` (its own name
    by default); types of one word take turns in the order of `turn`, those marked `once` only the first time. Where an
    outline is too small for the programme, rooms are left out by `spare`, the highest first, and never those without.
    """

    area: tuple[Metres, Metres, Metres]
    width: Metres
    aspect: Annotated[float, Field(ge=1, le=5)] = 2.0
    length: Annotated[float, Field(ge=0, le=20)] = 0.0
    word: str | None = None
    turn: Annotated[int, Field(ge=0, le=100)] = 0
    once: bool = False
    spare: Annotated[int, Field(ge=1, le=100)] | None = None

    @model_validator(mode="after")
    def _ordered(self) -> Home:
        if not self.area[0] <= self.area[1] <= self.area[2]:
            raise ValueError("areas must be ordered: least <= typical <= most")
        if self.width**2 > self.area[1] or self.width * self.width * self.aspect < self.area[0]:
            raise ValueError("no room of this width and aspect has such an area")
        return self

    def larger_by(self, floor: float) -> Home:
        """Returns the same with so much more floor, m2."""
        least, typical, most = (round(area + floor, 2) for area in self.area)
        return self.model_copy(update={"area": (least, typical, most)})


RoomWord = Annotated[str, Names("word for rooms", "the room types and their words")]


class Preset(Entry):
    """A named programme: how many rooms of each word (cars, for garages), and what it is, in words."""

    rooms: dict[RoomWord, Annotated[int, Field(ge=0, le=12)]] = Field(min_length=1)
    description: str = ""
