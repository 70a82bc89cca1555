"""Homes in a store: every question names an owner, and finds that one's homes alone."""

import secrets
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, Final
from unicodedata import normalize

from sqlalchemy import ColumnElement, Connection, Row, and_, delete, func, insert, or_, select, update
from sqlalchemy.dialects import postgresql, sqlite

from service.kept_contract import ANY_REVISION, HomeHead, HomeQuery, PackedScene, Revisions, moment
from service.problems import ChangedMeanwhile, NoSuchThing, TooManyKept, UnnamedRevision
from service.store.database import HOMES, OWNERS, VERSIONS, Database

KEPT_VERSIONS: Final = 50
"""Versions of a home; the oldest go when there are more. Our choice."""
SHOWN: Final = tuple(HOMES.c[part.name] for part in fields(HomeHead) if part.name != "link")


@dataclass(frozen=True)
class Keeping:
    """How much each owner may keep: homes, and bytes of all their versions, packed, and their pictures."""

    homes: int = 1000
    bytes: int = 500_000_000


@dataclass(frozen=True)
class PageOfHomes:
    """One page of homes, the last changed first; how many there are in all; and what asks for the next page, if there is one."""

    homes: tuple[HomeHead, ...]
    total: int
    after: str | None


class SavedHomes:
    """The homes of a store, and how much each owner may keep; the clock counts nanoseconds since 1970, UTC."""

    def __init__(self, database: Database, keeping: Keeping | None = None, clock: Callable[[], int] = time.time_ns) -> None:
        self._database, self._keeping, self._clock = database, keeping or Keeping(), clock

    def add(self, owner: str, texts: Mapping[str, Any], scene: PackedScene) -> HomeHead:
        """Keeps a new home of an owner: its `name`, `notes` and `tags`, and its first version.

        Raises:
            TooManyKept: the owner has no room for it.
        """
        home, now = secrets.token_urlsafe(12), self._clock() // 1000
        row = {
            **_written(texts),
            "id": home,
            "owner": owner,
            "created": now,
            "changed": now,
            "revision": 1,
            "version": 1,
            "rooms": scene.rooms,
        }
        with self._database.writing() as connection:
            self._take(connection, owner, 1, len(scene.content))
            connection.execute(insert(HOMES), row)
            connection.execute(insert(VERSIONS), {"home": home, "number": 1, "made": now, "scene": scene.content})
            return _read(_found(connection, owner, home))

    def get(self, owner: str, home: str, version: int | None = None) -> tuple[HomeHead, bytes]:
        """Returns a home and its packed scene; of a version, where one is named.

        Raises:
            NoSuchThing: this owner has no such home, or it has no such version any more.
        """
        with self._database.reading() as connection:
            found = _found(connection, owner, home)
            number = found.version if version is None else version
            scene = connection.scalar(select(VERSIONS.c.scene).where(VERSIONS.c.home == home, VERSIONS.c.number == number))
            if scene is None:
                raise NoSuchThing("version", f"{number} of this home is not kept", f"one of GET /homes/{home}/versions")
            return _read(found), scene

    def change(self, owner: str, home: str, revisions: Revisions, texts: Mapping[str, Any], scene: PackedScene | None) -> HomeHead:
        """Changes those texts of an owner's home that are given, and adds a version if there is a scene.

        Raises:
            NoSuchThing: this owner has no such home.
            UnnamedRevision: no revision is named.
            ChangedMeanwhile: it has another one by now.
            TooManyKept: the owner has no room for another version.
        """
        now = self._clock() // 1000
        with self._database.writing() as connection:
            before = _held(connection, owner, home, revisions)
            kept = {"name": before.name, "notes": before.notes, "tags": _tags(before), **texts}
            new: dict[str, Any] = {**_written(kept), "changed": max(now, before.changed + 1), "revision": before.revision + 1}
            if scene is not None:
                self._add_version(connection, owner, before, scene, now)
                new |= {"version": before.version + 1, "rooms": scene.rooms}
            connection.execute(update(HOMES).where(HOMES.c.id == home).values(new))
            return _read(_found(connection, owner, home))

    def _add_version(self, connection: Connection, owner: str, before: Row[Any], scene: PackedScene, now: int) -> None:
        old = and_(VERSIONS.c.home == before.id, VERSIONS.c.number <= before.version + 1 - KEPT_VERSIONS)
        gone = connection.scalar(select(func.coalesce(func.sum(func.length(VERSIONS.c.scene)), 0)).where(old)) or 0
        self._take(connection, owner, 0, len(scene.content) - int(gone))
        connection.execute(delete(VERSIONS).where(old))
        row = {"home": before.id, "number": before.version + 1, "made": now, "scene": scene.content}
        connection.execute(insert(VERSIONS), row)

    def remove(self, owner: str, home: str, revisions: Revisions) -> None:
        """Removes a home with all its versions.

        Raises:
            NoSuchThing, UnnamedRevision, ChangedMeanwhile: as `change`.
        """
        with self._database.writing() as connection:
            _held(connection, owner, home, revisions)
            sizes = connection.scalar(select(func.sum(func.length(VERSIONS.c.scene))).where(VERSIONS.c.home == home)) or 0
            picture = connection.scalar(select(func.length(HOMES.c.picture)).where(HOMES.c.id == home)) or 0
            connection.execute(delete(HOMES).where(HOMES.c.id == home))
            self._take(connection, owner, -1, -int(sizes) - int(picture))

    def list(self, owner: str, wanted: HomeQuery) -> PageOfHomes:
        """Returns one page of an owner's homes."""
        fits = and_(HOMES.c.owner == owner, *_matching(wanted))
        page = select(*SHOWN).where(fits).order_by(HOMES.c.changed.desc(), HOMES.c.id.desc()).limit(wanted.limit + 1)
        if wanted.after:
            at, _, home = wanted.after.partition("-")
            page = page.where(or_(HOMES.c.changed < int(at), and_(HOMES.c.changed == int(at), HOMES.c.id < home)))
        with self._database.reading() as connection:
            rows = connection.execute(page).all()
            total = connection.scalar(select(func.count()).select_from(HOMES).where(fits)) or 0
        shown = rows[: wanted.limit]
        return PageOfHomes(tuple(map(_read, shown)), total, f"{shown[-1].changed}-{shown[-1].id}" if len(rows) > wanted.limit else None)

    def versions(self, owner: str, home: str) -> Sequence[tuple[int, int]]:
        """Returns the number and the time of each version that is kept, the last first.

        Raises:
            NoSuchThing: this owner has no such home.
        """
        with self._database.reading() as connection:
            _found(connection, owner, home)
            asked = select(VERSIONS.c.number, VERSIONS.c.made).where(VERSIONS.c.home == home).order_by(VERSIONS.c.number.desc())
            return [(number, made) for number, made in connection.execute(asked)]

    def picture(self, owner: str, home: str) -> tuple[bytes, str] | None:
        """Returns a home's picture and its media type, or None where none was given.

        Raises:
            NoSuchThing: this owner has no such home.
        """
        asked = select(HOMES.c.picture, HOMES.c.picture_type).where(HOMES.c.id == home, HOMES.c.owner == owner)
        with self._database.reading() as connection:
            row = connection.execute(asked).first()
        if row is None:
            raise _no_such(home)
        return None if row.picture is None else (row.picture, row.picture_type)

    def put_picture(self, owner: str, home: str, content: bytes, media_type: str) -> None:
        """Gives a home another picture; that is no change of the home.

        Raises:
            NoSuchThing: this owner has no such home.
            TooManyKept: the owner has no room for it.
        """
        with self._database.writing() as connection:
            _held(connection, owner, home, ANY_REVISION)
            before = connection.scalar(select(func.length(HOMES.c.picture)).where(HOMES.c.id == home)) or 0
            self._take(connection, owner, 0, len(content) - int(before))
            connection.execute(update(HOMES).where(HOMES.c.id == home).values(picture=content, picture_type=media_type))

    def _take(self, connection: Connection, owner: str, homes: int, size: int) -> None:
        """Counts what an owner has more, or less; refuses what is too much. The row is held until the transaction ends."""
        dialect = postgresql if connection.dialect.name == "postgresql" else sqlite
        connection.execute(dialect.insert(OWNERS).values(name=owner, homes=0, bytes=0).on_conflict_do_nothing())
        fits = [OWNERS.c.homes + homes <= self._keeping.homes] * (homes > 0) + [OWNERS.c.bytes + size <= self._keeping.bytes] * (size > 0)
        more = {"homes": OWNERS.c.homes + homes, "bytes": OWNERS.c.bytes + size}
        if connection.execute(update(OWNERS).where(OWNERS.c.name == owner, *fits).values(more)).rowcount == 0:
            most = f"{self._keeping.homes} homes, of {self._keeping.bytes // 1_000_000} MB together"
            raise TooManyKept("homes", "are as many as may be kept, or as large", f"{most}; remove some first")


def _written(texts: Mapping[str, Any]) -> dict[str, str]:
    tags: tuple[str, ...] = tuple(texts["tags"])
    words = _folded("\n".join([texts["name"], texts["notes"], *tags]))
    return {"name": texts["name"], "notes": texts["notes"], "tags": "".join(f"\n{tag}" for tag in tags) + "\n", "words": words}


def _folded(text: str) -> str:
    """Returns a text as it is sought: small letters, however they were typed; those of a large I with a dot are an i."""
    return normalize("NFC", normalize("NFC", text).casefold().replace("i\u0307", "i"))


def _read(row: Row[Any]) -> HomeHead:
    told = {**row._asdict(), "tags": _tags(row), "created": moment(row.created), "changed": moment(row.changed)}
    return HomeHead(**told, link=f"./?home={row.id}")


def _tags(row: Row[Any]) -> tuple[str, ...]:
    return tuple(tag for tag in row.tags.split("\n") if tag)


def _matching(wanted: HomeQuery) -> list[ColumnElement[bool]]:
    words = [HOMES.c.words.contains(word, autoescape=True) for word in _folded(wanted.search).split()]
    return [*words, *(HOMES.c.tags.contains(f"\n{tag}\n", autoescape=True) for tag in wanted.tag)]


def _found(connection: Connection, owner: str, home: str, for_change: bool = False) -> Row[Any]:
    asked = select(*SHOWN).where(HOMES.c.id == home, HOMES.c.owner == owner)
    row = connection.execute(asked.with_for_update() if for_change else asked).first()
    if row is None:
        raise _no_such(home)
    return row


def _held(connection: Connection, owner: str, home: str, revisions: Revisions) -> Row[Any]:
    """Returns a home that nobody else changes until the transaction ends, if it is of one of those revisions."""
    found = _found(connection, owner, home, for_change=True)
    if revisions is None:
        raise UnnamedRevision("If-Match", "is missing", "the ETag that the home was read with, or * for whichever there is")
    if found.revision not in revisions:
        raise ChangedMeanwhile("If-Match", "is of another revision: somebody has changed the home since", f'"{found.revision}"')
    return found


def _no_such(home: str) -> NoSuchThing:
    return NoSuchThing("home", f"there is no {home!r:.40}", "the id of a home of yours")
