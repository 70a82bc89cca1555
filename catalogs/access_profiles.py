"""What standards of accessible homes ask for, as `access.yaml` says it."""

from math import ceil
from typing import Annotated, Literal

from pydantic import Field, model_validator

from catalogs.entries import PIECE_NAMES, ROOM_TYPE, Entry, Metres

RoomName = Annotated[str, ROOM_TYPE]
PieceName = Annotated[str, PIECE_NAMES]


class AccessRule(Entry):
    """One demand: `what` is asked for in which `rooms`, never in `not_in`, or of which `pieces` there, by which `clause`.

    `min` is the length asked for, m; `deep` how deep a rectangle before a piece is; `other` what the narrower of two strips
    has; `frame` what a leaf in its frame takes of a door; `latch` how far the floor before a door reaches beyond the end without the hinge;
    `beside` what may stand in strips. With `one` a single room will do.
    """

    what: Literal["turning", "door", "hallway", "before", "deep", "along", "approach"]
    clause: str
    min: Metres
    deep: Metres | None = None
    other: Metres | None = None
    frame: Annotated[float, Field(ge=0, le=0.5)] = 0.0
    latch: Annotated[float, Field(ge=0, le=2)] = 0.0
    rooms: tuple[RoomName, ...] = ()
    not_in: tuple[RoomName, ...] = ()
    pieces: tuple[PieceName, ...] = ()
    beside: tuple[PieceName, ...] = ()
    one: bool = False
    main: bool = False
    """Of a door: the main entrance alone is meant."""
    out: bool = False
    """Of a door: its leaf must not swing into the room."""
    pull: bool | None = None
    """Of the floor before a door: where the leaf comes towards one, or where it goes away."""

    def is_about(self, room: str) -> bool:
        """Tells whether rooms of a type, indoors, are meant."""
        return room not in self.not_in and (not self.rooms or room in self.rooms)

    @model_validator(mode="after")
    def _whole(self) -> "AccessRule":
        about = self.what in ("before", "deep", "along")
        if about != bool(self.pieces):
            raise ValueError("what asks for room before or along pieces names them, and nothing else does")
        if (self.what == "before") != (self.deep is not None) or (self.what == "along") != (self.other is not None):
            raise ValueError("`deep` goes with before, `other` with along")
        if (self.what == "approach") != (self.pull is not None) or (self.latch and self.what != "approach"):
            raise ValueError("`pull` goes with approach, and `latch` with nothing else")
        return self


class AccessHome(Entry):
    """How large rooms of a type are in homes that are made for a profile: `area` and `width` as in `home` of a room type."""

    area: tuple[Metres, Metres, Metres]
    width: Metres


class AccessProfile(Entry):
    """A standard: what it is, the side of the square that has to come everywhere, m, its rules, and how large rooms are for it."""

    description: str
    walker: Annotated[float, Field(ge=0.1, le=2)]
    rules: tuple[AccessRule, ...]
    homes: dict[RoomName, AccessHome] = Field(default_factory=dict)

    def turning(self, room: str) -> float:
        """Returns the side of the square to be kept empty in a room of a type, m; 0 where there is none."""
        return max((rule.min for rule in self.rules if rule.what == "turning" and rule.is_about(room)), default=0.0)

    @property
    def hallway(self) -> float:
        """How wide hallways are at least, m: what is asked for of them, and before the doors in them."""
        asked = ("hallway", "approach")
        return max((rule.min for rule in self.rules if rule.what in asked and rule.is_about("hallway")), default=0.0)

    def latch_behind(self, room: str) -> float:
        """Returns the floor that is asked for beside latches in rooms of a type whatever way leaves swing, m; 0 where none is."""
        return max((rule.latch for rule in self.rules if rule.pull is False and rule.is_about(room)), default=0.0)

    def swings_out(self, room: str) -> bool:
        """Tells whether leaves must not swing into rooms of a type."""
        return any(rule.out and rule.is_about(room) for rule in self.rules)

    def deep(self, piece: str, room: str) -> float:
        """Returns how deep the floor before a piece in a room of a type is to be empty, m; 0 where nothing is asked for."""
        return max((rule.min for rule in self.rules if rule.what == "deep" and piece in rule.pieces and rule.is_about(room)), default=0.0)

    def floor_of(self, piece: str, size: tuple[float, float, float]) -> float:
        """Returns the floor that a piece of a size takes, m2, with the strips that are to be empty along its sides and before its front."""
        about = [rule for rule in self.rules if piece in rule.pieces]
        along = max((rule.min + (rule.other or 0.0) for rule in about if rule.what == "along"), default=0.0)
        deep = max((rule.min for rule in about if rule.what == "deep"), default=0.0)
        return (size[0] + along) * (size[1] + deep)

    def leaf(self, main: bool) -> float:
        """Returns how wide a door's opening is to be cut, the main entrance's or another's, m: a multiple of 5 cm."""
        doors = (rule for rule in self.rules if rule.what == "door" and (main or not rule.main))
        least = max((rule.min + rule.frame for rule in doors), default=0.0)
        return ceil(round(max(least, self.walker) * 20, 6)) / 20
