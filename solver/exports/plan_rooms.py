"""Rooms on a plan: their clear floor between walls, where names, areas and clear sizes are best written; dimensions outside the house.

Along each side of the house runs a chain over its openings, one over its rooms, and the whole.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import Final, Literal, NamedTuple

from solver.exports.model import FloorPlate, PlacedOpening, WallPanel
from solver.geometry import ALONG_X, INWARDS, bounds_of_points, doubled_area, edges_round, square_metres, walls_round

PlanBox = tuple[float, float, float, float]
"""West, north, east and south, m."""
Obstacle = tuple[float, float, float, float, float]
"""A box, and how much worse than furniture it is to write on it."""
_STEPS: Final = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9)
"""Where across a room its label is tried, as shares of its span, the middle first."""
WIDE: Final = 0.66
"""How wide a bold letter is on average in the widest of the fonts asked for, as a share of its height."""
_DIGIT: Final = 0.6
_RAISED: Final = ("", *"¹²³⁴⁵⁶⁷⁸⁹")
_CORNER: Final = 0.35
"""What a wall that ends at a corner may reach beyond it, m: more than half of the thickest."""
SMALLER: Final = 0.86
"""How high an area and a size are written, as a share of the name above them."""
LINE: Final = 1.25
"""From one line of text to the next, as a share of its height."""
_SAID: Final = {
    "bedroom_master": "master bedroom", "kids_bedroom": "kids' bedroom", "garage_2car": "garage for two cars",
    "garage_3car": "garage for three cars",
}  # fmt: skip
"""What one says of room types whose names' parts stand in another order, or are short."""
_LEAST_SHRINK: Final = 0.62
"""How much smaller a name may be written to fit its room."""
MOST_CORNERS: Final = 16
"""Of a room with more corners no arms are looked for."""
APART: Final = 1e-6
"""What lies farther inside of an outline, m, is not on it."""
_UPRIGHT: Final = 0.75
"""A name is written upright where level it would have to be smaller than this share of that."""


class Dimension(NamedTuple):
    """A chain of dimensions along an axis: the coordinate across it, and where its marks are along it, m.

    `texts` are where its numbers stand: middles along the axis.
    """

    axis: Literal["x", "z"]
    at: float
    stops: tuple[float, ...]
    texts: tuple[float, ...]


class RoomLabel(NamedTuple):
    """A room's name in one row or two, its clear area in m2 and its clear width and depth, where: its middle, m.

    `measures` is empty where there is no room for it; `upright` is written from south to north; `size`: letters' height of the name,
    `small`: of what is below it, m.
    """

    room: FloorPlate
    rows: tuple[str, ...]
    area: float
    measures: str
    x: float
    z: float
    upright: bool
    size: float
    small: float

    @property
    def below(self) -> tuple[str, ...]:
        """What is written below the name: the area, and how wide and deep the room is."""
        return (square_metres(self.area), self.measures) if self.measures else (square_metres(self.area),)


@dataclass(frozen=True)
class PlanRoom:
    """A room to be labelled: its name, its clear corners, what stands in it, and the height of letters of its name, m."""

    plate: FloorPlate
    words: str
    corners: Sequence[tuple[float, float]]
    obstacles: Sequence[Obstacle]
    letters: float


def name_of(room: FloorPlate, called: Mapping[str, str] | None = None) -> str:
    """Returns what a plan calls a room, in one line: its own name, else its type's."""
    own = " ".join(room.name.split()) if room.name else ""
    return _capital(own) if own else words_of(room.type, called)


def said_of_room(room: FloorPlate) -> dict[str, str]:
    """Returns what formats that only show a room's `label` say of it in words of their own, for our import."""
    own = {"name": room.name} if room.name else {}
    return {"id": room.id, "type": room.type, "label": name_of(room), "outdoor": str(room.outdoor).lower(), **own}


def words_of(room_type: str, called: Mapping[str, str] | None = None) -> str:
    """Returns a room type as a plan names it: as it is `called`, else in English."""
    return _capital((called or {}).get(room_type) or _SAID.get(room_type) or " ".join(room_type.replace("_", " ").split()))


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]


def clear_corners(plate: FloorPlate, panels: Iterable[WallPanel], half: float) -> list[tuple[float, float]]:
    """Returns a floor's corners moved in to the faces of its walls, and by `half`, m, where it has none."""
    walls = [panel for panel in panels if panel.level == plate.level]
    corners = _turning(plate.corners)
    lines = []
    for side, line, low, high in walls_round(corners):
        axis, inward = "x" if side in ALONG_X else "z", INWARDS[side]
        least = min(_CORNER, (high - low) / 2)
        near = [
            w for w in walls if w.axis == axis and abs(w.line - line) <= w.thickness / 2 and min(w.end, high) - max(w.start, low) > least
        ]
        wall = min(near, key=lambda w: abs(w.line - line), default=None)
        lines.append((axis, line + inward * half if wall is None else wall.line + inward * wall.thickness / 2))
    made = []
    for (axis, line), (_, before) in zip(lines, (lines[-1], *lines[:-1]), strict=True):
        made.append((before, line) if axis == "x" else (line, before))
    return made


def _turning(corners: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Returns corners without those in the middle of a straight edge; all of a floor without width, on which none turns."""
    neighbours = zip((corners[-1], *corners[:-1]), corners, (*corners[1:], corners[0]), strict=True)
    return [b for a, b, c in neighbours if not (a[0] == b[0] == c[0] or a[1] == b[1] == c[1])] or list(corners)


def chord(corners: Sequence[tuple[float, float]], axis: Literal["x", "z"], at: float) -> tuple[float, float] | None:
    """Returns the longest stretch along an axis within corners at a coordinate across it."""
    along, across = (0, 1) if axis == "x" else (1, 0)
    crossed = sorted(a[along] for a, b in edges_round(corners) if min(a[across], b[across]) < at < max(a[across], b[across]))
    spans = list(zip(crossed[::2], crossed[1::2], strict=False))
    return max(spans, key=lambda span: span[1] - span[0], default=None)


def clear_size(corners: Sequence[tuple[float, float]]) -> tuple[float, float]:
    """Returns how wide the floor within corners is where it is widest, and how deep where it is deepest, m."""
    return _longest(corners, "x"), _longest(corners, "z")


def _longest(corners: Sequence[tuple[float, float]], axis: Literal["x", "z"]) -> float:
    cuts = sorted({corner[1 if axis == "x" else 0] for corner in corners})
    spans = [chord(corners, axis, (a + b) / 2) for a, b in pairwise(cuts)]
    return max((span[1] - span[0] for span in spans if span), default=0.0)


def label_of(room: PlanRoom) -> RoomLabel:
    """Returns where a room's name stands: least over furniture, next to the middle; in two rows, smaller or upright where it is narrow.

    Its size is written where that costs the name nothing. Where it would leave a room with arms, it stands in the one with most room.
    """
    label = _label_in(room, bounds_of_points(room.corners))
    if _within(label_box(label), room.corners):
        return label
    inside = [one for one in (_label_in(room, box) for box in _rectangles(room.corners)) if _within(label_box(one), room.corners)]
    return max(inside, key=lambda one: (one.size, bool(one.measures), one.small), default=label)


def _rectangles(corners: Sequence[tuple[float, float]]) -> Iterator[PlanBox]:
    """Yields the rectangles between lines of a room's outline that lie within it, the largest first; none where it has many corners."""
    if len(corners) > MOST_CORNERS:
        return
    spans = [[*combinations(sorted({corner[k] for corner in corners}), 2)] for k in (0, 1)]
    boxes = [(x0, z0, x1, z1) for x0, x1 in spans[0] for z0, z1 in spans[1]]
    largest = sorted(boxes, key=lambda box: ((box[0] - box[2]) * (box[3] - box[1]), box))
    yield from (box for box in largest if _within((box[0] + APART, box[1] + APART, box[2] - APART, box[3] - APART), corners))


def _label_in(room: PlanRoom, bounds: PlanBox) -> RoomLabel:
    """Returns where a room's name stands within bounds."""
    area, measures = doubled_area(room.corners) / 2, " × ".join(map(length_of, clear_size(room.corners)))
    x0, z0, x1, z1 = bounds

    def fit(rows: tuple[str, ...], below: str, upright: bool) -> tuple[float, float]:
        """How large the name and what is below it may be, as shares of what they should be."""
        across, along = (0.94 * side / room.letters for side in ((z1 - z0, x1 - x0) if upright else (x1 - x0, z1 - z0)))
        lines, under = len(rows) * LINE, (1 + bool(below)) * LINE * SMALLER
        small = min(1.0, across / _below_wide(below), along / (lines + under))
        return min(small, across / (max(map(len, rows)) * WIDE)), small

    lines = [((room.words,), False), *((rows, False) for rows in _in_two(room.words)), ((room.words,), True)]
    ways = [(rows, below, upright) for below in (measures, "") for rows, upright in lines]
    rows, below, upright = max(ways, key=lambda way: fit(*way)[0] * (_UPRIGHT if way[2] else 1.0))
    size, small = (max(_LEAST_SHRINK, share) * room.letters for share in fit(rows, below, upright))
    small *= SMALLER
    rows = tuple(_cut(row, 0.94 * (z1 - z0 if upright else x1 - x0) / (size * WIDE)) for row in rows)
    wide, high = _extent(rows, below, upright, (size, small))
    best, least = ((x0 + x1) / 2, (z0 + z1) / 2), float("inf")
    for i in _STEPS:
        x = x0 + wide / 2 + i * max(0.0, x1 - x0 - wide)
        for j in _STEPS:
            z = z0 + high / 2 + j * max(0.0, z1 - z0 - high)
            cost = 0.05 * wide * (abs(i - 0.5) + abs(j - 0.5))
            if cost >= least:
                continue
            box = (x - wide / 2, z - high / 2, x + wide / 2, z + high / 2)
            cost += covered(box, room.obstacles) + (0.0 if _within(box, room.corners) else 10.0)
            if cost < least:
                best, least = (x, z), cost
    return RoomLabel(room.plate, rows, area, below, *best, upright, size, small)


def _in_two(words: str) -> list[tuple[str, ...]]:
    """Returns a name of several words in two rows, the longer as short as can be."""
    cuts = [(words[:at], words[at + 1 :]) for at, letter in enumerate(words) if letter == " "]
    return [min(cuts, key=lambda rows: max(map(len, rows)))] if cuts else []


def _cut(row: str, letters: float) -> str:
    """Returns a row of words with no more letters than its room has space for, one at least."""
    return row if len(row) <= letters + APART else row[: max(1, int(letters) - 1)].rstrip() + "…"


def _below_wide(measures: str) -> float:
    """Returns how wide what is below a name is, as a multiple of the letters' height above it."""
    return max(7 * WIDE, len(measures) * _DIGIT) * SMALLER


def _extent(rows: tuple[str, ...], measures: str, upright: bool, sizes: tuple[float, float]) -> tuple[float, float]:
    """Returns how wide and high a name and what is below it are, m, by their letters' heights."""
    size, small = sizes
    wide = max(_below_wide(measures) / SMALLER * small, *(len(row) * WIDE * size for row in rows))
    high = (len(rows) * size + (1 + bool(measures)) * small) * LINE
    return (high, wide) if upright else (wide, high)


def label_box(label: RoomLabel) -> PlanBox:
    """Returns the floor that a label takes."""
    wide, high = _extent(label.rows, label.measures, label.upright, (label.size, label.small))
    return label.x - wide / 2, label.z - high / 2, label.x + wide / 2, label.z + high / 2


def length_of(metres: float) -> str:
    """Returns a length to the millimetre as drawings write it: metres, and millimetres beside whole centimetres raised."""
    centimetres, rest = divmod(round(metres * 1000), 10)
    return f"{centimetres // 100}.{centimetres % 100:02d}{_RAISED[rest]}"


def number_box(metres: float, size: float) -> tuple[float, float]:
    """Returns how wide and high a length is when written, m."""
    return len(length_of(metres)) * _DIGIT * size, size


def covered(box: PlanBox, obstacles: Iterable[Obstacle]) -> float:
    """Returns how much of a box obstacles cover, m2, each as often as it is worse; twice what two cover."""
    x0, z0, x1, z1 = box
    total = 0.0
    for a, b, c, d, worse in obstacles:
        if a < x1 and x0 < c and b < z1 and z0 < d:
            total += ((x1 if x1 < c else c) - (x0 if x0 > a else a)) * ((z1 if z1 < d else d) - (z0 if z0 > b else b)) * worse
    return total


def _within(box: PlanBox, corners: Sequence[tuple[float, float]]) -> bool:
    if len(corners) == 4:
        return True
    x0, z0, x1, z1 = box
    spans = (chord(corners, "x", z0), chord(corners, "x", (z0 + z1) / 2), chord(corners, "x", z1))
    return all(span is not None and span[0] <= x0 and x1 <= span[1] for span in spans)


NEAREST: Final = 0.05
"""Marks of a chain that are closer than this, m, are one."""
Facade = Literal["north", "west", "south", "east"]
SIDES: Final[tuple[Facade, ...]] = ("north", "west", "south", "east")


@dataclass(frozen=True)
class Facades:
    """A storey seen from outside: its floors, its openings, half the usual thickness of its walls and the boxes of those, m."""

    plates: Sequence[FloorPlate]
    openings: Sequence[PlacedOpening]
    half: float
    walls: Sequence[PlanBox] = ()

    def bounds(self) -> PlanBox:
        """Returns what the storey covers, outer walls included."""
        xs = [x for plate in self.plates for x, _ in plate.corners]
        zs = [z for plate in self.plates for _, z in plate.corners]
        lines = min(xs) - self.half, min(zs) - self.half, max(xs) + self.half, max(zs) + self.half
        x0, z0, x1, z1 = zip(lines, *self.walls, strict=True)
        return min(x0), min(z0), max(x1), max(z1)


def chains_of(facades: Facades, gap: float) -> list[Dimension]:
    """Returns the chains of all four sides, `gap` metres apart, the first twice as far from the walls; the whole is north and west."""
    x0, z0, x1, z1 = facades.bounds()
    found = []
    for side in SIDES:
        axis: Literal["x", "z"] = "x" if side in ("north", "south") else "z"
        low, high = (x0, x1) if axis == "x" else (z0, z1)
        rows = [stops for stops in (_openings(facades, side, low, high), _rooms(facades, side, low, high)) if len(stops) > 2]
        if side in ("north", "west"):
            rows.append((low, high))
        edge, away = {"north": (z0, -1), "south": (z1, 1), "west": (x0, -1), "east": (x1, 1)}[side]
        found += [chain(axis, edge + away * gap * (index + 1.6), stops) for index, stops in enumerate(dict.fromkeys(rows))]
    return found


def chain(axis: Literal["x", "z"], at: float, stops: tuple[float, ...]) -> Dimension:
    """Returns a chain with its numbers in the middle of their lengths."""
    return Dimension(axis, at, stops, tuple((a + b) / 2 for a, b in pairwise(stops)))


def too_short(metres: float, size: float) -> bool:
    """Tells whether a number does not fit over its own length."""
    return number_box(metres, size)[0] > metres * 0.96


def _openings(facades: Facades, side: Facade, low: float, high: float) -> tuple[float, ...]:
    axis = "x" if side in ("north", "south") else "z"
    indoors = {plate.id for plate in facades.plates if not plate.outdoor}
    stops = [low, high]
    for opening in facades.openings:
        greater, smaller = opening.rooms
        inside, outside = (greater, smaller) if side in ("north", "west") else (smaller, greater)
        if opening.axis == axis and inside in indoors and outside not in indoors:
            stops += [opening.start, opening.end]
    return _apart(stops)


def _rooms(facades: Facades, side: Facade, low: float, high: float) -> tuple[float, ...]:
    """Returns where the rooms end that one sees from a side: the lines of the walls between them, outer faces at the ends."""
    walls = ((plate.id, *wall) for plate in facades.plates for wall in walls_round(plate.corners))
    edges = [(start, end, line * INWARDS[side], room) for room, wall, line, start, end in walls if wall == side]
    cuts = sorted({end for edge in edges for end in edge[:2]})
    stops, last = [low, high], None
    for start, end in pairwise(cuts):
        seen = min(((line, room) for a, b, line, room in edges if a <= start and end <= b), default=None)
        if seen != last and last is not None:
            stops.append(start)
        last = seen
    return _apart(stops)


def _apart(stops: Sequence[float]) -> tuple[float, ...]:
    """Returns marks in order, those that nearly meet as one; the outermost stay."""
    low, *middle, high = sorted(stops)
    kept = [low]
    for stop in middle:
        if stop - kept[-1] > NEAREST and high - stop > NEAREST:
            kept.append(stop)
    return (*kept, high)
