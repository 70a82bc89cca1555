"""Fixtures of the core's tests."""

from __future__ import annotations

import pytest

from tests.core.native import Native


@pytest.fixture(scope="session")
def native(tmp_path_factory: pytest.TempPathFactory) -> Native:
    """The native build, compiled once."""
    return Native(tmp_path_factory.mktemp("native"))
