"""The catalogs that are kept in the user's cache folder: the same as those read, and never served when they are not."""

from __future__ import annotations

import pickle
from functools import lru_cache
from pathlib import Path
from unittest import mock

import pytest

from catalogs import cached, reading
from catalogs.schema import Catalogs


@pytest.fixture(autouse=True)
def fresh(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A cache folder of its own, and nothing known yet.

    Other tests go on with the catalogs that they had: what is kept by them is looked up by comparing them, at length where they are others.
    """
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr(cached, "_ours", lru_cache(maxsize=1)(cached._ours.__wrapped__))


def loaded() -> Catalogs:
    """What a new process would load."""
    cached._ours.cache_clear()
    return cached.load_catalogs()


def cache_file() -> Path:
    """Where they are kept."""
    found = cached.cache_file()
    assert found is not None
    return found


def test_what_is_kept_is_what_was_read(monkeypatch: pytest.MonkeyPatch) -> None:
    read = loaded()
    assert read == reading.read_catalogs()
    assert [path.name for path in cache_file().parent.iterdir()] == ["catalogs.pickle"]
    monkeypatch.setattr(reading, "read_catalogs", lambda: pytest.fail("they were read again"))
    again = loaded()
    assert again == read and again is not read
    assert list(again.furniture) == list(read.furniture)
    assert cached.load_catalogs() is again


def test_another_source_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = mock.Mock(return_value=loaded())
    monkeypatch.setattr(cached, "source_digest", lambda: b"\1" * 32)
    monkeypatch.setattr(reading, "read_catalogs", asked)
    loaded(), loaded()
    assert asked.call_count == 1


def test_every_file_counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cached, "HERE", tmp_path)
    digests = {cached.source_digest()}
    for name in ("furniture.yaml", "rooms/den.yaml", "schema.py", "assets/entry.py"):
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        for content in ("a: 1", "a: 2"):
            path.write_text(content)
            digests.add(cached.source_digest())
    assert len(digests) == 9


@pytest.mark.parametrize("at", [0, 40, 100, -1])
def test_what_is_damaged_is_read_again(at: int) -> None:
    read = loaded()
    content = bytearray(cache_file().read_bytes())
    content[at] ^= 255
    cache_file().write_bytes(content)
    assert loaded() == read
    assert cache_file().read_bytes() != bytes(content)


def test_nothing_but_types_of_the_catalogs_is_made() -> None:
    source, harmful = cached.source_digest(), pickle.dumps(Path("/"))
    cache_file().parent.mkdir(parents=True)
    cache_file().write_bytes(source + cached._of(harmful) + harmful)
    assert isinstance(loaded(), Catalogs)


def test_a_cache_that_cannot_be_had_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert loaded().furniture
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setattr(Path, "home", lambda: (_ for _ in ()).throw(RuntimeError))
    assert cached.cache_file() is None
    assert loaded().furniture
