"""The ground of the catalogs' types: what an entry is, and the units of its values.

Unknown keys are forbidden, everything is frozen. Lengths in metres, areas in m2, masses in kg, angles in degrees.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field

from catalogs.references import Names

Category = Literal[
    "bed", "seating", "table", "storage", "appliance", "bathroom", "lighting",
    "decor", "electronics", "vehicle", "structure", "water", "dynamic", "misc",
]  # fmt: skip
Side = Literal["front", "back", "left", "right"]
Colour = Annotated[str, Field(pattern=r"^#[0-9a-f]{6}$", description="a colour, #rrggbb in small letters")]
Metres = Annotated[float, Field(gt=0, le=100, allow_inf_nan=False)]
Share = Annotated[float, Field(ge=0, le=1)]
"""A part of a whole, 0 to 1."""
Probability = Annotated[float, Field(gt=0, le=1)]
Cost = Annotated[float, Field(strict=True, ge=0, le=100, allow_inf_nan=False)]


def _whole_centimetres(length: float) -> float:
    if abs(length * 100 - round(length * 100)) > 1e-9:
        raise ValueError(f"{length} m is not a whole number of centimetres")
    return length


def _ordered(ends: tuple[Any, Any]) -> tuple[Any, Any]:
    if all(isinstance(end, float) for end in ends) and ends[0] > ends[1]:
        raise ValueError("must be [least, most]")
    return ends


ORDERED = AfterValidator(_ordered)
"""Of a pair: the first is not more than the second, where both are numbers."""


def as_words(value: Any) -> Any:
    """Lets a single word stand for a list of one."""
    return (value,) if isinstance(value, str) else value


def _interval(value: Any) -> Any:
    """Lets a single number stand for an interval of one value."""
    return (value, value) if isinstance(value, int | float) and not isinstance(value, bool) else value


Centimetres = Annotated[Metres, AfterValidator(_whole_centimetres)]
"""A length of whole centimetres, m."""
Words = Annotated[tuple[str, ...], BeforeValidator(as_words, json_schema_input_type=str | tuple[str, ...])]
_Gap = Annotated[float, Field(strict=True, ge=-2, le=20, allow_inf_nan=False)]
GapInterval = Annotated[tuple[_Gap, _Gap], ORDERED, BeforeValidator(_interval, json_schema_input_type=_Gap | tuple[_Gap, _Gap])]


ROOM_TYPE = Names("room type", "a file of rooms/")
RoomTypeNames = Annotated[Words, ROOM_TYPE]
FlooringName = Annotated[str, Names("flooring", "a key of floorings.yaml")]
MaterialName = Annotated[str, Names("material", "a key of materials.yaml")]
KindName = Annotated[str, Names("kind", "a key of furniture.yaml")]
PIECE_NAMES = Names("piece name", "a name of furniture.yaml")


class Entry(BaseModel):
    """Base of every catalog entry."""

    model_config = ConfigDict(frozen=True, extra="forbid", defer_build=True)


class Surface(Entry):
    """A surface that carries things.

    Its height above the piece's underside, how far in from the footprint's edges it starts, and the free height above
    it, m (None: open above).
    """

    name: str
    height: Metres
    inset: Annotated[float, Field(ge=0, le=1)] = 0.02
    clearance: Metres | None = None


class KindSpec(Entry):
    """One kind of something that is drawn, has a size and may carry things.

    `size` is width, depth and height, m. `shape` is how it looks, where that is not the shape of its own name. `color` is its
    colour, `variants` are others it may have. For simulators: `friction` on other things (0.3, 0.6 or 0.9), `moves` says whether it is
    `free` to move or `fixed` (by default free where it is light, stands and does not hang), `labels` are semantic classes
    besides its kind, name and category.
    """

    shape: Annotated[str, Names("shape", "a name of shapes/")] | None = None
    size: tuple[Centimetres, Centimetres, Centimetres]
    color: Colour
    variants: tuple[Colour, ...] = ()
    surfaces: tuple[Surface, ...] = ()
    friction: Literal["low", "medium", "high"] = "medium"
    moves: Literal["free", "fixed"] | None = None
    labels: Words = ()


class Use(Entry):
    """Who uses a piece must get to these sides: `any` one of them, or `all`."""

    sides: tuple[Side, ...] = Field(min_length=1)
    need: Literal["any", "all"] = "any"


class Comfort(Entry):
    """Floor at a side of a piece that is better kept free: `depth` m, all but `behind` m.

    That is from its back on at its left and right, and from the piece on at its front, where a piano has its stool. Doing without the
    floor costs `cost`, shared by the sides.
    """

    depth: Metres
    behind: Annotated[float, Field(ge=0, le=10)] = 0.0
    cost: Cost = 0.6


def _comfort(value: Any) -> Any:
    """Lets a number stand for floor so deep along the whole side."""
    return {"depth": value} if isinstance(value, int | float) and not isinstance(value, bool) else value


ComfortFloor = Annotated[Comfort, BeforeValidator(_comfort, json_schema_input_type=Metres | Comfort)]


class Synonym(Entry):
    """What others call a kind, or a room of a type: `known_as`, in small letters. Its key is a kind's (a room type's) where it `means` one.

    It may mean `other`, what we have no kind of, or `nothing`, words that tell of no thing what it is.
    """

    known_as: Words = Field(min_length=1)
    means: Literal["kind", "other", "nothing"] = "kind"
