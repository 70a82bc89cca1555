"""No violation that axe-core knows, in the states a person meets; and nothing inline for the policy to forgive."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from playwright.sync_api import Frame, Page, Route, expect

from tests.browser.conftest import PHONE
from tests.browser.visit import SMALL, Visit, intercept, sent_by

AXE = Path(__file__).resolve().parents[2] / "web" / "node_modules" / "axe-core" / "axe.min.js"
RUN = """([rules, but]) => axe.run({
        resultTypes: ['violations'], selectors: false, ...(rules.length && {runOnly: rules}),
        rules: Object.fromEntries(but.map(rule => [rule, {enabled: false}])),
    }).then(found => found.violations.map(one => `${one.id}: ${one.nodes.map(node => node.html).join(' ')}`))"""
"""Every rule, or some; what is right need not be told in detail, which costs as much as to find what is wrong."""
OVER = """() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File(['a'], 'a'));
    window.dispatchEvent(new DragEvent('dragover', {dataTransfer: transfer, cancelable: true}));
}"""


def violations(visit: Visit) -> list[str]:
    """What axe-core finds wrong in the page as it is now."""
    assert visit.page.evaluate("document.querySelectorAll('button, input, select').length") > 20
    return found_in(visit.page)


def found_in(frame: Page | Frame, *rules: str, but: Sequence[str] = ()) -> list[str]:
    """What axe-core finds wrong in a page or a frame, which keeps it: by every rule but some, or by a few."""
    if not frame.evaluate("'axe' in globalThis"):
        frame.evaluate(AXE.read_text())
    found: list[str] = frame.evaluate(RUN, [rules, but])
    return found


def test_the_house_in_all_its_states(visit: Visit) -> None:
    page = visit.page
    scene = visit.open(SMALL.format(4))["scene"]
    found = {"start": violations(visit)}
    page.locator("#room_choice").select_option(index=1)
    page.locator("#program").select_option("own")
    page.locator("#legend summary").click()
    found["room in hand, rooms counted, legend"] = violations(visit)
    visit.line_of(scene["rooms"][0]["furniture"][0]["id"]).click()
    for key in ("f", "l", "o"):
        page.keyboard.press(key)
    page.locator("#find").fill("a")
    expect(page.locator("#yaml mark")).to_have_count(1)
    found["chosen, flagged, found, named, floor"] = violations(visit)
    page.evaluate(OVER)
    expect(page.locator("#drop")).to_be_visible()
    found["file over the page"] = violations(visit)
    page.evaluate("window.dispatchEvent(new DragEvent('dragleave', {relatedTarget: null})), 0")
    page.get_by_role("button", name="Walk through").click()
    visit.settle()
    found["walking"] = violations(visit)
    page.emulate_media(color_scheme="dark")
    page.get_by_role("button", name="Split").click()
    visit.settle()
    found["the plan beside, dark"] = violations(visit)
    assert {state: wrong for state, wrong in found.items() if wrong} == {}


def test_dialogs_palette_conflict_and_notice(visit: Visit) -> None:
    page = visit.page
    visit.open(SMALL.format(4))
    found: dict[str, list[str]] = {}
    for key, name in (("?", "Keys"), ("d", "Diagnosis")):
        page.keyboard.press(key)
        expect(page.get_by_role("dialog", name=name)).to_be_visible()
        found[name] = violations(visit)
        page.keyboard.press("Escape")
        expect(page.get_by_role("dialog", name=name)).to_be_hidden()
    page.keyboard.press("a")
    expect(page.locator("#palette li button").first).to_be_visible()
    found["palette"] = violations(visit)
    intercept(page, "**/fix", in_conflict)
    page.locator("#palette button[data-kind=armchair]").click()
    expect(page.locator("#conflict")).to_be_visible()
    found["conflict"] = violations(visit)
    for status in (401, 429):
        intercept(page, "**/generate", refusing(status))
        page.locator("#generate").click()
        expect(page.get_by_role("alert")).to_be_visible()
        found[f"notice of {status}"] = violations(visit)
        page.locator(".notice-close").click()
        expect(page.get_by_role("alert")).to_be_hidden()
        page.unroute("**/generate")
    assert {state: wrong for state, wrong in found.items() if wrong} == {}


def refusing(status: int) -> Callable[[Route], None]:
    """What refuses every call with a status."""
    return lambda route: route.fulfill(status=status, headers={"Retry-After": "30"}, body="{}")


def in_conflict(route: Route) -> None:
    """Says that nothing of the scene can stand together."""
    scene = sent_by(route.request)["scene"]
    ids = [piece["id"] for room in scene["rooms"] for piece in room["furniture"]]
    conflict = {"ids": ids, "message": "10 cm short", "repairs": [{"action": "leave_out", "id": ids[0]}]}
    route.fulfill(json={"scene": scene, "moves": [], "removed": [], "issues": [], "timing_ms": {}, "conflicts": [conflict]})


def test_a_narrow_screen(visit: Visit) -> None:
    visit.page.set_viewport_size(PHONE)
    visit.open(SMALL.format(4))
    assert violations(visit) == []
    visit.page.locator("details.group").evaluate_all("all => all.forEach(one => { one.open = true; })")
    assert violations(visit) == []
    assert visit.page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]


@pytest.mark.own_page
def test_nothing_is_inline(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    markup = visit.page.request.get(visit.address).text()
    assert "<style" not in markup
    assert " style=" not in markup
    assert " onclick=" not in markup
    policy = visit.page.request.get(visit.address).headers["content-security-policy"]
    assert "unsafe" not in policy
    assert "script-src 'self'" in policy
    assert visit.console == []
    assert all(url.startswith((visit.address, "blob:", "data:")) for url in visit.requests)
