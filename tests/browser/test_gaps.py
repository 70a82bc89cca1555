"""Distances around the chosen piece are the scene's own, at rest and while it is moved."""

from __future__ import annotations

import re
from typing import Any

from playwright.sync_api import expect

from tests.browser.test_editing import ONE, OTHER, Bench, crate, den, poses
from tests.browser.visit import Visit


def told(visit: Visit) -> dict[str, str]:
    """The distances shown, by side."""
    rows = visit.page.locator("#gaps dt, #gaps dd").all_inner_texts()
    return {side.lower(): said for side, said in zip(rows[::2], rows[1::2], strict=True)}


def test_distances_to_walls_and_pieces_follow_the_piece(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1), crate(OTHER, 3, 1)))
    gaps = visit.page.locator("#gaps")
    expect(gaps).to_be_hidden()
    visit.line_of(ONE).click()
    walls = {"north": "0.50", "east": "2.50", "south": "1.50", "west": "0.50"}
    wanted = {side: f"{gap} m to the wall" for side, gap in walls.items()}
    assert told(visit) == {**wanted, "east": "2.50 m to the wall, 1.00 m to crate"}
    visit.page.locator("#stage").focus()
    bench.press("Shift+ArrowRight", "ArrowRight")
    x = poses(bench.scene())[ONE][0]
    assert x != 1
    assert told(visit)["west"] == f"{x - 0.5:.2f} m to the wall"
    assert told(visit)["east"] == f"{4 - x - 0.5:.2f} m to the wall, {3 - x - 1:.2f} m to crate"
    visit.page.keyboard.press("Escape")
    expect(gaps).to_be_hidden()


LAID = """() => [
    ...document.querySelectorAll('.handle, .ruler-words, .piece-label.chosen, .room-label:not(.crowded-out)')
].filter(one => one.checkVisibility()).map(one => {
    const [{left, top, right, bottom}, unseen] = [one.getBoundingClientRect(), one.clientLeft]; // for fingers they have an empty border
    return [one.textContent, left + unseen, top + one.clientTop, right - unseen, bottom - one.clientTop];
})"""
"""The handles, written distances and names that are seen, and the rectangles that they take."""


def keep_apart(laid: list[Any]) -> None:
    """Checks that no distance lies over another, a handle or a name, nor they over it."""
    distances = [words for words, *_ in laid if re.fullmatch(r"[\d.]+ m", words)]
    assert len(distances) >= 2 and len(laid) > len(distances)
    for i, (words, *a) in enumerate(laid):
        for other, *b in laid[:i]:
            meets = a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
            assert not (meets and (words in distances or other in distances)), f"{words} over {other}"


def test_no_handle_and_no_name_lies_over_a_distance(visit: Visit) -> None:
    Bench(visit, den(crate(ONE, 2, 1), crate(OTHER, 2, 2.1)))
    visit.page.keyboard.press("2")
    visit.line_of(ONE).click()
    visit.settle()
    keep_apart(visit.page.evaluate(LAID))
