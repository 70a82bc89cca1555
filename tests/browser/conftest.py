"""What the browser tests share: a Chromium, the real service, and a visit to its page."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, ViewportSize, expect, sync_playwright

from tests.browser.service_process import ServiceProcess, running
from tests.browser.visit import ANSWER_MS, AT_REST, CAN_GO_ON, FORGET, PROBE, WINDOW, Visit
from tests.browser.ways import Touch, Way
from tests.chromium import FLAGS, executable
from tests.conftest import OPENED_ANEW, opens_a_page

DESK: ViewportSize = {"width": 1280, "height": 800}
PHONE: ViewportSize = {"width": 390, "height": 800}
PIXEL_RATIO = 0.5
"""The canvas has a pixel for two of CSS each way: without a graphics card every pixel costs."""

JAGGED = "--webgl-antialiasing-mode=none"
"""Smooth edges cost as much as all else that is drawn, and no test looks at them."""

ONE_PROCESS = "--process-per-site"
"""Pages of one window share a process, so that only the first has to start one and to compile what all of them load."""

NO_TRIANGLES = """{
    const counted = {drawArrays: [2], drawElements: [1], drawArraysInstanced: [2, 3], drawElementsInstanced: [1, 4]};
    const gl = WebGL2RenderingContext.prototype;
    for (const [name, counts] of Object.entries(counted)) {
        const draw = gl[name];
        gl[name] = function (...told) {
            for (const at of counts) told[at] = 0;
            draw.apply(this, told);
        };
    }
}"""
"""Every call to draw is made, with none of its thousands of triangles: no shader runs, which is most of a frame without a graphics card."""

UNSEEN = """{
    globalThis.unseen = new CSSStyleSheet();
    unseen.replaceSync('@media screen { html { opacity: 0; } }');
    addEventListener('DOMContentLoaded', () => document.adoptedStyleSheets.push(unseen));
}"""
"""All has its place, its colours and its turn, but nothing is painted, nor put together with the canvas: half of what a frame costs."""
UNWATCHED = NO_TRIANGLES + UNSEEN

SHOWN = """if (location.protocol === 'http:') {
    for (const name of ['reading', 'home', 'furnishing', 'view', 'files']) localStorage.setItem(`compose.${name}`, 'shown');
    localStorage.setItem('compose.tour', 'seen');
}"""
"""Most tests read the text and fill in the form: folded away at first in windows so small, they are not reached. None takes the tour."""
KEPT = "async () => location.protocol === 'http:' ? localStorage.length + (await indexedDB.databases()).length : 0"
"""How much a page has put where the next one finds it."""
KEPT_BESIDE_HOMES = KEPT.replace("length : 0", "filter(one => one.name !== 'compose').length : 0")
"""The same beside the homes, which a page that is handed on still holds open: it forgets them itself, once it shows the next."""
LEAVE = f"""async isClosed => {{
    const isLeft = !isClosed && ({AT_REST})(), goesOn = isLeft && ({CAN_GO_ON})();
    await (goesOn ? () => localStorage.clear() : {FORGET})();
    const kept = await (goesOn ? {KEPT_BESIDE_HOMES} : {KEPT})();
    if (isLeft && kept === 0) {{
        {SHOWN}
        performance.clearMarks();
        performance.clearMeasures();
    }}
    const asFirst = '(prefers-reduced-motion: reduce) and (prefers-color-scheme: light) and (forced-colors: none)';
    return [isLeft, goesOn, kept, matchMedia(asFirst).matches];
}}"""
"""Has a page forget what it keeps, and, unless it is closed, remember what a new one does: all at once, as each call to a page costs.

Tells whether it is at rest, whether it can go on to another home, how much it keeps all the same, and whether it looks as new ones do.
"""

expect.set_options(timeout=ANSWER_MS)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """A headless Chromium with WebGL, one for the whole run."""
    path = executable()
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=[*FLAGS, JAGGED, ONE_PROCESS], timeout=ANSWER_MS)
        yield chromium
        chromium.close()


def window(browser: Browser, size: ViewportSize = WINDOW, **more: Any) -> BrowserContext:
    """Where pages of a size open that show no flights, and what else a browser can be told of itself."""
    return browser.new_context(viewport=size, device_scale_factor=PIXEL_RATIO, reduced_motion="reduce", **more)


def keep_open(context: BrowserContext, service: ServiceProcess) -> None:
    """Keeps a window and the process of its pages, by a page that stays: a new one of either costs as much as a page."""
    context.new_page().goto(service.address + PROBE.removeprefix("/"), timeout=ANSWER_MS)


@contextmanager
def visiting(browser: Browser, address: str, size: ViewportSize = WINDOW, **more: Any) -> Iterator[Visit]:
    """A visit in a window of its own that keeps nothing of any other, and of which nobody looks at what is drawn."""
    context = window(browser, size, **more)
    context.add_init_script(UNWATCHED)
    yield Visit(context.new_page(), address)
    context.close()


@pytest.fixture(scope="session")
def context(browser: Browser, service: ServiceProcess) -> Iterator[BrowserContext]:
    """Where pages of 1000 x 600 open that show no flights; what they load stays compiled, what they remember ends with each."""
    context = window(browser)
    keep_open(context, service)
    context.add_init_script(SHOWN)
    yield context
    context.close()


@pytest.fixture(scope="session")
def handed_on() -> list[Page]:
    """The page that tests hand on from one to the next, where there is one."""
    return []


@pytest.fixture
def page(request: pytest.FixtureRequest, context: BrowserContext, handed_on: list[Page]) -> Iterator[Page]:
    """A page that remembers nothing: one handed on, or, for tests marked `own_page`, a new one; what else it leaves, or throws, fails.

    Only that of a test marked `draws_all`, a new one too, draws all that a person would see.
    """
    is_own = opens_a_page(request.node)
    if is_own and handed_on:
        close(handed_on.pop())
    page = handed_on.pop() if handed_on else opened(context, draws_all=request.node.get_closest_marker("draws_all") is not None)
    faults: list[str] = []
    page.on("pageerror", lambda fault: faults.append(str(fault)))
    failed = request.session.testsfailed
    yield page
    is_closed = is_own or request.session.testsfailed > failed
    is_left, goes_on, kept, as_first = page.evaluate(LEAVE, is_closed)
    if not (is_own or goes_on):
        request.node.user_properties.append((OPENED_ANEW, f"left at {page.url}, {'at rest' if is_left else 'not at rest'}"))
    left = (context.cookies(), kept)
    if is_left and (left, faults) == (([], 0), []):
        make_ready(page, as_first)
        handed_on.append(page)
    else:
        page.close()
    context.clear_permissions()
    assert faults == []
    assert left == ([], 0), "the next page would find this"


def opened(context: BrowserContext, *, draws_all: bool) -> Page:
    """A new page that draws all, or as little as does for who looks at no picture."""
    page = context.new_page()
    if not draws_all:
        page.add_init_script(UNWATCHED)
    return page


def close(page: Page) -> None:
    """Closes a page and forgets what it keeps."""
    page.evaluate(FORGET)
    page.close()


def make_ready(page: Page, as_first: bool) -> None:
    """Takes back what a test has told the browser of a page; what it did in the page, `Visit.open` finds."""
    page.unroute_all()
    if not as_first:
        page.emulate_media(reduced_motion="reduce", color_scheme="light", forced_colors="none")
    if page.viewport_size != WINDOW:
        page.set_viewport_size(WINDOW)
    page.mouse.move(0, 0)


@pytest.fixture(scope="session")
def service() -> Iterator[ServiceProcess]:
    """The real service, one for all tests of a run."""
    with running() as process:
        yield process


@pytest.fixture
def visit(request: pytest.FixtureRequest, page: Page, service: ServiceProcess) -> Iterator[Visit]:
    """A browser page that has not opened anything yet."""
    visit = Visit(page, service.address, hands_on=not opens_a_page(request.node))
    yield visit
    request.node.user_properties += [(OPENED_ANEW, other) for other in visit.found_other]


@pytest.fixture(scope="module")
def way(request: pytest.FixtureRequest, browser: Browser, service: ServiceProcess) -> Iterator[Way]:
    """A page for somebody who works in one way, in which the module's `begin` has begun."""
    is_phone = request.param is Touch
    with visiting(browser, service.address, PHONE if is_phone else DESK, has_touch=is_phone, is_mobile=is_phone) as visit:
        visit.page.context.add_init_script(SHOWN)
        visit.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
        made: Way = request.param(visit)
        request.module.begin(made)
        yield made


@pytest.fixture
def moving(visit: Visit) -> Visit:
    """A visit of someone to whom the page shows what moves."""
    visit.page.emulate_media(reduced_motion="no-preference")
    return visit
