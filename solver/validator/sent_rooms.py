"""Rooms and storeys as the core reads them (solver/core/validate/room.hpp and walk.hpp)."""

import math
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import chain, count
from struct import Struct, pack
from typing import Final, NamedTuple

from solver.body_rows import BodyRows, DecorationRows, FurnitureRows, KindKey, rows_in
from solver.scene import WALL_NUMBERS, Room
from solver.validator.kinds import NO_KIND, SEATED, Kinds
from solver.validator.lattice import ExactBox
from solver.validator.sent_openings import sent_openings
from solver.validator.world import PlacedRoom, World, turns_of

_ROOM: Final = Struct("<5q12i")
_AS_ROWS: Final = slice(13, 15)
"""Where a room says how much furniture and how many small things are told as rows."""
_BOX: Final = Struct("<4q")
_BODY: Final = Struct("<6d40s6i")
_TURN: Final = Struct("<4d2i")
_STOREY: Final = Struct("<3q6i")
_PLACE: Final = Struct("<2q")
_NO_SUCH_WALL: Final = 4
_FURNITURE, _DECORATION, _PERSON = 0, 1, 2
_ALONG, _CROSSWISE, _BETWEEN = 0, 1, 2
"""How a body is turned: its width along x, along z, or neither."""


class Floors(NamedTuple):
    """What is said of a storey's floor besides its rooms.

    `entrances` are a step of floor along every door that one comes in by; a tile of the floor holds `most` boxes before it is halved.
    `deepest_wall`: as far two rooms' wall lines may lie apart at an opening.
    """

    entrances: Sequence[ExactBox]
    most: int
    deepest_wall: int


class NumberedKinds(dict[KindKey, int]):
    """The kinds of a house's bodies, each once, by what they are looked up by; one that is not there yet is added.

    Without kinds nothing is said of surfaces, shapes and use.
    """

    def __init__(self, kinds: Kinds | None) -> None:
        super().__init__()
        self._kinds = kinds

    @property
    def kinds(self) -> Kinds:
        """What the catalogs say."""
        assert self._kinds is not None
        return self._kinds

    def __missing__(self, key: KindKey) -> int:
        at = self[key] = len(self)
        return at

    def sent(self) -> Iterable[bytes]:
        """Returns the kinds."""
        return map(self._kinds.rows.__getitem__, self) if self._kinds else [NO_KIND] * len(self)


def room_bytes(world: World, place: PlacedRoom, kinds: NumberedKinds) -> bytes:
    """Returns a room as bytes."""
    edges, openings, bodies, outline = place.edges, sent_openings(world, place), _bodies(place, kinds), place.outline
    sizes = len(outline.inside), len(outline.missing), len(edges), *openings[:3], len(bodies.told), bodies.names, *bodies.counts
    head = _ROOM.pack(*outline.bounds, place.ceiling, *sizes, place.room.outdoor)
    boxes = [_BOX.pack(*box) for box in (*outline.inside, *outline.missing)]
    lines = [_BOX.pack(WALL_NUMBERS[side], line, start, end) for side, line, start, end in edges]
    return b"".join([head, *boxes, *lines, openings.rows, *bodies.told, *bodies.rows])


def storey_bytes(world: World, placed: Sequence[tuple[PlacedRoom, bytes]], kinds: NumberedKinds, floors: Floors) -> bytes:
    """Returns the rooms of a storey as bytes."""
    rooms = chain.from_iterable([(_PLACE.pack(place.x, place.z), rows) for place, rows in placed])
    entrances, most, deepest = floors
    turns = _TURNS if any(any(_ROOM.unpack_from(rows)[_AS_ROWS]) for _, rows in placed) else b""
    counts = len(placed), len(entrances), len(turns) // _TURN.size, most, len(kinds), 0
    head = _STOREY.pack(world.half_wall, reach_of(world), deepest, *counts)
    return b"".join([head, *(_BOX.pack(*box) for box in entrances), turns, *kinds.sent(), *rooms])


def reach_of(world: World) -> int:
    """Returns how far the walking square reaches from its centre: half its side, less a step of the lattice."""
    return world.robot // 2 - 1


class _SentBodies(NamedTuple):
    """A room's bodies: those told one by one; how many ids there are; those told as rows.

    `counts`: how much furniture and how many small things are told as rows, and where the ids of the latter begin.
    """

    told: list[bytes]
    names: int
    rows: list[bytes]
    counts: tuple[int, int, int]


def _bodies(place: PlacedRoom, kinds: NumberedKinds) -> _SentBodies:
    """Returns furniture, small things and people."""
    room, none, pack = place.room, -1, _BODY.pack
    pieces, things = rows_in(room, FurnitureRows), rows_in(room, DecorationRows)
    names = _NumberedIds(room)
    told = []
    for piece, key in zip(room.furniture, place.keys, strict=True) if pieces is None else ():
        place_of = piece.x, piece.y, piece.z, piece.width, piece.depth, piece.height, _turn(piece.rotation)
        ids = names[piece.id], names[piece.on], names[piece.under]
        told.append(pack(*place_of, _FURNITURE, *ids, WALL_NUMBERS.get(piece.wall, _NO_SUCH_WALL), kinds[key]))
    names.add(pieces)
    first = names.count
    names.add(things)
    for thing in room.decorations if things is None else ():
        width, depth, height = thing.width, thing.depth, thing.height
        kind = kinds["decoration", thing.name, width, depth, height, thing.kind]
        place_of = thing.x, thing.y, thing.z, width, depth, height, _turn(thing.rotation)
        ids = names[thing.id], names[thing.parent], none
        told.append(pack(*place_of, _DECORATION, *ids, WALL_NUMBERS.get(thing.mounted_on_wall, _NO_SUCH_WALL), kind))
    for person in place.people:
        kind = kinds["person", person.kind, 0.0, 0.0, 0.0, None if person.on is None else SEATED]
        place_of = person.x, person.y, person.z, person.width, person.depth, person.height, _turn(person.rotation)
        told.append(pack(*place_of, _PERSON, names[person.id], names[person.on], none, none, kind))
    as_rows = [rows for rows in (pieces, things) if rows is not None]
    counts = 0 if pieces is None else len(pieces), 0 if things is None else len(things), first
    return _SentBodies(told, names.count, [part for rows in as_rows for part in _as_told(rows, kinds)], counts)


class _NumberedIds(dict[str | None, int]):
    """The ids of a room's bodies as numbers, equal ones alike, nobody's -1. Those of rows are made where one comes that may be of them."""

    def __init__(self, room: Room) -> None:
        self[None] = -1
        self.count, self._room, self._as_rows = 0, room, list[tuple[int, BodyRows]]()

    def add(self, rows: BodyRows | None) -> None:
        """Numbers the ids of bodies that are told as rows, if any."""
        if rows is not None:
            self._as_rows.append((self.count, rows))
            self.count += len(rows)

    def __missing__(self, name: str | None) -> int:
        while self._as_rows and str(name).startswith(f"{self._room.id}/"):
            first, rows = self._as_rows.pop(0)
            self.update(zip(rows.ids, count(first)))
        if name not in self:
            self[name] = self.count
            self.count += 1
        return self[name]


def _as_told(bodies: BodyRows, kinds: NumberedKinds) -> tuple[bytes, bytes]:
    """Returns bodies that are told as rows already, and behind them the number of each one's kind."""
    return bodies.content, pack(f"<{len(bodies)}q", *map(kinds.__getitem__, bodies.looks))


@lru_cache(maxsize=1024)
def _turn(rotation: float) -> bytes:
    """Returns how a body is turned: cosine and sine, exact at right angles, their sizes within one turn, how, and its quarter turns."""
    turns = turns_of(rotation)
    if rotation % 90 == 0:
        cosine, sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(rotation / 90) % 4]
        return _TURN.pack(cosine, sine, abs(cosine), abs(sine), _CROSSWISE if rotation % 180 == 90 else _ALONG, turns)
    angle, within = math.radians(rotation), math.radians(rotation % 360)
    return _TURN.pack(math.cos(angle), math.sin(angle), abs(math.cos(within)), abs(math.sin(within)), _BETWEEN, turns)


_TURNS: Final = b"".join(map(_turn, range(360)))
"""How what is told as rows is turned, by degrees."""
