"""The ground of the catalogs' types: what an entry is, the units of its values, and the entries that are small.

Unknown keys are forbidden, everything is frozen. Lengths in metres, areas in m2, masses in kg, angles in degrees.
"""

from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, model_validator

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
_Order = Annotated[tuple[str, ...], Field(max_length=21)]
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


DrawnName = Literal[
    "no_door", "garage_door", "window", "door", "passage", "opening", "wall", "room", "label", "furniture", "outdoors",
    "basement", "ground", "first", "second", "attic", "storey", "storey_layer",
]  # fmt: skip
"""What drawings name: what is drawn, in the order in which it counts, and storeys from the lowest on, last those with a number."""
Weight = Annotated[float, Field(strict=True, ge=-100, le=100, allow_inf_nan=False)]
OfType = dict[Annotated[str, ROOM_TYPE], Weight]
Mark = Literal[
    "typical", "beyond", "width", "long", "no_window", "small_windows", "wet_large", "wet_small", "way_windows", "windows",
    "front", "entrance", "side_door", "side_entrance", "no_garage_door", "no_front", "hall_width", "short_hall", "dead_end",
    "hall_ways", "shut_off", "ways", "outside", "open", "strange_opening", "leaf", "behind", "past", "off_hall", "through", "joined",
    "missing", "usual", "again", "first", "no_first", "later_alone", "miscounted", "beside_pieces",
]  # fmt: skip


class Evidence(Entry):
    """One mark of a room, a door between two, or a home: its `cost`, times what is measured.

    `types` is what the mark has for a type alone, `pairs` what it costs between two. What each mark measures is said in guessing.yaml.
    """

    cost: Weight = 0.0
    types: OfType = Field(default_factory=dict)
    pairs: dict[Annotated[str, ROOM_TYPE], OfType] = Field(default_factory=dict)


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
    def _complete(self) -> "Dweller":
        if ("sits" in self.poses) != (self.seats is not None):
            raise ValueError("`seats` goes with the pose `sits`")
        if self.otherwise and self.per == "room":
            raise ValueError("`otherwise` goes with `per: home`")
        return self


class KeptWall(Entry):
    """A stretch of wall that a floor plan keeps whole where it can, by moving openings along their walls.

    `length` along the wall and `depth` of the floor before it, m, without doors and the squares that stay free at them.
    `under_windows`: windows do not break it. `round_corners`: it may go round one corner. `across`: it faces such a stretch of the
    opposite wall, which is at most so far away; in rooms whose walls are all farther apart that is not asked.
    """

    length: Metres
    depth: Metres
    under_windows: bool = False
    round_corners: bool = False
    across: Metres | None = None


class Plan(Entry):
    """How a floor plan treats the type.

    `habitable`: wants daylight. `wet`: wants its pipes beside other wet rooms. `way_through`: one may walk through it to
    other rooms. `entrance`: the front door may open into it, lower numbers first. `street`: needs an outside wall.
    `swings_in`: leaves open into it (not into hallways). `behind`: types it may lie behind, besides a way through.
    """

    habitable: bool = False
    wet: bool = False
    way_through: bool = False
    entrance: int | None = None
    street: bool = False
    swings_in: bool = True
    passage: bool = False
    """Between two rooms with `passage` an opening without a leaf is cut instead of a door."""
    behind: tuple[Annotated[str, ROOM_TYPE], ...] = ()
    windows: bool = True
    garage_door: bool = False
    keeps: tuple[KeptWall, ...] = ()
    """Walls that are kept whole for what stands along them."""


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

    orders: tuple[Annotated[_Order, BeforeValidator(as_words, json_schema_input_type=str | _Order)], ...] = Field(min_length=1)
    worktop: Words = ()
    landing: Words = ()
    ends: Words = ()
    triangle: Words = ()
    leaves: tuple[Leaving, ...] = ()


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
    def _ordered(self) -> "Home":
        if not self.area[0] <= self.area[1] <= self.area[2]:
            raise ValueError("areas must be ordered: least <= typical <= most")
        if self.width**2 > self.area[1] or self.width * self.width * self.aspect < self.area[0]:
            raise ValueError("no room of this width and aspect has such an area")
        return self

    def larger_by(self, floor: float) -> "Home":
        """Returns the same with so much more floor, m2."""
        least, typical, most = (round(area + floor, 2) for area in self.area)
        return self.model_copy(update={"area": (least, typical, most)})


RoomWord = Annotated[str, Names("word for rooms", "the room types and their words")]


class Preset(Entry):
    """A named programme: how many rooms of each word (cars, for garages), and what it is, in words."""

    rooms: dict[RoomWord, Annotated[int, Field(ge=0, le=12)]] = Field(min_length=1)
    description: str = ""
