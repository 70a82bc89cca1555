"""Decorations that float -> back on the nearest point of a surface, at their wall, or on the floor.

Comes in: a sent Room and which of its decorations float. Goes out: the Room. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import replace

from catalogs import Catalogs
from catalogs.entries import Surface
from solver.free_places import footprint
from solver.geometry import Rect, to_mm
from solver.repair.bodies import Body, above, all_bodies, carried_along, size_of
from solver.scene import Decoration, Room


def rested(room: Room, floating: Container[str], catalogs: Catalogs, wall_thickness: float) -> Room:
    """Returns the room with the decorations of those ids where something carries them; the way there is the shortest.

    A ring of things that lie on each other is opened: the first of them loses its parent and lies on the floor.

    Args:
        room: as sent.
        floating: ids.
        catalogs: where the surfaces of known kinds are; other bodies carry on their tops.
        wall_thickness: m.
    """
    half = (to_mm(wall_thickness) + 1) // 2
    room = _opened(room, floating)
    sent: dict[str, Body] = {body.id: body for body in all_bodies(room)}
    bodies = dict(sent)
    for thing in _parents_first(room):
        after = carried_along(thing, sent.get(thing.parent or ""), bodies.get(thing.parent or ""))
        bodies[thing.id] = _at_rest(after, bodies, room, half, catalogs) if thing.id in floating else after
    things = [bodies[thing.id] for thing in room.decorations]
    return replace(room, decorations=tuple(thing for thing in things if isinstance(thing, Decoration)))


def _opened(room: Room, floating: Container[str]) -> Room:
    """Returns the room with every ring of parents opened at the first of its things that may be moved."""
    things = {thing.id: thing for thing in room.decorations}
    for thing in room.decorations:
        if thing.id in floating and thing.mounted_on_wall is None and _in_ring(thing, things):
            things[thing.id] = replace(thing, parent=None)
    return replace(room, decorations=tuple(things.values()))


def _in_ring(thing: Decoration, things: Mapping[str, Decoration]) -> bool:
    """Tells whether what carries a thing comes back to it; what hangs is carried by its wall."""
    seen, at = set[str](), thing.parent or ""
    while at in things and at not in seen and things[at].mounted_on_wall is None:
        seen.add(at)
        at = things[at].parent or ""
    return thing.id in seen


def _parents_first(room: Room) -> list[Decoration]:
    """Returns a room's decorations, each after what carries it; a ring of parents in the document's order."""
    parents = above(room)

    def depth(thing: Decoration) -> int:
        seen, at = {thing.id}, parents.get(thing.id)
        while at is not None and at not in seen:
            seen.add(at)
            at = parents.get(at)
        return len(seen)

    return sorted(room.decorations, key=depth)


def _at_rest(thing: Decoration, bodies: Mapping[str, Body], room: Room, half: int, catalogs: Catalogs) -> Decoration:
    if thing.mounted_on_wall is not None:
        return _at_wall(thing, room, half)
    parent = bodies.get(thing.parent or "")
    if parent is None:
        return _placed(thing, _floor(room).shrunk(half), 0)
    places = [(to_mm(parent.y) + height, rect) for height, rect in surfaces_of(parent, catalogs)]
    level, rect = min(places, key=lambda place: abs(place[0] - to_mm(thing.y)))
    return _placed(thing, rect, level)


def surfaces_of(parent: Body, catalogs: Catalogs, tall_mm: int = 0) -> Sequence[tuple[int, Rect]]:
    """Returns a body's surfaces with so much free height above them: heights above its underside and rectangles, mm."""
    rect = footprint(parent)
    known = [(entry.name or kind, entry.size, entry.surfaces) for kind, entry in catalogs.furniture.items()]
    known += [(kind, thing.size, thing.surfaces) for kind, thing in catalogs.decorations.items()]
    size = (parent.width, parent.depth, parent.height)
    found: tuple[Surface, ...] = next((carries for name, extent, carries in known if (name, extent) == (parent.name, size)), ())
    tall = [one for one in found if one.clearance is None or to_mm(one.clearance) >= tall_mm] or found
    return [(to_mm(one.height), rect.shrunk(to_mm(one.inset))) for one in tall] or [(size_of(parent)[2], rect)]


def _floor(room: Room) -> Rect:
    return Rect(0, 0, to_mm(room.width), to_mm(room.depth))


def _at_wall(thing: Decoration, room: Room, half: int) -> Decoration:
    """Moves a thing to the face of the nearest of the room's walls on its side, or leaves it where there is none."""
    own = footprint(thing)
    places = [_at_face(thing, wall, half, own) for side, wall in _walls(room) if side == thing.mounted_on_wall]
    return min(places, key=lambda place: abs(place.x - thing.x) + abs(place.z - thing.z), default=thing)


def _walls(room: Room) -> Iterator[tuple[str, Rect]]:
    """Yields the sides and lines of a room's walls; those of an outline run clockwise around the floor, or all of them back."""
    corners = [(to_mm(x), to_mm(z)) for x, z in room.outline or ()] or list(_corners(_floor(room)))
    lines = list(zip(corners, [*corners[1:], corners[0]], strict=True))
    if sum(x * next_z - z * next_x for (x, z), (next_x, next_z) in lines) < 0:
        lines = [(b, a) for a, b in lines]
    for (x, z), (next_x, next_z) in lines:
        side = ("north" if next_x > x else "south") if z == next_z else ("east" if next_z > z else "west")
        yield side, Rect(min(x, next_x), min(z, next_z), max(x, next_x), max(z, next_z))


def _corners(rect: Rect) -> tuple[tuple[int, int], ...]:
    return (rect.x0, rect.z0), (rect.x1, rect.z0), (rect.x1, rect.z1), (rect.x0, rect.z1)


def _at_face(thing: Decoration, wall: Rect, half: int, own: Rect) -> Decoration:
    """Moves a thing against a wall's face, within that wall's ends."""
    x0, z0, x1, z1 = wall
    rect = {
        "north": Rect(x0 + half, z0 + half, x1 - half, z0 + half + own.depth),
        "south": Rect(x0 + half, z1 - half - own.depth, x1 - half, z1 - half),
        "west": Rect(x0 + half, z0 + half, x0 + half + own.width, z1 - half),
        "east": Rect(x1 - half - own.width, z0 + half, x1 - half, z1 - half),
    }[thing.mounted_on_wall or ""]
    return _placed(thing, rect, to_mm(thing.y))


def _placed(thing: Decoration, area: Rect, level: int) -> Decoration:
    """Moves a thing into an area at a height by the shortest way; where it is larger than the area, onto its middle."""
    own = footprint(thing)
    x = _moved(thing.x, (own.x0, own.x1), (area.x0, area.x1))
    z = _moved(thing.z, (own.z0, own.z1), (area.z0, area.z1))
    return replace(thing, x=x, z=z, y=level / 1000)


def _moved(middle: float, own: tuple[int, int], area: tuple[int, int]) -> float:
    if own[1] - own[0] > area[1] - area[0]:
        return (area[0] + area[1]) / 2000
    step = max(area[0] - own[0], 0) + min(area[1] - own[1], 0)
    return round(middle + step / 1000, 4) if step else middle
