"""Homes that are to be accessible: who has to come everywhere; what the certificate says of it, and of how far each front opens."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from math import ceil
from typing import Any

from catalogs import Catalogs
from catalogs.access_profiles import AccessProfile
from solver.certificate import ACCESS
from solver.free_places import footprint
from solver.furnish.zones import bounds_of, floor_before_doors
from solver.geometry import Rect, strip_at, to_mm, wall_faced, wall_turned
from solver.records import changed
from solver.request import NO_ACCESS, Request
from solver.scene import Room, Scene, robot_width_of
from solver.validator import Checked, access_of
from solver.validator.accessibility import access_profile, turning_squares
from solver.validator.opening import certified_fronts


def with_walker(request: Request, catalogs: Catalogs) -> Request:
    """Returns a request whose robot is at least as wide as the walker of its profile.

    Raises:
        RequestError: there is no such profile.
    """
    if request.access is None or request.access == NO_ACCESS:
        return request
    return replace(request, robot_width=max(request.robot_width, access_profile(request.access, catalogs).walker))


def walked_by(scene: Scene, access: str | None, catalogs: Catalogs) -> dict[str, Any]:
    """Returns what a scene's request says where its rooms are furnished for a profile: that, and who walks there.

    `access` is the profile, or "none"; None: as the scene's request says.

    Raises:
        RequestError: there is no such profile.
    """
    if access is None or access == NO_ACCESS:
        return {} if access is None else {"access": access}
    return {"access": access, "robot_width": max(robot_width_of(scene), access_profile(access, catalogs).walker)}


def access_in(scene: Scene) -> str:
    """Returns the profile that a scene's request names, NO_ACCESS where it names none."""
    name = scene.request.get("access") if isinstance(scene.request, Mapping) else None
    return name if isinstance(name, str) else NO_ACCESS


def floors_asked_for(scene: Scene, catalogs: Catalogs) -> dict[str, list[Rect]]:
    """Returns by room the floor on which nothing may come to stand, mm, for what a scene's profile asks for to stay met.

    That is the largest empty square of each room where it is to be turned in, as large as asked for, the strips about pieces, and the floor
    before doors.
    """
    name = access_in(scene)
    if name not in catalogs.access:
        return {}
    profile, half = catalogs.access[name], (to_mm(scene.wall_thickness) + 1) // 2
    floors = {room.id: [*_strips(room, profile), *floor_before_doors(room, bounds_of(room).shrunk(half), profile)] for room in scene.rooms}
    bare = replace(scene, rooms=tuple(replace(room, decorations=()) for room in scene.rooms))
    for finding in turning_squares(bare, name, catalogs):
        if finding.place and not finding.missing:
            west, north = (to_mm(edge) for edge in finding.place[:2])
            side = ceil(finding.needs * 1000) + 1
            floors[finding.room].append(Rect(west, north, west + side, north + side))
    return floors


def _strips(room: Room, profile: AccessProfile) -> Iterator[Rect]:
    """Yields the strips of floor about the pieces of a room that a profile asks for."""
    for rule in (one for one in profile.rules if one.pieces and one.is_about(room.type)):
        sides = ("left", "right") if rule.what == "along" else ("front",)
        for piece in room.furniture:
            if piece.name in rule.pieces and piece.rotation % 90 == 0:
                own = footprint(piece)
                for faced in (wall_faced(side, round(piece.rotation) % 360) for side in sides):
                    yield strip_at(wall_turned(faced, 180), own.line(faced), own.along(faced), to_mm(rule.deep or rule.min))


def with_access(scene: Scene, catalogs: Catalogs) -> Scene:
    """Returns a scene whose certificate says what of its request's profile is met, and what is not."""
    name = access_in(scene)
    if name not in catalogs.access:
        return scene
    told = access_of(scene, name, catalogs).document()
    said = {key: told[key] for key in ("profile", "met", "unmet")}
    return replace(scene, certificate={**(scene.certificate or {}), ACCESS: said})


def with_fronts(scene: Scene, checked: Checked, rooms: Collection[str] | None = None) -> Scene:
    """Returns a scene whose certificate says of some rooms, or of all, how far their fronts open, and what they meet.

    The scene is as it was checked; no rule reads what is added.
    """
    document: dict[str, Any] = dict(scene.certificate or {})
    entries: dict[str, Any] = dict(document.get("rooms") or {})
    for case in checked.cases:
        name = case.room.room.id
        if name in entries and (rooms is None or name in rooms) and case.judged.opened:
            entries[name] = {**entries[name], "fronts": certified_fronts(case)}
    return changed(scene, certificate={**document, "rooms": entries})
