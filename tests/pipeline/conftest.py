"""Fixtures of the pipeline's tests."""

from __future__ import annotations

import pytest

from solver.validator import RULES


@pytest.fixture
def geometry_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Makes `unreachable` no error, in rooms too full to walk in; test_fix_walking has the ways."""
    monkeypatch.setitem(RULES, "unreachable", "warning")
