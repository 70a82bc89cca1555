"""What is done to pieces by their numbers, one by one and several together, in the home of these acts."""

from __future__ import annotations

import json
import re

import pytest
from playwright.sync_api import ViewportSize, expect

from tests.browser.acts import Acts, bodies
from tests.browser.test_editing import crate, den
from tests.browser.visit import Document
from tests.browser.ways import Keyboard, Touch, Way, unfold

ONE, OTHER, SOFA, VASE = "den/one", "den/other", "den/sofa", "den/vase"
TABLET: ViewportSize = {"width": 1100, "height": 800}
ACTS = Acts()
doing = ACTS.act


def home() -> Document:
    """Two rooms with a passage between them; in the west one two crates, a vase on one of them, and a sofa of the catalog."""
    passage = {"kind": "passage", "wall": "east", "position": 2.5, "width": 1.4, "height": 2.1, "sill": 0, "connects_to": "yard"}
    sofa = {"id": SOFA, "name": "sofa", "kind": "sofa", "category": "seating", "width": 2.2, "depth": 0.9, "height": 0.85}
    vase = {"id": VASE, "name": "vase", "parent": ONE, "x": 1, "y": 0.5, "z": 1.5, "width": 0.2, "depth": 0.2, "height": 0.3}
    west = den(crate(ONE, 1, 1.5), crate(OTHER, 3.2, 3.2, 0.8), {**sofa, "x": 4.2, "z": 0.6}, width=6, depth=4)["rooms"][0]
    east = {"id": "yard", "type": "storage", "x": 6, "z": 0, "width": 4, "depth": 4, "furniture": []}
    back = {**passage, "wall": "west", "connects_to": "den"}
    return {"rooms": [{**west, "decorations": [vase], "openings": [passage]}, {**east, "openings": [back]}]}


def piece(way: Way, id_of: str) -> Document:
    """A piece or a decoration as the scene has it, and the room it is in."""
    for room in json.loads(way.scene())["rooms"]:
        for body in [*room["furniture"], *room["decorations"]]:
            if body["id"] == id_of:
                return {**body, "room": room["id"]}
    raise AssertionError(f"{id_of} is gone")


def ids(way: Way) -> set[str]:
    return {one["id"] for one in bodies(json.loads(way.scene()))}


@doing("4 a distance is read and typed")
def _distance(way: Way) -> None:
    way.choose(ONE)
    length = way.page.locator("#gaps [data-gap='west wall']")
    expect(length).to_have_text("0.50 m")
    way.press(length)
    field = way.page.locator("#gaps input")
    way.write(field, "wide")
    expect(field).to_have_attribute("aria-invalid", "true")
    way.changed(lambda: way.write(field, "45 cm"))
    assert piece(way, ONE)["x"] == pytest.approx(0.95)
    assert piece(way, VASE)["x"] == pytest.approx(0.95)
    way.press(way.page.locator("#gaps [data-gap='north wall']"))
    way.changed(lambda: way.write(field, "0,9"))
    assert piece(way, ONE)["z"] == pytest.approx(1.4)
    if not isinstance(way, Keyboard):
        way.press(way.page.locator(".ruler-words", has_text="0.90 m"))
        expect(field).to_be_focused()
        field.press("Escape")
        expect(field).to_have_count(0)


@doing("4 a piece is moved", always=True)
def move_piece(way: Way) -> None:
    way.choose(OTHER)
    if isinstance(way, Keyboard):
        way.changed(lambda: way.page.keyboard.press("ArrowLeft"))
        assert (piece(way, OTHER)["x"], piece(way, OTHER)["z"]) == pytest.approx((3.15, 3.2))
    else:
        way.changed(lambda: way.drag(way.at(OTHER), way.floor(2.2, 3.0)))
        assert piece(way, OTHER)["x"] == pytest.approx(2.2, abs=0.15)


@doing("4 a piece that is not chosen is dragged at once, by a finger that stays on it", keyboard="a piece is chosen before it is moved")
def _held(way: Way) -> None:
    way.changed(lambda: way.drag(way.at(OTHER), way.floor(2.2, 3.0), held=False))
    assert piece(way, OTHER)["x"] == pytest.approx(2.2, abs=0.15)


@doing(
    "4 what is dragged lines up",
    keyboard="arrows move by 5 cm and 1 cm; a distance is typed",
    touch="the same, tried below with a mouse: fingers have no Alt",
)
def _lined_up(way: Way) -> None:
    x, z = way.floor(1.02, 3.1)
    way.changed(lambda: way.drag(way.at(OTHER), (x, z)))
    assert piece(way, OTHER)["x"] == pytest.approx(1, abs=1e-6)
    way.changed(lambda: way.tool("undo"))
    way.page.keyboard.down("Alt")
    way.changed(lambda: way.drag(way.at(OTHER), (x, z)))
    way.page.keyboard.up("Alt")
    assert piece(way, OTHER)["x"] != pytest.approx(1, abs=1e-6)


@doing("4 a tape is laid")
def _tape(way: Way) -> None:
    way.tool("tape")
    if isinstance(way, Keyboard):
        for id_of in (ONE, OTHER):
            line = way.visit.line_of(id_of)
            line.focus()
            way.page.keyboard.press("Enter")
        wanted = ((2.2**2 + 1.7**2) ** 0.5, 0.01)
    else:
        tap = way.page.touchscreen.tap if isinstance(way, Touch) else way.page.mouse.click
        for spot in ((1.0, 3.2), (2.5, 3.2)):
            tap(*way.floor(*spot))
        wanted = (1.5, 0.12)
    said = way.page.locator("#tape")
    expect(said).to_contain_text(re.compile(r"west to east"))
    assert float((said.text_content() or "").split()[1]) == pytest.approx(wanted[0], abs=wanted[1])


@doing("4 a piece is turned")
def _turned(way: Way) -> None:
    way.choose(OTHER)
    if isinstance(way, Keyboard):
        way.changed(lambda: way.page.keyboard.press("q"))
    else:
        way.changed(lambda: way.drag(_grip(way, "turn"), way.floor(4.6, 3.2)))
    assert piece(way, OTHER)["rotation"] == 90
    way.changed(lambda: way.tool("right"))
    assert piece(way, OTHER)["rotation"] == 0


def _grip(way: Way, name: str) -> tuple[float, float]:
    box = way.page.locator(f".handle[data-grip={name}]").bounding_box()
    assert box
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def _unfolded(way: Way, id_of: str) -> None:
    """Chooses a piece, and unfolds its numbers."""
    way.choose(id_of)
    if way.page.locator("#piece").get_attribute("open") is None:
        way.press(way.page.locator("#piece > summary"))


@doing("4 a piece is made larger")
def _resized(way: Way) -> None:
    if isinstance(way, Keyboard):
        _unfolded(way, OTHER)
        way.changed(lambda: way.write(way.page.locator("#piece [name=width]"), "1.2 m"))
        assert piece(way, OTHER)["width"] == 1.2
    else:
        way.choose(OTHER)
        way.changed(lambda: way.drag(_grip(way, "width"), way.floor(4.2, 3.2)))
        resized = piece(way, OTHER)
        assert resized["width"] > 1.2
        assert resized["x"] - resized["width"] / 2 == pytest.approx(2.8, abs=1e-3), "the far edge stays"


@doing("4 size and angle are typed", always=True)
def _sized(way: Way) -> None:
    _unfolded(way, OTHER)
    way.changed(lambda: way.write(way.page.locator("#piece [name=depth]"), "70 cm"))
    assert piece(way, OTHER)["depth"] == 0.7
    way.changed(lambda: way.select(way.page.locator("#piece [name=angle]"), "180"))
    assert piece(way, OTHER)["rotation"] == 180


@doing("4 colour and kind are chosen")
def _painted(way: Way) -> None:
    _unfolded(way, SOFA)
    way.changed(lambda: way.press(way.page.locator(".swatches button").nth(2)))
    assert piece(way, SOFA)["color"] == "#a3785c"
    way.changed(lambda: way.page.get_by_label("Any colour").fill("#336699"))
    assert piece(way, SOFA)["color"] == "#336699"
    way.changed(lambda: way.select(way.page.locator("#piece [name=kind]"), "loveseat"))
    assert (piece(way, SOFA)["kind"], piece(way, SOFA)["width"]) == ("loveseat", 1.5)


@doing("4 a piece is duplicated beside itself")
def _duplicated(way: Way) -> None:
    way.choose(OTHER)
    way.changed(lambda: way.tool("duplicate"))
    assert len(ids(way)) == 4


@doing("4 a piece is copied and pasted into another room")
def _pasted(way: Way) -> None:
    before = ids(way)
    way.choose(ONE)
    way.tool("copy")
    way.let_go()
    unfold(way, "room")
    way.select(way.page.locator("#room_choice"), "yard")
    way.changed(lambda: way.tool("paste"))
    (new,) = ids(way) - before
    assert piece(way, new)["room"] == "yard"
    vases = [one for one in json.loads(way.scene())["rooms"][1]["decorations"] if one["parent"] == new]
    assert len(vases) == 1, "what lies on it comes along"
    way.select(way.page.locator("#room_choice"), "")


def _moved_together(way: Way) -> None:
    """Moves both crates, which are chosen."""
    way.press(way.page.locator("#piece > summary"))  # it lies over the pieces; folded, over one of them
    before = [piece(way, one)["z"] for one in (ONE, OTHER)]
    if isinstance(way, Keyboard):
        way.page.locator("#stage").focus()
        way.changed(lambda: way.page.keyboard.press("ArrowUp"))
    else:
        x, z = piece(way, OTHER)["x"], piece(way, OTHER)["z"]
        way.changed(lambda: way.drag(way.at(OTHER), way.floor(x, z - 0.6)))
    moved = [piece(way, one)["z"] - z for one, z in zip((ONE, OTHER), before, strict=True)]
    assert moved[0] < -0.04 and moved[0] == pytest.approx(moved[1], abs=1e-6)


@doing("4 several pieces are lined up, moved, and deleted together", always=True)
def _several(way: Way) -> None:
    way.choose(ONE)
    for wanted in ({ONE, OTHER}, {ONE}):
        way.add(OTHER)
        assert set(way.visit.state()["marks"]["selected"]) == wanted
    way.add(OTHER)
    assert set(way.visit.state()["marks"]["selected"]) == {ONE, OTHER}
    if way.page.locator("#piece").get_attribute("open") is None:
        way.press(way.page.locator("#piece > summary"))
    way.changed(lambda: way.press(way.page.locator("[data-align=west]")))
    edges = [piece(way, one)["x"] - piece(way, one)["width"] / 2 for one in (ONE, OTHER)]
    assert edges[0] == pytest.approx(edges[1], abs=1e-6)
    _moved_together(way)
    way.changed(lambda: way.tool("delete"))
    assert ids(way) == {SOFA}


@doing("4 a piece is dragged through a door into another room", keyboard="it is copied, pasted into the room, and deleted")
def _through_a_door(way: Way) -> None:
    way.choose(OTHER)
    way.changed(lambda: way.drag(way.at(OTHER), way.floor(8, 3.2)))
    assert piece(way, OTHER)["room"] == "yard"
    assert piece(way, OTHER)["x"] == pytest.approx(2, abs=0.15)


@doing("4 a decoration is moved and deleted")
def _decoration(way: Way) -> None:
    way.choose(VASE)
    if isinstance(way, Keyboard):
        way.changed(lambda: way.page.keyboard.press("ArrowRight"))
        assert (piece(way, VASE)["x"], piece(way, VASE)["parent"]) == (pytest.approx(1.05), ONE)
    else:
        way.changed(lambda: way.drag(way.at(VASE), way.floor(3.2, 3.2)))
        assert (piece(way, VASE)["parent"], piece(way, VASE)["y"]) == (OTHER, 0.5)
    way.changed(lambda: way.tool("delete"))
    assert json.loads(way.scene())["rooms"][0]["decorations"] == []


@doing("4 a piece is locked, and stays")
def _locked(way: Way) -> None:
    way.choose(OTHER)
    way.changed(lambda: way.tool("lock"))
    assert piece(way, OTHER)["locked"]
    way.tool("delete")
    expect(way.page.locator("#conflict")).to_contain_text("is locked: it stays where it is")
    assert piece(way, OTHER)["locked"]


@doing("1 a step is undone, and done again")
def _undone(way: Way) -> None:
    way.choose(OTHER)
    before = way.scene()
    after = way.changed(lambda: way.tool("left"))
    assert way.changed(lambda: way.tool("undo")) == before
    if isinstance(way, Keyboard):
        way.page.evaluate("document.activeElement?.blur()")
        assert way.changed(lambda: way.page.keyboard.press("Control+y")) == after
    else:
        assert way.changed(lambda: way.tool("redo")) == after
