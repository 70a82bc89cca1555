"""What axe-core finds wrong in a page, what brings a page into some states; and nothing inline for the policy to forgive."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from playwright.sync_api import Frame, Page, Route

from tests.browser.visit import SMALL, Visit, sent_by

AXE = Path(__file__).resolve().parents[2] / "web" / "node_modules" / "axe-core" / "axe.min.js"
RUN = """([rules, but]) => {
    const paint = isSeen => { if (globalThis.unseen) unseen.disabled = isSeen; };
    paint(true);
    return axe.run({exclude: %s}, {
        resultTypes: ['violations'], selectors: false, ...(rules.length && {runOnly: rules}),
        rules: Object.fromEntries(but.map(one => [one, {enabled: false}])),
    }).then(found => found.violations.map(one => `${one.id}: ${one.nodes.map(node => node.html).join(' ')}`)).finally(() => paint(false));
}"""
"""Every rule, or some, of the page, as it is when it is seen, but some elements.

What is right need not be told in detail, which costs as much as to find what is wrong.
"""
OVER = """() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File(['a'], 'a'));
    window.dispatchEvent(new DragEvent('dragover', {dataTransfer: transfer, cancelable: true}));
}"""


def violations(visit: Visit) -> list[str]:
    """What axe-core finds wrong in the page as it is now."""
    assert visit.page.evaluate("document.querySelectorAll('button, input, select').length") > 20
    return found_in(visit.page)


def found_in(frame: Page | Frame, *rules: str, but: Sequence[str] = (), aside: str = "[]") -> list[str]:
    """What axe-core finds wrong in a page or a frame, which keeps it: by every rule or a few, but some; some elements are left aside."""
    if not frame.evaluate("'axe' in globalThis"):
        frame.evaluate(AXE.read_text())
    found: list[str] = frame.evaluate(RUN % aside, [rules, but])
    return found


def refusing(status: int) -> Callable[[Route], None]:
    """What refuses every call with a status."""
    return lambda route: route.fulfill(status=status, headers={"Retry-After": "30"}, body="{}")


def in_conflict(route: Route) -> None:
    """Says that nothing of the scene can stand together."""
    scene = sent_by(route.request)["scene"]
    ids = [piece["id"] for room in scene["rooms"] for piece in room["furniture"]]
    conflict = {"ids": ids, "message": "10 cm short", "repairs": [{"action": "leave_out", "id": ids[0]}]}
    route.fulfill(json={"scene": scene, "moves": [], "removed": [], "issues": [], "timing_ms": {}, "conflicts": [conflict]})


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
