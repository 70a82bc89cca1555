"""`make page-bench`: what the page costs, as tables for BENCHMARKS.md."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import dataclass

from playwright.sync_api import Browser, Page, sync_playwright

from tests.browser.cost import (
    BUILT,
    DRAWN,
    HOME,
    LEAST,
    MAX_DRAW_CALLS,
    MAX_SCRIPT_BYTES,
    WRITTEN,
    Cost,
    Steps,
    Summary,
    Took,
    clock,
    counts,
    cpu,
    measured,
    script_bytes,
    thinned,
    traced,
)
from tests.browser.first_picture import MAX_FIRST_S, first_picture_s
from tests.browser.service_process import running
from tests.browser.test_rooms_and_files import DROP
from tests.browser.visit import Visit
from tests.chromium import FLAGS, bring

TIMES = 20
MAX_REBUILD_MS = 50
"""What a rebuild may take of the processor of the machine that the figures are measured on."""
OPENINGS = 3
"""Pages opened anew."""
OTHERS = 10
"""Houses asked for one after another."""
TEXT_SHOWN = "if (location.protocol === 'http:') localStorage.setItem('compose.reading', 'shown')"
"""In windows so small the text is folded away at first, and then it is not written."""


@dataclass(frozen=True)
class Asked:
    """Houses asked for one after another: steps, and all that the page's thread did for each, ms."""

    steps: Steps
    whole: Sequence[float]
    pieces: Sequence[tuple[int, int]]


class PageThread:
    """The thread on which the page's script, layout and style run."""

    def __init__(self, page: Page) -> None:
        self._session = page.context.new_cdp_session(page)
        self._session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def busy_ms(self) -> float:
        """Returns how long it was busy since this began, on its processor."""
        found = {entry["name"]: entry["value"] for entry in self._session.send("Performance.getMetrics")["metrics"]}
        return float(found["TaskDuration"]) * 1000


def opened(visit: Visit) -> Took:
    """Opens a page on a home; returns how long building it took."""
    with traced(visit.page) as trace:
        visit.open(HOME)
    return trace.steps[BUILT][0]


def asked(visit: Visit) -> Asked:
    """Asks an open page for others like its home."""
    whole, pieces, thread = [], [], PageThread(visit.page)
    with traced(visit.page) as trace:
        for _ in range(OTHERS):
            before = thread.busy_ms()
            answer = visit.after(lambda: visit.page.locator("#random").click())
            whole.append(thread.busy_ms() - before)
            pieces.append(counts(answer["scene"]))
    return Asked(trace.steps, whole, pieces)


def show(visit: Visit, scene: dict[str, object]) -> None:
    """Drops a scene on the page."""
    assert visit.page.evaluate(DROP, ["home.json", json.dumps(scene)])
    visit.page.wait_for_function("title => document.title === title", arg="Compose: home.json")
    visit.settle()


def words(times: Summary) -> str:
    """Returns the median and the longest."""
    return f"{times.median:.1f}, {times.longest:.1f}"


def seconds(times: Summary) -> str:
    """Returns the median and the longest, to hundredths."""
    return f"{times.median:.2f}, {times.longest:.2f}"


def both(took: Sequence[Took]) -> str:
    """Returns two cells: on the processor, by the clock."""
    return f"{words(cpu(took))} | {words(clock(took))}"


def times_table(costs: Sequence[Cost], firsts: Sequence[Took], others: Asked) -> str:
    """Returns the times as a Markdown table."""
    wanted = f"{MAX_REBUILD_MS} at most"
    rebuilds = [(f"rebuilt: {cost.furniture} + {cost.decorations}", both(cost.rebuilds), wanted) for cost in costs]
    furniture, decorations = zip(*others.pieces, strict=True)
    pieces = f"{min(furniture)}-{max(furniture)} + {min(decorations)}-{max(decorations)}"
    rows = [
        *rebuilds,
        (f"built first after the page was opened, {OPENINGS} pages", both(firsts), ""),
        (f"another house built: {pieces}", both(others.steps[BUILT]), ""),
        ("its first frame, script of it", both(others.steps[DRAWN]), ""),
        ("its readable YAML shown", both(others.steps[WRITTEN]), ""),
        ("all that the page does from the press of Random to the YAML shown", f"{words(Summary.of(others.whole))} | ", ""),
    ]
    head = ["| median, longest [ms] | processor | clock | wanted |", "|---|---|---|---|"]
    return "\n".join([*head, *(f"| {' | '.join(row)} |" for row in rows)])


def other_table(cost: Cost, pictures: Sequence[tuple[float, float]]) -> str:
    """Returns the other figures as a Markdown table."""
    started, first = (Summary.of(times) for times in zip(*pictures, strict=True))
    rows = [
        ("draw calls without the shadow pass", f"{cost.draw_calls}", f"{MAX_DRAW_CALLS} at most"),
        ("draw calls of the shadow pass", f"{cost.shadow_calls}", ""),
        ("triangles", f"{cost.triangles:,}", ""),
        ("frames while the browser shows 60 and nothing changes", f"{cost.idle_frames}", "0"),
        ("first picture, all processes of a new Chromium: median, longest [s of CPU]", seconds(first), f"{MAX_FIRST_S} at most"),
        ("of which before the page", seconds(started), ""),
        ("page script, gzip [KB]", f"{script_bytes() / 1024:.0f}", f"{MAX_SCRIPT_BYTES // 1024} at most"),
    ]
    return "\n".join(["| of that home | measured | wanted |", "|---|---|---|", *(f"| {' | '.join(row)} |" for row in rows)])


def fresh(browser: Browser, address: str) -> Visit:
    """Returns a visit by a page of its own; those before it are closed."""
    for context in browser.contexts:
        context.close()
    page = browser.new_page(viewport={"width": 1000, "height": 600})
    page.add_init_script(TEXT_SHOWN)
    return Visit(page, address)


def main() -> int:
    """Measures the built page in headless Chromium and prints the tables; returns 1 where a rebuild takes too long."""
    path = bring()
    with running() as service, sync_playwright() as playwright:
        pictures = [first_picture_s(playwright, path, service.address) for _ in range(OPENINGS)]
        browser = playwright.chromium.launch(executable_path=path, args=FLAGS)
        firsts = []
        for _ in range(OPENINGS):
            visit = fresh(browser, service.address)
            firsts.append(opened(visit))
        others = asked(visit)
        scene = visit.open(HOME)["scene"]
        whole = measured(visit, TIMES)
        show(visit, thinned(scene, LEAST))
        print(times_table([measured(visit, TIMES), whole], firsts, others), other_table(whole, pictures), sep="\n\n")
        browser.close()
    return int(cpu(whole.rebuilds).median > MAX_REBUILD_MS)


if __name__ == "__main__":
    sys.exit(main())
