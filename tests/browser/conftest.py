"""What the browser tests share: the real service, and a visit to its page."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Page, expect

from tests.browser.service_process import ServiceProcess, running
from tests.browser.visit import ANSWER_MS, Visit

expect.set_options(timeout=ANSWER_MS)


@pytest.fixture(scope="session")
def service() -> Iterator[ServiceProcess]:
    """The real service, one for all tests of a run."""
    with running() as process:
        yield process


@pytest.fixture
def visit(page: Page, service: ServiceProcess) -> Visit:
    """A browser page that has not opened anything yet; small, since without a graphics card every pixel counts."""
    page.set_viewport_size({"width": 1000, "height": 600})
    return Visit(page, service.address)
