"""What the store keeps of each owner's homes, and in whose turn: asked of it without calls, SQLite and PostgreSQL alike."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path
from threading import Barrier, Event, Thread
from typing import Any

import pytest
from sqlalchemy import select, text

from service.kept_contract import ANY_REVISION, HomeQuery, PackedScene
from service.problems import StoreAway
from service.store.database import VERSIONS, Database
from service.store.saved_homes import KEPT_VERSIONS, Keeping, SavedHomes
from solver.errors import FieldError
from tests.service.heavy import PATIENCE_S

SCENE: dict[str, Any] = {"rooms": [{"id": "den", "type": "office", "width": 4.0, "depth": 3.0}]}


def test_an_owner_keeps_so_many_and_so_much(place: str) -> None:
    with closing(Database(place)) as database:
        homes = SavedHomes(database, Keeping(homes=2, bytes=100))
        texts = {"name": "a", "notes": "", "tags": ()}
        kept = [homes.add("carla", texts, PackedScene(b"1" * 40, 1)) for _ in range(2)]
        for refused in (
            lambda: homes.add("carla", texts, PackedScene(b"", 1)),
            lambda: homes.change("carla", kept[0].id, {1}, {}, PackedScene(b"1" * 30, 1)),
        ):
            with pytest.raises(FieldError, match="2 homes, of 0 MB"):
                refused()
        homes.add("dora", texts, PackedScene(b"1" * 40, 1))
        homes.put_picture("carla", kept[0].id, b"1" * 20, "image/png")
        homes.put_picture("carla", kept[0].id, b"1" * 10, "image/png")
        homes.remove("carla", kept[0].id, {1})
        homes.change("carla", kept[1].id, {1}, {}, PackedScene(b"1" * 60, 1))
        homes.remove("carla", kept[1].id, {2})
        assert [homes.list("carla", HomeQuery()).total for _ in range(2)] == [0, 0]
        with database.reading() as connection:
            assert connection.execute(text("SELECT homes, bytes FROM owners WHERE name = 'carla'")).one() == (0, 0)


def kept_time(database: Database, home: str) -> int:
    with database.reading() as connection:
        return int(connection.execute(text("SELECT changed FROM homes WHERE id = :home"), {"home": home}).scalar_one())


def test_a_clock_that_jumps_hides_no_home_and_no_change(place: str) -> None:
    now, texts = [1_700_000_000 * 10**9], {"name": "a", "notes": "", "tags": ()}
    with closing(Database(place)) as database:
        homes = SavedHomes(database, clock=lambda: now[0])
        kept = set[str]()
        for jump_s in (0, 86_400, -86_400 * 900, 3, 86_400 * 900):
            now[0] += jump_s * 10**9
            kept.add(homes.add("finn", texts, PackedScene(b"1", 1)).id)
        first = homes.list("finn", HomeQuery(limit=1)).homes[0]
        now[0] -= 86_400 * 10**9
        before = kept_time(database, first.id)
        changed = homes.change("finn", first.id, {first.revision}, {"name": "b"}, PackedScene(b"2", 1))
        assert kept_time(database, first.id) > before and homes.list("finn", HomeQuery()).homes[0] == changed
        found, after = list[str](), ""
        while True:
            page = homes.list("finn", HomeQuery(limit=2, after=after))
            found += [home.id for home in page.homes]
            if page.after is None:
                break
            after = page.after
        assert len(found) == len(kept) and set(found) == kept
        for home in found:
            homes.remove("finn", home, ANY_REVISION)


class Line(list[Any]):
    """Those who wait for their turn; knows who came and who went, in order."""

    def __init__(self) -> None:
        super().__init__()
        self.came, self.went = list[Any](), list[Any]()

    def append(self, one: Any) -> None:
        self.came.append(one)
        super().append(one)

    def remove(self, one: Any) -> None:
        self.went.append(one)
        super().remove(one)


def test_many_who_write_without_pause_let_another_write_in_his_turn(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By order: who asks first writes first, so that between two writes of one the others have a turn each, and never hundreds."""
    others = 7
    with closing(Database(str(tmp_path / "homes.sqlite"))) as database:
        homes, ended, begun = SavedHomes(database), Event(), Barrier(others + 1)
        home = homes.add("gil", {"name": "a", "notes": "", "tags": ()}, PackedScene(b"1", 1)).id
        line = Line()
        monkeypatch.setattr(database._turns, "_line", line)

        def write() -> None:
            homes.put_picture("gil", home, b"picture", "image/png")
            begun.wait(PATIENCE_S)
            while not ended.is_set():
                homes.put_picture("gil", home, b"picture", "image/png")

        threads = [Thread(target=write) for _ in range(others)]
        for thread in threads:
            thread.start()
        try:
            begun.wait(PATIENCE_S)
            for _ in range(60):
                with database.writing():
                    pass
        finally:
            ended.set()
            for thread in threads:
                thread.join()
        assert line.went == line.came
        assert len(line.came) >= 60 + others


def test_a_turn_that_does_not_come_is_said_and_holds_nobody_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("service.store.database.WAIT_S", 0.05)
    with closing(Database(str(tmp_path / "homes.sqlite"))) as database:
        refusals: list[str] = []

        def write() -> None:
            with pytest.raises(StoreAway) as refused, database.writing():
                pass
            refusals.append(refused.value.field)

        with database.writing():
            threads = [Thread(target=write) for _ in range(3)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
        assert refusals == ["store"] * 3
        with database.writing() as connection:
            assert connection.scalar(text("SELECT COUNT(*) FROM homes")) == 0


def test_the_oldest_versions_go(place: str) -> None:
    with closing(Database(place)) as database:
        homes = SavedHomes(database, Keeping(bytes=KEPT_VERSIONS + 1))
        home = homes.add("emil", {"name": "a", "notes": "", "tags": ()}, PackedScene(b"1", 1)).id
        for revision in range(1, KEPT_VERSIONS + 10):
            homes.change("emil", home, {revision}, {}, PackedScene(b"1", 1))
        numbers = [number for number, _ in homes.versions("emil", home)]
        assert numbers == list(range(KEPT_VERSIONS + 10, 10, -1))
        homes.remove("emil", home, ANY_REVISION)


def test_a_home_goes_with_its_versions_and_no_others(place: str) -> None:
    with closing(Database(place)) as database:
        homes = SavedHomes(database, Keeping())
        gone, stays = (homes.add("fay", {"name": "a", "notes": "", "tags": ()}, PackedScene(b"1", 1)).id for _ in range(2))
        for home in (gone, stays):
            homes.change("fay", home, {1}, {}, PackedScene(b"2", 1))
        homes.remove("fay", gone, ANY_REVISION)
        with database.reading() as connection:
            left = connection.execute(select(VERSIONS.c.home, VERSIONS.c.number).where(VERSIONS.c.home.in_((gone, stays)))).all()
        assert sorted(map(tuple, left)) == [(stays, 1), (stays, 2)]
        homes.remove("fay", stays, ANY_REVISION)
