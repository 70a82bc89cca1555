"""Every type of the scene document and of the request, with its units.

Comes in: nothing. Goes out: frozen dataclasses that mirror the document key by key, in its order.
May import: errors, fields, what an asset may be called. Not here: reading and writing (exchange), rules (validate).
Frame: right-handed, x east, y up, z south. Lengths in metres, rotation in degrees about +y, counter-clockwise seen from above, 0 facing
south. A body's `x` and `z` are its footprint's centre, relative to its room's north-west corner; `y` is its underside. Edges lie on
integer millimetres, so a centre may end in 0.0005. Each field's type states what a reader accepts (solver/fields.py); in `extra` it
keeps the keys it does not know.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, ClassVar, Final

from annotated_types import Ge, Le, MinLen

from catalogs.assets import ASSET_NAME
from solver.answers import Limited, OfferedRepair, Removal
from solver.fields import (
    MAX_WHOLE,
    OMITTED,
    OUTLINE,
    REQUIRED,
    STRICT,
    WHOLE,
    Counted,
    Flag,
    Free,
    GivenCorners,
    Identity,
    Index,
    Like,
    Matching,
    Name,
    Number,
    OneOf,
    OpenShare,
    PositiveMetres,
    Record,
    Says,
    Text,
    TextByIndex,
    Whole,
    late,
)
from solver.geometry import doubled_area

FORMAT: Final = "compose-scene/1"
MAX_SEED: Final = MAX_WHOLE
EXTERIOR: Final = "EXTERIOR"
"""What an opening connects to when it leads outside."""
WALLS: Final = ("north", "south", "east", "west")
ROBOT_WIDTH: Final = 0.6
"""Side of the square that must be able to walk, m, where nothing else is said."""
PLAIN_SIZE: Final = (20.0, 15.0)
"""Width and depth of a house where nothing else is asked for, m."""
FITTED: Final = "unless a programme or an area chooses it"
NO_ACCESS: Final = "none"
"""Names no profile of access."""
MAX_COUNT: Final = 12
"""Most rooms of one word, or cars, that a programme may count; our choice, more than any home has."""
OPENING_KINDS: Final = ("door", "garage_door", "passage", "window")
SEVERITIES: Final = ("error", "warning")
ADJACENCY: Final = (
    "pairs of rooms, by index, with a common wall long enough for a door; the certificate's `unjoined` are those of them, by id, "
    "that no door or passage joins"
)

WallName = Annotated[str, OneOf(*WALLS)]
OwnAsset = Annotated[str, STRICT, Matching(ASSET_NAME), Says("the name of an own asset: letters, digits and _ . -, never a path")]
RequiredNumber = Annotated[Number, REQUIRED]
RequiredMetres = Annotated[PositiveMetres, REQUIRED]
Seed = Annotated[int, Ge(0), Le(MAX_SEED), WHOLE]
RobotWidth = Annotated[float, STRICT, Ge(0.1), Le(2.0)]
WallThickness = Annotated[float, STRICT, Ge(0.0), Le(1.0)]
Extent = Annotated[float, STRICT, Ge(2.0), Le(1000.0)]


@dataclass(frozen=True)
class Request(Record):
    """What to generate; all optional. Unknown keys are refused.

    `program` counts rooms by word (`{bedrooms: 3, bathrooms: 2, garage: 1}`) or names a preset; `area` is the wished floor of the house,
    m2. With either a home is planned for them, and `width` and `depth`, m, are chosen to fit where they are not given; else the house is
    20 x 15 m and `min_room_size`, `max_depth`, `use_spine` and `force_types` say how its rectangle is cut into rooms. `outline` is that of
    a planned home, none stands for any; or the corners around the house, m, each edge along x or z. `force_types` maps a room's index to a
    room type. `robot_width` is the side, m, of the square that must be able to walk everywhere. `decorate` decorates surfaces, walls and
    floors. `style` names a style. `access` names a profile: its walker must come everywhere, and the certificate tells what else of it is
    met. `people` is whether there are people and pets. `wall_thickness` is that of inner walls, m, 0.1 by default, `outer_wall_thickness`
    that of outer ones, as inner ones by default.
    """

    camel_case: ClassVar[bool] = True

    seed: Annotated[Seed | None, Says("drawn where there is none")] = None
    width: Annotated[Extent | None, Says(f"m, {PLAIN_SIZE[0]:g} {FITTED}")] = None
    depth: Annotated[Extent | None, Says(f"m, {PLAIN_SIZE[1]:g} {FITTED}")] = None
    min_room_size: Annotated[float, STRICT, Ge(1.5), Le(50.0), Says("m, at most the house's shorter side")] = 3.0
    max_depth: Annotated[int, Ge(0), Le(16), WHOLE, Says("how often the rectangle is split")] = 5
    use_spine: Flag = True
    outdoor: Flag = False
    decorate: Flag = False
    force_types: Annotated[TextByIndex, Says("room types by the room's index")] = field(default_factory=dict)
    robot_width: RobotWidth = ROBOT_WIDTH
    program: Annotated[Mapping[str, int] | str | None, Counted(MAX_COUNT), Says("a preset's name, or how many rooms of each word")] = None
    area: Annotated[float, STRICT, Ge(15.0), Le(1000.0)] | None = None
    style: Text | None = None
    outline: Annotated[str | GivenCorners | None, OUTLINE, Says("of a planned home, any by default; or of any home its corners, m")] = None
    access: Annotated[Text | None, Says("a profile of access.yaml, or none")] = None
    people: Annotated[Flag | None, Says("false: nobody is there")] = field(default=None, metadata={OMITTED: True})
    wall_thickness: Annotated[float, STRICT, Ge(0.05), Le(0.24)] | None = field(default=None, metadata={OMITTED: True})
    outer_wall_thickness: Annotated[float, STRICT, Ge(0.05), Le(0.6)] | None = field(default=None, metadata={OMITTED: True})

    @property
    def planned(self) -> bool:
        """Tells whether a home is planned for a programme or a wished area, instead of a rectangle cut into rooms."""
        return self.program is not None or self.area is not None

    @property
    def extents(self) -> tuple[float, float]:
        """Width and depth of a plain request's house, m."""
        return PLAIN_SIZE[0] if self.width is None else self.width, PLAIN_SIZE[1] if self.depth is None else self.depth


@dataclass(frozen=True)
class Size(Record):
    """Outer extents of the house, m."""

    width: PositiveMetres
    depth: PositiveMetres
    height: PositiveMetres = 2.8
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Level(Record):
    """One storey: elevation of its floor and its height, m."""

    index: Whole = 0
    elevation: Number = 0.0
    height: PositiveMetres = 2.8
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Flooring(Record):
    """What the floor is made of: a name of catalogs/floorings.yaml and a colour."""

    type: Text = "wood"
    color: Text = "#b08d57"
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class WallFinish(Record):
    """What a room's walls are finished with on its side, and the colour."""

    type: Text = "plaster"
    color: Text = "#f0ede6"
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Sides(Record):
    """A yes or no for each of a room's four walls."""

    north: Flag = False
    south: Flag = False
    east: Flag = False
    west: Flag = False


@dataclass(frozen=True)
class Opening(Record):
    """A door, garage door, passage or window in a wall.

    `position` is the opening's centre along the wall from its west or north end, m. Both rooms of a door list it under one id. `hinge` is
    the end of the opening that carries the leaf; `swing` is `in` for the room whose floor the leaf sweeps. On an outlined room `edge` (from
    outline point i to the next) replaces `wall`. `open` is how far its leaf stands open, 0 to 1; of the two entries that of the room that
    draws the leaf counts.
    """

    id: Identity
    kind: Annotated[str, OneOf(*OPENING_KINDS)] = "door"
    wall: WallName | None = None
    position: Number = 0.0
    width: PositiveMetres = 0.9
    height: PositiveMetres = 2.1
    sill: Number = 0.0
    connects_to: Text | None = None
    hinge: Annotated[str, OneOf("start", "end")] | None = None
    swing: Annotated[str, OneOf("in", "out")] | None = None
    main_entrance: Flag = False
    render_panel: Flag = True
    edge: Index | None = field(default=None, metadata={OMITTED: True})
    open: OpenShare | None = field(default=None, metadata={OMITTED: True})
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Furniture(Record):
    """A piece of furniture: full unrotated extents, m; `width` is across its front, `depth` front to back.

    `wall` is the wall it must stand at; `under` the table a chair is tucked under, `on` the piece it stands on (ids). `kind` is the
    catalogs' key of what it is; without it, of the kinds called `name` the one nearest in size. `asset` is the name of the own asset
    that it is shown as.
    """

    id: Identity
    name: Text
    category: Text | None = None
    x: RequiredNumber = 0.0
    y: Number = 0.0
    z: RequiredNumber = 0.0
    rotation: Number = 0
    width: RequiredMetres = 0.0
    depth: RequiredMetres = 0.0
    height: RequiredMetres = 0.0
    color: Text | None = None
    wall: WallName | None = None
    under: Text | None = None
    on: Text | None = None
    locked: Flag = False
    kind: Text | None = field(default=None, metadata={OMITTED: True})
    asset: OwnAsset | None = field(default=None, metadata={OMITTED: True})
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Decoration(Record):
    """A small thing: `y` is the surface it rests on; `parent` the body that carries it, if any; `kind` and `asset` as for furniture."""

    id: Identity
    name: Text
    parent: Text | None = None
    mounted_on_wall: WallName | None = None
    x: RequiredNumber = 0.0
    y: Number = 0.0
    z: RequiredNumber = 0.0
    rotation: Number = 0
    width: RequiredMetres = 0.0
    depth: RequiredMetres = 0.0
    height: RequiredMetres = 0.0
    color: Text | None = None
    kind: Text | None = field(default=None, metadata={OMITTED: True})
    asset: OwnAsset | None = field(default=None, metadata={OMITTED: True})
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Dynamic(Record):
    """A person or a pet; `room` is the room's id, the pose relative to that room; `on` the seat one sits on (its id)."""

    id: Identity
    kind: Text = "person"
    room: Text | None = None
    x: Number = 0.0
    y: Number = 0.0
    z: Number = 0.0
    rotation: Number = 0
    width: PositiveMetres = 0.5
    depth: PositiveMetres = 0.3
    height: PositiveMetres = 1.7
    color: Text | None = field(default=None, metadata={OMITTED: True})
    on: Text | None = field(default=None, metadata={OMITTED: True})
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Room(Record):
    """A room: its wall lines' rectangle in the house, m, and everything in it, relative to its north-west corner.

    `outline` lists corner points clockwise from the north-west, room-relative, where the room is not that rectangle; `walls` says what its
    walls are finished with; `wall_thickness` is that of its outer walls by line of the outline, north first, where not the scene's.
    """

    id: Identity
    index: Whole = 0
    type: Text = "room"
    level: Whole = 0
    x: Number = 0.0
    z: Number = 0.0
    width: RequiredMetres = 0.0
    depth: RequiredMetres = 0.0
    outline: Annotated[tuple[tuple[Number, Number], ...], MinLen(4)] | None = None
    outdoor: Flag = False
    flooring: Flooring | None = None
    accent: Text | None = None
    walls: WallFinish | None = field(default=None, metadata={OMITTED: True})
    wall_thickness: tuple[WallThickness | None, ...] | None = field(default=None, metadata={OMITTED: True})
    exterior_walls: Sides | None = None
    wall_flags: Sides | None = None
    openings: tuple[Opening, ...] = ()
    furniture: tuple[Furniture, ...] = late(())
    decorations: tuple[Decoration, ...] = late(())
    extra: Mapping[str, object] = field(default_factory=dict)

    @property
    def floor_m2(self) -> float:
        """Its floor between wall lines, m2."""
        return abs(doubled_area(self.outline)) / 2 if self.outline else self.width * self.depth

    @property
    def corners(self) -> tuple[tuple[float, float], ...]:
        """The corners of its wall lines, as its outline lists them; a rectangle's clockwise from the north-west."""
        return self.outline or ((0.0, 0.0), (self.width, 0.0), (self.width, self.depth), (0.0, self.depth))


@dataclass(frozen=True)
class Scene(Record):
    """A whole house: the document of /generate, /fix and /validate."""

    format: Annotated[str, OneOf(FORMAT)] = FORMAT
    seed: Whole | None = None
    request: Free | None = None
    generator: Free | None = None
    size: Size | None = None
    wall_thickness: WallThickness = 0.0
    levels: tuple[Level, ...] = ()
    rooms: tuple[Room, ...] = ()
    corridors: tuple[Free, ...] = ()
    adjacency: Annotated[tuple[tuple[Whole, Whole], ...], Says(ADJACENCY)] = ()
    dynamic: tuple[Dynamic, ...] = ()
    certificate: Free | None = None
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Issue(Record):
    """One broken rule: its name, the room's id, the ids of the bodies, and by how much, m."""

    rule: str
    severity: Annotated[str, OneOf(*SEVERITIES)]
    room: str | None
    ids: tuple[str, ...]
    amount: float
    message: str


@dataclass(frozen=True)
class Conflict(Record):
    """Bodies that cannot stand together, why, and what would help."""

    ids: tuple[str, ...]
    message: str
    repairs: tuple[Annotated[Mapping[str, object], Like(OfferedRepair)], ...] = ()


@dataclass(frozen=True)
class Move(Record):
    """How far /fix moved a body, m, and the rotation it has now, degrees."""

    id: str
    dx: float
    dz: float
    rotation: float


@dataclass(frozen=True)
class Pose(Record):
    """Where a body was in the last answer of /fix: its footprint's centre in its room, m, and its rotation, degrees."""

    id: Name
    x: Number
    z: Number
    rotation: Number = 0


@dataclass(frozen=True)
class Generated(Record):
    """The answer of generate: the scene, what the validator says, and stage times in ms."""

    scene: Scene
    issues: tuple[Issue, ...]
    timing_ms: Mapping[str, float]
    limited: Limited | None = field(default=None, metadata={OMITTED: True})


@dataclass(frozen=True)
class Fixed(Record):
    """The answer of fix."""

    scene: Scene
    moves: tuple[Move, ...]
    removed: tuple[Annotated[Mapping[str, str], Like(Removal)], ...]
    conflicts: tuple[Conflict, ...]
    issues: tuple[Issue, ...]
    timing_ms: Mapping[str, float]
    understood_as: Mapping[str, str] = field(default_factory=dict)
    """By id, what a piece was taken for that is called by no name of the catalogs."""
    limited: Limited | None = field(default=None, metadata={OMITTED: True})


def robot_width_of(scene: Scene) -> float:
    """Returns the side of the square that must be able to walk, m: the request's, or 0.6."""
    width = (scene.request or {}).get("robot_width")
    return float(width) if isinstance(width, int | float) and not isinstance(width, bool) and 0.1 <= width <= 2.0 else ROBOT_WIDTH
