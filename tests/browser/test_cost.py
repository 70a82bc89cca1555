"""A large decorated home costs the page little: draw calls, idle frames, bytes, shaders made once; script time on its own processor."""

from __future__ import annotations

import pytest

from tests.browser.cost import (
    FOLLOWED,
    HOME,
    LEAST,
    MAX_DRAW_CALLS,
    MAX_DRAW_CALLS_EDITING,
    MAX_SCRIPT_BYTES,
    cpu,
    measured,
    script_bytes,
    traced,
)
from tests.browser.visit import Visit

pytestmark = pytest.mark.own_page

TIMES = 5
MOVES = 8
MOST_SHADERS = 8
"""One a kind of surface: each costs a first picture."""
READINGS = 50
"""A rebuild takes the processor at most as long as reading the scene's JSON so often."""

READ = """() => {
    const text = JSON.stringify(compose.scene);
    for (let time = 0; time < 15; time += 1) {
        performance.mark('scene read: start');
        for (let i = 0; i < 10; i += 1) JSON.parse(text);
        performance.mark('scene read: end');
    }
}"""
"""Reads the scene's JSON fifteen times ten times, each ten marked for the browser's performance tools."""

COUNT_SHADERS = """
    window.shadersMade = 0;
    const { linkProgram } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.linkProgram = function (program) {
        window.shadersMade += 1;
        linkProgram.call(this, program);
    };
"""


def test_a_large_decorated_home_is_cheap(visit: Visit) -> None:
    visit.open(HOME)
    before = visit.state()
    cost = measured(visit, TIMES)
    assert cost.furniture >= LEAST
    assert cost.decorations >= LEAST
    assert 0 < cost.draw_calls <= MAX_DRAW_CALLS
    assert 0 < cost.shadow_calls <= MAX_DRAW_CALLS
    assert cost.idle_frames == 0
    assert len(cost.rebuilds) == TIMES
    assert visit.state()["geometries"] == before["geometries"]
    with traced(visit.page) as trace:
        visit.page.evaluate(READ)
    assert 0 < cpu(cost.rebuilds).median <= READINGS * cpu(trace.steps["scene read"]).median / 10


def test_a_drag_in_a_dense_room_is_cheap(visit: Visit) -> None:
    """Following the pointer, with distances and guides, takes the processor less than reading the scene's JSON ten times."""
    scene = visit.open(HOME)["scene"]
    page = visit.page
    page.keyboard.press("2")
    visit.settle()
    dense = max(scene["rooms"], key=lambda room: len(room["furniture"]) / (room["width"] * room["depth"]))
    seen = [piece["id"] for piece in dense["furniture"] if not piece["on"] and page.evaluate("id => compose.whereIs(id)", piece["id"])]
    at = page.evaluate("id => compose.whereIs(id)", seen[0])
    with traced(page) as trace:
        page.mouse.move(at["x"], at["y"])
        page.mouse.down()
        for step in range(1, MOVES + 1):
            page.mouse.move(at["x"] + step % 20, at["y"] + step % 11)
        page.evaluate(READ)
    cost = page.evaluate("compose.measure(0)")
    page.keyboard.press("Escape")
    page.mouse.up()
    frames = trace.steps[FOLLOWED]
    assert len(frames) > MOVES // 2
    assert 0 < cpu(frames).median <= cpu(trace.steps["scene read"]).median
    assert cost["drawCalls"] <= MAX_DRAW_CALLS_EDITING


def test_the_script_is_small() -> None:
    assert 0 < script_bytes() <= MAX_SCRIPT_BYTES


def test_another_house_is_drawn_with_the_shaders_that_are_there(visit: Visit) -> None:
    visit.page.add_init_script(COUNT_SHADERS)
    visit.open(HOME)
    made = visit.page.evaluate("shadersMade")
    assert 0 < made <= MOST_SHADERS
    visit.page.evaluate("compose.measure(2)")
    visit.after(lambda: visit.page.locator("#random").click())
    assert visit.page.evaluate("shadersMade") == made
