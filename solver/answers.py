"""The words and keys of answers: scenes with what breaks a rule, how far what was moved, repairs of a conflict, what ended the search.

Of somebody's own plan what was guessed: the types of its rooms, its main entrance. Of an import everything that is not as the file says. Of
an explanation why a piece stands where it does.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Final, Literal

from solver.fields import OMITTED, Like, Name, Number, OneOf, Record, Says
from solver.scene import Scene

ON_CONFLICT: Final = ("report", "remove")
"""What becomes of what cannot stand in a repaired scene."""
SEVERITIES: Final = ("error", "warning")


@dataclass(frozen=True)
class Freed(Record):
    """A repair: `wall` becomes null, for the body need not stand at one; /fix then moves it.

    Args:
        action: "move".
        id: of the body.
        wall: null.
        dx, dz: how far it then goes, m.
        rotation: that it then has, degrees.
    """

    action: Literal["move"]
    id: str
    wall: None
    dx: float
    dz: float
    rotation: float


@dataclass(frozen=True)
class Unlocked(Record):
    """A repair: the body is unlocked; /fix then moves it.

    Args:
        action: "unlock".
        id: of the body.
        dx, dz: how far it then goes, m.
        rotation: that it then has, degrees.
    """

    action: Literal["unlock"]
    id: str
    dx: float
    dz: float
    rotation: float


@dataclass(frozen=True)
class Turned(Record):
    """A repair: another rotation.

    Args:
        action: "turn".
        id: of the body.
        rotation: the other one, degrees.
    """

    action: Literal["turn"]
    id: str
    rotation: float


@dataclass(frozen=True)
class Shrunk(Record):
    """A repair: another size.

    Args:
        action: "shrink".
        id: of the body.
        width: across its front, m.
        depth: from its front to its back, m.
    """

    action: Literal["shrink"]
    id: str
    width: float
    depth: float


@dataclass(frozen=True)
class LeftOut(Record):
    """A repair: the scene without the body.

    Args:
        action: "leave_out".
        id: of the body.
    """

    action: Literal["leave_out"]
    id: str


@dataclass(frozen=True)
class Removal(Record):
    """A body that was taken out, and why.

    Args:
        id: of the body.
        reason: the rule that it broke, or what keeps it from standing there, in words.
    """

    id: str
    reason: str


@dataclass(frozen=True)
class Limited(Record):
    """The limit of the call's work ended a search: what stands is sound, but more may be found with more work.

    `work` is the limit that its `effort` has: a count, the same on every machine.
    """

    effort: str
    work: int
    message: str


OfferedRepair = Freed | Unlocked | Turned | Shrunk | LeftOut
"""A change of the scene with which the rest can stand; README.md says what to do with each."""


@dataclass(frozen=True)
class Issue(Record):
    """One broken rule: its name, the room's id, the ids of the bodies, and by how much, m."""

    rule: str
    severity: Annotated[str, OneOf(*SEVERITIES)]
    room: str | None
    ids: tuple[str, ...]
    amount: float
    message: str


@dataclass(frozen=True)
class Conflict(Record):
    """Bodies that cannot stand together, why, and what would help."""

    ids: tuple[str, ...]
    message: str
    repairs: tuple[Annotated[Mapping[str, object], Like(OfferedRepair)], ...] = ()


@dataclass(frozen=True)
class Move(Record):
    """How far /fix moved a body, m, and the rotation it has now, degrees."""

    id: str
    dx: float
    dz: float
    rotation: float


@dataclass(frozen=True)
class Pose(Record):
    """Where a body was in the last answer of /fix.

    Args:
        id: of the body.
        x, z: its footprint's centre in its room, m.
        rotation: degrees.
    """

    id: Name
    x: Number
    z: Number
    rotation: Number = 0


@dataclass(frozen=True)
class Generated(Record):
    """The answer of generate: the scene, what the validator says, and stage times in ms."""

    scene: Scene
    issues: tuple[Issue, ...]
    timing_ms: Mapping[str, float]
    limited: Limited | None = field(default=None, metadata={OMITTED: True})


@dataclass(frozen=True)
class Fixed(Record):
    """The answer of fix."""

    scene: Scene
    moves: tuple[Move, ...]
    removed: tuple[Annotated[Mapping[str, str], Like(Removal)], ...]
    conflicts: tuple[Conflict, ...]
    issues: tuple[Issue, ...]
    timing_ms: Mapping[str, float]
    understood_as: Mapping[str, str] = field(default_factory=dict)
    """By id, what a piece was taken for that is called by no name of the catalogs."""
    limited: Limited | None = field(default=None, metadata={OMITTED: True})


GUESSED_BY: Final = ("name", "pieces", "form")
"""What a room's type was told from: what it is called, what stands in it, its floor, doors, windows and neighbours."""
KEEPS: Final = ("all", "locked", "none")
"""What stays in rooms that are furnished."""


@dataclass(frozen=True)
class RoomGuess(Record):
    """The type that a room was given: what it was called, what told the type, and the type that would suit it next, if any."""

    room: str
    type: str
    by: Annotated[str, OneOf(*GUESSED_BY)]
    sent: str
    instead: Annotated[str | None, Says("the room type that suits next best, where the room's form told the type")]
    message: str


@dataclass(frozen=True)
class ChosenEntrance(Record):
    """The door that was chosen as the main entrance of a home that had none, and its room."""

    id: str
    room: str
    message: str


@dataclass(frozen=True)
class FurnishedPlan(Record):
    """The answer of furnish: the scene, what was guessed, which rooms could not be furnished and why, issues, and stage times in ms."""

    scene: Scene
    guesses: tuple[RoomGuess, ...]
    entrance: ChosenEntrance | None
    left: Annotated[Mapping[str, str], Says("by room id, why a room that was asked for was left as it was")]
    issues: tuple[Issue, ...]
    timing_ms: Mapping[str, float]
    limited: Limited | None = field(default=None, metadata={OMITTED: True})


HOLDERS = ("wall", "piece", "use_side", "door", "window", "outline", "floor", "way", "relation")
"""What may hold a piece."""
FloorPoint = Annotated[tuple[float, float], Says("x, z of the footprint's centre in the room, m")]


@dataclass(frozen=True)
class Hold(Record):
    """What keeps a piece from going on in one direction, and what a metre more room there would save.

    `by` is the id of a piece or an opening, or null; `what` is `use_side` where it is the floor that a person needs to use that piece,
    `floor` where it is floor at a side of that piece that is better kept free.
    """

    by: str | None
    what: Annotated[str, OneOf(*HOLDERS)]
    towards: Annotated[str, OneOf("north", "east", "south", "west")]
    cost_per_m: float
    message: str


@dataclass(frozen=True)
class MovedPiece(Record):
    """How a piece would stand: its footprint's centre in the room, m, its rotation, degrees, and its kind, perhaps another size of it.

    `y` is its underside, m, and `on` what it would stand on.
    """

    id: str
    kind: str
    x: float
    y: float
    z: float
    rotation: int
    width: float
    depth: float
    height: float
    on: str | None


@dataclass(frozen=True)
class OtherWay(Record):
    """Another way to stand: at which wall and how it is turned, and what the room would have cost more with it; null: it could not.

    `moves` is all that would then stand elsewhere, the piece itself too; `left_out` who would have no place.
    """

    wall: Annotated[str, OneOf("north", "east", "south", "west")] | None
    rotation: int
    cost: float | None
    moves: tuple[MovedPiece, ...]
    left_out: tuple[str, ...]
    message: str


@dataclass(frozen=True)
class Explained(Record):
    """Why a piece stands where it does: where it was wished, what holds it back from there, and how else it could stand."""

    id: str
    room: str
    stands: FloorPoint
    wished: FloorPoint | None
    holds: tuple[Hold, ...]
    notes: tuple[str, ...]
    ways: tuple[OtherWay, ...] = ()


UNITS: Final = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}
"""Units of files by name, m."""
ALLOWED_UNITS: Final = f"{', '.join(UNITS)}, or a number of metres"


@dataclass(frozen=True)
class ImportSettings(Record):
    """What the caller says: the level to take (None: the lowest with rooms), the unit, whether furniture comes along."""

    level: int | None = None
    unit: str | None = None
    furniture: bool = True


@dataclass(frozen=True)
class ImportChange(Record):
    """Something that is not as it was drawn: in which step, of what (a room's or opening's id, or `plan`), by how much, m."""

    step: str
    of: str
    amount: float
    message: str


@dataclass(frozen=True)
class ImportGuess(Record):
    """Something that the file does not say: of what (an id, or `plan`), which key, what was taken."""

    of: str
    what: str
    taken: str
    message: str


@dataclass(frozen=True)
class Unread(Record):
    """Something that was left out: its place in the file, and why."""

    place: str
    reason: str


@dataclass(frozen=True)
class PlanImport(Record):
    """A foreign plan as a scene; `format` is what the file was read as.

    `changes`, `guesses` and `unread` say what is not as in the file; `understood_as`, by id, what foreign names were taken for.
    """

    scene: Scene
    format: str
    changes: tuple[Annotated[Mapping[str, object], Like(ImportChange)], ...]
    guesses: tuple[Annotated[Mapping[str, str], Like(ImportGuess)], ...]
    unread: tuple[Annotated[Mapping[str, str], Like(Unread)], ...]
    issues: tuple[Issue, ...]
    understood_as: Mapping[str, str] = field(default_factory=dict)
