"""No violation that axe-core knows in any state of the page that a person can bring it to, light and dark.

In other languages only words differ: that there are words for all, and others for other regions, is in web/tests/language.test.ts, and what
longer words could make scroll can be scrolled by keys.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import ClassVar

import pytest
from playwright.sync_api import Route, expect

from tests.architecture.tree import ROOT
from tests.browser.conftest import DESK, PHONE
from tests.browser.test_accessible import OVER, found_in, in_conflict, refusing
from tests.browser.test_editing import ONE, OTHER, crate, den
from tests.browser.test_language import TOWN
from tests.browser.visit import Visit, furniture_of, intercept
from tests.sweeps import ALL

HOME = "?program=studio&decorate=true&seed=3"
PLAIN_HOME = "?program=studio&seed=3"
"""A home whose text is looked at where it is in view: all its lines, and those of decorations, are looked at in the other."""
NOT_TWICE = """(contrast => {
    const lookedAt = globalThis.lookedAt ??= new Set();
    const media = ['print', '(prefers-color-scheme: dark)'].map(one => matchMedia(one).matches);
    const all = [...media, innerWidth, !document.querySelector(':modal')];
    const around = one => one ? [one.cloneNode().outerHTML, ...around(one.parentElement)] : [];
    const isTwice = (one, ...seen) => {
        const state = [...all, one.checkVisibility(), !one.closest('[inert]'), around(one.parentElement), ...seen];
        const [told, less] = [contrast, false].map(asked => JSON.stringify([asked, ...state]));
        return lookedAt.has(told) || !lookedAt.add(told).add(less);
    };
    const twice = [...document.querySelectorAll('#controls details.group')].filter(one => isTwice(one, one.outerHTML));
    const text = document.querySelector('#yaml');
    if (!text) return twice;
    const {top, bottom} = text.getBoundingClientRect();
    const isOut = ({bottom: end, top: start}) => end < Math.max(top, 0) || start > Math.min(bottom, innerHeight);
    const [out, seen] = [true, false].map(is => [...text.children].filter(one => isOut(one.getBoundingClientRect()) === is));
    return [...twice, ...isTwice(text, text.cloneNode().outerHTML, ...seen.map(one => one.outerHTML)) ? [text] : out];
})(%s)"""
"""Groups of controls that have been looked at, by as many rules, as they and what they stand in are in these colours.

So of the text, and else its lines out of view.
"""
PAINTED = """() => {
    const isTransparent = colour => colour === 'rgba(0, 0, 0, 0)';
    const grounds = one => {
        const found = [];
        for (let at = one; at && at !== document.documentElement; at = at.parentElement) {
            const {backgroundColor, backgroundImage, opacity, filter} = getComputedStyle(at);
            if (isTransparent(backgroundColor) && [backgroundImage, opacity, filter].join() === 'none,1,none') continue;
            found.push(backgroundColor, backgroundImage, opacity, filter);
        }
        return found;
    };
    const isInView = one => {
        const {left, right, top, bottom} = one.getBoundingClientRect();
        const met = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
        return met !== null && (one.contains(met) || met.contains(one));
    };
    const says = one => one.value || one.placeholder || [...one.childNodes].some(part => part.nodeType === 3 && part.data.trim() !== '');
    const told = [...document.querySelectorAll('body *')].filter(one => says(one) && one.checkVisibility() && isInView(one)).map(one => {
        const {color, fontSize, fontWeight} = getComputedStyle(one);
        const around = one.localName === 'a' && getComputedStyle(one.parentElement).color;
        return JSON.stringify([color, fontSize, fontWeight, around, one.closest(':disabled') !== null, ...grounds(one)]);
    });
    return [...new Set(told)];
}"""
"""In which colours, and how large, words in view are written on which grounds."""
OPEN = "all => all.forEach(one => { one.open = true; })"
UNDONE = "window.dispatchEvent(new DragEvent('dragleave', {relatedTarget: null})), 0"
OF_COLOURS = ("color-contrast", "link-in-text-block")
"""The rules by which a page is looked at once more in the other colours: it differs in these alone."""
STUCK = """() => {
    const isReached = one => [one, ...one.querySelectorAll('*')].some(part => part.tabIndex >= 0);
    const isHalfFull = one => {
        const inside = document.createRange();
        inside.selectNodeContents(one);
        const {width, height} = inside.getBoundingClientRect();
        return height > one.clientHeight / 2 || width > one.clientWidth + 1;
    };
    const scrolls = one => /auto|scroll/.test(getComputedStyle(one).overflow) && one.textContent !== '' && isHalfFull(one);
    return [...document.querySelectorAll('body *')].filter(one => one.checkVisibility() && scrolls(one) && !isReached(one))
        .map(one => one.outerHTML.slice(0, 90));
}"""
"""What scrolls, or would with words twice as long, and no key would scroll it."""
IN_THE_DARK = re.compile(r"@media[^{]*prefers-color-scheme[^{]*\{((?:[^{}]*\{[^{}]*\})*)")
PROPERTY = re.compile(r"[{;]\s*([\w-]+)\s*:")
PAINT = {"background", "filter"}
"""What may change in the dark beside `light-dark()`, which gives nothing but a colour."""
COMPARE = 4
"""Which button of a saved home compares it with another."""


@pytest.fixture
def opened(visit: Visit) -> Visit:
    """A visit that remembers nothing, in a window with room for all panels, which stand open."""
    visit.page.set_viewport_size(DESK)
    return visit


class States:
    """What axe-core finds, by state and colours."""

    seen: ClassVar[set[str]] = set()
    """What words look like that have been looked at: where none look otherwise, contrast is as it was there."""

    def __init__(self, visit: Visit) -> None:
        self.visit, self.found, self.colours = visit, dict[str, list[str]](), ["light", "dark"]

    def look(self, state: str, shown: str | None = None, *, whole: bool = False) -> None:
        """Wait until what makes the state is seen, and look at it: at the whole text, or at lines in view, which look like all, once.

        At groups of controls that stay as they were, too, it looks once. In `make test` states are light and dark in turn.
        """
        if shown is not None:
            expect(self.visit.page.locator(shown).first).to_be_visible()
        if not self.found:
            self.visit.page.evaluate("delete globalThis.lookedAt")  # the page may be another test's before
        looked = self.colours if ALL or whole else self.colours[:1]
        for colours in looked:
            self.visit.page.emulate_media(color_scheme=colours)  # type: ignore[arg-type]
            assert f"{state}, {colours}" not in self.found
            painted = set(self.visit.page.evaluate(PAINTED))
            rules = OF_COLOURS if painted - self.seen else ()
            aside = "[]" if whole else NOT_TWICE % json.dumps(bool(rules))
            if colours == looked[0]:
                found = found_in(self.visit.page, but=() if rules else OF_COLOURS, aside=aside)
            else:
                found = found_in(self.visit.page, *rules, aside=aside) if rules else []
            self.found[f"{state}, {colours}"] = found
            self.seen.update(painted)
        self.found[state] = self.visit.page.evaluate(STUCK)
        self.colours.reverse()  # the next state is come to in the colours of this one

    def file(self, name: str, document: object) -> None:
        """Open a file on the page."""
        content = json.dumps(document).encode()
        self.visit.page.locator("#file").set_input_files({"name": name, "mimeType": "application/json", "buffer": content})

    def wrong(self) -> dict[str, list[str]]:
        """The states in which something is wrong, of which there must be many."""
        return {state: wrong for state, wrong in self.found.items() if wrong}


def test_dark_pages_differ_in_colours_alone_and_no_style_in_languages() -> None:
    sources = {path: path.read_text(encoding="utf-8") for path in (ROOT / "web").rglob("*.*") if path.suffix in {".css", ".ts", ".html"}
               and not {"node_modules", "tests"} & {*path.relative_to(ROOT).parts}}  # fmt: skip
    asking = {path.suffix for path, text in sources.items() if "prefers-color-scheme" in text}
    assert asking == {".css"}
    assert not [path for path, text in sources.items() if path.suffix == ".css" and re.search(r":lang\(|\[lang", text)]
    inside = [rules for text in sources.values() for rules in IN_THE_DARK.findall(text)]
    assert inside
    assert {name for rules in inside for name in PROPERTY.findall(rules)} <= PAINT


def test_with_all_that_is_told_of_a_home(opened: Visit) -> None:
    states = States(opened)
    opened.open(HOME)
    opened.page.locator("details.group").evaluate_all(OPEN)
    states.look("all groups open", "#recent_list .recent-home", whole=True)
    assert states.wrong() == {}
    assert len(states.found) == 3  # light, dark, and what scrolls


def test_with_a_home(opened: Visit) -> None:
    page, states = opened.page, States(opened)
    scene = opened.open(PLAIN_HOME)["scene"]
    for button, shown, shut in (("#keys", "#keys_dialog", "#keys_close"), ("#diagnose", "#diagnose_found > *", "#diagnose_close")):
        page.locator(button).click()
        if button == "#diagnose":
            page.locator("#report_whole > summary").click()
            page.locator("#diagnose_copy").click()
            expect(page.locator("#diagnose_said")).not_to_be_empty()
            expect(page.locator("#report > *").first).to_be_visible()
        states.look(button, shown)
        page.locator(shut).click()
    page.locator("#tools [data-tool=menu]").click()
    states.look("menu", "#menu")
    page.keyboard.press("Escape")
    page.locator("#tour_again").click()
    states.look("tour", "#tour")
    page.keyboard.press("Escape")
    for key, shown in (("4", "#stage .plan-sheet"), ("5", "#beside .plan-sheet"), ("1", "#walk_leave")):
        page.keyboard.press("Escape")
        page.locator("#stage").focus()
        page.keyboard.press(key)
        opened.settle()
        states.look(f"view {key}", shown)
    page.keyboard.press("3")
    for key in ("5", "o", "l"):
        page.keyboard.press(key)
    page.locator("#fold_controls").click()
    states.look("folded, floor and names")
    page.locator("#fold_controls").click()
    page.emulate_media(media="print")
    states.look("printed")
    page.emulate_media(media="screen")
    page.locator("#shortfall_line").click()
    page.locator("#shortfall_list summary").first.click()
    states.look("what fell short", "#shortfall_list p")
    on_a_phone(opened, states)
    assert scene["rooms"] and opened.console == []
    assert states.wrong() == {}
    assert len(states.found) == (3 if ALL else 2) * 13


def on_a_phone(visit: Visit, states: States) -> None:
    """Looks at the home that is open on a narrow screen."""
    page = visit.page
    page.set_viewport_size(PHONE)
    visit.settle()
    assert page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]
    visit.line_of(visit.state()["bodies"][0]).click()
    states.look("phone, chosen", "#piece")
    page.locator("#tools [data-tool=add]").click()
    states.look("phone, palette", "#palette li button")
    page.locator(".palette-head button").click()
    page.locator("#camera_walk").click()
    visit.settle()
    states.look("phone, walking", "#walk_leave")


def with_marks(visit: Visit, states: States) -> None:
    """Looks at the chosen piece while it is flagged and found, a distance of it typed wrongly, a room in hand, and rooms counted."""
    page, marks = visit.page, "flo"
    for key in marks:
        page.keyboard.press(key)
    page.locator("#find").fill("a")
    page.locator("#room_choice").select_option(index=1)
    page.locator("#program").select_option("own")
    page.locator("#gaps button").first.click()
    page.locator("#gaps input").fill("wide")
    page.keyboard.press("Enter")
    for shown in ("#counts", "#yaml mark", "#gaps input[aria-invalid=true]"):
        expect(page.locator(shown).first).to_be_visible()
    states.look("flagged, found, named, floor, room in hand, rooms counted, a distance that is none", "#piece")
    page.keyboard.press("Escape")
    page.locator("#find").fill("")
    page.locator("#room_choice").select_option(index=0)
    page.locator("#stage").focus()
    for key in marks:
        page.keyboard.press(key)


def test_with_a_piece(opened: Visit) -> None:
    page, states = opened.page, States(opened)
    pieces = list(furniture_of(opened.open(PLAIN_HOME)))
    stage = page.locator("#stage")
    opened.line_of(pieces[0]).click()
    stage.focus()
    expect(page.locator("#piece")).to_be_visible()
    with_marks(opened, states)
    page.keyboard.press("h")
    states.look("why", "#why ul li")
    page.keyboard.press("Escape")
    opened.line_of(pieces[0]).click()
    opened.line_of(pieces[1]).click(modifiers=["Shift"])
    states.look("several", "#piece")
    page.keyboard.press("Escape")
    stage.focus()
    page.keyboard.press("m")
    states.look("tape", ".tape-words")
    page.keyboard.press("Escape")
    page.keyboard.press("a")
    states.look("palette", "#palette li button")
    page.locator("#palette input").first.fill("qqqq")
    states.look("nothing found in the palette", "#palette")
    page.locator("#palette input").first.fill("")
    page.locator("#palette button[data-kind=plant], #palette button[data-kind=armchair]").first.click()
    page.wait_for_function("before => compose.scene.rooms.flatMap((room) => room.furniture).length > before", arg=len(pieces))
    opened.settle()
    states.look("added, with other places")
    page.keyboard.press("Escape")
    page.locator("#room_choice").select_option(index=1)
    page.locator("#others_now").click()
    states.look("other arrangements", "#others canvas")
    page.keyboard.press("Escape")
    intercept(page, "**/fix", in_conflict)
    opened.line_of(pieces[0]).click()
    stage.focus()
    page.keyboard.press("ArrowRight")
    states.look("conflict", "#conflict")
    assert states.wrong() == {}
    assert len(states.found) == (3 if ALL else 2) * 9


def test_with_saved_homes_and_files(opened: Visit) -> None:
    page, states = opened.page, States(opened)
    scene = opened.open(PLAIN_HOME)["scene"]
    page.locator("#saved summary").click()
    states.look("nothing saved", "#saved")
    for name in ("one", "another"):
        made = page.request.post(f"{opened.address}homes", data={"name": name, "tags": ["x"], "scene": scene})
        assert made.ok, made.text()
    page.reload()
    opened.settle()
    page.locator("#saved summary").click()
    states.look("homes saved", "#saved li b")
    for at in (0, 1):
        page.locator("#saved li").nth(at).locator("button").nth(COMPARE).click()
    states.look("two homes compared", ".saved-comparison table")
    page.locator(".saved-comparison button").click()
    page.evaluate(OVER)
    states.look("a file over the page", "#drop")
    page.evaluate(UNDONE)
    states.file("town.json", {**TOWN, "unit": None})
    states.look("a file that was read", "#imported_list li")
    states.file("x.json", [1])
    states.look("a file that is refused", "#notice .notice-detail")
    page.locator(".notice-close").click()
    (wrong,) = den(crate(ONE, 1, 1), crate(OTHER, 1.2, 1.2))["rooms"]
    bare = {**wrong, "id": "bath", "type": "bathroom", "x": wrong["x"] + wrong["width"], "furniture": [crate("bath/one", 1, 1)]}
    states.file("wrong.json", {"rooms": [wrong, bare]})
    expect(page.locator("#issue_list .issue-warning").first).to_be_visible()
    states.look("errors and warnings", "#issue_list .issue-error")
    states.file("none.json", {"format": "compose-scene/1", "rooms": []})
    states.look("no rooms", "#no_rooms")
    assert states.wrong() == {}
    assert len(states.found) == (3 if ALL else 2) * 8


def test_with_refusals_and_a_plan(opened: Visit) -> None:
    page, states = opened.page, States(opened)
    opened.open("?width=9&depth=7&seed=3")
    page.locator("#home summary").evaluate("one => { one.parentElement.open = true; }")
    page.locator("#width").fill("5000")
    page.locator("#generate").click()
    states.look("a wrong field", "#width_problem")
    page.locator("#width").fill("9")
    for status in (401, 429):
        intercept(page, "**/generate", refusing(status))
        page.locator("#generate").click()
        states.look(f"refused {status}", "#notice")
        page.locator(".notice-close").click()
        page.unroute("**/generate")
    held: list[Route] = []

    def hold(route: Route) -> None:
        held.append(route)

    intercept(page, "**/generate", hold)
    page.locator("#generate").click()
    states.look("in work", "#progress")
    held[0].continue_()
    opened.settle()
    page.locator("#draw_this").click()
    states.look("a plan that is drawn", "#drawing .drawing-rooms button")
    assert states.wrong() == {}
    assert len(states.found) == (3 if ALL else 2) * 5


def test_in_a_frame(opened: Visit) -> None:
    page, states = opened.page, States(opened)

    def framed(address: str, shown: Callable[[], None]) -> None:
        page.goto("about:blank")
        page.goto(f"{opened.address}embed#{address}")
        shown()

    framed("seed=3&width=9&depth=7", lambda: expect(page.locator("#stage")).to_have_attribute("aria-busy", "false"))
    states.look("embedded", "#camera_plan")
    page.locator("#camera_walk").click()
    states.look("embedded, walking", "#walk_leave")
    page.locator("#walk_leave").click()
    page.locator("#camera_plan").click()
    states.look("embedded, as a plan", ".plan-sheet")
    framed("program=castle", lambda: expect(page.locator("#embed_said")).to_contain_text("castle"))
    states.look("embedded, refused", "#embed_said")
    assert states.wrong() == {}
