"""What each call takes and answers: declared once, for the reader, the OpenAPI document, refusals and the page's types."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, ClassVar, Final

from annotated_types import Ge, Le, MaxLen, MinLen

from service.effort import EFFORTS, NORMAL
from solver.answers import ALLOWED_UNITS, KEEPS, ON_CONFLICT, Conflict, ImportSettings, Issue, Limited, Pose
from solver.exchange import SentRoom, SentScene
from solver.export_formats import FREEDOMS
from solver.fields import OMITTED, WHOLE, Flag, Free, Like, OneOf, PositiveMetres, Record, Says, Text, Whole, counted
from solver.request import MAX_COUNT, Seed
from solver.requested import MOST_ALTERNATIVES, MOST_PIECES, Held, PieceRequest, Placement, Unplaced
from solver.scene import ROBOT_WIDTH, RobotWidth, Scene, WallThickness

Ids = Annotated[tuple[Text, ...], Says("ids")]
Effort = Annotated[str, OneOf(*EFFORTS), Says("how much work the call may do")]


@dataclass(frozen=True)
class RerollBody(Record):
    """Furnishes some rooms of a scene anew."""

    camel_case: ClassVar[bool] = True

    scene: SentScene
    reroll: Annotated[tuple[Text, ...], MinLen(1), Says("ids of the rooms to furnish anew")]
    seed: Annotated[Seed | None, Says("drawn where there is none")] = None
    effort: Effort = NORMAL


@dataclass(frozen=True)
class FurnishBody(Record):
    """Furnishes rooms of a plan: those named, else the empty ones where `keep` is all, else every room.

    Args:
        keep: what stays in these rooms.
        style: of the home; the scene's own where there is none, else one of the seed's.
    """

    camel_case: ClassVar[bool] = True

    scene: SentScene
    rooms: Annotated[tuple[Text, ...], Says("ids of the rooms to furnish")] = ()
    keep: Annotated[str, OneOf(*KEEPS)] = KEEPS[0]
    types: Annotated[Mapping[Text, Text], Says("room types by room id, instead of what the scene says")] = field(default_factory=dict)
    program: Annotated[Mapping[str, int] | str | None, counted(MAX_COUNT), Says("what rooms the home has, to guess by")] = None
    style: Text | None = None
    decorate: Annotated[Flag | None, Says("as the scene's request says where there is none")] = None
    access: Annotated[Text | None, Says("a profile of access.yaml, or none; as the scene's request says where there is none")] = None
    seed: Annotated[Seed | None, Says("the scene's own where there is none, else drawn")] = None
    effort: Effort = NORMAL


@dataclass(frozen=True)
class RestyleBody(Record):
    """Gives a scene another style, or other decorations; its furniture stays where it stands."""

    camel_case: ClassVar[bool] = True

    scene: SentScene
    style: Annotated[Text | None, Says("stays where there is none")] = None
    decorate: Annotated[Flag | None, Says("whether to decorate every room, or none; as it was where it is not said")] = None


@dataclass(frozen=True)
class FixBody(Record):
    """Repairs a scene.

    Args:
        locked: ids of bodies that stay to the millimetre.
        moved: ids of bodies that are held most strongly.
        on_conflict: what becomes of what cannot stand.
        previous: poses of the last answer.
        dragging: whether this is a frame of a drag.
    """

    camel_case: ClassVar[bool] = True

    scene: SentScene
    locked: Ids = ()
    moved: Ids = ()
    on_conflict: Annotated[str, OneOf(*ON_CONFLICT)] = ON_CONFLICT[0]
    previous: tuple[Pose, ...] = ()
    dragging: Flag = False
    effort: Effort = NORMAL


@dataclass(frozen=True)
class DragBody(Record):
    """Takes a piece in hand: its room is prepared for frames of a drag.

    Args:
        id: of the piece.
        locked: ids of bodies that stay.
    """

    scene: SentScene
    id: Text
    locked: Ids = ()


@dataclass(frozen=True)
class DragAnswer(Record):
    """The room prepared for the core (base64), and all that is in it in the order of a frame; null where /fix has to be asked instead."""

    opening: Text | None
    bodies: tuple[Text, ...]


@dataclass(frozen=True)
class ImportQuery(Record):
    """How a foreign floor plan is read; with a file that is sent as it is, it stands in the query."""

    name: Annotated[Text, Says("the file's name, where it has one")] = ""
    level: Annotated[Whole | None, Says("the storey to take; by default the lowest with rooms")] = None
    unit: Annotated[Text | None, Says(f"of the file: {ALLOWED_UNITS}")] = None
    furniture: Annotated[str, OneOf("keep", "none"), Says("whether the file's furniture comes along")] = "keep"

    @property
    def settings(self) -> ImportSettings:
        """The same as the reader of plans takes it."""
        return ImportSettings(self.level, self.unit, self.furniture == "keep")


USUAL_READING: Final = ImportQuery()


@dataclass(frozen=True)
class ImportBody(ImportQuery):
    """A foreign floor plan: `file` holds a file's bytes in base64, or `document` what a JSON file says; one of the two."""

    file: Annotated[Text | None, Says("the file in base64")] = None
    document: Annotated[Free | None, Says("the document that a JSON file holds")] = None


@dataclass(frozen=True)
class PlaceBody(Record):
    """Places pieces in a room.

    Args:
        pieces: what is wanted in it.
        alternatives: how many placements are wished for in all.
        wall_thickness: of its walls, m.
        robot_width: side of the square that must be able to walk, m.
        height: of the room, m; nothing higher may be wanted.
    """

    camel_case: ClassVar[bool] = True

    room: SentRoom
    pieces: Annotated[tuple[PieceRequest, ...], MaxLen(MOST_PIECES)]
    alternatives: Annotated[int, Ge(1), Le(MOST_ALTERNATIVES), WHOLE] = 1
    wall_thickness: WallThickness = 0.0
    robot_width: RobotWidth = ROBOT_WIDTH
    height: PositiveMetres | None = None
    effort: Effort = NORMAL


@dataclass(frozen=True)
class ValidateBody(Record):
    """Judges a scene.

    Args:
        flagged: ids of bodies that somebody finds problematic: a report is written.
        report: whether a report is written in any case.
        access: a profile of access.yaml.
    """

    camel_case: ClassVar[bool] = True

    scene: SentScene
    flagged: Ids | None = None
    report: Flag | None = None
    access: Text | None = None


@dataclass(frozen=True)
class ViewBody(Record):
    """Shows a scene."""

    scene: SentScene


@dataclass(frozen=True)
class ExplainBody(Record):
    """Asks why a piece of furniture stands where it does.

    Args:
        id: of the piece.
    """

    scene: SentScene
    id: Text


@dataclass(frozen=True)
class FloorBody(Record):
    """Asks for the floor of rooms; of all where none are named."""

    scene: SentScene
    rooms: Ids = ()


@dataclass(frozen=True)
class ExportBody(Record):
    """A scene, or an answer that holds one.

    Args:
        free: what may move in the formats of simulators.
        strict: whether a scene with errors is refused.
        issues, timing_ms, understood_as, moves, removed, conflicts: of an answer, not read.
    """

    scene: SentScene
    free: Annotated[str, OneOf(*FREEDOMS)] = "light"
    strict: Flag = False
    scale: Annotated[Annotated[int, Ge(20), Le(2000), WHOLE] | None, Says("of an svg plan, 1 to so much")] = None
    called: Annotated[Mapping[Text, Text], Says("what an svg plan calls room types, by type")] = field(default_factory=dict)
    issues: Any = None
    timing_ms: Any = None
    understood_as: Any = None
    moves: Any = None
    removed: Any = None
    conflicts: Any = None


class _ByItself:
    """Tells a scene from an answer that holds one."""

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> Any:
        return {**handler(schema), "required": ["rooms"], "not": {"required": ["scene"]}}


SceneByItself = Annotated[Scene, _ByItself()]


@dataclass(frozen=True)
class ExportFormat(Record):
    """A format that /export writes: what it is, and whether its library is installed here."""

    name: str
    words: str
    available: bool


@dataclass(frozen=True)
class ExportFormats(Record):
    """The formats that /export writes."""

    formats: tuple[Annotated[Mapping[str, Any], Like(ExportFormat)], ...]


@dataclass(frozen=True)
class PlaceAnswer(Record):
    """The best placement, the others by rank, why required pieces are missing, issues, and stage times in ms."""

    scene: Scene
    relations: tuple[Held, ...]
    unplaced: tuple[Unplaced, ...]
    alternatives: tuple[Placement, ...]
    conflicts: tuple[Conflict, ...]
    issues: tuple[Issue, ...]
    timing_ms: Mapping[str, float]
    understood_as: Mapping[str, str]
    limited: Limited | None = field(default=None, metadata={OMITTED: True})


@dataclass(frozen=True)
class Lines(Record):
    """Text, and for each of its lines the id of the body it speaks of, or null."""

    text: str
    lines: tuple[str | None, ...]


@dataclass(frozen=True)
class ValidateAnswer(Record):
    """What breaks which rule and by how much, measures, and where wanted the whole scene in words, and what a profile of access asks.

    `misspelt` are places of keys that the scene keeps without knowing them, each with the known key that it nearly is.
    """

    issues: tuple[Issue, ...]
    metrics: Free
    understood_as: Mapping[str, str]
    report: Lines | None = field(default=None, metadata={OMITTED: True})
    access: Free | None = field(default=None, metadata={OMITTED: True})
    misspelt: Mapping[str, str] | None = field(default=None, metadata={OMITTED: True})


Rectangle = Annotated[tuple[float, float, float, float], Says("west, north, east, south edge in the room, m")]


@dataclass(frozen=True)
class RoomFloor(Record):
    """A room's floor: what is clear of walls, kept free before doors and windows, and free to come to.

    Where the scene's request names a profile of access, `turning` is the square to turn in, `short` the largest where it is too small.
    """

    room: str
    clear: Rectangle
    doors: tuple[Rectangle, ...]
    windows: tuple[Rectangle, ...]
    free: tuple[Rectangle, ...]
    turning: tuple[Rectangle, ...]
    short: tuple[Rectangle, ...]


@dataclass(frozen=True)
class FloorAnswer(Record):
    """The floor of rooms."""

    rooms: tuple[Annotated[Mapping[str, Any], Like(RoomFloor)], ...]


@dataclass(frozen=True)
class Health(Record):
    """The service lives."""

    status: Annotated[str, OneOf("ok")] = "ok"


@dataclass(frozen=True)
class FieldProblem(Record):
    """A field that is wrong: where, how, and what would be right (empty where there is nothing to say)."""

    field: str
    problem: str
    allowed: str


@dataclass(frozen=True)
class ProblemDocument(Record):
    """An RFC 9457 problem document."""

    type: str
    title: str
    status: Whole
    detail: str
    errors: tuple[Annotated[Mapping[str, str], Like(FieldProblem)], ...]
