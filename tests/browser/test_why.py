"""Why a piece stands where it does: the page says what the service answers, and goes to what holds it."""

from __future__ import annotations

from collections.abc import Callable
from itertools import islice

from playwright.sync_api import expect

from tests.browser.visit import SMALL, Document, Visit, furniture_of, told, told_sentence
from tests.sweeps import times


def asked(visit: Visit, id_of: str) -> Document:
    """Chooses a piece, presses the key, and returns what the service said."""
    visit.line_of(id_of).click()
    with visit.page.expect_response(lambda response: response.url.endswith("/explain")) as caught:
        visit.page.keyboard.press("h")
    answer: Document = caught.value.json()
    return answer


def test_what_holds_a_piece_is_said_and_can_be_chosen(visit: Visit) -> None:
    made, page = visit.open(SMALL.format(4)), visit.page
    panel, tool = page.locator("#why"), page.get_by_role("button", name="Why here?")
    expect(tool).to_be_hidden()
    answers = ((piece, asked(visit, piece)) for piece in furniture_of(made))
    held, answer = next((piece, answer) for piece, answer in answers if {hold["what"] for hold in answer["holds"]} == {"piece"})
    by = answer["holds"][0]
    assert asked(visit, held) == answer
    expect(panel).to_be_visible()
    expect(panel.locator("ul:not(.ways) li")).to_have_text([told_sentence(hold["message"], made["scene"]) for hold in answer["holds"]])
    for note in answer["notes"]:
        expect(panel).to_contain_text(told(note, made["scene"])[1:])
    expect(page.locator(".ruler-hold")).to_have_count(len(answer["holds"]))
    panel.get_by_role("button", name=told(by["message"], made["scene"])).click()
    assert visit.state()["selected"] == by["by"]
    expect(panel).to_be_hidden()
    tool.click()
    expect(panel).to_be_visible()
    page.keyboard.press("Escape")
    expect(panel).to_be_hidden()
    assert visit.state()["selected"] == by["by"], "one thing at a time"
    page.keyboard.press("Escape")
    assert visit.state()["selected"] is None
    assert visit.console == []


def test_another_way_to_stand_is_shown_and_taken(visit: Visit) -> None:
    """Of the ways that leave nothing out: the room becomes what the service says it would be, as one step."""
    made, page = visit.open(SMALL.format(4)), visit.page
    answers = ((piece, asked(visit, piece)) for piece in furniture_of(made))
    piece, answer, way = next(
        (piece, answer, way) for piece, answer in answers for way in answer["ways"] if way["cost"] is not None and not way["left_out"]
    )
    number = answer["ways"].index(way)
    expect(page.locator("#why .ways li")).to_have_count(len(answer["ways"]))
    take = page.locator("#why .ways li").nth(number).locator("button")
    take.focus()
    expect(page.locator("#why")).to_be_visible()
    take.press("Enter")
    visit.settle()
    shown = page.evaluate("compose.scene")
    stands = {one["id"]: (one["x"], one["z"], one["rotation"]) for room in shown["rooms"] for one in room["furniture"]}
    (own,) = [move for move in way["moves"] if move["id"] == piece]
    assert stands[piece] == (own["x"], own["z"], own["rotation"])
    page.keyboard.press("Control+z")
    visit.settle()
    assert page.evaluate("compose.scene") == made["scene"]
    assert visit.console == []


BOX = "one => { const {left, top, right, bottom} = one.getBoundingClientRect(); return {left, top, right, bottom}; }"
DECORATED = "?seed=7&program=one_bed&decorate=true"


def test_its_numbers_are_explained_and_it_leaves_the_middle_of_the_house_free(visit: Visit) -> None:
    page = visit.page
    page.set_viewport_size({"width": 1440, "height": 860})
    made = visit.open(DECORATED)
    bed = next(piece for piece in furniture_of(made) if piece.rsplit("/")[-1].startswith("bed"))
    assert asked(visit, bed)["holds"] != []
    panel = page.locator("#why")
    expect(panel.locator(".hint")).to_contain_text("the room's cost")
    close, around, stage = (
        found.evaluate(BOX) for found in (panel.get_by_role("button", name="Close"), panel, page.locator(".stage").first)
    )
    assert around["top"] <= close["top"] and close["bottom"] <= around["bottom"], "Close is seen without scrolling"
    words = panel.locator("> div").evaluate(BOX)
    assert words["bottom"] <= close["top"], "Close lies over no words"
    panel.locator(".ways li").last.scroll_into_view_if_needed()
    last = panel.locator(".ways li").last.evaluate(BOX)
    assert last["bottom"] <= words["bottom"] + 1, "the last way can be read wholly"
    assert around["left"] > (stage["left"] + stage["right"]) / 2


def test_a_piece_that_the_panel_would_cover_comes_out_from_under_it(visit: Visit) -> None:
    """Those that stand where the panel comes to lie are seen beside it, by pixels that are theirs."""
    page = visit.page
    page.set_viewport_size({"width": 1100, "height": 700})
    pieces = furniture_of(visit.open(DECORATED))
    asked(visit, pieces[0])
    panel = page.locator("#why").evaluate(BOX)
    page.keyboard.press("Escape")
    page.locator("#camera_corner").click()
    visit.settle()
    places = {piece: page.evaluate("id => compose.whereIs(id)", piece) for piece in pieces}
    under = [piece for piece, at in places.items() if at and at["x"] > panel["left"] and panel["top"] < at["y"] < panel["bottom"]]
    assert len(under) >= 3
    for piece in under[: times(3, 1)]:
        asked(visit, piece)
        expect(page.locator("#why")).to_be_visible()
        visit.settle()
        seen = page.evaluate("id => { const at = compose.whereIs(id); return at && document.elementFromPoint(at.x, at.y).tagName; }", piece)
        assert seen == "CANVAS", piece
        page.locator("#camera_corner").click()
        visit.settle()


def test_closed_it_gives_back_the_view_it_took(visit: Visit) -> None:
    """Unless the view was moved since, or another piece is chosen, which may be in hand."""
    page = visit.page
    page.set_viewport_size({"width": 1100, "height": 700})
    pieces = furniture_of(visit.open(DECORATED))
    page.locator("#camera_plan").click()
    visit.settle()

    def looked(*acts: Callable[[], object]) -> list[float]:
        for act in acts:
            act()
        visit.settle()
        return [round(one, 6) for name in ("eye", "target") for one in visit.state()[name]]

    def explained(piece: str) -> list[float]:
        asked(visit, piece)
        page.locator("#why").wait_for()
        return looked()

    before = looked()
    first, second = islice((piece for piece in pieces if explained(piece) != before), 2)
    assert looked(lambda: page.keyboard.press("Escape")) == before, "from piece to piece, and back"
    assert explained(first) != before
    assert looked(page.locator("#why").get_by_role("button", name="Close").click) == before
    aside = explained(first)
    assert looked(visit.line_of(second).click) == aside
    explained(first)
    corner = looked(page.locator("#camera_corner").click)
    assert looked(lambda: page.keyboard.press("Escape")) == corner != before


MARKS = """() => ['.ruler-words, .piece-label.chosen', '.handle, #tools, .views, .compass'].map(names =>
    [...document.querySelectorAll(names)].filter(one => one.checkVisibility()).map(one => {
        const {left, top, right, bottom} = one.getBoundingClientRect();
        return [one.textContent.trim(), left, top, right, bottom];
    }))"""
"""What is written over the house, and what else lies there, with the rectangles that they take."""


def test_where_little_is_seen_no_mark_of_it_lies_over_another_nor_under_a_control(visit: Visit) -> None:
    """As at a zoom of 200 %."""
    page = visit.page
    page.set_viewport_size({"width": 640, "height": 400})
    made = visit.open(DECORATED)
    sofa = next(piece for piece in furniture_of(made) if piece.endswith("/sofa_1"))
    page.evaluate("id => document.querySelector(`#yaml button[data-id='${id}']`).click()", sofa)
    visit.settle()
    with page.expect_response(lambda response: response.url.endswith("/explain")):
        page.keyboard.press("h")
    expect(page.locator("#why")).to_be_visible()
    visit.settle()
    marks, controls = page.evaluate(MARKS)
    assert len(marks) >= 3 and len(controls) >= 3
    for number, (words, *a) in enumerate(marks):
        for other, *b in [*controls, *marks[:number]]:
            assert not (a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]), f"{words} over {other}"


def test_what_lies_on_a_piece_of_another_size_is_laid_on_it_anew(visit: Visit) -> None:
    """Of a way that puts another size of pieces that things lie on: nothing on them meets or hangs over, and no rule is broken."""
    page = visit.page
    made = visit.open("?seed=3&program=one_bed&decorate=true&people=false")["scene"]
    sizes = {piece["id"]: (piece["width"], piece["depth"]) for room in made["rooms"] for piece in room["furniture"]}
    loaded = {thing["parent"] for room in made["rooms"] for thing in room["decorations"] if thing["mounted_on_wall"] is None}
    sofa = next(piece for piece in sorted(loaded - {None}) if piece.endswith("/sofa_1"))
    ways = asked(visit, sofa)["ways"]
    taken = next(
        way for way in ways if any(one["id"] in loaded and (one["width"], one["depth"]) != sizes[one["id"]] for one in way["moves"])
    )
    page.locator("#why .ways button").nth([way for way in ways if way["cost"] is not None].index(taken)).click()
    visit.settle()
    shown = page.evaluate("compose.scene")
    assert shown != made
    expect(page.locator("#status .verdict.has-issues")).to_have_count(0)
    for room in shown["rooms"]:
        for piece in room["furniture"]:
            if (piece["width"], piece["depth"]) == sizes[piece["id"]]:
                continue
            rects = [rect_of(thing) for thing in room["decorations"] if thing["parent"] == piece["id"] and thing["mounted_on_wall"] is None]
            x0, z0, x1, z1 = rect_of(piece)[:4]
            assert all(x0 <= one[0] and z0 <= one[1] and one[2] <= x1 and one[3] <= z1 for one in rects), piece["id"]
            assert piece["id"] not in loaded or rects, piece["id"]
            assert not any(meet(one, other) for number, one in enumerate(rects) for other in rects[:number]), piece["id"]


def rect_of(body: Document) -> tuple[float, ...]:
    """A body's edges from west, north and below to east, south and above, m, a millimetre within, as at the nearest right angle."""
    wide, deep = (body["width"], body["depth"]) if round(body["rotation"] / 90) % 2 == 0 else (body["depth"], body["width"])
    half_x, half_z = wide / 2 - 0.001, deep / 2 - 0.001
    return (body["x"] - half_x, body["z"] - half_z, body["x"] + half_x, body["z"] + half_z, body["y"], body["y"] + body["height"])


def meet(one: tuple[float, ...], other: tuple[float, ...]) -> bool:
    """Whether two bodies are in one another."""
    return all(one[low] < other[high] and other[low] < one[high] for low, high in ((0, 2), (1, 3), (4, 5)))
