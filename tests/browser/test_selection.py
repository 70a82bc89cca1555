"""Clicks: a line of the YAML selects its body, a body its line."""

from __future__ import annotations

from playwright.sync_api import Route, expect

from tests.browser.visit import FRAMES, SMALL, Visit, furniture_of, intercept, rows, said


def test_a_line_selects_its_body_and_only_one_at_a_time(visit: Visit) -> None:
    first, second = furniture_of(visit.open(SMALL.format(4)))[:2]
    for piece in (first, second):
        visit.line_of(piece).click()
        assert visit.state()["selected"] == piece
        assert visit.state()["marks"]["selected"] == [piece]
        expect(visit.line_of(piece)).to_have_attribute("aria-pressed", "true")
    expect(visit.line_of(first)).to_have_attribute("aria-pressed", "false")
    visit.page.keyboard.press("Escape")
    assert visit.state()["selected"] is None
    expect(visit.line_of(second)).to_have_attribute("aria-pressed", "false")


def test_a_body_clicked_shows_its_line(visit: Visit) -> None:
    pieces = furniture_of(visit.open(SMALL.format(4)))
    visit.page.keyboard.press("2")
    visit.settle()
    clicked = next(piece for piece in reversed(pieces) if visit.click_on(piece))
    assert visit.state()["selected"] == clicked
    expect(visit.line_of(clicked)).to_have_attribute("aria-pressed", "true")
    expect(visit.line_of(clicked)).to_be_in_viewport()
    before = visit.page.viewport_size
    visit.page.keyboard.press("]")
    visit.page.set_viewport_size({"width": 1024, "height": 768})
    tools = visit.page.locator("#tools button").filter(visible=True)
    assert tools.count() > 8
    assert rows(tools) == 1, "what is done to it is one row of a small laptop"
    undo, lock = (visit.page.locator(f"#tools [data-tool={tool}]") for tool in ("undo", "lock"))
    at = [undo.bounding_box(), lock.bounding_box()]
    expect(undo).to_be_disabled()
    for button, can_be_undone in ((lock, True), (undo, False)):
        button.click()
        expect(undo).to_be_enabled(enabled=can_be_undone)
        assert [undo.bounding_box(), lock.bounding_box()] == at, "no other button comes under a second click"
    assert before
    visit.page.set_viewport_size(before)


def test_a_body_pointed_at_is_named_with_its_sizes(visit: Visit) -> None:
    answer = visit.open(SMALL.format(4))
    visit.page.keyboard.press("2")
    visit.settle()
    tip = visit.page.locator(".body-tip")
    expect(tip).to_be_hidden()
    pieces = [piece for room in answer["scene"]["rooms"] for piece in room["furniture"]]
    piece = next(one for one in pieces if visit.page.evaluate("id => compose.whereIs(id)", one["id"]))
    at = visit.page.evaluate("id => compose.whereIs(id)", piece["id"])
    visit.page.mouse.move(at["x"], at["y"])
    expect(tip).to_be_visible()
    expect(tip).to_contain_text(said(piece["name"]))
    expect(tip).to_contain_text(" × ".join(f"{piece[side]:g}" for side in ("width", "depth", "height")))


def test_what_is_pointed_at_is_what_lies_there_once_the_house_has_turned(visit: Visit) -> None:
    answer, page = visit.open(SMALL.format(4)), visit.page

    def pointed() -> list[str]:
        page.evaluate(FRAMES, 2)
        found: list[str] = visit.state()["marks"].get("pointed", [])
        return found

    seen = {piece: page.evaluate("id => compose.whereIs(id)", piece) for piece in furniture_of(answer)}
    piece, at = next((piece, at) for piece, at in seen.items() if at and abs(at["x"] - 500) > 100)
    page.locator("#stage").focus()
    page.mouse.move(at["x"], at["y"])
    page.wait_for_function("id => compose.state.marks.pointed?.[0] === id", arg=piece)
    for _ in range(6):
        page.keyboard.press("ArrowLeft")
    visit.settle()
    found = pointed()
    assert found != [piece]
    page.mouse.move(at["x"] + 1, at["y"])
    page.mouse.move(at["x"], at["y"])
    assert pointed() == found


def test_the_arrow_keys_go_through_the_lines(visit: Visit) -> None:
    pieces = furniture_of(visit.open(SMALL.format(4)))
    visit.line_of(pieces[0]).focus()
    visit.page.keyboard.press("ArrowDown")
    visit.page.keyboard.press("Enter")
    assert visit.state()["selected"] == pieces[1]


def test_pieces_in_error_are_framed_and_named_in_the_services_words(visit: Visit) -> None:
    wronged: list[str] = []

    def worsen(route: Route) -> None:
        answer = route.fetch().json()
        wronged[:] = furniture_of(answer)[:2]
        answer["issues"] = [
            {"rule": "overlap", "severity": "error", "room": None, "ids": wronged, "amount": 0.1, "message": "they share 0.1 m"},
            {"rule": "missing_required", "severity": "warning", "room": None, "ids": [], "amount": None, "message": "no oven"},
        ]
        route.fulfill(json=answer)

    intercept(visit.page, "**/generate", worsen)
    visit.open(SMALL.format(4))
    assert visit.count("issues") == 1, "the warning is counted apart"
    assert sorted(visit.state()["marks"]["error"]) == sorted(wronged)
    expect(visit.page.locator("#issue_list")).to_contain_text("They share 0.1 m")
    visit.page.get_by_role("button", name="They share 0.1 m").click()
    assert visit.state()["selected"] == wronged[0]
