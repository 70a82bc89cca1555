"""What a store is, and what is none: the tables it is made with, and the places it may be at."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from sqlalchemy import text
from starlette.testclient import TestClient

from service.app import create_app
from service.service_settings import Settings
from service.store.database import TABLES, Database
from solver.errors import FieldError
from tests.service.problems import problem_of


def test_the_migrations_make_the_tables_that_are_used(place: str) -> None:
    with closing(Database(place)) as database, database.reading() as connection:
        assert compare_metadata(MigrationContext.configure(connection), TABLES) == []


def test_a_store_of_a_later_version_is_refused(tmp_path: Path) -> None:
    place = str(tmp_path / "homes.sqlite")
    with closing(Database(place)) as database, database.writing() as connection:
        connection.execute(text("UPDATE alembic_version SET version_num = '9999'"))
    with pytest.raises(FieldError, match="later version"):
        Database(place)


@pytest.mark.parametrize("place", ["mysql://a@b/c", "sqlite://", "nonsense://x", "postgresql://[", "{file}/under.sqlite", "{folder}"])
def test_what_is_no_place_for_a_store_is_said(tmp_path: Path, place: str) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(FieldError, match="store"):
        Database(place.format(file=tmp_path / "file", folder=tmp_path))


def test_without_a_store_the_rest_is_answered() -> None:
    client = TestClient(create_app(settings=Settings(allow_host=("*",), store="none")))
    assert problem_of(client.get("/homes"))["status"] == 503
    assert client.get("/schema").status_code == 200
