"""Numbers while editing: distances that are typed, snapping, a tape, handles, copies, several pieces at once, other rooms, decorations."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.browser.test_editing import ONE, OTHER, Bench, crate, den, drawn, poses
from tests.browser.test_gaps import told
from tests.browser.visit import Document, Visit

WHERE = "([x, z]) => compose.whereAt(x, z)"


def window_at(bench: Bench, x: float, z: float) -> tuple[float, float]:
    """Where in the window a place of the floor is seen, m."""
    at = bench.page.evaluate(WHERE, [x, z])
    return at["x"], at["y"]


def drag_to(bench: Bench, label: str, x: float, z: float) -> None:
    """Drags a piece by its middle until that is near a place of the house, and holds it."""
    bench.drag(label, (round(window_at(bench, x, z)[0]), round(window_at(bench, x, z)[1])))


def let_go(bench: Bench) -> None:
    bench.page.mouse.up()
    bench.rest()


def mm(metres: float) -> int:
    return round(metres * 1000)


def two_rooms() -> Document:
    """Two rooms with a passage between them, a crate in the west one."""
    passage = {"kind": "passage", "wall": "east", "position": 1.5, "width": 1.4, "height": 2.1, "sill": 0, "connects_to": "yard"}
    west = {**den(crate(ONE, 1, 1.5))["rooms"][0], "openings": [passage]}
    back = {**passage, "wall": "west", "connects_to": "den"}
    return {"rooms": [west, {"id": "yard", "type": "storage", "x": 4, "z": 0, "width": 4, "depth": 3, "furniture": [], "openings": [back]}]}


def test_while_it_is_dragged_distances_are_those_of_where_it_is_drawn(moving: Visit) -> None:
    bench = Bench(moving, den(crate(ONE, 1, 1), crate(OTHER, 3, 1), width=6, depth=4))
    for x, z in ((1.3, 2.2), (2.0, 2.9), (4.4, 2.6)):
        drag_to(bench, ONE, x, z)
        across, along, _ = bench.page.evaluate("id => compose.places[id]", ONE)
        walls = {"north": along - 0.5, "east": 6 - across - 0.5, "south": 4 - along - 0.5, "west": across - 0.5}
        said = told(moving)
        assert {side: said[side].split(" m")[0] for side in walls} == {
            side: f"{mm(gap) / 1000:.2f}" if mm(gap) % 10 == 0 else f"{mm(gap) / 1000:.3f}" for side, gap in walls.items()
        }
        let_go(bench)


def test_a_dragged_piece_lines_up_and_alt_frees_it(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1), crate(OTHER, 4, 1), width=8, depth=5))
    drag_to(bench, ONE, 3.98, 3.43)
    expect(bench.page.locator(".ruler-guide")).not_to_have_count(0)
    let_go(bench)
    x, z, _ = poses(bench.scene())[ONE]
    assert (x, mm(z) % 50) == (4, 0)
    expect(bench.page.locator(".ruler-guide")).to_have_count(0)
    bench.page.keyboard.down("Alt")
    drag_to(bench, ONE, 4.02, 3.9)
    expect(bench.page.locator(".ruler-guide")).to_have_count(0)
    let_go(bench)
    bench.page.keyboard.up("Alt")
    x, z, _ = poses(bench.scene())[ONE]
    assert x != 4
    assert x == pytest.approx(4.02, abs=0.03)


def test_a_piece_is_dragged_through_a_passage_into_another_room_and_back(moving: Visit) -> None:
    bench = Bench(moving, two_rooms())
    assert bench.errors() == []
    drag_to(bench, ONE, 6, 1.5)
    let_go(bench)
    rooms = bench.scene()["rooms"]
    assert [[piece["id"] for piece in room["furniture"]] for room in rooms] == [[], [ONE]]
    assert rooms[1]["furniture"][0]["x"] == pytest.approx(2, abs=0.1)
    assert bench.errors() == []
    there = bench.page.evaluate("compose.places")
    assert there[ONE][0] == pytest.approx(4 + rooms[1]["furniture"][0]["x"], abs=1e-6)
    bench.press("Control+z")
    assert bench.scene() == bench.before
    assert poses(bench.before) == drawn(bench)
    drag_to(bench, ONE, 6, 1.5)
    bench.page.keyboard.press("Escape")
    let_go(bench)
    assert bench.scene() == bench.before
    assert poses(bench.before) == drawn(bench)
