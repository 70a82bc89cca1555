"""Rooms and storeys as the core reads them (solver/core/validate/room.hpp and walk.hpp): openings with what is fitted to them, bodies.

Doors are closed.
"""

import math
from collections import defaultdict
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import chain, count
from struct import Struct, pack
from typing import Final, NamedTuple

from solver.body_rows import BodyRows, DecorationRows, FurnitureRows, KindKey, rows_in
from solver.scene import EXTERIOR, WALL_NUMBERS, Opening, Room
from solver.validator.kinds import NO_KIND, SEATED, Kinds
from solver.validator.lattice import PER_METRE, ExactBox, WallEdge, metres
from solver.validator.world import Hole, PlacedRoom, World, turns_of
from solver.wall_fittings import Span, door_bars, leaf_bars, leaf_offset, window_bars

_OPENING: Final = Struct("<6q2d4i")
_BAR: Final = Struct("<6d")
_KINDS: Final = {"window": 0, "door": 1, "passage": 2, "garage_door": 3}
_NO_SUCH_KIND: Final = 4
_ANYWHERE, _OUTSIDE, _NOWHERE = -1, -2, -3
"""Where an opening leads, where not to a room of its storey."""
_KEEPS_FREE, _SAYS_HEIGHT = 1, 2


class SentOpenings(NamedTuple):
    """The openings on a room's walls: how many it lists, how many only others list, how many boxes are fitted to these; their rows."""

    own: int
    beyond: int
    fitted: int
    rows: bytes


def openings_on(world: World, place: PlacedRoom) -> list[Opening]:
    """Returns the openings on a room's walls, as the core numbers them: its own, and then those that only others list."""
    return [hole.opening for hole in (*place.holes, *(hole for _, hole in _beyond(world, place)))]


def sent_openings(world: World, place: PlacedRoom) -> SentOpenings:
    """Returns the openings on a room's walls."""
    told = list[tuple[bytes, bytes]]()
    thickness, said = 2 * metres(world.half_wall), Opening.height
    leading = {hole.opening.id: hole for _, hole in reversed(world.leading_to.get(place.room.id, ()))}
    for hole in place.holes:
        opening, leaf = hole.opening, hole
        if not opening.render_panel:  # of two entries that draws the leaf which says so
            other = leading.get(opening.id)
            leaf = other if other and other.opening.render_panel else hole
        flags = _KEEPS_FREE if opening.height == said else _KEEPS_FREE | _SAYS_HEIGHT
        told.append(_rows(hole, hole.edge, (_leads_to(world, place, opening.connects_to), flags), leaf, thickness))
    others = _beyond(world, place)
    listed = {opening.id for opening in place.room.openings} if others else ()
    for room, hole in others:
        flags = 0 if hole.opening.id in listed else _KEEPS_FREE
        told.append(_rows(hole, hole.edge.moved(room.x - place.x, room.z - place.z), (_ANYWHERE, flags), hole, thickness))
    fitted = b"".join([bars for _, bars in told])
    return SentOpenings(len(place.holes), len(others), len(fitted) // _BAR.size, b"".join([*(row for row, _ in told), fitted]))


def _rows(hole: Hole, edge: WallEdge, leads: tuple[int, int], leaf: Hole, thickness: float) -> tuple[bytes, bytes]:
    """Returns an opening's row, and those of what is fitted to it.

    Args:
        hole: the opening.
        edge: where it is in the room's frame.
        leads: where to, and its flags.
        leaf: the entry of it that says how its leaf turns.
        thickness: of walls, m.
    """
    (side, line, start, end), (to, flags), said, turning = edge, leads, hole.opening, leaf.opening
    low = hole.sill / PER_METRE if said.kind == "window" else 0.0
    inwards = 1 if leaf.edge.side in ("north", "west") else -1
    turns = turning.hinge, -inwards if turning.swing == "out" else inwards
    bars = _fitted(turning.kind, (end - start) / PER_METRE, (low, low + said.height), turns, thickness)
    place = WALL_NUMBERS[side], line, start, end, hole.sill, hole.top, low, low + said.height
    return _OPENING.pack(*place, _KINDS.get(said.kind, _NO_SUCH_KIND), to, len(bars) // _BAR.size, flags), bars


def _beyond(world: World, place: PlacedRoom) -> list[tuple[PlacedRoom, Hole]]:
    """Returns the openings on a room's walls that only other rooms list."""
    own = {hole.opening.id for hole in place.holes}
    leading = world.leading_to.get(place.room.id, ())
    return [(room, hole) for room, hole in leading if room is not place and hole.opening.id not in own]


def _leads_to(world: World, place: PlacedRoom, to: str | None) -> int:
    """Returns where an opening says that it leads to. A room that was sent alone may speak of rooms that were not."""
    if to is None or len(world.places) == 1:
        return _ANYWHERE
    if to == EXTERIOR:
        return _OUTSIDE
    level, number = world.numbers.get(to, (place.room.level, _NOWHERE))
    return number if level == place.room.level else _ANYWHERE


@lru_cache(maxsize=256)
def _fitted(kind: str, width: float, up: Span, turns: tuple[str | None, int], thickness: float) -> bytes:
    """Returns what is fitted to an opening that begins at 0, m, its leaf closed, as the core reads it.

    `turns` says at which end its leaf hangs, and whether it turns across the wall to where x or z grow, +1, or -1.
    """
    along, head = (0.0, width), up[1]
    if kind == "window":
        bars = window_bars(along, up, thickness)
    elif kind == "passage":
        bars = []
    else:
        hinge = ("end" if turns[0] == "end" else "start") if kind == "door" else None
        middle = turns[1] * leaf_offset(thickness) if kind == "door" else 0.0
        bars = [*door_bars(along, head, thickness), *leaf_bars(along, head, middle, hinge)]
    return b"".join([_BAR.pack(*bar.along, *bar.up, *bar.across) for bar in bars])


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


class NumberedKinds(defaultdict[KindKey, int]):
    """The kinds of a house's bodies, each once, by what they are looked up by; one that is not there yet is added.

    Without kinds nothing is said of surfaces, shapes and use.
    """

    def __init__(self, kinds: Kinds | None) -> None:
        super().__init__(count().__next__)
        self._kinds = kinds

    @property
    def kinds(self) -> Kinds:
        """What the catalogs say."""
        assert self._kinds is not None
        return self._kinds

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
    reach = world.robot // 2 - 1  # of the walking square from its centre: half its side, less a step of the lattice
    head = _STOREY.pack(world.half_wall, reach, deepest, *counts)
    return b"".join([head, *(_BOX.pack(*box) for box in entrances), turns, *kinds.sent(), *rooms])


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
