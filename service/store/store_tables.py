"""The tables as they are now; how they came to be stands in `migrations`, and a test holds one against the other."""

from __future__ import annotations

from typing import Any, Final

from sqlalchemy import BigInteger, Column, ForeignKey, Index, Integer, LargeBinary, MetaData, Table, Text
from sqlalchemy.types import TypeEngine

TABLES: Final = MetaData()


def _said(kind: type[TypeEngine[Any]], *names: str) -> list[Column[Any]]:
    """Returns columns that are never null."""
    return [Column(name, kind, nullable=False) for name in names]


OWNERS: Final = Table("owners", TABLES, Column("name", Text, primary_key=True), *_said(Integer, "homes"), *_said(BigInteger, "bytes"))
"""What each owner has: counted where it is changed, so that a limit holds however many save at once."""
HOMES: Final = Table(
    "homes",
    TABLES,
    Column("id", Text, primary_key=True),
    *_said(Text, "owner", "name", "notes", "tags", "words"),
    *_said(BigInteger, "created", "changed"),
    *_said(Integer, "revision", "version", "rooms"),
    Column("picture", LargeBinary),
    Column("picture_type", Text),
    Index("homes_by_change", "owner", "changed", "id"),
)
"""`tags` has a line each, and one before and after; `words` is what a search looks through; times are microseconds since 1970.

`revision` counts every change but that of the picture, `version` those of the scene.
"""
VERSIONS: Final = Table(
    "versions",
    TABLES,
    Column("home", Text, ForeignKey("homes.id", ondelete="CASCADE"), primary_key=True),
    Column("number", Integer, primary_key=True),
    *_said(BigInteger, "made"),
    *_said(LargeBinary, "scene"),
)
"""`scene` is its JSON, packed by zlib."""
JOBS: Final = Table(
    "jobs",
    TABLES,
    Column("id", Text, primary_key=True),
    *_said(Text, "owner", "call"),
    *_said(LargeBinary, "asked"),
    *_said(Text, "state"),
    *_said(Integer, "count", "done", "refused"),
    *_said(BigInteger, "created", "changed", "beat"),
    *_said(Text, "runner"),
    Index("jobs_by_state", "state", "created"),
)
"""`asked` is a JSON list of the bodies of its calls, packed by zlib; `beat` is when `runner`, who runs it, last said that it lives."""
RESULTS: Final = Table(
    "results",
    TABLES,
    Column("job", Text, ForeignKey("jobs.id", ondelete="CASCADE"), primary_key=True),
    Column("number", Integer, primary_key=True),
    *_said(Integer, "status"),
    *_said(Text, "media_type"),
    *_said(LargeBinary, "content"),
)
"""`content` is what was answered, packed by zlib."""
