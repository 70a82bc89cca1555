"""Drawings whose layers tell nothing: what is a room, a wall or a window is told by texts and by form.

Comes in: shapes, texts, doors, the length of the unit. Goes out: shapes that are told. May import: shape_openings, walls_alone.
"""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Final, NamedTuple

import numpy as np

from solver.answers import Unread
from solver.geometry import bounds_of_points, edges_round, encloses
from solver.imports.drawn import MOST_POINTS, DrawnOpening, DrawnRoom, DrawnText, Spot
from solver.imports.rectilinear import DrawnLine
from solver.imports.shape_openings import DrawnBox, DrawnShape, longer_line, sides_of
from solver.imports.wall_faces import REACH, SAME_LINE, THICKEST, WallRows, line_between
from solver.imports.wall_gaps import WIDTHS, Fitted, fitted, gaps_of
from solver.imports.walls_alone import NamedSpot, WallOutlines, names_in, rooms_between

MOST_AROUND: Final = 20
"""Of the shapes around a text so many are looked at."""
MOST_BESIDE: Final = 60
"""Of the lines beside one the nearest are looked at, so many."""
MOST_LAYERS: Final = 6
"""Layers, each with closed shapes or open ones, among which walls are looked for: those with most on them."""
THINNEST: Final = 40
"""Lines that are nearer to one another, mm, are no two faces of a wall."""
LEAST_POINTS: Final = 8
LEAST_ROOMS: Final = 2
"""As many rooms walls enclose, or one that is named."""
LOST: Final = 0.05
"""Such a share of the floor is lost with walls, not with furniture."""


def told_by_form(
    shapes: Sequence[DrawnShape], names: Sequence[NamedSpot], doors: Sequence[DrawnOpening], metres: float | None
) -> list[DrawnShape]:
    """Returns shapes of a drawing that calls none a room or a wall, of which some are rooms, or else walls and windows.

    Walls are what on one layer, of areas, of closed shapes or of open ones, encloses most of what is named, else most rooms; of lines
    those that run beside another, if they do. Windows are drawn from jamb to jamb. `metres` is the length of the unit, where it is told.
    """
    rooms = _around_texts(shapes, names)
    is_large = sum(len(one.points) for one in shapes if one.sort is None) > MOST_POINTS
    if metres is None or is_large or 2 * sum(one.sort == "room" for one in rooms) > len(names):
        return rooms
    found = _with_windows(shapes, None, metres * 1000)
    openings = [*doors, *_windows_of(found)]
    groups: dict[tuple[str, bool, bool], list[int]] = {}
    for at, one in enumerate(found):
        if one.sort is None and len(one.points) > 1:
            groups.setdefault((one.names, one.closed, one.filled), []).append(at)
    counts = {key: sum(len(found[at].points) for at in members) for key, members in groups.items()}
    several = [groups[key] for key in sorted(counts, key=lambda key: -counts[key])[:MOST_LAYERS] if counts[key] >= LEAST_POINTS]
    ways = [
        (*_without_furniture(way, found, names, openings, metres), is_paired)
        for members in several
        for way, is_paired in {tuple(members): False, tuple(_side_by_side(members, found, metres * 1000)): True}.items()
    ]
    scores = [_score(rooms, names) for _, rooms, _ in ways]
    ranks = [(named, count * is_paired, count, -at) for at, ((named, count), (*_, is_paired)) in enumerate(zip(scores, ways, strict=True))]
    named, _, count, at = max(ranks, default=(0, 0, 0, 0))
    if not named and count < LEAST_ROOMS:
        return rooms
    walls = set(ways[-at][0])
    return [one._replace(sort="wall") if at in walls else one for at, one in enumerate(found)]


def told_among_walls(
    shapes: Sequence[DrawnShape], names: Sequence[NamedSpot], openings: Sequence[DrawnOpening], metres: float
) -> list[DrawnShape]:
    """Returns shapes, of which those that are called walls are windows or nothing where they are so by their form."""
    if sum(len(one.points) for one in shapes if one.sort == "wall") > MOST_POINTS:
        return list(shapes)
    if any(one.sort == "window" for one in shapes):
        found = list(shapes)
    else:
        found = _with_windows(shapes, "wall", metres * 1000)
        openings = [*openings, *_windows_of(found)]
    way = [at for at, one in enumerate(found) if one.sort == "wall"]
    kept = set(_without_furniture(way, found, names, openings, metres)[0])
    return [one._replace(sort=None) if one.sort == "wall" and at not in kept else one for at, one in enumerate(found)]


def _windows_of(shapes: Sequence[DrawnShape]) -> list[DrawnOpening]:
    return [DrawnOpening("window", *longer_line(one.points), one.where) for one in shapes if one.sort == "window"]


def _rooms_of(
    shapes: Sequence[DrawnShape], way: Sequence[int], names: Sequence[NamedSpot], openings: Sequence[DrawnOpening], metres: float
) -> tuple[list[DrawnRoom], Fitted, bool]:
    """Returns the rooms between shapes, the openings in their gaps, and whether the walls have two faces."""
    walls = [shapes[at].round() for at in way]
    fit = fitted(openings, gaps_of(walls, metres), metres)
    areas = [shapes[at].points for at in way if shapes[at].filled]
    found = rooms_between(WallOutlines(walls, areas), fit, metres, names) if walls else None
    return (found.rooms, fit, found.thickness is not None) if found else ([], fit, False)


def _score(rooms: Sequence[DrawnRoom], names: Sequence[NamedSpot]) -> tuple[int, int]:
    """Returns in how many rooms one room is named, and how many there are."""
    return sum(len(names_in(room, names)) == 1 for room in rooms), len(rooms)


def _without_furniture(
    way: Sequence[int], shapes: Sequence[DrawnShape], names: Sequence[NamedSpot], openings: Sequence[DrawnOpening], metres: float
) -> tuple[Sequence[int], list[DrawnRoom]]:
    """Returns shapes but for those of which a side has floor before and behind it, as of a wall of two faces none has; and the rooms.

    What ends at a gap that an opening fills is a wall. Where walls have one face alone, or rooms or floor are lost with the others: but for
    those that end at nothing and part no two names.
    """
    rooms, fit, have_two_faces = _rooms_of(shapes, way, names, openings, metres)
    by, sides = THINNEST / 2000 / metres, [(at, a, b) for at in way for a, b in pairwise(shapes[at].round()) if a != b]
    spots = np.array([sides_of(a, b, by) for _, a, b in sides]).reshape(-1, 2)
    around = [(names_in(room, names), _are_in(spots, (room.points, *room.holes)).reshape(-1, 2)) for room in rooms]
    are_floor = np.any([inside for _, inside in around], axis=0) if rooms else np.zeros((len(sides), 2), dtype=np.bool_)
    jambs = _ends([stretch for gap in fit.filled for stretch in gap.faces])
    within = SAME_LINE / 1000 / metres
    floor_at = [
        (number, at) for number, (at, *_) in enumerate(sides)
        if are_floor[number].all() and not any((np.hypot(*(jambs - spot).T) <= within).any() for spot in shapes[at].points)
    ]  # fmt: skip
    left_out, scale = {at for _, at in floor_at}, metres * 1000
    for is_strict in (False, True) if have_two_faces else (True,):
        if left_out and is_strict:
            left_out &= _loose(way, shapes, _ends([(gap.start, gap.end) for gap in (*fit.filled, *fit.left)]) * scale, scale)
            parted = ((at, [called for called, inside in around if called and inside[number].any()]) for number, at in floor_at)
            left_out -= {at for at, called in parted if len({frozenset(one) for one in called}) > 1}
        if not left_out or (is_strict and not names):
            break
        kept = [at for at in way if at not in left_out]
        others, *_ = _rooms_of(shapes, kept, names, openings, metres)
        is_less = sum(room.area for room in others) < (1 - LOST) * sum(room.area for room in rooms)
        are_fewer = len(others) < max(LEAST_ROOMS, len(rooms) - len(left_out)) or _score(others, names)[0] < _score(rooms, names)[0]
        if not is_less and not are_fewer:
            return kept, others
    return way, rooms


def _ends(stretches: Sequence[tuple[Spot, Spot]]) -> np.ndarray:
    return np.array(stretches).reshape(-1, 2)


def _loose(way: Sequence[int], shapes: Sequence[DrawnShape], ends: np.ndarray, scale: float) -> set[int]:
    """Returns single lines of which an end is at no other line and at none of some ends of gaps, mm."""
    sides = list(_sides(shapes, way, scale))
    rows = WallRows([one.line for one in sides])

    def is_free(line: DrawnLine, end: int) -> bool:
        spot = (end, line.at) if line.axis == "x" else (line.at, end)
        by = min(REACH, (line.high - line.low) // 2)
        short = line._replace(low=line.low + by) if end == line.low else line._replace(high=line.high - by)
        crossed = rows.ahead(short, short.low if end == line.low else short.high, by + SAME_LINE)
        is_crossed = crossed is not None and crossed.low <= line.at <= crossed.high
        return not is_crossed and not rows.is_met(line, end) and not (np.hypot(*(ends - spot).T) <= SAME_LINE).any()

    return {one.shape for one in sides if len(shapes[one.shape].points) == 2 and any(is_free(one.line, end) for end in one.line[2:])}


def _are_in(spots: np.ndarray, outlines: Sequence[Sequence[Spot]]) -> np.ndarray:
    """Tells of points whether they lie in an odd number of outlines, of rooms and of what is in these."""
    inside, (xs, zs) = np.zeros(len(spots), dtype=np.bool_), spots.T
    for (x0, z0), (x1, z1) in (edge for points in outlines for edge in edges_round(points) if edge[0][1] != edge[1][1]):
        inside ^= ((z0 > zs) != (z1 > zs)) & (xs < x0 + (zs - z0) / (z1 - z0) * (x1 - x0))
    return inside


def without_pieces(shapes: list[DrawnShape], texts: list[DrawnText]) -> tuple[list[DrawnShape], list[DrawnText], list[Unread]]:
    """Returns shapes and texts without the pieces that these name, and these, where nothing names a room but by a word for both."""
    pieces = [one for one in texts if one.of_piece]
    if (
        all(one.means for one in pieces)
        or any(one.means and not one.of_piece for one in texts)
        or any(one.sort == "room" for one in shapes)
    ):
        return shapes, texts, []
    told = _around_texts(shapes, [NamedSpot(one.x, one.z, one.words) for one in pieces], are_pieces=True)
    kept = [one for one, now in zip(shapes, told, strict=True) if one is now]
    left = [Unread(one.where, "a text in it names a piece: it is no wall") for one, now in zip(shapes, told, strict=True) if one is not now]
    return kept, [one for one in texts if not one.of_piece], left


def _around_texts(shapes: Sequence[DrawnShape], names: Sequence[NamedSpot], are_pieces: bool = False) -> list[DrawnShape]:
    """Returns shapes, of which closed ones with one text in them that plainly names a room are rooms.

    Of those around a text the largest is it: others are furniture, and frames of texts; where there is one text, it is the smallest.
    So it is of texts that name pieces.
    """
    places = [at for at, one in enumerate(shapes) if one.sort is None and one.closed and not one.filled and len(one.points) > 2]
    boxes = np.array([bounds_of_points(shapes[at].points) for at in places]).reshape(-1, 4)
    sizes = (boxes[:, 2:] - boxes[:, :2]).prod(axis=1)
    held: list[list[int]] = []
    for text in names:
        around = ((boxes[:, :2] < (text.x, text.z)) & (boxes[:, 2:] > (text.x, text.z))).all(axis=1)
        smallest = sorted(map(int, np.flatnonzero(around)), key=lambda at: sizes[at])[:MOST_AROUND]
        held.append([at for at in smallest if encloses(shapes[places[at]].points, text.x, text.z)])
    counts = Counter(at for some in held for at in some)
    own = [[at for at in some if counts[at] == 1] for some in held]
    rooms = {places[some[0 if are_pieces or len(held) == 1 else -1]] for some in own if some}
    return [one._replace(sort="room") if at in rooms else one for at, one in enumerate(shapes)]


class _Side(NamedTuple):
    """A straight side of a shape in mm, and whose."""

    line: DrawnLine
    shape: int


def _sides(shapes: Sequence[DrawnShape], places: Sequence[int], scale: float) -> Iterator[_Side]:
    for at in places:
        for a, b in pairwise(shapes[at].round()):
            if line := line_between((a[0] * scale, a[1] * scale), (b[0] * scale, b[1] * scale)):
                yield _Side(line, at)


def _rows(sides: Sequence[_Side], axis: str) -> np.ndarray:
    return np.array([(*one.line[1:], one.shape) for one in sides if one.line.axis == axis], dtype=np.int64).reshape(-1, 4).T


def _side_by_side(places: Sequence[int], shapes: Sequence[DrawnShape], scale: float) -> list[int]:
    """Returns shapes but for single lines, longer than a wall is thick, that are no face of a wall: lengths, axes, frames, worktops."""
    kept = list(places)
    for is_none in (_is_within, _is_alone):
        sides = list(_sides(shapes, kept, scale))
        rows = {axis: _rows(sides, axis) for axis in ("x", "z")}
        single = [one for one in sides if len(shapes[one.shape].points) == 2 and one.line.high - one.line.low > THICKEST]
        left_out = {one.shape for one in single if is_none(one.line, rows)}
        kept = [at for at in kept if at not in left_out]
    return kept


def _is_within(line: DrawnLine, rows: Mapping[str, np.ndarray]) -> bool:
    """Tells whether a line runs in the middle of a wall, farther than walls are thick: an axis."""
    away, lows, highs = _beside(line, rows[line.axis])
    common = np.maximum(np.minimum.outer(highs, highs) - np.maximum.outer(lows, lows), 0)
    faces = (np.subtract.outer(away, away) <= THICKEST) & (np.abs(np.add.outer(away, away)) <= SAME_LINE)
    return common[faces & (away > 0)[:, None]].sum() > THICKEST and not any(_corners(line, rows))


def _is_alone(line: DrawnLine, rows: Mapping[str, np.ndarray]) -> bool:
    """Tells whether no other face of a wall runs beside most of a line.

    None is that of a line that ends at the side of another one, as a worktop does, if a nearer one runs behind it, too far for one wall.
    """
    away, lows, highs = _beside(line, rows[line.axis], 2 * THICKEST)
    far = np.abs(away)
    behind = np.subtract.outer(far, far).T
    nearer = (np.multiply.outer(away, away) > 0) & (behind >= THINNEST) & (behind < far[:, None]) & (far > THICKEST)
    overlap = np.minimum.outer(highs, highs) > np.maximum.outer(lows, lows)
    is_face = (far <= THICKEST) & ~((nearer & overlap).any(axis=1) & (not all(_corners(line, rows))))
    return bool(2 * (highs - lows)[is_face].sum() < line.high - line.low)


def _corners(line: DrawnLine, rows: Mapping[str, np.ndarray]) -> tuple[bool, ...]:
    """Tells of either end of a line whether it is a corner, of an outline."""
    ats, lows, highs, _ = rows["z" if line.axis == "x" else "x"]
    ends_there = np.minimum(np.abs(lows - line.at), np.abs(highs - line.at)) <= SAME_LINE
    return tuple(bool((ends_there & (np.abs(ats - end) <= SAME_LINE)).any()) for end in line[2:])


def _beside(line: DrawnLine, row: np.ndarray, within: int = THICKEST) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns how far away the nearest lines run beside one, and from where to where they do."""
    away, lows, highs = row[0] - line.at, np.maximum(row[1], line.low), np.minimum(row[2], line.high)
    beside = np.flatnonzero((np.abs(away) >= THINNEST) & (np.abs(away) <= within) & (highs > lows))
    near = beside[np.argsort(np.abs(away[beside]), kind="stable")[:MOST_BESIDE]]
    return away[near], lows[near], highs[near]


def _with_windows(shapes: Sequence[DrawnShape], sort: str | None, scale: float) -> list[DrawnShape]:
    """Returns shapes, of which those of a sort around a line between two jambs, from one of which a wall goes on, are windows."""
    sides = list(_sides(shapes, [at for at, one in enumerate(shapes) if one.sort == sort], scale))
    boxes = list(_window_boxes(sides))
    around = np.array(boxes).reshape(-1, 4) + np.array((-SAME_LINE, -SAME_LINE, SAME_LINE, SAME_LINE))
    found = []
    for one in shapes:
        box = np.array(bounds_of_points(one.points)) * scale
        is_in = one.sort == sort and ((around[:, :2] <= box[:2]) & (around[:, 2:] >= box[2:])).all(axis=1).any()
        found.append(one._replace(sort="window") if is_in else one)
    return found


def _window_boxes(sides: Sequence[_Side]) -> Iterator[DrawnBox]:
    for axis, across in (("x", "z"), ("z", "x")):
        (ats, lows, highs, _), along = _rows(sides, across), _rows(sides, axis)
        for at, low, high in {
            one.line[1:] for one in sides if one.line.axis == axis and WIDTHS[0] <= one.line.high - one.line.low <= WIDTHS[1]
        }:
            holds = (lows < at - SAME_LINE) & (highs > at + SAME_LINE) & (highs - lows <= THICKEST) & (highs - lows >= THINNEST)
            jambs = [
                {(int(lows[k]), int(highs[k])) for k in np.flatnonzero(holds & (np.abs(ats - end) <= SAME_LINE))} for end in (low, high)
            ]
            for first, last in jambs[0] & jambs[1]:
                at_face = np.minimum(np.abs(along[0] - first), np.abs(along[0] - last)) <= SAME_LINE
                goes_on = ((along[1] < low - SAME_LINE) & (along[2] >= low - SAME_LINE)) | (
                    (along[2] > high + SAME_LINE) & (along[1] <= high + SAME_LINE)
                )
                if (at_face & goes_on).any():
                    yield (low, first, high, last) if axis == "x" else (first, low, last, high)
