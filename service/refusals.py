"""What the service itself refuses, beside what readers of documents refuse."""

from __future__ import annotations

from typing import Final

from solver.errors import FieldError


class TooLarge(FieldError):
    """A body over the limit."""


class TooSlow(FieldError):
    """A body that does not arrive."""


class WrongMediaType(FieldError):
    """A body in a format that is not read here."""


class TooLong(FieldError):
    """A call that ran longer than a call may."""

    SMALLER: Final = "a smaller house or scene, less effort; the command line has no such bound"


class Busy(FieldError):
    """More calls than may wait."""


class NoSuchFormat(FieldError):
    """An export in a format that there is not."""


class StoreAway(FieldError):
    """A store of homes that does not answer, or that there is none of."""


class NoRoom(FieldError):
    """A store whose disk is full."""


class TooManyKept(FieldError):
    """More than an owner may keep."""


class NoSuchThing(FieldError):
    """Something that is not kept, or is another owner's."""


class ChangedMeanwhile(FieldError):
    """A change of something that somebody else has changed since it was read."""


class UnnamedRevision(FieldError):
    """A change that does not say of which revision."""
