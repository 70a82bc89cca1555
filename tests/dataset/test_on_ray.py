"""`compose dataset --ray`: a local cluster makes the same bytes as processes do, and goes on where those ended."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from service.cli import main
from solver.errors import FieldError
from tests.dataset.test_building import contents

SMALL = ("dataset", "--width", "6", "--depth", "5", "--seeds", "0-11", "--shard-size", "3", "--formats", "json,csv")


def test_a_cluster_makes_the_same_bytes_and_is_told_of_faults_of_the_core(tmp_path: Path) -> None:
    """In a process of its own, whose core has a fault before Ray begins, in Ray's processes, and after Ray has ended."""
    assert main([*SMALL, "--workers", "1", "--out", str(tmp_path / "pool")]) == 0
    assert main([*SMALL, "--workers", "1", "--out", str(tmp_path / "ray"), "--seeds", "0-4"]) == 0
    words = (*SMALL, "--workers", "2", "--out", str(tmp_path / "ray"), "--ray")
    assert subprocess.run([sys.executable, "-m", "tests.dataset.ray_jobs", *words], check=False).returncode == 0
    assert contents(tmp_path / "ray") == contents(tmp_path / "pool")


def test_a_cluster_that_is_not_there_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*SMALL, "--out", str(tmp_path / "ray"), "--ray", "127.0.0.1:9"]) == 2
    assert "--ray: nothing answers at 127.0.0.1:9" in capsys.readouterr().err


def test_a_cluster_that_is_too_slow_to_start_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    import ray

    from service.dataset.on_ray import LOCAL, on_cluster

    def too_slow(*_: object, **__: object) -> None:
        raise Exception("The current node timed out during startup.")

    monkeypatch.setattr(ray, "init", too_slow)
    with pytest.raises(FieldError, match="timed out during startup"):
        list(on_cluster(len, ["a job"], 2, LOCAL))
