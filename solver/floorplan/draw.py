"""draw(): the whole stage, top to bottom."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations
from operator import itemgetter
from typing import NamedTuple

from catalogs.access_profiles import AccessProfile
from catalogs.schema import Catalogs
from solver.errors import RequestError
from solver.fields import ANY, RECTANGLE
from solver.floorplan.access import THROUGH_OTHER, RoomAccess, door_tree, entrance_of, passing_cost, plan_access, served
from solver.floorplan.bsp import partition
from solver.floorplan.classify import check_forced, classify
from solver.floorplan.columns import RoomBounds
from solver.floorplan.fitness import Fitness
from solver.floorplan.given import parts_of
from solver.floorplan.openings import OpenedHouse, open_walls
from solver.floorplan.plan import Drawing, FloorPlan, written
from solver.floorplan.programme import plan_home
from solver.floorplan.spine import carve
from solver.floorplan.tiling import CLEAR_HALLWAY_MM, LATTICE_MM, LEAF_MM, WALL_MM, HouseWalls, Joint, Layout, joints, set_apart, trimmed
from solver.geometry import Rect, to_m, to_mm
from solver.request import Request


def draw(request: Request, catalogs: Catalogs) -> FloorPlan:
    """Draws the floor plan of a request.

    Args:
        request: what is wished; its seed must be set.
        catalogs: the room types.

    Raises:
        RequestError: min_room_size is larger than the house, force_types names an unknown room or type, or the programme
            an unknown word or preset.
    """
    walls = _walls_of(request, catalogs)
    return _planned(request, catalogs, walls) if request.planned else _partitioned(request, catalogs, walls)


def wall_thickness_of(request: Request) -> float:
    """Returns how thick inner walls are to be, m."""
    return to_m(WALL_MM) if request.wall_thickness is None else request.wall_thickness


def _walls_of(request: Request, catalogs: Catalogs) -> HouseWalls:
    """Reads how thick walls are to be; refuses outer walls that are thinner than inner ones."""
    inner = wall_thickness_of(request)
    outer = inner if request.outer_wall_thickness is None else request.outer_wall_thickness
    if outer < inner:
        raise RequestError("outer_wall_thickness", f"{outer} m is less than the {inner} m of inner walls", f"at least {inner}")
    robot = -(-to_mm(request.robot_width) // LATTICE_MM) * LATTICE_MM
    walls = HouseWalls(to_mm(inner), to_mm(outer), max(LEAF_MM, robot))
    return walls if catalogs.profile is None else _walls_for(catalogs.profile, catalogs, walls)


def _walls_for(profile: AccessProfile, catalogs: Catalogs, walls: HouseWalls) -> HouseWalls:
    """Returns walls with doors and hallways as wide as a profile asks for, and wall beside the doors' latches."""
    leaf, latch = to_mm(profile.leaf(main=False)), to_mm(max(map(profile.latch_behind, catalogs.rooms)))
    clear = max(CLEAR_HALLWAY_MM, to_mm(profile.hallway))
    return walls._replace(leaf=max(walls.leaf, leaf), clear_hallway=clear, latch=latch and latch + walls.half)


def _partitioned(request: Request, catalogs: Catalogs, walls: HouseWalls) -> FloorPlan:
    """A plain request: a rectangle is cut into rooms, and they are given types."""
    if isinstance(request.outline, str) and request.outline not in (ANY, RECTANGLE):
        raise RequestError("outline", f"{request.outline} is for planned homes", f"{RECTANGLE}, or a program or an area beside it")
    layout, notes = _layout(request, catalogs, walls)
    layout = replace(layout, walls=walls)
    check_forced(request, len(layout.rooms), catalogs.rooms)
    shared = joints(layout)
    access_plan = plan_access(layout, shared)
    fitness = Fitness(layout, shared, access_plan, catalogs)
    types, more = classify(fitness, request)
    ways = _ways(layout, RoomAccess(types, shared, access_plan, catalogs.rooms))
    return _opened(layout, ways if request.force_types else _sane_ways(fitness, ways), catalogs, (*notes, *more), is_plain=True)


class _Ways(NamedTuple):
    """Rooms with types, the room and wall by which one comes in, and from there the tree of doors."""

    typed: RoomAccess
    entrance: tuple[int, str]
    tree: tuple[tuple[Joint, int], ...]

    @property
    def strain(self) -> float:
        """What it costs to walk through rooms that nobody should walk through."""
        types, rooms = self.typed.types, self.typed.rooms
        costs = [passing_cost(types[joint.other(entered)], types[entered], rooms) for joint, entered in self.tree]
        return sum(cost for cost in costs if cost >= THROUGH_OTHER)


def _ways(layout: Layout, typed: RoomAccess) -> _Ways:
    entrance = entrance_of(layout, typed.types, typed.rooms)
    return _Ways(typed, entrance, door_tree(entrance[0], typed))


def _sane_ways(fitness: Fitness, ways: _Ways) -> _Ways:
    """Lets two rooms change types while fewer are then entered through one that nobody should walk through."""

    def suits(types: tuple[str, ...]) -> float:
        return sum(fitness.shape(i, name) + fitness.company(i, name, types) for i, name in enumerate(types) if i in free)

    typed, strain = ways.typed, ways.strain
    free = [i for i, name in enumerate(typed.types) if name != "hallway" and not typed.rooms[name].outdoor]
    while strain:
        types = ways.typed.types
        swapped = (tuple(types[{i: j, j: i}.get(k, k)] for k in range(len(types))) for i, j in combinations(free, 2))
        tried = (_ways(fitness.layout, replace(typed, types=own)) for own in swapped)
        less, _, found = min(
            ((one.strain, suits(one.typed.types), one) for one in tried), key=itemgetter(0, 1), default=(strain, 0.0, ways)
        )
        if less >= strain:
            break
        strain, ways = less, found
    return ways


def _planned(request: Request, catalogs: Catalogs, walls: HouseWalls) -> FloorPlan:
    """A programme: types are dealt, and their rooms' widths are solved."""
    home = plan_home(request, catalogs, walls)
    entrance = entrance_of(home.layout, home.types, catalogs.rooms, by_hallway=False)
    typed = home.access(joints(home.layout), catalogs, entrance[0])
    return _opened(home.layout, _Ways(typed, entrance, door_tree(entrance[0], typed)), catalogs, home.notes)


def _opened(layout: Layout, ways: _Ways, catalogs: Catalogs, notes: tuple[str, ...], is_plain: bool = False) -> FloorPlan:
    """Cuts doors and windows into the walls of typed rooms; planned kitchens are near the dining room, and need their walls."""
    typed, entrance, tree = ways
    rects = set_apart(layout, [catalogs.rooms[name].outdoor for name in typed.types])
    if rects != layout.rooms:
        typed = replace(typed, shared=trimmed(typed.shared, rects, layout.walls.door_wall))
        tree = door_tree(entrance[0], typed)
    house = OpenedHouse(layout, rects, typed.types, catalogs.rooms, catalogs.profile)
    cuts, garages = open_walls(house, (*tree, *served(typed, tree)) if is_plain else tree, entrance)
    drawing = Drawing(layout, rects, typed.types, typed.shared, cuts, catalogs)
    return written(drawing, (*notes, *garages, *_compromises(drawing, tree)))


def _layout(request: Request, catalogs: Catalogs, walls: HouseWalls) -> tuple[Layout, tuple[str, ...]]:
    if request.outline is not None and not isinstance(request.outline, str):
        return _within(request, request.outline, walls.more)
    width, depth = request.extents
    outline = Rect(0, 0, to_mm(width), to_mm(depth))
    least, seed = to_mm(request.min_room_size) + walls.more, request.seed or 0
    if least > min(outline.width, outline.depth):
        allowed = f"at most {to_m(min(outline.width, outline.depth))}"
        raise RequestError("min_room_size", f"{request.min_room_size} m is more than the house's shorter side", allowed)
    if request.use_spine:
        bounds = RoomBounds(least, 1 << request.max_depth, catalogs.rooms["bathroom"].area.max, walls.hallway)
        layout = carve(outline, bounds, seed)
        if layout is not None:
            return layout, layout.notes
    layout = partition(outline, least, request.max_depth, seed)
    if not request.use_spine:
        return layout, layout.notes
    half = to_m((min(outline.width, outline.depth) - walls.hallway) // 2)
    note = f"no hallway spine: beside it each half would be {half} m deep, less than min_room_size {request.min_room_size}"
    return layout, (note, *layout.notes)


def _within(request: Request, corners: Sequence[tuple[float, float]], more: int) -> tuple[Layout, tuple[str, ...]]:
    """Cuts a given outline into rooms."""
    for key in ("width", "depth"):
        if getattr(request, key) is not None:
            raise RequestError(key, "is given beside the outline's corners", "one of the two")
    least = to_mm(request.min_room_size) + more
    parts = parts_of(corners, least)
    box = Rect(0, 0, max(part.rect.x1 for part in parts), max(part.rect.z1 for part in parts))
    layout = partition(box, least, request.max_depth, request.seed or 0, parts)
    notes = ("no hallway spine: the outline is given",) if request.use_spine else ()
    return layout, (*notes, *layout.notes)


def _compromises(drawing: Drawing, tree: tuple[tuple[Joint, int], ...]) -> tuple[str, ...]:
    """Says which rooms can only be entered through one that should not be walked through."""
    notes, types, ids = [], drawing.types, drawing.ids()
    for joint, entered in tree:
        through = joint.other(entered)
        if passing_cost(types[through], types[entered], drawing.catalogs.rooms) >= THROUGH_OTHER:
            notes.append(f"{ids[entered]} can only be entered through {ids[through]}")
    return tuple(notes)
