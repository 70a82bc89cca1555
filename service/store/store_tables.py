"""The tables as they are now; how they came to be stands in `migrations`, and a test holds one against the other."""

from __future__ import annotations

from typing import Final

from sqlalchemy import BigInteger, Column, ForeignKey, Index, Integer, LargeBinary, MetaData, Table, Text

TABLES: Final = MetaData()

OWNERS: Final = Table(
    "owners",
    TABLES,
    Column("name", Text, primary_key=True),
    Column("homes", Integer, nullable=False),
    Column("bytes", BigInteger, nullable=False),
)
"""What each owner has: counted where it is changed, so that a limit holds however many save at once."""
HOMES: Final = Table(
    "homes",
    TABLES,
    Column("id", Text, primary_key=True),
    Column("owner", Text, nullable=False),
    Column("name", Text, nullable=False),
    Column("notes", Text, nullable=False),
    Column("tags", Text, nullable=False),
    Column("words", Text, nullable=False),
    Column("created", BigInteger, nullable=False),
    Column("changed", BigInteger, nullable=False),
    Column("revision", Integer, nullable=False),
    Column("version", Integer, nullable=False),
    Column("rooms", Integer, nullable=False),
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
    Column("made", BigInteger, nullable=False),
    Column("scene", LargeBinary, nullable=False),
)
"""`scene` is its JSON, packed by zlib."""
JOBS: Final = Table(
    "jobs",
    TABLES,
    Column("id", Text, primary_key=True),
    Column("owner", Text, nullable=False),
    Column("call", Text, nullable=False),
    Column("asked", LargeBinary, nullable=False),
    Column("state", Text, nullable=False),
    Column("count", Integer, nullable=False),
    Column("done", Integer, nullable=False),
    Column("refused", Integer, nullable=False),
    Column("created", BigInteger, nullable=False),
    Column("changed", BigInteger, nullable=False),
    Column("beat", BigInteger, nullable=False),
    Column("runner", Text, nullable=False),
    Index("jobs_by_state", "state", "created"),
)
"""`asked` is a JSON list of the bodies of its calls, packed by zlib; `beat` is when `runner`, who runs it, last said that it lives."""
RESULTS: Final = Table(
    "results",
    TABLES,
    Column("job", Text, ForeignKey("jobs.id", ondelete="CASCADE"), primary_key=True),
    Column("number", Integer, primary_key=True),
    Column("status", Integer, nullable=False),
    Column("media_type", Text, nullable=False),
    Column("content", LargeBinary, nullable=False),
)
"""`content` is what was answered, packed by zlib."""
