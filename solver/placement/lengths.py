"""Why pieces cannot stand together, in lengths that a person can check with a ruler.

Not here: which pieces are to blame (explain), what to do about it.

The room is made longer at its east or south end; what hangs on that wall goes along. At the least length at which the pieces
can stand, those of one chain of touching things from wall to wall have no millimetre left: that chain is the reason.
"""

from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from solver.geometry import Rect, outwards
from solver.pieces import Arrangement, Piece, Placed, Space
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


CanStand = Callable[[Space, Sequence[Piece]], bool | None]
"""Can the pieces stand in the space? None where a limit was hit first."""
Placing = Callable[[Space, Sequence[Piece]], Arrangement]
"""Places pieces that can stand."""
NEAR_MM = 200
"""What stands still this near to the far wall goes along with it."""
WALKING_MM = 900
"""Deepest square before an opening, mm: room that a longer room may need besides its pieces."""
ALONG = ("from west to east", "from north to south")


@dataclass(frozen=True)
class Shortfall:
    """By how much a room is too short for some pieces along the axis (0: x, 1: z) where that is least, in whole millimetres.

    `clear_mm` is what is clear along it. `lengths` are those from wall to wall, which add up to clear_mm + missing_mm; none where no single
    chain says why.
    """

    axis: int
    missing_mm: int
    clear_mm: int
    lengths: tuple[Length, ...] = ()


def shortfall(space: Space, pieces: Sequence[Piece], can_stand: CanStand, placing: Placing) -> Shortfall | None:
    """Finds the least length by which a room must grow along one axis for infeasible pieces to be feasible.

    `can_stand` is the search's verdict, `placing` its placement, asked for at most once. Returns the shorter of both axes' (x where equal);
    None where growing along one axis does not help, where more is missing than there is (it is not one length that such a room lacks), or a
    limit was hit.
    """
    best: tuple[int, int] | None = None
    for axis in (0, 1):
        most = best[1] - 1 if best else _enough(space, pieces)

        def stands(by: int, axis: int = axis) -> bool | None:
            return can_stand(longer_space(space, axis, by), longer_pieces(space, pieces, axis, by))

        missing = least_that(stands, most)
        if missing is not None:
            best = axis, missing
    if best is None or best[1] > _span(space.clear, best[0]):
        return None
    axis, missing = best
    longer, moved = longer_space(space, axis, missing), longer_pieces(space, pieces, axis, missing)
    arrangement = placing(longer, moved)
    clear_mm = _span(space.clear, axis)
    lengths = () if arrangement.left_out else chain(longer, moved, arrangement.placed, axis, going=_going(space, axis))
    exact = sum(length.mm for length in lengths) == clear_mm + missing
    return Shortfall(axis, missing, clear_mm, lengths if exact else ())


def sentence(found: Shortfall) -> str:
    """Says a shortfall in metres and centimetres."""
    along, missing = ALONG[found.axis], centimetres(found.missing_mm)
    if not found.lengths:
        return f"the {metres(found.clear_mm)} m that are clear {along} are {missing} short"
    clear = metres(found.clear_mm)
    if len(found.lengths) == 1:
        only = found.lengths[0]
        return f"{only.name} is {metres(only.mm)} m long, {clear} m are clear {along}: {missing} too long"
    total = metres(found.clear_mm + found.missing_mm)
    terms = " + ".join(f"{length.name} {metres(length.mm)}" for length in found.lengths)
    wall = _common_wall(found.lengths, found.axis)
    return f"{terms} = {total} > {clear} m {f'along the {wall} wall' if wall else along}: {missing} short"


def metres(mm: int) -> str:
    """Writes millimetres as metres with two decimals, or three where needed."""
    return f"{mm / 1000:.3f}" if mm % 10 else f"{mm / 1000:.2f}"


def centimetres(mm: int) -> str:
    """Writes millimetres as centimetres, exactly."""
    return f"{mm / 10:.1f} cm" if mm % 10 else f"{mm // 10} cm"


def _common_wall(lengths: Sequence[Length], axis: int) -> str | None:
    """Returns the wall that runs along the axis and that all bodies stand at, if there is one."""
    walls = {length.wall for length in lengths if length.label}
    return next((wall for wall in (("east", "west") if axis else ("north", "south")) if walls == {wall}), None)


def _span(rect: Rect, axis: int) -> int:
    return rect.depth if axis else rect.width


def _enough(space: Space, pieces: Sequence[Piece]) -> int:
    """Returns a growth that would hold all pieces one after the other beyond everything that is there."""
    longest = [max((max(a.size_mm[:2]) for a in piece.candidates), default=0) for piece in pieces]
    stands = sum(len(piece.stands) for piece in pieces)
    return sum(longest) + stands * space.robot_mm + 2 * (space.gap_mm + NEAR_MM + WALKING_MM)


def least_that(does: Callable[[int], bool | None], most: int) -> int | None:
    """Bisects for the least number in 1 ... `most` that does, if doing is monotone; None where that does not or a limit was hit."""
    if most < 1 or not does(most):
        return None
    low, high = 0, most
    while high - low > 1:
        middle = (low + high) // 2
        verdict = does(middle)
        if verdict is None:
            return None
        low, high = (low, middle) if verdict else (middle, high)
    return high


def longer_space(space: Space, axis: int, by: int) -> Space:
    """Returns a space longer at its east (axis 0) or south (axis 1) end; zones at that wall go along."""
    going = _going(space, axis)
    zones = tuple(zone._replace(rect=_shifted(zone.rect, axis, by, going)) for zone in space.zones)
    doorways = tuple(doorway._replace(square=_shifted(doorway.square, axis, by, going)) for doorway in space.doorways)
    return replace(space, clear=_shifted(space.clear, axis, by, going), zones=zones, doorways=doorways)


def longer_pieces(space: Space, pieces: Sequence[Piece], axis: int, by: int) -> tuple[Piece, ...]:
    """Returns the pieces for the longer space: where they must stay near the far wall they go along with it."""
    going = _going(space, axis)
    found = []
    for piece in pieces:
        ways = (replace(way, within=_shifted(way.within, axis, by, going)) if way.within else way for way in piece.candidates)
        found.append(replace(piece, candidates=tuple(ways)))
    return tuple(found)


def _going(space: Space, axis: int) -> tuple[int, int]:
    """Returns where things begin to touch the near wall, and from where on they are at the far one."""
    near, far = space.clear.span(axis)
    return near, far - NEAR_MM


def _shifted(rect: Rect, axis: int, by: int, going: tuple[int, int]) -> Rect:
    """Moves a rectangle at the far wall; stretches one that reaches from wall to wall; leaves the others."""
    low, high = rect.span(axis)
    if high < going[1]:
        return rect
    start = low if low <= going[0] else low + by
    return Rect(rect.x0, start, rect.x1, high + by) if axis else Rect(start, rect.z0, high + by, rect.z1)
