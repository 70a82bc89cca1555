"""A drawing of shapes on layers, as CAD programmes and SVG keep it -> a plan: what a shape is, its layer's or its own name tells.

Closed shapes on layers of rooms are rooms, named by the text inside them; shapes on layers of doors, windows and openings are openings,
as long as their longer side. Other layers are passed over, and told. Comes in: `DrawnShape`s. Goes out: a `DrawnPlan`. May import: drawn.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from typing import Final, Literal, NamedTuple

from solver.imported import Unread
from solver.imports.drawn import MOST_POINTS, DrawnOpening, DrawnPlan, DrawnRoom, DrawnWall, OpeningKind, Spot, check_count

WORDS: Final[dict[str, tuple[str, ...]]] = {
    "garage_door": ("garage_door", "garagedoor"),
    "window": ("window", "fenster", "fenetre", "ventana", "finestra", "glaz"),
    "door": ("door", "tür", "tuer", "porte", "puerta", "porta"),
    "passage": ("opening", "passage", "durchgang"),
    "wall": ("wall", "wand", "mur", "pared", "parete", "muro"),
    "room": ("room", "space", "raum", "zimmer", "piece", "habitacion", "stanza", "zone"),
}  # fmt: skip
"""What a layer or a shape is, by words in its name; the first that fits."""
WIDER: Final = 1.4
"""A door's opening may be so many times as wide as its leaf."""
SAME: Final = 0.6
"""Openings whose middles are nearer than this share of their length are one, drawn in several lines."""


DrawnBox = tuple[float, float, float, float]


class DrawnShape(NamedTuple):
    """A shape: its name and its layers' names, its points, whether it is closed, its place in the file."""

    names: str
    points: tuple[Spot, ...]
    closed: bool
    where: str


class DrawnSwing(NamedTuple):
    """The arc that a door's leaf sweeps: its hinge, its two ends, its place in the file."""

    hinge: Spot
    ends: tuple[Spot, Spot]
    where: str


class DrawnText(NamedTuple):
    """A text and where it stands."""

    words: str
    x: float
    z: float


def plan_of_shapes(
    shapes: Sequence[DrawnShape], texts: Sequence[DrawnText], swings: Sequence[DrawnSwing], metres: float | None, unread: Sequence[Unread]
) -> DrawnPlan:
    """Returns the plan that shapes draw.

    Raises:
        FieldError: there are more shapes than in any home.
    """
    check_count("shapes", len(shapes), MOST_POINTS)
    sorts = [sort_of(shape.names) for shape in shapes]
    rooms = [_room(one, texts) for one, sort in zip(shapes, sorts, strict=True) if sort == "room" and one.closed and len(one.points) > 2]
    walls = [
        DrawnWall(a, b, 0.0, one.where)
        for one, sort in zip(shapes, sorts, strict=True) if sort == "wall" and not one.closed
        for a, b in zip(one.points, one.points[1:], strict=False)
    ]  # fmt: skip
    solid = [_box(one.points) for one, sort in zip(shapes, sorts, strict=True) if sort == "wall" and one.closed]
    doors = [_swinging(swing, rooms, solid) for swing in swings]
    drawn = [one for one in _openings(shapes, sorts) if not any(_is_leaf(one, swing) for swing in swings)]
    openings = [one for one in drawn if not any(_is_one((one.start, one.end), (door.start, door.end)) for door in doors)]
    left = Counter(one.names for one, sort in zip(shapes, sorts, strict=True) if sort is None)
    told = [
        Unread(f"layer {name!r:.60}", f"{count} shapes: its name tells neither rooms nor openings") for name, count in sorted(left.items())
    ]
    return DrawnPlan(
        tuple(rooms), (*doors, *openings), tuple(walls), metres=metres, drawn="lines", unread=(*unread, *told)
    )  # fmt: skip


def sort_of(names: str) -> str | None:
    """Returns what the names of a shape and its layers tell."""
    small = names.lower()
    return next((sort for sort, words in WORDS.items() if any(word in small for word in words)), None)


def _room(shape: DrawnShape, texts: Sequence[DrawnText]) -> DrawnRoom:
    inside = [text.words for text in texts if _holds(shape.points, text.x, text.z) and not any(letter.isdigit() for letter in text.words)]
    own = shape.names.split("/")[-1]
    return DrawnRoom(shape.points, inside[0] if inside else "" if sort_of(own) == "room" else own, shape.where)


def _holds(points: Sequence[Spot], x: float, z: float) -> bool:
    inside = False
    for (x0, z0), (x1, z1) in zip(points, (*points[1:], *points[:1]), strict=True):
        if (z0 > z) != (z1 > z) and x < x0 + (z - z0) / (z1 - z0) * (x1 - x0):
            inside = not inside
    return inside


def _openings(shapes: Sequence[DrawnShape], sorts: Sequence[str | None]) -> list[DrawnOpening]:
    """Returns openings, each once: the longest of what is drawn in one place; a hole with a leaf in it is a door."""
    found: list[tuple[OpeningKind, Spot, Spot, str]] = []
    for kind in ("window", "garage_door", "passage", "door"):
        drawn = [(*_longer(one.points), one.where) for one, sort in zip(shapes, sorts, strict=True) if sort == kind]
        for start, end, where in sorted(drawn, key=lambda one: -math.dist(one[0], one[1])):
            near = next((at for at, one in enumerate(found) if _is_one(one[1:3], (start, end))), None)
            if near is None and math.dist(start, end) > 0:
                found.append((kind, start, end, where))
            elif near is not None and kind == "door" and found[near][0] == "passage":
                found[near] = ("door", *found[near][1:])
    return [DrawnOpening(*one) for one in found]


def _swinging(swing: DrawnSwing, rooms: Sequence[DrawnRoom], walls: Sequence[DrawnBox]) -> DrawnOpening:
    """Returns the door of an arc: shut, its leaf lies at a wall; it is as wide as the gap between pieces of wall there, if there is one."""
    shut, opened = sorted(swing.ends, key=lambda end: (_to_wall(end, rooms), end))
    along = 0 if abs(shut[0] - swing.hinge[0]) >= abs(shut[1] - swing.hinge[1]) else 1
    low, high = sorted((swing.hinge[along], shut[along]))
    middle, across, width = (low + high) / 2, (swing.hinge[1 - along] + shut[1 - along]) / 2, high - low
    there = [(box[along], box[along + 2]) for box in walls if box[1 - along] - width / 2 <= across <= box[3 - along] + width / 2]
    before = max((end for _, end in there if end <= middle), default=low)
    after = min((start for start, _ in there if start >= middle), default=high)
    if width <= after - before <= WIDER * width:
        low, high = before, after
    ends = ((low, across), (high, across)) if along == 0 else ((across, low), (across, high))
    hinge: Literal["start", "end"] = "start" if swing.hinge[along] < middle else "end"
    return DrawnOpening("door", *ends, swing.where, hinge=hinge, towards=opened)


def _to_wall(spot: Spot, rooms: Sequence[DrawnRoom]) -> float:
    """Returns how far a point is from the nearest outline of a room."""
    return min(
        (_to_line(spot, a, b) for room in rooms for a, b in zip(room.points, (*room.points[1:], *room.points[:1]), strict=True)),
        default=0.0,
    )


def _to_line(spot: Spot, a: Spot, b: Spot) -> float:
    length = math.dist(a, b) ** 2
    share = 0.0 if not length else ((spot[0] - a[0]) * (b[0] - a[0]) + (spot[1] - a[1]) * (b[1] - a[1])) / length
    share = min(max(share, 0.0), 1.0)
    return math.dist(spot, (a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])))


def _is_leaf(one: DrawnOpening, swing: DrawnSwing) -> bool:
    """Tells whether an opening is a door's leaf, drawn open or shut."""
    radius = math.dist(swing.hinge, swing.ends[0])
    return one.kind == "door" and any(_is_one((one.start, one.end), (swing.hinge, end)) for end in swing.ends if radius)


def _box(points: Sequence[Spot]) -> DrawnBox:
    xs, zs = [x for x, _ in points], [z for _, z in points]
    return min(xs), min(zs), max(xs), max(zs)


def _is_one(kept: tuple[Spot, Spot], other: tuple[Spot, Spot]) -> bool:
    (a, b), (c, d) = ((((one[0][0] + one[1][0]) / 2), ((one[0][1] + one[1][1]) / 2)) for one in (kept, other))
    (x, z), length = ((a - c), (b - d)), max(math.dist(*kept), math.dist(*other))
    return math.hypot(x, z) < SAME * length


def _longer(points: Sequence[Spot]) -> tuple[Spot, Spot]:
    """Returns the middle line of the box around points, along its longer side."""
    xs, zs = [x for x, _ in points], [z for _, z in points]
    x0, x1, z0, z1 = min(xs), max(xs), min(zs), max(zs)
    if x1 - x0 >= z1 - z0:
        return (x0, (z0 + z1) / 2), (x1, (z0 + z1) / 2)
    return ((x0 + x1) / 2, z0), ((x0 + x1) / 2, z1)
