"""What a person meets first, with nothing remembered: a decorated home, three to begin with, one line to ask; panels that fold; colours."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.conftest import visiting
from tests.browser.service_process import ServiceProcess
from tests.browser.test_accessible import violations
from tests.browser.visit import SMALL, Visit

GROUND = "() => getComputedStyle(document.documentElement).backgroundColor"
SCROLLBAR = 16
"""What one that is hidden here takes from the controls elsewhere [CSS pixels]."""
PLAIN = "?width=7&depth=5&seed=4"
DENIED = """for (const name of ['localStorage', 'sessionStorage', 'indexedDB']) {
    Object.defineProperty(window, name, {get() { throw new DOMException('denied', 'SecurityError'); }});
}"""
"""As browsers are that were told to keep nothing of any page."""
PLACES = """() => [...document.querySelectorAll('.controls, .controls details:not([hidden]), .stage, .reading')].map(one => {
    const {x, y, width, height} = one.getBoundingClientRect();
    return [one.id, x, y, width, one.matches('details') && !one.open ? height : null];
})"""
"""Where the panels and the groups in them are; of groups that are open not how high."""
SPARE = """one => {
    const style = getComputedStyle(one);
    const pen = document.createElement('canvas').getContext('2d');
    pen.font = `${style.fontSize} ${style.fontFamily}`;
    const longest = Math.max(...[one, ...document.querySelectorAll('#saved input')].map(field => pen.measureText(field.placeholder).width));
    return one.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - longest;
}"""
"""How much wider a field is than what is written to begin with in it, or in those as wide of saved homes [CSS pixels]."""


@pytest.fixture
def fresh(browser: Browser, service: ServiceProcess) -> Iterator[Visit]:
    """A visit with a browser that remembers nothing, on a laptop that is set to dark."""
    with visiting(browser, service.address, color_scheme="dark") as visit:
        yield visit


def folded(page: Page) -> list[bool]:
    """Whether the controls and the text are folded away."""
    return [page.locator(f"#{panel}").is_hidden() for panel in ("controls", "reading")]


def toured(page: Page) -> None:
    """Take the tour that a first visit begins with, by pointer; start it from the menu, by keys."""
    tour = page.locator("#tour")
    at: list[str] = []
    expect(tour).to_be_visible()
    assert page.evaluate("document.activeElement === document.body"), "it takes the focus from nobody"
    for step in range(1, 5):
        expect(tour.get_by_role("heading")).to_contain_text(f"{step}/4")
        at.append(page.locator("[data-toured]").evaluate("one => one.id || one.className || one.dataset.tool"))
        tour.get_by_role("button").last.click()
    expect(tour).to_be_hidden()
    assert (at, page.locator("[data-toured]").count()) == (["starts", "views", "tools", "menu"], 0)
    expect(page.locator("#stage")).to_have_attribute("aria-busy", "false")  # with the home comes another state of the tools
    page.locator("#tools [data-tool=menu]").focus()
    page.keyboard.press("Enter")
    expect(page.locator("#menu")).to_be_visible()
    page.locator("#menu").get_by_role("button", name="Tour").press("Enter")
    expect(tour.get_by_role("heading")).to_be_focused()
    for keys, step in ((("Tab", "Tab", "Enter"), 2), (("Shift+Tab", "Enter"), 1)):
        for key in keys:
            page.keyboard.press(key)
        expect(tour.get_by_role("heading")).to_contain_text(f"{step}/4")
    page.keyboard.press("Escape")
    expect(tour).to_be_hidden()
    expect(page.locator("#stage")).to_be_focused()
    page.locator("#tour_again").click()
    page.locator("#asked").click()
    expect(tour).to_be_visible()
    page.locator("#camera_top").click()
    expect(tour).to_be_hidden()


def test_a_decorated_home_and_what_to_begin_with(fresh: Visit) -> None:
    page = fresh.page
    scene = fresh.open()["scene"]
    asked = {key: scene["request"].get(key) for key in ("program", "decorate", "seed")}
    assert asked == {"program": "family", "decorate": True, "seed": 42}
    assert any(room["decorations"] for room in scene["rooms"])
    assert folded(page) == [False, True]
    expect(page.locator("#width")).to_be_hidden()
    assert page.locator("#asked").evaluate(SPARE) > SCROLLBAR
    assert all(page.locator("#starts img").evaluate_all("all => all.map(one => one.naturalWidth > 100)"))
    schemes: tuple[Literal["light", "dark"], ...] = ("light", "dark")
    for colours in schemes:
        page.emulate_media(color_scheme=colours)
        assert violations(fresh) == []
    toured(page)
    page.locator("#asked").fill("a bedroom, 3 ballrooms")
    page.keyboard.press("Enter")
    expect(page.locator("#asked_problem")).to_contain_text('"3 ballrooms"')
    page.locator("#asked").fill("2 bedrooms, 1 bath, 80 m²")
    request = fresh.after(lambda: page.keyboard.press("Enter"))["scene"]["request"]
    assert (request["program"]["bedrooms"], request["program"]["bathrooms"], request["area"]) == (2, 1, 80)
    expect(page.locator("#asked_problem")).to_be_empty()
    studio = fresh.after(page.get_by_role("link", name="Studio").click)["scene"]["request"]
    assert (studio["program"], studio["seed"]) == ("studio", 3)
    assert "program=studio" in page.url
    assert fresh.console == []


def test_a_board_that_does_not_come_is_asked_for_once_more(fresh: Visit) -> None:
    page, notice = fresh.page, fresh.page.get_by_role("alert")
    fresh.open(SMALL.format(4))
    page.route("**/board-*.js", lambda route: route.abort(), times=1)
    page.locator("#draw_new").click()
    expect(notice).to_contain_text("The service does not answer")
    notice.get_by_role("button", name="Try again").click()
    expect(page.locator("#drawing .sheet")).to_be_focused()
    expect(notice).to_be_hidden()


@pytest.mark.parametrize("width", [1280, 1600])
def test_nothing_moves_when_the_code_of_the_page_arrives(fresh: Visit, width: int) -> None:
    page = fresh.page
    page.set_viewport_size({"width": width, "height": 800})
    page.route("**/*.js", lambda route: route.abort())
    page.goto(fresh.address)
    before = page.evaluate(PLACES)
    page.unroute_all()
    fresh.open()
    after = page.evaluate(PLACES)
    beneath = [one[0] for one in after].index("room")  # in which the code fills in what is chosen
    assert after[: beneath + 1] == before[: beneath + 1]
    assert folded(page) == [False, width < 1500]


def test_a_browser_that_keeps_nothing_at_all_shows_homes_all_the_same(fresh: Visit) -> None:
    page = fresh.page
    page.add_init_script(DENIED)
    fresh.after(lambda: page.goto(fresh.address + PLAIN))
    page.locator("#recent > summary").click()
    expect(page.locator("#recent_said")).to_contain_text("This browser keeps no homes beyond this page")
    first = page.evaluate("compose.scene")
    fresh.after(page.locator("#random").click)
    page.go_back()
    page.wait_for_function("seed => compose.scene.seed === seed", arg=first["seed"])
    fresh.settle()
    page.goto(f"{fresh.address}embed#{PLAIN[1:]}")
    expect(page.locator("#embed_said")).to_be_empty()
    assert page.evaluate("compose.scene") == first
    assert fresh.console == []


def test_panels_and_colours_stay_as_they_were_left(fresh: Visit) -> None:
    page = fresh.page
    fresh.open(PLAIN)
    dark = page.evaluate(GROUND)
    expect(page.get_by_label("Colours of the page")).to_be_hidden()
    page.locator("#view > summary").click()
    page.get_by_label("Colours of the page").select_option("light")
    light = page.evaluate(GROUND)
    assert light != dark
    assert violations(fresh) == []
    wide = page.locator("#stage").bounding_box()
    page.get_by_role("button", name="Controls", exact=True).click()
    page.keyboard.press("]")
    assert folded(page) == [True, False]
    narrow = page.locator("#stage").bounding_box()
    assert wide and narrow and narrow["x"] == 0 < wide["x"]
    fresh.reopened(page.reload)
    assert (folded(page), page.evaluate(GROUND)) == ([True, False], light)
    page.get_by_role("link", name="To the controls").focus()
    page.keyboard.press("Enter")
    expect(page.locator("#controls")).to_be_focused()
    page.keyboard.press("]")
    assert folded(page) == [False, True]
    page.get_by_label("Colours of the page").select_option("")
    page.locator("#home > summary").click()
    expect(page.locator("#width")).to_be_visible()
    fresh.reopened(page.reload)
    assert page.evaluate(GROUND) == dark
    expect(page.locator("#width")).to_be_visible()
