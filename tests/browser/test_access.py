"""A standard of access chosen in the form: the home is made for it, its squares are shown, and the report says that it is met."""

from __future__ import annotations

from playwright.sync_api import expect

from tests.browser.visit import Visit, sent_by

SMALL = "?seed=4&program=one_bed&access=ada&width=5&depth=5"


def test_a_home_is_made_for_the_standard_that_is_chosen(visit: Visit) -> None:
    page = visit.page
    visit.open("?seed=3&program=one_bed")
    expect(page.locator("#access option")).to_have_count(4)
    page.locator("#access").select_option("ada")
    with page.expect_request("**/generate") as asked, page.expect_response("**/generate") as answered:
        page.locator("#generate").click()
    assert sent_by(asked.value)["access"] == "ada"
    scene = answered.value.json()["scene"]
    assert scene["certificate"]["access"] == {"profile": "ada", "met": True, "unmet": []}
    visit.settle()
    assert "access=ada" in page.url
    plain = visit.state()["floorZones"]
    with page.expect_response("**/floor") as floor:
        page.keyboard.press("o")
    rooms = floor.value.json()["rooms"]
    squares = [square for room in rooms for square in room["turning"]]
    assert len(squares) >= 3
    assert all(round(x1 - x0, 3) == round(z1 - z0, 3) == 1.525 for x0, z0, x1, z1 in squares)
    assert [room["short"] for room in rooms if room["short"]] == []
    page.wait_for_function("plain => compose.state.floorZones > plain", arg=plain)
    page.keyboard.press("d")
    expect(page.get_by_role("dialog", name="Diagnosis")).to_contain_text("# Access: ada, met")
    page.keyboard.press("Escape")
    assert visit.console == []


def test_what_is_short_is_told_in_centimetres(visit: Visit) -> None:
    scene = visit.open(SMALL)["scene"]
    unmet = scene["certificate"]["access"]["unmet"]
    assert unmet
    visit.page.locator("#shortfall_line").click()
    told = visit.page.locator("#shortfall_list > li")
    expect(told.filter(has_text="Access, ada")).to_have_count(len(unmet))
    expect(told.filter(has_text="cm short").first).to_be_visible()
    with visit.page.expect_response("**/floor") as floor:
        visit.page.keyboard.press("o")
    assert any(room["short"] for room in floor.value.json()["rooms"])
