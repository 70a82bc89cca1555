"""What a designer looks at in rooms people live, eat and sleep in, from the scene alone; shares no code with what furnishes.

Comes in: a `Scene`. Goes out: for every line of `LINES` how many of its cases hold, and how many there are. Metres and degrees.
The lengths are of Neufert, Architects' Data (3rd ed., chapters on bedrooms, living and dining rooms) where nothing else is said.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from solver.scene import Decoration, Furniture, Opening, Room, Scene
from tests.density.ruler import FACE, Box, boxes

STORES, FRONT, ASIDE = ("wardrobe", "dresser"), 0.6, 0.5
"""Floor before a cupboard's doors and drawers, and along a bed, for one who stands there."""
LIT = 2.5
"""A desk is at most so far from a window of its room."""
FLAT = 0.02
"""What is lower lies on the floor and is in nobody's way."""
DOUBLE = 1.35
"""Beds from this width on are for two."""
BED_HEAD = 0.6
"""Of a bed's side, from its head: nightstands stand there."""
FREE_STANDING = 0.4
"""A table whose sides are all so far from the walls has a place to sit at each."""
CONE = 60.0
"""One who sits sees this far to either side, degrees, without turning."""
FAR = 5.0
"""What is farther away does not belong to a seat."""
SEEN = ("sofa", "armchair", "coffee_table", "tv", "dining_table", "bed", "single_bed", "bunk_bed", "fireplace", "piano", "desk")
SEATS = ("sofa", "armchair")
COMPANY, NEAR_BY = ("sofa", "armchair", "coffee_table", "bed", "desk"), 1.3
AT_HAND, IN_REACH = ("side_table", "floor_lamp", "nightstand"), 0.5
"""An armchair has company so near, m, or a table or a lamp in reach; else it is stranded."""
TV_ASIDE, TV_NEAR, TV_FAR, TV_FOOT = 30.0, 1.5, 4.5, 0.5
"""A screen is at most so far off the sofa's axis, degrees, between these away from it, and over what is so high."""
TALL = ("wardrobe", "bookshelf", "pantry", "linen_cabinet", "storage_shelf")
BULKY = ("plant", "floor_lamp", "laundry_basket", "bean_bag", "potted_plant", "slim_plant", "basket", "play_tent")
JOINED = {0.6: 1.0, 0.65: 0.98, 0.7: 0.9, 0.8: 0.4}
"""Of homes, by the width of who walks: the share that should be joined."""
SLEEP = ("bedroom", "bedroom_master", "kids_bedroom", "living_room")

Count = tuple[int, int]
"""How many hold, and how many there are."""


@dataclass(frozen=True)
class Line:
    """One line of the table.

    Args:
        says: what is counted.
        count: cases that hold, and cases, in a home.
        wanted: the share that should hold, by preset; `*` for those not named.
        most: whether the share should be at most, not at least, `wanted`.
    """

    says: str
    count: Callable[[Scene], Count]
    wanted: dict[str, float]
    most: bool = False


@dataclass(frozen=True)
class Floor:
    """What stands on a room's floor: furniture, then decorations, as boxes."""

    room: Room
    pieces: tuple[Box, ...]
    things: tuple[Box, ...]

    def named(self, *names: str) -> list[Box]:
        """Returns the pieces of these names."""
        return [box for box in self.pieces if box.piece.name in names]

    def free(self, rect: tuple[float, float, float, float], but: Sequence[Box]) -> bool:
        """Tells whether a rectangle lies between the walls' faces, and nothing stands on it but some."""
        x0, z0, x1, z1 = rect
        inside = min(x0, z0) >= FACE - 1e-3 and x1 <= self.room.width - FACE + 1e-3 and z1 <= self.room.depth - FACE + 1e-3
        return inside and not any(box.meets(x0, z0, x1, z1) for box in (*self.pieces, *self.things) if box not in but)


def floor_of(room: Room) -> Floor:
    """Returns what stands on a room's floor, rugs and what stands on pieces left out."""
    standing = tuple(box for box in boxes(room) if box.piece.on is None and box.piece.y < 1.0 and box.top > FLAT)
    things = [one for one in room.decorations if one.parent is None and one.mounted_on_wall is None and one.y < 1.0]
    as_pieces = tuple(_as_piece(room, one) for one in things if one.height > FLAT)
    return Floor(room, standing, as_pieces)


def _as_piece(room: Room, thing: Decoration) -> Box:
    """Returns a thing on the floor as a box: what is askew by its bounds."""
    angle = math.radians(thing.rotation)
    cosine, sine = abs(math.cos(angle)), abs(math.sin(angle))
    width, depth = thing.width * cosine + thing.depth * sine, thing.width * sine + thing.depth * cosine
    piece = Furniture(thing.id, thing.name, x=thing.x, y=thing.y, z=thing.z, width=width, depth=depth, height=thing.height)
    return boxes(replace(room, furniture=(piece,)))[0]


def strip(box: Box, side: str, depth: float, start: float = 0.0, end: float = 0.0) -> tuple[float, float, float, float]:
    """Returns the floor at a side of a piece, so deep; `start` and `end` are left out of it from the piece's back and front on."""
    dx, dz = box.ahead
    x0, z0, x1, z1 = box.x0, box.z0, box.x1, box.z1
    if dx:
        x0, x1 = (x0 + start, x1 - end) if dx > 0 else (x0 + end, x1 - start)
    else:
        z0, z1 = (z0 + start, z1 - end) if dz > 0 else (z0 + end, z1 - start)
    dx, dz = {"front": (dx, dz), "back": (-dx, -dz), "right": (dz, -dx), "left": (-dz, dx)}[side]
    if dx:
        return (box.x1, z0, box.x1 + depth, z1) if dx > 0 else (box.x0 - depth, z0, box.x0, z1)
    return (x0, box.z1, x1, box.z1 + depth) if dz > 0 else (x0, box.z0 - depth, x1, box.z0)


def count(cases: Iterable[bool]) -> Count:
    """Returns how many cases hold, and how many there are."""
    held = list(cases)
    return sum(held), len(held)


def floors(scene: Scene, *types: str) -> Iterator[Floor]:
    """Returns the floors of the rooms of some types, or of all indoor rooms."""
    return (floor_of(room) for room in scene.rooms if (room.type in types if types else not room.outdoor))


def free_before(depth: float, *names: str) -> Callable[[Scene], Count]:
    """Counts pieces with so much floor free along the whole of their front."""
    return lambda scene: count(floor.free(strip(box, "front", depth), (box,)) for floor in floors(scene) for box in floor.named(*names))


fronts_free = free_before(FRONT, *STORES)
shelves_free = free_before(0.4, "bookshelf", "storage_shelf", "toy_shelf")
racks_free = free_before(0.3, "coat_rack")
seats_free = free_before(0.38, *SEATS)


def desks_lit(scene: Scene) -> Count:
    """Desks near a window, of those in rooms that have one."""
    windows = {room.id: [one for one in room.openings if one.kind == "window"] for room in scene.rooms}
    found = ((floor.room, windows[floor.room.id], desk) for floor in floors(scene) for desk in floor.named("desk"))
    return count(any(_off(room, desk, one) <= LIT for one in lights) for room, lights, desk in found if lights)


def _off(room: Room, box: Box, window: Opening) -> float:
    """Returns how far a piece is from a window's line."""
    low, high = window.position - window.width / 2, window.position + window.width / 2
    along, across = ((box.x0, box.x1), (box.z0, box.z1)) if window.wall in ("north", "south") else ((box.z0, box.z1), (box.x0, box.x1))
    far = {"south": room.depth, "east": room.width}.get(str(window.wall), 0.0)
    return math.hypot(max(low - along[1], along[0] - high, 0.0), max(far - across[1], across[0] - far, 0.0))


def _chairs(floor: Floor, table: Box) -> dict[str, int]:
    """Returns how many chairs stand at each side of a table."""
    found = dict.fromkeys(("front", "back", "left", "right"), 0)
    for chair in floor.pieces:
        if chair.piece.under == table.piece.id:
            found[next(side for side in found if _is_at(table, side, chair))] += 1
    return found


def _is_at(table: Box, side: str, chair: Box) -> bool:
    """Tells whether a chair looks at a side of a table from outside."""
    x0, z0, x1, z1 = strip(table, side, 1.0)
    dx, dz = (x0 + x1) / 2 - table.middle[0], (z0 + z1) / 2 - table.middle[1]
    return chair.ahead[0] * dx + chair.ahead[1] * dz < -1e-6


def _dining_tables(scene: Scene) -> Iterator[tuple[Floor, Box]]:
    return ((floor, table) for floor in floors(scene) for table in floor.named("dining_table"))


def lopsided(scene: Scene) -> Count:
    """Free-standing dining tables that have more chairs at one side than at the side across."""

    def cases() -> Iterator[bool]:
        for floor, table in _dining_tables(scene):
            room = floor.room
            gaps = (table.x0, table.z0, room.width - table.x1, room.depth - table.z1)
            if min(gaps) - FACE >= FREE_STANDING:
                at = _chairs(floor, table)
                yield at["front"] != at["back"] or at["left"] != at["right"]

    return count(cases())


def lonely(scene: Scene) -> Count:
    """Dining tables with one chair at most."""
    return count(sum(_chairs(floor, table).values()) <= 1 for floor, table in _dining_tables(scene))


def windows_behind(room: Room, box: Box) -> Iterator[Opening]:
    """Yields the windows right behind a piece whose back is within 0.3 m of their wall."""
    wall = {(0, 1): "north", (0, -1): "south", (1, 0): "west", (-1, 0): "east"}[box.ahead]
    back = {"north": box.z0, "south": room.depth - box.z1, "west": box.x0, "east": room.width - box.x1}[wall] - FACE
    low, high = (box.x0, box.x1) if wall in ("north", "south") else (box.z0, box.z1)
    for opening in room.openings:
        reach = opening.width / 2
        behind = opening.kind == "window" and opening.wall == wall and back < 0.3
        if behind and opening.position - reach < high - 1e-3 and low + 1e-3 < opening.position + reach:
            yield opening


def heads_under_windows(scene: Scene) -> Count:
    """Beds with any of a window behind their head."""
    found = ((floor.room, bed) for floor in floors(scene) for bed in floor.named("bed", "single_bed", "bunk_bed"))
    return count(any(True for _ in windows_behind(room, bed)) for room, bed in found)


def both_sides_free(scene: Scene) -> Count:
    """Double beds with ASIDE of floor free along both long sides, from BED_HEAD below the head on."""
    return count(
        all(floor.free(strip(bed, side, ASIDE, start=BED_HEAD), (bed,)) for side in ("left", "right"))
        for floor in floors(scene)
        for bed in floor.named("bed")
        if bed.piece.width >= DOUBLE
    )


def dining_beside_dining_room(scene: Scene) -> Count:
    """Living rooms with a dining table, of homes that have a dining room."""
    if not any(room.type == "dining_room" for room in scene.rooms):
        return 0, 0
    return count(bool(floor.named("dining_table")) for floor in floors(scene, "living_room"))


def tables_to_eat_at(scene: Scene) -> Count:
    """Homes with a dining table, wherever it stands."""
    return count([any(floor.named("dining_table") for room in scene.rooms for floor in floors(scene, room.type))])


def _aside(seat: Box, other: Box) -> tuple[float, float]:
    """Returns how far something's middle lies off the axis of a seat's front, degrees, and how far away, m."""
    dx, dz = other.middle[0] - seat.front[0], other.middle[1] - seat.front[1]
    ahead = dx * seat.ahead[0] + dz * seat.ahead[1]
    return math.degrees(math.atan2(abs(dx * seat.ahead[1] - dz * seat.ahead[0]), ahead)), math.hypot(dx, dz)


def _sees(seat: Box, other: Box) -> bool:
    aside, away = _aside(seat, other)
    return other is not seat and aside <= CONE and away <= FAR


def faces_nothing(scene: Scene) -> Count:
    """Armchairs and sofas before which, within CONE and FAR, is nothing of SEEN."""
    rooms = [boxes(room) for room in scene.rooms if not room.outdoor]
    seats = ((there, seat) for there in rooms for seat in there if seat.piece.name in SEATS)
    return count(not any(_sees(seat, box) for box in there if box.piece.name in SEEN) for there, seat in seats)


def _apart(one: Box, two: Box) -> float:
    """Returns the free distance between two footprints, m."""
    return math.hypot(max(one.x0 - two.x1, two.x0 - one.x1, 0.0), max(one.z0 - two.z1, two.z0 - one.z1, 0.0))


def stranded(scene: Scene) -> Count:
    """Armchairs indoors that have neither COMPANY nor AT_HAND."""

    def cases() -> Iterator[bool]:
        for room in (room for room in scene.rooms if not room.outdoor):
            there = boxes(room)
            for chair in (box for box in there if box.piece.name == "armchair"):
                near = ((box.piece.name, _apart(chair, box)) for box in there if box is not chair)
                yield not any((name in COMPANY and away <= NEAR_BY) or (name in AT_HAND and away <= IN_REACH) for name, away in near)

    return count(cases())


def screen_before_sofa(scene: Scene) -> Count:
    """Living rooms with a sofa in which a screen is in its view."""
    found = ((floor, sofa) for floor in floors(scene, "living_room") for sofa in floor.named("sofa")[:1])
    return count(any(_in_view(floor, sofa, box) for box in boxes(floor.room) if box.piece.name == "tv") for floor, sofa in found)


def _in_view(floor: Floor, sofa: Box, screen: Box) -> bool:
    """Tells whether a screen is near a sofa's axis, in a good distance, and nothing over TV_FOOT is 0.1 m about the line between them."""
    aside, away = _aside(sofa, screen)
    (x0, z0), (x1, z1) = sofa.front, screen.front
    between = min(x0, x1) - 0.1, min(z0, z1) - 0.1, max(x0, x1) + 0.1, max(z0, z1) + 0.1
    hidden = any(box.top > TV_FOOT and box.meets(*between) for box in floor.pieces if box is not sofa and box.piece.name != "tv")
    return aside <= TV_ASIDE and TV_NEAR <= away <= TV_FAR and not hidden


def fireplaces_faced(scene: Scene) -> Count:
    """Fireplaces that a sofa or an armchair looks at."""
    return count(any(_sees(seat, fire) for seat in floor.named(*SEATS)) for floor in floors(scene) for fire in floor.named("fireplace"))


def pianos_played(scene: Scene) -> Count:
    """Pianos with a seat before them and 0.9 m of floor free of all else."""
    return count(_played(floor, piano) for floor in floors(scene) for piano in floor.named("piano"))


def _played(floor: Floor, piano: Box) -> bool:
    before = strip(piano, "front", 0.9)
    stools = [box for box in floor.named("ottoman", "piano_stool", "bench") if box.meets(*before)]
    return bool(stools) and floor.free(before, (piano, *stools))


def stores_under_windows(scene: Scene) -> Count:
    """Tall cupboards and shelves with a window behind them."""
    found = ((floor.room, box) for floor in floors(scene) for box in floor.named(*TALL))
    return count(any(True for _ in windows_behind(room, box)) for room, box in found)


def things_in_the_way(scene: Scene) -> Count:
    """Plants, lamps, baskets, bean bags and tents that stand before a cupboard's front or along a double bed's side."""

    def cases() -> Iterator[bool]:
        for floor in floors(scene, *SLEEP):
            kept = [strip(box, "front", FRONT) for box in floor.named(*STORES)]
            kept += [strip(bed, side, ASIDE, start=BED_HEAD) for bed in floor.named("bed") for side in ("left", "right")]
            for box in (*floor.pieces, *floor.things):
                if box.piece.name in BULKY:
                    yield any(box.meets(*rect) for rect in kept)

    return count(cases())


def joined_at(width: float, things: bool = True) -> Callable[[Scene], Count]:
    """Returns what tells whether in every room a square so wide comes from door to door; things on the floor in its way or not."""

    def joined(scene: Scene) -> Count:
        floors = (floor_of(room) for room in scene.rooms)
        return int(all(doors_joined(floor if things else replace(floor, things=()), width) for floor in floors)), 1

    return joined


def doors_joined(floor: Floor, width: float) -> bool:
    """Tells whether a square that has come through any door of a room comes to all others; by whole millimetres."""
    room, half = floor.room, round(500 * width)
    bodies = [(box.x0, box.z0, box.x1, box.z1) for box in (*floor.pieces, *floor.things)]
    blocked = [(mm(x0) - half, mm(z0) - half, mm(x1) + half, mm(z1) + half) for x0, z0, x1, z1 in bodies]
    low = mm(FACE) + half
    high = mm(room.width) - low, mm(room.depth) - low
    doors = [_inside(room, opening, low, high) for opening in room.openings if opening.kind in ("door", "passage")]
    if min(high) < low or len(doors) < 2:
        return len(doors) < 2
    xs = sorted({low, high[0], *(x for x, _ in doors), *(x for x0, _, x1, _ in blocked for x in (x0, x1) if low < x < high[0])})
    zs = sorted({low, high[1], *(z for _, z in doors), *(z for _, z0, _, z1 in blocked for z in (z0, z1) if low < z < high[1])})

    def free(i: int, k: int) -> bool:
        """Tells of a line (even) or the space between two lines (odd) whether no body is there: edges are free."""
        x, z = _doubled(xs, i), _doubled(zs, k)
        return not any(2 * x0 < x < 2 * x1 and 2 * z0 < z < 2 * z1 for x0, z0, x1, z1 in blocked)

    goals = {(2 * xs.index(x), 2 * zs.index(z)) for x, z in doors}
    start = next(iter(goals))
    seen, open_ = {start} if free(*start) else set(), [start] if free(*start) else []
    while open_:
        i, k = open_.pop()
        for near in ((i - 1, k), (i + 1, k), (i, k - 1), (i, k + 1)):
            if near not in seen and 0 <= near[0] < 2 * len(xs) - 1 and 0 <= near[1] < 2 * len(zs) - 1 and free(*near):
                seen.add(near)
                open_.append(near)
    return goals <= seen


def mm(metres: float) -> int:
    """Returns a length in whole millimetres."""
    return round(1000 * metres)


def _doubled(lines: Sequence[int], i: int) -> int:
    return 2 * lines[i // 2] if i % 2 == 0 else lines[i // 2] + lines[i // 2 + 1]


def _inside(room: Room, opening: Opening, low: int, high: tuple[int, int]) -> tuple[int, int]:
    """Returns where the square's centre is when it has just come through the middle of a door."""
    at = mm(opening.position)
    x, z = (min(max(at, low), end) for end in high)
    return {"north": (x, low), "south": (x, high[1]), "west": (low, z), "east": (high[0], z)}[str(opening.wall)]


LINES = (
    Line("wardrobe, dresser: front free, 0.6 m", fronts_free, {"*": 0.95}),
    Line("open shelf: front free, 0.4 m", shelves_free, {"*": 0.9}),
    Line("coat rack: front free, 0.3 m", racks_free, {"*": 0.9, "one_bed": 0.75}),
    Line("desk: window within 2.5 m", desks_lit, {"*": 0.9}),
    Line("free-standing dining table: lopsided chairs", lopsided, {"*": 0.05}, most=True),
    Line("dining table: one chair at most", lonely, {"*": 0.0}, most=True),
    Line("bed: head under a window", heads_under_windows, {"*": 0.05}, most=True),
    Line("double bed: both long sides free, 0.5 m", both_sides_free, {"*": 0.9, "studio": 0.8}),
    Line("dining table in the living room beside a dining room", dining_beside_dining_room, {"*": 0.0}, most=True),
    Line("home with a dining table", tables_to_eat_at, {"*": 0.98}),
    Line("armchair, sofa: faces nothing", faces_nothing, {"*": 0.02}, most=True),
    Line("armchair, sofa: front free, 0.38 m", seats_free, {"*": 0.9}),
    Line("armchair: neither company nor a table or lamp at hand", stranded, {"*": 0.05}, most=True),
    Line("sofa: screen in sight within 30 degrees, 1.5-4.5 m", screen_before_sofa, {"*": 0.92}),
    Line("fireplace: a seat looks at it", fireplaces_faced, {"*": 0.9}),
    Line("piano: a seat, and 0.9 m free", pianos_played, {"*": 0.9}),
    Line("tall cupboard, shelf: under a window", stores_under_windows, {"*": 0.02}, most=True),
    Line("plants, lamps, baskets: before cupboards, beside beds", things_in_the_way, {"*": 0.02}, most=True),
    *(Line(f"home joined at {width:.2f} m", joined_at(width), {"*": share}) for width, share in JOINED.items()),
    Line("home joined at 0.65 m, without things", joined_at(0.65, False), {"*": 0.98}),
)
"""All lines, in the order of the table."""
