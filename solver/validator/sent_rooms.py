"""Rooms and storeys as the core reads them (solver/core/validate/room.hpp and walk.hpp).

Comes in: a `World`, and what the catalogs say of kinds. Goes out: bytes for the core, and its answers. May import: scene, core.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from struct import Struct
from typing import Final

from solver.core import borrowed
from solver.scene import WALLS, Dynamic, Furniture
from solver.validator.kinds import NO_KIND, KindRows, Kinds
from solver.validator.lattice import ExactBox, WallEdge
from solver.validator.squares import squares, window_zone
from solver.validator.world import WAYS, AnyBody, Hole, PlacedRoom, World, turns_of

_ROOM: Final = Struct("<5q12i")
_BOX: Final = Struct("<4q")
_ZONE: Final = Struct("<6q")
_KIND: Final = Struct("<4i")
_BODY: Final = Struct("<6d40s6i")
_TURN: Final = Struct("<4d2i")
_STOREY: Final = Struct("<2q4i")
_PLACE: Final = Struct("<2q")
_WALL: Final = {wall: i for i, wall in enumerate(WALLS)}
_NO_SUCH_WALL: Final = 4
_ALONG, _CROSSWISE, _BETWEEN = 0, 1, 2
"""How a body is turned: its width along x, along z, or neither."""


def ask(name: str, content: bytes) -> bytes:
    """Asks the core what takes bytes and answers with bytes.

    Raises:
        CoreFailed: the bytes are no room or storey, or hold lengths beyond a million kilometres.
        CoreFull: it takes more memory than there is.
    """
    with borrowed() as core:
        told = core.call(name, core.write(content), len(content))
        return core.read(told & 0xFFFFFFFF, told >> 32)


def room_bytes(world: World, place: PlacedRoom, kinds: Kinds | None) -> bytes:
    """Returns a room as bytes; without kinds nothing is said of surfaces and shapes."""
    doors = [_zone(square.hole, square.box) for square in squares(world, place)]
    windows = [_zone(hole, window_zone(hole)) for hole in place.holes if hole.opening.kind == "window"]
    edges = [_edge(edge) for edge in place.edges]
    ways = [_edge(WallEdge(hole.edge.side, hole.edge.line, hole.start, hole.end)) for hole in place.holes if hole.opening.kind in WAYS]
    numbers: dict[str, int] = {}
    of_kinds = _KindTable(kinds)
    bodies = [_body(body, numbers, of_kinds) for body in place.bodies]
    outline = place.outline
    shell = (outline.inside, outline.missing, edges, ways, doors, windows)
    sizes = (*map(len, shell), *of_kinds.sizes, len(bodies), len(numbers), 0)
    head = _ROOM.pack(world.half_wall, *outline.bounds, *sizes)
    boxes = [_BOX.pack(*box) for box in (*outline.inside, *outline.missing)]
    return b"".join([head, *boxes, *edges, *ways, *doors, *windows, *of_kinds.rows, *bodies])


def storey_bytes(
    world: World, placed: Iterable[tuple[PlacedRoom, bytes]], bridges: Sequence[ExactBox], entrances: Sequence[ExactBox], most: int
) -> bytes:
    """Returns the rooms of a storey as bytes.

    Args:
        world: the house.
        placed: its rooms, each with its bytes.
        bridges: floor inside doorways between walls that lie apart.
        entrances: a step of floor along every door that one comes in by.
        most: how many boxes a tile of the floor holds before it is halved.
    """
    rooms = [_PLACE.pack(place.x, place.z) + rows for place, rows in placed]
    head = _STOREY.pack(world.half_wall, reach_of(world), len(rooms), len(bridges), len(entrances), most)
    return b"".join([head, *(_BOX.pack(*box) for box in (*bridges, *entrances)), *rooms])


def reach_of(world: World) -> int:
    """Returns how far the walking square reaches from its centre: half its side, less a step of the lattice."""
    return world.robot // 2 - 1


class _KindTable:
    """The kinds of a room's bodies, each once."""

    def __init__(self, kinds: Kinds | None) -> None:
        self._kinds = kinds
        self._found: dict[object, int] = {}
        self._rows: list[KindRows] = []

    def at(self, body: AnyBody) -> int:
        """Returns a body's kind by its place in the table."""
        key = Kinds.key(body) if self._kinds else None
        at = self._found.get(key)
        if at is None:
            at = self._found[key] = len(self._rows)
            self._rows.append(self._kinds.rows(key) if self._kinds and key else NO_KIND)
        return at

    @property
    def sizes(self) -> tuple[int, int, int]:
        """How many kinds, surfaces and parts there are."""
        return len(self._rows), sum(one.surfaces for one in self._rows), sum(one.parts for one in self._rows)

    @property
    def rows(self) -> Iterator[bytes]:
        """The kinds, their surfaces, their parts."""
        surfaces = parts = 0
        for one in self._rows:
            yield _KIND.pack(surfaces, one.surfaces, parts, one.parts)
            surfaces, parts = surfaces + one.surfaces, parts + one.parts
        yield from (one.surface_rows for one in self._rows)
        yield from (one.part_rows for one in self._rows)


def _zone(hole: Hole, box: ExactBox) -> bytes:
    return _ZONE.pack(*box, hole.sill, hole.top)


def _edge(edge: WallEdge) -> bytes:
    return _BOX.pack(_WALL[edge.side], edge.line, edge.start, edge.end)


def _body(body: AnyBody, numbers: dict[str, int], kinds: _KindTable) -> bytes:
    if isinstance(body, Furniture):
        sort, on, under, wall = 0, body.on, body.under, body.wall
    elif isinstance(body, Dynamic):
        sort, on, under, wall = 2, body.on, None, None
    else:
        sort, on, under, wall = 1, body.parent, None, body.mounted_on_wall
    return _BODY.pack(
        body.x, body.y, body.z, body.width, body.depth, body.height,
        _turn(body.rotation),
        sort,
        numbers.setdefault(body.id, len(numbers)),
        -1 if on is None else numbers.setdefault(on, len(numbers)),
        -1 if under is None else numbers.setdefault(under, len(numbers)),
        -1 if wall is None else _WALL.get(wall, _NO_SUCH_WALL),
        kinds.at(body),
    )  # fmt: skip


@lru_cache(maxsize=1024)
def _turn(rotation: float) -> bytes:
    """Returns how a body is turned: cosine and sine, exact at right angles, their sizes within one turn, how, and its quarter turns."""
    turns = turns_of(rotation)
    if rotation % 90 == 0:
        cosine, sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(rotation / 90) % 4]
        return _TURN.pack(cosine, sine, abs(cosine), abs(sine), _CROSSWISE if rotation % 180 == 90 else _ALONG, turns)
    angle, within = math.radians(rotation), math.radians(rotation % 360)
    return _TURN.pack(math.cos(angle), math.sin(angle), abs(math.cos(within)), abs(math.sin(within)), _BETWEEN, turns)
