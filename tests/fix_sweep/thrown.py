"""Generated homes with pieces thrown about in one room: what was valid a moment ago is still possible.

Comes in: a way to throw, a preset, a seed. Goes out: the home, and the same with some pieces of one room at random poses.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

from solver import Request, Scene, generate
from solver.scene import Furniture, Room
from solver.streams import Stream

PRESETS: Mapping[str, dict[str, str]] = {
    "plain": {},
    "studio": {"program": "studio"},
    "one_bed": {"program": "one_bed"},
    "family": {"program": "family"},
    "large": {"program": "large"},
}
SHARE = 0.3
WAYS = ("1", "3", "30 %", "30 %, one locked")
"""How many pieces are thrown; with one locked, a piece that was not thrown stays where it is."""
LEAST = 2
"""Pieces that a room must have to be chosen."""


@dataclass(frozen=True)
class Thrown:
    """A home with pieces thrown about.

    Args:
        home: as it was, valid.
        scene: the same with pieces at random poses.
        room: the id of their room.
        ids: of the pieces thrown.
        locked: ids of those that must stay; they stand where they stood.
    """

    home: Scene
    scene: Scene
    room: str
    ids: tuple[str, ...]
    locked: tuple[str, ...]


def thrown(way: str, preset: str, seed: int, turn: bool = False) -> Thrown:
    """Throws pieces of one room of a home about: anywhere in it, and where asked for turned; what stands on them stays behind."""
    home = _home(preset, seed)
    stream = Stream(seed, f"thrown {way}", preset)
    room = stream.pick([room for room in home.rooms if len(room.furniture) >= LEAST])
    count = {"1": 1, "3": 3}.get(way, max(1, round(SHARE * len(room.furniture))))
    order = [piece.id for piece in room.furniture]
    stream.shuffle(order)
    ids = order[: min(count, len(order) - 1)]
    held = {label for piece in room.furniture if piece.id in ids for label in (piece.id, piece.on, piece.under)}
    free = [p.id for p in room.furniture if p.id not in held and p.on is None and p.under is None]
    locked = (stream.pick(free),) if way.endswith("locked") and free else ()
    furniture = tuple(_anywhere(piece, room, stream, turn) if piece.id in ids else piece for piece in room.furniture)
    rooms = tuple(replace(room, furniture=furniture) if one is room else one for one in home.rooms)
    return Thrown(home, replace(home, rooms=rooms), room.id, tuple(ids), locked)


@lru_cache(maxsize=64)  # each is thrown in several ways, and repaired in two
def _home(preset: str, seed: int) -> Scene:
    return generate(Request(seed=seed, **PRESETS[preset])).scene  # type: ignore[arg-type]


def _anywhere(piece: Furniture, room: Room, stream: Stream, turn: bool) -> Furniture:
    rotation = 90 * stream.below(4) if turn else piece.rotation
    wide, deep = (piece.depth, piece.width) if rotation % 180 else (piece.width, piece.depth)
    x, z = (_between(extent, length, stream.unit()) for extent, length in ((wide, room.width), (deep, room.depth)))
    return replace(piece, x=x, z=z, rotation=rotation)


def _between(extent: float, length: float, share: float) -> float:
    """Returns a centre at which an extent lies within the walls; their middle where it is longer."""
    return round(extent / 2 + max(length - extent, 0.0) * share if extent < length else length / 2, 3)
