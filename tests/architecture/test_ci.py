"""What CI calls is there: a step that is no target ends the run before any test."""

from __future__ import annotations

import re

from tests.architecture.tree import ROOT


def test_every_step_of_ci_is_a_target() -> None:
    targets = set(re.findall(r"^([\w./-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    called = [
        word
        for line in re.findall(r"^step make (.+)$", (ROOT / ".ci" / "run").read_text(encoding="utf-8"), re.MULTILINE)
        for word in line.split()
    ]
    named = [word for word in called if not word.startswith("-")]
    assert {"lint", "test"} <= set(named) <= targets
