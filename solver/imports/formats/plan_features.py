"""GeoJSON of a home, for people who write their own: rooms as polygons, doors, windows and walls as lines, furniture as points.

A FeatureCollection with members of its own: `unit`, `y` (`up`, as on paper, or `down`), `drawn` (`lines` or `inner`), `wall_thickness`.
docs/plans.md tells all of it.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from difflib import get_close_matches
from itertools import pairwise
from typing import Any, Final, get_args

from solver.answers import Unread
from solver.errors import FieldError
from solver.imports.drawn import (
    MOST_POINTS,
    MOST_ROOMS,
    DrawnAlong,
    DrawnOpening,
    DrawnPiece,
    DrawnPlan,
    DrawnRoom,
    DrawnWall,
    Spot,
    Tally,
    check_count,
)
from solver.imports.formats.map_features import DOOR, along_walls, in_our_words, levels_of, opening_at, why_left_out
from solver.imports.plain_values import a_list, a_number, a_text, an_object, one_of
from solver.imports.shape_openings import longer_line
from solver.imports.units import unit_named
from solver.scene import OPENING_KINDS

ROOM: Final = "room"
MANY: Final = {"MultiPolygon": "Polygon", "MultiLineString": "LineString", "MultiPoint": "Point"}
"""Geometries that are several of another."""
A_DEGREE: Final = ((111_412.84, -93.5), (111_132.95, -559.85))
"""How long a degree is, m: to the east in cosines of the latitude and of three times it, to the north one part, and that of twice it."""
FEW_DEGREES: Final = 0.005
"""No plan is so small in any unit, but one in degrees."""
MOST_RINGS: Final = 21
"""Of a room: its outline and its holes."""
LINES: Final = (*OPENING_KINDS, "wall")
KINDS: Final = {"Polygon": (ROOM, *LINES), "LineString": LINES, "Point": ("furniture",)}
"""What a feature may be, by its geometry; the first where it does not say."""
OWN: Final = ("kind", "name", "type", "id", "level")
OF_OPENINGS: Final = ("height", "sill", "hinge", "main_entrance")
TOLD: Final = {
    "Polygon": (*OWN, "outdoor", *OF_OPENINGS), "LineString": (*OWN, *OF_OPENINGS, "thickness"),
    "Point": (*OWN, "width", "depth", "height", "rotation", "elevation"),
}  # fmt: skip
"""What features say of themselves, by their geometry; anything else is of another program, but for a slip of the pen."""


def read_features(document: Mapping[str, Any]) -> DrawnPlan:
    """Reads a FeatureCollection, or one Feature.

    Raises:
        FieldError: something in it cannot be read; names its place.
    """
    up = one_of(document, "y", ("up", "down"), "plan") == "up"
    rooms: list[DrawnRoom] = []
    openings: list[DrawnOpening] = []
    walls, faces = list[DrawnWall](), list[DrawnWall]()
    pieces: list[DrawnPiece] = []
    thickness, tally = a_number(document, "wall_thickness", "plan", None), Tally()
    unread, widths = list[Unread](), dict[str, float]()
    for said, shape, where in _features(document, unread):
        form = one_of(shape, "type", tuple(KINDS), f"{where}.geometry", required=True)
        reason = why_left_out(said, form)
        if reason is not None:
            unread.append(Unread(where, reason))
            continue
        kind = one_of(said, "kind", KINDS[form], f"{where}.properties")
        points, *holes = _rings(shape, form, up, where)
        at_point = opening_at(said) if form == "Point" else None
        unread += [
            Unread(f"{where}.properties", f"no property is called {key!r:.60}; {meant}?")
            for key in said if key not in (*TOLD[form], at_point)
            for meant in get_close_matches(key, TOLD[form], 1) if said.get(meant) is None
        ]  # fmt: skip
        if kind == ROOM:
            tally.add("rooms", most=MOST_ROOMS)
            tally.add("corners of rooms", sum(map(len, (points, *holes))))
            rooms.append(replace(_room(said, points, where), holes=tuple(map(tuple, holes))))
            continue
        tally.add("furniture" if form == "Point" else "walls" if kind == "wall" else "openings", len(points) - 1 if kind == "wall" else 1)
        tally.add("points of lines", sum(map(len, (points, *holes))), 4 * MOST_POINTS)
        if at_point:
            openings.append(_opening(at_point, said, points, where))
            widths[where] = a_number(said, "width", where, DOOR)
        elif form == "Point":
            pieces.append(_piece(said, points[0], where))
        elif kind == "wall" and form == "Polygon":
            faces += _walls(said, [[*ring, ring[0]] for ring in (points, *holes)], 0.0, where)
        elif kind == "wall":
            walls += _walls(said, (points,), a_number(said, "thickness", where, thickness or 0.0), where)
        else:
            openings.append(_opening(kind, said, longer_line(points) if form == "Polygon" else points, where))
    drawn = one_of(document, "drawn", ("unsaid", "lines", "inner") if faces else ("lines", "inner"), "plan")
    unit = unit_named(a_text(document, "unit", "plan") or None)
    plan = DrawnPlan(
        tuple(rooms), tuple(openings), (*walls, *faces), tuple(pieces), (), unit,
        next(one for one in get_args(DrawnAlong) if one == drawn), thickness,
        tuple(unread),
    )  # fmt: skip
    return _with_wide_doors(_from_degrees(plan) if unit is None else plan, widths)


def _with_wide_doors(plan: DrawnPlan, widths: Mapping[str, float]) -> DrawnPlan:
    """Returns a plan with openings that are drawn as points as wide as they say, m, along walls."""
    scale = plan.metres or 0.0
    doors = {
        one.where: along_walls(one, widths[one.where] / scale, plan.rooms) if scale else None
        for one in plan.openings
        if one.where in widths
    }
    lost = [Unread(where, "a door that is a point: `unit`, or a line along its wall") for where, one in doors.items() if one is None]
    openings = (doors.get(one.where, one) for one in plan.openings)
    return replace(plan, openings=tuple(one for one in openings if one), unread=(*plan.unread, *lost))


def _features(document: Mapping[str, Any], unread: list[Unread]) -> Iterator[tuple[Mapping[str, Any], Mapping[str, Any], str]]:
    """Yields what each feature says of itself, its geometry, its place; those of several geometries as often as they have."""
    features = [document] if document.get("type") == "Feature" else a_list(document.get("features"), "features")
    levels = levels_of(features)
    for number, feature in enumerate(features):
        where = f"features[{number}]"
        outer = an_object(feature, where)
        of_maps = {"feature_type": outer["feature_type"]} if "feature_type" in outer else {}
        own = an_object(outer.get("properties") or {}, f"{where}.properties")
        said = in_our_words({"id": outer.get("id"), **of_maps, **own}, levels)
        if "geometry" in outer and outer["geometry"] is None:
            unread.append(Unread(where, "it has no geometry"))
            continue
        shape = an_object(outer.get("geometry"), f"{where}.geometry")
        form = MANY.get(shape["type"]) if isinstance(shape.get("type"), str) else None
        if form is None:
            yield said, shape, where
            continue
        parts = a_list(shape.get("coordinates"), f"{where}.geometry.coordinates")
        check_count(f"{where}.geometry.coordinates", len(parts), MOST_POINTS)
        for at, part in enumerate(parts):
            own = {**said, "id": f"{said['id']}_{at}"} if at and isinstance(said.get("id"), str) else said
            yield own, {"type": form, "coordinates": part}, where


def _from_degrees(plan: DrawnPlan) -> DrawnPlan:
    """Returns a plan in metres that is drawn in degrees of longitude and latitude, as GeoJSON mostly is; any other as it is."""
    spots = [spot for room in plan.rooms for spot in room.points]
    if not spots or any(max(values) - min(values) > FEW_DEGREES for values in zip(*spots, strict=True)):
        return plan
    west, north = spots[0]
    angle, (across, along) = math.radians(north), A_DEGREE
    east, south = across[0] * math.cos(angle) + across[1] * math.cos(3 * angle), along[0] + along[1] * math.cos(2 * angle)

    def at(spot: Spot) -> Spot:
        return (spot[0] - west) * east, (spot[1] - north) * south

    return replace(
        plan,
        rooms=tuple(replace(one, points=tuple(map(at, one.points)), holes=tuple(tuple(map(at, hole)) for hole in one.holes))
 for one in plan.rooms),
        openings=tuple(replace(one, start=at(one.start), end=at(one.end)) for one in plan.openings),
        walls=tuple(replace(one, start=at(one.start), end=at(one.end)) for one in plan.walls),
        pieces=tuple(replace(one, x=spot[0], z=spot[1]) for one in plan.pieces for spot in (at((one.x, one.z)),)),
        metres=1.0, unit_words="the file is in degrees of longitude and latitude: no home is so small in any unit",
    )  # fmt: skip


def _rings(shape: Mapping[str, Any], form: str, up: bool, where: str) -> list[list[Spot]]:
    """Returns the points of a geometry; of a polygon those of its outline and of each hole."""
    place, given = f"{where}.geometry.coordinates", shape.get("coordinates")
    if form != "Polygon":
        return [_points(given, form, up, place)]
    rings = a_list(given, place)
    if not 1 <= len(rings) <= MOST_RINGS:
        raise FieldError(place, f"has {len(rings)} rings", f"1 to {MOST_RINGS}: an outline and its holes")
    return [_points(ring, form, up, f"{place}[{at}]") for at, ring in enumerate(rings)]


def _points(given: Any, form: str, up: bool, place: str) -> list[Spot]:
    listed = [given] if form == "Point" else a_list(given, place)
    check_count(place, len(listed), MOST_POINTS)
    found = [_point(point, up, f"{place}[{number}]") for number, point in enumerate(listed)]
    least = {"Polygon": 3, "LineString": 2, "Point": 1}[form]
    if len(found) < least:
        raise FieldError(place, f"has {len(found)} points", f"at least {least}")
    return found[:-1] if form == "Polygon" and found[0] == found[-1] else found


def _point(given: object, up: bool, where: str) -> Spot:
    pair = a_list(given, where)
    if len(pair) < 2:
        raise FieldError(where, f"has {len(pair)} numbers", "x and y")
    x, y = (a_number({"": value}, "", where) for value in pair[:2])
    return x, -y if up else y


def _level(said: Mapping[str, Any], where: str) -> int:
    return round(a_number(said, "level", where, 0.0))


def _room(said: Mapping[str, Any], points: list[Spot], where: str) -> DrawnRoom:
    return DrawnRoom(
        tuple(points), a_text(said, "name", where), where, a_text(said, "type", where), _level(said, where),
        bool(said["outdoor"]) if "outdoor" in said else None, a_text(said, "id", where),
    )  # fmt: skip


def _walls(said: Mapping[str, Any], lines: Sequence[Sequence[Spot]], thickness: float, where: str) -> Iterator[DrawnWall]:
    yield from (DrawnWall(a, b, thickness, _level(said, where)) for line in lines for a, b in pairwise(line))


def _opening(kind: str, said: Mapping[str, Any], points: Sequence[Spot], where: str) -> DrawnOpening:
    hinge = one_of(said, "hinge", ("", "start", "end"), where)
    return DrawnOpening(
        kind, points[0], points[-1], where, a_number(said, "height", where, None), a_number(said, "sill", where, None),  # type: ignore[arg-type]
        _level(said, where), hinge or None, None, bool(said["main_entrance"]) if "main_entrance" in said else None,  # type: ignore[arg-type]
        id=a_text(said, "id", where),
    )  # fmt: skip


def _piece(said: Mapping[str, Any], spot: Spot, where: str) -> DrawnPiece:
    sizes = [a_number(said, key, where, None) for key in ("width", "depth", "height")]
    size = None if None in sizes else (sizes[0] or 0.0, sizes[1] or 0.0, sizes[2] or 0.0)
    return DrawnPiece(
        a_text(said, "name", where), spot[0], spot[1], a_number(said, "elevation", where, 0.0),
        a_number(said, "rotation", where, 0.0), size,
        where, _level(said, where), id=a_text(said, "id", where),
    )  # fmt: skip
