"""The menu: what leaves a home and comes to it, in one place, by pointer and by keys; a picture of what is in view."""

from __future__ import annotations

import struct
from pathlib import Path

from playwright.sync_api import expect

from tests.browser.visit import SMALL, Visit

IN_MENU = "() => document.activeElement.closest('#menu') !== null"
UNDER = """() => {
    const [menu, button] = ['#menu', '[data-tool=menu]'].map(one => document.querySelector(one).getBoundingClientRect());
    const below = menu.top - button.bottom;
    const across = menu.left <= button.right && button.left <= menu.right;
    return [below >= 0 && below < 12, across, menu.right <= innerWidth && menu.bottom <= innerHeight];
}"""
"""Whether the menu begins just under its button, stands beside nothing of it, and within the window."""
SIZE = struct.Struct(">II")


def test_the_menu_saves_shares_and_leads_to_what_is_kept(visit: Visit) -> None:
    page = visit.page
    visit.open(SMALL.format(4))
    menu = page.locator("#menu")
    page.locator("#tools [data-tool=menu]").focus()
    page.keyboard.press("Enter")
    expect(menu).to_be_visible()
    page.wait_for_function(IN_MENU)
    assert page.evaluate(UNDER) == [True, True, True]
    first = page.evaluate("document.activeElement.textContent")
    page.keyboard.press("ArrowDown")
    assert page.evaluate(IN_MENU)
    assert page.evaluate("document.activeElement.textContent") != first

    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    menu.get_by_role("button", name="Copy a frame").click()
    expect(menu.get_by_role("status")).to_contain_text("Copied")
    line = page.evaluate("navigator.clipboard.readText()")
    assert line.startswith(f'<iframe src="{visit.address}embed#')
    assert "seed=4" in line

    with page.expect_download() as saved:
        menu.get_by_role("button", name="Picture of the view").click()
    expect(menu).to_be_hidden()
    picture = Path(saved.value.path()).read_bytes()
    assert picture.startswith(b"\x89PNG")
    assert SIZE.unpack_from(picture, 16) == (3840, 2160)
    visit.settle()

    for entry, focused in (("Saved homes", "#saved"), ("Save this home", "#saved_name"), ("For simulators", "#export_format")):
        page.locator("#tools [data-tool=menu]").click()
        menu.get_by_role("button", name=entry).click()
        expect(menu).to_be_hidden()
        assert page.evaluate("id => document.activeElement.closest(id) !== null", focused)
    page.keyboard.press("Escape")
    assert visit.console == []
