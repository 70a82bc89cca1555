"""What the service refuses, beside what readers of documents refuse; and errors as RFC 9457 problem documents.

The one table that maps errors to HTTP is `STATUS`.
"""

import json
from collections.abc import Mapping
from http import HTTPStatus
from typing import Any, Final

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response

from solver.errors import ComposeError, FieldError, SyntaxFault, TooMuch


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


class ProcessLost(FieldError):
    """A call whose processes ended amid it, as for want of memory."""


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


MEDIA_TYPE: Final = "application/problem+json"

STATUS: Final[Mapping[type[ComposeError], tuple[int, str]]] = {
    NoSuchFormat: (404, "There is no such format"),
    SyntaxFault: (400, "The body cannot be read"),
    TooSlow: (408, "The body did not arrive"),
    TooLarge: (413, "The body is too large"),
    WrongMediaType: (415, "The body's format is not read here"),
    TooMuch: (422, "The work is too much"),
    FieldError: (422, "A field is wrong"),
    TooLong: (504, "The call took too long"),
    Busy: (503, "The service is busy"),
    ProcessLost: (503, "The service lost a process"),
}
"""Status and title of every error a caller can bring about; a class stands for its children too."""
STORE_STATUS: Final[Mapping[type[ComposeError], tuple[int, str]]] = {
    NoSuchThing: (404, "There is no such thing here"),
    TooManyKept: (409, "No more may be kept"),
    ChangedMeanwhile: (412, "It was changed meanwhile"),
    UnnamedRevision: (428, "The revision has to be named"),
    StoreAway: (503, "The store does not answer"),
    NoRoom: (507, "The store is full"),
}
"""The same, of the calls that keep something."""
ALL_STATUS: Final = {**STATUS, **STORE_STATUS}

RETRY_AFTER_S: Final = 2
"""When to come back to a busy service, s. Our choice: a house takes a fraction of that."""


def problem(status: int, title: str, detail: str, errors: list[dict[str, str]], headers: Mapping[str, str] | None = None) -> Response:
    """Writes a problem document.

    Args:
        status: the HTTP status.
        title: what kind of problem it is, the same for every occurrence.
        detail: this occurrence, in words.
        errors: the fields concerned: `field`, `problem`, and `allowed` where there is something to say.
        headers: more headers.
    """
    document: dict[str, Any] = {"type": "about:blank", "title": title, "status": status, "detail": detail, "errors": errors}
    return Response(json.dumps(document).encode(), status, headers, MEDIA_TYPE)


def _entry(field: str, what: str, allowed: str = "") -> dict[str, str]:
    return {"field": field, "problem": what, "allowed": allowed}


def of_error(_: Request | None, error: Exception) -> Response:
    """Turns an error of the table into its problem document."""
    status, title = next(ALL_STATUS[kind] for kind in type(error).__mro__ if kind in ALL_STATUS)
    if isinstance(error, FieldError):
        entries = [_entry(error.field, error.problem, error.allowed), *(_entry(*one) for one in error.more)]
    else:
        entries = [_entry("body", str(error), "one JSON document in UTF-8, or one in YAML with Content-Type: application/yaml")]
    headers = {"Retry-After": str(RETRY_AFTER_S)} if status == HTTPStatus.SERVICE_UNAVAILABLE else None
    return problem(status, title, str(error), entries, headers)


def of_http(request: Request, error: Exception) -> Response:
    """Turns the router's own errors (unknown path, wrong method) into problem documents."""
    status = error.status_code if isinstance(error, HTTPException) else HTTPStatus.INTERNAL_SERVER_ERROR
    headers = dict(getattr(error, "headers", None) or {})
    title, path = HTTPStatus(status).phrase, request.url.path
    if status == HTTPStatus.METHOD_NOT_ALLOWED:
        allow = ", ".join(sorted(headers.get("Allow", "GET, HEAD").split(", ")))
        return problem(
            status, title, f"{path} does not take {request.method}.", [_entry("method", request.method, allow)], {"Allow": allow}
        )
    if status == HTTPStatus.NOT_FOUND:
        return problem(status, title, f"There is no {path}.", [_entry("path", path, "the calls listed at /docs")], headers)
    return problem(status, title, f"{path}: {title}.", [], headers)


def unexpected() -> Response:
    """The answer when something is wrong with the service itself; says nothing of its insides."""
    return problem(500, "The service failed", "This is a fault of the service, not of the request; it has been logged.", [])
