"""A home as rows of tables: its rooms, pieces, doors, fronts and the graph of its rooms, for those who train on many homes.

Comes in: a generated scene, catalogs. Goes out: rows of plain values by table; service/dataset/table_schemas.py says their types.
May import: the ground floor, catalogs.

Poses are in the house: x east, y up, z south, m; turns in degrees about +y, 0 facing south.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

from catalogs import Catalogs
from catalogs.kind_book import KindBook
from solver.exports.kind_facts import KindFacts, book_of, decoration_facts, furniture_facts, living_facts
from solver.exports.wall_bands import WallBands
from solver.exports.wall_edges import corners_of
from solver.exports.wall_lines import RoomFinder, openings_of
from solver.scene import EXTERIOR, Decoration, Dynamic, Furniture, Room, Scene

Row = dict[str, Any]
WALL: Final = "wall"
"""The edge of two rooms that share a wall and no door."""


def rows_of(scene: Scene, catalogs: Catalogs) -> dict[str, list[Row]]:
    """Returns a home's rows by table: rooms, pieces, doors, graph, fronts; each begins with the home's seed.

    Args:
        scene: generated, with its certificate.
        catalogs: what kinds weigh.
    """
    certificate: Mapping[str, Any] = scene.certificate or {}
    reports: Mapping[str, Mapping[str, Any]] = certificate.get("rooms", {})
    doors = list(_doors(scene))
    tables = {
        "rooms": [_room(room, reports.get(room.id, {})) for room in scene.rooms],
        "pieces": list(_pieces(scene, book_of(catalogs))),
        "doors": doors,
        "graph": list(_graph(scene, doors)),
        "fronts": [row for report in reports.values() for row in _fronts(report.get("fronts", {}))],
    }
    return {name: [{"seed": scene.seed, **row} for row in rows] for name, rows in tables.items()}


def _room(room: Room, report: Mapping[str, Any]) -> Row:
    corners = [[round(room.x + x, 6), round(room.z + z, 6)] for x, z in corners_of(room)]
    return {
        "id": room.id,
        "index": room.index,
        "type": room.type,
        "level": room.level,
        "outdoor": room.outdoor,
        "x": room.x,
        "z": room.z,
        "width": room.width,
        "depth": room.depth,
        "area": round(room.floor_m2, 4),
        "polygon": corners,
        "flooring": room.flooring.type if room.flooring else None,
        "furniture": len(room.furniture),
        "decorations": len(room.decorations),
        "cost": report.get("cost"),
        "proven": report.get("proven"),
        "best": report.get("best"),
        "left_out": [entry["piece"] for entry in report.get("left_out", ())],
    }


def _pieces(scene: Scene, book: KindBook) -> Iterator[Row]:
    elevations = {level.index: level.elevation for level in scene.levels}
    for room in scene.rooms:
        above = elevations.get(room.level, 0.0)
        for piece in room.furniture:
            key = book.kind_of("furniture", piece.name, (piece.width, piece.depth, piece.height), piece.kind)
            yield _body(piece, room, above, furniture_facts(book, piece.name, key, piece.category))
        for thing in room.decorations:
            key = book.kind_of("decoration", thing.name, (thing.width, thing.depth, thing.height), thing.kind)
            yield _body(thing, room, above, decoration_facts(book, thing.name, key))
    rooms = {room.id: room for room in scene.rooms}
    for one in scene.dynamic:
        if one.room in rooms:
            room = rooms[one.room]
            yield _body(one, room, elevations.get(room.level, 0.0), living_facts(book, one.kind, one.on is not None))


def _body(body: Furniture | Decoration | Dynamic, room: Room, above: float, facts: KindFacts) -> Row:
    sort = {Furniture: "furniture", Decoration: "decoration", Dynamic: "dynamic"}[type(body)]
    size = (body.width, body.depth, body.height)
    share = size[0] * size[1] * size[2] / facts.volume
    sits = isinstance(body, Dynamic) and body.on is not None
    return {
        "id": body.id,
        "room": room.id,
        "sort": sort,
        "name": body.kind if isinstance(body, Dynamic) else body.name,
        "kind": facts.key,
        "category": facts.category,
        "x": round(room.x + body.x, 6),
        "y": round(above + body.y, 6),
        "z": round(room.z + body.z, 6),
        "turn": float(body.rotation),
        "width": size[0],
        "depth": size[1],
        "height": size[2],
        "mass": round(facts.mass * (1.0 if sits else share), 4),
        "color": body.color,
        "parent": body.parent if isinstance(body, Decoration) else body.on,
        "under": body.under if isinstance(body, Furniture) else None,
        "wall": body.wall if isinstance(body, Furniture) else getattr(body, "mounted_on_wall", None),
    }


def _doors(scene: Scene) -> Iterator[Row]:
    """Yields doors, garage doors, passages and windows, each once; `room_a` lies towards greater coordinates."""
    for one in openings_of(scene.rooms, WallBands(scene.rooms, scene.wall_thickness), RoomFinder(scene.rooms)):
        middle = round((one.start + one.end) / 2, 6)
        x, z = (middle, one.line) if one.axis == "x" else (one.line, middle)
        yield {
            "id": one.id,
            "kind": one.kind,
            "level": one.level,
            "axis": one.axis,
            "x": x,
            "z": z,
            "width": round(one.end - one.start, 6),
            "sill": one.sill,
            "head": one.head,
            "room_a": one.rooms[0],
            "room_b": one.rooms[1],
            "main_entrance": one.is_main_entrance,
        }


def _graph(scene: Scene, doors: list[Row]) -> Iterator[Row]:
    """Yields an edge for each two rooms that share a wall, and for each door that leads outside."""
    joined: dict[frozenset[str | None], Row] = {}
    for door in doors:
        if door["kind"] != "window":
            joined.setdefault(frozenset((door["room_a"], door["room_b"])), door)
    names = {room.index: room.id for room in scene.rooms}
    for a, b in scene.adjacency:
        through = joined.pop(frozenset((names[a], names[b])), None)
        kind, name = (through["kind"], through["id"]) if through else (WALL, None)
        yield {"a": names[a], "b": names[b], "edge": kind, "door": name}
    for door in joined.values():
        yield {"a": door["room_a"] or EXTERIOR, "b": door["room_b"] or EXTERIOR, "edge": door["kind"], "door": door["id"]}


def _fronts(fronts: Mapping[str, Mapping[str, Any]]) -> Iterator[Row]:
    """Yields each front with the share of its way that it opens, and what it meets then."""
    for piece, ways in fronts.items():
        for front, said in ways.items():
            opens, meets = (said["opens"], said["meets"]) if isinstance(said, Mapping) else (said, None)
            yield {"piece": piece, "front": front, "opens": float(opens), "meets": meets}
