"""A visit to the page: what it shows, what it asked for, and what it said on the console."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

from playwright.sync_api import Locator, Page, Request, Response, Route, ViewportSize

from tests.architecture.tree import ROOT

Document: TypeAlias = dict[str, Any]

ANSWER_MS = 240_000
"""A guard against a page that never answers: far beyond a busy machine, below the time after which pytest shows where a test hangs."""
POLL_MS = 40
WINDOW: ViewportSize = {"width": 1000, "height": 600}
"""In which pages are opened, and handed on."""
FRAMES = "count => new Promise(done => { const next = () => count-- > 0 ? requestAnimationFrame(next) : done(); next(); })"
IN_WORK = ".plan-sheet[aria-busy=true]:not([hidden])"
"""What the page shows while the plan is drawn again."""
MARK_LEFT = "() => { globalThis.left = compose.scene; }"
MOVED = "before => JSON.stringify([compose.state.eye, compose.state.target]) !== JSON.stringify(before)"
TURNED = """([eye, target, least]) => {
    const now = compose.state;
    const [was, is] = [[eye, target], [now.eye, now.target]].map(([from, to]) => Math.atan2(to[0] - from[0], to[2] - from[2]));
    return Math.abs(Math.atan2(Math.sin(is - was), Math.cos(is - was))) * 180 / Math.PI >= least;
}"""
"""Whether one has turned by so many degrees at least, fewer than 180, since one looked so."""
AT_REST = f"""() => document.querySelector('#stage')?.ariaBusy === 'false' && globalThis.compose?.state?.moving === false
    && document.querySelector("{IN_WORK}") === null"""
"""Whether nothing is under way, as `Visit.settle` has it."""
COME_TO_REST = f"""async patience => {{
    const end = performance.now() + patience;
    await new Promise(requestAnimationFrame);
    while (!({AT_REST})() && performance.now() < end) await new Promise(done => setTimeout(done, 16));
    return ({AT_REST})();
}}"""
"""Waits for that in the page itself, from its next frame on: until then it has begun what it puts off to one. Further frames would cost."""
FORGET = """() => location.protocol !== 'http:' || new Promise((done, fail) => {
    for (const kept of [localStorage, sessionStorage]) kept.clear();
    const gone = indexedDB.deleteDatabase('compose');
    gone.onsuccess = () => done(true);
    gone.onerror = gone.onblocked = () => fail(new Error('the homes stay'));
})"""
"""Forgets the homes that the page keeps, what a person chose about it, and what it keeps of its tab: done once they are gone."""
CAN_GO_ON = """() => location.protocol === 'http:' && location.pathname === '/' && 'foundNew' in sessionStorage
    && sessionStorage.length === 2"""
"""Whether a page is one that was looked at when it was new, and it keeps nothing but that; it may have been loaded again since."""
OPEN_ANOTHER = """address => {
    const shuts = ['#palette:not([hidden]) .palette-head button', '#camera_split[aria-pressed=true]', '.fold[aria-expanded=false]',
        '#drawing:not([hidden]) [data-tool=close]'];
    for (const one of document.querySelectorAll('dialog[open]')) one.close();
    for (const one of document.querySelectorAll('dialog details[open]')) one.open = false;
    const chosen = Object.keys(localStorage);
    for (const one of document.querySelectorAll(shuts)) one.click();
    document.querySelector('#camera_corner').click();
    for (const one of document.querySelectorAll('#view :is(input, #plan_scale), #find')) {
        if (one.type === 'checkbox' && one.checked !== one.defaultChecked) one.click();
        if (one.type === 'checkbox' || one.value === (one.defaultValue ?? '')) continue;
        one.value = one.defaultValue ?? '';
        for (const told of ['input', 'change']) one.dispatchEvent(new Event(told, {bubbles: true}));
    }
    for (const one of document.querySelectorAll('details.group')) one.open = JSON.parse(sessionStorage.unfolded).includes(one.id);
    for (const name of Object.keys(localStorage).filter(one => !chosen.includes(one))) localStorage.removeItem(name);
    document.activeElement.blur();
    history.pushState(null, '', address);
    dispatchEvent(new PopStateEvent('popstate'));
}"""
"""Puts back what a person can put back, and goes to another home."""
FORGET_OTHERS = """async () => {
    const [recent, list, clear] = ['recent', 'recent_list', 'recent_clear'].map(id => document.getElementById(id));
    list.replaceChildren();
    recent.open = true;
    for (let looks = 0; looks < 200 && !(clear.disabled && list.children.length === 1); looks += 1) {
        if (list.children.length > 1) for (let time = 0; time < 2; time += 1) clear.click();
        await new Promise(done => setTimeout(done, 10));
    }
    recent.open = false;
    const room = document.getElementById('room_choice');
    if (room.value !== '') { room.value = ''; room.dispatchEvent(new Event('change', {bubbles: true})); }
    for (const panel of document.querySelectorAll('#controls, #reading, #yaml')) panel.scrollTop = 0;
    document.querySelector('#camera_corner').click();
}"""
"""Has the page forget all homes but the one that it shows, and look at that as at a first one: there is nothing to go back to."""
OF_HOMES = "#yaml > *, #issues, #shortfalls, #shortfall_line, #legend_rooms, #storey, #no_rooms, #request, #furnish_now, #decorate_now"
ASIDE = "dialog:not([open]) *, #palette[hidden] *, #drawing[hidden] *"
"""What is asked for anew, or begun anew, when it is opened."""
CONTROLS = f"""() => JSON.stringify([
    [...document.querySelectorAll('[id], [data-tool], :popover-open')].filter(one => !one.closest('{OF_HOMES}, {ASIDE}')).map(one => [
        one.id, one.dataset.tool, one.className, one.checkVisibility(), one.open, one.checked, one.disabled,
        one.matches('select, [type=range], [type=search]') && one.value, one.ariaPressed === 'true', one.ariaExpanded,
        one.scrollTop,
    ]),
    document.activeElement.id, window.scrollY, document.documentElement.lang, {{...localStorage}},
    compose.state.selected, compose.state.marks.flagged, compose.state.openFronts, compose.state.lowered, compose.state.walking,
])"""
"""What a person sees of the page that speaks of no home; the form does."""
FOUND_NEW = f"""() => {{
    sessionStorage.foundNew = ({CONTROLS})();
    sessionStorage.unfolded = JSON.stringify([...document.querySelectorAll('details.group[open]')].map(one => one.id));
}}"""
OTHER_THAN_NEW = f"""async patience => {{
    if (!await ({COME_TO_REST})(patience)) return null;
    await ({FORGET_OTHERS})();
    if (!await ({COME_TO_REST})(patience)) return null;
    const [before, now] = [sessionStorage.foundNew, ({CONTROLS})()].map(text => {{
        const [ofElements, ...others] = JSON.parse(text);
        return [ofElements.length, ...ofElements, ...others].map(one => JSON.stringify(one));
    }});
    return now.filter((one, at) => one !== before[at]);
}}"""
"""What of that is other than it was when the page was new, once it has forgotten the homes before: nothing, where it is as new."""
DRIVER = "GL Driver Message (OpenGL, Performance"
"""What a software renderer says of its own pace, mostly when the machine is busy: no word of the page's."""
SAID: dict[str, str] = json.loads((ROOT / "web" / "src" / "words" / "names.en.json").read_text(encoding="utf-8"))
"""Names that are said otherwise than they are written."""
PROBE = "/healthz"
UNTIL_TAKEN = f"""async () => {{
    while (await (await fetch('{PROBE}')).text() !== 'taken');
}}"""
SMALL = "?width=12&depth=9&seed={}"
"""A house that is made and drawn fast, by its seed."""


class Visit:
    """The page, opened at a service; `answers` holds what the service answered to each call."""

    def __init__(self, page: Page, address: str, *, hands_on: bool = False) -> None:
        self.page = page
        page.context.set_default_timeout(ANSWER_MS)  # for what a test asks the service itself, too
        self.address, self.hands_on = address, hands_on
        self.handed_on = page.url.startswith(address)
        self.found_other: list[str] = []
        self.console: list[str] = []
        self.requests: list[str] = []
        self.answers: list[Document] = []
        page.on("console", lambda message: self._heard(f"{message.type}: {message.text} {message.location}"))
        page.on("request", lambda request: self.requests.append(request.url) if not request.url.endswith(PROBE) else None)

    def _heard(self, said: str) -> None:
        if DRIVER not in said:
            self.console.append(said)

    def open(self, query: str = "") -> Document:
        """Open the page and wait for its house; returns the answer to /generate.

        A page that tests hand on goes to the house by itself, and stays if it is as a new page would be: in the window that all have had,
        before it is in another. A new one, which is handed on next, begins in that window too.
        """
        size = self.page.viewport_size
        if not self.hands_on or size == WINDOW:
            return self._opened(query)
        assert size
        self.page.set_viewport_size(WINDOW)
        answer = self._opened(query)
        self.page.set_viewport_size(size)
        self.page.locator("#camera_corner").dispatch_event("click")
        self.settle()
        return answer

    def _opened(self, query: str) -> Document:
        if self.handed_on:
            self.handed_on = False
            if self.page.evaluate(CAN_GO_ON):
                with self.page.expect_response(_generated) as caught:
                    self.page.evaluate(OPEN_ANOTHER, self.address + query)
                self.found_other = self.page.evaluate(OTHER_THAN_NEW, ANSWER_MS)
                assert self.found_other is not None, "the page does not come to rest"
                if self.found_other == []:
                    answer: Document = caught.value.json()
                    return answer
                self.page.evaluate(FORGET)
                for heard in (self.console, self.requests, self.answers):
                    heard.clear()
        answer = self.after(lambda: self._load(query))
        if self.hands_on:
            self.page.locator("#export_format option").first.wait_for(state="attached")  # what comes last of all
            self.page.evaluate(FOUND_NEW)
        return answer

    def _load(self, query: str) -> None:
        self.page.goto(self.address + query)
        assert self.page.evaluate("'compose' in globalThis"), f"the page's script does not run: {self.console}"

    def after(self, act: Callable[[], object]) -> Document:
        """Do something that makes a house, wait until it is shown, return the answer to /generate."""
        with self.page.expect_response(_generated) as caught:
            act()
        self.settle()
        answer: Document = caught.value.json()
        return answer

    def reopened(self, act: Callable[[], object]) -> Document:
        """Do something that opens a home that the browser keeps, wait until it is shown, return its scene."""
        self.page.evaluate(MARK_LEFT)
        act()
        self.page.wait_for_function("() => globalThis.compose?.scene && compose.scene !== globalThis.left")
        self.settle()
        scene: Document = self.page.evaluate("compose.scene")
        return scene

    def settle(self) -> None:
        """Wait until no call and no edit is under way, the plan is drawn and nothing moves."""
        assert self.page.evaluate(COME_TO_REST, ANSWER_MS), "the page does not come to rest"

    def idle(self, frames: int = 30) -> int:
        """How many frames the page draws while the browser shows so many."""
        before: int = self.state()["frames"]
        self.page.evaluate(FRAMES, frames)
        after: int = self.state()["frames"]
        return after - before

    def held(self, key: str, turn: float | None = None) -> None:
        """Hold a key until what one looks from or at has changed; or, where it is given, until one has turned by so many degrees."""
        before = self.state()
        seen = [before["eye"], before["target"]]
        self.page.keyboard.down(key)
        if turn is None:
            self.page.wait_for_function(MOVED, arg=seen)
        else:
            self.page.wait_for_function(TURNED, arg=[*seen, turn])
        self.page.keyboard.up(key)
        self.settle()

    def state(self) -> Document:
        """What the page says it shows."""
        shown: Document = self.page.evaluate("compose.state")
        return shown

    def click_on(self, id_of: str) -> bool:
        """Click on a body or a door in the canvas; false where something stands before it."""
        at = self.page.evaluate("id => compose.whereIs(id)", id_of)
        if at is None:
            return False
        self.page.mouse.click(at["x"], at["y"])
        return True

    def count(self, name: str) -> int:
        """A number of the status bar."""
        return int(self.page.locator(f"[data-count={name}]").inner_text())

    def yaml(self) -> str:
        """The readable YAML as shown."""
        return "\n".join(self.page.locator("#yaml > *").all_inner_texts())

    def line_of(self, id_of: str) -> Locator:
        """The line of the readable YAML that speaks of a body."""
        return self.page.locator(f'#yaml button[data-id="{id_of}"]').first


def intercept(page: Page, calls: str, handler: Callable[[Route], object]) -> None:
    """Gives a page's calls to a handler, and waits until a call of the page is taken.

    The browser says that it intercepts before a busy page does: a click at once would pass it by. From then on the page is intercepted,
    so that a call that is held stays so when its handler is gone; not before, as each page would read and compile all its script anew.
    """
    page.route(calls, handler)
    page.route(f"**{PROBE}", lambda route: route.fulfill(body="taken"))
    if page.url.startswith("http"):  # a page that comes is intercepted from its first call
        page.evaluate(UNTIL_TAKEN)


def first(page: Page, taken: Sequence[Route]) -> Route:
    """The first call that a handler has taken; one that the page does not make in as long as an answer may take never comes."""
    for _ in range(ANSWER_MS // POLL_MS):
        if taken:
            break
        page.wait_for_timeout(POLL_MS)
    return taken[0]


def rows(elements: Locator) -> int:
    """In how many rows elements stand beside each other; each must have a size."""
    ends: list[list[float]] = elements.evaluate_all("all => all.map(one => one.getBoundingClientRect()).map(box => [box.top, box.bottom])")
    assert all(top < bottom for top, bottom in ends)
    return len({round((top + bottom) / 2) for top, bottom in ends})


def said(name: str) -> str:
    """A name of the catalogs as the page says it."""
    return SAID.get(name, name.replace("_", " "))


def told(message: str, scene: Document) -> str:
    """A message of the service as the page says it in English: rooms and pieces called by name, so that no id is left."""
    seen: dict[str, list[str]] = {}
    for room in scene["rooms"]:
        seen.setdefault(room["type"], []).append(room["id"])
    names: dict[str, str] = {}
    for kind, ids in seen.items():
        names |= {id_of: said(kind) + (f" {number}" if len(ids) > 1 else "") for number, id_of in enumerate(ids, 1)}
    words = []
    for word in message.split(" "):
        id_of = word.rstrip(".,:;").removesuffix("'s")
        kind, _, number = id_of.rpartition("/")[2].rpartition("_")
        name = names.get(id_of) or (said(kind) + (f" {number}" if number != "1" else "") if number.isdecimal() else said(id_of))
        the = "the " if id_of in names or "/" in id_of else ""
        words.append(word.replace(id_of, the + name) if "_" in id_of else word)
    return " ".join(words)


def told_sentence(message: str, scene: Document) -> str:
    """The same, begun as a sentence begins."""
    words = told(message, scene)
    return words[:1].upper() + words[1:]


def furniture_of(answer: Document) -> list[str]:
    """The ids of a scene's furniture."""
    return [piece["id"] for room in answer["scene"]["rooms"] for piece in room["furniture"]]


def sent_by(request: Request) -> Document:
    """The document that a call was sent with."""
    document = request.post_data_json
    assert isinstance(document, dict)
    return document


def _generated(response: Response) -> bool:
    return response.url.endswith("/generate")
