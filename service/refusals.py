"""What the service itself refuses, beside what readers of documents refuse."""

from __future__ import annotations

from solver.errors import FieldError


class BodyError(FieldError):
    """A body that is an object, but not the one this call takes."""


class TooLarge(FieldError):
    """A body over the limit."""


class TooSlow(FieldError):
    """A body that does not arrive."""


class WrongMediaType(FieldError):
    """A body in a format that is not read here."""


class Busy(FieldError):
    """More calls than may wait."""
