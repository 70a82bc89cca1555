"""`compose generate --count`: a folder of homes, whole files only, the same for any number of processes, and resumed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from service.cli import main
from service.many import MADE_FROM
from solver.exchange import load_text
from solver.whole_files import write_whole

SMALL = ("generate", "--width", "7", "--depth", "6", "--seed", "11", "-n", "5")


def made(folder: Path, *more: str) -> dict[str, bytes]:
    """What a run leaves in its folder."""
    assert main([*SMALL, "-o", str(folder), *more]) == 0
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    return made(tmp_path_factory.mktemp("alone"), "--workers", "1")


def test_each_seed_has_its_file(alone: dict[str, bytes]) -> None:
    assert sorted(alone) == [*(f"{seed}.yaml" for seed in range(11, 16)), MADE_FROM]
    for seed in range(11, 16):
        scene = load_text(alone[f"{seed}.yaml"], "yaml")
        assert isinstance(scene, dict) and scene["request"]["seed"] == seed


def test_the_number_of_processes_changes_no_byte(alone: dict[str, bytes], tmp_path: Path) -> None:
    assert made(tmp_path, "--workers", "2") == alone


def test_what_was_ended_goes_on(alone: dict[str, bytes], tmp_path: Path) -> None:
    made(tmp_path, "--workers", "1", "-n", "2")
    (tmp_path / "12.yaml").unlink()
    kept = (tmp_path / "11.yaml").stat().st_mtime_ns
    assert made(tmp_path, "--workers", "1") == alone
    assert (tmp_path / "11.yaml").stat().st_mtime_ns == kept


def test_homes_of_another_request_need_another_folder(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    before = made(tmp_path, "--workers", "1", "-n", "1")
    assert main([*SMALL, "-o", str(tmp_path), "--style", "rustic"]) == 2
    assert "another version, catalog or request" in capfd.readouterr().err
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before
    assert json.loads(before[MADE_FROM])["request"] == {"width": 7.0, "depth": 6.0}


def test_a_wrong_request_is_refused_by_its_field(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main([*SMALL, "-o", str(tmp_path), "--width", "-3", "--workers", "1"]) == 2
    assert "width" in capfd.readouterr().err
    assert list(tmp_path.glob("*.yaml")) == []
    assert len(made(tmp_path, "--workers", "1", "-n", "1")) == 2


@pytest.mark.parametrize("ended", [OSError(28, "No space left on device"), KeyboardInterrupt("Ctrl-C")])
def test_a_file_is_whole_or_as_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ended: BaseException) -> None:
    path = tmp_path / "home.yaml"
    write_whole(path, b"before")

    def full(self: Path, content: bytes) -> int:
        with self.open("wb") as file:
            file.write(content[:3])
        raise ended

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(type(ended), match=r"No space|Ctrl-C"):
        write_whole(path, b"afterwards")
    assert [(one.name, one.read_text()) for one in tmp_path.iterdir()] == [("home.yaml", "before")]


def test_what_cannot_be_written_is_called_by_its_own_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """On a disk that is not written to nothing can be taken away either."""

    def refused(self: Path, *_: object, **__: object) -> None:
        raise OSError(30, "Read-only file system", str(self))

    monkeypatch.setattr(Path, "write_bytes", refused)
    monkeypatch.setattr(Path, "unlink", refused)
    with pytest.raises(OSError, match="Read-only") as caught:
        write_whole(tmp_path / "home.yaml", b"a home")
    assert caught.value.filename == str(tmp_path / "home.yaml")
