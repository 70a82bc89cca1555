"""The types that describe the catalogs' data. Unknown keys are forbidden, everything is frozen.

Lengths in metres, areas in m2, masses in kg, angles in degrees. A body's sides are those of the unrotated body, which
faces south: `front` is south (+z), `back` north, `left` west (-x), `right` east (+x).
"""

from collections.abc import Collection
from functools import lru_cache
from hashlib import blake2b
from itertools import chain
from math import sqrt
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, ValidationError, model_validator
from pydantic.json_schema import SkipJsonSchema

from catalogs.access_profiles import AccessProfile
from catalogs.assets.asset_entry import Asset
from catalogs.decoration_types import Decorating, DecorationKind
from catalogs.entries import (
    ORDERED,
    PIECE_NAMES,
    Category,
    Colour,
    ComfortFloor,
    Cost,
    DrawnName,
    Dweller,
    Entry,
    Evidence,
    FlooringName,
    GapInterval,
    Home,
    KindName,
    KindSpec,
    Mark,
    Metres,
    Plan,
    Preset,
    Probability,
    RoomTypeNames,
    Run,
    Side,
    Synonym,
    Use,
    Words,
)  # fmt: skip
from catalogs.misfits import misfit
from catalogs.shapes import Material, Solid
from catalogs.styles import Style

RelationWord = Literal[
    "against_wall", "in_corner", "beside", "in_front_of", "opposite", "facing", "near", "far_from", "around",
    "aligned_with", "centred", "in_row", "at_window", "near_door", "far_from_door", "on", "under",
]  # fmt: skip


class FurnitureSpec(KindSpec):
    """One kind of furniture. `stands: wall` means that its back is 3 cm from a wall's face.

    `name` is what scenes call it, where that is not the kind's own name: size variants of a sofa are all a `sofa`.
    """

    category: Category
    name: str | None = None
    mass: Annotated[float, Field(gt=0, le=5000)]
    stands: Literal["wall", "free"]
    use: Use | None = None
    comfort: dict[Side, ComfortFloor] = Field(default_factory=dict)
    """Floor that is better kept free at a side, m deep: wished, never asked."""


class RelationSpec(Entry):
    """One relation of a piece to the room or to other pieces; docs/relations.md says what each type means.

    Args:
        type: the relation.
        of: other pieces by their names, any of them will do; or an opening: door, garage_door, window, front_door.
        required: whether it has to hold.
        cost: what it costs to do without it.
        weight: how much it pulls towards it, per m2.
        distance: a wished distance, m.
        gap: the free space between two bodies, m, one number or [least, most]; negative: tucked under.
        sides: sides of the piece `of`, most wanted first.
        align: how a piece beside another lines up with it.
        walls: for against_wall: costs by what a wall has, such as {door: 2, window: 1}.
        wall: for two pieces: how their walls should lie.
    """

    type: RelationWord
    of: Words = ()
    required: Annotated[bool, Field(strict=True)] = False
    cost: Cost = 2.0
    weight: Annotated[float, Field(strict=True, ge=0, le=20)] = 0.3
    distance: Annotated[float, Field(strict=True, ge=0, le=100)] | None = None
    gap: GapInterval | None = None
    sides: tuple[Side, ...] = ()
    align: Literal["back", "centre", "front", "any"] | None = None
    walls: dict[Literal["door", "window", "exterior", "plain", "short", "long", "across"], Cost] = Field(default_factory=dict)
    wall: Literal["same", "opposite", "adjacent", "other"] | None = None

    if not TYPE_CHECKING:

        def __init__(self, **said: Any) -> None:
            """Makes one that is written in Python.

            Raises:
                ValueError: names the key, and what is allowed.
            """
            try:
                super().__init__(**said)
            except ValidationError as error:
                wrong = misfit(error, type(self).model_json_schema())
                words = f" (allowed: {wrong.allowed})" if wrong.allowed else ""
                raise ValueError(f"{'.'.join(map(str, wrong.at))}: {wrong.problem}{words}") from None

        __init__.__pydantic_base_init__ = True  # what pydantic reads goes past it


class Habit(Entry):
    """Where a piece usually stands, in lists that say nothing of it: the first of its `ways` whose other pieces are there."""

    ways: tuple[Annotated[tuple[RelationSpec, ...], Field(min_length=1)], ...] = Field(min_length=1)


class Variant(Entry):
    """A size variant of a wanted piece: a kind of furniture, what settling for it costs, and the area of rooms it is for, m2.

    It is for rooms of `min_area` and more, below `max_area`: from there on another piece is that kind, as the shower beside a tub.
    `corner`: it stands only in the corner of a run, where what stands round the corner hides that end of its front.
    """

    kind: KindName
    cost: Cost = 0.0
    min_area: Annotated[float, Field(ge=0)] = 0.0
    max_area: Annotated[float, Field(gt=0)] | None = None
    corner: Literal["left", "right"] | None = None


class PieceSpec(Entry):
    """A piece a room type holds. The order of pieces in the file is their importance.

    `piece` is its name inside the room type; `kinds` its size variants from wanted down to least (default: the kind of
    the same name). An optional piece is wanted only where the room has `min_area` m2, and then with probability
    `chance`. `count` copies are wanted; with `per_area` a seed draws between half and all of one for every so many m2, at
    least one and at most `count`. A required piece is wanted in its whole count and takes no `chance` or `per_area`; below its
    `min_area` it is optional.
    `approach` are sides that must stay reachable besides the kind's own use: a desk's front, before its chair comes.
    `with_next`: an optional piece that is left out where the piece after it, which only stands with it or those before it, finds no place.
    `without`: the piece is wanted only in a home planned without rooms of these types: a bed where there is no bedroom.
    `unless`: the piece is not wanted in a home that has a room of these types: a dining table beside a dining room.
    `unless_elsewhere`: nor where one of these pieces, as scenes call them, stands in a room of a type that asks nothing of the kind.
    `entered`: the piece is wanted only in the room that the home's main entrance leads into: a coat rack.
    `among`: neighbours in the list with the same word matter alike: a seed draws their order.
    """

    piece: str
    kinds: tuple[Variant, ...] = ()
    required: bool = False
    count: Annotated[int, Field(ge=1, le=24)] = 1
    per_area: Annotated[float, Field(gt=0)] | None = None
    min_area: Annotated[float, Field(ge=0)] = 0.0
    chance: Probability = 1.0
    skip_cost: Cost = 10.0
    approach: tuple[Side, ...] = ()
    with_next: bool = False
    without: RoomTypeNames = ()
    unless: RoomTypeNames = ()
    unless_elsewhere: Annotated[Words, PIECE_NAMES] = ()
    entered: bool = False
    among: str | None = None
    rules: tuple[RelationSpec, ...] = ()

    @model_validator(mode="after")
    def _certain(self) -> "PieceSpec":
        if self.required and (self.chance < 1 or self.per_area):
            raise ValueError("a required piece takes no chance or per_area")
        return self

    @property
    def variants(self) -> tuple[Variant, ...]:
        """The size variants, wanted first; never empty."""
        return self.kinds or (Variant(kind=self.piece),)


class Area(Entry):
    """Floor area between wall lines, m2. `min` is by number of doors: one, two and more."""

    min: tuple[Metres, Metres]
    typical: Metres
    max: Annotated[float, Field(gt=0, le=10000)]

    @model_validator(mode="after")
    def _ordered(self) -> "Area":
        if not self.min[0] <= self.min[1] <= self.max or not self.min[0] <= self.typical <= self.max:
            raise ValueError("areas must be ordered: min (one door) <= min (two doors) <= max, min <= typical <= max")
        return self


class RoomType(Entry):
    """A room type: its areas, floor, accent colour, what it holds and by which relations.

    `requires` lists what the validator asks for: each line is met by any of its kinds in that number. `cover` is the range
    of the share of the floor that furniture covers in homes that people live in: optional pieces are added until a share
    drawn from it is reached.
    """

    outdoor: bool = False
    area: Area
    short_side: Metres = 2.4
    aspect: Annotated[float, Field(ge=1, le=20)] = 2.0
    flooring: FlooringName
    accent: Colour
    plan: Plan = Plan()
    home: Home | None = None
    requires: tuple[dict[Annotated[str, PIECE_NAMES], Annotated[int, Field(ge=1, le=12)]], ...] = ()
    cover: Annotated[tuple[Probability, Probability], ORDERED] | None = None
    run: Run | None = None
    pieces: tuple[PieceSpec, ...] = ()


class FlooringSpec(Entry):
    """A flooring material and its colour."""

    color: Colour


class Catalogs(Entry):
    """Everything the project knows, by name; `fingerprint` identifies the exact data that homes follow from (hex, 12 digits)."""

    furniture: dict[str, FurnitureSpec]
    floorings: dict[str, FlooringSpec]
    rooms: dict[str, RoomType]
    decorations: dict[str, DecorationKind] = Field(default_factory=dict)
    decorating: dict[str, Decorating] = Field(default_factory=dict)
    styles: dict[str, Style] = Field(default_factory=dict)
    presets: dict[str, Preset] = Field(default_factory=dict)
    people: dict[str, Dweller] = Field(default_factory=dict)
    materials: dict[str, Material] = Field(default_factory=dict)
    shapes: dict[str, tuple[Solid, ...]] = Field(default_factory=dict)
    """Written out for every kind of furniture and decoration that has one."""
    synonyms: dict[str, Synonym] = Field(default_factory=dict)
    room_names: dict[str, Synonym] = Field(default_factory=dict)
    drawn_names: dict[DrawnName, Synonym] = Field(default_factory=dict)
    guessing: dict[Mark, Evidence] = Field(default_factory=dict)
    habits: dict[str, Habit] = Field(default_factory=dict)
    access: dict[str, AccessProfile] = Field(default_factory=dict)
    assets: dict[str, Asset] = Field(default_factory=dict)
    profile: SkipJsonSchema[AccessProfile | None] = Field(default=None, exclude=True)
    home: SkipJsonSchema[str] = Field(default="", exclude=True)
    """Never written in a file: what standard homes are made for (`for_access`), and whose room types these are (`of_home`, `holding`)."""
    fingerprint: str

    def __hash__(self) -> int:
        """Equal catalogs have equal fingerprints, so that what is worked out is kept by them; those of other homes need no comparing."""
        return hash((self.fingerprint, self.home))

    def for_access(self, name: str | None) -> "Catalogs":
        """Returns the catalogs for homes that are made for a profile, by its name; the same ones where there is none of it."""
        return _for_access(self, name) if name in self.access else self

    def widened(self, more_mm: int) -> "Catalogs":
        """Returns the catalogs for homes whose rooms are planned larger by so many mm, for thicker inner walls or wider ways."""
        return _widened(self, more_mm) if more_mm else self

    def of_home(self, types: Collection[str], planned: bool = True) -> "Catalogs":
        """Returns the catalogs of a home with rooms of these types.

        Pieces are not wanted `unless` it has no such room; in a planned home those that it needs `without` rooms it does not have are.
        """
        return _of_home(self, _deciding_types(self).intersection(types), planned)

    def asking_types(self) -> frozenset[str]:
        """Returns the room types in which what is wanted depends on what other rooms hold."""
        return _asking_types(self)

    def holding(self, pieces: Collection[str]) -> "Catalogs":
        """Returns the catalogs of a home that holds these pieces in rooms that do not ask: what others want `unless_elsewhere` is gone."""
        every = (piece for name in self.asking_types() for piece in self.rooms[name].pieces)
        there = frozenset(name for piece in every for name in piece.unless_elsewhere if name in pieces)
        return _holding(self, there) if there else self

    def name_of(self, kind: str) -> str:
        """Returns what scenes call a kind: its `name`, else the kind itself."""
        entry = self.furniture.get(kind)
        return entry.name if entry and entry.name else kind

    def kinds_by_name(self) -> dict[str, FurnitureSpec]:
        """Returns the kinds by what scenes call them; a kind of that very name goes before size variants."""
        named = {entry.name or kind: entry for kind, entry in reversed(self.furniture.items())}
        return named | {kind: entry for kind, entry in self.furniture.items() if (entry.name or kind) == kind}

    def use_sides(self) -> dict[str, tuple[tuple[Side, ...], bool]]:
        """Returns from which sides pieces are used, and whether all of them are needed, by what scenes call them."""
        return {name: (kind.use.sides, kind.use.need == "all") for name, kind in self.kinds_by_name().items() if kind.use}


@lru_cache(maxsize=16)
def _for_access(catalogs: Catalogs, name: str) -> Catalogs:
    """Returns the catalogs with what a profile asks for; the same object for the same catalogs, as what is compiled is kept by it."""
    profile = catalogs.access[name]
    made_from = blake2b(f"{catalogs.fingerprint} {profile.model_dump_json()}".encode(), digest_size=6)
    rooms = dict(catalogs.rooms)
    for room, size in profile.homes.items():
        kind = rooms[room]
        if kind.home is not None:
            rooms[room] = kind.model_copy(update={"home": kind.home.model_copy(update={"area": size.area, "width": size.width})})
    rooms = {
        room: of.model_copy(update={"pieces": tuple(_farther_off(piece, room, profile) for piece in of.pieces)})
        for room, of in rooms.items()
    }
    return catalogs.model_copy(update={"rooms": rooms, "profile": profile, "fingerprint": made_from.hexdigest()})


def _farther_off(piece: PieceSpec, room: str, profile: AccessProfile) -> PieceSpec:
    """Returns a piece so far before others as a profile asks for in rooms of a type; no longer required where it gives way."""
    rules = tuple(_before(rule, max((profile.deep(of, room) for of in rule.of), default=0.0)) for rule in piece.rules)
    return piece if rules == piece.rules else piece.model_copy(update={"required": False, "rules": rules})


def _before(rule: RelationSpec, deep: float) -> RelationSpec:
    """Returns a relation that leaves floor so deep, m, before the piece that another one stands in front of."""
    if rule.type != "in_front_of" or not rule.gap or rule.gap[0] >= deep:
        return rule
    return rule.model_copy(update={"gap": (deep, max(rule.gap[1], deep))})


@lru_cache(maxsize=16)
def _widened(catalogs: Catalogs, more_mm: int) -> Catalogs:
    """Returns the catalogs with the sizes of rooms that are longer and wider by so much, what is left of their floors as large as ever."""
    made_from = blake2b(f"{catalogs.fingerprint} wider {more_mm}".encode(), digest_size=6)
    rooms = {name: _wider(kind, more_mm / 1000) for name, kind in catalogs.rooms.items()}
    return catalogs.model_copy(update={"rooms": rooms, "fingerprint": made_from.hexdigest()})


def _wider(kind: RoomType, more: float) -> RoomType:
    home = kind.home
    if home is None:
        return kind
    around = more * (1 + home.aspect) / sqrt(home.aspect)  # of a room as long as it may be, a side's share of its floor's root
    area = tuple(round(((around + sqrt(around**2 + 4 * (one - more**2))) / 2) ** 2, 3) for one in home.area)
    length = home.length and round(home.length + more, 3)
    return kind.model_copy(update={"home": home.model_copy(update={"area": area, "width": round(home.width + more, 3), "length": length})})


@lru_cache(maxsize=64)
def _holding(catalogs: Catalogs, there: frozenset[str]) -> Catalogs:
    """Returns the catalogs of a home with some pieces; the same object each time."""
    rooms = {}
    for name, room in catalogs.rooms.items():
        pieces = tuple(piece for piece in room.pieces if there.isdisjoint(piece.unless_elsewhere))
        rooms[name] = room if len(pieces) == len(room.pieces) else room.model_copy(update={"pieces": pieces})
    return catalogs.model_copy(update={"rooms": rooms, "home": f"{catalogs.home} holding {sorted(there)}"})


@lru_cache(maxsize=16)
def _asked_types(catalogs: Catalogs) -> dict[str, frozenset[str]]:
    """Returns the room types that are furnished by what other rooms their home has, each with the types that decide."""
    asked = {name: frozenset(chain.from_iterable((*p.unless, *p.without) for p in room.pieces)) for name, room in catalogs.rooms.items()}
    return {name: types for name, types in asked.items() if types}


@lru_cache(maxsize=64)
def _asking_types(catalogs: Catalogs) -> frozenset[str]:
    return frozenset(name for name, room in catalogs.rooms.items() if any(piece.unless_elsewhere for piece in room.pieces))


@lru_cache(maxsize=16)
def _deciding_types(catalogs: Catalogs) -> frozenset[str]:
    """Returns the room types that decide how others are furnished."""
    return frozenset(chain.from_iterable(_asked_types(catalogs).values()))


@lru_cache(maxsize=64)
def _of_home(catalogs: Catalogs, there: frozenset[str], planned: bool) -> Catalogs:
    """Returns the catalogs of a home, of whose rooms' types only those count that decide; the same object each time."""
    rooms = {name: _room_at_home(catalogs, name, there & asked, planned) for name, asked in _asked_types(catalogs).items()}
    return catalogs.model_copy(update={"rooms": {**catalogs.rooms, **rooms}, "home": f"{sorted(there)}, planned: {planned}"})


@lru_cache(maxsize=256)
def _room_at_home(catalogs: Catalogs, name: str, there: frozenset[str], planned: bool) -> RoomType:
    """Returns a room type as it is in a home with rooms of some types, the same object each time: what is compiled is kept by it."""
    room = catalogs.rooms[name]
    pieces = tuple(piece for piece in room.pieces if there.isdisjoint(piece.unless))
    if len(pieces) < len(room.pieces):
        room = room.model_copy(update={"pieces": pieces})
    more = [piece for piece in pieces if planned and piece.without and there.isdisjoint(piece.without)]
    if not more:
        return room
    sizes = [catalogs.furniture[piece.variants[0].kind].size for piece in more]
    cover = sum(width * depth for width, depth, _ in sizes) / room.area.typical
    pieces = tuple(piece.model_copy(update={"without": ()}) if piece in more else piece for piece in pieces)
    wished = tuple(min(share + cover, 1.0) for share in room.cover) if room.cover else None
    home = room.home
    if home and catalogs.profile:
        home = home.larger_by(sum(map(catalogs.profile.floor_of, (catalogs.name_of(one.variants[0].kind) for one in more), sizes)))
    return room.model_copy(update={"pieces": pieces, "cover": wished, "home": home})
