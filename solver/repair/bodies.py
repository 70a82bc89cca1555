"""The bodies of a sent room: footprints, who is on the floor, who is tucked under a table, what carries what and how it goes along.

And what is done to them: placed poses written into the room, a repair applied, and what a dropped piece says of itself.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any, TypeVar

import numpy as np

from solver.free_places import FLAT_MM, footprint
from solver.geometry import FACING, WALL_BEHIND, Rect, half_m, turned, wall_turned
from solver.pieces import Placed
from solver.repair.room_problem import RoomProblem, Walls
from solver.scene import Decoration, Dynamic, Furniture, Room

AT_TABLE_MM = 300
"""How far a chair may be from its table and still be that table's."""
UNTUCKED_MM = 150
"""Depth of a tucked chair that stays outside its table (docs/scene.md, overlap)."""


def size_of(body: Body) -> tuple[int, int, int]:
    """Returns the unrotated extents, mm, rounded up."""
    return (
        math.ceil(body.width * 1000 - 1e-6),
        math.ceil(body.depth * 1000 - 1e-6),
        math.ceil(body.height * 1000 - 1e-6),
    )


def bounding_size(body: Body, rect: Rect) -> tuple[int, int, int]:
    """Returns the unrotated size whose footprint at the squared rotation is the rectangle."""
    width, depth = turned(rect.width, rect.depth, squared(body.rotation))
    return width, depth, size_of(body)[2]


def floor_bodies(room: Room) -> list[Body]:
    """Returns what the solver may move: bodies that rest on nothing else, no rugs or mats among them."""
    carried = carriers(room)
    bodies: list[Body] = [piece for piece in room.furniture if piece.id not in carried and piece.height * 1000 > FLAT_MM]
    for thing in room.decorations:
        loose = thing.parent is None and thing.mounted_on_wall is None and thing.y < RESTS_MM / 1000
        if loose and thing.height * 1000 > FLAT_MM:
            bodies.append(thing)
    return bodies


def tables_of(bodies: Sequence[Body]) -> dict[str, Body]:
    """Returns under which table each chair stands that names one."""
    by_id = {body.id: body for body in bodies}
    tables = {body.id: by_id.get(body.under or "") for body in bodies if isinstance(body, Furniture)}
    return {label: table for label, table in tables.items() if table is not None and table.id != label}


def too_deep_mm(chair: Body, table: Body) -> int:
    """Returns how much too far a chair is tucked: by at most its depth less 0.15 m (docs/scene.md, overlap); 0 for none, mm."""
    own, other = footprint(chair), footprint(table)
    if not own.overlaps(other):
        return 0
    shared = own.common(other)
    return max(0, (shared.depth if squared(chair.rotation) % 180 == 0 else shared.width) - _tuck_mm(chair))


def drawn_out(chair: Furniture, table: Body) -> Furniture:
    """Returns a chair pulled out from under its table, the shorter way, until it is not tucked too far."""
    if too_deep_mm(chair, table) == 0:
        return chair
    own, other, tuck = footprint(chair), footprint(table), _tuck_mm(chair)
    if squared(chair.rotation) % 180 == 0:
        return replace(chair, z=chair.z + min(other.z0 + tuck - own.z1, other.z1 - tuck - own.z0, key=abs) / 1000)
    return replace(chair, x=chair.x + min(other.x0 + tuck - own.x1, other.x1 - tuck - own.x0, key=abs) / 1000)


def _tuck_mm(chair: Body) -> int:
    return max(0, math.floor(chair.depth * 1000 + 1e-6) - UNTUCKED_MM)


RESTS_MM = 20
"""How far a body's underside may be from the top it rests on."""

Body = Furniture | Decoration
Thing = TypeVar("Thing", bound=Furniture | Decoration | Dynamic)


def squared(rotation: float) -> int:
    """Returns the nearest right angle in [0, 360)."""
    return round(rotation / 90) * 90 % 360


def all_bodies(room: Room) -> tuple[Body, ...]:
    """Returns a room's furniture and decorations."""
    return (*room.furniture, *room.decorations)


def carriers(room: Room) -> dict[str, str]:
    """Returns which piece stands on which, by id: on the one it names, else on the one whose top it rests on; no rings."""
    known, tops = {piece.id for piece in room.furniture}, _Tops(room.furniture)
    carried = {piece.id: piece.on for piece in room.furniture}
    for piece in room.furniture:
        if piece.on is None or piece.on not in known or piece.on == piece.id:
            carried[piece.id] = tops.rested_on(piece) if piece.y * 1000 > RESTS_MM else None
    parents = {child: parent for child, parent in carried.items() if parent is not None}
    return {child: parent for child, parent in parents.items() if child not in below(child, parents)}


def parents_of(room: Room) -> dict[str, str]:
    """Returns what stands on, hangs over or lies in what, by id: in the one it names, else in that whose top is nearest to it."""
    found, known, tops = carriers(room), {body.id for body in all_bodies(room)}, _Tops(room.furniture)
    for thing in room.decorations:
        piece = None if thing.mounted_on_wall is not None or thing.y * 1000 <= RESTS_MM else tops.lain_in(thing)
        if thing.parent in known and thing.parent is not None:
            found[thing.id] = thing.parent
        elif piece is not None:
            found[thing.id] = piece
    return found


class _Tops:
    """Footprints and heights of furniture, as tables: many things may lie over many pieces."""

    def __init__(self, pieces: Sequence[Furniture]) -> None:
        self.pieces = pieces

    @cached_property
    def _table(self) -> np.ndarray[Any, np.dtype[np.float64]]:
        """Row by row west, east, north and south, mm, underside and top, m."""
        rects = [footprint(piece) for piece in self.pieces]
        rows = [(one.x0, one.x1, one.z0, one.z1, piece.y, piece.y + piece.height) for one, piece in zip(rects, self.pieces, strict=True)]
        return np.array(rows, dtype=np.float64).reshape(-1, 6).T

    def _over(self, body: Body) -> list[int]:
        """Returns the numbers of the pieces that begin lower than a body, and over whose footprints its middle is."""
        west, east, north, south, low, _ = self._table
        x, z = body.x * 1000, body.z * 1000
        return np.flatnonzero((west < x) & (x < east) & (north < z) & (z < south) & (low < body.y)).tolist()

    def rested_on(self, piece: Furniture) -> str | None:
        """Returns the first piece on whose top another one rests."""
        tops = self._table[5]
        others = (self.pieces[k].id for k in self._over(piece) if abs(tops[k] - piece.y) * 1000 <= RESTS_MM)
        return next((other for other in others if other != piece.id), None)

    def lain_in(self, thing: Decoration) -> str | None:
        """Returns the piece with the lowest top that a thing lies in or on."""
        tops = self._table[5]
        within = [k for k in self._over(thing) if thing.y <= tops[k] + RESTS_MM / 1000]
        return self.pieces[min(within, key=lambda k: tops[k])].id if within else None


def below(label: str, parents: Mapping[str, str]) -> list[str]:
    """Returns what carries a body, one under the other; the body itself among them where it carries itself in the end."""
    found: list[str] = []
    while label in parents and parents[label] not in found:
        label = parents[label]
        found.append(label)
    return found


def root_of(label: str, parents: Mapping[str, str]) -> str:
    """Returns the last of what carries a body; the body itself where nothing does."""
    return [label, *below(label, parents)][-1]


def without(room: Room, gone: Container[str]) -> Room:
    """Returns the room without the bodies of those ids and all that they carry."""
    parents = parents_of(room)
    kept = [body for body in all_bodies(room) if not any(label in gone for label in (body.id, *below(body.id, parents)))]
    return with_bodies(room, kept)


def changed_from_the_floor_up(room: Room, change: Callable[[Body, Mapping[str, Body]], Body]) -> Room:
    """Returns the room with its bodies changed, each after what carries it; `change` is also given all bodies as they are by then."""
    parents, sent = parents_of(room), {body.id: body for body in all_bodies(room)}
    now: dict[str, Body] = dict(sent)
    for body in sorted(sent.values(), key=lambda body: len(below(body.id, parents))):
        parent = parents.get(body.id, body.id)
        now[body.id] = change(brought_along(body, sent[parent], now[parent]), now)
    return with_bodies(room, [now[label] for label in sent])


def with_bodies(room: Room, bodies: Iterable[Body]) -> Room:
    """Returns the room with those bodies and no others."""
    every = list(bodies)
    furniture = tuple(body for body in every if isinstance(body, Furniture))
    decorations = tuple(body for body in every if isinstance(body, Decoration))
    same = furniture == room.furniture and decorations == room.decorations
    return room if same else replace(room, furniture=furniture, decorations=decorations)


def brought_along(thing: Thing, before: Body, after: Body) -> Thing:
    """Returns a thing that keeps its place in the frame of what carries it, which was moved and turned."""
    if _pose(before) == _pose(after):
        return thing
    turn = (squared(after.rotation) - squared(before.rotation)) % 360
    fx, fz = FACING[turn]
    dx, dz = thing.x - before.x, thing.z - before.z
    pose: dict[str, Any] = {"x": round(after.x + dx * fz + dz * fx, 4), "z": round(after.z + dz * fz - dx * fx, 4)}
    if after.y != before.y:
        pose["y"] = round(thing.y + after.y - before.y, 4)
    if turn:
        pose["rotation"] = (thing.rotation + turn) % 360
    if isinstance(thing, Decoration) and thing.mounted_on_wall is not None:
        pose["mounted_on_wall"] = wall_turned(thing.mounted_on_wall, turn)
    return replace(thing, **pose)


def _pose(body: Body) -> tuple[float, float, float, float]:
    return body.x, body.y, body.z, body.rotation


def seated_along(people: Iterable[Dynamic], before: Iterable[Room], after: Iterable[Room]) -> tuple[Dynamic, ...]:
    """Takes those who sit along with their seats, from rooms before to the same rooms after; who has lost the seat stands up."""
    sent = {piece.id: piece for room in before for piece in room.furniture}
    now = {piece.id: piece for room in after for piece in room.furniture}
    return tuple(
        (brought_along(person, sent[person.on], now[person.on]) if person.on in now else standing(person))
        if person.on is not None and person.on in sent
        else person
        for person in people
    )


def standing(person: Dynamic) -> Dynamic:
    """Returns somebody on the floor: a person who sat is as tall as persons are."""
    if person.on is None:
        return person
    tall = Dynamic("") if person.kind == "person" else person
    return replace(person, y=0.0, width=tall.width, depth=tall.depth, height=tall.height, on=None)


AT_WALL_MM = 100
"""How far a back may be from a wall's face to be at it."""

Repair = Mapping[str, Any]
"""One of the changes that /fix offers, as README.md describes them."""


def written_back(problem: RoomProblem, placed: Iterable[Placed]) -> Room:
    """Returns the problem's room with the placed poses; what is carried by a piece follows it, what is locked stays."""
    poses, parents = {one.label: one for one in placed}, parents_of(problem.room)

    def change(body: Body, _: Mapping[str, Body]) -> Body:
        stays = body.id not in poses or problem.settings.is_locked(body)
        return body if stays else _posed(body, poses[body.id], body.id in parents)

    return changed_from_the_floor_up(problem.room, change)


def _posed(body: Body, to: Placed, carried: bool) -> Body:
    pose = replace(body, x=half_m(to.footprint.x0 + to.footprint.x1), z=half_m(to.footprint.z0 + to.footprint.z1), rotation=to.rotation)
    if not isinstance(pose, Furniture) or pose.wall is None or carried:
        return pose
    as_sent = pose.wall if to.chosen.attach is None else None
    return replace(pose, wall=to.wall or to.chosen.stretch_of or as_sent)


def applied(room: Room, repair: Repair) -> Room:
    """Returns the room with a repair applied; `unlock` also takes the id out of the request's `locked`.

    move and unlock shift the body by dx and dz, m, and set its rotation and wall; turn sets its rotation; shrink its width
    and depth, m; leave_out takes it out with all it carries.
    """
    if repair["action"] == "leave_out":
        return without(room, (repair["id"],))
    return with_bodies(room, (_changed(body, repair) if body.id == repair["id"] else body for body in all_bodies(room)))


def _changed(body: Body, repair: Repair) -> Body:
    changes: dict[str, Any] = {key: repair[key] for key in ("rotation", "width", "depth") if key in repair}
    if "dx" in repair:
        changes |= {"x": round(body.x + repair["dx"], 4), "z": round(body.z + repair["dz"], 4)}
    if isinstance(body, Furniture) and "wall" in repair:
        changes["wall"] = repair["wall"]
    if isinstance(body, Furniture) and repair["action"] == "unlock":
        changes["locked"] = False
    return replace(body, **changes)


def with_walls_told(problem: RoomProblem) -> Room:
    """Returns the room with what its moved pieces say of themselves made true: the wall behind, the table; no pose changes."""
    room, settings = problem.room, problem.settings
    tables = tables_of(room.furniture)
    changed: list[Body] = []
    for piece in room.furniture:
        if piece.id in settings.moved and not settings.is_locked(piece):
            table, own = tables.get(piece.id), footprint(piece)
            left = table is not None and not own.overlaps(footprint(table).shrunk(-AT_TABLE_MM))
            hugs = piece.wall is None and piece.name in settings.wall_names
            wall = _wall_behind(piece, own, problem.walls) if hugs else piece.wall
            changed.append(replace(piece, wall=wall, under=None if left else piece.under))
        else:
            changed.append(piece)
    return with_bodies(room, (*changed, *room.decorations))


def _wall_behind(piece: Furniture, own: Rect, walls: Walls) -> str | None:
    """Returns the wall whose face the back of a squared piece is at."""
    turn = squared(piece.rotation)
    wall = WALL_BEHIND[turn] if turn == piece.rotation % 360 else None
    if wall is None or piece.on is not None:
        return None
    start, end = own.along(wall)
    before = [walls.before(edge, AT_WALL_MM) for edge in walls.edges if edge[0] == wall and edge[2] < end and start < edge[3]]
    return wall if any(0 <= own.wall_distance(wall, region) <= AT_WALL_MM for region in before) else None
