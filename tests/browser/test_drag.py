"""A drag in the page: frames are answered by the core in its worker, the service is asked when the piece is let go."""

from __future__ import annotations

import pytest

from tests.browser.test_editing import ONE, OTHER, Bench, crate, den, drawn, poses
from tests.browser.visit import ANSWER_MS, POLL_MS, Visit, intercept

ANSWERED = "performance.getEntriesByName('frame answered').length"


def take(bench: Bench, label: str) -> tuple[int, int]:
    """Takes a piece in hand and waits until the worker answers its frames; returns where it was on the screen."""
    x, z = bench.at(label)
    bench.page.mouse.move(x, z)
    bench.page.mouse.down()
    for k in range(ANSWER_MS // POLL_MS):
        bench.page.mouse.move(x + 20 * (k % 2) + 10, z)
        if bench.page.evaluate(ANSWERED):
            return x, z
        bench.page.wait_for_timeout(POLL_MS)
    raise AssertionError("the worker never answered")


def given_way(bench: Bench, wanted: str) -> None:
    """Waits until the other piece is drawn where it is wanted, nobody having let go."""
    bench.page.wait_for_function(f"id => {{ const [x, z] = compose.places[id]; return {wanted}; }}", arg=OTHER)


def test_frames_are_answered_without_the_network(moving: Visit) -> None:
    bench = Bench(moving, den(crate(ONE, 1, 1), crate(OTHER, 2.8, 1.8)))
    prepared: list[str] = []
    bench.page.on("request", lambda request: prepared.append(request.url) if request.url.endswith("/drag") else None)
    to = bench.at(OTHER)
    take(bench, ONE)
    asked = bench.fixes
    bench.page.mouse.move(*to, steps=10)
    given_way(bench, "Math.max(Math.abs(x - 2.8), Math.abs(z - 1.8)) > 0.1")
    assert poses(bench.scene()) == poses(bench.before), "nothing is settled yet"
    assert (bench.fixes, len(prepared)) == (asked, 1)
    bench.page.mouse.up()
    bench.rest()
    assert bench.fixes == asked + 1
    assert poses(bench.scene()) == poses(bench.last_answer()["scene"]) == drawn(bench)
    assert bench.errors() == []


@pytest.mark.own_page
def test_where_the_core_cannot_be_had_the_service_answers_frames(moving: Visit) -> None:
    intercept(moving.page, "**/core.wasm", lambda route: route.fulfill(status=404))
    bench = Bench(moving, den(crate(ONE, 1, 1), crate(OTHER, 2.8, 1.8)))
    bench.drag(ONE, bench.at(OTHER), steps=25)
    bench.page.mouse.up()
    bench.rest()
    assert bench.fixes >= 2
    assert bench.page.evaluate(ANSWERED) == 0
    assert poses(bench.scene()) == poses(bench.last_answer()["scene"]) == drawn(bench)
    assert bench.errors() == []
    moving.console.clear()  # the browser says that the file is not there


def test_neighbours_go_on_giving_way_while_the_pointer_rests(moving: Visit) -> None:
    bench = Bench(moving, den(crate(ONE, 0.6, 1.5, 1.0), crate(OTHER, 1.9, 1.5, 1.0), width=6))
    x, z = bench.at(OTHER)
    take(bench, ONE)
    bench.page.mouse.move(x - 30, z)  # at once: farther than a neighbour goes in one frame
    given_way(bench, "x > 1.9 + 0.2")
    bench.page.keyboard.press("Escape")
    bench.page.mouse.up()
    bench.rest()
    assert poses(bench.scene()) == poses(bench.before) == drawn(bench)
