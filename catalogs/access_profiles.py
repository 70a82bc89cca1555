"""What standards of accessible homes ask for, as `access.yaml` says it."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from catalogs.entries import PIECE_NAMES, ROOM_TYPE, Entry, Metres

RoomName = Annotated[str, ROOM_TYPE]
PieceName = Annotated[str, PIECE_NAMES]


class AccessRule(Entry):
    """One demand: `what` is asked for in which `rooms`, never in `but`, or of which `pieces` there, by which `clause`.

    `least` is the length asked for, m; `deep` how deep a rectangle before a piece is; `other` what the narrower of two strips
    has; `frame` what a leaf in its frame takes of a door; `beside` what may stand in strips. With `one` a single room will do.
    """

    what: Literal["turning", "door", "hallway", "before", "deep", "along"]
    clause: str
    least: Metres
    deep: Metres | None = None
    other: Metres | None = None
    frame: Annotated[float, Field(ge=0, le=0.5)] = 0.0
    rooms: tuple[RoomName, ...] = ()
    but: tuple[RoomName, ...] = ()
    pieces: tuple[PieceName, ...] = ()
    beside: tuple[PieceName, ...] = ()
    one: bool = False

    @model_validator(mode="after")
    def _whole(self) -> AccessRule:
        about = self.what in ("before", "deep", "along")
        if about != bool(self.pieces):
            raise ValueError("what asks for room before or along pieces names them, and nothing else does")
        if (self.what == "before") != (self.deep is not None) or (self.what == "along") != (self.other is not None):
            raise ValueError("`deep` goes with before, `other` with along")
        return self


class AccessProfile(Entry):
    """A standard: what it is, the side of the square that has to come everywhere, m, and its rules."""

    says: str
    walker: Annotated[float, Field(ge=0.1, le=2)]
    rules: tuple[AccessRule, ...]
