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


class TooMuch(FieldError):
    """Work that is not finished within this service's bounds."""

    SMALLER: Final = "a smaller house or scene; the command line has no such bound"


class Busy(FieldError):
    """More calls than may wait."""


class NoSuchFormat(FieldError):
    """An export in a format that there is not."""
