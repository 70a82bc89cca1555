"""`compose dataset check`: nothing is wrong with what was made, and what is changed is found."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from service.cli import main

Captured = pytest.CaptureFixture[str]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("datasets") / "set"
    asked = ["dataset", "--width", "6", "--depth", "5", "--seeds", "0-7", "--shard-size", "4", "--workers", "1", "--formats", "json,csv"]
    assert main([*asked, "--out", str(path)]) == 0
    return path


def test_nothing_is_wrong_with_what_was_made(folder: Path, capfd: Captured) -> None:
    assert main(["dataset", "check", str(folder), "--all"]) == 0
    assert "8 homes, " in (words := capfd.readouterr().err) and "8 homes made again and validated: nothing is wrong" in words
    assert main(["dataset", "check", str(folder), "--sample", "3"]) == 0
    assert "3 homes made again" in capfd.readouterr().err


def _house(folder: Path) -> Path:
    return folder / "tables" / "houses" / "train-000000.parquet"


def _delete(folder: Path) -> None:
    _house(folder).unlink()


def _append(folder: Path) -> None:
    with next((folder / "archives").glob("*.tar")).open("ab") as file:
        file.write(b"more")


def _count(folder: Path) -> None:
    manifest = folder / "dataset.json"
    manifest.write_text(manifest.read_text().replace('"houses": 8', '"houses": 9'))


def _digest(folder: Path) -> None:
    record = folder / "shards" / "000001.json"
    text = record.read_text()
    at = text.index('"digests"') + 20
    record.write_text(text[:at] + ("0" if text[at] != "0" else "1") + text[at + 1 :])


def _column(folder: Path) -> None:
    """Writes a table with another column, and says in the record that it is so."""
    import json
    from hashlib import sha256

    table = pq.read_table(_house(folder))
    pq.write_table(table.append_column("more", pa.array([1] * len(table))), _house(folder))
    record = folder / "shards" / "000000.json"
    document = json.loads(record.read_text())
    document["files"]["tables/houses/train-000000.parquet"]["sha256"] = sha256(_house(folder).read_bytes()).hexdigest()
    record.write_text(json.dumps(document))


@pytest.mark.parametrize(
    ("harm", "words"),
    [
        (_delete, "train-000000.parquet is missing"),
        (_append, "is not as it was written"),
        (_count, "the manifest says"),
        (_digest, "the homes' digest is"),
        (_column, "has other columns"),
    ],
)
def test_what_is_changed_is_found(folder: Path, tmp_path: Path, capfd: Captured, harm: Callable[[Path], None], words: str) -> None:
    shutil.copytree(folder, tmp_path / "set")
    harm(tmp_path / "set")
    assert main(["dataset", "check", str(tmp_path / "set"), "--sample", "1"]) == 1
    assert words in capfd.readouterr().err


def test_homes_of_another_version_are_not_made_again(folder: Path, capfd: Captured, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("service.dataset.dataset_plan.VERSION", "9.9.9")
    assert main(["dataset", "make", str(folder), "--seed", "3"]) == 2
    assert "its version is" in capfd.readouterr().err


@pytest.mark.parametrize("option", ["-f", "--format", "--formats"])
def test_a_home_is_made_in_either_format_of_scenes_and_no_other(
    folder: Path, capfdbinary: pytest.CaptureFixture[bytes], option: str
) -> None:
    assert main(["dataset", "make", str(folder), "--seed", "3", option, "yaml"]) == 0
    assert capfdbinary.readouterr().out.startswith(b"format: compose-scene/1")
    assert main(["dataset", "make", str(folder), "--seed", "3", option, "csv"]) == 2
    assert b"'csv', which is of another task (allowed: json, yaml)" in capfdbinary.readouterr().err
    assert main(["dataset", "--out", str(folder / "new"), "--seeds", "0-1", option, "yaml"]) == 2
    assert b"'yaml', which is of another task (allowed: json, csv" in capfdbinary.readouterr().err


def test_a_folder_that_holds_no_dataset_is_said(tmp_path: Path, capfd: Captured) -> None:
    for asked in (["check", str(tmp_path)], ["make", str(tmp_path), "--seed", "1"], ["check"], ["make"], []):
        assert main(["dataset", *asked]) == 2
        assert "Traceback" not in capfd.readouterr().err
