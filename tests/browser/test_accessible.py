"""No violation that axe-core knows, in the states a person meets; and nothing inline for the policy to forgive."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.browser.visit import SMALL, Visit

AXE = Path(__file__).resolve().parents[2] / "web" / "node_modules" / "axe-core" / "axe.min.js"
RUN = "() => axe.run().then(found => found.violations.map(one => `${one.id}: ${one.nodes.map(node => node.html).join(' ')}`))"
PHONE = {"width": 390, "height": 800}


def violations(visit: Visit) -> list[str]:
    """What axe-core finds wrong in the page as it is now."""
    visit.page.evaluate(AXE.read_text())
    assert visit.page.evaluate("document.querySelectorAll('button, input, select').length") > 20
    found: list[str] = visit.page.evaluate(RUN)
    return found


def test_the_start_and_a_room_in_hand(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    assert violations(visit) == []
    visit.page.locator("#room_choice").select_option(index=1)
    visit.page.locator("#program").select_option("own")
    assert violations(visit) == []


def test_the_diagnose_dialog(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    visit.page.keyboard.press("d")
    expect(visit.page.locator("#diagnose_dialog")).to_be_visible()
    assert violations(visit) == []


@pytest.mark.parametrize("status", [401, 429])
def test_a_notice(visit: Visit, status: int) -> None:
    visit.open(SMALL.format(4))
    visit.page.route("**/generate", lambda route: route.fulfill(status=status, headers={"Retry-After": "30"}, body="{}"))
    visit.page.locator("#generate").click()
    expect(visit.page.get_by_role("alert")).to_be_visible()
    assert violations(visit) == []


def test_a_narrow_screen(visit: Visit) -> None:
    visit.page.set_viewport_size(PHONE)
    visit.open(SMALL.format(4))
    assert violations(visit) == []
    assert visit.page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]


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
