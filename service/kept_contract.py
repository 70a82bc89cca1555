"""What the calls about homes that are kept, and about long work, take and answer: declared once, as in `contract`."""

import sys
from collections.abc import Container
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Annotated, Final

from annotated_types import Ge, Le, MaxLen, MinLen

from solver.exchange import SentScene
from solver.fields import STRICT, WHOLE, Free, Matching, Name, OneOf, Record, Says, Text, Whole
from solver.request import Seed
from solver.scene import Scene

MOST_NAME: Final = 200
MOST_NOTES: Final = 10_000
MOST_TAG: Final = 50
MOST_TAGS: Final = 20
MOST_LISTED: Final = 100
"""Homes of one page."""
LISTED: Final = 20
"""Homes of one page where no number is named."""
AFTER: Final = r"^([0-9]{1,18}-[A-Za-z0-9_-]{1,40})?$"
"""How `after` looks: the time and the id of a page's last home."""
LINE: Final = Matching(r"^[^\x00-\x1f\x7f]*[^\x00-\x1f\x7f\s][^\x00-\x1f\x7f]*$")
LINES: Final = Matching(r"^[^\x00-\x08\x0b\x0c\x0e-\x1f\x7f]*$")

HomeName = Annotated[str, MinLen(1), MaxLen(MOST_NAME), LINE, STRICT, Says("one line, not blank")]
HomeNotes = Annotated[str, MaxLen(MOST_NOTES), LINES, STRICT]
HomeTag = Annotated[str, MinLen(1), MaxLen(MOST_TAG), LINE, STRICT]
HomeTags = Annotated[tuple[HomeTag, ...], MaxLen(MOST_TAGS), Says("each is kept once, in their order")]


@dataclass(frozen=True)
class HomeBody(Record):
    """A home to keep.

    Args:
        notes: what somebody wrote about it.
    """

    scene: SentScene
    name: HomeName = "Home"
    notes: HomeNotes = ""
    tags: HomeTags = ()


@dataclass(frozen=True)
class HomeChange(Record):
    """What changes of a home that is kept.

    Args:
        scene: its next version.
        name: one line.
        notes: what somebody wrote about it.
        tags: each is kept once, in their order.
    """

    scene: SentScene | None = None
    name: HomeName | None = None
    notes: HomeNotes | None = None
    tags: HomeTags | None = None


@dataclass(frozen=True)
class HomeHead(Record):
    """A home that is kept, without its scene; `revision` counts every change, `version` those of the scene. Times are of RFC 3339, UTC."""

    id: Name
    name: Text
    notes: Text
    tags: tuple[Text, ...]
    created: Annotated[Text, Says("when it was kept first")]
    changed: Annotated[Text, Says("when it was changed last")]
    revision: Whole
    version: Whole
    rooms: Annotated[Whole, Says("how many rooms it has")]
    link: Annotated[Text, Says("opens it on the page, relative to the service's address")]


@dataclass(frozen=True)
class HomeWithScene(HomeHead):
    """A home that is kept, with its scene."""

    scene: Scene


@dataclass(frozen=True)
class HomeList(Record):
    """One page of homes, the last changed first; how many there are in all; and what asks for the next page, null on the last one."""

    homes: tuple[HomeHead, ...]
    total: Whole
    after: Text | None = None


@dataclass(frozen=True)
class HomeVersion(Record):
    """A version of a home."""

    number: Whole
    made: Annotated[Text, Says("when, RFC 3339, UTC")]


@dataclass(frozen=True)
class HomeVersions(Record):
    """The versions of a home that are kept, the last first."""

    versions: tuple[HomeVersion, ...]


@dataclass(frozen=True)
class HomeQuery(Record):
    """Which homes are listed."""

    search: Annotated[str, MaxLen(MOST_NAME), LINES, STRICT, Says("words that are all somewhere in name, notes and tags")] = ""
    tag: Annotated[tuple[HomeTag, ...], MaxLen(MOST_TAGS), Says("tags that it has, all of them")] = ()
    limit: Annotated[int, Ge(1), Le(MOST_LISTED), WHOLE] = LISTED
    after: Annotated[str, Matching(AFTER), STRICT, Says("`after` of the page before")] = ""


Revisions = Container[int] | None
"""Those of a home that a change may be made to; None where none was named."""
ANY_REVISION: Final = range(1, sys.maxsize)


def moment(microseconds: int) -> str:
    """Writes a time by RFC 3339."""
    return datetime.fromtimestamp(microseconds / 1e6, UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")


@dataclass(frozen=True)
class PackedScene:
    """A scene as it is kept: its JSON, packed by zlib; and how many rooms it has."""

    content: bytes
    rooms: int


MOST_CALLS: Final = 1000
JOB_CALLS: Final = ("generate", "furnish", "fix", "place", "validate")
WAITING: Final = "waiting"
RUNNING: Final = "running"
DONE: Final = "done"
STATES: Final = (WAITING, RUNNING, DONE)
LEASE_S: Final = 20.0
"""After so long without a word of its runner, another one carries a job on, s. Our choice."""


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


@dataclass(frozen=True)
class JobResult:
    """What came of one call: the answer as it would have been sent, packed by zlib."""

    status: int
    media_type: str
    content: bytes
