"""A drawing of shapes on layers, as CAD programmes and SVG keep it -> a plan: what a shape is, its layer's or its own name tells.

Closed shapes on layers of rooms are rooms, named by the text inside them, and so is what loose lines there enclose; shapes on layers of
doors, windows and openings are openings, as long as their longer side. Without closed rooms they are looked for between the walls.
Outlines that stay open, and other layers, are passed over, and told.
"""

from __future__ import annotations

import math
import re
from bisect import bisect_left
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Final, NamedTuple

import numpy as np

from catalogs.synonyms import RoomNames
from solver.geometry import bounds_of_points, encloses
from solver.imported import Unread
from solver.imports.drawn import MOST_POINTS, DrawnOpening, DrawnPlan, DrawnRoom, DrawnWall, Spot, check_count
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
)
from solver.imports.storeys_beside import storey_called, with_storeys_apart
from solver.imports.straighten import turn_of, turned_by
from solver.imports.units import GAPS, PlanUnit, assumed
from solver.imports.wall_gaps import fitted, gaps_of
from solver.imports.walls_alone import INSIDE, NamedSpot, overlap, passages_between, rooms_between

WORDS: Final[dict[str, tuple[str, ...]]] = {
    "garage_door": ("garage door", "garagedoor", "garagentor", "porte de garage"),
    "window": (
        "window", "fenster", "fenetre", "fenêtre", "ventana", "finestr", "janela", "kozijn", "raam", " ramen", "fönster", "fonster",
        "okn", "окно", "окна", "вікн", "glaz", "vindu", "ikkuna", "pencere", "ablak", "窓", "窗", "창",
    ),
    "door": (
        "door", "tür", "tuer", "porte", "puerta", "porta", "deur", "dörr", "drzwi", "двер", "dør", " ovi ", " ovet ", "kapı", "kapi ",
        "dveř", "dvere", "ajtó", "ドア", "扉", "门 ", "門 ", "门窗", "門窗", "문 ",
    ),
    "passage": ("passage", "durchgang"),
    "opening": (
        "opening", "öffnung", "oeffnung", "ouverture", "menuiserie", "apertura", "infiss", "serrament", "carpinter", "abertura",
        "esquadria", "проем", "проём", "建具", "开口",
    ),
    "wall": (
        "wall", "wand", "wänd", "waend", "mauer", "mur", "pared", "parete", "muro", "tabique", "cloison", "vägg", "vagg", "ścian",
        "scian", "стен", "стін", "partition", "bearing", "væg", "vegg", "seinä", "seina", "duvar", " zdi", "stěn", "příčk", "pricky",
        " falak", "壁 ", "墙", "墻", "벽",
    ),
    "room": (
        "room", "space", "raum", "räum", "raeum", "zimmer", "piece", "pièce", "habitacion", "habitación", "stanza", "stanze", "locale",
        "ruimte", "pomieszcz", "помещ", "приміщ", "zone", "místnost", "mistnost", "mahal", " odalar ", "部屋", "房间", "房間",
    ),
    "label": (" tag ", " tags ", " iden ", "stempel", "label", "etikett", "etiquet", "etichett"),
}  # fmt: skip
"""What a layer or a shape is, by words in its name; the first that fits, but an opening where doors and windows are named.

Of labels, such as the stamps of rooms, texts alone count."""
BETWEEN_WORDS: Final = re.compile(r"[\W_]+")
PASSED: Final = ("furn", "möbel", "mobil", "meuble", "mueble", "arredo", "dimension", "hatch")
"""Words of layers that hold none of these, whatever they lie within."""
NO_DOOR: Final = ("outdoor", "indoor")
MOST_DRAWN: Final = 4 * MOST_POINTS
"""Points of all rooms, walls and openings together."""
MOST_AROUND: Final = 20
"""Of the shapes around a text so many are looked at."""
HOUSE: Final = 12.0
"""About so large, m, is a house."""
LONG: Final = 3.0
"""A piece of wall is so many times as long as it is thick."""
ALIKE: Final = 0.01
"""Walls are as thick as one another whose thicknesses differ by no more than this share."""


UnitTold = Callable[[Sequence[DrawnOpening]], PlanUnit]


class DrawnText(NamedTuple):
    """A text without its lines of numbers, where it stands, what it plainly names: a room type, or another use of a room."""

    words: str
    x: float
    z: float
    means: str = ""


def text_at(words: str, spot: Spot, names: RoomNames) -> DrawnText:
    """Returns a text as it is drawn at a point, looked up among the names of rooms."""
    lines = (line.strip() for line in words.splitlines())
    said = " ".join(line for line in lines if line[:1].isalpha() or names.meaning(line) or storey_called(line) is not None)
    meaning = names.meaning(said) if said and names.is_plain(said) else None
    return DrawnText(said, *spot, meaning.key if meaning else "")


def plan_of_shapes(
    shapes: Sequence[DrawnShape], texts: Sequence[DrawnText], swings: Sequence[DrawnSwing], metres: UnitTold, unread: Sequence[Unread]
) -> DrawnPlan:
    """Returns the plan that shapes draw; where they draw no rooms, those between their walls.

    Texts name the rooms that they stand in, swings are of doors' leaves. `metres` tells the length of the unit by the openings, m; None
    where nothing does. `unread` is what is left out already.

    Raises:
        FieldError: there are more shapes than in any home.
    """
    shapes = _named_by_texts(shapes, texts)
    sorts = [shape.sort for shape in shapes]
    check_count("shapes", sum(sort is not None for sort in sorts) + len(swings), MOST_POINTS)
    check_count("points of shapes", sum(len(one.points) for one in shapes if one.sort is not None), MOST_DRAWN)
    check_count("texts", len(texts), MOST_POINTS)
    turn = turn_of([one.points for one in shapes if one.sort == "room"] or [one.points for one in shapes if one.sort == "wall"])
    shapes, texts, swings = _turned(shapes, texts, swings, turn)
    sorted_shapes = list(zip(shapes, sorts, strict=True))
    rooms = [_room(one, texts) for one, sort in sorted_shapes if sort == "room" and one.closed and len(one.points) > 2]
    outlines = [((*one.points, one.points[0]) if one.closed else one.points, one.closed) for one, sort in sorted_shapes if sort == "wall"]
    loose = [one for one, sort in sorted_shapes if sort == "room" and len(one.points) > 1 and not (one.closed and len(one.points) > 2)]
    are_drawn, by_walls = bool(rooms), not rooms and bool(outlines)
    if not rooms and not outlines:
        outlines = [(one.points, False) for one in loose]
    solid = [bounds_of_points(one.points) for one, sort in sorted_shapes if sort == "wall" and one.closed]
    faces = [(*room.points, room.points[0]) for room in rooms] or [points for points, _ in outlines]
    openings = _openings(shapes, sorts, swings, faces)
    length = _length(metres, openings, [points for points, _ in outlines])
    unit = length.metres
    openings, gaps = fitted(openings, gaps_of([points for points, _ in outlines], unit), unit)
    walls: list[DrawnWall] = []
    thick: float | None = None
    told: list[Unread] = []
    if rooms or not outlines:
        walls = [
            DrawnWall(a, b, 0.0, one.where)
            for one, sort in sorted_shapes if sort == "wall" and not one.closed
            for a, b in zip(one.points, one.points[1:], strict=False)
        ]  # fmt: skip
        found = _beside(rooms, loose, openings, unit)
        openings += passages_between(rooms, openings, gaps, unit)
    else:
        names = [NamedSpot(one.x, one.z, one.means) for one in texts if one.means]
        found, thick, told, passages = rooms_between([points for points, _ in outlines], openings, unit, gaps, names)
        openings += passages
    rooms += [replace(room, label=_label(room.points, texts)) for room in found]
    told += _still_open([] if by_walls else loose, rooms, unit)
    told += (*(one for room in rooms for one in _other_names(room, texts)), *_names_outside(rooms, texts), *_untold_layers(shapes))
    plan = DrawnPlan(
        tuple(rooms), tuple(openings), tuple(walls), metres=unit, unit_words=length.words, drawn="inner" if thick else "unsaid",
        wall_thickness=thick or _thickness(solid), unread=(*unread, *told), turned=turn, solid=_solid_walls(sorted_shapes),
        layers=tuple(name for name, _ in Counter(one.names for one in shapes if one.names).most_common()),
        faces=tuple(pair for points, closed in outlines if closed or thick or are_drawn for pair in pairwise(points)),
    )  # fmt: skip
    return with_storeys_apart(plan, [(one.words, (one.x, one.z)) for one in texts if not one.means], unit)


def _length(told: UnitTold, openings: Sequence[DrawnOpening], walls: Sequence[Sequence[Spot]]) -> PlanUnit:
    """Returns the length of the unit as it is told, else by doors, else by the gaps in walls of a house of usual size."""
    unit = told(openings)
    if unit.metres is None and not (unit := assumed(openings)).metres and walls:
        x0, z0, x1, z1 = bounds_of_points([spot for points in walls for spot in points])
        usual = HOUSE / (max(x1 - x0, z1 - z0) or 1.0)
        gaps = [gap for gap in fitted(openings, gaps_of(walls, usual), usual)[1] if gap.in_line]
        unit = assumed([DrawnOpening("passage", gap.start, gap.end, "") for gap in gaps], GAPS)
    return unit


def _openings(
    shapes: Sequence[DrawnShape], sorts: Sequence[str | None], swings: Sequence[DrawnSwing], faces: Sequence[Sequence[Spot]]
) -> list[DrawnOpening]:
    """Returns the doors of leaves' arcs, and what else is drawn as an opening, but for the leaves."""
    doors = doors_of_swings(swings, faces)
    leaves = Places([(one.hinge, end) for one in swings for end in one.ends])
    taken = Places([(one.start, one.end) for one in doors])
    others = (one for one in openings_of(shapes, sorts, swings) if taken.first(one.start, one.end) is None)
    return [*doors, *(one for one in others if leaves.first(one.start, one.end, one.kind == "window") is None)]


def _named_by_texts(shapes: Sequence[DrawnShape], texts: Sequence[DrawnText]) -> list[DrawnShape]:
    """Returns shapes; of a drawing that calls none a room or a wall those with one text in them that plainly names a room are rooms.

    Of those around a text the largest is it: others are furniture, and frames of texts; where there is one text, it is the smallest.
    """
    if any(one.sort in ("room", "wall") for one in shapes):
        return list(shapes)
    places = [at for at, one in enumerate(shapes) if one.sort is None and one.closed and len(one.points) > 2]
    boxes = np.array([bounds_of_points(shapes[at].points) for at in places]).reshape(-1, 4)
    sizes = (boxes[:, 2:] - boxes[:, :2]).prod(axis=1)
    held: list[list[int]] = []
    for text in (one for one in texts if one.means):
        around = ((boxes[:, :2] < (text.x, text.z)) & (boxes[:, 2:] > (text.x, text.z))).all(axis=1)
        smallest = sorted(map(int, np.flatnonzero(around)), key=lambda at: sizes[at])[:MOST_AROUND]
        held.append([at for at in smallest if encloses(shapes[places[at]].points, text.x, text.z)])
    counts = Counter(at for some in held for at in some)
    own = [[at for at in some if counts[at] == 1] for some in held]
    rooms = {places[some[0 if len(held) == 1 else -1]] for some in own if some}
    return [one._replace(sort="room") if at in rooms else one for at, one in enumerate(shapes)]


def _untold_layers(shapes: Sequence[DrawnShape]) -> Iterator[Unread]:
    """Yields the layers whose names tell nothing."""
    for name, count in sorted(Counter(one.names for one in shapes if one.sort is None).items()):
        yield Unread(f"layer {name!r:.60}", f"{count} shapes: its name tells neither rooms nor openings")


def _beside(
    rooms: Sequence[DrawnRoom], loose: Sequence[DrawnShape], openings: Sequence[DrawnOpening], metres: float | None
) -> list[DrawnRoom]:
    """Returns the rooms that loose lines enclose where no room is drawn as one outline."""
    if not loose:
        return []
    found = rooms_between([one.points for one in loose], openings, metres).rooms
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
    return [Unread(f"layer {name!r:.60}", f"{count} open outlines of rooms, which enclose none") for name, count in sorted(counts.items())]


def _turned(
    shapes: Sequence[DrawnShape], texts: Sequence[DrawnText], swings: Sequence[DrawnSwing], turn: float
) -> tuple[Sequence[DrawnShape], Sequence[DrawnText], Sequence[DrawnSwing]]:
    """Returns what is drawn turned back by some degrees, so that walls run along x and z."""
    if not turn:
        return shapes, texts, swings
    return (
        [one._replace(points=tuple(turned_by(spot, turn) for spot in one.points)) for one in shapes],
        [DrawnText(one.words, *turned_by((one.x, one.z), turn), one.means) for one in texts],
        [one._replace(hinge=turned_by(one.hinge, turn), ends=(turned_by(one.ends[0], turn), turned_by(one.ends[1], turn)))
         for one in swings],
    )  # fmt: skip


def is_passed(names: Sequence[str]) -> bool:
    """Tells whether a name is one of what is passed over."""
    return any(word in name.lower() for name in names for word in PASSED)


def sort_within(names: Sequence[str]) -> str | None:
    """Returns what the names around a shape tell, the outermost first: the nearest that tells anything counts."""
    for name in reversed(names):
        small = f" {BETWEEN_WORDS.sub(' ', name.lower())} "
        for word in NO_DOOR:
            small = small.replace(word, "")
        if is_passed((name,)):
            return None
        found = [sort for sort, words in WORDS.items() if any(word in small for word in words)]
        if found:
            return "label" if "label" in found else "opening" if {"window", "door"} <= {*found} else found[0]
    return None


def _thickness(walls: Sequence[DrawnBox]) -> float | None:
    """Returns the usual thickness of pieces of wall."""
    sides = [sorted((x1 - x0, z1 - z0)) for x0, z0, x1, z1 in walls]
    found = [(thin, long) for thin, long in sides if thin and long >= LONG * thin]
    return None if not found else sorted(found)[len(found) // 2][0]


def _solid_walls(shapes: Sequence[tuple[DrawnShape, str | None]]) -> tuple[DrawnWall, ...]:
    """Returns walls drawn as thick lines, and as boxes of four corners: long ones, and short ones that are as thick as a long one."""
    lines = [
        DrawnWall(a, b, one.width, one.where)
        for one, sort in shapes if sort == "wall" and one.width
        for a, b in pairwise((*one.points, *one.points[:one.closed]))
    ]  # fmt: skip
    long, short = list[DrawnWall](), list[tuple[DrawnBox, str]]()
    for one, sort in shapes:
        if sort == "wall" and one.closed and len({*one.points}) == 4:
            x0, z0, x1, z1 = box = bounds_of_points(one.points)
            thin, (start, end) = min(x1 - x0, z1 - z0), longer_line(one.points)
            if thin and math.dist(start, end) >= LONG * thin:
                long.append(DrawnWall(start, end, thin, one.where))
            elif thin:
                short.append((box, one.where))
    known = sorted({wall.thickness for wall in long})
    return (*lines, *long, *(wall for box, where in short for wall in _short_walls(box, where, known)))


def _short_walls(box: DrawnBox, where: str, known: Sequence[float]) -> Iterator[DrawnWall]:
    """Yields a short piece of wall along each axis across which it is as thick as some wall is known to be."""
    x0, z0, x1, z1 = box
    x, z = (x0 + x1) / 2, (z0 + z1) / 2
    for start, end, thickness in (((x0, z), (x1, z), z1 - z0), ((x, z0), (x, z1), x1 - x0)):
        near = known[max(0, bisect_left(known, thickness) - 1) :][:2]
        if any(abs(one - thickness) <= ALIKE * thickness for one in near):
            yield DrawnWall(start, end, thickness, where)


def _room(shape: DrawnShape, texts: Sequence[DrawnText]) -> DrawnRoom:
    return DrawnRoom(shape.points, shape.label or _label(shape.points, texts), shape.where)


def _label(points: Sequence[Spot], texts: Sequence[DrawnText]) -> str:
    """Returns the first text in a room that plainly names one, else the first that is no number."""
    return min(_texts_in(points, texts), key=lambda one: not one.means, default=DrawnText("", 0.0, 0.0)).words


def _texts_in(points: Sequence[Spot], texts: Sequence[DrawnText]) -> list[DrawnText]:
    """Returns the texts in a room that are no numbers."""
    x0, z0, x1, z1 = bounds_of_points(points)
    near = [one for one in texts if one.words and x0 <= one.x <= x1 and z0 <= one.z <= z1]
    return [one for one in near if encloses(points, one.x, one.z)]


def _other_names(room: DrawnRoom, texts: Sequence[DrawnText]) -> Iterator[Unread]:
    """Yields what else is named in a room that is called by a text in it: a dining room, to which no wall is drawn."""
    inside = _texts_in(room.points, texts)
    known = {one.means for one in inside if one.words == room.label}
    for words in dict.fromkeys(one.words for one in inside if known and one.means and one.means not in known):
        yield Unread(f"text {words!r:.60}", f"names a room, but no wall is drawn between it and {room.label!r:.60}")


def _names_outside(rooms: Sequence[DrawnRoom], texts: Sequence[DrawnText]) -> Iterator[Unread]:
    """Yields what names a room beside all rooms: walls may leave one open."""
    known = {room.label for room in rooms}
    inside = {(one.x, one.z) for room in rooms for one in _texts_in(room.points, texts)}
    outside = (one for one in texts if one.means and (one.x, one.z) not in inside) if rooms else ()
    for words in dict.fromkeys(one.words for one in outside if one.words not in known):
        yield Unread(f"text {words!r:.60}", "names a room, but stands in none: nothing encloses it")
