"""What a furnished, decorated home costs the page: script time, draw calls, frames, bytes."""

from __future__ import annotations

import gzip
import json
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from statistics import median

from playwright.sync_api import Page

from tests.browser.service_process import ROOT
from tests.browser.visit import Document, Visit

HOME = "?program=large&area=340&decorate=true&seed=41"
"""A home with at least `LEAST` pieces of furniture and as many decorations."""
LEAST = 150
WARM_UPS = 3
IDLE_FRAMES = 60
MAX_DRAW_CALLS = 400
MAX_DRAW_CALLS_EDITING = 60
"""While a piece is dragged, with its frame and the floor it may go to."""
MAX_SCRIPT_BYTES = 320 * 1024
ASSETS = ROOT / "service" / "static" / "assets"

BUILT, DRAWN, WRITTEN, FOLLOWED = "house built", "house drawn", "text shown", "drag followed"
"""The steps whose ends the page marks for the browser's performance tools (web/src/timing.ts)."""


@dataclass(frozen=True)
class Took:
    """How long a step of the page's script took: by the clock, and on its processor without what other programs did meanwhile."""

    clock_ms: float
    cpu_ms: float


Steps = dict[str, list[Took]]


@dataclass
class Trace:
    """What the browser recorded; `steps` is filled when the recording ends."""

    steps: Steps = field(default_factory=dict)


@contextmanager
def traced(page: Page) -> Iterator[Trace]:
    """Record the steps that the page takes within the block."""
    browser = page.context.browser
    assert browser is not None
    trace = Trace()
    browser.start_tracing(page=page, categories=["blink.user_timing"])
    yield trace
    trace.steps = _steps_of(json.loads(browser.stop_tracing())["traceEvents"])


def _steps_of(events: Sequence[Document]) -> Steps:
    steps: Steps = {}
    begun: dict[str, Document] = {}
    for event in sorted((event for event in events if event["ph"] in "IR"), key=lambda event: event["ts"]):
        step, _, end = event["name"].partition(": ")
        if end == "start":
            begun[step] = event
        elif end == "end":
            start = begun[step]
            took = Took((event["ts"] - start["ts"]) / 1000, (event["tts"] - start["tts"]) / 1000)
            steps.setdefault(step, []).append(took)
    return steps


@dataclass(frozen=True)
class Summary:
    """The middle one and the longest of several times, in their unit."""

    median: float
    longest: float

    @staticmethod
    def of(times: Sequence[float]) -> Summary:
        """Returns the summary of at least one time."""
        return Summary(median(times), max(times))


def cpu(took: Sequence[Took]) -> Summary:
    """Returns the summary of the steps' processor times."""
    return Summary.of([one.cpu_ms for one in took])


def clock(took: Sequence[Took]) -> Summary:
    """Returns the summary of the steps' times by the clock."""
    return Summary.of([one.clock_ms for one in took])


@dataclass(frozen=True)
class Cost:
    """Figures of one home: its `rebuilds`, what a frame costs, `idle_frames` drawn while the browser shows 60 in which nothing changes."""

    furniture: int
    decorations: int
    rebuilds: tuple[Took, ...]
    draw_calls: int
    shadow_calls: int
    triangles: int
    idle_frames: int


def script_bytes() -> int:
    """Returns how many bytes the page's scripts are, each packed by gzip."""
    return sum(len(gzip.compress(path.read_bytes(), 9)) for path in ASSETS.glob("*.js"))


def counts(scene: Document) -> tuple[int, int]:
    """Returns how many pieces of furniture and how many decorations a scene has."""
    rooms = scene["rooms"]
    return sum(len(room["furniture"]) for room in rooms), sum(len(room["decorations"]) for room in rooms)


def measured(visit: Visit, times: int) -> Cost:
    """Measures the home that is shown.

    Args:
        visit: a page that shows a home and is at rest.
        times: how many rebuilds to measure, after those that warm up.
    """
    idle = visit.idle(IDLE_FRAMES)
    with traced(visit.page) as trace:
        for _ in range(times + WARM_UPS):
            visit.page.evaluate("compose.rebuild()")
            visit.settle()
    frame: Document = visit.page.evaluate("compose.measure(0)")
    furniture, decorations = counts(visit.page.evaluate("compose.scene"))
    return Cost(
        furniture=furniture,
        decorations=decorations,
        rebuilds=tuple(trace.steps[BUILT][WARM_UPS:]),
        draw_calls=frame["drawCalls"],
        shadow_calls=frame["shadowCalls"],
        triangles=frame["triangles"],
        idle_frames=idle,
    )


def thinned(scene: Document, most: int) -> Document:
    """Returns the scene with this many decorations, dealt among the rooms in turn; none stays without what it lies on."""
    kept = {piece["id"] for room in scene["rooms"] for piece in room["furniture"]}
    longest = max(len(room["decorations"]) for room in scene["rooms"])
    dealt: set[str] = set()
    for i in range(longest):
        for room in scene["rooms"]:
            piece = room["decorations"][i] if i < len(room["decorations"]) else None
            if piece and len(dealt) < most and (piece.get("parent") is None or piece["parent"] in kept | dealt):
                dealt.add(piece["id"])
    rooms = [{**room, "decorations": [piece for piece in room["decorations"] if piece["id"] in dealt]} for room in scene["rooms"]]
    return {**scene, "rooms": rooms}
