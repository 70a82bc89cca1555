"""What a floor plan's file draws, before anything is changed: rooms, walls, openings, pieces, in the file's own unit.

Frame: x east, z south (readers of files whose y points north turn it round), in the file's unit; turns as in scenes.
`where` names the place in the file, for whoever has to be told: `features[3]`, `Home.xml line 40, room`.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Final, Literal, NamedTuple

from solver.answers import ImportChange, ImportGuess, Unread
from solver.errors import FieldError
from solver.geometry import doubled_area, encloses

Spot = tuple[float, float]
"""A point (x, z)."""
DrawnAlong = Literal["lines", "inner", "unsaid"]
"""What room outlines are drawn along: the middle lines of walls, or the inner faces; unsaid: to be measured between the rooms."""
OpeningKind = Literal["door", "garage_door", "passage", "window"]


@dataclass(frozen=True)
class DrawnRoom:
    """A room's outline; `label` is what the file calls it, `type` what it is where the file says that in our words or its own.

    `outdoor` None: the file does not say. `floor` is the colour of its floor, where the file names one. `holes` are outlines in it.
    `outer` is how thick its outer walls are, by the sides of its outline, where the file says that; None where they are as the others.
    """

    points: tuple[Spot, ...]
    label: str
    where: str
    type: str = ""
    level: int = 0
    outdoor: bool | None = None
    id: str = ""
    floor: str | None = None
    holes: tuple[tuple[Spot, ...], ...] = ()
    outer: tuple[float | None, ...] = ()
    found: bool = False
    """It is not drawn: thick walls enclose it."""

    def as_exported(self, said: Mapping[str, str]) -> "DrawnRoom":
        """Returns the room with what our own export says beside its `label`: `type`, `outdoor`, and a `name` if it has one.

        One that was called by other words since is what these say.
        """
        if "type" not in said or self.label not in said.get("label", ""):
            return self
        return replace(self, type=said["type"], label=said.get("name", ""), outdoor=said.get("outdoor", "").lower() == "true")

    @property
    def area(self) -> float:
        """How large its floor is, without the holes."""
        outer, *inner = (abs(doubled_area(points)) / 2 for points in (self.points, *self.holes))
        return outer - sum(inner)

    def holds(self, x: float, z: float) -> bool:
        """Tells whether a point is in the room."""
        return encloses(self.points, x, z) and not any(encloses(hole, x, z) for hole in self.holes)


@dataclass(frozen=True)
class DrawnWall:
    """A straight piece of wall along its middle line, `thickness` in the file's unit."""

    start: Spot
    end: Spot
    thickness: float
    level: int = 0
    low: bool = False
    """It is no higher than a railing."""


@dataclass(frozen=True)
class DrawnOpening:
    """A door, passage or window along its wall, from `start` to `end`.

    `height` and `sill` in the file's unit, None where it does not say; `hinge` is the end that carries the leaf, `towards` a point on
    the side that it swings to. `main_entrance` None: the file does not know the word. `rooms` are ids of rooms, where it names them.
    """

    kind: OpeningKind
    start: Spot
    end: Spot
    where: str
    height: float | None = None
    sill: float | None = None
    level: int = 0
    hinge: Literal["start", "end"] | None = None
    towards: Spot | None = None
    main_entrance: bool | None = None
    rooms: tuple[str, ...] = ()
    id: str = ""
    unsaid: bool = False
    """The file says no more of it than that it is an opening."""


@dataclass(frozen=True)
class DrawnPiece:
    """A thing in the plan: its footprint's middle, its underside `y` above the level's floor, sizes in the file's unit, a turn in degrees.

    `size` None: the file does not say; then its `height` may be known, and how high its `middle` is, in place of `y`; `usual`: it has
    its kind's. `kind` is the key of a kind of ours, where the file names one, `on` the place of what the file says it lies on.
    """

    name: str
    x: float
    z: float
    y: float
    rotation: float
    size: tuple[float, float, float] | None
    where: str
    level: int = 0
    color: str | None = None
    id: str = ""
    decoration: bool = False
    kind: str | None = None
    height: float | None = None
    middle: float | None = None
    on: str = ""
    usual: bool = False


class DrawnText(NamedTuple):
    """A text without its lines of numbers, where it stands, what it plainly names: a room type, or another use of a room; an area, m2.

    `storey` is which one it tells, as a title does, from the lowest on; `of_piece`: a piece may be called so, too, as a bed.
    """

    words: str
    x: float
    z: float
    means: str = ""
    area: float = 0.0
    storey: int | None = None
    of_piece: bool = False
    level: int = 0


class DrawnLevel(NamedTuple):
    """A storey: its number, its name, its floor's elevation and its height in the file's unit; None where the file does not say."""

    number: int
    name: str = ""
    elevation: float | None = None
    height: float | None = None


@dataclass(frozen=True)
class DrawnPlan:
    """A file's plan.

    `metres` is the length of its unit, None where it does not say; `drawn` what rooms are drawn along; `wall_thickness` in its unit.
    """

    rooms: tuple[DrawnRoom, ...]
    openings: tuple[DrawnOpening, ...] = ()
    walls: tuple[DrawnWall, ...] = ()
    pieces: tuple[DrawnPiece, ...] = ()
    levels: tuple[DrawnLevel, ...] = ()
    metres: float | None = 1.0
    drawn: DrawnAlong = "lines"
    wall_thickness: float | None = None
    unread: tuple[Unread, ...] = ()
    unit_words: str = ""
    """What the unit was taken from, where the file does not say it itself."""
    turned: float = 0.0
    """By how many degrees it was turned already, counter-clockwise, so that its walls run along x and z."""
    solid: tuple[DrawnWall, ...] = ()
    """Pieces of wall that tell how thick walls are, not where there are none."""
    faces: tuple[tuple[Spot, Spot], ...] = ()
    """Lines along the faces of walls: two that look away from each other have a wall between them."""
    texts: tuple[DrawnText, ...] = ()
    """What names the rooms that it stands in."""
    layers: tuple[str, ...] = ()
    """The names of a drawing's layers, those with most on them first."""


@dataclass
class PlanNotes:
    """What is said about an import, gathered on the way."""

    changes: list[ImportChange] = field(default_factory=list)
    guesses: list[ImportGuess] = field(default_factory=list)
    unread: list[Unread] = field(default_factory=list)

    def change(self, step: str, of: str, amount: float, message: str) -> None:
        """Notes something that is not as it was drawn; `amount` in m."""
        self.changes.append(ImportChange(step, of, round(amount, 4), message))

    def guess(self, of: str, what: str, taken: str, message: str) -> None:
        """Notes something that the file does not say."""
        self.guesses.append(ImportGuess(of, what, taken, message))

    def leave(self, place: str, reason: str) -> None:
        """Notes something that is left out."""
        self.unread.append(Unread(place, reason))


MOST_ROOMS: Final = 500
MOST_POINTS: Final = 5_000
"""FloorCorners of all rooms together; and walls, openings and pieces each. Our choices: a house has a hundredth of it."""


def check_count(what: str, count: int, most: int) -> None:
    """Refuses a plan that holds more of something than a house can have.

    Raises:
        FieldError: it does.
    """
    if count > most:
        raise FieldError(what, f"are {count:,}", f"at most {most:,}")


class Tally:
    """Counts what is read of a plan, so that one larger than any house is refused before all of it is read."""

    def __init__(self) -> None:
        self._counts: Counter[str] = Counter()

    def add(self, what: str, count: int = 1, most: int = MOST_POINTS) -> None:
        """Counts what is about to be read.

        Raises:
            FieldError: it is more than a house can have.
        """
        self._counts[what] += count
        check_count(what, self._counts[what], most)


def check_plan(plan: DrawnPlan) -> None:
    """Refuses a plan that is larger than any house.

    Raises:
        FieldError: it is.
    """
    check_count("rooms", len(plan.rooms), MOST_ROOMS)
    check_count("corners of rooms", sum(len(room.points) for room in plan.rooms), MOST_POINTS)
    sets: Sequence[tuple[str, int]] = (
        ("walls", len(plan.walls) + len(plan.solid)), ("openings", len(plan.openings)), ("furniture", len(plan.pieces)),
    )  # fmt: skip
    for what, count in sets:
        check_count(what, count, MOST_POINTS)
