"""The page in German: chosen by the browser's language or by hand, whole, fitting, and nothing is lost when another is chosen."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from tests.browser.conftest import PIXEL_RATIO
from tests.browser.service_process import ServiceProcess
from tests.browser.test_accessible import violations
from tests.browser.visit import Visit

OPENED = "() => { for (const one of document.querySelectorAll('#controls details')) one.open = true; }"
CUT_OFF = """() => [...document.querySelectorAll('#controls :is(button, a, label, h1, h2), .views button, .status span')]
    .filter(one => one.offsetParent && one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0).map(one => one.textContent.trim())"""
HOME = "?program=studio&seed=3"


@pytest.fixture
def german(browser: Browser, service: ServiceProcess) -> Iterator[Visit]:
    """A visit with a browser that is set to German and remembers nothing."""
    context = browser.new_context(
        viewport={"width": 1440, "height": 900}, device_scale_factor=PIXEL_RATIO, reduced_motion="reduce", locale="de-AT"
    )
    yield Visit(context.new_page(), service.address)
    context.close()


def test_german_is_whole_fits_and_gives_way_to_english(german: Visit) -> None:
    page = german.page
    scene = german.open(HOME)["scene"]
    expect(page.locator("html")).to_have_attribute("lang", "de")
    expect(page.get_by_role("button", name="Erzeugen")).to_be_visible()
    expect(page.locator("#language_words")).to_contain_text("englisch")
    page.evaluate(OPENED)
    assert page.evaluate(CUT_OFF) == []
    page.emulate_media(color_scheme="dark")
    assert violations(german) == []
    page.locator("#asked").fill("zwei Schlafzimmer, ein Bad, drei Ballsäle")
    page.keyboard.press("Enter")
    expect(page.locator("#asked_problem")).to_contain_text("„drei ballsäle“ ist weder")
    page.locator("#asked").fill("")
    page.locator("#stage").focus()
    piece = next(one["id"] for one in scene["rooms"][0]["furniture"] if not one.get("locked"))
    page.locator("#fold_reading").click()
    german.line_of(piece).click()
    page.locator("#stage").focus()
    page.keyboard.press("k")
    german.settle()
    assert german.state()["marks"]["locked"] == [piece]
    numbers = " ".join(page.locator("#gaps, .labels").all_inner_texts())
    assert re.search(r"\d,\d", numbers) and not re.search(r"\d\.\d", numbers)
    left = page.evaluate("JSON.stringify(compose.scene)")
    page.get_by_role("button", name="Tasten").click()
    expect(page.get_by_role("dialog", name="Tasten")).to_contain_text("ein anderes Haus")
    page.keyboard.press("Escape")
    german.reopened(lambda: page.get_by_label("Sprache").select_option("en"))
    expect(page.locator("html")).to_have_attribute("lang", "en")
    expect(page.get_by_role("button", name="Generate")).to_be_visible()
    expect(page.locator("#language_words")).to_be_hidden()
    assert page.evaluate("JSON.stringify(compose.scene)") == left
    expect(page.get_by_role("button", name="Undo")).to_be_enabled()
    assert german.console == []
