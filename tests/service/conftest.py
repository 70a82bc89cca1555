"""What the tests of the service share: a client of the application, and a house to send back to it."""

from __future__ import annotations

from typing import Any

import pytest
from starlette.testclient import TestClient

SMALL = {"seed": 42, "width": 8.0, "depth": 6.0}
"""A request whose house is made quickly."""


@pytest.fixture(scope="session")
def house(client: TestClient) -> dict[str, Any]:
    """The answer to SMALL."""
    answer = client.post("/generate", json=SMALL)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


@pytest.fixture
def scene(house: dict[str, Any]) -> dict[str, Any]:
    """The scene of the house."""
    return dict(house["scene"])
