"""A home as rows of tables, for those who train on many: rooms, pieces, what things can stand on, doors, fronts, the graph of rooms.

service/dataset/shards.py says what the rows hold, in the same order. Poses are in the house: x east, y up, z south, m; turns in
degrees about +y, 0 facing south. Things can stand on surfaces, on boards inside and on the bottoms of drawers.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any, Final, NamedTuple

from catalogs import Catalogs
from catalogs.insides import insides_of
from catalogs.kind_book import UPRIGHT, KindBook
from solver.body_rows import BODY_WALLS, DecorationRows, FurnitureRows, Look, count_decorations, count_furniture, rows_in
from solver.exports.kind_facts import KindFacts, book_of, decoration_facts, furniture_facts, living_facts
from solver.exports.model import PlacedOpening
from solver.exports.wall_bands import RoomFinder, WallBands, openings_of
from solver.geometry import turned_by
from solver.scene import EXTERIOR, Decoration, Dynamic, Furniture, Room, Scene
from solver.scene_bodies import storey_levels

Row = tuple[Any, ...]
WALL: Final = "wall"
"""The edge of two rooms that share a wall and no door."""
_OPEN: Final = (1.0, None)


def rows_of(scene: Scene, catalogs: Catalogs) -> dict[str, list[Row]]:
    """Returns a generated home's rows by table: rooms, pieces, receptacles, doors, graph, fronts; each begins with the home's seed."""
    certificate: Mapping[str, Any] = scene.certificate or {}
    reports: Mapping[str, Mapping[str, Any]] = certificate.get("rooms", {})
    openings = openings_of(scene.rooms, WallBands(scene.rooms, scene.wall_thickness), RoomFinder(scene.rooms))
    book = book_of(catalogs)
    pieces = list(_pieces(scene, book))
    return {
        "rooms": [_room(scene.seed, room, reports.get(room.id, {})) for room in scene.rooms],
        "pieces": pieces,
        "receptacles": [row for piece in pieces for row in _receptacles(piece, book)],
        "doors": [_door(scene.seed, one) for one in openings],
        "graph": list(_graph(scene, openings)),
        "fronts": [row for report in reports.values() for row in _fronts(scene.seed, report.get("fronts", {}))],
    }


def _room(seed: int | None, room: Room, report: Mapping[str, Any]) -> Row:
    corners = [[round(room.x + x, 6), round(room.z + z, 6)] for x, z in room.corners]
    where = room.x, room.z, room.width, room.depth, round(room.floor_m2, 4), corners, room.flooring.type if room.flooring else None
    counts = count_furniture(room), count_decorations(room)
    proof = report.get("cost"), report.get("proven"), report.get("best"), [entry["piece"] for entry in report.get("left_out", ())]
    return seed, room.id, room.index, room.type, room.level, room.outdoor, *where, *counts, *proof


def _pieces(scene: Scene, book: KindBook) -> Iterator[Row]:
    levels = storey_levels(scene)
    frames = {room.id: (scene.seed, room, levels[room.level].elevation) for room in scene.rooms}
    for frame in frames.values():
        room = frame[1]
        pieces, things = rows_in(room, FurnitureRows), rows_in(room, DecorationRows)
        origin = [round(2000 * edge) for edge in (room.x, frame[2], room.z)]
        if [edge / 2000 for edge in origin] != [room.x, frame[2], room.z]:
            pieces = things = None
        for piece in room.furniture if pieces is None else ():
            key = book.kind_of("furniture", piece.name, (piece.width, piece.depth, piece.height), piece.kind)
            facts, carried = furniture_facts(book, piece.name, key, piece.category), (piece.on, piece.under, piece.wall)
            yield _body(frame, piece, "furniture", facts, carried)
        if pieces is not None:
            ids = (*pieces.ids, None)
            yield from _told(frame, pieces, book, origin, [(ids[row[1]], ids[row[2]]) for row in pieces.rows])
        for thing in room.decorations if things is None else ():
            key = book.kind_of("decoration", thing.name, (thing.width, thing.depth, thing.height), thing.kind)
            facts = decoration_facts(book, thing.name, key)
            yield _body(frame, thing, "decoration", facts, (thing.parent, None, thing.mounted_on_wall))
        if things is not None:
            yield from _told(frame, things, book, origin, [(parent, None) for parent in things.parents])
    for one in scene.dynamic:
        if one.room in frames:
            facts = living_facts(book, one.kind, one.on is not None)
            yield _body(frames[one.room], one, "dynamic", facts, (one.on, None, None))


_Frame = tuple[int | None, Room, float]
"""A home's seed, a room, and how high its floor is, m."""
_Carriers = tuple[str | None, str | None]
"""What carries a body, what it is under."""
_Carried = tuple[str | None, str | None, str | None]
"""What carries a body, what it is under, the wall it is at."""


def _body(frame: _Frame, body: Furniture | Decoration | Dynamic, sort: str, facts: KindFacts, carried: _Carried) -> Row:
    seed, room, above = frame
    size = width, depth, height = body.width, body.depth, body.height
    sits = isinstance(body, Dynamic) and body.on is not None
    mass = round(facts.mass * (1.0 if sits else width * depth * height / facts.volume), 4)
    named = body.id, room.id, sort, body.kind if isinstance(body, Dynamic) else body.name, facts.key, facts.category
    place = round(room.x + body.x, 6), round(above + body.y, 6), round(room.z + body.z, 6), float(body.rotation)
    return seed, *named, *place, *size, mass, body.color, *carried


def _told(
    frame: _Frame, bodies: FurnitureRows | DecorationRows, book: KindBook, origin: Sequence[int], carried: Sequence[_Carriers]
) -> Iterator[Row]:
    """Yields the rows of bodies that are told as rows, in a room that begins at half millimetres: no sum need be rounded."""
    (seed, room, _), (west, floor, north) = frame, origin
    name = room.id
    told = zip(bodies.ids, bodies.looks, carried, bodies.colours, bodies.rows, strict=True)
    for label, look, carriers, color, (_, _, _, wall, rotation, _, _, _, x0, z0, x1, z1, low, *_) in told:
        of_look, size, mass = _facts_of_look(book, look)
        place = (west + x0 + x1) / 2000, (floor + 2 * low) / 2000, (north + z0 + z1) / 2000, float(rotation)
        yield (seed, label, name, *of_look, *place, *size, mass, color, *carriers, BODY_WALLS[wall])


@lru_cache(maxsize=1 << 13)
def _facts_of_look(book: KindBook, look: Look) -> tuple[tuple[str, str, str | None, str], tuple[float, float, float], float]:
    """Returns of bodies that look alike their sort, name, and the key and category of their kind; their size and mass."""
    sort = look.key[0]
    key = book.kind_of(sort, look.name, look.size, look.kind)
    facts = furniture_facts(book, look.name, key, look.category) if sort == "furniture" else decoration_facts(book, look.name, key)
    width, depth, height = look.size
    return (sort, look.name, facts.key, facts.category), look.size, round(facts.mass * (width * depth * height / facts.volume), 4)


def _receptacles(piece: Row, book: KindBook) -> Iterator[Row]:
    """Yields what a piece carries things on, numbered from 1, where it is in the house."""
    seed, name, room, sort, _, key, _, x, y, z, turn, *size = piece[:14]
    for number, one in enumerate(receptacles_of(book, sort, key, tuple(size)), 1):
        east, south = turned_by(one.x, one.z, turn)
        place = round(x + east, 6), round(y + one.height, 6), round(z + south, 6), turn
        yield seed, f"{name}#{number}", name, room, one.surface, one.front, *place, one.width, one.depth, one.clearance


def _door(seed: int | None, one: PlacedOpening) -> Row:
    """Returns a door, garage door, passage or window; of its rooms the first lies towards greater coordinates."""
    middle = round((one.start + one.end) / 2, 6)
    x, z = (middle, one.line) if one.axis == "x" else (one.line, middle)
    extent = round(one.end - one.start, 6), one.sill, one.head
    hung = (one.hinge, "room_a" if one.towards == 1 else "room_b") if one.kind == "door" else (None, None)
    return seed, one.id, one.kind, one.level, one.axis, x, z, *extent, *one.rooms, *hung, one.is_main_entrance


def _graph(scene: Scene, openings: Sequence[PlacedOpening]) -> Iterator[Row]:
    """Yields an edge for each two rooms that share a wall, and for each door that leads outside."""
    joined: dict[frozenset[str | None], PlacedOpening] = {}
    for one in openings:
        if one.kind != "window":
            joined.setdefault(frozenset(one.rooms), one)
    names = {room.index: room.id for room in scene.rooms}
    for a, b in scene.adjacency:
        through = joined.pop(frozenset((names[a], names[b])), None)
        yield scene.seed, names[a], names[b], *((through.kind, through.id) if through else (WALL, None))
    for one in joined.values():
        a_id, b_id = one.rooms
        yield scene.seed, a_id or EXTERIOR, b_id or EXTERIOR, one.kind, one.id


def _fronts(seed: int | None, fronts: Mapping[str, Mapping[str, Any]]) -> Iterator[Row]:
    """Yields each front with the share of its way that it opens, and what it meets then."""
    for piece, ways in fronts.items():
        for front, said in ways.items():
            yield seed, piece, front, *((float(said["opens"]), said["meets"]) if isinstance(said, Mapping) else _OPEN)


class Receptacle(NamedTuple):
    """A rectangle that things can stand on.

    `surface` is what the kind calls it; inside a body `shelves` or `drawers`, of these with the `front` that it moves with. Its middle
    is `x` to the right and `z` to the front of the body's, `height` above the underside; `clearance` is free over it (None: open), m.
    """

    surface: str
    front: str | None
    x: float
    z: float
    height: float
    width: float
    depth: float
    clearance: float | None


@lru_cache(maxsize=1 << 12)
def receptacles_of(book: KindBook, sort: str, key: str | None, size: tuple[float, float, float]) -> tuple[Receptacle, ...]:
    """Returns what a body carries things on, its surfaces as the catalogs list them, then what is inside.

    Nothing stands on people and pets, nor on what is tipped or of no kind. What is inside is known of bodies as large as their kind.
    """
    return () if key is None or sort == "dynamic" or key.endswith(UPRIGHT) else tuple(_found(book, sort, key, size))


def _found(book: KindBook, sort: str, key: str, size: tuple[float, float, float]) -> Iterator[Receptacle]:
    kind, (width, depth, height) = book.spec(sort, key), size
    for one in kind.surfaces:
        sides = width - 2 * one.inset, depth - 2 * one.inset
        if min(sides) > 0:
            yield _rounded(one.name, None, 0.0, 0.0, one.height * height / kind.size[2], *sides, one.clearance)
    for inside in insides_of(book.solids(key), size) if sort == "furniture" and size == kind.size else ():
        (x0, x1), (z0, z1) = inside.x, inside.z
        middle = (x0 + x1) / 2, (z0 + z1) / 2
        yield _rounded(inside.sort, inside.drawer, *middle, inside.height, x1 - x0, z1 - z0, inside.clearance)


def _rounded(surface: str, front: str | None, *lengths: float | None) -> Receptacle:
    return Receptacle(surface, front, *[None if length is None else round(length, 6) for length in lengths])  # type: ignore[arg-type]
