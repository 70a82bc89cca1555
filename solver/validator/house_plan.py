"""The rules about the plan itself: rooms that share floor, openings that are in no wall, or in another's way.

Bodies are not looked at, and nothing is moved for these rules.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence

from solver.demanded import demand
from solver.scene import EXTERIOR, Opening
from solver.validator.judging import Finding, RuleCase
from solver.validator.lattice import ExactBox, words
from solver.validator.walk import DEEPEST_WALL
from solver.validator.world import LINE_OF, OPPOSITE, PAIR_WORK, Hole, HouseWall, PlacedRoom, World


def rooms_overlap(case: RuleCase) -> Iterator[Finding]:
    """The clear floors of two rooms of a storey share floor; told of the one listed first."""
    place, wall = case.room, 2 * case.world.half_wall
    later = case.world.beside.get(id(place), ())
    demand(PAIR_WORK * len(later))
    x0, z0, x1, z1 = place.outline.bounds
    for other in later:
        x, z = other.x - place.x, other.z - place.z
        bounds = other.outline.bounds
        if bounds.x0 + x < x1 and x0 < bounds.x1 + x and bounds.z0 + z < z1 and z0 < bounds.z1 + z:
            east, south = _shared(place.outline.inside, [box.moved(x, z) for box in other.outline.inside], wall)
            if min(east, south) > 0:
                size = f"{words(east)} from west to east, {words(south)} from north to south"
                yield Finding((), min(east, south), f"{place.room.id} and {other.room.id} are rooms that share floor: {size}")


def opening_wrong(case: RuleCase) -> Iterator[Finding]:
    """An opening is not wholly in a wall, does not lead where it says, or meets another of its room; of each the first that is wrong.

    What both its rooms list wrongly is told once, of the room listed first.
    """
    world, place = case.world, case.room
    there: dict[str, set[tuple[str, str | None]]] = {}
    for opening, amount, before, after in _wrong(world, place):
        rooms, other = place.room.id, world.by_id.get(opening.connects_to or "")
        if other is not None and other is not place:
            name = other.room.id
            if name not in there:
                there[name] = {(one.id, one.connects_to) for one, *_ in _wrong(world, other)}
            if (opening.id, rooms) in there[name]:
                if next(one for one in world.places if one is place or one is other) is other:
                    continue
                rooms = f"{rooms} and {name}"
        yield Finding((), amount, f"the {opening.kind} {opening.id} {before} {rooms}{after}")


def _wrong(world: World, place: PlacedRoom) -> Iterator[tuple[Opening, int, str, str]]:
    """Yields what is wrong with the openings that a room lists: by how much, and how, before and after the room's name."""
    placed = {id(hole.opening) for hole in place.holes}
    for opening in place.room.openings:
        if id(opening) not in placed:
            yield opening, 0, "is in no wall of", ""
    in_line: dict[tuple[str, int], list[Hole]] = {}
    for hole in place.holes:
        before = in_line.setdefault((hole.edge.side, hole.edge.line), [])
        found = _leaves_its_wall(place, hole) or _leads_elsewhere(world, place, hole) or _meets(hole, before) or _reaches_above(place, hole)
        before.append(hole)
        if found is not None:
            yield hole.opening, found[0], "of", f" {found[1]}"


def _shared(one: Sequence[ExactBox], other: Sequence[ExactBox], wall: int) -> tuple[int, int]:
    """Returns the largest extents, less a wall's, that a box of one room and one of another have in common."""
    demand(PAIR_WORK * len(one) * len(other))
    extents = ((min(a.x1, b.x1) - max(a.x0, b.x0) - wall, min(a.z1, b.z1) - max(a.z0, b.z0) - wall) for a in one for b in other)
    return max(extents, key=min)


def _leaves_its_wall(place: PlacedRoom, hole: Hole) -> tuple[int, str] | None:
    side, line, start, end = hole.edge
    over = _uncovered(start, end, [(first, last) for wall, at, first, last in place.edges if at == line and wall == side])
    return (over, f"reaches {words(over)} beyond its wall") if over > 0 else None


def _reaches_above(place: PlacedRoom, hole: Hole) -> tuple[int, str] | None:
    """Judges how high an opening reaches; one above a sill that has the height of those that say none may have been meant lower."""
    above, is_sure = hole.top - place.ceiling, hole.sill <= 0 or hole.opening.height != Opening.height
    if above <= 0 or not (is_sure or hole.sill >= place.ceiling):
        return None
    return above, f"reaches {words(above)} above its wall, which is {words(place.ceiling)} high"


def _leads_elsewhere(world: World, place: PlacedRoom, hole: Hole) -> tuple[int, str] | None:
    """Judges what an opening says that it leads to. A room that was sent alone may speak of rooms that were not."""
    to = hole.opening.connects_to
    if to is None or len(world.places) == 1:
        return None
    if to != EXTERIOR and to not in world.by_id:
        return 0, f"leads to {to}, which is no room of the scene"
    if to != EXTERIOR and world.by_id[to].room.level != place.room.level:
        return None
    return _faces_a_room(world, place, hole) if to == EXTERIOR else _misses(world, place, hole, to)


def _faces_a_room(world: World, place: PlacedRoom, hole: Hole) -> tuple[int, str] | None:
    """Judges an opening to the outside; what lies outdoors is outside."""
    if place.room.outdoor:
        return None
    behind: dict[str, list[tuple[int, int]]] = {}
    for wall in _beyond(world, place, hole):
        if not wall.place.room.outdoor:
            behind.setdefault(wall.place.room.id, []).append((wall.start, wall.end))
    for name, walls in behind.items():
        start, end = _in_house(place, hole)
        shared = end - start - _uncovered(start, end, walls)
        return shared, f"leads outside, but {name} lies behind {words(shared)} of it"
    return None


def _misses(world: World, place: PlacedRoom, hole: Hole, to: str) -> tuple[int, str] | None:
    """Judges an opening to a room: that room's wall lies behind all of it."""
    walls = [(wall.start, wall.end) for wall in _beyond(world, place, hole) if wall.place.room.id == to]
    over = _uncovered(*_in_house(place, hole), walls)
    return (over, f"leads to {to}, whose wall is missing behind {words(over)} of it") if over > 0 else None


def _in_house(place: PlacedRoom, hole: Hole) -> tuple[int, int]:
    """Returns from where to where along its line a hole lies in the house."""
    along = place.x if hole.edge.runs_east else place.z
    return hole.edge.start + along, hole.edge.end + along


def _beyond(world: World, place: PlacedRoom, hole: Hole) -> list[HouseWall]:
    """Returns the other rooms' walls that are a hole's other side, for a part of its width or for all."""
    cut = hole.edge
    start, end = _in_house(place, hole)
    line = cut.line + (place.z if cut.runs_east else place.x)
    low, high = (line - DEEPEST_WALL, line) if cut.side in ("north", "west") else (line, line + DEEPEST_WALL)
    walls = world.walls.get((place.room.level, OPPOSITE[cut.side]), ())
    first, last = bisect_left(walls, low, key=LINE_OF), bisect_right(walls, high, key=LINE_OF)
    demand(PAIR_WORK * (last - first))
    return [wall for wall in walls[first:last] if wall[1] < end and start < wall[2] and wall[3] is not place]


def _uncovered(start: int, end: int, parts: Sequence[tuple[int, int]]) -> int:
    """Returns how much of an interval none of the parts covers."""
    for first, last in parts:
        if first <= start and end <= last:  # as nearly always
            return 0
    missing, at = 0, start
    for first, last in sorted(parts):
        if last > at and first < end:
            missing += max(first - at, 0)
            at = min(last, end)
    return missing + end - at


def _meets(hole: Hole, others: Sequence[Hole]) -> tuple[int, str] | None:
    """Judges an opening beside those listed before it in the same line of wall."""
    if not others:
        return None
    start, end, sill, top = hole.edge.start, hole.edge.end, hole.sill, hole.top
    apart = (max(start - one.edge.end, one.edge.start - end) >= 0 or one.top <= sill or one.sill >= top for one in others)
    number = next((number for number, is_apart in enumerate(apart) if not is_apart), len(others))
    demand(PAIR_WORK * number)
    if number == len(others):
        return None
    other = others[number]
    along = min(end, other.edge.end) - max(start, other.edge.start)
    return along, f"and the {other.opening.kind} {other.opening.id} share {words(along)} of its wall"
