"""The finished floor plan: rooms as the scene has them, and a door moved along its wall afterwards."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, Final

from catalogs.schema import Catalogs
from solver.floorplan.openings import Cut, OpenedHouse, door_places, pane_of
from solver.floorplan.tiling import Joint, Layout
from solver.geometry import ALONG_X, OPPOSITE, Rect, to_m
from solver.records import changed
from solver.scene import EXTERIOR, WALLS, Flooring, Opening, Room, Sides

DOOR_HEIGHT: Final = 2.1
"""Height of doors and passages, m."""
CLOCKWISE: Final = ("north", "east", "south", "west")
"""The walls in the order of a rectangle's lines."""
GARAGE_DOOR_HEIGHT: Final = 2.2
"""Height of garage doors, m. Our choice."""


@dataclass(frozen=True)
class Drawing:
    """What the rooms are written from: the layout, rectangles as written, types, shared walls and openings on the lattice."""

    layout: Layout
    rects: tuple[Rect, ...]
    types: tuple[str, ...]
    shared: tuple[Joint, ...]
    cuts: tuple[Cut, ...]
    catalogs: Catalogs

    def ids(self) -> tuple[str, ...]:
        """Returns the rooms' ids."""
        return tuple(f"{name}_{i}" for i, name in enumerate(self.types))


@dataclass(frozen=True)
class FloorPlan:
    """RoomAccess rooms with openings, without furniture.

    `adjacency` are the pairs of rooms whose shared wall could take a door; `unjoined` those of them, by id, without one.
    `notes` are for the certificate. `drawing` is what with_door_at needs.
    """

    rooms: tuple[Room, ...]
    corridors: tuple[Mapping[str, Any], ...]
    adjacency: tuple[tuple[int, int], ...]
    unjoined: tuple[tuple[str, str], ...]
    notes: tuple[str, ...]
    spine: bool
    drawing: Drawing


def written(drawing: Drawing, notes: tuple[str, ...]) -> FloorPlan:
    """Writes a drawing as a floor plan."""
    ids = drawing.ids()
    joined = {tuple(sorted(cut.sides)) for cut in drawing.cuts if cut.other is not None}
    adjacency = tuple(sorted((joint.a, joint.b) for joint in drawing.shared))
    return FloorPlan(
        rooms=_rooms(drawing, ids),
        corridors=drawing.layout.corridors,
        adjacency=adjacency,
        unjoined=tuple((ids[a], ids[b]) for a, b in adjacency if (a, b) not in joined),
        notes=notes,
        spine=drawing.layout.spine,
        drawing=drawing,
    )


def _rooms(drawing: Drawing, ids: tuple[str, ...]) -> tuple[Room, ...]:
    flags = _wall_flags(drawing.layout)
    openings: dict[int, list[Opening]] = {}
    for cut in drawing.cuts:
        alike = _alike(drawing, cut)
        for room in cut.sides:
            openings.setdefault(room, []).append(_opening(drawing, cut, room, ids, alike))
    return tuple(_room(drawing, i, flags[i], tuple(openings.get(i, ()))) for i in range(len(ids)))


def _room(drawing: Drawing, index: int, flags: Sides, openings: tuple[Opening, ...]) -> Room:
    rect, name = drawing.rects[index], drawing.types[index]
    kind = drawing.catalogs.rooms[name]
    outside = drawing.layout.exposed[index]
    walls = drawing.layout.walls
    own = walls.outer != walls.thickness and not kind.outdoor and bool(outside)
    return changed(
        _ROOM,
        id=f"{name}_{index}",
        index=index,
        type=name,
        x=to_m(rect.x0),
        z=to_m(rect.z0),
        width=to_m(rect.width),
        depth=to_m(rect.depth),
        outdoor=kind.outdoor,
        flooring=_flooring(kind.flooring, drawing.catalogs.floorings[kind.flooring].color),
        accent=kind.accent,
        wall_thickness=tuple(to_m(walls.outer) if wall in outside else None for wall in CLOCKWISE) if own else None,
        exterior_walls=_sides(*(wall in outside for wall in WALLS)),
        wall_flags=flags,
        openings=openings,
    )


def _opening(drawing: Drawing, cut: Cut, room: int, ids: tuple[str, ...], alike: Mapping[str, Any]) -> Opening:
    """Writes an opening as one of its rooms sees it; `alike` is what both say."""
    wall, partner = cut.wall_of(room), cut.other if room == cut.room else cut.room
    return changed(
        _OPENING,
        **alike,
        wall=wall,
        position=to_m(cut.centre - drawing.rects[room].along(wall)[0]),
        connects_to=ids[partner] if partner is not None else EXTERIOR,
        swing=("in" if cut.leaf == room else "out") if cut.kind == "door" else None,
        render_panel=partner is None or room < partner,
    )


def _alike(drawing: Drawing, cut: Cut) -> dict[str, Any]:
    """Returns what all rooms at an opening say of it."""
    height, sill = (GARAGE_DOOR_HEIGHT if cut.kind == "garage_door" else DOOR_HEIGHT), 0.0
    if cut.kind == "window":
        pane = pane_of(drawing.catalogs.rooms[drawing.types[cut.room]])
        height, sill = to_m(pane.height), to_m(pane.sill)
    hinge = _hinge(cut, drawing) if cut.kind == "door" else None
    sizes = {"width": to_m(cut.width), "height": height, "sill": sill}
    return {"id": cut.id, "kind": cut.kind, **sizes, "hinge": hinge, "main_entrance": cut.main}


def _hinge(cut: Cut, drawing: Drawing) -> str:
    """The leaf hangs at the end nearer to the corner of the room it sweeps, so that it opens against the wall there.

    Where homes are made for a profile that asks for floor beside the latch on both sides, a corner of either room for which it does.
    """
    profile, swept = drawing.catalogs.profile, cut.room if cut.leaf is None else cut.leaf
    low, high = drawing.rects[swept].along(cut.wall)
    for room in [one for one in cut.sides if profile.latch_behind(drawing.types[one])] if profile else ():
        start, end = drawing.rects[room].along(cut.wall)
        low, high = max(low, start), min(high, end)
    return "start" if cut.centre - low <= high - cut.centre else "end"


def _wall_flags(layout: Layout) -> list[Sides]:
    """A room draws a side unless rooms of lower index draw its whole length."""
    covered: dict[tuple[int, str], int] = {}
    for _, b, wall, low, high in layout.met:
        side = (b, OPPOSITE[wall])
        covered[side] = covered.get(side, 0) + high - low
    sides = []
    for i, rect in enumerate(layout.rooms):
        width, depth = rect.width, rect.depth
        sides.append(_sides(*(covered.get((i, wall), 0) < (width if wall in ALONG_X else depth) for wall in WALLS)))
    return sides


_ROOM: Final = Room("")
_OPENING: Final = Opening("")
_flooring: Final = lru_cache(maxsize=1024)(Flooring)
_sides: Final = lru_cache(maxsize=16)(Sides)
"""Every set of walls once, in the order of WALLS."""


def _cut(plan: FloorPlan, opening_id: str) -> Cut:
    for cut in plan.drawing.cuts:
        if cut.id == opening_id:
            return cut
    raise KeyError(opening_id)


def door_positions(plan: FloorPlan, opening_id: str) -> tuple[int, ...]:
    """Returns where else in its wall a door or passage could stand; none lets a leaf or square meet another's.

    Positions of its centre along x (walls north and south) or z (east and west), mm in the house: the ends of the shared wall first, then
    its quarters, then every 0.1 m.
    """
    drawing = plan.drawing
    house = OpenedHouse(drawing.layout, drawing.rects, drawing.types, drawing.catalogs.rooms, drawing.catalogs.profile)
    return door_places(house, drawing.shared, drawing.cuts, _cut(plan, opening_id))


def with_door_at(plan: FloorPlan, opening_id: str, position_mm: int) -> FloorPlan:
    """Returns the plan with one door or passage moved along its wall to one of `door_positions`."""
    drawing = plan.drawing
    moved = _cut(plan, opening_id)._replace(centre=position_mm)
    cuts = tuple(moved if cut.id == opening_id else cut for cut in drawing.cuts)
    drawing = replace(drawing, cuts=cuts)
    ids, alike, rooms = drawing.ids(), _alike(drawing, moved), list(plan.rooms)
    for room in moved.sides:
        written_anew = _opening(drawing, moved, room, ids, alike)
        rooms[room] = changed(rooms[room], openings=tuple(written_anew if one.id == opening_id else one for one in rooms[room].openings))
    return replace(plan, rooms=tuple(rooms), drawing=drawing)
