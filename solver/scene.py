"""Every type of the scene document, with its units.

Frozen dataclasses mirror the document key by key, in its order. Not here: reading and writing (exchange), rules (validate). Frame:
right-handed, x east, y up, z south. Lengths in metres, rotation in degrees about +y, counter-clockwise seen from above, 0 facing south. A
body's `x` and `z` are its footprint's centre, relative to its room's north-west corner; `y` is its underside. Edges lie on integer
millimetres, so a centre may end in 0.0005. Each field's type states what a reader accepts (solver/fields.py); in `extra` it keeps the keys
it does not know.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Final

from annotated_types import Ge, Le, MinLen

from catalogs.assets import ASSET_NAME
from solver.fields import (
    OMITTED,
    REQUIRED,
    STRICT,
    Flag,
    Free,
    Identity,
    Index,
    Matching,
    Number,
    OneOf,
    OpenShare,
    PositiveMetres,
    Record,
    Says,
    Text,
    Whole,
)
from solver.geometry import doubled_area
from solver.records import late

FORMAT: Final = "compose-scene/1"
EXTERIOR: Final = "EXTERIOR"
"""What an opening connects to when it leads outside."""
WALLS: Final = ("north", "south", "east", "west")
WALL_NUMBERS: Final[dict[str | None, int]] = {None: -1, **{wall: number for number, wall in enumerate(WALLS)}}
"""As the core numbers them, and none."""
ROBOT_WIDTH: Final = 0.6
"""Side of the square that must be able to walk, m, where nothing else is said."""
OPENING_KINDS: Final = ("door", "garage_door", "passage", "window")
ADJACENCY: Final = (
    "pairs of rooms, by index, with a common wall long enough for a door; the certificate's `unjoined` are those of them, by id, "
    "that no door or passage joins"
)

WallName = Annotated[str, OneOf(*WALLS)]
OwnAsset = Annotated[str, STRICT, Matching(ASSET_NAME), Says("the name of an own asset: letters, digits and _ . -, never a path")]
RequiredNumber = Annotated[Number, REQUIRED]
RequiredMetres = Annotated[PositiveMetres, REQUIRED]
RobotWidth = Annotated[float, STRICT, Ge(0.1), Le(2.0)]
WallThickness = Annotated[float, STRICT, Ge(0.0), Le(1.0)]


@dataclass(frozen=True)
class Size(Record):
    """Outer extents of the house, m.

    Args:
        width: from west to east.
        depth: from north to south.
        height: of the building.
    """

    width: PositiveMetres
    depth: PositiveMetres
    height: PositiveMetres = 2.8
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Level(Record):
    """One storey.

    Args:
        index: what a room's `level` names.
        elevation: height of its floor, m.
        height: of the storey, m.
    """

    index: Whole = 0
    elevation: Number = 0.0
    height: PositiveMetres = 2.8
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Flooring(Record):
    """What the floor is made of.

    Args:
        type: a name of catalogs/floorings.yaml.
        color: #rrggbb.
    """

    type: Text = "wood"
    color: Text = "#b08d57"
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class WallFinish(Record):
    """What a room's walls are finished with on its side.

    Args:
        type: such as plaster.
        color: #rrggbb.
    """

    type: Text = "plaster"
    color: Text = "#f0ede6"
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class Sides(Record):
    """A yes or no for each of a room's four walls.

    Args:
        north, south, east, west: whether it is so of that wall.
    """

    north: Flag = False
    south: Flag = False
    east: Flag = False
    west: Flag = False


@dataclass(frozen=True)
class Opening(Record):
    """A door, garage door, passage or window in a wall. Both rooms of a door list it under one id.

    Args:
        kind: a passage has no leaf.
        wall: the wall it is in.
        position: its centre along the wall, from the west or north end, m.
        width: along the wall, m.
        height: from its lower edge up, m.
        sill: height of its lower edge, m.
        connects_to: the other room's id, or EXTERIOR.
        hinge: which end of it carries the leaf; start is west or north.
        swing: in: the leaf sweeps the floor of the room that lists it.
        main_entrance: whether it is the front door.
        render_panel: whether a leaf is drawn.
        edge: in a room with an outline the line from that point to the next, in place of `wall`.
        open: how far its leaf stands open, 0 to 1; of the two entries that of the room that draws the leaf counts.
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
    """A piece of furniture.

    Args:
        name: such as sofa; all its sizes have this name.
        category: such as seating.
        x, z: centre of its footprint in the room, m.
        y: its underside, m.
        rotation: degrees; 0 faces south, 90 east.
        width: across its front, unrotated, m.
        depth: from front to back, unrotated, m.
        height: m.
        color: #rrggbb.
        wall: the wall it must stand at.
        under: id of the table it is tucked under.
        on: id of the piece it stands on.
        locked: whether it stays where it is.
        kind: the catalogs' key of what it is; without it, of the kinds called `name` the one nearest in size.
        asset: the own asset that it is shown as.
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
    """A small thing.

    Args:
        name: such as pillow.
        parent: id of the body that carries it.
        mounted_on_wall: the wall it hangs at.
        x, z: centre of its footprint in the room, m.
        y: the surface it rests on, m.
        rotation: degrees; 0 faces south, 90 east.
        width: across its front, unrotated, m.
        depth: from front to back, unrotated, m.
        height: m.
        color: #rrggbb.
        kind: the catalogs' key of what it is, as for furniture.
        asset: the own asset that it is shown as.
    """

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
    """A person or a pet.

    Args:
        kind: person, dog, cat or any word.
        room: the room's id.
        x, z: centre of the footprint in that room, m.
        y: the underside, m.
        rotation: where they look, degrees; 0 faces south, 90 east.
        width: from left to right, m.
        depth: from front to back, m.
        height: m; of who sits, from the seat up.
        color: #rrggbb.
        on: id of the seat they sit on.
    """

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
    """A room: its wall lines' rectangle in the house, and everything in it, relative to its north-west corner.

    Args:
        index: what `adjacency` and seeds call it; its place in the list by default.
        type: a room type, or any word.
        name: what people call it, where they do.
        level: the storey it is on.
        x, z: its north-west corner in the house, m.
        width: of its wall lines' rectangle, from west to east, m.
        depth: of its wall lines' rectangle, from north to south, m.
        outline: its corners, m, clockwise from the north-west, where it is not that rectangle.
        outdoor: whether it is a garden or the like.
        flooring: material and colour of its floor.
        accent: its own colour, #rrggbb.
        walls: what its walls are finished with.
        wall_thickness: of its outer walls by line of the outline, north first, m; null where it is the scene's.
        exterior_walls: which walls are outer walls, wholly or in part.
        wall_flags: which walls it draws; of a shared wall one room does.
        openings: doors, passages and windows.
        furniture: its pieces.
        decorations: small things.
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
    name: Text | None = field(default=None, metadata={OMITTED: True})
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
    """A whole house: the document of /generate, /fix and /validate.

    Args:
        format: the only one there is.
        seed: what the home was drawn from.
        request: everything it takes to make this home again.
        generator: the version of Compose and the mark of its catalogs: a seed means something with these two only.
        size: outer extents of the house, or of the least rectangle around it.
        wall_thickness: of the walls, m.
        levels: storeys.
        rooms: what the house has.
        corridors: of homes that were cut without a hallway: for information only.
        dynamic: people and pets.
        certificate: what was checked and proven.
    """

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


def robot_width_of(scene: Scene) -> float:
    """Returns the side of the square that must be able to walk, m: the request's, or 0.6."""
    width = (scene.request or {}).get("robot_width")
    return float(width) if isinstance(width, int | float) and not isinstance(width, bool) and 0.1 <= width <= 2.0 else ROBOT_WIDTH
