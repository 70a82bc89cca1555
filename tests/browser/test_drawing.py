"""A plan drawn on the page, with the pointer and with keys alone: what is sent, what is furnished, what is undone."""

from __future__ import annotations

import re
import struct
import zlib
from typing import Any

import pytest
from playwright.sync_api import expect

from tests.browser.test_accessible import violations
from tests.browser.test_in_turn import held
from tests.browser.visit import SMALL, WINDOW, Document, Visit, rows, sent_by

IN_WINDOW = """([x, z]) => {
    const sheet = document.querySelector('.sheet');
    const at = new DOMPoint(x, z).matrixTransform(sheet.getScreenCTM());
    return [at.x, at.y];
}"""
BOXES = """() => [...document.querySelectorAll('[data-room]')].map(one => {
    const {x, y, width, height} = one.getBBox();
    return [x, y, x + width, y + height];
})"""
TOLD = "[...document.querySelectorAll('#stage > [id], #progress, #stage section, #notice')].map(one => one.id)"
"""What lies over the house, in the page's own order."""
DRAW = "Draw a plan"


class DrawingBoard:
    """The open board of a page, and the scenes that it asks the service about; lengths in mm."""

    def __init__(self, visit: Visit) -> None:
        self.visit, self.page = visit, visit.page
        self.judged: list[Document] = []
        self.page.on(
            "request", lambda request: self.judged.append(sent_by(request)["scene"]) if request.url.endswith("/validate") else None
        )

    def open(self, name: str = DRAW) -> DrawingBoard:
        self.page.get_by_role("button", name=name).click()
        expect(self.page.locator(".sheet")).to_be_visible()
        return self

    def at(self, x: float, z: float) -> tuple[float, float]:
        """Where a point of the plan is in the window."""
        left, top = self.page.evaluate(IN_WINDOW, [x, z])
        return left, top

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Draw or drag from one point of the plan to another."""
        self.page.mouse.move(*self.at(*start))
        self.page.mouse.down()
        self.page.mouse.move(*self.at(*end), steps=4)
        self.page.mouse.up()

    def click(self, x: float, z: float) -> None:
        self.page.mouse.click(*self.at(x, z))

    def tool(self, name: str) -> None:
        self.page.locator(f"#drawing [data-tool={name}]").click()

    def rooms(self) -> list[list[float]]:
        """West, north, east and south of every room drawn."""
        shown: list[list[float]] = self.page.evaluate(BOXES)
        return shown

    def openings(self) -> int:
        return self.page.locator(".sheet [data-opening]").count()

    def verdict(self) -> Document:
        """The scene that the service judged last, once it has found nothing wrong."""
        self.judge()
        expect(self.page.get_by_role("heading", name="Nothing is wrong with the plan")).to_be_visible()
        return self.judged[-1]

    def judge(self) -> None:
        """Wait until the service has judged the last step."""
        expect(self.page.locator("#drawing [aria-busy=true]")).to_have_count(0)

    def furnish(self) -> Document:
        """Furnish what was drawn; returns the answer."""
        with self.page.expect_response(lambda response: response.url.endswith("/furnish")) as caught:
            self.page.get_by_role("button", name="Furnish the rooms").click()
        expect(self.page.locator(".sheet")).to_be_hidden()
        self.visit.settle()
        answer: Document = caught.value.json()
        return answer


def flat(color: tuple[int, int, int], width: int, height: int) -> bytes:
    """A picture of one colour as a PNG file."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = (b"\0" + bytes(color) * width) * height
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


@pytest.fixture
def board(visit: Visit) -> DrawingBoard:
    """An empty board over a small house."""
    visit.open(SMALL.format(4))
    return DrawingBoard(visit).open()


def two_rooms(board: DrawingBoard) -> None:
    """Draws two rooms of 4 by 3 m side by side, a door between them, one outside, a window each."""
    board.drag((1000, 1000), (5020, 3990))  # near the grid is on it
    board.drag((5000, 1010), (9000, 4000))
    board.page.keyboard.press("d")
    board.click(5000, 2500)
    board.click(2000, 4000)
    board.page.keyboard.press("w")
    board.click(1000, 2500)
    board.click(9000, 2500)
    board.page.keyboard.press("v")


def standing(scene: Document) -> dict[str, int]:
    """How many pieces stand in each room."""
    return {room["id"]: len(room["furniture"]) for room in scene["rooms"]}


def test_a_plan_is_drawn_with_the_pointer_and_furnished(board: DrawingBoard) -> None:
    two_rooms(board)
    assert board.rooms() == [[1000, 1000, 5000, 4000], [5000, 1000, 9000, 4000]]
    drawn = board.verdict()
    assert [len(room["openings"]) for room in drawn["rooms"]] == [3, 2]
    assert [one["connects_to"] for one in drawn["rooms"][0]["openings"]] == ["room_2", "EXTERIOR", "EXTERIOR"]
    board.click(7000, 1800)
    board.page.get_by_label("Type").select_option("bedroom")
    answer = board.furnish()
    expect(board.page).to_have_title("Compose: a plan of your own")
    assert answer["scene"]["rooms"][1]["type"] == "bedroom"
    assert min(standing(answer["scene"]).values()) > 0
    assert [issue for issue in answer["issues"] if issue["severity"] == "error"] == []
    assert board.page.evaluate("compose.scene")["rooms"][0]["x"] == 0, "a home begins at its north-western corner"
    board.page.keyboard.press("Control+z")
    board.visit.settle()
    assert board.visit.count("rooms") > 2, "the home of before is back"
    expect(board.page).to_have_title("Compose: house 4")
    assert board.visit.console == []


def test_the_tools_are_one_row_of_a_laptop_and_nothing_is_said_of_the_home_before(board: DrawingBoard) -> None:
    page = board.page
    before = page.viewport_size
    tools = page.locator(".drawing-tools button")
    for width in (1280, 1240, 1180, 1024):
        page.set_viewport_size({"width": width, "height": 800})
        shown = tools.filter(visible=True)
        assert shown.count() > 10
        assert rows(shown) == 1
    expect(page.locator("#status")).to_be_hidden()
    assert page.locator("#drawing").evaluate("one => one.getBoundingClientRect().bottom") == 800, "there is no empty bar beneath it"
    tools.last.click()
    expect(page.locator(".sheet")).not_to_be_visible()
    expect(page.locator("#status [data-count=rooms]")).to_be_visible()
    assert before
    page.set_viewport_size(before)


def test_a_plan_is_drawn_with_keys_alone(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    board = DrawingBoard(visit)
    page = board.page
    page.get_by_role("button", name=DRAW).focus()
    page.keyboard.press("Enter")
    expect(page.locator(".sheet")).to_be_focused()
    for key in ("n", "n"):
        page.keyboard.press(key)
    west, _, east, _ = board.rooms()[1]
    assert west == board.rooms()[0][2]
    page.keyboard.press("ArrowLeft")
    expect(page.locator(".drawing-said")).to_have_text("There it would meet another room.")
    for label in ("Add a door to the west wall", "Add a window to the south wall", "Add a door to the north wall"):
        page.get_by_role("button", name=re.compile("^Room 2,")).press("Enter")
        expect(page.get_by_role("button", name=re.compile("^Room 2,"))).to_be_focused()
        page.get_by_role("button", name=label).press("Enter")
        expect(page.get_by_role("combobox", name="Kind")).to_be_focused()
        expect(page.get_by_role("combobox", name="Kind")).to_have_value(label.split()[2])
    assert board.openings() == 3
    page.get_by_role("button", name=re.compile("^Room 2,")).press("Enter")
    for key in ("w", "ArrowRight", "Shift+ArrowDown"):  # into the wall in the east, then along it
        page.keyboard.press(key)
    expect(page.get_by_label("From the north corner, m")).to_have_value("0.81")
    page.keyboard.press("Delete")
    page.keyboard.press("p")
    page.keyboard.press("ArrowUp")
    expect(page.locator(".drawing-said")).to_have_text("Choose a room first.")
    assert board.openings() == 3
    page.get_by_role("button", name=re.compile("^Room 2,")).press("Enter")
    field = page.get_by_label("North wall", exact=True)
    field.fill("4.35")
    field.press("Enter")
    assert board.rooms()[1][2] - west == 4350 != east - west
    scene = board.furnish()["scene"]
    assert [one["main_entrance"] for one in scene["rooms"][1]["openings"]].count(True) == 1
    assert min(standing(scene).values()) > 0
    assert visit.console == []


def test_a_named_room_is_told_by_its_name_and_guesses_are_said(board: DrawingBoard) -> None:
    two_rooms(board)
    board.click(3000, 1800)
    field = board.page.get_by_label("Name", exact=True)
    field.fill("Aunt May's bedroom")
    field.press("Enter")
    expect(board.page.locator(".room-name").first).to_have_accessible_name(re.compile("^Aunt May's bedroom, "))
    assert board.verdict()["rooms"][0]["name"] == "Aunt May's bedroom"
    answer = board.furnish()
    assert [(guess["room"], guess["by"]) for guess in answer["guesses"]] == [("room_1", "name"), ("room_2", "form")]
    said = board.page.locator("#imported")
    expect(said.get_by_role("heading", name="What the plan became")).to_be_visible()
    expect(said.locator("li").first).to_have_text("Aunt May's bedroom: Bedroom, told by its name, Aunt May's bedroom")
    expect(said.locator("li").nth(1)).to_contain_text("told by its form")
    expect(board.page.locator(".room-label", has_text="Aunt May's bedroom")).to_have_count(1)
    expect(board.page.locator("#room_choice")).to_contain_text("Aunt May's bedroom")
    expect(board.page.locator("#yaml")).to_contain_text('name: "Aunt May\'s bedroom"')
    expect(board.page.locator("#said")).to_contain_text("No link holds this home")
    board.open("Change this plan")
    expect(board.page.locator(".room-name").first).to_have_accessible_name(re.compile("^Aunt May's bedroom, "))


def test_a_door_is_moved_and_all_is_undone(board: DrawingBoard) -> None:
    two_rooms(board)
    board.drag((2000, 4000), (3000, 4000))
    assert board.page.get_by_label("From the west corner, m").input_value() == "1.55"
    board.page.keyboard.press("ArrowRight")
    assert board.page.get_by_label("From the west corner, m").input_value() == "1.60"
    assert board.verdict()["rooms"][0]["openings"][1]["position"] == 2.05
    for steps, said in ((6, "No room has a door"), (1, "Room has no door")):
        for _ in range(steps):
            board.page.keyboard.press("Control+z")
        expect(board.page.locator(".drawing-side .issue").last).to_have_text(said)
    board.page.keyboard.press("Control+z")
    assert (board.rooms(), board.openings()) == ([], 0)
    for _ in range(8):
        board.page.keyboard.press("Control+Shift+z")
    assert (len(board.rooms()), board.openings()) == (2, 4)


def test_a_door_where_walls_meet_joins_two_rooms(board: DrawingBoard) -> None:
    for start, end in (((0, 0), (5, 4)), ((5, 0), (8, 4)), ((0, 4), (4, 7.5)), ((4, 4), (5.5, 7.5)), ((5.5, 4), (8, 7.5))):
        board.drag((1000 * start[0], 1000 * start[1]), (1000 * end[0], 1000 * end[1]))
    board.page.keyboard.press("d")
    board.click(4700, 7500)
    board.judge()
    expect(board.page.locator(".drawing-side .issue-warning")).to_have_count(4)  # the other rooms, each once, none as if it were wrong
    expect(board.page.locator(".drawing-side .issue-error, .sheet .floor.wrong")).to_have_count(0)
    for x, z in ((4700, 4000), (4000, 5500), (5500, 5500), (5000, 1500)):
        board.click(x, z)
    leading = {room["id"]: [one["connects_to"] for one in room["openings"]] for room in board.verdict()["rooms"]}
    assert leading == {
        "room_1": ["room_4", "room_2"],
        "room_2": ["room_1"],
        "room_3": ["room_4"],
        "room_4": ["EXTERIOR", "room_1", "room_3", "room_5"],
        "room_5": ["room_4"],
    }
    issues = board.furnish()["issues"]
    assert [issue for issue in issues if issue["rule"] == "unreachable"] == []


def test_rooms_are_cut_and_walls_dragged_for_both_sides(board: DrawingBoard) -> None:
    two_rooms(board)
    board.click(7000, 2000)
    board.tool("cut")
    board.drag((7000, 3000), (9000, 4000))
    assert board.verdict()["rooms"][1]["outline"] == [[0, 0], [4, 0], [4, 2], [2, 2], [2, 3], [0, 3]]
    board.tool("choose")
    board.drag((5000, 1500), (4500, 1500))
    assert [room[:1] + room[2:3] for room in board.rooms()] == [[1000, 4500], [4500, 9000]]
    board.tool("room")
    board.drag((1500, 1500), (3000, 3000))
    expect(board.page.get_by_text("shares no floor with another")).to_be_visible()
    assert len(board.rooms()) == 2


def test_a_wall_of_a_furnished_home_is_dragged_and_what_goes_with_it_is_told(board: DrawingBoard) -> None:
    two_rooms(board)
    board.click(3000, 2200)
    board.page.get_by_label("Type").select_option("living_room")
    board.click(7000, 2200)
    board.page.get_by_label("Type").select_option("bedroom")
    before = board.furnish()["scene"]
    board.open("Change this plan")
    expect(board.page.locator(".sheet .piece")).not_to_have_count(0)
    board.click(200, 200)
    with board.page.expect_response(lambda response: response.url.endswith("/furnish")) as caught:
        board.drag((4000, 200), (4400, 200))
    after = caught.value.json()["scene"]
    assert [room["width"] for room in after["rooms"]] == [4.4, 3.6]
    board.judge()
    for old, new in zip(before["rooms"], after["rooms"], strict=True):
        kept = {piece["id"] for piece in old["furniture"]} & {piece["id"] for piece in new["furniture"]}
        assert len(kept) >= len(old["furniture"]) // 2
    assert [issue for issue in caught.value.json()["issues"] if issue["severity"] == "error"] == []
    calls: list[str] = []
    board.page.on("response", lambda response: calls.append(response.url.rsplit("/", 1)[-1]))
    board.tool("cut")
    with board.page.expect_response(lambda response: "furnish" in calls and response.url.endswith("/validate")):
        board.drag((-200, -200), (400, 3200))
    board.judge()
    expect(board.page.get_by_text("1 door or window no longer fits")).to_be_visible()
    board.tool("show")
    board.visit.settle()
    assert [room["width"] for room in board.page.evaluate("compose.scene")["rooms"]] == [4, 3.6]
    board.page.keyboard.press("Control+z")
    board.visit.settle()
    assert board.page.evaluate("compose.scene")["rooms"] == before["rooms"]
    assert board.visit.console == []


def in_view(board: DrawingBoard) -> None:
    """The whole picture is seen on the sheet."""
    sheet, picture = (board.page.locator(one).evaluate("one => one.getBoundingClientRect().toJSON()") for one in (".sheet", ".traced"))
    assert sheet["left"] <= picture["left"] and picture["right"] <= sheet["right"]
    assert sheet["top"] <= picture["top"] and picture["bottom"] <= sheet["bottom"]


def test_a_picture_lies_beneath_and_is_scaled_by_a_known_length(board: DrawingBoard) -> None:
    page = board.page
    page.get_by_label("A picture to trace").set_input_files(
        {"name": "plan.png", "mimeType": "image/png", "buffer": flat((200, 180, 160), 120, 80)}
    )
    expect(page.locator(".traced")).to_have_attribute("width", "12000")
    page.get_by_role("button", name="Measure a known length").click()
    board.click(1000, 1000)
    board.click(4000, 1000)
    expect(page.get_by_label("That is, m")).to_be_focused()
    page.keyboard.type("6\n")  # in place of what it was taken to be
    expect(page.locator(".sheet")).to_be_focused()
    expect(page.get_by_role("button", name="Draw a room")).to_have_attribute("aria-pressed", "true")
    width = float(page.locator(".traced").get_attribute("width") or 0)
    assert width == pytest.approx(24000, rel=0.02)
    in_view(board)
    field = page.get_by_label("Its width, m")
    expect(field).to_have_value(f"{width / 1000:.2f}")
    field.fill("50")
    field.press("Enter")
    assert float(page.locator(".traced").get_attribute("width") or 0) == pytest.approx(50000)
    in_view(board)
    page.get_by_role("button", name="Remove the picture").click()
    page.get_by_label("A picture to trace").set_input_files({"name": "none.png", "mimeType": "image/png", "buffer": b"no picture"})
    expect(page.get_by_text("none.png is no picture")).to_be_visible()


def test_the_board_is_accessible_and_gives_the_focus_back(board: DrawingBoard) -> None:
    found: dict[str, Any] = {"empty": violations(board.visit)}
    two_rooms(board)
    board.click(3000, 2200)
    board.verdict()
    found["a room"] = violations(board.visit)
    board.click(1000, 2500)
    found["a window"] = violations(board.visit)
    board.page.set_viewport_size({"width": 390, "height": 800})
    found["on a phone"] = violations(board.visit)
    board.page.keyboard.press("n")
    expect(board.page.locator(".floor").nth(2)).to_be_in_viewport(ratio=0.99)
    assert {state: wrong for state, wrong in found.items() if wrong} == {}
    drawn = board.rooms()
    board.tool("close")
    expect(board.page.get_by_role("button", name=DRAW)).to_be_focused()
    board.page.set_viewport_size(WINDOW)
    board.open()
    assert board.rooms() == []
    expect(board.page.get_by_text("Undo brings back what was drawn before.")).to_be_visible()
    board.page.keyboard.press("Control+z")
    assert board.rooms() == drawn
    board.visit.after(board.page.locator("#random").click)
    expect(board.page.locator(".sheet")).to_be_hidden()
    expect(board.page.locator("#random")).to_be_focused()


def test_what_is_under_way_and_what_fails_is_said_over_the_board(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    page = visit.page
    places = page.evaluate(TOLD)
    progress, notice = page.get_by_role("progressbar"), page.get_by_role("alert")
    held(page, "validate", lambda: DrawingBoard(visit).open("Change this plan")).abort()
    expect(page.get_by_role("heading", name="Not judged yet")).to_be_visible()
    notice.get_by_role("button", name="Try again").click()
    expect(page.get_by_role("heading", name="Nothing is wrong with the plan")).to_be_visible()
    expect(notice).to_be_hidden()
    waiting = held(page, "furnish", page.get_by_role("button", name="Furnish the rooms").click)
    expect(progress).to_contain_text("Furnishing the plan")
    assert progress.evaluate("one => one.closest('[inert]')") is None
    waiting.abort()
    expect(notice).to_contain_text("The service does not answer")
    notice.get_by_role("button", name="Try again").click()
    expect(page.locator("#drawing")).to_be_hidden()
    visit.settle()
    assert any(room["furniture"] for room in visit.page.evaluate("compose.scene.rooms"))
    assert page.evaluate(TOLD) == places
