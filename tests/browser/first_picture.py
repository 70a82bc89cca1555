"""What the first picture costs: the CPU of all processes of a new Chromium, from its start to the home drawn at a bare address."""

from __future__ import annotations

import os
from pathlib import Path

from playwright.sync_api import Playwright, ViewportSize

from tests.browser.service_process import descendants
from tests.browser.visit import ANSWER_MS
from tests.chromium import FLAGS

LAPTOP: ViewportSize = {"width": 1440, "height": 900}
MAX_FIRST_S = 2.5
TELL = """new PerformanceObserver((list, observer) => {
    if (!list.getEntries().some((entry) => entry.name === 'house drawn: end')) return;
    observer.disconnect();
    requestAnimationFrame(() => requestAnimationFrame(() => {
        const gl = document.querySelector('#stage > canvas').getContext('webgl2');
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        firstPicture();
    }));
}).observe({ entryTypes: ['mark'] });"""
"""Tells when the home has been drawn: the reading waits for what draws."""
TICKS = os.sysconf("SC_CLK_TCK")


def _cpu_s(process: int) -> float:
    """Returns what a process and those of its own that have ended took of the processor [s]."""
    try:
        fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0.0
    return sum(int(ticks) for ticks in fields[11:15]) / TICKS


def first_picture_s(playwright: Playwright, path: Path, address: str) -> tuple[float, float]:
    """Returns the CPU [s] of a new Chromium at an empty page, and when it shows the first picture of the page at an address. Linux only.

    What the service starts meanwhile is not counted.
    """
    before = set(descendants(os.getpid()))
    browser = playwright.chromium.launch(executable_path=path, args=FLAGS)
    launched = set(descendants(os.getpid())) - before

    def spent() -> float:
        return sum(_cpu_s(one) for one in launched.union(*(descendants(one) for one in launched)))

    page = browser.new_page(viewport=LAPTOP)
    shown: list[float] = []
    page.expose_binding("firstPicture", lambda _source: shown.append(spent()))
    page.add_init_script(TELL)
    started = spent()
    page.goto(address, timeout=ANSWER_MS)
    while not shown:
        page.wait_for_timeout(100)
    browser.close()
    return started, shown[0]
