"""Homes that the service keeps, on the page: saved, found, renamed, tagged, opened, compared, removed; their names are texts."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import expect

from tests.browser.test_in_turn import held
from tests.browser.visit import SMALL, Visit

HOSTILE = '<img src=x onerror="document.title=1">'


@pytest.fixture
def panel(visit: Visit) -> Any:
    """The open panel of a page that shows a home; nothing is saved yet."""
    visit.open(SMALL.format(4))
    homes = visit.page.request.get(f"{visit.address}homes?limit=100").json()["homes"]
    for home in homes:
        visit.page.request.delete(f"{visit.address}homes/{home['id']}", headers={"If-Match": "*"})
    panel = visit.page.locator("#saved")
    panel.locator("summary").click()
    expect(panel.get_by_role("status")).to_have_text("No home is saved here yet.")
    return panel


def save(panel: Any, name: str, tags: str = "") -> None:
    panel.get_by_label("Name to save as").fill(name)
    panel.get_by_label("Tags, with commas").fill(tags)
    panel.get_by_label("Tags, with commas").press("Enter")
    expect(panel.get_by_role("status")).to_have_text(f"Saved “{name}”.")


def test_a_hostile_name_is_a_text_everywhere(visit: Visit, panel: Any) -> None:
    title = visit.page.title()
    save(panel, HOSTILE, f"{HOSTILE}, second")
    item = panel.locator("li")
    expect(item.locator("b")).to_have_text(HOSTILE)
    expect(item.locator("small")).to_contain_text(f"{HOSTILE}, second")
    expect(panel.get_by_role("button", name="Save changes")).to_have_text(f"Save changes to “{HOSTILE}”")
    save(panel, "Other")
    for one in panel.get_by_role("button", name="Compare").all():
        one.click()
    dialog = visit.page.get_by_role("dialog", name="Two homes side by side")
    expect(dialog.locator("td").filter(has_text=HOSTILE).first).to_be_visible()
    dialog.get_by_role("button", name="Close").click()
    visit.reopened(lambda: item.nth(1).get_by_role("button", name="Open").click())
    assert visit.page.locator("img[src=x]").count() == 0
    assert visit.page.title() == f"Compose: {HOSTILE}" != title


def test_a_home_is_saved_changed_renamed_found_and_opened_by_its_link(visit: Visit, panel: Any) -> None:
    shown = visit.page.evaluate("compose.scene")
    save(panel, "By the lake", "small")
    save(panel, "Second")
    items = panel.locator("li")
    expect(items).to_have_count(2)
    panel.get_by_role("button", name="Save changes").click()
    expect(items.first.locator("small")).to_contain_text("version 2")
    panel.get_by_role("button", name="Rename By the lake").click()
    panel.get_by_label("New name of By the lake").fill("By the sea")
    panel.get_by_label("New name of By the lake").press("Enter")
    expect(items.first.locator("b")).to_have_text("By the sea")
    panel.get_by_role("button", name="Tag By the sea").click()
    panel.get_by_label("Tags of By the sea").fill("large, sunny")
    panel.get_by_label("Tags of By the sea").press("Enter")
    expect(items.first.locator("small")).to_contain_text("large, sunny")
    panel.get_by_label("Search saved homes").fill("rainy")
    expect(panel.get_by_role("status")).to_have_text("No saved home is called or tagged so.")
    panel.get_by_label("Search saved homes").fill("SUNNY")
    expect(items).to_have_count(1)
    home = items.first.get_attribute("data-saved")
    visit.page.evaluate("navigator.clipboard.writeText = async text => { globalThis.copied = text; }")
    panel.get_by_role("button", name="Copy link By the sea").click()
    expect(panel.get_by_role("status")).to_have_text("Link copied: it opens this home as it is saved.")
    assert visit.page.evaluate("copied") == f"{visit.address}?home={home}"
    visit.page.goto(f"{visit.address}?home={home}")
    visit.page.wait_for_function("() => globalThis.compose?.scene")
    assert [room["id"] for room in visit.page.evaluate("compose.scene.rooms")] == [room["id"] for room in shown["rooms"]]
    visit.settle()


def test_what_somebody_else_changed_is_not_overwritten(visit: Visit, panel: Any) -> None:
    save(panel, "Ours")
    home = panel.locator("li").get_attribute("data-saved")
    path = f"{visit.address}homes/{home}"
    assert visit.page.request.patch(path, data={"name": "Theirs"}, headers={"If-Match": "*"}).ok
    panel.get_by_role("button", name="Save changes").click()
    expect(panel.get_by_role("status")).to_contain_text("Somebody has changed this home")
    assert visit.page.request.get(path).json()["name"] == "Theirs"
    visit.page.route(f"**/homes/{home}", lambda route: route.fulfill(status=404), times=1)
    panel.get_by_role("button", name="Save changes").click()
    expect(panel.get_by_role("status")).to_contain_text("Somebody has removed this home")
    panel.get_by_label("Search saved homes").fill("t")
    panel.get_by_role("button", name="Remove Theirs").click()
    assert visit.page.request.get(path).ok, "it is asked once more"
    panel.get_by_role("button", name="Really remove? Theirs").click()
    expect(panel.get_by_role("status")).to_have_text("Removed “Theirs”.")
    assert visit.page.request.get(path).status == 404
    panel.get_by_label("Search saved homes").fill("")
    expect(panel.get_by_role("status")).to_have_text("No home is saved here yet.")


def test_the_home_that_was_asked_for_last_is_shown_and_its_changes_are_its_own(visit: Visit, panel: Any) -> None:
    save(panel, "Kept")
    home = panel.locator("li").get_attribute("data-saved")
    visit.after(visit.page.locator("#random").click)
    update, name = panel.get_by_role("button", name="Save changes"), panel.get_by_label("Name to save as")
    expect(update).to_be_hidden()
    expect(name).to_have_value("")  # it was the other's
    waiting = held(visit.page, f"homes/{home}", panel.get_by_role("button", name="Open Kept").click)
    expect(visit.page.locator("#stage")).to_have_attribute("aria-busy", "true")
    made = visit.after(visit.page.locator("#random").click)["scene"]
    waiting.continue_()
    visit.settle()
    assert visit.page.evaluate("compose.scene") == made
    expect(update).to_be_hidden()
    panel.get_by_role("button", name="Save this home").click()
    expect(panel.get_by_role("status")).to_have_text(f"Saved “seed {made['seed']}”.")
