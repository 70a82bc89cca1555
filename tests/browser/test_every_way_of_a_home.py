"""Every way to ask for a home, to look at it, to walk through it, to keep it; by pointer, keys alone, fingers. One opened page a way."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import expect

from tests.browser.acts import Act, Acts, left_as_found
from tests.browser.acts_on_homes import left_and_come_back_to, lit_at_another_hour, movable, offered_a_file, scene
from tests.browser.test_looking import entrance_of
from tests.browser.test_touch import PRESSED, SMALLEST
from tests.browser.test_walking import KNOWN
from tests.browser.visit import SMALL
from tests.browser.ways import Keyboard, Touch, Way, unfold

ON_MAP = "([x, z]) => new DOMPoint(x, z).matrixTransform(document.querySelector('#minimap svg').getScreenCTM()).toJSON()"
MET = """id => {
    const at = compose.whereIs(id);
    return at && document.elementFromPoint(at.x, at.y)?.tagName === 'CANVAS' ? at : null;
}"""
ACTS = Acts()
doing = ACTS.act


def begin(way: Way) -> None:
    """A small home is opened."""
    way.visit.open(SMALL.format(4))
    way.seen = "3"


@doing("1 another home comes and goes as a step; it is among the recent homes")
def _another_home(way: Way) -> None:
    before = way.scene()
    unfold(way, "recent")
    homes = way.page.locator("#recent_list .recent-home")
    expect(homes.first).to_be_visible()
    number = homes.count()
    other = way.changed(lambda: way.press(way.page.locator("#random")))
    expect(homes).to_have_count(number + 1)
    assert way.changed(lambda: way.press(homes.nth(1))) == before
    assert way.changed(way.page.go_back) == other
    assert way.changed(lambda: way.press(way.page.locator("#tools [data-tool=undo]"))) == before
    way.press(way.page.locator("#recent_clear"))
    way.press(way.page.locator("#recent_clear"))
    expect(homes).to_have_count(1)


@doing("1 style and decorations change in place")
def _restyled(way: Way) -> None:
    unfold(way, "furnishing")
    standing = "JSON.stringify(compose.scene.rooms.map(room => room.furniture.map(one => [one.id, one.x, one.z, one.rotation])))"
    before = way.page.evaluate(standing)
    way.changed(lambda: way.select(way.page.locator("#style"), "rustic"))
    way.changed(lambda: way.switch(way.page.locator("[name=decorate]")))
    assert way.page.evaluate(standing) == before
    assert way.visit.count("decorations") > 0


@doing("1 the link is copied")
def _linked(way: Way) -> None:
    way.press(way.page.locator("#copy_link"))
    expect(way.page.locator("#said")).to_contain_text("Link copied")
    assert "seed=4" in way.page.evaluate("navigator.clipboard.readText()")


@doing("2 what fell short is read, and its room chosen")
def _short(way: Way) -> None:
    way.press(way.page.locator("#shortfall_line"))
    first = way.page.locator("#shortfall_list .shortfall").first
    way.press(first)
    assert way.page.locator("#room_choice").input_value() != ""
    why = way.page.locator("#shortfall_list details summary").first
    way.press(why)
    expect(way.page.locator("#shortfall_list details p").first).to_be_visible()
    unfold(way, "room")
    way.select(way.page.locator("#room_choice"), "")


@doing("2 a wrong field is named")
def _wrong(way: Way) -> None:
    unfold(way, "home")
    way.page.locator("#width").fill("5000")
    way.press(way.page.locator("#generate"))
    expect(way.page.locator("#width_problem")).to_contain_text("1000")
    expect(way.page.get_by_role("alert")).to_contain_text("Width: enter a number")
    way.page.locator("#width").fill("12")
    way.press(way.page.locator(".notice-close"))
    expect(way.page.get_by_role("alert")).to_be_hidden()
    way.visit.console[:] = [said for said in way.visit.console if "422" not in said]  # the browser's own word for a refusal


@doing("5 a room is taken in another arrangement")
def _otherwise(way: Way) -> None:
    unfold(way, "room")
    room = next(one["id"] for one in scene(way)["rooms"] if one["type"] in ("bedroom_master", "bedroom"))
    way.select(way.page.locator("#room_choice"), room)
    way.press(way.page.locator("#others_now"))
    choices = way.page.locator("#others .others-row button")
    expect(choices).to_have_count(3)
    way.changed(lambda: way.press(choices.nth(1)))
    way.changed(lambda: way.press(way.page.locator("#reroll")))
    unfold(way, "room")
    way.select(way.page.locator("#room_choice"), "")


@doing("6 why a piece stands here is asked, what holds it is gone to, another way to stand is taken")
def _why(way: Way) -> None:
    for piece in [one["id"] for room in scene(way)["rooms"] for one in room["furniture"]]:
        if not way.page.evaluate("id => compose.whereIs(id)", piece):
            continue
        way.choose(piece)
        way.tool("why")
        expect(way.page.locator("#why strong").first).to_be_visible()
        if way.page.locator("#why ul:not(.ways) button").count() and way.page.locator("#why .ways button").count():
            break
        way.let_go()
    way.press(way.page.locator("#why ul:not(.ways) button").first)
    assert way.visit.state()["selected"] not in (None, piece)
    way.let_go()
    way.choose(piece)
    way.tool("why")
    take = way.page.locator("#why .ways button").first
    expect(take).to_be_visible()
    way.changed(lambda: way.press(take))


@doing("7 a home is asked for in words, and begun with a picture")
def _asked(way: Way) -> None:
    way.changed(lambda: way.write(way.page.locator("#asked"), "1 bedroom, 1 bath, 50 m²"))
    assert scene(way)["request"]["area"] == 50
    way.changed(lambda: way.press(way.page.locator("#starts a").first))
    assert scene(way)["request"]["program"] == "studio"


@doing("7 the view is switched", always=True)
def _views(way: Way) -> None:
    for name in ("plan", "top", "corner"):
        way.view(name)
        expect(way.page.locator(f"#camera_{name}")).to_have_attribute("aria-pressed", "true")


@doing("7 controls and text are folded")
def _folded(way: Way) -> None:
    if isinstance(way, Touch):  # on a phone they stand beneath the house
        for shown in ("false", "true"):
            way.press(way.page.locator("#reading_toggle"))
            expect(way.page.locator("#reading_toggle")).to_have_attribute("aria-expanded", shown)
        return
    for panel in ("controls", "reading"):
        for is_shown in (False, True):
            way.press(way.page.locator(f"#fold_{panel}"))
            expect(way.page.locator(f"#{panel}")).to_be_visible(visible=is_shown)


@doing("7 the page is light or dark")
def _colours(way: Way) -> None:
    unfold(way, "view")
    grounds = []
    for name in ("light", "dark", ""):
        way.select(way.page.locator("#colours"), name)
        grounds.append(way.page.evaluate("getComputedStyle(document.documentElement).backgroundColor"))
    assert grounds[0] != grounds[1]


@doing("7 the tour is taken, back and forth, and left")
def _tour(way: Way) -> None:
    way.press(way.page.locator("#tour_again"))
    heading, buttons = way.page.locator("#tour").get_by_role("heading"), way.page.locator("#tour button:visible")
    for at, step in ((-1, 2), (1, 1), (-1, 2)):
        way.press(buttons.nth(at) if at > 0 else buttons.last)
        expect(heading).to_contain_text(f"{step}/4")
    way.press(buttons.first)
    expect(way.page.locator("#tour")).to_be_hidden()


@doing("8 pieces and decorations are named", always=True)
def _named(way: Way) -> None:
    unfold(way, "view")
    few = way.page.locator(".labels > *:visible").count()
    way.switch(way.page.locator("#all_labels"))
    way.page.wait_for_function(
        "few => [...document.querySelectorAll('.labels > *')].filter(one => one.checkVisibility()).length > few", arg=few
    )
    way.switch(way.page.locator("#decoration_labels"))
    for name in ("all_labels", "decoration_labels"):
        expect(way.page.locator(f"#{name}")).to_be_checked()
        way.switch(way.page.locator(f"#{name}"))


@doing("8 the free floor is shown")
def _floor(way: Way) -> None:
    unfold(way, "view")
    way.switch(way.page.locator("#show_floor"))
    way.page.wait_for_function("() => compose.state.floorZones > 0")
    way.switch(way.page.locator("#show_floor"))
    way.page.wait_for_function("() => compose.state.floorZones === 0")


@doing("8 a picture of the view is saved, from the menu")
def _picture(way: Way) -> None:
    way.tool("menu")
    expect(way.page.locator("#menu")).to_be_visible()
    with way.page.expect_download() as saved:
        way.press(way.page.locator("#menu").get_by_role("button", name="Picture of the view"))
    with open(saved.value.path(), "rb") as file:
        assert file.read(4) == b"\x89PNG"


@doing("8 the fronts of a piece open")
def _fronts(way: Way) -> None:
    certified = scene(way)["certificate"]["rooms"]
    having = [piece for room in certified.values() for piece, fronts in room["fronts"].items() if fronts]
    for piece in having:
        if not way.page.evaluate("id => compose.whereIs(id)", piece):
            continue
        way.choose(piece)
        met = _met(way, [f"{piece}/{front}" for room in certified.values() for front in room["fronts"].get(piece, {})])
        if isinstance(way, Keyboard) or met:
            break
        way.let_go()
    if isinstance(way, Keyboard):
        way.page.keyboard.press("t")
    else:
        assert met, "a length lies over every front, as each is chosen"
        _tap(way, met["x"], met["y"])
    way.page.wait_for_function("() => compose.state.openFronts.length > 0")
    way.visit.settle()
    way.page.keyboard.press("t")
    way.page.wait_for_function("() => compose.state.openFronts.length === 0")


def _met(way: Way, fronts: list[str]) -> Any:
    """Where the first of the fronts is seen over which no length of the chosen piece lies, which would be pressed in its place."""
    return next((at for front in fronts if (at := way.page.evaluate(MET, front))), None)


def _tap(way: Way, x: float, y: float) -> None:
    (way.page.touchscreen.tap if isinstance(way, Touch) else way.page.mouse.click)(x, y)


@doing("8 the house is turned, come nearer to, and looked aside of", always=True)
def _turned(way: Way) -> None:
    def looks() -> Any:
        way.visit.settle()
        return [way.visit.state()["eye"], way.visit.state()["target"]]

    box = way.page.locator("#stage > canvas").bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + 8  # beside the house
    before = looks()
    if isinstance(way, Keyboard):
        way.page.locator("#stage").focus()
        way.page.keyboard.press("ArrowRight")
    else:
        way.drag((x, y), (x + 60, y))
    turned = looks()
    assert turned[0] != before[0] and turned[1] == pytest.approx(before[1], abs=0.01)
    if isinstance(way, Keyboard):
        way.page.keyboard.press("+")
    elif isinstance(way, Touch):
        way.fingers("touchStart", [(x - 20, y), (x + 20, y)])
        for step in range(1, 5):
            way.fingers("touchMove", [(x - 20 - 10 * step, y), (x + 20 + 10 * step, y)])
        way.lift((x - 60, y), (x + 60, y))
    else:
        way.page.mouse.wheel(0, -240)
    way.page.wait_for_function("before => compose.state.eye[1] < before - 0.1", arg=turned[0][1])
    way.view("top")
    way.view("corner")


@doing("9 one walks, turns, opens a door, goes where the map is clicked, and leaves")
def _walked(way: Way) -> None:
    start = entrance_of({"scene": scene(way)})
    way.view("walk")
    way.page.wait_for_function(KNOWN)
    way.visit.settle()
    box = way.page.locator("#stage > canvas").bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    before = way.visit.state()
    if isinstance(way, Keyboard):
        way.visit.held("w")
        way.visit.held("ArrowLeft")
    else:
        _on_map(way, start["x"] + start["width"] / 2, start["z"] + start["depth"] / 2)
        way.visit.settle()
        way.drag((x, y), (x + 90, y), held=True)
    after = way.visit.state()
    assert after["eye"] != before["eye"]
    assert [a - b for a, b in zip(after["target"], after["eye"], strict=True)] != pytest.approx(
        [a - b for a, b in zip(before["target"], before["eye"], strict=True)], abs=0.01
    )
    way.press(way.page.locator("#walk_leave"))
    assert not way.visit.state()["walking"]


def _on_map(way: Way, x: float, z: float) -> None:
    at = way.page.evaluate(
        ON_MAP,
        [x, z],
    )
    _tap(way, at["x"], at["y"])


@doing("9 a door opens and shuts")
def _door(way: Way) -> None:
    doors = way.visit.state()["doors"]
    for count in (1, 0):
        if isinstance(way, Keyboard):
            way.page.locator("#stage").focus()
            way.page.keyboard.press("t")
        else:
            seen = next(at for door in doors if (at := way.page.evaluate("id => compose.whereIs(id)", door)))
            _tap(way, seen["x"], seen["y"])
        way.page.wait_for_function("count => compose.state.openDoors.length === count", arg=count)
        way.visit.settle()


@doing("9 what fingers press is large enough", pointer="a pointer is fine", keyboard="keys need no size")
def _large(way: Way) -> None:
    way.choose(movable(way)["id"])
    way.tool("menu")
    assert way.page.evaluate(PRESSED, SMALLEST) == []


doing("1 the page is left with a change, asks nothing, and comes back with it")(left_and_come_back_to)
doing("8 a home is lit as at another time of day, which is kept", always=True)(lit_at_another_hour)
doing("1 the file that is offered in place of a link, where changes are too many, holds the home")(offered_a_file)


@ACTS.by_every_way()
def test_is_done_and_undone(way: Way, act: Act) -> None:
    left_as_found(way, act)
