"""The cache of compiled code: cold or warm, the same bytes; one process compiles, says so, and others wait for it."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

import pytest

from solver.placement.kernel import cache
from tests.placement.cold_cache import SAID, files, started

TINY = ("-m", "tests.placement.tiny_kernel")


def test_of_two_processes_with_a_cold_cache_one_compiles_and_says_so(tmp_path: Path) -> None:
    """A kernel of one function; that of placement is compiled in `python -m tests.targets kernel`."""
    both = [started(tmp_path, *TINY), started(tmp_path, *TINY)]
    answers = [process.communicate() for process in both]
    assert [(process.returncode, made) for process, (made, _) in zip(both, answers, strict=True)] == [(0, b"42\n")] * 2, answers
    assert sorted(errors.decode().count("\n") for _, errors in answers) == [0, 1]
    assert SAID in answers[0][1] + answers[1][1]
    compiled = files(tmp_path)
    assert len([path for path in compiled if path.suffix == ".nbc"]) == 1
    assert not [path for path in compiled if ".tmp." in path.name]
    assert started(tmp_path, *TINY).communicate() == (b"42\n", b"")
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
