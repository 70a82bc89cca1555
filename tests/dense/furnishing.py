"""One dense room, furnished as a house's rooms are and judged by what shares no code with that.

empty room -> space_of -> wanted_pieces -> place -> furnished -> a scene of one room -> validate, once from each door.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from pathlib import Path

from catalogs import Catalogs, load_catalogs
from solver.furnish import space_of, wanted_pieces
from solver.furnished import furnished
from solver.pieces import Arrangement, Piece, Space
from solver.placement import arrange, place
from solver.scene import Room, Scene
from solver.streams import Stream
from solver.validator import validate
from tests.dense.rooms import cover_wish, dense_room
from tests.oracles.paths import stand_and_walk
from tests.oracles.rules import faults, unreached

CATALOG = Path(__file__).parent / "catalog"
WALL_M = 0.1


@cache
def catalogs() -> Catalogs:
    """Our catalogs with the dense room types laid over them."""
    return load_catalogs(CATALOG)


@dataclass(frozen=True)
class Result:
    """A furnished room.

    `cover` is the floor covered by pieces that stand on it, where two overlap (a chair under its table) counted once, over the
    area between the wall lines. `walkable`: from either door the validator comes to everything, and so does a flood of its
    own to both doors and all use sides. `faults` are what the validator finds besides `unreachable` and warnings of blocked
    fronts. `left_out` counts what found no place, not what was one piece too many for the cover wished
    for. `cpu` counts place() alone, `compiled` the kernel's part of it.
    """

    name: str
    seed: int
    cover: float
    faults: tuple[str, ...]
    walkable: bool
    required: bool
    left_out: int
    pieces: int
    cpu: float
    compiled: float


def wishes(name: str, seed: int, tight: bool = False) -> tuple[Room, Space, tuple[Piece, ...]]:
    """Returns a seed's empty room, its space with the cover wished for, and what it wants."""
    room = dense_room(name, seed, tight)
    cover_mm2 = round(1e6 * room.width * room.depth * cover_wish(name, seed))
    space = replace(space_of(room, WALL_M), cover_mm2=cover_mm2)
    wanted = wanted_pieces(room, space, catalogs(), Stream(seed, "furnish", name))
    return room, space, tuple(piece for piece in wanted if not piece.is_floor)


def result(job: tuple[str, int]) -> Result:
    """Furnishes the room of a type and seed and judges it."""
    name, seed = job
    room, space, wanted = wishes(name, seed)
    start = time.process_time()
    (arrangement,) = place([(space, wanted)])
    cpu = time.process_time() - start
    start = time.process_time()
    arrange(space, wanted)
    compiled = time.process_time() - start
    done = furnished(room, arrangement, catalogs(), Stream(seed, "colour", name))
    rules = [issue.rule for door in _doors(done) for issue in validate(_scene(done, door), catalogs())]
    placed = {piece.label for piece in arrangement.placed}
    return Result(
        name, seed, covered(arrangement) / (room.width * room.depth),
        tuple(rule for rule in rules if rule not in ("unreachable", "missing_required", "front_blocked")),
        "unreachable" not in rules and not unreached(space, wanted, arrangement),
        "missing_required" not in rules and all(piece.label in placed for piece in wanted if piece.required),
        len(refused(space, wanted, arrangement)), len(placed), cpu, compiled,
    )  # fmt: skip


def refused(space: Space, wanted: tuple[Piece, ...], arrangement: Arrangement) -> list[str]:
    """Returns what found no place: what was left out before the last that stands, or all where less is covered than wished."""
    there = {placed.label for placed in arrangement.placed}
    stands = [piece.label in there for piece in wanted]
    full = covered(arrangement) * 1e6 >= space.cover_mm2 > 0
    tried = max((k for k, stand in enumerate(stands) if stand), default=-1) if full else len(stands)
    return [piece.label for piece, stand in zip(wanted[:tried], stands, strict=False) if not stand]


@dataclass(frozen=True)
class Spare:
    """A room's optional pieces that found no place: all, those that the oracle adds to what stands, those it cannot decide."""

    name: str
    refused: tuple[str, ...]
    possible: tuple[str, ...]
    undecided: tuple[str, ...]


def spare(job: tuple[str, int]) -> Spare:
    """Asks the oracle about every piece that found no place, each with all that stands, everything movable."""
    name, seed = job
    _, space, wanted = wishes(name, seed)
    (arrangement,) = place([(space, wanted)])
    there = {placed.label for placed in arrangement.placed}
    out = refused(space, wanted, arrangement)
    verdicts = {}
    for label in out:
        pieces = [piece for piece in wanted if piece.label in there or piece.label == label]
        verdicts[label] = stand_and_walk(space, pieces, seconds=10).verdict
    possible = tuple(label for label in out if verdicts[label])
    return Spare(name, tuple(out), possible, tuple(label for label in out if verdicts[label] is None))


def _doors(room: Room) -> list[str]:
    return [opening.id for opening in room.openings if opening.kind == "door"]


def _scene(room: Room, entrance: str) -> Scene:
    """Returns the house of this one room, entered through one of its doors."""
    openings = tuple(replace(opening, main_entrance=opening.id == entrance) for opening in room.openings)
    return Scene(seed=0, wall_thickness=WALL_M, rooms=(replace(room, openings=openings),))


def covered(arrangement: Arrangement) -> float:
    """Returns the floor that pieces standing on it cover, m2, no spot counted twice."""
    rects = [piece.footprint for piece in arrangement.placed if piece.chosen.bottom_mm == 0]
    xs = sorted({x for rect in rects for x in (rect.x0, rect.x1)})
    total = 0
    for low, high in pairwise(xs):
        end = -1
        for a, b in sorted((rect.z0, rect.z1) for rect in rects if rect.x0 <= low and high <= rect.x1):
            total += (high - low) * max(b - max(a, end), 0)
            end = max(end, b)
    return total / 1e6


@dataclass(frozen=True)
class Tight:
    """The required pieces of a tight room: do they all stand, walkable, by us and by the oracle (None: not closed)?"""

    name: str
    seed: int
    ours: bool
    oracle: bool | None
    how: str


def tight(job: tuple[str, int]) -> Tight:
    """Asks us and the oracle about the required pieces of a type's and seed's tight room."""
    name, seed = job
    _, space, wanted = wishes(name, seed, tight=True)
    required = tuple(piece for piece in wanted if piece.required)
    (arrangement,) = place([(space, required)])
    ours = not arrangement.left_out and not faults(space, required, arrangement) and not unreached(space, required, arrangement)
    answer = stand_and_walk(space, required)
    return Tight(name, seed, ours, answer.verdict, answer.how)
