"""A large decorated home costs the page little: draw calls, idle frames, bytes; script time within reason on a busy machine."""

from __future__ import annotations

from tests.browser.cost import HOME, LEAST, MAX_DRAW_CALLS, MAX_REBUILD_MS, MAX_SCRIPT_BYTES, measured
from tests.browser.visit import Visit

TIMES = 5
BUSY = 4
"""On a machine that does other work a rebuild takes up to this many times as long."""


def test_a_large_decorated_home_is_cheap(visit: Visit) -> None:
    cost = measured(visit, TIMES)
    assert cost.furniture >= LEAST
    assert cost.decorations >= LEAST
    assert 0 < cost.draw_calls <= MAX_DRAW_CALLS
    assert 0 < cost.shadow_calls <= MAX_DRAW_CALLS
    assert cost.idle_frames == 0
    assert 0 < cost.script_bytes <= MAX_SCRIPT_BYTES
    assert len(cost.rebuilds) == TIMES
    assert cost.median_ms <= BUSY * MAX_REBUILD_MS


COUNT_SHADERS = """
    window.shadersMade = 0;
    const { linkProgram } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.linkProgram = function (program) {
        window.shadersMade += 1;
        linkProgram.call(this, program);
    };
"""


def test_another_house_is_drawn_with_the_shaders_that_are_there(visit: Visit) -> None:
    visit.page.add_init_script(COUNT_SHADERS)
    visit.open(HOME)
    made = visit.page.evaluate("shadersMade")
    assert made > 0
    visit.page.evaluate("compose.measure(2)")
    visit.after(lambda: visit.page.locator("#random").click())
    assert visit.page.evaluate("shadersMade") == made
