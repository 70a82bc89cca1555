"""An independent judge of floor plans: reads the rooms of a plan as a stranger would, and shares no code with the stage.

Every check returns sentences, none for a plan that is right. Lengths are taken to whole millimetres.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import takewhile

from solver.scene import Opening, Room
from tests.floorplan import silhouettes

WALKED = ("door", "passage")
PUBLIC = ("living_room", "dining_room", "kitchen")
SLEEPING = ("bedroom", "bedroom_master", "kids_bedroom")
JAMB = 50
"""Half a wall's thickness, mm: an opening nearer to a corner would cut into the wall that meets there."""


@cache
def mm(metres: float) -> int:
    value = round(metres * 1000)
    assert abs(value - metres * 1000) < 1e-6, f"{metres} m is off the millimetre lattice"
    return value


def box(room: Room) -> tuple[int, int, int, int]:
    west, north = mm(room.x), mm(room.z)
    return west, north, west + mm(room.width), north + mm(room.depth)


def tiling(rooms: Sequence[Room], width: float, depth: float, bent: bool = False) -> list[str]:
    """The rooms lie in the house, do not overlap, and cover it; or, where it is bent, make one part without a hole that fills it."""
    faults, boxes = [], [box(room) for room in rooms]
    for i, (w, n, e, s) in enumerate(boxes):
        if w < 0 or n < 0 or e > mm(width) or s > mm(depth) or w >= e or n >= s:
            faults.append(f"{rooms[i].id} leaves the house")
    eastwards = sorted(range(len(rooms)), key=lambda i: boxes[i])
    for at, i in enumerate(eastwards):
        _, n, e, s = boxes[i]
        for j in takewhile(lambda j: boxes[j][0] < e, eastwards[at + 1 :]):  # noqa: B023 - used at once
            if min(s, boxes[j][3]) > max(n, boxes[j][1]):
                faults.append(f"{rooms[j].id} overlaps {rooms[i].id}")
    if not bent:  # what lies inside without overlaps, and is as large, is the whole house
        covered = sum((e - w) * (s - n) for w, n, e, s in boxes) == mm(width) * mm(depth)
        return faults if covered else [*faults, "the rooms do not cover the house"]
    try:
        xs, zs = (sorted(line) for line in zip(*((x, z) for x, z, _ in silhouettes.corners(boxes)), strict=True))
    except ValueError as problem:
        return [*faults, f"the house is {problem}"]
    if (xs[0], zs[0], xs[-1], zs[-1]) != (0, 0, mm(width), mm(depth)):
        faults.append("the rooms do not reach the sides of the house")
    return faults


def segment(room: Room, opening: Opening) -> tuple[str, int, int, int]:
    """Where an opening is in the house: direction of its wall, the wall's line, the opening's ends."""
    w, n, e, s = box(room)
    middle, half = round(opening.position * 2000), mm(opening.width)
    start = w if opening.wall in ("north", "south") else n
    line = {"north": n, "south": s, "west": w, "east": e}[str(opening.wall)]
    direction = "x" if opening.wall in ("north", "south") else "z"
    assert (middle - half) % 2 == 0, f"{opening.id} has an edge off the millimetre lattice"
    return direction, line, start + (middle - half) // 2, start + (middle + half) // 2


def wall_length(room: Room, wall: str | None) -> int:
    return mm(room.width) if wall in ("north", "south") else mm(room.depth)


def openings(rooms: Sequence[Room]) -> list[str]:
    """Openings lie inside their walls, apart from each other, and both rooms of a door agree about it."""
    faults = []
    for room in rooms:
        for opening in room.openings:
            low, high = round(opening.position * 1000 - opening.width * 500), round(opening.position * 1000 + opening.width * 500)
            if low < JAMB or high > wall_length(room, opening.wall) - JAMB:
                faults.append(f"{opening.id} does not fit the {opening.wall} wall of {room.id}")
            if opening.sill + opening.height > 2.8:
                faults.append(f"{opening.id} is higher than the wall")
        for i, one in enumerate(room.openings):
            for other in room.openings[:i]:
                near = abs(one.position - other.position) < (one.width + other.width) / 2 - 1e-9
                if one.wall == other.wall and near:
                    faults.append(f"{one.id} and {other.id} overlap in {room.id}")
    return faults + list(_agreement(rooms))


def outside(rooms: Sequence[Room], room: Room, wall: str, span: tuple[int, int]) -> bool:
    """Whether no other room lies at any of a part of a wall, half a wall to either side included."""
    direction, line, _, _ = sides(room)[wall]
    for other in rooms:
        there, beside, low, high = sides(other)[FACING[wall]]
        if other is not room and (there, beside) == (direction, line) and max(low, span[0] - JAMB) < min(high, span[1] + JAMB):
            return False
    return True


def _agreement(rooms: Sequence[Room]) -> Iterator[str]:
    seen: dict[str, list[tuple[Room, Opening]]] = {}
    for room in rooms:
        for opening in room.openings:
            seen.setdefault(opening.id, []).append((room, opening))
    for name, sides in seen.items():
        room, opening = sides[0]
        if opening.connects_to == "EXTERIOR":
            _, _, low, high = segment(room, opening)
            if len(sides) != 1 or not outside(rooms, room, str(opening.wall), (low, high)):
                yield f"{name} does not lead outside"
            if not opening.render_panel:
                yield f"{name} is drawn by nobody"
            continue
        if len(sides) != 2 or sides[0][1].connects_to != sides[1][0].id or sides[1][1].connects_to != sides[0][0].id:
            yield f"{name} does not join two rooms"
            continue
        if segment(*sides[0]) != segment(*sides[1]):
            yield f"{name} is in two places"
        first, second = sides[0][1], sides[1][1]
        if (first.kind, first.height, first.hinge) != (second.kind, second.height, second.hinge):
            yield f"{name} is two things"
        if first.kind == "door" and {first.swing, second.swing} != {"in", "out"}:
            yield f"{name} swings both ways or neither"
        if first.render_panel == second.render_panel:
            yield f"{name} is drawn twice or not at all"


def entrances(rooms: Sequence[Room]) -> list[tuple[Room, Opening]]:
    return [(room, opening) for room in rooms for opening in room.openings if opening.main_entrance]


def reached(rooms: Sequence[Room], without: str | None = None) -> set[str]:
    """The rooms one can walk to from the main entrance, without walking through one of them."""
    by_id = {room.id: room for room in rooms}
    start = entrances(rooms)[0][0].id
    found, queue = {start}, [start]
    while queue:
        room = by_id[queue.pop()]
        if room.id == without:
            continue
        for opening in room.openings:
            if opening.kind in WALKED and opening.connects_to in by_id and opening.connects_to not in found:
                found.add(str(opening.connects_to))
                queue.append(str(opening.connects_to))
    return found


def entrance(rooms: Sequence[Room]) -> list[str]:
    """One door is the main entrance; every room is reached from it."""
    mains = entrances(rooms)
    if len(mains) != 1 or mains[0][1].kind != "door" or mains[0][1].connects_to != "EXTERIOR":
        return [f"{len(mains)} main entrances"]
    found = reached(rooms)
    return [f"{room.id} cannot be reached" for room in rooms if room.id not in found]


def gardens(rooms: Sequence[Room]) -> list[str]:
    """No room is reached only through an outdoor room."""
    faults = []
    for garden in rooms:
        lost = len(rooms) - len(reached(rooms, garden.id)) if garden.outdoor else 0
        faults += [f"{lost} rooms are only reached through {garden.id}"] if lost else []
    return faults


def violations(rooms: Sequence[Room]) -> list[str]:
    """The issue's rule for houses with a spine, and that nobody walks through bedrooms and bathrooms."""
    types = {room.id: room.type for room in rooms}
    faults = []
    for room in rooms:
        into = {types[str(o.connects_to)] for o in room.openings if o.kind in WALKED and o.connects_to in types}
        owned = room.type == "bathroom" and into & set(SLEEPING)
        if room.type != "hallway" and not into & {"hallway", *PUBLIC} and not owned:
            faults.append(f"{room.id} is off the hallway")
    return faults + walked_through(rooms)


def walked_through(rooms: Sequence[Room]) -> list[str]:
    """Bedrooms and bathrooms that are the way to another room than an own bathroom."""
    faults = []
    for room in rooms:
        if room.type not in (*SLEEPING, "bathroom"):
            continue
        lost = [other for other in rooms if other.id not in reached(rooms, room.id)]
        bad = [other.id for other in lost if room.type == "bathroom" or other.type != "bathroom"]
        faults += [f"{room.id} is the way to {', '.join(bad)}"] if bad else []
    return faults


def aspect(room: Room) -> float:
    return max(room.width, room.depth) / min(room.width, room.depth)


Square = tuple[int, int, int, int]


def squares(room: Room) -> list[tuple[str, bool, Square]]:
    """Every door's and passage's square on the room's floor: its id, whether a leaf sweeps it here, the square."""
    w, n, e, s = box(room)
    found = []
    for opening in room.openings:
        if opening.kind not in WALKED:
            continue
        _, _, low, high = segment(room, opening)
        deep = min(mm(opening.width), 900)
        square = {
            "north": (low, n, high, n + deep),
            "south": (low, s - deep, high, s),
            "west": (w, low, w + deep, high),
            "east": (e - deep, low, e, high),
        }[str(opening.wall)]
        found.append((opening.id, opening.kind == "door" and opening.swing == "in", square))
    return found


def meet(one: Square, other: Square) -> bool:
    return min(one[2], other[2]) > max(one[0], other[0]) and min(one[3], other[3]) > max(one[1], other[1])


def leaves(rooms: Sequence[Room]) -> list[str]:
    """No leaf meets another leaf or another door's square; no passage has a leaf."""
    faults = []
    for room in rooms:
        here = squares(room)
        for i, (name, leaf, square) in enumerate(here):
            for other, other_leaf, other_square in here[:i]:
                if (leaf or other_leaf) and meet(square, other_square):
                    faults.append(f"the leaves or squares of {name} and {other} meet in {room.id}")
        for opening in room.openings:
            if (opening.kind == "door") != (opening.hinge is not None and opening.swing is not None):
                faults.append(f"{opening.id} has a leaf it should not have, or none")
    return faults


def crowded(rooms: Sequence[Room]) -> int:
    """Counts pairs of doors' squares that overlap in rooms other than hallways."""
    total = 0
    for room in rooms:
        here = squares(room) if room.type != "hallway" else []
        total += sum(meet(one[2], other[2]) for i, one in enumerate(here) for other in here[:i])
    return total


def sides(room: Room) -> dict[str, tuple[str, int, int, int]]:
    w, n, e, s = box(room)
    return {"north": ("x", n, w, e), "south": ("x", s, w, e), "west": ("z", w, n, s), "east": ("z", e, n, s)}


FACING = {"north": "south", "south": "north", "east": "west", "west": "east"}


def flags(rooms: Sequence[Room]) -> list[str]:
    """A side is left to others exactly where rooms of lower index draw its whole length; exterior sides are named."""
    faults = []
    for i, room in enumerate(rooms):
        for wall, (direction, line, low, high) in sides(room).items():
            drawn = covered = 0
            for j, other in enumerate(rooms):
                there, beside, start, end = sides(other)[FACING[wall]]
                if (there, beside) == (direction, line):
                    covered += max(0, min(high, end) - max(low, start))
                    drawn += max(0, min(high, end) - max(low, start)) if j < i else 0
            if getattr(room.wall_flags, wall) != (drawn < high - low):
                faults.append(f"the {wall} flag of {room.id} is wrong")
            if getattr(room.exterior_walls, wall) != (covered < high - low):
                faults.append(f"the {wall} exterior wall of {room.id} is wrong")
    return faults


def shared_walls(rooms: Sequence[Room], least: int) -> set[tuple[str, str]]:
    """Pairs of rooms, lower index first, that share at least so many mm of wall."""
    pairs = set()
    for i, room in enumerate(rooms):
        for other in rooms[:i]:
            for wall, (direction, line, low, high) in sides(room).items():
                there, beside, start, end = sides(other)[FACING[wall]]
                if (there, beside) == (direction, line) and min(high, end) - max(low, start) >= least:
                    pairs.add((other.id, room.id))
    return pairs


def joined(rooms: Sequence[Room]) -> set[tuple[str, str]]:
    index = {room.id: i for i, room in enumerate(rooms)}
    pairs = set()
    for room in rooms:
        for opening in room.openings:
            if opening.kind in WALKED and opening.connects_to in index:
                one, other = sorted((room.id, str(opening.connects_to)), key=index.__getitem__)
                pairs.add((one, other))
    return pairs


def sound(rooms: Sequence[Room], width: float, depth: float, bent: bool = False) -> list[str]:
    """Everything that must hold for any request."""
    return [
        *tiling(rooms, width, depth, bent),
        *openings(rooms),
        *entrance(rooms),
        *leaves(rooms),
        *flags(rooms),
    ]
