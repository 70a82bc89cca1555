"""A drawing of shapes on layers, as CAD programmes and SVG keep it -> a plan: what a shape is, its layer's or its own name tells.

Closed shapes on layers of rooms are rooms, named by the text inside them, and so is what loose lines there enclose; shapes on layers of
doors, windows and openings are openings, as long as their longer side. Without closed rooms they are looked for between the walls.
Outlines that stay open, and other layers, are passed over, and told.
"""

import math
from bisect import bisect_left
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain, combinations, compress, pairwise
from typing import Final, NamedTuple

import numpy as np

from catalogs.synonyms import STOREYS, DrawnNames
from solver.answers import Unread
from solver.geometry import bounds_of_points
from solver.imports.drawn import MOST_POINTS, DrawnOpening, DrawnPlan, DrawnRoom, DrawnText, DrawnWall, Spot, check_count
from solver.imports.in_walls import doors_in_walls, windows_in_walls
from solver.imports.nameless_shapes import told_among_walls, told_by_form, without_pieces
from solver.imports.shape_openings import (
    DrawnBox,
    DrawnShape,
    DrawnSwing,
    Places,
    between,
    doors_of_swings,
    longer_line,
    openings_of,
    to_lines,
    without_leaves,
)
from solver.imports.storeys_beside import SidesOfWalls, StoreyTitle, away, with_storeys_apart, without_views
from solver.imports.straighten import turn_of, turned_by
from solver.imports.units import ASSUMED, DOORS, GAPS, PlanUnit, assumed, told_by_areas, without_area
from solver.imports.wall_gaps import WIDTHS, WallGap, fitted, gaps_of, with_leaves
from solver.imports.walls_alone import INSIDE, NamedSpot, WallOutlines, overlap, rooms_between
from solver.plain import quoted

MOST_DRAWN: Final = 4 * MOST_POINTS
"""Points of all rooms, walls and openings together."""
HOUSE: Final = 12.0
"""About so large, m, is a house."""
LARGEST_HOUSE: Final = 100.0
"""So large, m, is none in a unit that is but assumed: it was no door that told it."""
BESIDE: Final = 1.5
"""Storeys that are drawn one above another are taken so many times as far apart as they are wide."""
LONG: Final = 3.0
"""A piece of wall is so many times as long as it is thick."""
ALIKE: Final = 0.01
"""Walls are as thick as one another whose thicknesses differ by no more than this share."""


UnitTold = Callable[[Sequence[DrawnOpening]], PlanUnit]


class DrawnSheet(NamedTuple):
    """What a drawing draws: shapes; texts, which name the rooms that they stand in; arcs of doors' leaves."""

    shapes: list[DrawnShape]
    texts: list[DrawnText]
    swings: list[DrawnSwing]


def side_by_side(sheets: Mapping[int | None, DrawnSheet]) -> DrawnSheet:
    """Returns what layers of storeys, from the lowest on, and others draw: what lies one above another is beside one another, titled."""
    walls = {
        storey: [spot for one in sheet.shapes if one.sort in ("room", "wall") for spot in one.points] for storey, sheet in sheets.items()
    }
    boxes = {storey: bounds_of_points(walls[storey]) for storey in sorted(told for told in walls if told is not None) if walls[storey]}
    if any(not away(*two) for two in combinations(boxes.values(), 2)):
        names = {storey: key for key, storey in STOREYS.items() if storey is not None}
        wide = max(box[2] for box in boxes.values()) - min(box[0] for box in boxes.values())
        for at, (storey, box) in enumerate(boxes.items()):
            title = DrawnText(names.get(storey, f"storey {storey}"), box[0] - wide / 99, box[1], storey=storey)
            drawn = sheets[storey]._replace(texts=[title, *sheets[storey].texts])
            sheets = {**sheets, storey: _each(drawn, partial(_eastward, at * BESIDE * wide))}
    return DrawnSheet(*(list(chain(*some)) for some in zip(DrawnSheet([], [], []), *sheets.values(), strict=True)))


def _eastward(by: float, spot: Spot) -> Spot:
    return spot[0] + by, spot[1]


def text_at(words: str, spot: Spot, known: DrawnNames) -> DrawnText:
    """Returns a text as it is drawn at a point, looked up among the names of rooms; what is behind an area may be of the room's floor."""
    lines = words.splitlines()
    at = next((number for number, line in enumerate(lines) if without_area(line)[1]), len(lines))
    ways = [_name_in("\n".join(some), known) for some in (lines[: at + 1], lines[at + 1 :], lines)]
    said = next((one for one in ways if one and known.rooms.is_plain(one)), ways[-1])
    meaning = known.rooms.meaning(said) if said and known.rooms.is_plain(said) else None
    return DrawnText(said, *spot, meaning.key if meaning else "", without_area(words)[1], known.storey(said), known.is_thing(said))


def _name_in(words: str, known: DrawnNames) -> str:
    """Returns the lines of a text that are no numbers, without an area."""
    lines = (line.strip() for line in without_area(words)[0].splitlines())
    return " ".join(line for line in lines if line[:1].isalpha() or known.rooms.meaning(line) or known.storey(line) is not None)


def plan_of_shapes(sheet: DrawnSheet, told: UnitTold, metres: float | None, unread: Sequence[Unread] = ()) -> DrawnPlan:
    """Returns the plan that shapes draw; where they draw no rooms, those between their walls.

    `metres` is the length of the unit, where the caller says it; else the areas that are written in rooms tell it, where they differ from
    what `told` tells by the openings. `unread` is what is left out already.

    Raises:
        FieldError: there are more shapes than in any home.
    """
    called = [one for one in sheet.shapes if one.sort is not None]
    check_count("texts", len(sheet.texts), MOST_POINTS)
    check_count("shapes", len(called) + len(sheet.swings), MOST_POINTS)
    check_count("points of shapes", sum(len(one.points) for one in called), MOST_DRAWN)
    shapes, texts, left = without_pieces(sheet.shapes, sheet.texts)
    sheet, unread = sheet._replace(shapes=shapes, texts=texts), (*unread, *left)
    plan = _plan(sheet, (lambda _: PlanUnit(metres)) if metres else told, unread)
    unit = None if metres else told_by_areas([(room.area, one) for room in plan.rooms if (one := _said_area(room, sheet.texts))], plan)
    return plan if unit is None else _plan(sheet, lambda _: unit, unread)


def _said_area(room: DrawnRoom, texts: Sequence[DrawnText]) -> float:
    """Returns the area that is written in a room, m2; 0 where none or several are."""
    said = {one.area for one in texts if one.area and room.holds(one.x, one.z)}
    return said.pop() if len(said) == 1 else 0.0


def _plan(sheet: DrawnSheet, metres: UnitTold, unread: Sequence[Unread]) -> DrawnPlan:
    shapes, texts, swings = sheet
    turn = turn_of(next((some for sort in ("room", "wall", None) if (some := [one.points for one in shapes if one.sort == sort])), []))
    shapes, texts, swings = _turned(sheet, turn)
    names = [NamedSpot(one.x, one.z, one.means) for one in texts if one.means]
    is_swung = any(one.sort for one in swings) or any(one.sort in ("door", "opening") for one in shapes)
    nameless = [one for one in swings if not one.sort]
    swings = [one for one in swings if one.sort or not is_swung]
    shapes, untold = _told_by_form(shapes, swings, names, metres)
    drawn_rooms, drawn_walls = ([one for one in shapes if one.sort == sort] for sort in ("room", "wall"))
    rooms = [DrawnRoom(one.points, one.label, one.where) for one in drawn_rooms if one.closed and len(one.points) > 2]
    outlines = [(one.round(), one.closed) for one in drawn_walls]
    loose = [one for one in drawn_rooms if len(one.points) > 1 and not (one.closed and len(one.points) > 2)]
    are_drawn, by_walls = bool(rooms), not rooms and bool(outlines)
    if not rooms and not outlines:
        outlines = [(one.points, False) for one in loose]
    faces = [(*room.points, room.points[0]) for room in rooms] + [points for points, _ in outlines]
    openings = _openings(shapes, swings, faces)
    length = _length(metres, openings, [points for points, _ in outlines])
    unit = length.metres
    gaps = gaps_of([points for points, _ in outlines], unit)
    fit = fitted(openings, gaps, unit)
    openings, gapless = (fit.openings, []) if is_swung else _in_gaps(fit.openings, gaps)
    walls: list[DrawnWall] = []
    thick: float | None = None
    told: list[Unread] = []
    if rooms or not outlines:
        walls = [DrawnWall(a, b, 0.0) for one in drawn_walls if not one.closed for a, b in pairwise(one.points)]
        found = _beside(rooms, loose, openings, unit)
    else:
        drawn = WallOutlines([points for points, _ in outlines], [one.points for one in drawn_walls if one.filled])
        found, thick, told, passages = rooms_between(drawn, fit._replace(openings=openings), unit, names)
        found, views = _seen_from_above(found, openings, gaps, texts, SidesOfWalls(drawn.lines, thick, unit or 1.0))
        told += views
        openings += with_leaves(passages, gaps, [] if is_swung else [one.round() for one in shapes if one.sort is None and one.points])
    rooms += found
    openings += doors_in_walls(gapless, shapes, rooms, unit) if unit else ()
    openings += windows_in_walls(openings, untold, shapes, rooms, unit) if unit else ()
    told += (*_still_open([] if by_walls else loose, rooms, unit), *_no_doors(nameless, openings))
    told += _untold_layers(shapes, sheet.shapes)
    plan = DrawnPlan(
        tuple(rooms), tuple(openings), tuple(walls), metres=unit, unit_words=length.words, drawn="inner" if thick else "unsaid",
        wall_thickness=thick or _thickness(drawn_walls), unread=(*unread, *told), turned=turn, solid=_solid_walls(drawn_walls),
        layers=tuple(name for name, _ in Counter(one.names for one in shapes if one.names).most_common()),
        faces=tuple(pair for points, closed in outlines if closed or thick or are_drawn for pair in pairwise(points)),
        texts=tuple(texts),
    )  # fmt: skip
    return with_storeys_apart(with_labels(plan), _titles(texts), unit)


def _titles(texts: Sequence[DrawnText]) -> list[StoreyTitle]:
    """Returns the texts that tell a storey, and name no room."""
    return [StoreyTitle(one.storey, one.words, one.x, one.z) for one in texts if one.storey is not None and not one.means]


def _length(told: UnitTold, openings: Sequence[DrawnOpening], walls: Sequence[Sequence[Spot]]) -> PlanUnit:
    """Returns the length of the unit as it is told, else by doors, else by the gaps in walls of a house of usual size."""
    unit = told(openings)
    unit = assumed(openings) if unit.metres is None else unit
    x0, z0, x1, z1 = bounds_of_points([spot for points in walls for spot in points]) if walls else (0.0, 0.0, 0.0, 0.0)
    size = max(x1 - x0, z1 - z0) or 1.0
    if walls and (unit.metres is None or (unit.words.startswith(ASSUMED) and size * unit.metres > LARGEST_HOUSE)):
        usual = HOUSE / size
        left = fitted(openings, gaps_of(walls, usual), usual).left
        wide = [gap for gap in left if gap.in_line and gap.width * usual * 1000 >= WIDTHS[0]]
        gaps = [DrawnOpening("door", gap.start, gap.end, "") for gap in wide]
        unit = told(gaps)
        unit = assumed(gaps, GAPS) if unit.metres is None else unit._replace(words=unit.words.replace(DOORS, GAPS))
    return unit


def _openings(shapes: Sequence[DrawnShape], swings: Sequence[DrawnSwing], faces: Sequence[Sequence[Spot]]) -> list[DrawnOpening]:
    """Returns the doors of leaves' arcs, and what else is drawn as an opening, but for the leaves."""
    doors = doors_of_swings(swings, faces)
    leaves = Places([(one.hinge, end) for one in swings for end in one.ends])
    taken = Places([(one.start, one.end) for one in doors])
    return doors + [
        one
        for one in openings_of(shapes, swings)
        if (one.id and one.kind != "door")
        or not (taken.holds(one.start, one.end) or leaves.holds(one.start, one.end, one.kind == "window"))
    ]


def _told_by_form(
    shapes: Sequence[DrawnShape], swings: Sequence[DrawnSwing], names: Sequence[NamedSpot], metres: UnitTold
) -> tuple[list[DrawnShape], list[DrawnShape]]:
    """Returns shapes, of which those of no sort are told by their form where none is called a room or a wall; and of these the others."""
    if any(one.sort == "room" for one in shapes):
        return list(shapes), []
    walls = [one.round() for one in shapes if one.sort == "wall"]
    if walls:
        openings = _openings(shapes, swings, walls)
        unit = _length(metres, openings, walls).metres
        return told_among_walls(shapes, names, openings, unit) if unit else list(shapes), []
    shapes = without_leaves(shapes, swings)
    lines = [one.round() for one in shapes if one.sort is None and len(one.points) > 1]
    doors = doors_of_swings(swings, lines)
    found = told_by_form(shapes, names, doors, _length(metres, doors, lines).metres)
    return found, [now for one, now in zip(shapes, found, strict=True) if one.sort is None and now.sort in (None, "wall")]


def _in_gaps(openings: Sequence[DrawnOpening], gaps: Sequence[WallGap]) -> tuple[list[DrawnOpening], list[DrawnOpening]]:
    """Returns openings but for doors that hang in no gap, and these if all do: quarter circles on layers that tell nothing may be any."""
    ends = set(map(_ends, gaps))
    hung = [one.kind != "door" or _ends(one) in ends for one in openings]
    kept = list(compress(openings, hung))
    return kept, [one for one in openings if one.kind == "door"] if all(one.kind != "door" for one in kept) else []


def _seen_from_above(
    rooms: Sequence[DrawnRoom], openings: Sequence[DrawnOpening], gaps: Sequence[WallGap], texts: Sequence[DrawnText], walls: SidesOfWalls
) -> tuple[list[DrawnRoom], list[Unread]]:
    """Returns rooms but for those of elevations, in which no door swings or closes a gap: the lines of walls go on behind it."""
    ends = set(map(_ends, gaps))
    doors = [one for one in openings if one.hinge or (one.kind != "window" and _ends(one) in ends)]
    return without_views(rooms, doors, [(one.x, one.z) for one in texts if one.means or one.area], walls)


def _ends(one: DrawnOpening | WallGap) -> frozenset[Spot]:
    return frozenset((one.start, one.end))


def _no_doors(nameless: Sequence[DrawnSwing], openings: Sequence[DrawnOpening]) -> list[Unread]:
    """Returns how many quarter circles on layers that tell nothing are at no door."""
    doors = Places([(one.start, one.end) for one in openings if one.kind == "door"])
    left = [one for one in nameless if not any(doors.holds(one.hinge, end) for end in one.ends)]
    return [Unread(left[0].where, f"quarter circles that hang in no gap in a wall are no doors: {len(left)}")] if left else []


def _untold_layers(shapes: Sequence[DrawnShape], drawn: Sequence[DrawnShape]) -> Iterator[Unread]:
    """Yields the layers whose names tell nothing: those of walls that are so by their form, and those of which nothing is read.

    And those of walls on which some are none by their form.
    """
    called = {one.names for one in drawn if one.sort == "wall"}
    walls = {one.names for one in shapes if one.sort == "wall"} - {one.names for one in drawn if one.sort}
    yield from (
        Unread(f"layer {quoted(name)}", "it is taken as walls, as it encloses rooms: its name does not say what it holds")
        for name in sorted(walls)
    )
    for name, count in sorted(Counter(one.names for one in shapes if one.sort is None).items()):
        yield Unread(
            f"layer {quoted(name)}",
            f"{count} shapes with floor before and behind them are taken as no walls"
            if name in called
            else f"{count} shapes: its name tells neither rooms nor openings",
        )


def _beside(
    rooms: Sequence[DrawnRoom], loose: Sequence[DrawnShape], openings: Sequence[DrawnOpening], metres: float | None
) -> list[DrawnRoom]:
    """Returns the rooms that loose lines enclose where no room is drawn as one outline."""
    if not loose:
        return []
    lines = [one.points for one in loose]
    fit = fitted(openings, gaps_of(lines, metres), metres)
    found = rooms_between(WallOutlines(lines), fit._replace(left=[]), metres).rooms
    within = INSIDE / (metres or 1.0)
    return [room for room in found if not any(overlap(room.points, other.points, within) for other in rooms)]


def _still_open(loose: Sequence[DrawnShape], rooms: Sequence[DrawnRoom], metres: float | None) -> list[Unread]:
    """Returns, for each layer of rooms, how many of its loose lines no room lies along."""
    sides = np.array([(*a, *b) for room in rooms for a, b in pairwise((*room.points, room.points[0]))]).reshape(-1, 4)
    near, counts = INSIDE / (metres or 1.0), Counter[str]()
    for one in loose:
        middles = [between(a, b) for a, b in pairwise(one.points)]
        if not len(sides) or any(to_lines(spot, sides) > near for spot in middles):
            counts[one.names] += 1
    found = sorted(counts.items())
    return [Unread(f"layer {quoted(name)}", f"{count} open outlines of rooms, which enclose none") for name, count in found]


def _turned(sheet: DrawnSheet, turn: float) -> DrawnSheet:
    """Returns what is drawn turned back by some degrees, so that walls run along x and z."""
    return _each(sheet, lambda spot: turned_by(spot, turn)) if turn else sheet


def _each(sheet: DrawnSheet, to: Callable[[Spot], Spot]) -> DrawnSheet:
    """Returns what is drawn with each point moved."""
    return DrawnSheet(
        [one._replace(points=tuple(map(to, one.points))) for one in sheet.shapes],
        [one._replace(x=spot[0], z=spot[1]) for one in sheet.texts for spot in (to((one.x, one.z)),)],
        [one._replace(hinge=to(one.hinge), ends=(to(one.ends[0]), to(one.ends[1]))) for one in sheet.swings],
    )


def _thickness(walls: Sequence[DrawnShape]) -> float | None:
    """Returns the usual thickness of pieces of wall."""
    sides = [sorted((x1 - x0, z1 - z0)) for x0, z0, x1, z1 in (bounds_of_points(one.points) for one in walls if one.closed)]
    found = [(thin, long) for thin, long in sides if thin and long >= LONG * thin]
    return None if not found else sorted(found)[len(found) // 2][0]


def _solid_walls(walls: Sequence[DrawnShape]) -> tuple[DrawnWall, ...]:
    """Returns walls drawn as thick lines, and as boxes of four corners: long ones, and short ones that are as thick as a long one."""
    lines = [DrawnWall(a, b, one.width) for one in walls if one.width for a, b in pairwise(one.round())]
    long, short = list[DrawnWall](), list[DrawnBox]()
    for one in walls:
        if one.closed and len({*one.points}) == 4:
            x0, z0, x1, z1 = box = bounds_of_points(one.points)
            thin, (start, end) = min(x1 - x0, z1 - z0), longer_line(one.points)
            if thin and math.dist(start, end) >= LONG * thin:
                long.append(DrawnWall(start, end, thin))
            elif thin:
                short.append(box)
    known = sorted({wall.thickness for wall in long})
    return (*lines, *long, *(wall for box in short for wall in _short_walls(box, known)))


def _short_walls(box: DrawnBox, known: Sequence[float]) -> Iterator[DrawnWall]:
    """Yields a short piece of wall along each axis across which it is as thick as some wall is known to be."""
    x0, z0, x1, z1 = box
    x, z = (x0 + x1) / 2, (z0 + z1) / 2
    for start, end, thickness in (((x0, z), (x1, z), z1 - z0), ((x, z0), (x, z1), x1 - x0)):
        near = known[max(0, bisect_left(known, thickness) - 1) :][:2]
        if any(abs(one - thickness) <= ALIKE * thickness for one in near):
            yield DrawnWall(start, end, thickness)


def with_labels(plan: DrawnPlan) -> DrawnPlan:
    """Returns a plan whose rooms are called by the texts in them; what else these name is told."""
    texts: defaultdict[int, list[DrawnText]] = defaultdict(list)
    for one in plan.texts:
        texts[one.level].append(one)
    rooms, told = tuple(_labelled(room, texts[room.level]) for room in plan.rooms), list(plan.unread)
    for level, some in texts.items():
        own = [room for room in rooms if room.level == level]
        told += (*(name for room in own for name in _other_names(room, some)), *_names_outside(own, some))
    return replace(plan, rooms=rooms, unread=tuple(told), texts=())


def _labelled(room: DrawnRoom, texts: Sequence[DrawnText]) -> DrawnRoom:
    """Returns a room, one without a label called by the first text in it that plainly names one, else the first that is no number."""
    inside = [] if room.label else sorted(_texts_in(room, texts), key=lambda one: not one.means)
    return replace(room, label=inside[0].words) if inside else room


def _texts_in(room: DrawnRoom, texts: Sequence[DrawnText]) -> list[DrawnText]:
    """Returns the texts in a room that are no numbers."""
    if not room.points:
        return []
    x0, z0, x1, z1 = bounds_of_points(room.points)
    near = [one for one in texts if one.words and x0 <= one.x <= x1 and z0 <= one.z <= z1]
    return [one for one in near if room.holds(one.x, one.z)]


def _other_names(room: DrawnRoom, texts: Sequence[DrawnText]) -> Iterator[Unread]:
    """Yields what else is named in a room that is called by a text in it: a dining room, to which no wall is drawn."""
    inside = _texts_in(room, texts)
    known = {one.means for one in inside if one.words == room.label}
    for words in dict.fromkeys(one.words for one in inside if known and one.means and one.means not in known):
        yield Unread(f"text {quoted(words)}", f"names a room, but no wall is drawn between it and {quoted(room.label)}")


def _names_outside(rooms: Sequence[DrawnRoom], texts: Sequence[DrawnText]) -> Iterator[Unread]:
    """Yields what names a room beside all rooms: walls may leave one open."""
    known = {room.label for room in rooms}
    inside = {(one.x, one.z) for room in rooms for one in _texts_in(room, texts)}
    outside = (one for one in texts if one.means and (one.x, one.z) not in inside) if rooms else ()
    for words in dict.fromkeys(one.words for one in outside if one.words not in known):
        yield Unread(f"text {quoted(words)}", "names a room, but stands in none: nothing encloses it")
