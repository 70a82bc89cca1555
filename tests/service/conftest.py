"""What the tests of the service share: a house to send back to the application, and applications with a store of either kind."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from starlette.testclient import TestClient

from service.admission import Admitted
from service.app import ComposeApp, create_app
from service.keys import KeyRing
from service.service_settings import Settings
from tests.service.heavy import PATIENCE_S
from tests.service.stores import KEYS, postgresql

SMALL = {"seed": 42, "width": 8.0, "depth": 6.0}
"""A request whose house is made quickly."""


@pytest.fixture(scope="session", autouse=True)
def patient_store() -> Iterator[None]:
    """On busy cores a writer's turn may come late: no test of this process is about how long a store waits, but who says so."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("service.store.database.WAIT_S", PATIENCE_S)
        yield


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


@pytest.fixture(scope="module", params=["sqlite", "postgresql"])
def place(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Where homes and jobs are kept."""
    if request.param == "sqlite":
        yield str(tmp_path_factory.mktemp("store") / "deep" / "homes.sqlite")
        return
    with postgresql() as server:
        yield server.url


@pytest.fixture(scope="module")
def app(place: str) -> Iterator[ComposeApp]:
    """An application that keeps its homes and jobs there, for those with KEYS."""
    settings = Settings(allow_host=("*",), store=place, request_seconds=PATIENCE_S)
    app = create_app(settings=settings, admitted=Admitted(KeyRing(KEYS.items())))
    with TestClient(app) as entered:
        app.state.portal = entered.portal
        yield app
