"""What fell short is told in plain words, and every wrong field by the form's own name."""

from __future__ import annotations

from playwright.sync_api import expect

from tests.browser.visit import Visit

WISHED = 40


def test_an_area_that_could_not_be_met_and_pieces_left_out_are_told(visit: Visit) -> None:
    scene = visit.open(f"?seed=3&program=family&area={WISHED}")["scene"]
    assert any(f"not {WISHED}" in note for note in scene["certificate"]["notes"])
    left = [(room, one["piece"], one["reason"]) for room, said in scene["certificate"]["rooms"].items() for one in said["left_out"]]
    line = visit.page.locator("#shortfall_line")
    expect(line).to_contain_text(f"m², not {WISHED}: its rooms would be too small.")
    tried = [piece for _, piece, reason in left if not reason.startswith("the floor is covered")]
    expect(line).to_contain_text(f"{len(tried)} more pieces were tried and found no place.")
    expect(visit.page.locator("#status")).not_to_contain_text("0 issues")
    line.click()
    told = visit.page.locator("#shortfall_list > li")
    assert "not 40" in told.first.inner_text()
    why = visit.page.locator("#shortfall_list details")
    why.first.locator("summary").click()
    expect(why.first.locator("p").first).to_contain_text("needs")
    assert visit.page.locator("#shortfall_list details p").count() == len(left)
    visit.page.locator("#shortfall_list .shortfall").first.click()
    assert visit.page.locator("#room_choice").input_value() in {room for room, *_ in left}
    visit.page.locator("#recent summary").click()
    expect(visit.page.locator("#recent_list .recent-home")).to_have_count(1)
    assert visit.console == []


def test_a_garden_without_a_patio_is_told_without_alarm(visit: Visit) -> None:
    scene = visit.open("?program=one_bed&seed=12&outdoor=true")["scene"]
    assert [note.split(":")[0] for note in scene["certificate"]["notes"]] == ["no patio"]
    expect(visit.page.locator(".verdict .kept")).to_be_visible()
    expect(visit.page.locator("#shortfall_line")).not_to_have_class("shortfall-line is-asked")
    expect(visit.page.locator("#shortfall_list > li").first).to_contain_text("No patio: beside the backyard")


def test_every_wrong_field_is_named_by_its_label_at_once(visit: Visit) -> None:
    visit.page.goto(visit.address + "?program.bedrooms=99&width=wide&robot_width=9")
    visit.settle()
    alert = visit.page.get_by_role("alert")
    told = ("3 fields need", "Width: enter a number from 2 to 1000 m", "Bedrooms: enter a whole number", "Robot width: enter a number")
    for words in told:
        expect(alert).to_contain_text(words)
    expect(visit.page.locator("[aria-invalid=true]")).to_have_count(3)
    expect(visit.page.locator(".verdict")).to_be_hidden()  # there is no home that a rule could be kept in
    expect(visit.page.locator("#width_problem")).to_have_text("Enter a number from 2 to 1000 m")
