"""The page in German: chosen by the browser's language or by hand, whole, fitting, and nothing is lost when another is chosen."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.conftest import visiting
from tests.browser.first_picture import LAPTOP
from tests.browser.service_process import ServiceProcess
from tests.browser.test_accessible import violations
from tests.browser.visit import Visit, rows
from tests.imports import plans

OPENED = "() => { for (const one of document.querySelectorAll('#controls details')) one.open = true; }"
CUT_OFF = """() => [...document.querySelectorAll('#controls :is(button, a, label, h1, h2), .views button, .status span')]
    .filter(one => one.offsetParent && one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0).map(one => one.textContent.trim())"""
HOME = "?program=studio&seed=3"


@pytest.fixture
def german(browser: Browser, service: ServiceProcess) -> Iterator[Visit]:
    """A visit with a browser that is set to German and remembers nothing."""
    with visiting(browser, service.address, LAPTOP, locale="de-AT") as visit:
        yield visit


def test_german_is_whole_fits_and_gives_way_to_english(german: Visit) -> None:
    page = german.page
    scene = german.open(HOME)["scene"]
    expect(page.locator("html")).to_have_attribute("lang", "de")
    expect(page.get_by_role("button", name="Erzeugen")).to_be_visible()
    expect(page.locator("#language_words")).to_contain_text("englisch")
    page.evaluate(OPENED)
    assert page.evaluate(CUT_OFF) == []
    assert violations(german) == []
    assert len({page.locator(one).evaluate("one => one.clientWidth") for one in ("#export_format", "#open_file")}) == 1, "it is cut off"
    page.locator("#export_format").select_option("usdz")
    expect(page.locator("#export_words")).to_have_text("Dasselbe wie usd als eine Datei: Telefone, Tablets, Vorschau")
    expect(page.locator("#robot_width")).to_have_attribute("placeholder", "0,6")
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
    keys = set(page.locator("#keys_list kbd").all_inner_texts())
    assert {"Strg+Z", "Strg+Umschalt+Z", "Entf", "Umschalt+Enter"} <= keys
    assert not any(re.search("Ctrl|Shift|Del", key) for key in keys)
    page.keyboard.press("Escape")
    german.reopened(lambda: page.get_by_label("Sprache").select_option("en"))
    expect(page.locator("html")).to_have_attribute("lang", "en")
    expect(page.get_by_role("button", name="Generate")).to_be_visible()
    expect(page.locator("#language_words")).to_be_hidden()
    assert page.evaluate("JSON.stringify(compose.scene)") == left
    expect(page.get_by_role("button", name="Undo")).to_be_enabled()
    assert german.console == []


ENGLISH = re.compile(r"\b(?:the|is|are|was|as|of|and|or|its?|to|by|no|not|with|at)\b")
"""Words that hardly an English sentence is without, and that are not German ones."""
TOWN = plans.collection(
    plans.polygon("Kitchen", (0, 0), (4.03, 0), (4, 3), (0, 3)), plans.box("Salon", 4.1, 0, 9, 3), plans.box("Sliver", 20, 0, 20.1, 3),
    plans.line("door", (1, 0), (1.9, 0)), plans.line("window", (1, 30), (2, 30)), plans.piece("Sofa", 30, 30, width=2, depth=1, height=1),
    plans.piece("Fridge", 0.1, 0.2, width=0.6, depth=0.6, height=1.8), plans.piece("Bett", 6, 1.5),
)  # fmt: skip


def test_what_is_read_and_what_is_refused_is_said_in_german(german: Visit) -> None:
    page = german.page
    german.open(HOME)
    page.locator("#room_choice").select_option(index=1)
    expect(page.locator("#room_facts")).to_contain_text(re.compile("BodenHolz|BodenFliesen"))
    chooser, notice = page.locator("#file"), page.get_by_role("alert")
    chooser.set_input_files({"name": "town.json", "mimeType": "application/json", "buffer": json.dumps({**TOWN, "unit": None}).encode()})
    expect(page.locator("#imported")).to_be_visible()
    report = page.locator("#imported_list")
    for heading in ("Angenommen", "Weggelassen", "Geändert"):
        expect(report.get_by_role("heading", name=re.compile(heading))).to_be_visible()
    lines = report.locator("li").all_inner_texts()
    assert len(lines) > 6
    assert [line for line in lines if ENGLISH.search(line)] == []
    for content in (b"", b"[1", b'{"rooms": [{"width": -1}]}', json.dumps(plans.collection(plans.box("a", 0, 0, 4000, 3))).encode()):
        chooser.set_input_files({"name": "x.json", "mimeType": "application/json", "buffer": content})
        expect(notice).to_be_visible()
        words = notice.inner_text()
        assert not ENGLISH.search(re.sub(r"Expecting.*", "", words)), words
        page.locator(".notice-close").click()
    page.goto(f"{german.address}embed#program=castle")
    said = page.locator("#embed_said")
    expect(said).to_contain_text("kein Raumprogramm heißt")
    assert not ENGLISH.search(said.inner_text())
    assert [line for line in german.console if "422" not in line] == []


def test_all_german_tools_are_one_row_of_a_small_laptop(german: Visit) -> None:
    """The rows are as long as they can be: something is chosen, copied, done and taken back."""
    page = german.page
    page.set_viewport_size({"width": 1024, "height": 768})
    scene = german.open(HOME)["scene"]
    page.locator("#fold_reading").click()
    german.line_of(next(one["id"] for one in scene["rooms"][0]["furniture"] if not one.get("locked"))).click()
    page.locator("#fold_reading").click()
    page.locator("#stage").focus()
    for key in ("Control+c", "k", "k", "k", "Control+z"):
        page.keyboard.press(key)
        german.settle()
    in_one_row(page, "#tools", 14)
    page.get_by_role("button", name="Diesen Plan ändern").click()
    page.locator(".drawing-tools [data-tool=new]").click()
    page.locator(".drawing-tools [data-tool=new]").click()
    page.keyboard.press("Control+z")
    for width in (1024, 1180, 1240, 1280, 1366):
        page.set_viewport_size({"width": width, "height": 768})
        in_one_row(page, ".drawing-tools", 15)


def in_one_row(page: Page, row: str, count: int) -> None:
    tools = page.locator(f"{row} button").filter(visible=True)
    expect(tools).to_have_count(count)
    titles = " ".join(tools.evaluate_all("all => all.map(one => one.title)"))
    assert "Strg+Z" in titles and not re.search("Control|Shift|Delete", titles), titles
    assert rows(tools) == 1
