"""What the calls about long work take and answer: declared once, as in `contract`."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, Final

from annotated_types import MaxLen, MinLen

from solver.fields import Free, Name, OneOf, Record, Says, Text, Whole
from solver.request import Seed

MOST_CALLS: Final = 1000
JOB_CALLS: Final = ("generate", "furnish", "fix", "place", "validate")
STATES: Final = ("waiting", "running", "done")


@dataclass(frozen=True)
class JobBody(Record):
    """Long work: one call with `body`; with `seeds` that call once a seed.

    Args:
        call: its name.
        seeds: the call is made once for each.
    """

    call: Annotated[str, OneOf(*JOB_CALLS)]
    body: Annotated[Free, Says("of the call, as it would be sent to it")] = field(default_factory=dict)
    seeds: Annotated[tuple[Seed, ...], MinLen(1), MaxLen(MOST_CALLS), Says("each is the body's `seed` once")] | None = None


@dataclass(frozen=True)
class JobHead(Record):
    """A job: `done` of its `count` calls have been made, of which `refused` were refused."""

    id: Name
    call: Text
    state: Annotated[str, OneOf(*STATES)]
    count: Whole
    done: Whole
    refused: Whole
    created: Annotated[Text, Says("RFC 3339, UTC")]
    changed: Annotated[Text, Says("RFC 3339, UTC")]


@dataclass(frozen=True)
class JobList(Record):
    """Jobs, the newest first."""

    jobs: tuple[JobHead, ...]
