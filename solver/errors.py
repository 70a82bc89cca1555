"""The tree of errors.

    ComposeError
    ├── FieldError          a field of a document is wrong: which, and what is allowed
    │   ├── RequestError      ... of a request
    │   ├── SceneError        ... of a scene
    │   └── TooMuch           it takes more work than a call may have
    ├── SyntaxFault         the text is not JSON or YAML at all
    └── CatalogError        a catalog cannot be used: which file, line and key (catalogs.faults, as the base)

A bad scene (one that breaks rules) is not an error: validate() returns issues.
"""

from collections.abc import Callable, Iterable
from typing import Final, TypeVar

from catalogs.faults import ComposeError, system_words

__all__ = ["ComposeError", "FieldError", "RequestError", "SceneError", "SyntaxFault", "TooMuch", "all_of", "system_words"]
Made = TypeVar("Made")
MOST_TOLD: Final = 20
"""How many wrong fields a refusal names."""
MOST_LETTERS: Final = 4000
"""How long its words about one may be, which may hold what was sent: twice what all kinds of the catalog take."""


class FieldError(ComposeError):
    """A field of a document is wrong.

    Args:
        field: where, as a path such as `rooms[2].furniture[0].width`.
        problem: what is wrong with it, in words.
        allowed: what would be accepted, in words; empty if there is nothing to add.
        more: other fields that are wrong as well, each as field, problem, allowed.
    """

    def __init__(self, field: str, problem: str, allowed: str = "", more: tuple[tuple[str, str, str], ...] = ()) -> None:
        self.field, self.problem, self.allowed = map(_cut, (field, problem, allowed))
        self.more = tuple([(_cut(where), _cut(what), _cut(may_be)) for where, what, may_be in more])
        super().__init__(f"{self.field}: {self.problem}" + (f" (allowed: {self.allowed})" if allowed else ""))

    def __reduce__(self) -> "tuple[type[FieldError], tuple[str, str, str, tuple[tuple[str, str, str], ...]]]":
        """Lets it go from one process to another: a pool raises it again."""
        return type(self), (self.field, self.problem, self.allowed, self.more)


def _cut(words: str) -> str:
    return words if len(words) <= MOST_LETTERS else f"{words[: MOST_LETTERS - 1]}…"


class RequestError(FieldError):
    """A field of a request is wrong."""


class SceneError(FieldError):
    """A field of a scene is wrong."""


class TooMuch(FieldError):
    """Work that is not finished within the bounds of a call."""

    SMALLER: Final = "a smaller house or scene; the command line has no such bound"


class SyntaxFault(ComposeError):
    """A text is not a JSON or YAML document, or is too deeply nested to be one of ours."""


def all_of(makers: Iterable[Callable[[], Made]]) -> list[Made]:
    """Returns what each makes.

    Raises:
        FieldError: the first refusal of a request or scene, with all others as its `more`.
    """
    made: list[Made] = []
    wrong: list[FieldError] = []
    for make in makers:
        try:
            made.append(make())
        except (RequestError, SceneError) as error:
            wrong.append(error)
    if wrong:
        first, *more = [entry for one in wrong for entry in ((one.field, one.problem, one.allowed), *one.more)][:MOST_TOLD]
        raise type(wrong[0])(*first, tuple(more))
    return made
