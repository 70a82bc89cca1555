"""What long work tells of itself where standard error is a file: lines, none of them overwritten; where it is closed, nothing."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from service import progress
from service.cli import main

MANY = ("generate", "--width", "5", "--depth", "4", "--seed", "3", "-n", "3", "--workers", "1")


def test_a_file_is_told_line_by_line(tmp_path: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress, "EVERY_S", 0.0)
    assert main([*MANY, "-o", str(tmp_path)]) == 0
    told = capfd.readouterr().err
    assert "\r" not in told
    assert [line for line in told.splitlines() if " of 3 " in line] == ["1 of 3 houses", "2 of 3 houses", "3 of 3 houses"]


def test_nobody_need_listen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", None)
    assert main([*MANY, "-o", str(tmp_path)]) == 0
    assert len(list(tmp_path.glob("*.yaml"))) == 3
