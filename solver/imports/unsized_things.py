"""Things whose size a file does not say get that of their kind: they stand, hang or lie where their middles tell."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final, NamedTuple

from catalogs import Catalogs
from catalogs.entries import KindSpec
from catalogs.insides import InsideSurface, insides_of
from catalogs.synonyms import Meaning, Synonyms, synonyms_of
from solver.geometry import extents, rotate
from solver.imports.drawn import DrawnPiece, Spot

APART: Final = 0.005
"""Things on one surface are so far apart, m."""
CROWDED: Final = 8
"""On a surface with so many things the next lies where it is drawn."""
LEAST_RISE: Final = 0.3
"""What begins no higher over the floor, m, by its middle and a size that is not its own, stands on it."""


class _Taken(NamedTuple):
    """Where a thing lies on a surface, and how far it reaches along x and z, m."""

    spot: Spot
    reach: Spot


class _Carrier(NamedTuple):
    """What things lie on: as it is taken to be, what carries them, how high it is as the file has it, m, and what lies there."""

    body: DrawnPiece
    levels: tuple[InsideSurface, ...]
    drawn_height: float
    taken: dict[InsideSurface, list[_Taken]]


def with_usual_sizes(pieces: Sequence[DrawnPiece], catalogs: Catalogs) -> Iterator[DrawnPiece]:
    """Yields things of which those without a size have their kind's, where their names tell a kind."""
    names, carriers = synonyms_of(catalogs), dict[str, _Carrier]()
    for piece in pieces:
        meaning = _meaning(piece, names) if piece.size is None else None
        if meaning is None or meaning.sort == "other":
            yield piece
            continue
        known = catalogs.furniture if meaning.sort == "furniture" else catalogs.decorations
        spec: KindSpec = known[meaning.key]
        body = _settled(replace(piece, size=spec.size, usual=True, decoration=meaning.sort == "decoration"), carriers.get(piece.on))
        if not piece.on and piece.middle is not None:
            carriers[piece.where] = _Carrier(body, tuple(_levels(meaning.key, spec, catalogs)), 2 * piece.middle, {})
        yield body


def _meaning(piece: DrawnPiece, names: Synonyms) -> Meaning | None:
    """Returns what a thing is: by its name and height where both agree, else its name alone."""
    return (piece.height and names.meaning(piece.name, piece.height)) or names.meaning(piece.name, None)


def _levels(key: str, spec: KindSpec, catalogs: Catalogs) -> Iterator[InsideSurface]:
    """Yields what carries things on a body of a kind and in it, but for drawers."""
    width, depth, _ = spec.size
    for one in spec.surfaces:
        across, along = width / 2 - one.inset, depth / 2 - one.inset
        yield InsideSurface("shelves", (-across, across), (-along, along), one.height, one.clearance or float("inf"))
    yield from (board for board in insides_of(catalogs.shapes.get(key, ()), spec.size) if board.sort == "shelves")


def _settled(piece: DrawnPiece, carrier: _Carrier | None) -> DrawnPiece:
    """Returns a thing that has a size at its height: on what carries it, beside what is there; on the floor; or above it."""
    if piece.middle is None or piece.size is None:
        return piece
    low = piece.middle - piece.size[2] / 2
    if carrier is None:
        return replace(piece, y=low if low > max(min(piece.size), LEAST_RISE) else 0.0)
    body, tall = carrier.body, (carrier.body.size or piece.size)[2]
    turn = round(body.rotation / 90) * 90
    reach = extents(*piece.size[:2], round(piece.rotation / 90) * 90 - turn)
    fits = [one for one in carrier.levels if one.clearance >= piece.size[2] and _holds(one, reach)]
    if not fits:
        return piece
    level = min(fits, key=lambda one: (abs(one.height / tall - low / carrier.drawn_height), one.height))
    spot = rotate((piece.x - body.x) / 1000, (piece.z - body.z) / 1000, -turn)
    x, z = rotate(*_beside(spot, reach, level, carrier.taken.setdefault(level, [])), turn)
    return replace(piece, x=body.x + x * 1000, z=body.z + z * 1000, y=body.y + level.height)


def _holds(level: InsideSurface, reach: Spot) -> bool:
    """Tells whether a footprint fits."""
    return level.x[1] - level.x[0] >= reach[0] and level.z[1] - level.z[0] >= reach[1]


def _beside(spot: Spot, reach: Spot, level: InsideSurface, taken: list[_Taken]) -> Spot:
    """Returns the free spot of a surface that is nearest to one, and takes it; the nearest one where none is free, or many are taken."""
    across, along = (
        [at, *(middle + side * ((own + half) / 2 + APART) for middle, half in taken_so for side in (-1, 1))]
        for at, own, taken_so in zip(spot, reach, _ways(taken[:CROWDED]), strict=True)
    )
    spots = sorted(
        {(_within(x, level.x, reach[0]), _within(z, level.z, reach[1])) for x in across for z in along},
        key=lambda at: (math.dist(at, spot), at),
    )
    free = (at for at in spots if not any(_meet(at, reach, one) for one in taken))
    found = next(free, spots[0])
    taken.append(_Taken(found, reach))
    return found


def _ways(taken: Sequence[_Taken]) -> tuple[list[Spot], list[Spot]]:
    """Returns the middle and length of what is taken, along x and along z."""
    return [(one.spot[0], one.reach[0]) for one in taken], [(one.spot[1], one.reach[1]) for one in taken]


def _meet(spot: Spot, reach: Spot, other: _Taken) -> bool:
    return all(abs(a - b) < (own + its) / 2 for a, b, own, its in zip(spot, other.spot, reach, other.reach, strict=True))


def _within(at: float, span: tuple[float, float], length: float) -> float:
    return min(max(at, span[0] + length / 2), span[1] - length / 2)
