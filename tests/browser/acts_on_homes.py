"""What is done with a whole home: it is sent, left and come back to, lit otherwise."""

from __future__ import annotations

import json
from typing import Any

from playwright.sync_api import Dialog, Locator, expect

from tests.browser.visit import Document
from tests.browser.ways import Way, unfold


def scene(way: Way) -> Any:
    """The scene shown, once all is at rest."""
    return json.loads(way.scene())


def movable(way: Way) -> Document:
    """A piece that can be seen, is no chair at a table, and lies on nothing."""
    for room in scene(way)["rooms"]:
        for piece in room["furniture"]:
            if not (piece["on"] or piece["under"]) and way.page.evaluate("id => compose.whereIs(id)", piece["id"]):
                return dict(piece)
    raise AssertionError("nothing is seen")


def offered_a_file(way: Way) -> None:
    """Saves the file that is offered in place of a link, with nothing changed but that it is offered."""
    offered = way.page.locator("#save_instead")
    offered.evaluate("one => { one.hidden = false; }")
    saves(way, offered)
    offered.evaluate("one => { one.hidden = true; }")


def saves(way: Way, button: Locator) -> None:
    """Presses what saves a file, which holds the home shown."""
    with way.page.expect_download() as saved:
        way.press(button)
    with open(saved.value.path(), encoding="utf-8") as file:
        assert json.load(file) == scene(way)


def left_and_come_back_to(way: Way) -> None:
    """Leaves the page with a change: it is kept, so nothing is asked."""
    asked: list[str] = []

    def heard(dialog: Dialog) -> None:
        asked.append(dialog.type)
        dialog.accept()

    def away() -> None:
        way.page.goto("about:blank")
        way.page.go_back()

    way.page.on("dialog", heard)
    way.choose(movable(way)["id"])
    edited = way.changed(lambda: way.tool("delete"))
    way.visit.reopened(away)
    assert (way.scene(), asked) == (edited, [])
    way.page.remove_listener("dialog", heard)
    way.page.keyboard.press(way.seen)


def lit_at_another_hour(way: Way) -> None:
    """Moves the hour to the evening: the sun stands lower, in the west, and does so after a reload."""
    sun: Any = "compose.state.sun"
    unfold(way, "view")
    hour, words = way.page.locator("#hour"), way.page.locator("#hour_words")
    noon = way.page.evaluate(sun)
    way.to_end(hour)
    expect(words).to_have_text("19:00")
    evening = way.page.evaluate(sun)
    assert 0 < evening[1] < 0.5 * noon[1]
    assert evening[0] < noon[0]
    way.visit.reopened(way.page.reload)
    assert way.page.evaluate(sun) == evening
    expect(words).to_have_text("19:00")
    unfold(way, "view")
    hour.fill("15")
    assert way.page.evaluate(sun) == noon
    way.page.keyboard.press(way.seen)
