"""A home in a frame of another place's page: shown, walked through, never changed; nothing is kept, nothing else may be framed."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Thread

import pytest
from playwright.sync_api import expect

from tests.browser.test_accessible import found_in
from tests.browser.visit import Visit

STAYS = """async () => {
    const asked = /^compose[.](reading|home|furnishing|view|files|tour)$/;
    return [Object.keys(localStorage).filter(key => !asked.test(key)).length, (await indexedDB.databases()).length, document.cookie];
}"""


@contextmanager
def elsewhere(frames: str) -> Iterator[str]:
    """A page of another place, at an address of its own."""

    class Answers(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.send_header("Content-Type", "text/html")
            self.end_headers()
            self.wfile.write(f"<!doctype html><title>x</title><link rel=icon href=data:,>{frames}".encode())

        def log_message(self, format: str, *args: object) -> None:
            """Says nothing."""

    with ThreadingHTTPServer(("127.0.0.1", 0), Answers) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


def framed(name: str, address: str) -> str:
    """A frame of an address."""
    return f'<iframe title="{name}" src="{address.replace("&", "&amp;")}" width="600" height="400"></iframe>'


@pytest.mark.own_page
def test_a_frame_elsewhere_shows_the_home_and_the_page_itself_stays_out(visit: Visit) -> None:
    page, hostile = visit.page, "seed=4&width=12&depth=9&style=<img src=x onerror=alert(1)>"
    asked = "seed=4&width=12&depth=9"
    with elsewhere(framed("home", f"{visit.address}embed#{asked}") + framed("page", f"{visit.address}?{asked}")) as address:
        page.goto(address)
        look_at_frames(visit)
    page.goto(f"{visit.address}embed#{hostile}")
    expect(page.locator("#embed_said")).to_contain_text("<img")
    assert page.locator("img").count() == 0
    whole = page.get_by_role("link", name="Open in Compose").get_attribute("href")
    assert whole == "./?seed=4&width=12&depth=9&style=%3Cimg+src%3Dx+onerror%3Dalert%281%29%3E"
    assert [said for said in visit.console if "frame-ancestors" not in said and "422" not in said] == []


@pytest.mark.own_page
def test_a_frame_says_which_words_of_its_address_are_known_to_none(visit: Visit) -> None:
    page = visit.page
    page.goto(f"{visit.address}embed#sead=4&program.bedrooms=2")
    expect(page.locator("#embed_said")).to_contain_text("sead: is not known; seed?")
    page.goto(f"{visit.address}embed#seed=4&width=12&depth=9&view=above")
    expect(page.locator("#embed_said")).to_contain_text("view: is not known; allowed: corner, plan, top, walk", ignore_case=True)
    page.goto(f"{visit.address}embed#seed=4&width=12&depth=9&view=top")
    expect(page.locator("#embed_said")).to_be_empty()
    expect(page.locator("#camera_top")).to_have_attribute("aria-pressed", "true")
    expect(page.locator("#stage > canvas")).to_be_visible()
    page.goto(f"{visit.address}embed#seed=none")
    expect(page.locator("#embed_said")).to_contain_text("seed: ")
    expect(page.locator("#stage > canvas")).not_to_be_visible()
    expect(page.get_by_role("link", name="Open in Compose")).to_be_visible()


def look_at_frames(visit: Visit) -> None:
    """Looks at a page with both frames."""
    page = visit.page
    shown = page.frame_locator("iframe[title=home]")
    expect(shown.locator("#stage")).to_have_attribute("aria-busy", "false")
    inner = next(frame for frame in page.frames if "/embed" in frame.url)
    assert len(inner.evaluate("compose.state.bodies")) > 10
    shown.get_by_role("button", name="Walk").click()
    inner.wait_for_function("() => compose.state.walking && compose.state.knowsFloor")
    expect(shown.locator("#minimap")).to_be_visible()
    assert found_in(inner) == []
    assert inner.evaluate(STAYS) == [0, 0, ""]
    refused = next(frame for frame in page.frames if frame not in (page.main_frame, inner))
    assert not refused.evaluate("document.querySelector('#stage') !== null")


@pytest.mark.own_page
def test_a_frame_says_that_the_card_was_taken_away_while_it_is(visit: Visit) -> None:
    page = visit.page
    page.goto(f"{visit.address}embed#seed=4&width=12&depth=9")
    expect(page.locator("#stage")).to_have_attribute("aria-busy", "false")
    said = page.locator("#embed_said")
    card = page.evaluate_handle("document.querySelector('#stage > canvas').getContext('webgl2').getExtension('WEBGL_lose_context')")
    card.evaluate("card => card.loseContext()")
    expect(said).to_have_text("The graphics card was taken away")
    card.evaluate("card => card.restoreContext()")
    expect(said).to_have_text("")
