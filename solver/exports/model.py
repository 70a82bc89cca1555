"""The description of a house that every format is written from: what there is, where, how large, how heavy, in which colour.

Not here: how a scene becomes one (describing).

Frame: the scene's own, right-handed, x east, y up, z south, in house coordinates, m; turns in degrees about +y, counter-clockwise
seen from above, 0 facing south (+z). Each format converts it once, in its module.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from catalogs.assets.asset_entry import Asset
from catalogs.fronts import BodyFront
from solver.body_parts import BodyPart
from solver.geometry import extents, turned_back
from solver.scene import Scene

Sort = Literal["furniture", "decoration", "dynamic"]
Point = tuple[float, float, float]


class Paint(NamedTuple):
    """How a surface looks: its sRGB colour (#rrggbb) and shares from 0 to 1; `texture` names what whoever draws may draw on it."""

    color: str
    roughness: float = 0.8
    metalness: float = 0.0
    opacity: float = 1.0
    glow: float = 0.0
    texture: str | None = None


class Cuboid(NamedTuple):
    """An axis-aligned box in the house, m."""

    x0: float
    y0: float
    z0: float
    x1: float
    y1: float
    z1: float

    @property
    def middle(self) -> Point:
        """Its centre, m."""
        return (self.x0 + self.x1) / 2, (self.y0 + self.y1) / 2, (self.z0 + self.z1) / 2

    @property
    def size(self) -> Point:
        """Its extents along x, y and z, m."""
        return self.x1 - self.x0, self.y1 - self.y0, self.z1 - self.z0


class ModelBody(NamedTuple):
    """A piece of furniture, a decoration, a person or a pet.

    `x` and `z` are the middle of its footprint and `y` its underside in the house, m; `turn` in degrees; `mass` in kg; `friction` is a
    coefficient. `kind` is the catalogs' key (None: they do not know it), `shape` that of its shape. `parent` is the id of what carries it.
    `hung`: it hangs on a wall; `fixed`: it never moves in a simulator; `flat`: a rug or mat, which others stand through. `parts` and
    `paints` go together. `uses` are the points on the floor (x, z, turn) from which it is used, facing it. `fronts` is what opens, in m.
    `asset` is the name, in `HouseModel.assets`, of what it is shown as; it collides as its parts all the same.
    """

    id: str
    sort: Sort
    name: str
    kind: str | None
    category: str
    room: str | None
    x: float
    y: float
    z: float
    turn: float
    width: float
    depth: float
    height: float
    mass: float
    friction: float
    parent: str | None
    hung: bool
    fixed: bool
    flat: bool
    shape: str
    parts: tuple[BodyPart, ...]
    paints: tuple[Paint, ...]
    labels: tuple[str, ...] = ()
    uses: tuple[tuple[float, float, float], ...] = ()
    fronts: tuple[BodyFront, ...] = ()
    asset: str | None = None

    @property
    def footprint(self) -> tuple[float, float, float, float]:
        """The rectangle along the axes round its turned footprint: west, north, east, south, m."""
        half_x, half_z = (extent / 2 for extent in extents(self.width, self.depth, self.turn))
        return self.x - half_x, self.z - half_z, self.x + half_x, self.z + half_z

    def local(self, x: float, z: float) -> tuple[float, float]:
        """Returns a point of the house from the middle of its footprint, in its own frame, m: to its right, to its front."""
        return turned_back(x - self.x, z - self.z, self.turn)


class PanelHole(NamedTuple):
    """An opening in a wall panel: along the wall's line in the house, and above the panel's foot, m."""

    opening: str
    start: float
    end: float
    low: float
    high: float


@dataclass(frozen=True)
class WallPanel:
    """A straight wall along one axis: from `start` to `end` along it, its middle on `line`, holes cut out.

    `seams` are where its finish may change.
    """

    axis: Literal["x", "z"]
    line: float
    start: float
    end: float
    thickness: float
    elevation: float
    height: float
    level: int
    holes: tuple[PanelHole, ...]
    seams: tuple[float, ...]


class WallBox(NamedTuple):
    """A solid piece of a wall: between holes, under a sill, over a head; painted by the rooms that its two long faces look into.

    `lesser` is the paint of the face towards smaller coordinates across the wall, `greater` of the other, `rest` of all else.
    """

    axis: Literal["x", "z"]
    box: Cuboid
    lesser: Paint
    greater: Paint
    rest: Paint


class Fitting(NamedTuple):
    """What is fitted to a wall: a frame, a threshold, a pane, a part of a railing."""

    surface: Literal["railing", "frame", "threshold", "glass"]
    box: Cuboid
    paint: Paint


@dataclass(frozen=True)
class PlacedOpening:
    """A door, garage door, passage or window on the middle line of a wall so thick in the house, m; both rooms' entries are one.

    `hinge` is the end that carries the leaf, `towards` the side of the line it swings to (1: greater coordinates). `rooms` are the
    ids of the rooms towards greater and smaller coordinates (None: outside).
    """

    id: str
    kind: str
    level: int
    axis: Literal["x", "z"]
    line: float
    thickness: float
    start: float
    end: float
    sill: float
    head: float
    hinge: Literal["start", "end"]
    towards: Literal[1, -1]
    is_main_entrance: bool
    open: float = 0.0
    rooms: tuple[str | None, str | None] = (None, None)

    @property
    def middle(self) -> tuple[float, float]:
        """Its middle on its line, (x, z), m."""
        along = (self.start + self.end) / 2
        return (along, self.line) if self.axis == "x" else (self.line, along)


@dataclass(frozen=True)
class DoorLeaf:
    """A leaf that turns about its hinge, or a panel that rolls up.

    `hinge` is the lower end of its turning axis, m; closed it points along `closed` (degrees about +y from +x), and opening adds `swing`
    degrees; it stands `open` (0 to 1). Its parts are in its own frame: the middle of its width at the origin, the hinge at -width / 2.
    A wide door has two: the second's id is the door's with `/2`.
    """

    id: str
    opening: str
    motion: Literal["swing", "roll"]
    look: str
    hinge: Point
    width: float
    height: float
    thickness: float
    closed: float
    swing: float
    mass: float
    parts: tuple[BodyPart, ...]
    paints: tuple[Paint, ...]
    open: float = 0.0

    @property
    def wide_open(self) -> float:
        """Its turn about +y where it is open as far as it goes, degrees; closed where it rolls."""
        return self.closed + (self.swing if self.motion == "swing" else 0.0)

    def middle(self, turn: float) -> tuple[float, float]:
        """Returns where the middle of its width is, (x, z), m, when it is turned so."""
        angle, half = math.radians(turn), self.width / 2
        return self.hinge[0] + math.cos(angle) * half, self.hinge[2] - math.sin(angle) * half

    @property
    def opened(self) -> float:
        """How far it stands open: degrees, of what rolls up m."""
        return self.open * (self.swing if self.motion == "swing" else self.height)


@dataclass(frozen=True)
class FloorPlate:
    """A room: its floor's corners (x, z) in the house, clockwise from the north-west, seen from above, m.

    `outer` is how thick its outer walls are, m, by edge, where the house's thickness is not meant; none where it always is. `name` is what
    people call it, where they do.
    """

    id: str
    type: str
    level: int
    outdoor: bool
    corners: tuple[tuple[float, float], ...]
    elevation: float
    ceiling: float
    paint: Paint
    area: float
    outer: tuple[float | None, ...] = ()
    name: str | None = None


@dataclass(frozen=True)
class HouseModel:
    """A house, described for export. `warnings` say what is wrong with the scene; formats carry them inside."""

    scene: Scene
    name: str
    bodies: tuple[ModelBody, ...]
    panels: tuple[WallPanel, ...]
    walls: tuple[WallBox, ...]
    fittings: tuple[Fitting, ...]
    openings: tuple[PlacedOpening, ...]
    leaves: tuple[DoorLeaf, ...]
    rooms: tuple[FloorPlate, ...]
    thickness: float
    warnings: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ()
    """Every kind of furniture that the catalogs know, in order: what training counts as classes, the same for all houses."""
    categories: tuple[str, ...] = ()
    """Every category that the catalogs know, in order."""
    assets: Mapping[str, Asset] = field(default_factory=dict)
    """The own assets that bodies are shown as, by name."""

    def origin(self) -> Iterator[str]:
        """Yields in words which seed and catalog made it, and its warnings."""
        made = self.scene.generator or {}
        yield f"seed {self.scene.seed}, Compose {made.get('version')}, catalog {made.get('catalog')}"
        yield from (f"warning: {warning}" for warning in self.warnings)

    def railings(self, room: FloorPlate) -> list[Cuboid]:
        """Returns the parts of the railings of a room's storey."""
        return [one.box for one in self.fittings if one.surface == "railing" and room.elevation <= one.box.y0 < room.ceiling]

    @property
    def levels(self) -> list[int]:
        """The levels that have rooms, the lowest first; 0 where there is none."""
        return sorted({room.level for room in self.rooms}) or [0]

    @property
    def leaves_by_opening(self) -> dict[str, list[DoorLeaf]]:
        """The leaves of each opening that has any, the one at its hinge first."""
        found: dict[str, list[DoorLeaf]] = {}
        for leaf in self.leaves:
            found.setdefault(leaf.opening, []).append(leaf)
        return found
