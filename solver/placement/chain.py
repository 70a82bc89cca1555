"""A chain of touching things from wall to wall, read off a placement.

Not here: how long the room must be.
"""

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from solver.geometry import outwards
from solver.pieces import Piece, Placed, Space
from solver.placement.layout import PERSON_MM

OUTSIDE = "what is outside the outline"


@dataclass(frozen=True)
class Length:
    """One length of a chain: what it is, and mm; for bodies their label, their wall, and whether it is their depth."""

    name: str
    mm: int
    label: str = ""
    wall: str | None = None
    is_depth: bool = False


@dataclass(frozen=True)
class _Thing:
    """A box on the chain: its extent along the axis and across it, its heights; `owner` only for a stand before a piece."""

    name: str
    label: str
    along: tuple[int, int]
    across: tuple[int, int]
    heights: tuple[float, float]
    fixed: bool = False
    wall: str | None = None
    is_depth: bool = False
    owner: str = ""
    above: tuple[str | None, ...] = ()


def chain(space: Space, pieces: Sequence[Piece], placed: Sequence[Placed], axis: int, going: tuple[int, int]) -> tuple[Length, ...]:
    """Returns the lengths of the shortest chain of touching things from wall to wall along an axis (0: x); empty where there is none.

    All pieces are placed; what may stand in one place only counts as fixed. `going`: where things begin to touch the near wall, and from
    where on they hang on the far one.
    """
    things = [*_bodies(pieces, placed, axis), *_zones(space, axis)]
    things += list(_stands(space, pieces, placed, axis))
    low, high = space.clear.span(axis)
    paths = deque[tuple[_Thing, ...]]((thing,) for thing in things if _starts(thing, low, space.gap_mm, going[1], axis))
    seen = {path[0].label for path in paths}
    while paths:
        path = paths.popleft()
        if _ends(path[-1], high, space.gap_mm, going[1], axis) and any(not thing.fixed and not thing.owner for thing in path):
            return _lengths(path, low, high)
        for thing in things:
            if thing.label not in seen and _touch(path[-1], thing):
                seen.add(thing.label)
                paths.append((*path, thing))
    return ()


def _bodies(pieces: Sequence[Piece], placed: Sequence[Placed], axis: int) -> Iterator[_Thing]:
    ways = {piece.label: piece.candidates for piece in pieces}
    for p in placed:
        a = p.chosen
        heights = (a.bottom_mm, a.bottom_mm + a.size_mm[2])
        fixed = len(ways[p.label]) == 1 and ways[p.label][0].stays
        along, across = p.footprint.span(axis), p.footprint.span(1 - axis)
        is_depth = (p.rotation % 180 == 90) == (axis == 0)
        yield _Thing(a.kind, p.label, along, across, heights, fixed, p.wall, is_depth, above=(a.under, a.on))


def _zones(space: Space, axis: int) -> Iterator[_Thing]:
    for k, zone in enumerate(space.zones):
        name = OUTSIDE if zone.cause == "outline" else f"the floor before {zone.cause}"
        along, across = zone.rect.span(axis), zone.rect.span(1 - axis)
        yield _Thing(name, f"zone {k}", along, across, (zone.above_mm, float("inf")), fixed=True)


def _stands(space: Space, pieces: Sequence[Piece], placed: Sequence[Placed], axis: int) -> Iterator[_Thing]:
    """Returns the squares of people at use sides, where they look along the axis."""
    wanted = {piece.label: piece for piece in pieces}
    for p in placed:
        for stand in wanted[p.label].stands:
            direction = outwards(stand.side, p.rotation)[axis]
            if not direction:
                continue
            low, high = p.footprint.span(axis)
            start, end = p.footprint.span(1 - axis)
            size = space.robot_mm
            along = (high, high + size) if direction > 0 else (low - size, low)
            across = (start - size // 2, end + size // 2)
            yield _Thing("to stand", f"{p.label} {stand.side}", along, across, (0, PERSON_MM), owner=p.label)


def _gap(thing: _Thing, wall: str, gap_mm: int) -> int:
    return gap_mm if thing.wall == wall else 0


def _starts(thing: _Thing, low: int, gap_mm: int, far_from: int, axis: int) -> bool:
    near = ("west", "north")[axis]
    return thing.along[0] in (low, low + _gap(thing, near, gap_mm)) or (thing.fixed and thing.along[1] <= far_from)


def _ends(thing: _Thing, high: int, gap_mm: int, far_from: int, axis: int) -> bool:
    far = ("east", "south")[axis]
    return thing.along[1] in (high, high - _gap(thing, far, gap_mm)) or (thing.fixed and thing.along[1] > far_from)


def _touch(before: _Thing, after: _Thing) -> bool:
    """Tells whether a thing begins where another ends, and they would share space if either went on."""
    if before.label in after.above or after.label in before.above or (before.fixed and after.fixed):
        return False
    for stand, other in ((before, after), (after, before)):
        if stand.owner and (other.owner or other.name.startswith("the floor before ")):
            return False  # people may stand where doors open, and in each other's place
    meet = max(before.across[0], after.across[0]) < min(before.across[1], after.across[1])
    tall = max(before.heights[0], after.heights[0]) < min(before.heights[1], after.heights[1])
    return before.along[1] == after.along[0] and meet and tall


def _lengths(path: Sequence[_Thing], low: int, high: int) -> tuple[Length, ...]:
    """Returns the lengths from wall to wall; what is fixed counts with all that lies between it and its wall."""
    found = []
    first, last = path[0], path[-1]
    for thing in path:
        if thing.fixed and thing is first:
            found.append(Length(f"to the far side of {thing.name}", thing.along[1] - low))
        elif thing.fixed and thing is last:
            found.append(Length(f"from the near side of {thing.name}", high - thing.along[0]))
        else:
            label = "" if thing.owner or thing.fixed else thing.label
            found.append(Length(thing.name, thing.along[1] - thing.along[0], label, thing.wall, thing.is_depth))
    before, after = first.along[0] - low, high - last.along[1]
    if before > 0 and not first.fixed:
        found.insert(0, Length("wall gap", before))
    if after > 0 and not last.fixed:
        found.append(Length("wall gap", after))
    return tuple(found)
