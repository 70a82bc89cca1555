"""Every type of the scene document and of the request, with its units.

Comes in: nothing. Goes out: frozen dataclasses that mirror the document key by key, in its order.
May import: errors. Not here: reading and writing (exchange), rules (validate).

Frame: right-handed, x east, y up, z south. Lengths in metres, rotation in degrees about +y, counter-clockwise seen
from above, 0 facing south. A body's `x` and `z` are its footprint's centre, relative to its room's north-west corner;
`y` is its underside. Edges lie on integer millimetres, so a centre may end in 0.0005.

Field metadata states what a reader accepts (`positive`, `at_least`, `at_most`, `choices`); the reader and the published
JSON Schema are both derived from it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

from solver.errors import SceneError

FORMAT: Final = "compose-scene/1"
MAX_SEED: Final = 2**53 - 1
"""Largest seed: the largest integer that every JSON reader keeps exactly."""
MAX_LENGTH: Final = 1000.0
"""Largest size of anything in a scene, m."""
EXTERIOR: Final = "EXTERIOR"
"""What an opening connects to when it leads outside."""
WALLS: Final = ("north", "south", "east", "west")
ROBOT_WIDTH: Final = 0.6
"""Side of the square that must be able to walk, m, where nothing else is said (contract)."""
PLAIN_SIZE: Final = (20.0, 15.0)
"""Width and depth of a house where nothing else is asked for, m (contract)."""
FITTED: Final = "chosen to fit where a programme or an area is asked for"
MAX_COUNT: Final = 12
"""Most rooms of one word, or cars, that a programme may count; our choice, more than any home has."""
OPENING_KINDS: Final = ("door", "garage_door", "passage", "window")
SEVERITIES: Final = ("error", "warning")


def _length(**more: Any) -> Any:
    """Declares a required size in metres: finite, > 0 and <= MAX_LENGTH."""
    return field(metadata={"positive": True, "at_most": MAX_LENGTH, **more})


def _extra() -> Any:
    """Declares where a reader keeps the keys it does not know."""
    return field(default_factory=dict)


@dataclass(frozen=True)
class Request:
    """What to generate; all optional. Unknown keys are refused.

    `program` counts rooms by word (`{bedrooms: 3, bathrooms: 2, garage: 1}`) or names a preset; `area` is the wished
    floor of the house, m2. With either a home is planned for them, and `width` and `depth`, m, are chosen to fit where
    they are not given; else the house is 20 x 15 m and `min_room_size`, `max_depth`, `use_spine` and `force_types` say
    how its rectangle is cut into rooms. `force_types` maps a room's index to a room type. `robot_width` is the side, m,
    of the square that must be able to walk everywhere. `decorate` dresses surfaces, walls and floors. `style` names a style.
    """

    seed: int | None = field(default=None, metadata={"at_least": 0, "at_most": MAX_SEED})
    width: float | None = field(default=None, metadata={"at_least": 2.0, "at_most": 1000.0, "says": f"{PLAIN_SIZE[0]:g} m; {FITTED}"})
    depth: float | None = field(default=None, metadata={"at_least": 2.0, "at_most": 1000.0, "says": f"{PLAIN_SIZE[1]:g} m; {FITTED}"})
    min_room_size: float = field(default=3.0, metadata={"at_least": 1.5, "at_most": 50.0})
    max_depth: int = field(default=5, metadata={"at_least": 0, "at_most": 16})
    use_spine: bool = True
    outdoor: bool = False
    decorate: bool = False
    force_types: Mapping[int, str] = field(default_factory=dict)
    robot_width: float = field(default=ROBOT_WIDTH, metadata={"at_least": 0.1, "at_most": 2.0})
    program: Mapping[str, int] | str | None = field(default=None, metadata={"at_least": 0, "at_most": MAX_COUNT})
    area: float | None = field(default=None, metadata={"at_least": 15.0, "at_most": 1000.0})
    style: str | None = None

    @property
    def planned(self) -> bool:
        """Tells whether a home is planned for a programme or a wished area, instead of a rectangle cut into rooms."""
        return self.program is not None or self.area is not None

    @property
    def extents(self) -> tuple[float, float]:
        """Width and depth of a plain request's house, m."""
        width, depth = PLAIN_SIZE
        return (width if self.width is None else self.width, depth if self.depth is None else self.depth)


@dataclass(frozen=True)
class Size:
    """Outer extents of the house, m."""

    width: float = _length()
    depth: float = _length()
    height: float = field(default=2.8, metadata={"positive": True, "at_most": MAX_LENGTH})
    extra: Mapping[str, Any] = _extra()


@dataclass(frozen=True)
class Level:
    """One storey: elevation of its floor and its height, m."""

    index: int = 0
    elevation: float = 0.0
    height: float = field(default=2.8, metadata={"positive": True, "at_most": MAX_LENGTH})
    extra: Mapping[str, Any] = _extra()


@dataclass(frozen=True)
class Flooring:
    """What the floor is made of: a name of catalogs/floorings.yaml and a colour."""

    type: str = "wood"
    color: str = "#b08d57"
    extra: Mapping[str, Any] = _extra()


@dataclass(frozen=True)
class WallFinish:
    """What a room's walls are finished with on its side, and the colour."""

    type: str = "plaster"
    color: str = "#f0ede6"
    extra: Mapping[str, Any] = _extra()


@dataclass(frozen=True)
class Sides:
    """A yes or no for each of a room's four walls."""

    north: bool = False
    south: bool = False
    east: bool = False
    west: bool = False


@dataclass(frozen=True)
class Opening:
    """A door, garage door, passage or window in a wall.

    `position` is the opening's centre along the wall from its west or north end, m. Both rooms of a door list it under
    one id. `hinge` is the end of the opening that carries the leaf; `swing` is `in` for the room whose floor the leaf
    sweeps. On an outlined room `edge` (from outline point i to the next) replaces `wall`.
    """

    id: str
    kind: str = field(default="door", metadata={"choices": OPENING_KINDS})
    wall: str | None = field(default=None, metadata={"choices": WALLS})
    position: float = 0.0
    width: float = field(default=0.9, metadata={"positive": True, "at_most": MAX_LENGTH})
    height: float = field(default=2.1, metadata={"positive": True, "at_most": MAX_LENGTH})
    sill: float = 0.0
    connects_to: str | None = None
    hinge: str | None = field(default=None, metadata={"choices": ("start", "end")})
    swing: str | None = field(default=None, metadata={"choices": ("in", "out")})
    main_entrance: bool = False
    render_panel: bool = True
    edge: int | None = field(default=None, metadata={"at_least": 0, "omit_none": True})
    extra: Mapping[str, Any] = _extra()


@dataclass(frozen=True)
class Furniture:
    """A piece of furniture: full unrotated extents, m; `width` is across its front, `depth` front to back.

    `wall` is the wall it must stand at; `under` the table a chair is tucked under, `on` the piece it stands on (ids).
    """

    id: str
    name: str
    category: str | None = None
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    rotation: float = 0
    width: float = field(default=0.0, metadata={"positive": True, "at_most": MAX_LENGTH, "required": True})
    depth: float = field(default=0.0, metadata={"positive": True, "at_most": MAX_LENGTH, "required": True})
    height: float = field(default=0.0, metadata={"positive": True, "at_most": MAX_LENGTH, "required": True})
    color: str | None = None
    wall: str | None = field(default=None, metadata={"choices": WALLS})
    under: str | None = None
    on: str | None = None
    locked: bool = False
    extra: Mapping[str, Any] = _extra()


@dataclass(frozen=True)
class Decoration:
    """A small thing: `y` is the surface it rests on; `parent` the body that carries it, if any."""

    id: str
    name: str
    parent: str | None = None
    mounted_on_wall: str | None = field(default=None, metadata={"choices": WALLS})
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    rotation: float = 0
    width: float = field(default=0.0, metadata={"positive": True, "at_most": MAX_LENGTH, "required": True})
    depth: float = field(default=0.0, metadata={"positive": True, "at_most": MAX_LENGTH, "required": True})
    height: float = field(default=0.0, metadata={"positive": True, "at_most": MAX_LENGTH, "required": True})
    color: str | None = None
    extra: Mapping[str, Any] = _extra()


@dataclass(frozen=True)
class Dynamic:
    """A person or a pet; `room` is the room's id, the pose relative to that room; `on` the seat one sits on (its id)."""

    id: str
    kind: str = "person"
    room: str | None = None
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    rotation: float = 0
    width: float = field(default=0.5, metadata={"positive": True, "at_most": MAX_LENGTH})
    depth: float = field(default=0.3, metadata={"positive": True, "at_most": MAX_LENGTH})
    height: float = field(default=1.7, metadata={"positive": True, "at_most": MAX_LENGTH})
    color: str | None = field(default=None, metadata={"omit_none": True})
    on: str | None = field(default=None, metadata={"omit_none": True})
    extra: Mapping[str, Any] = _extra()


@dataclass(frozen=True)
class Room:
    """A room: its wall lines' rectangle in the house, m, and everything in it, relative to its north-west corner.

    `outline` lists corner points clockwise from the north-west, room-relative, where the room is not that rectangle; `walls`
    says what its walls are finished with, where that is known.
    """

    id: str
    index: int = 0
    type: str = "room"
    level: int = 0
    x: float = 0.0
    z: float = 0.0
    width: float = field(default=0.0, metadata={"positive": True, "at_most": MAX_LENGTH, "required": True})
    depth: float = field(default=0.0, metadata={"positive": True, "at_most": MAX_LENGTH, "required": True})
    outline: tuple[tuple[float, float], ...] | None = None
    outdoor: bool = False
    flooring: Flooring | None = None
    accent: str | None = None
    walls: WallFinish | None = field(default=None, metadata={"omit_none": True})
    exterior_walls: Sides | None = None
    wall_flags: Sides | None = None
    openings: tuple[Opening, ...] = ()
    furniture: tuple[Furniture, ...] = ()
    decorations: tuple[Decoration, ...] = ()
    extra: Mapping[str, Any] = _extra()


@dataclass(frozen=True)
class Scene:
    """A whole house: the document of /generate, /fix and /validate."""

    format: str = field(default=FORMAT, metadata={"choices": (FORMAT,)})
    seed: int | None = None
    request: Mapping[str, Any] | None = None
    generator: Mapping[str, Any] | None = None
    size: Size | None = None
    wall_thickness: float = field(default=0.0, metadata={"at_least": 0.0, "at_most": 1.0})
    levels: tuple[Level, ...] = ()
    rooms: tuple[Room, ...] = ()
    corridors: tuple[Mapping[str, Any], ...] = ()
    adjacency: tuple[tuple[int, int], ...] = ()
    dynamic: tuple[Dynamic, ...] = ()
    certificate: Mapping[str, Any] | None = None
    extra: Mapping[str, Any] = _extra()


@dataclass(frozen=True)
class Issue:
    """One broken rule: the contract's word, the room's id, the ids of the bodies, and by how much, m."""

    rule: str
    severity: str
    room: str | None
    ids: tuple[str, ...]
    amount: float
    message: str


@dataclass(frozen=True)
class Conflict:
    """Bodies that cannot stand together, why, and what would help."""

    ids: tuple[str, ...]
    message: str
    repairs: tuple[Mapping[str, Any], ...] = ()


@dataclass(frozen=True)
class Move:
    """How far /fix moved a body, m, and the rotation it has now, degrees."""

    id: str
    dx: float
    dz: float
    rotation: float


@dataclass(frozen=True)
class Pose:
    """Where a body was in the last answer of /fix: its footprint's centre in its room, m, and its rotation, degrees."""

    id: str
    x: float = field(metadata={"required": True})
    z: float = field(metadata={"required": True})
    rotation: float = 0


@dataclass(frozen=True)
class Generated:
    """The answer of generate: the scene, what the validator says, and stage times in ms."""

    scene: Scene
    issues: tuple[Issue, ...]
    timing_ms: Mapping[str, float]


@dataclass(frozen=True)
class Fixed:
    """The answer of fix."""

    scene: Scene
    moves: tuple[Move, ...]
    removed: tuple[Mapping[str, str], ...]
    conflicts: tuple[Conflict, ...]
    issues: tuple[Issue, ...]
    timing_ms: Mapping[str, float]


def robot_width_of(scene: Scene) -> float:
    """Returns the side of the square that must be able to walk, m: the request's, or the contract's."""
    width = (scene.request or {}).get("robot_width")
    return float(width) if isinstance(width, int | float) and 0.1 <= width <= 2.0 else ROBOT_WIDTH


def body_ids(scene: Scene) -> list[str]:
    """Returns the ids of all bodies of a scene: furniture and decorations room by room, then people and pets."""
    things = [[*(piece.id for piece in room.furniture), *(item.id for item in room.decorations)] for room in scene.rooms]
    return [*(name for names in things for name in names), *(person.id for person in scene.dynamic)]


def check_ids(field_name: str, wanted: Sequence[str], known: Sequence[str]) -> None:
    """Refuses ids that a scene does not have.

    Raises:
        SceneError: names the entry and some ids that would do.
    """
    have = set(known)
    for k, name in enumerate(wanted):
        if name not in have:
            shown = ", ".join(known[:12]) + (", ..." if len(known) > 12 else "")
            raise SceneError(f"{field_name}[{k}]", f"nothing in the scene has the id {name!r}", f"one of {shown}")
