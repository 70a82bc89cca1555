"""What a designer looks at in kitchens, bathrooms, at long tables and in plain plans; shares no code with what furnishes.

Comes in: a `Scene`. Goes out: for every line of `LINES` how many of its cases hold, and how many there are. Metres. The lengths are of

* the International Residential Code, P2705.1: a toilet's axis is 15 inches (0.38 m) or more from what is at its side, and 21 inches
  (0.53 m) of floor are free before it;
* the NKBA Kitchen Planning Guidelines: 5 (working triangle), 6 (no tall piece parts work centers), 12 (worktop by the dishwasher), 13
  (dishwasher within 36 inches of the sink), 16 (worktop beside the refrigerator), 17 (worktop at both sides of the hob, 12 and 15
  inches), 18 (no hob under a window that opens);
* Neufert, Architects' Data, kitchens: a worktop of 0.3 m at least between hob and any tall unit.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import replace

from solver.scene import Decoration, Room, Scene
from tests.density.living_ruler import Count, Floor, Line, count, floors, free_before, strip, windows_behind
from tests.density.ruler import FACE, Box, triangle, works

AXIS = 0.38
"""From a toilet's axis to what is at its side."""
LANDING = 0.3
"""Of worktop at a stove's side; and how far a refrigerator is from it at least."""
BEFORE = 0.53
"""Of floor before a toilet and a counter, where nothing is put down."""
ROW = 0.05
"""Neighbours in a row are at most so far apart, and their backs as much out of line."""
WORKTOP = ("counter",)
WORKED_AT = ("counter", "sink", "stove")
"""What a worktop is made of, and what belongs between its parts."""
BREAKS = ("refrigerator", "pantry")
"""What is taller than it and belongs at an end of it; a dishwasher is as high, and one works on its top."""
RINSED = 0.92
"""From a dishwasher to the sink where dishes are rinsed, at most."""
LONG_TABLE = 2.0
"""From here on a table is for six (Neufert: a place is 0.6 m wide), m."""
LEANING = 0.2
"""Chairs all about a table have their middle at most so far from its own."""
LONG = 2.4
"""Of worktop in a large home's kitchen, m along the fronts."""
ROOMY, BROAD = 15.0, 3.3
"""Kitchens of this area, m2, and short side have room for an island or a table."""
SMALL = 10.0
"""A bathroom is at most so large, m2."""
RUN = ("counter", "sink", "stove", "refrigerator", "dishwasher")
NEAR = 0.1
"""From a wall's face in a corner, and from a run, at most."""
MIRROR = 0.6
"""Of floor before a mirror, from where one looks into it."""
AISLE = 0.75
"""Between a run and an island, where one works and walks past."""
HUNG = 0.12
"""Between things at a wall."""
USED = ("toilet", "wardrobe", "counter", "sink", "stove", "refrigerator")
PUT_DOWN = ("plant", "laundry_basket", "trash_bin", "basket", "potted_plant", "slim_plant", "plant_small")


def _rooms(scene: Scene, name: str) -> list[Room]:
    return [room for room in scene.rooms if room.type == name]


def toilets_with_room(scene: Scene) -> Count:
    """Toilets with no wall and no furniture nearer than AXIS to their axis, at either side, along their depth."""

    def cases() -> Iterator[bool]:
        for floor in floors(scene):
            for toilet in floor.named("toilet"):
                aside = AXIS - toilet.piece.width / 2
                yield all(floor.free(strip(toilet, side, aside), (toilet, *floor.things)) for side in ("left", "right"))

    return count(cases())


def toilets_faced(scene: Scene) -> Count:
    """Toilets that look straight out of a door: it is in the wall ahead, and some of it is before the toilet."""

    def cases() -> Iterator[bool]:
        for floor in floors(scene, "bathroom"):
            doors = [one for one in floor.room.openings if one.kind != "window"]
            for toilet in floor.named("toilet"):
                ahead = {(0, 1): "south", (0, -1): "north", (1, 0): "east", (-1, 0): "west"}[toilet.ahead]
                low, high = (toilet.z0, toilet.z1) if toilet.ahead[0] else (toilet.x0, toilet.x1)
                yield any(one.wall == ahead and abs(one.position - (low + high) / 2) < (one.width + high - low) / 2 - 1e-3 for one in doors)

    return count(cases())


def _in_corner(floor: Floor, box: Box) -> bool:
    """Tells whether a piece is nearer than NEAR to two walls that meet."""
    room = floor.room
    x, z = min(box.x0, room.width - box.x1), min(box.z0, room.depth - box.z1)
    return max(x, z) <= FACE + NEAR + 1e-3


def tubs_in_corners(scene: Scene) -> Count:
    """Bathtubs in a corner of the room."""
    return count(_in_corner(floor, box) for floor in floors(scene, "bathroom") for box in floor.named("bathtub"))


def pantries_apart(scene: Scene) -> Count:
    """Pantries in no corner, with nothing of the kitchen's run right beside them."""
    return count(
        not _in_corner(floor, box) and all(_apart(box, other) > NEAR for other in floor.named(*RUN))
        for floor in floors(scene, "kitchen")
        for box in floor.named("pantry")
    )


def baths_free(*names: str) -> Callable[[Scene], Count]:
    """Counts what is stood before in bathrooms with BEFORE of floor free along its front."""
    return lambda scene: free_before(BEFORE, *names)(replace(scene, rooms=tuple(_rooms(scene, "bathroom"))))


def basins_mirrored(scene: Scene) -> Count:
    """Basins with a mirror at the wall over them."""

    def cases() -> Iterator[bool]:
        for floor in floors(scene, "bathroom"):
            mirrors = [one for one in floor.room.decorations if "mirror" in one.name and one.mounted_on_wall]
            for box in floor.named("vanity", "sink"):
                x0, z0, x1, z1 = strip(box, "back", NEAR)
                yield any(x0 <= one.x <= x1 and z0 <= one.z <= z1 for one in mirrors)

    return count(cases())


def mirrors_seen(scene: Scene) -> Count:
    """Standing mirrors with MIRROR of floor free along their front."""
    return free_before(MIRROR, "standing_mirror")(scene)


def hung_close(scene: Scene) -> Count:
    """Things at a wall with another one beside them, nearer than HUNG."""

    def cases() -> Iterator[bool]:
        for room in scene.rooms:
            hung = [one for one in room.decorations if one.mounted_on_wall]
            for one in hung:
                yield any(_hang_close(one, other) for other in hung if other is not one)

    return count(cases())


def _hang_close(one: Decoration, two: Decoration) -> bool:
    if one.mounted_on_wall != two.mounted_on_wall or one.y >= two.y + two.height or two.y >= one.y + one.height:
        return False
    middles = (one.x, two.x) if one.mounted_on_wall in ("north", "south") else (one.z, two.z)
    return abs(middles[0] - middles[1]) - (one.width + two.width) / 2 < HUNG - 2e-3


def _neighbour(box: Box, side: str, others: list[Box]) -> Box | None:
    """Returns what goes on a row at a side of a piece: turned alike, backs in line, touching."""
    rect = strip(box, side, ROW)
    for other in others:
        if other is not box and other.ahead == box.ahead and other.meets(*rect) and abs(_back(other) - _back(box)) <= ROW:
            return other
    return None


def _back(box: Box) -> float:
    dx, dz = box.ahead
    return (-box.x0 if dx > 0 else box.x1) if dx else (-box.z0 if dz > 0 else box.z1)


def stoves_with_worktop(scene: Scene) -> Count:
    """Stoves with a counter of LANDING or more right beside them, at both sides."""

    def cases() -> Iterator[bool]:
        for floor in floors(scene):
            tops = [box for box in floor.named(*WORKTOP) if box.piece.width >= LANDING - 1e-3]
            for stove in floor.named("stove"):
                yield all(_neighbour(stove, side, tops) is not None for side in ("left", "right"))

    return count(cases())


def stoves_under_windows(scene: Scene) -> Count:
    """Stoves with any of a window behind them."""
    return count(any(windows_behind(floor.room, stove)) for floor in floors(scene) for stove in floor.named("stove"))


def stoves_at_refrigerators(scene: Scene) -> Count:
    """Stoves with a refrigerator nearer than LANDING."""
    return count(
        any(_apart(stove, cold) < LANDING - 1e-3 for cold in floor.named("refrigerator"))
        for floor in floors(scene)
        for stove in floor.named("stove")
    )


def _apart(one: Box, two: Box) -> float:
    dx, dz = max(one.x0, two.x0) - min(one.x1, two.x1), max(one.z0, two.z0) - min(one.z1, two.z1)
    return float((max(dx, 0.0) ** 2 + max(dz, 0.0) ** 2) ** 0.5)


def worktops_parted(scene: Scene) -> Count:
    """Refrigerators and pantries with a counter, sink or stove right beside them at both sides."""

    def cases() -> Iterator[bool]:
        for floor in floors(scene, "kitchen"):
            there = floor.named(*WORKED_AT)
            for box in floor.named(*BREAKS):
                yield all(_neighbour(box, side, there) is not None for side in ("left", "right"))

    return count(cases())


def dishwashers_at_sinks(scene: Scene) -> Count:
    """Dishwashers whose nearest edge is near enough to that of a sink."""
    kitchens = floors(scene, "kitchen")
    return count(
        any(_apart(box, sink) <= RINSED for sink in floor.named("sink")) for floor in kitchens for box in floor.named("dishwasher")
    )


def refrigerators_served(scene: Scene) -> Count:
    """Refrigerators with a counter right beside them (guideline 16: a landing area)."""

    def cases() -> Iterator[bool]:
        for floor in floors(scene, "kitchen"):
            tops = floor.named(*WORKTOP)
            for box in floor.named("refrigerator"):
                yield any(_neighbour(box, side, tops) is not None for side in ("left", "right"))

    return count(cases())


def long_tables_short_of_chairs(scene: Scene) -> Count:
    """Dining tables of LONG_TABLE or more with fewer than six chairs."""

    def cases() -> Iterator[bool]:
        for floor in floors(scene):
            for box in floor.named("dining_table"):
                if box.piece.width >= LONG_TABLE:
                    yield sum(chair.piece.under == box.piece.id for chair in floor.pieces) < 6

    return count(cases())


def chairs_at_one_end(scene: Scene) -> Count:
    """Dining tables with chairs whose middle lies more than LEANING off the table's along its longer sides."""

    def cases() -> Iterator[bool]:
        for floor in floors(scene):
            for table in floor.named("dining_table"):
                axis = int(table.z1 - table.z0 > table.x1 - table.x0)
                at = [chair.middle[axis] - table.middle[axis] for chair in floor.pieces if chair.piece.under == table.piece.id]
                if at:
                    yield abs(sum(at) / len(at)) > LEANING

    return count(cases())


def refrigerators_apart(scene: Scene) -> Count:
    """Refrigerators with nothing of the kitchen's run, and no pantry, right beside them or round the corner."""
    return count(
        all(_apart(box, other) > NEAR for other in floor.named(*RUN, "pantry") if other is not box)
        for floor in floors(scene, "kitchen")
        for box in floor.named("refrigerator")
    )


def islands_crowding(scene: Scene) -> Count:
    """Islands nearer than AISLE to any of the kitchen's run."""
    return count(
        any(_apart(box, other) < AISLE - 1e-3 for other in floor.named(*RUN))
        for floor in floors(scene, "kitchen")
        for box in floor.named("kitchen_island")
    )


def long_worktops(scene: Scene) -> Count:
    """Kitchens of LONG or more of counter, measured along the fronts: what stands round the corner hides none of it."""
    return count(worktop(floor) >= LONG - 1e-3 for floor in floors(scene, "kitchen"))


def worktop(floor: Floor) -> float:
    """Returns the length of a room's counters in all, less what another piece hides of their fronts, m."""
    length = 0.0
    for box in floor.named(*WORKTOP):
        along = 1 if box.ahead[0] else 0
        x0, z0, x1, z1 = strip(box, "front", 0.1)
        hidden = [
            (max(one[0], (x0, z0)[along]), min(one[1], (x1, z1)[along]))
            for other in floor.pieces
            if other is not box and other.meets(x0, z0, x1, z1)
            for one in [((other.x0, other.x1), (other.z0, other.z1))[along]]
        ]
        length += max(0.0, box.piece.width - sum(high - low for low, high in hidden))
    return length


def triangles_whole(scene: Scene) -> Count:
    """Kitchens whose sink, stove and refrigerator stand as the guideline wants (`ruler.works`)."""
    return count(works(legs) for room in _rooms(scene, "kitchen") if (legs := triangle(room)) is not None)


def roomy_kitchens_used(scene: Scene) -> Count:
    """Kitchens of ROOMY and BROAD or more with an island or a table."""
    return count(
        bool(floor.named("kitchen_island", "dining_table"))
        for floor in floors(scene, "kitchen")
        if floor.room.width * floor.room.depth >= ROOMY and min(floor.room.width, floor.room.depth) >= BROAD
    )


def put_down_in_the_way(scene: Scene) -> Count:
    """Plants, baskets and bins on the floor within BEFORE of the front of a toilet, wardrobe, counter, sink, stove or refrigerator."""

    def cases() -> Iterator[bool]:
        for floor in floors(scene):
            kept = [strip(box, "front", BEFORE) for box in floor.named(*USED)]
            for box in (*floor.pieces, *floor.things):
                if kept and box.piece.name in PUT_DOWN:
                    yield any(box.meets(*rect) for rect in kept)

    return count(cases())


def _plain(scene: Scene, cases: Callable[[Counter[str]], Iterator[bool]]) -> Count:
    planned = (scene.request or {}).get("program") is not None
    return (0, 0) if planned else count(cases(Counter(room.type for room in scene.rooms)))


def twice(scene: Scene) -> Count:
    """Plain houses with two master bedrooms or three living rooms."""
    return _plain(scene, lambda types: iter([types["bedroom_master"] > 1 or types["living_room"] > 2]))


def dining_rooms(scene: Scene) -> Count:
    """Plain houses with a dining room."""
    return _plain(scene, lambda types: iter([types["dining_room"] > 0]))


def small_bathrooms(scene: Scene) -> Count:
    """Bathrooms of at most SMALL."""
    return count(room.width * room.depth <= SMALL + 1e-6 for room in _rooms(scene, "bathroom"))


def coats_hung(scene: Scene) -> Count:
    """Homes with a coat rack."""
    return count([_pieces(scene, "coat_rack") > 0])


def washed_twice(scene: Scene) -> Count:
    """Homes with more than one washer."""
    return count([_pieces(scene, "washer") > 1])


def _pieces(scene: Scene, name: str) -> int:
    return sum(piece.name == name for room in scene.rooms for piece in room.furniture)


LINES = (
    Line("toilet: 0.38 m free at both sides of its axis", toilets_with_room, {"*": 0.9}),
    Line("toilet: looks straight out of a door", toilets_faced, {"*": 0.02}, most=True),
    Line("basin: 0.53 m free along its front", baths_free("vanity", "sink"), {"*": 0.9}),
    Line("shower: 0.53 m free along its front", baths_free("shower"), {"*": 0.8}),
    Line("basin: a mirror over it", basins_mirrored, {"*": 0.98}),
    Line("bathtub: in a corner", tubs_in_corners, {"*": 0.9}),
    Line("pantry: neither beside the run nor in a corner", pantries_apart, {"*": 0.35}, most=True),
    Line("standing mirror: front free, 0.6 m", mirrors_seen, {"*": 0.9}),
    Line("things at a wall: less than 0.12 m apart", hung_close, {"*": 0.0}, most=True),
    Line("stove: 0.3 m of worktop at both sides", stoves_with_worktop, {"*": 0.85}),
    Line("stove: under a window", stoves_under_windows, {"*": 0.05}, most=True),
    Line("stove: refrigerator within 0.3 m", stoves_at_refrigerators, {"*": 0.0}, most=True),
    Line("refrigerator, pantry: parts the worktop", worktops_parted, {"*": 0.02}, most=True),
    Line("dishwasher: sink within 0.92 m", dishwashers_at_sinks, {"*": 0.75}),
    Line("refrigerator: worktop right beside it", refrigerators_served, {"*": 0.85}),
    Line("dining table of 2 m: fewer than six chairs", long_tables_short_of_chairs, {"*": 0.1}, most=True),
    Line("dining table: chairs at one end", chairs_at_one_end, {"*": 0.1}, most=True),
    Line("refrigerator: apart from the run", refrigerators_apart, {"*": 0.03}, most=True),
    Line("island: within 0.75 m of the run", islands_crowding, {"*": 0.2}, most=True),
    Line("kitchen: 2.4 m of worktop", long_worktops, {"*": 0.25, "large": 0.5}),
    Line("kitchen: working triangle", triangles_whole, {"*": 0.85}),
    Line("kitchen of 15 m2, 3.3 m wide: island or table", roomy_kitchens_used, {"*": 0.8}),
    Line("plants, baskets, bins: before toilets, wardrobes, counters", put_down_in_the_way, {"*": 0.02}, most=True),
    Line("plain house: two masters or three living rooms", twice, {"*": 0.0}, most=True),
    Line("plain house: a dining room", dining_rooms, {"*": 0.98}),
    Line("bathroom: at most 10 m2", small_bathrooms, {"*": 0.6}),
    Line("home with a coat rack", coats_hung, {"*": 0.98}),
    Line("home with two washers", washed_twice, {"*": 0.0}, most=True),
)
"""All lines, in the order of the table."""
