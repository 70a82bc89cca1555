"""Where the doors, passages, garage doors and windows stand, by the core.

The work itself is in solver/core/openings/.
"""

from collections.abc import Mapping, Sequence
from struct import Struct
from typing import Final, NamedTuple

from catalogs.access_profiles import AccessProfile
from catalogs.schema import RoomType
from solver.core import ask
from solver.floorplan.fitness import CAR_DOOR_MM, cars_of
from solver.floorplan.tiling import HouseWalls, Joint, Layout
from solver.geometry import OPPOSITE, Rect, to_mm
from solver.scene import WALL_NUMBERS, WALLS

KINDS: Final = ("door", "passage", "window", "garage_door")
"""As the core numbers them."""
_HEADER: Final = Struct("<6i7q")
_ROOM: Final = Struct("<6q4i")
_WISH: Final = Struct("<5q")
_STRETCH: Final = Struct("<3q")
_JOINT: Final = Struct("<6q")
_CUT: Final = Struct("<9q")
_PLACE: Final = Struct("<q")
_NONE: Final = -1


class Pane(NamedTuple):
    """A size of window: height and sill, mm; its width is the core's."""

    height: int
    sill: int


PANE: Final = Pane(1400, 900)
"""The window of a living space."""
SMALL_PANE: Final = Pane(600, 1400)
"""The window of a bathroom or laundry: a basin and a washer stand below it. Our choice."""


class Cut(NamedTuple):
    """An opening on the lattice, named by kind and number when written.

    `room` and `wall` say where it is; `other` is the room on the other side, None for outside. `centre` is its middle
    along x (walls north and south) or z, mm in the house. `leaf` is the room whose floor a door's leaf sweeps; None: it
    sweeps none of the house's floor.
    """

    kind: str
    number: int
    room: int
    wall: str
    other: int | None
    centre: int
    width: int
    leaf: int | None = None
    main: bool = False

    @property
    def id(self) -> str:
        """Its name in the house."""
        return f"{self.kind}_{self.number}"

    def wall_of(self, room: int) -> str:
        """Returns the wall as that room sees it."""
        return self.wall if room == self.room else OPPOSITE[self.wall]

    @property
    def sides(self) -> tuple[int, ...]:
        """The rooms it opens on."""
        return (self.room,) if self.other is None else (self.room, self.other)


def pane_of(kind: RoomType) -> Pane:
    """Returns the size of a room type's windows."""
    return SMALL_PANE if has_small_panes(kind) else PANE


def has_small_panes(kind: RoomType) -> bool:
    """Tells whether the windows of a room type are small."""
    return kind.plan.wet and not kind.plan.habitable


class OpenedHouse(NamedTuple):
    """What openings are cut into: rooms as they are written, with types, and the access profile they are made for."""

    layout: Layout
    rects: Sequence[Rect]
    types: Sequence[str]
    rooms: Mapping[str, RoomType]
    profile: AccessProfile | None = None


def open_walls(house: OpenedHouse, tree: Sequence[tuple[Joint, int]], entrance: tuple[int, str]) -> tuple[tuple[Cut, ...], tuple[str, ...]]:
    """Places the entrance, the doors and passages of the tree, garage doors and windows.

    No leaf sweeps another leaf or the square of another door; squares of different doors in a furnished room stay apart where the walls
    allow. Openings are moved along their walls where a room has no wall as whole as its type's `plan.keeps` asks.

    The tree has the joint of every room's door, and the room that is entered by it; the entrance's leaf opens inwards. Returns the
    openings, and a note for each room for cars that has no door to the street.
    """
    by_length = sorted(tree, key=lambda item: (item[0].length, item[0]))
    cuts = tuple(_cut(row) for row in _CUT.iter_unpack(ask("open_walls", rows_of(house, by_length, entrance))))
    garages = {cut.room for cut in cuts if cut.kind == "garage_door"}
    lacking = [room for room, name in enumerate(house.types) if house.rooms[name].plan.garage_door and room not in garages]
    return cuts, tuple(f"{house.types[room]}_{room}: no outside wall has {CAR_DOOR_MM / 1000} m for a garage door" for room in lacking)


def door_places(house: OpenedHouse, shared: Sequence[Joint], cuts: Sequence[Cut], moved: Cut) -> tuple[int, ...]:
    """Returns where else in its wall one of all openings (`cuts`) could stand, mm in the house, what differs most first."""
    joint = [(one, one.a) for one in shared if (one.a, one.b) == tuple(sorted(moved.sides))]
    others = [*(cut for cut in cuts if cut.id != moved.id), moved]
    return tuple(place for (place,) in _PLACE.iter_unpack(ask("door_places", rows_of(house, joint, (0, WALLS[0]), others))))


def rows_of(house: OpenedHouse, joints: Sequence[tuple[Joint, int]], entrance: tuple[int, str], cuts: Sequence[Cut] = ()) -> bytes:
    """Returns a house as the core reads it."""
    layout, walls, profile = house.layout, house.layout.walls, house.profile
    wishes: list[bytes] = []
    kinds = {name: _kind_numbers(name, house, walls, wishes) for name in dict.fromkeys(house.types)}
    stretches = [
        (room, WALL_NUMBERS[wall], *one) for room, outside in enumerate(layout.openable) for wall, free in outside.items() for one in free
    ]
    rooms, first = [], 0
    for room, rect in enumerate(house.rects):
        traits, cars, *kept = kinds[house.types[room]]
        count = sum(len(free) for free in layout.openable[room].values())
        rooms.append(_ROOM.pack(*rect, traits, cars, *kept, first, count))
        first += count
    widths = [max(walls.leaf, to_mm(profile.leaf(main))) if profile else walls.leaf for main in (False, True)]
    counts = len(rooms), len(wishes), len(stretches), len(joints), len(cuts), walls.latch
    jamb = walls.least_jamb if walls.latch else walls.jamb
    header = _HEADER.pack(*counts, jamb, walls.least_jamb, walls.hallway, *widths, entrance[0], WALL_NUMBERS[entrance[1]])
    outside = [_STRETCH.pack(*row[1:]) for row in stretches]
    shared = [_JOINT.pack(one.a, one.b, WALL_NUMBERS[one.wall], one.low, one.high, entered) for one, entered in joints]
    return b"".join([header, *rooms, *wishes, *outside, *shared, *(_cut_row(cut) for cut in cuts)])


def _kind_numbers(name: str, house: OpenedHouse, walls: HouseWalls, wishes: list[bytes]) -> tuple[int, int, int, int]:
    """Returns what a room type is to its openings, bit by bit, its cars, and where among all wishes its own are, which are added."""
    kind, profile = house.rooms[name], house.profile
    plan, more = kind.plan, walls.more
    out, latch = profile is not None and profile.swings_out(name), profile is not None and profile.latch_behind(name) > 0
    is_so = name == "hallway", plan.passage, plan.swings_in, out, kind.outdoor, plan.windows, plan.habitable, has_small_panes(kind), latch
    first = len(wishes)
    for one in plan.keeps:
        across = to_mm(one.across) + more if one.across else 0
        wishes.append(_WISH.pack(to_mm(one.length) + more, to_mm(one.depth) + more // 2, one.under_windows, one.round_corners, across))
    return sum(yes << bit for bit, yes in enumerate(is_so)), cars_of(kind) if plan.garage_door else 0, first, len(wishes) - first


def _cut_row(cut: Cut) -> bytes:
    other, leaf = (_NONE if room is None else room for room in (cut.other, cut.leaf))
    return _CUT.pack(KINDS.index(cut.kind), cut.number, cut.room, WALL_NUMBERS[cut.wall], other, cut.centre, cut.width, leaf, cut.main)


def _cut(row: Sequence[int]) -> Cut:
    kind, number, room, wall, other, centre, width, leaf, main = row
    beyond, swept = None if other == _NONE else other, None if leaf == _NONE else leaf
    return Cut(KINDS[kind], number, room, WALLS[wall], beyond, centre, width, swept, bool(main))
