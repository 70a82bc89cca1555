"""Opens a store, brings its tables up to date, and runs transactions in it.

How the tables came to be as they are now stands in `migrations`, and a test holds one against the other.
"""

import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from threading import Lock
from typing import Any, Final

import sqlalchemy as sa
from sqlalchemy.engine import URL, make_url
from sqlalchemy.exc import ArgumentError, DBAPIError, NoSuchModuleError
from sqlalchemy.types import TypeEngine

from service.problems import NoRoom, StoreAway
from solver.errors import FieldError, system_words

HEAD: Final = "0002"
"""The last step of `migrations`."""
WRITING: Final = "writing"
LOCK: Final = 0x436F6D70
"""Any number: whoever brings a PostgreSQL store up to date holds the advisory lock of that number."""
WAIT_S: Final = 5
"""How long a transaction waits for another one, and a connection for the database, s. Our choice."""
FULL: Final = ("disk is full", "53100")
"""How SQLite (in words) and PostgreSQL (by SQLSTATE) say that no room is left."""


class Database:
    """A store that is up to date.

    Args:
        place: the name of an SQLite file, whose folder is made; or a URL, `postgresql://...` or `sqlite:///...`.

    Raises:
        FieldError: it is no place for a store, or a later version of Compose made it; says why, and no password.
        StoreAway: it cannot be reached.
        NoRoom: its disk is full.
    """

    def __init__(self, place: str) -> None:
        url = _url(place)
        try:
            self.engine = _engine(url)
        except (NoSuchModuleError, ImportError, ArgumentError) as error:
            raise FieldError("store", f"cannot be opened: {error}", "a file's name, or postgresql:// with the extra `postgresql`") from None
        self._turns = _Turns()
        with self.writing() as connection:
            _bring_up_to_date(connection)

    @contextmanager
    def reading(self) -> Iterator[sa.Connection]:
        """Runs a transaction that changes nothing.

        Raises:
            StoreAway: the database does not answer.
        """
        with _in_words(), self.engine.connect() as connection:
            yield connection

    @contextmanager
    def writing(self) -> Iterator[sa.Connection]:
        """Runs a transaction: all of it is kept once the block has ended, or nothing.

        Raises:
            StoreAway: the database does not answer, or others kept it busy for WAIT_S.
            NoRoom: its disk is full.
        """
        turn = self._turns.mine(WAIT_S) if self.engine.dialect.name == "sqlite" else nullcontext()
        with _in_words(), turn, self.engine.connect().execution_options(**{WRITING: True}) as connection, connection.begin():
            yield connection

    def close(self) -> None:
        """Lets its connections go."""
        self.engine.dispose()


class _Turns:
    """A lock that is handed on in the order in which it was asked for.

    SQLite has each writer look now and then whether it may write: of several who write often, one that waits would find it taken each time,
    and be refused. PostgreSQL, where writers wait for rows, needs none.
    """

    def __init__(self) -> None:
        self._guard, self._line = Lock(), list[Lock]()

    @contextmanager
    def mine(self, seconds: float) -> Iterator[None]:
        """Runs a block in its turn, for which it waits so many seconds.

        Raises:
            TimeoutError: it waited that long.
        """
        own = Lock()
        own.acquire()
        with self._guard:
            self._line.append(own)
            if self._line[0] is own:
                own.release()
        try:
            if not own.acquire(timeout=seconds):
                raise TimeoutError
            yield
        finally:
            with self._guard:
                is_handed_on = self._line[0] is own
                self._line.remove(own)
                if is_handed_on and self._line:
                    self._line[0].release()


def _url(place: str) -> URL:
    try:
        url = make_url(place) if "://" in place else URL.create("sqlite", database=str(Path(place).expanduser().absolute()))
    except ArgumentError:
        raise FieldError("store", "is no URL of a database", "a file's name, postgresql://user:password@host/name") from None
    if url.get_backend_name() == "postgresql":
        return url.set(drivername="postgresql+psycopg")
    if url.get_backend_name() != "sqlite" or not url.database:
        raise FieldError("store", f"is of a kind that is not kept in: {url.drivername}", "a file's name, or postgresql://")
    return url


def _engine(url: URL) -> sa.Engine:
    if url.get_backend_name() == "postgresql":
        return sa.create_engine(url, pool_pre_ping=True, connect_args={"connect_timeout": WAIT_S}, pool_timeout=WAIT_S)
    try:
        Path(str(url.database)).parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FieldError("store", f"cannot be opened: {system_words(error)}", "a file in a folder that can be written to") from None
    engine = sa.create_engine(url, connect_args={"timeout": WAIT_S}, pool_timeout=WAIT_S)
    sa.event.listen(engine, "connect", _set_sqlite_up)
    sa.event.listen(engine, "begin", _begin_sqlite)
    return engine


def _set_sqlite_up(connection: sqlite3.Connection, _: object) -> None:
    """What is acknowledged is on the disk; LIKE tells small letters from large, as PostgreSQL does."""
    connection.isolation_level = None  # the module's own BEGINs come too late to keep others from writing between
    for name, value in {"journal_mode": "WAL", "synchronous": "FULL", "foreign_keys": "ON", "case_sensitive_like": "ON"}.items():
        connection.execute(f"PRAGMA {name}={value}")


def _begin_sqlite(connection: sa.Connection) -> None:
    connection.exec_driver_sql("BEGIN IMMEDIATE" if connection.get_execution_options().get(WRITING) else "BEGIN")


@contextmanager
def _in_words() -> Iterator[None]:
    """Turns what a database refuses into what the service answers; faults of ours stay what they are."""
    try:
        yield
    except DBAPIError as error:
        said = f"{error.orig} {getattr(error.orig, 'sqlstate', '')}"
        if any(words in said for words in FULL):
            raise NoRoom("store", "has no room left", "less, or another try when there is room") from error
        if error.connection_invalidated or type(error).__name__ in ("OperationalError", "InterfaceError"):
            raise StoreAway("store", "does not answer", "another try in a moment") from error
        raise
    except TimeoutError as error:
        raise StoreAway("store", "does not answer", "another try in a moment") from error


def _bring_up_to_date(connection: sa.Connection) -> None:
    if connection.dialect.name == "postgresql":
        connection.execute(sa.text("SELECT pg_advisory_xact_lock(:lock)"), {"lock": LOCK})
    if _found(connection) == HEAD:
        return
    # alembic takes as long to import as all else of a start, and there is seldom something to do.
    from alembic import command  # noqa: PLC0415
    from alembic.config import Config  # noqa: PLC0415
    from alembic.util import CommandError  # noqa: PLC0415

    config: Any = Config()
    config.set_main_option("script_location", str(Path(__file__).parent / "migrations").replace("%", "%%"))
    config.attributes["connection"] = connection
    try:
        command.upgrade(config, "head")
    except CommandError:
        raise FieldError("store", "was made by a later version of Compose", f"that version, or a store up to {HEAD}") from None


def _found(connection: sa.Connection) -> str | None:
    if not sa.inspect(connection).has_table("alembic_version"):
        return None
    found: str | None = connection.scalar(sa.text("SELECT version_num FROM alembic_version"))
    return found


TABLES: Final = sa.MetaData()


def _said(kind: type[TypeEngine[Any]], *names: str) -> list[sa.Column[Any]]:
    """Returns columns that are never null."""
    return [sa.Column(name, kind, nullable=False) for name in names]


OWNERS: Final = sa.Table(
    "owners", TABLES, sa.Column("name", sa.Text, primary_key=True), *_said(sa.Integer, "homes"), *_said(sa.BigInteger, "bytes")
)
"""What each owner has: counted where it is changed, so that a limit holds however many save at once."""
HOMES: Final = sa.Table(
    "homes",
    TABLES,
    sa.Column("id", sa.Text, primary_key=True),
    *_said(sa.Text, "owner", "name", "notes", "tags", "words"),
    *_said(sa.BigInteger, "created", "changed"),
    *_said(sa.Integer, "revision", "version", "rooms"),
    sa.Column("picture", sa.LargeBinary),
    sa.Column("picture_type", sa.Text),
    sa.Index("homes_by_change", "owner", "changed", "id"),
)
"""`tags` has a line each, and one before and after; `words` is what a search looks through; times are microseconds since 1970.

`revision` counts every change but that of the picture, `version` those of the scene.
"""
VERSIONS: Final = sa.Table(
    "versions",
    TABLES,
    sa.Column("home", sa.Text, sa.ForeignKey("homes.id", ondelete="CASCADE"), primary_key=True),
    sa.Column("number", sa.Integer, primary_key=True),
    *_said(sa.BigInteger, "made"),
    *_said(sa.LargeBinary, "scene"),
)
"""`scene` is its JSON, packed by zlib."""
JOBS: Final = sa.Table(
    "jobs",
    TABLES,
    sa.Column("id", sa.Text, primary_key=True),
    *_said(sa.Text, "owner", "call"),
    *_said(sa.LargeBinary, "asked"),
    *_said(sa.Text, "state"),
    *_said(sa.Integer, "count", "done", "refused"),
    *_said(sa.BigInteger, "created", "changed", "beat"),
    *_said(sa.Text, "runner"),
    sa.Index("jobs_by_state", "state", "created"),
)
"""`asked` is a JSON list of the bodies of its calls, packed by zlib; `beat` is when `runner`, who runs it, last said that it lives."""
RESULTS: Final = sa.Table(
    "results",
    TABLES,
    sa.Column("job", sa.Text, sa.ForeignKey("jobs.id", ondelete="CASCADE"), primary_key=True),
    sa.Column("number", sa.Integer, primary_key=True),
    *_said(sa.Integer, "status"),
    *_said(sa.Text, "media_type"),
    *_said(sa.LargeBinary, "content"),
)
"""`content` is what was answered, packed by zlib."""
