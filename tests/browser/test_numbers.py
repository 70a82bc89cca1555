"""Numbers while editing: distances that are typed, snapping, a tape, handles, copies, several pieces at once, other rooms, decorations."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.browser.test_accessible import violations
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


def test_a_distance_is_typed_with_a_unit_and_words_that_are_none_are_refused(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1), crate(OTHER, 3, 2)))
    bench.choose(ONE)
    west = bench.page.get_by_role("button", name="0.50 m west to the wall: type another length")
    west.click()
    field = bench.page.locator("#gaps input")
    expect(field).to_be_focused()
    field.fill("wide")
    field.press("Enter")
    expect(field).to_have_attribute("aria-invalid", "true")
    assert violations(visit) == []
    field.fill("45 cm")
    field.press("Enter")
    bench.rest()
    assert poses(bench.scene())[ONE] == (0.95, 1, 0)
    assert told(visit)["west"] == "0.45 m to the wall"
    bench.page.locator("#gaps [data-gap='north wall']").press("Enter")
    field.fill("0,6")
    field.press("Enter")
    bench.rest()
    assert poses(bench.scene())[ONE] == (0.95, 1.1, 0)
    bench.page.locator(".ruler-words", has_text="0.45 m").click()
    expect(field).to_be_focused()
    field.press("Escape")
    expect(field).to_have_count(0)
    bench.press("Control+z", "Control+z")
    assert bench.scene() == bench.before
    assert visit.console == []


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


def test_a_tape_measures_by_pointer_and_between_pieces_by_keys(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1), crate(OTHER, 3, 2)))
    said = bench.page.locator("#tape")
    bench.press("m")
    expect(bench.page.get_by_role("button", name="Tape measure")).to_have_attribute("aria-pressed", "true")
    bench.page.mouse.click(*window_at(bench, 0.5, 2.5))
    bench.page.mouse.click(*window_at(bench, 2.0, 2.5))
    length = float((said.text_content() or "").split()[1])
    assert length == pytest.approx(1.5, abs=0.05)
    assert visit.state()["selected"] is None
    for piece in (ONE, OTHER):
        visit.line_of(piece).press("Enter")
    expect(said).to_contain_text("2.00 m west to east, 1.00 m north to south")
    assert violations(visit) == []
    bench.press("Escape")
    expect(said).to_be_hidden()
    assert visit.console == []


def test_handles_turn_and_resize_and_so_do_the_fields(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 2, 1.5)))
    bench.choose(ONE)
    page = bench.page
    turn = page.locator(".handle[data-grip=turn]")
    turn.hover()
    page.mouse.down()
    page.mouse.move(*window_at(bench, 3.4, 1.5), steps=6)
    let_go(bench)
    assert poses(bench.scene())[ONE] == (2, 1.5, 90)
    page.locator("#piece summary").click()
    page.locator("#piece [name=angle]").select_option("0")
    bench.rest()
    page.locator(".handle[data-grip=width]").hover()
    page.mouse.down()
    page.mouse.move(*window_at(bench, 3.0, 1.5), steps=6)
    let_go(bench)
    piece = bench.scene()["rooms"][0]["furniture"][0]
    assert piece["width"] > 1.2
    assert piece["x"] - piece["width"] / 2 == pytest.approx(1.5, abs=0.001), "the far edge stays"
    page.locator("#piece [name=width]").fill("80 cm")
    page.locator("#piece [name=width]").press("Enter")
    bench.rest()
    assert bench.scene()["rooms"][0]["furniture"][0]["width"] == 0.8
    page.get_by_label("Any colour").fill("#336699")
    bench.rest()
    assert bench.scene()["rooms"][0]["furniture"][0]["color"] == "#336699"
    assert violations(visit) == []
    bench.press(*["Control+z"] * 5)
    assert bench.scene() == bench.before
    assert bench.errors() == []


def test_copies_and_several_at_once(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 0.6, 0.6, 0.5), crate(OTHER, 3, 2, 0.5), width=6, depth=4))
    bench.choose(ONE)
    bench.press("Control+d")
    copy = next(id_of for id_of in poses(bench.scene()) if id_of not in (ONE, OTHER))
    assert visit.state()["selected"] == copy
    assert poses(bench.scene())[ONE] == poses(bench.before)[ONE]
    bench.press("Control+c", "Control+v")
    assert len(poses(bench.scene())) == 4
    bench.choose(ONE)
    visit.line_of(OTHER).click(modifiers=["Shift"])
    assert set(visit.state()["marks"]["selected"]) == {ONE, OTHER}
    before = poses(bench.scene())
    bench.press("ArrowDown")
    after = poses(bench.scene())
    assert {id_of: after[id_of][1] - z for id_of, (_, z, _) in before.items()} == {
        id_of: pytest.approx(0.05 if id_of in (ONE, OTHER) else 0, abs=1e-6) for id_of in before
    }
    bench.page.locator("#piece summary").click()
    bench.page.get_by_role("button", name="West edges").click()
    bench.rest()
    aligned = poses(bench.scene())
    assert aligned[ONE][0] == aligned[OTHER][0] == after[ONE][0]
    assert violations(visit) == []
    bench.page.locator("#piece summary").click()  # it lies over the pieces; folded, over one of them
    drag_to(bench, OTHER, 2.6, 2.2)
    let_go(bench)
    dragged = poses(bench.scene())
    moved = [dragged[id_of][0] - aligned[id_of][0] for id_of in (ONE, OTHER)]
    assert moved[0] > 1
    assert moved[0] == pytest.approx(moved[1], abs=1e-6)
    bench.press("Delete")
    assert not {ONE, OTHER} & set(poses(bench.scene()))
    bench.press(*["Control+z"] * 6)
    assert bench.scene() == bench.before
    assert visit.console == []


def test_a_click_with_shift_on_the_canvas_adds_and_takes_out(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1), crate(OTHER, 3, 2)))
    bench.page.mouse.click(*bench.at(ONE))
    for wanted in ({ONE, OTHER}, {ONE}):
        bench.page.keyboard.down("Shift")
        bench.page.mouse.click(*bench.at(OTHER))
        bench.page.keyboard.up("Shift")
        assert set(visit.state()["marks"]["selected"]) == wanted


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


def test_a_chosen_decoration_is_dragged_nudged_and_deleted(visit: Visit) -> None:
    vase = {"id": "den/vase", "name": "vase", "parent": ONE, "x": 1, "y": 0.5, "z": 1, "width": 0.2, "depth": 0.2, "height": 0.3}
    house = den(crate(ONE, 1, 1), crate(OTHER, 3, 2))
    house["rooms"][0]["decorations"] = [vase]
    bench = Bench(visit, house)

    def thing() -> Document:
        found: Document = bench.scene()["rooms"][0]["decorations"][0]
        return found

    bench.choose("den/vase")
    bench.press("ArrowRight")
    assert (thing()["x"], thing()["parent"]) == (pytest.approx(1.05), ONE)
    drag_to(bench, "den/vase", 3, 2)
    let_go(bench)
    assert (thing()["parent"], thing()["y"]) == (OTHER, 0.5)
    assert poses(bench.scene()) == poses(bench.before)
    bench.press("Delete")
    assert bench.scene()["rooms"][0]["decorations"] == []
    bench.press(*["Control+z"] * 3)
    assert bench.scene() == bench.before
    assert visit.console == []
