"""What opens of furniture on the page: by a click on the chosen piece, by its key; what it costs."""

from __future__ import annotations

from typing import Any

import pytest

from tests.browser.visit import Visit

PLANNED = "?program=studio&seed=3"
MEETS_HOUSE = """name => {
    const at = compose.whereIs(name);
    return at !== null && document.elementFromPoint(at.x, at.y)?.matches('#stage > canvas') === true;
}"""
LARGE = "?program=large&seed=4&decorate=true"
MOST_CALLS = 60


def certified(answer: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """What the certificate says of all fronts, by piece."""
    return {piece: fronts for room in answer["scene"]["certificate"]["rooms"].values() for piece, fronts in room.get("fronts", {}).items()}


def press(visit: Visit, key: str) -> None:
    visit.page.keyboard.press(key)
    visit.settle()


def click(visit: Visit, name: str) -> None:
    at = visit.page.evaluate("name => compose.whereIs(name)", name)
    assert at is not None, name
    visit.page.mouse.click(at["x"], at["y"])
    visit.settle()


def seen_front(visit: Visit, fronts: dict[str, dict[str, Any]]) -> tuple[str, str]:
    """A piece and one of its fronts that a click meets from where one looks."""
    for piece, several in fronts.items():
        for front in several:
            if visit.page.evaluate("name => compose.whereIs(name)", f"{piece}/{front}"):
                return piece, front
    raise AssertionError("no front is seen")


def chosen_front(visit: Visit, fronts: dict[str, dict[str, Any]]) -> tuple[str, str]:
    """A piece, chosen by a click, and one of its fronts that a click meets then: no distance is written over it."""
    for piece, several in fronts.items():
        for front in several:
            name = f"{piece}/{front}"
            if visit.page.evaluate("name => compose.whereIs(name)", name):
                click(visit, name)
                if visit.page.evaluate(MEETS_HOUSE, name):
                    return piece, front
                press(visit, "Escape")
    raise AssertionError("no front of a chosen piece is seen")


def test_the_key_opens_all_fronts_of_the_chosen_piece_and_shuts_them(visit: Visit) -> None:
    fronts = certified(visit.open(PLANNED))
    piece, front = seen_front(visit, fronts)
    click(visit, f"{piece}/{front}")
    assert visit.state()["selected"] == piece
    assert visit.state()["openFronts"] == []
    press(visit, "t")
    assert visit.state()["openFronts"] == [f"{piece}/{name}" for name in fronts[piece]]
    assert visit.state()["openDoors"] == []
    press(visit, "t")
    assert visit.state()["openFronts"] == []


def test_a_click_opens_one_front_of_the_chosen_piece(visit: Visit) -> None:
    fronts = certified(visit.open(PLANNED))
    piece, front = chosen_front(visit, fronts)
    click(visit, f"{piece}/{front}")
    assert visit.state()["openFronts"] == [f"{piece}/{front}"]
    assert visit.idle() == 0
    click(visit, f"{piece}/{front}")
    assert visit.state()["openFronts"] == []
    assert visit.state()["selected"] == piece


def test_with_nothing_chosen_the_key_opens_a_door(visit: Visit) -> None:
    visit.open(PLANNED)
    press(visit, "t")
    assert len(visit.state()["openDoors"]) == 1
    assert visit.state()["openFronts"] == []


def test_who_wants_no_motion_sees_doors_and_fronts_open_at_once(visit: Visit) -> None:
    visit.open(PLANNED)

    def frames(key: str) -> int:
        before: int = visit.state()["frames"]
        press(visit, key)
        after: int = visit.state()["frames"]
        return after - before

    for key in ("t", "Shift+T"):
        visit.page.emulate_media(reduced_motion="reduce")
        at_once = frames(key)
        visit.page.emulate_media(reduced_motion="no-preference")
        assert 1 <= at_once <= 2 < frames(key), key


@pytest.mark.parametrize("query", [LARGE])
def test_all_fronts_of_a_large_home_open_in_few_draw_calls(visit: Visit, query: str) -> None:
    fronts = certified(visit.open(query))
    count = sum(map(len, fronts.values()))
    assert count > 50
    shut = visit.page.evaluate("compose.measure(0)")
    press(visit, "Shift+T")
    assert len(visit.state()["openFronts"]) == count
    opened = visit.page.evaluate("compose.measure(0)")
    assert opened["drawCalls"] <= MOST_CALLS
    assert opened["drawCalls"] == shut["drawCalls"]
    press(visit, "Shift+T")
    assert visit.state()["openFronts"] == []
