"""The tree of errors.

    ComposeError
    ├── FieldError          a field of a document is wrong: which, and what is allowed
    │   ├── RequestError      ... of a request
    │   └── SceneError        ... of a scene
    └── SyntaxFault         the text is not JSON or YAML at all

A bad scene (one that breaks rules) is not an error: validate() returns issues. A catalog that cannot be read raises
catalogs.CatalogError, which stands alone because catalogs import nothing of ours.
"""

from __future__ import annotations


class ComposeError(Exception):
    """Base of everything this project raises on purpose."""


class FieldError(ComposeError):
    """A field of a document is wrong.

    Args:
        field: where, as a path such as `rooms[2].furniture[0].width`.
        problem: what is wrong with it, in words.
        allowed: what would be accepted, in words; empty if there is nothing to add.
    """

    def __init__(self, field: str, problem: str, allowed: str = "") -> None:
        self.field, self.problem, self.allowed = field, problem, allowed
        super().__init__(f"{field}: {problem}" + (f" (allowed: {allowed})" if allowed else ""))


class RequestError(FieldError):
    """A field of a request is wrong."""


class SceneError(FieldError):
    """A field of a scene is wrong."""


class SyntaxFault(ComposeError):
    """A text is not a JSON or YAML document, or is too deeply nested to be one of ours."""
