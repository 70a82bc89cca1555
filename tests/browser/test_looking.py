"""Looking at the house: floors that are clicked, cameras, the cut through the walls, names on demand."""

from __future__ import annotations

from tests.browser.visit import SMALL, Visit


def test_a_floor_clicked_tells_its_room(visit: Visit) -> None:
    rooms = visit.open(SMALL.format(4))["scene"]["rooms"]
    visit.page.evaluate("globalThis.told = []; compose.onRoom = id => told.push(id); 0")
    visit.page.keyboard.press("2")
    visit.settle()
    clicked = [room["id"] for room in rooms if visit.click_on(room["id"])]
    assert len(clicked) == len(rooms)
    assert visit.page.evaluate("told") == clicked
