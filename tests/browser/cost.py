"""What a furnished, decorated home costs the page: script time, draw calls, frames, bytes."""

from __future__ import annotations

import gzip
from dataclasses import dataclass
from statistics import median

from tests.browser.service_process import ROOT
from tests.browser.visit import Document, Visit

HOME = "?program=large&area=320&decorate=true&seed=2"
"""A home with at least `LEAST` pieces of furniture and as many decorations."""
LEAST = 150
WARM_UPS = 3
IDLE_MS = 1000
MAX_REBUILD_MS = 50
MAX_DRAW_CALLS = 400
MAX_SCRIPT_BYTES = 250 * 1024
ASSETS = ROOT / "service" / "static" / "assets"


@dataclass(frozen=True)
class Cost:
    """Figures of one home: `rebuilds` in ms of script time, `idle_frames` drawn within a second in which nothing changes."""

    furniture: int
    decorations: int
    rebuilds: tuple[float, ...]
    draw_calls: int
    shadow_calls: int
    triangles: int
    idle_frames: int
    script_bytes: int

    @property
    def median_ms(self) -> float:
        """The middle one of the rebuilds, ms."""
        return median(self.rebuilds)


def script_bytes() -> int:
    """Returns how many bytes the page's scripts are, each packed by gzip."""
    return sum(len(gzip.compress(path.read_bytes(), 9)) for path in ASSETS.glob("*.js"))


def measured(visit: Visit, times: int) -> Cost:
    """Opens the home and measures it.

    Args:
        visit: a page that has opened nothing yet.
        times: how many rebuilds to measure, after those that warm up.
    """
    rooms = visit.open(HOME)["scene"]["rooms"]
    frames = visit.state()["frames"]
    visit.page.wait_for_timeout(IDLE_MS)
    idle = visit.state()["frames"] - frames
    found: Document = visit.page.evaluate("times => compose.measure(times)", times + WARM_UPS)
    return Cost(
        furniture=sum(len(room["furniture"]) for room in rooms),
        decorations=sum(len(room["decorations"]) for room in rooms),
        rebuilds=tuple(found["rebuilds"][WARM_UPS:]),
        draw_calls=found["drawCalls"],
        shadow_calls=found["shadowCalls"],
        triangles=found["triangles"],
        idle_frames=idle,
        script_bytes=script_bytes(),
    )
