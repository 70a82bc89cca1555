"""`make page-bench`: what the page costs, as a table for BENCHMARKS.md."""

from __future__ import annotations

from playwright.sync_api import sync_playwright

from tests.browser.cost import MAX_DRAW_CALLS, MAX_REBUILD_MS, MAX_SCRIPT_BYTES, Cost, measured
from tests.browser.service_process import running
from tests.browser.visit import Visit
from tests.chromium import FLAGS, bring

TIMES = 20


def table(cost: Cost) -> str:
    """Returns the figures as a Markdown table."""
    rows = [
        ("furniture, decorations", f"{cost.furniture}, {cost.decorations}", "150, 150 at least"),
        ("scene rebuilt, median of 20 [ms of script]", f"{cost.median_ms:.1f}", f"{MAX_REBUILD_MS} at most"),
        ("scene rebuilt, longest of 20 [ms of script]", f"{max(cost.rebuilds):.1f}", ""),
        ("draw calls without the shadow pass", f"{cost.draw_calls}", f"{MAX_DRAW_CALLS} at most"),
        ("draw calls of the shadow pass", f"{cost.shadow_calls}", ""),
        ("triangles", f"{cost.triangles:,}", ""),
        ("frames in a second in which nothing changes", f"{cost.idle_frames}", "0"),
        ("page script, gzip [KB]", f"{cost.script_bytes / 1024:.0f}", f"{MAX_SCRIPT_BYTES // 1024} at most"),
    ]
    lines = ["| of a decorated large home | measured | wanted |", "|---|---|---|", *(f"| {' | '.join(row)} |" for row in rows)]
    return "\n".join(lines)


def main() -> None:
    """Measures the built page in headless Chromium and prints the table."""
    path = bring()
    with running() as service, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=FLAGS)
        page = browser.new_page(viewport={"width": 1000, "height": 600})
        print(table(measured(Visit(page, service.address), TIMES)))
        browser.close()


if __name__ == "__main__":
    main()
