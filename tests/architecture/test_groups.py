"""The tests of one file share a worker of a parallel run: what a fixture of theirs makes is made once."""

from __future__ import annotations

import pytest


def test_a_parallel_run_keeps_files_together(request: pytest.FixtureRequest) -> None:
    """What pytest-xdist gives to one worker has the group's name behind an `@` at the end of its node id."""
    groups: dict[str, set[str]] = {}
    for item in request.session.items:
        groups.setdefault(str(item.path), set()).add(item.nodeid.rpartition("]")[2].partition("@")[2])
    assert {path: names for path, names in groups.items() if len(names) > 1} == {}
    grouped = bool(request.config.getoption("loadgroup", False))
    assert [path for path, names in groups.items() if ("" not in names) != grouped] == [], "`make dev` brings the pinned pytest"
