"""What every test shares: repeatable random examples, and which tests share a worker of a parallel run."""

from __future__ import annotations

import gc
import os
import signal
from collections.abc import Generator, Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers
from hypothesis.internal.constants_ast import Constants

from tests.sweeps import times

if TYPE_CHECKING:
    from starlette.testclient import TestClient

# The same examples are drawn every time, so that a change is what a failure speaks of; `make targets` draws 25 times as many.
# A busy machine draws slowly, which is no fault of a test.
SLOW = [HealthCheck.too_slow]
settings.register_profile(
    "repeatable", derandomize=True, deadline=None, max_examples=times(600, 24), database=None, suppress_health_check=SLOW
)
settings.load_profile("repeatable")

NO_CONSTANTS = Constants()
"""Hypothesis mixes in constants of the modules loaded so far, which other tests of a worker decide: then examples would not repeat."""
providers._get_local_constants = lambda: NO_CONSTANTS

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as nohup and `&` leave it: what tests start would never hear Ctrl-C
    signal.signal(signal.SIGINT, signal.default_int_handler)

BROWSERS = 2
"""Workers with a Chromium and a service of their own; each takes memory, and seconds to begin, and draws without a graphics card."""
BROWSER_TESTS = Path(__file__).parent / "browser"
GENERATED_CALLS = Path(__file__).parent / "service" / "test_openapi_cases.py"
"""The longest file beside the browser's."""
TOGETHER = ("architecture", "exports")
"""Folders whose tests read, or make, and load once in a process what is much: all sources; described homes and what reads their files."""
ONCE = {"client": "service", "native": "native build"}
"""Fixtures that one worker makes for all, and what the group of their tests is called."""

OPENED_ANEW = "page opened anew"
"""What is told of a test of the browser that could not go on with the page of the one before, or left one that nobody goes on with."""

GARBAGE = (100_000, 20, 5)
"""After how many new objects the youngest, the younger and all are looked through for garbage that holds itself."""


@pytest.fixture(scope="session")
def client() -> Iterator[TestClient]:
    """A client of an application with our own catalogs and much time; a failure of the service comes back as its answer."""
    from starlette.testclient import TestClient

    from service.app import EMBEDDED, create_app
    from tests.service.heavy import PATIENCE_S

    with TestClient(create_app(settings=replace(EMBEDDED, request_seconds=PATIENCE_S)), raise_server_exceptions=False) as client:
        yield client


def pytest_xdist_auto_num_workers() -> int:
    """A worker more than cores: those of the browser's and the service's tests wait for other processes much of their time."""
    return (os.cpu_count() or 1) + 1


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collect the tests without looking for garbage, and never look through them again: all of this stays to the end.

    Later too it is looked for rarely: little of what tests leave holds itself, and what they keep for each other is much to look through.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(*GARBAGE)
        gc.enable()


def opens_a_page(item: pytest.Item) -> bool:
    """Whether a test of the browser opens a page of its own."""
    return any(item.get_closest_marker(name) for name in ("own_page", "draws_all"))


@pytest.hookimpl(wrapper=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> Generator[None]:
    """Share the tests, file by file, among the workers of a parallel run, so that what a file makes for its tests is made once.

    The browser's files go to few workers, dealt there and back, those that call the application to one: each starts a service. They take
    longest and are begun first, as are other long ones: whoever began one last would go on alone when all else is done. Files of a folder
    that have much in common go to one too.

    Among the browser's, those that hand a page on go before those that open their own. A wrapper comes before pytest-xdist, which reads
    the marks in the same hook.
    """
    paths = sorted({item.path for item in items})
    groups = {path: f"browser {(at + 1) // 2 % BROWSERS}" for at, path in enumerate(path for path in paths if path.parent == BROWSER_TESTS)}
    groups |= {path: f"folder {path.parent.name}" for path in paths if path.parent.name in TOGETHER}
    groups[GENERATED_CALLS] = "generated calls"
    for item in items:
        for fixture in ONCE.keys() & getattr(item, "fixturenames", ()):
            groups.setdefault(item.path, ONCE[fixture])
    for item in items:
        item.add_marker(pytest.mark.xdist_group(groups.get(item.path) or item.nodeid.partition("::")[0]))
    items.sort(key=lambda item: (groups.get(item.path, "to others"), opens_a_page(item)))
    yield


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say which pages of the browser's tests were not handed on, and why: each costs a second, and nothing else tells."""
    reports = [one for name in ("", "error") for one in terminalreporter.getreports(name) if one.when == "teardown"]
    anew = {one.nodeid: [why for name, why in one.user_properties if name == OPENED_ANEW] for one in reports}
    for test, reasons in anew.items():
        if reasons:
            terminalreporter.write_line(f"{OPENED_ANEW}: {test}: {'; '.join(reasons[:3])}"[:400])


def pytest_unconfigure() -> None:
    """Look for garbage once more, as what was left open is told of there; pytest would do so five times, and Python thrice as it ends."""
    gc.collect()
    gc.freeze()
