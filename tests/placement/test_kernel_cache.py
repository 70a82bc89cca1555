"""The cache of compiled code: cold or warm, the same bytes; and nothing of earlier sources is left after set-up."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib import import_module
from pathlib import Path

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


def test_a_cold_cache_gives_the_same_bytes_as_a_warm_one(tmp_path: Path) -> None:
    cold = started(tmp_path)
    made, errors = cold.communicate()
    assert cold.returncode == 0, errors.decode()
    compiled = files(tmp_path)
    assert len([path for path in compiled if path.suffix == ".nbc"]) > 50
    assert not [path for path in compiled if ".tmp." in path.name]
    own, everyones = started(tmp_path), started(None)
    assert own.communicate()[0] == everyones.communicate()[0] == made
    assert len(made) > 10_000
    assert files(tmp_path) == compiled


def test_set_up_leaves_no_code_of_earlier_sources(tmp_path: Path) -> None:
    warm = import_module("solver.placement.kernel.__main__")
    current = tmp_path / "0123456789abcdef"
    for name in (current.name, "fedcba9876543210", "0000000000000000", "something_else", "fedcba9876543210.lock"):
        (tmp_path / name).mkdir()
    (tmp_path / "1111111111111111").write_text("a file")
    assert [path.name for path in warm.outdated(current)] == ["0000000000000000", "fedcba9876543210"]
