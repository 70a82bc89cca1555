"""The words and keys of answers: scenes with what breaks a rule, how far what was moved, repairs of a conflict, what ended the search.

And of somebody's own plan what was guessed: the types of its rooms, its main entrance.
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
