"""The cache of compiled code: cold or warm, the same bytes; one process compiles, says so, and others wait for it."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

from solver.placement.kernel import cache

ROOT = Path(__file__).parents[2]
PROGRAM = "import sys; from tests.pipeline.test_same_bytes import house; sys.stdout.buffer.write(house(5))"


def started(cache: Path | None) -> subprocess.Popen[bytes]:
    """Starts a process that prints a house, with a cache of its own or with everyone's."""
    own = {} if cache is None else {"NUMBA_CACHE_DIR": str(cache)}
    return subprocess.Popen(
        [sys.executable, "-c", PROGRAM], cwd=ROOT, env={**os.environ, **own}, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )


def files(cache: Path) -> set[Path]:
    return {path.relative_to(cache) for path in cache.rglob("*") if path.is_file()}


def test_of_two_processes_with_a_cold_cache_one_compiles_and_says_so(tmp_path: Path) -> None:
    both = [started(tmp_path), started(tmp_path)]
    answers = [process.communicate() for process in both]
    assert [process.returncode for process in both] == [0, 0], answers
    assert sorted(errors.decode().count("\n") for _, errors in answers) == [0, 1]
    assert b"compiling the placement kernel" in answers[0][1] + answers[1][1]
    compiled = files(tmp_path)
    assert len([path for path in compiled if path.suffix == ".nbc"]) > 50
    assert not [path for path in compiled if ".tmp." in path.name]
    own, everyones = started(tmp_path).communicate(), started(None).communicate()
    assert {own[0], everyones[0], *(made for made, _ in answers)} == {own[0]}
    assert len(own[0]) > 10_000
    assert own[1] == b""
    assert files(tmp_path) == compiled


def test_where_one_folder_cannot_be_written_the_next_is_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setattr(cache, "roots", lambda: [tmp_path / "file", tmp_path / "next"])
    assert cache.folder() == tmp_path / "next" / cache.digest()
    monkeypatch.setattr(cache, "roots", lambda: [tmp_path / "file"])
    assert cache.folder() is None


def test_code_that_cannot_be_kept_is_announced_all_the_same(capsys: pytest.CaptureFixture[str]) -> None:
    with cache.one_compiles(None, ()):
        pass
    assert "no folder to keep it in" in capsys.readouterr().err


def test_what_was_compiled_for_another_machine_is_compiled_anew(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for machine, lines in (("one", 1), ("one", 0), ("other", 1), ("one", 0)):
        with cache.one_compiles(tmp_path, (machine,)):
            pass
        assert capsys.readouterr().err.count("\n") == lines


def test_an_end_before_all_was_compiled_is_no_whole_cache(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(KeyboardInterrupt), cache.one_compiles(tmp_path, ()):
        raise KeyboardInterrupt
    with cache.one_compiles(tmp_path, ()):
        pass
    assert capsys.readouterr().err.count("compiling") == 2


def test_set_up_leaves_no_code_of_earlier_sources(tmp_path: Path) -> None:
    warm = import_module("solver.placement.kernel.__main__")
    current = tmp_path / "0123456789abcdef"
    for name in (current.name, "fedcba9876543210", "0000000000000000", "something_else", "fedcba9876543210.lock"):
        (tmp_path / name).mkdir()
    (tmp_path / "1111111111111111").write_text("a file")
    assert [path.name for path in warm.outdated(current)] == ["0000000000000000", "fedcba9876543210"]
