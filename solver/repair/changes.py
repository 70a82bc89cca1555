"""What is done to a room: placed poses written into it, a repair applied, and what a dropped piece says of itself."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from solver.free_places import footprint
from solver.geometry import WALL_BEHIND, Rect, half_m
from solver.pieces import Placed
from solver.repair.bodies import (
    AT_TABLE_MM,
    Body,
    all_bodies,
    changed_from_the_floor_up,
    parents_of,
    squared,
    tables_of,
    with_bodies,
    without,
)
from solver.repair.room_problem import RoomProblem, Walls
from solver.scene import Furniture, Room

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
