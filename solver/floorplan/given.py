"""A given outline: its corners are checked, and it is cut into the fewest rectangles, none narrower than a room may be."""

from collections.abc import Iterator, Sequence
from typing import Final, Literal, NamedTuple

from solver.errors import RequestError
from solver.geometry import Rect, edges_round, encloses, to_mm
from solver.streams import Stream

LARGEST_MM: Final = 100_000
"""Neither extent of a house is longer."""
RECTILINEAR: Final = "corners in order around the house, each edge along x or z, none crossing or touching another"
DRAWN: Final = 24
KEPT: Final = 6
"""How many ways to cut an outline of a planned home are drawn, and how many of those are searched."""
PlanCorner = tuple[int, int]
PlanCell = tuple[int, int]


class GivenPart(NamedTuple):
    """A rectangle of the outline, mm, and its place in the tree of cuts: 0 for the west or north side of a cut, 1 for the other."""

    rect: Rect
    path: str


def parts_of(corners: Sequence[tuple[float, float]], least: int) -> tuple[GivenPart, ...]:
    """Returns the rectangles that an outline is cut into, in the order of their paths; its north-west bound becomes the origin.

    Of the ways to cut from inner corners straight on, the one with the fewest narrow parts, then the fewest parts, then the widest.

    Raises:
        RequestError: the corners are no outline of a house, or one part is narrower than a room may be, however it is cut.
    """
    cells, xs, zs = _gridded(corners)
    best = _cut(cells, xs, zs, least, {})
    narrow = next((rect for rect in best if min(rect.width, rect.depth) < least), None)
    if narrow is not None:
        side = min(narrow.width, narrow.depth) / 1000
        raise RequestError("outline", f"has a part that is {side:g} m wide", f"parts of at least min_room_size, {least / 1000:g} m")
    return tuple(GivenPart(rect, path) for rect, path in best.items())


def tilings_of(corners: Sequence[tuple[float, float]], stream: Stream) -> tuple[tuple[Rect, ...], ...]:
    """Returns a few ways to cut an outline, m, into rectangles, the widest least side first; its north-west bound becomes the origin.

    The stream draws which ways are looked at.

    Raises:
        RequestError: the corners are no outline of a house.
    """
    cells, xs, zs = _gridded(corners)
    drawn = dict.fromkeys(tuple(sorted(_cut_at_random(cells, xs, zs, stream))) for _ in range(DRAWN))
    return tuple(sorted(drawn, key=lambda rects: (-min(min(rect.width, rect.depth) for rect in rects), len(rects), rects))[:KEPT])


def _cut_at_random(cells: frozenset[PlanCell], xs: Sequence[int], zs: Sequence[int], stream: Stream) -> list[Rect]:
    """Returns rectangles of connected cells, cut at each inner corner along an axis that is drawn."""
    box = _bounds(cells, xs, zs)
    if _fills(cells):
        return [box]
    return [rect for side in stream.pick(tuple(_ways(cells))) for rect in _cut_at_random(side, xs, zs, stream)]


def _gridded(corners: Sequence[tuple[float, float]]) -> tuple[frozenset[PlanCell], list[int], list[int]]:
    """Returns the cells of an outline in the grid of its lines, and these along x and z; its north-west bound is the origin."""
    points = _tidied([(to_mm(x), to_mm(z)) for x, z in corners])
    _check(points)
    west, north = min(x for x, _ in points), min(z for _, z in points)
    points = [(x - west, z - north) for x, z in points]
    xs, zs = sorted({x for x, _ in points}), sorted({z for _, z in points})
    cells = frozenset(
        (i, j) for i in range(len(xs) - 1) for j in range(len(zs) - 1) if encloses(points, (xs[i] + xs[i + 1]) / 2, (zs[j] + zs[j + 1]) / 2)
    )
    return cells, xs, zs


def _bounds(cells: frozenset[PlanCell], xs: Sequence[int], zs: Sequence[int]) -> Rect:
    columns, rows = [i for i, _ in cells], [j for _, j in cells]
    return Rect(xs[min(columns)], zs[min(rows)], xs[max(columns) + 1], zs[max(rows) + 1])


def _fills(cells: frozenset[PlanCell]) -> bool:
    """Tells whether cells make up the rectangle around them."""
    return len(cells) == len({i for i, _ in cells}) * len({j for _, j in cells})


def _tidied(points: Sequence[PlanCorner]) -> list[PlanCorner]:
    """Returns corners without repeated ones, and those in the middle of an edge."""
    kept = [point for at, point in enumerate(points) if point != points[at - 1]]
    while kept:
        around = zip([kept[-1], *kept[:-1]], kept, [*kept[1:], kept[0]], strict=True)
        corners = [b for a, b, c in around if not _is_between(a, b, c)]
        if len(corners) == len(kept):
            break
        kept = corners
    return kept


def _is_between(a: PlanCorner, b: PlanCorner, c: PlanCorner) -> bool:
    """Tells whether a corner lies on the straight way from the one before to the one after."""
    return any(a[k] == b[k] == c[k] and min(a[1 - k], c[1 - k]) <= b[1 - k] <= max(a[1 - k], c[1 - k]) for k in (0, 1))


def _check(points: Sequence[PlanCorner]) -> None:
    """Refuses what is no outline of a house."""
    if len(points) < 4:
        raise RequestError("outline", "encloses no floor", RECTILINEAR)
    edges = list(edges_round(points))
    for a, b in edges:
        if a[0] != b[0] and a[1] != b[1]:
            raise RequestError("outline", f"has a slanted edge from {_said(a)} to {_said(b)}", RECTILINEAR)
    for i, one in enumerate(edges):
        for other in edges[i + 2 : len(edges) - (i == 0)]:
            if _meet(one, other):
                raise RequestError("outline", f"crosses or touches itself between {_said(other[0])} and {_said(other[1])}", RECTILINEAR)
    if any(_turns_back(*edges[at - 1], edges[at][1]) for at in range(len(edges))):
        raise RequestError("outline", "goes back the way it came", RECTILINEAR)
    extents = [max(p[k] for p in points) - min(p[k] for p in points) for k in (0, 1)]
    if max(extents) > LARGEST_MM:
        raise RequestError("outline", f"is {max(extents) / 1000:g} m long", f"at most {LARGEST_MM / 1000:g} m")


def _said(point: PlanCorner) -> str:
    return f"({point[0] / 1000:g}, {point[1] / 1000:g})"


def _meet(one: tuple[PlanCorner, PlanCorner], other: tuple[PlanCorner, PlanCorner]) -> bool:
    """Tells whether two edges have a point in common."""
    return all(
        max(min(one[0][k], one[1][k]), min(other[0][k], other[1][k])) <= min(max(one[0][k], one[1][k]), max(other[0][k], other[1][k]))
        for k in (0, 1)
    )


def _turns_back(a: PlanCorner, b: PlanCorner, c: PlanCorner) -> bool:
    return any(a[k] == b[k] == c[k] for k in (0, 1))


Known = dict[frozenset[PlanCell], "dict[Rect, str]"]


def _cut(cells: frozenset[PlanCell], xs: Sequence[int], zs: Sequence[int], least: int, known: Known) -> dict[Rect, str]:
    """Returns the rectangles of connected cells with their paths, by the best way to cut them."""
    if cells in known:
        return known[cells]
    if _fills(cells):
        return {_bounds(cells, xs, zs): ""}
    ways = []
    for first, second in _ways(cells):
        sides_of = (("0", _cut(first, xs, zs, least, known)), ("1", _cut(second, xs, zs, least, known)))
        parts = {rect: digit + path for digit, side in sides_of for rect, path in side.items()}
        sides = [min(rect.width, rect.depth) for rect in parts]
        ways.append((sum(side < least for side in sides), len(sides), -min(sides), sorted(parts.values()), parts))
    known[cells] = min(ways, key=lambda way: way[:4])[4]
    return known[cells]


def _ways(cells: frozenset[PlanCell]) -> Iterator[tuple[frozenset[PlanCell], frozenset[PlanCell]]]:
    """Yields the two sides of each cut that goes straight on from the first inner corner, along x and along z."""
    corners = sorted({(i + di, j + dj) for i, j in cells for di in (0, 1) for dj in (0, 1)})
    column, row = next(at for at in corners if len(_around(at) & cells) == 3)
    axes: tuple[Literal["x", "z"], ...] = ("x", "z")
    for axis in axes:
        barred = frozenset(_line(cells, (column, row), axis, 1)) | frozenset(_line(cells, (column, row), axis, -1))
        start = min(cells)
        first = _flooded(cells, start, barred, axis)
        second = cells - first
        yield (first, second) if min(first) < min(second) else (second, first)


def _around(corner: PlanCell) -> frozenset[PlanCell]:
    """Returns the four cells about a corner of the grid."""
    i, j = corner
    return frozenset(((i - 1, j - 1), (i, j - 1), (i - 1, j), (i, j)))


def _line(cells: frozenset[PlanCell], corner: PlanCell, axis: Literal["x", "z"], way: int) -> Iterator[PlanCell]:
    """Yields the cells south or east of a cut from a corner on, as far as there is floor on either side of it."""
    i, j = corner
    if axis == "x":
        i = i if way > 0 else i - 1
        while (i, j - 1) in cells and (i, j) in cells:
            yield i, j
            i += way
    else:
        j = j if way > 0 else j - 1
        while (i - 1, j) in cells and (i, j) in cells:
            yield i, j
            j += way


def _flooded(cells: frozenset[PlanCell], start: PlanCell, barred: frozenset[PlanCell], axis: Literal["x", "z"]) -> frozenset[PlanCell]:
    """Returns the cells that are joined with one, where nothing passes the cut into barred cells."""
    found, ahead = {start}, [start]
    while ahead:
        i, j = ahead.pop()
        for cell in ((i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)):
            beyond = cell if (axis == "x" and cell[1] == j + 1) or (axis == "z" and cell[0] == i + 1) else (i, j)
            across = cell[1] != j if axis == "x" else cell[0] != i
            if cell in cells and cell not in found and not (across and beyond in barred):
                found.add(cell)
                ahead.append(cell)
    return frozenset(found)
