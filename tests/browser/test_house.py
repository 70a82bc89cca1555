"""The page shows a house: in 3D, in words, in numbers; and asks nobody but its service."""

from __future__ import annotations

import pytest
from playwright.sync_api import Route, expect

from tests.browser.visit import SMALL, Visit, furniture_of, intercept, said

MAX_DRAW_CALLS = 400
PLAIN_PICTURE_BYTES = 20_000
"""A canvas of one colour compresses to less; a drawn house to several times as much."""


def picture(visit: Visit) -> bytes:
    return visit.page.locator("#stage > canvas").screenshot()


@pytest.mark.draws_all
def test_a_bare_address_shows_a_house_and_asks_nobody_else(visit: Visit) -> None:
    answer = visit.open()
    scene = answer["scene"]
    openings = {opening["id"]: opening["kind"] for room in scene["rooms"] for opening in room["openings"]}
    assert visit.count("rooms") == len(scene["rooms"]) > 5
    assert visit.count("furniture") == len(furniture_of(answer)) > 20
    assert visit.count("doors") == sum(kind != "window" for kind in openings.values())
    assert visit.count("windows") == sum(kind == "window" for kind in openings.values())
    assert visit.count("issues") == len(answer["issues"])
    assert len(picture(visit)) > PLAIN_PICTURE_BYTES
    visit.page.keyboard.press("r")
    visit.settle()
    visit.page.get_by_role("button", name="Top down").click()
    visit.settle()
    assert visit.console == []
    foreign = [url for url in visit.requests if not url.startswith((visit.address, "data:", "blob:"))]
    assert foreign == []
    assert len(visit.requests) > 4


def test_page_defaults_have_spine_and_outdoor_rooms(visit: Visit) -> None:
    scene = visit.open(SMALL.format(6))["scene"]
    assert scene["request"]["use_spine"] is True
    assert scene["request"]["outdoor"] is True
    assert any(room["outdoor"] for room in scene["rooms"])


def test_every_body_and_door_leaf_of_the_scene_is_drawn(visit: Visit) -> None:
    answer = visit.open(SMALL.format(7))
    rooms = answer["scene"]["rooms"]
    state = visit.state()
    bodies = [body["id"] for room in rooms for body in (*room["furniture"], *room["decorations"])]
    assert sorted(state["bodies"]) == sorted(bodies + [body["id"] for body in answer["scene"]["dynamic"]])
    leaves = {opening["id"] for room in rooms for opening in room["openings"] if opening["kind"] in ("door", "garage_door")}
    assert sorted(state["doors"]) == sorted(leaves)


def test_every_room_is_named(visit: Visit) -> None:
    rooms = visit.open()["scene"]["rooms"]
    visit.page.get_by_role("button", name="Top down").click()
    visit.settle()
    shown = visit.page.locator(".room-label .words").all_text_contents()
    assert sorted(shown) == sorted(said(room["type"]) for room in rooms)


def test_labels_do_not_cover_each_other(visit: Visit) -> None:
    visit.page.set_viewport_size({"width": 1600, "height": 900})
    visit.open("?width=30&depth=20")
    boxes = [label.bounding_box() for label in visit.page.locator(".room-label:not(.crowded-out)").all()]
    seen = [box for box in boxes if box]
    assert len(seen) > 10
    for index, one in enumerate(seen):
        for other in seen[index + 1 :]:
            apart_x = abs(one["x"] + one["width"] / 2 - other["x"] - other["width"] / 2) >= (one["width"] + other["width"]) / 2
            apart_y = abs(one["y"] - other["y"]) >= (one["height"] + other["height"]) / 2
            assert apart_x or apart_y


def test_the_readable_yaml_is_the_services_own(visit: Visit) -> None:
    with visit.page.expect_response(lambda response: response.url.endswith("/view")) as viewed:
        visit.open(SMALL.format(6))
    lines = viewed.value.json()["text"].rstrip("\n").split("\n")
    shown = visit.page.locator("#yaml > *").all_text_contents()
    assert [line.replace("\u00a0", "") for line in shown] == lines


def test_an_idle_page_draws_no_frames(visit: Visit) -> None:
    visit.open(SMALL.format(6))
    assert visit.state()["frames"] > 0
    assert visit.idle() == 0


def test_few_draw_calls_and_nothing_left_behind(visit: Visit) -> None:
    visit.open("?seed=1&width=30&depth=20")
    assert 0 < visit.state()["drawCalls"] <= MAX_DRAW_CALLS
    visit.open(SMALL.format(1))
    kept = visit.state()["geometries"]
    for seed in (2, 3, 1):
        visit.page.locator("#seed").fill(str(seed))
        visit.after(lambda: visit.page.keyboard.press("Enter"))
    assert visit.state()["geometries"] == kept


@pytest.mark.own_page
def test_names_from_a_scene_are_text(visit: Visit) -> None:
    trap = "<img src=x onerror=console.error('ran')>"

    def disguise(route: Route) -> None:
        answer = route.fetch().json()
        answer["scene"]["rooms"][0]["type"] = trap
        answer["issues"] = [{"rule": trap, "severity": "warning", "room": None, "ids": [], "amount": None, "message": trap}]
        route.fulfill(json=answer)

    intercept(visit.page, "**/generate", disguise)
    intercept(visit.page, "**/view", lambda route: route.fulfill(json={"text": f"- {trap}: 1\n", "lines": ["x"]}))
    visit.open(SMALL.format(6))
    assert visit.page.locator("main img, aside img:not(#starts *)").count() == 0
    assert trap in visit.yaml()
    assert visit.console == []


NO_WEBGL = """for (const canvas of [HTMLCanvasElement, OffscreenCanvas]) {
    const given = canvas.prototype.getContext;
    canvas.prototype.getContext = function (kind, ...how) { return kind.startsWith('webgl') ? null : given.call(this, kind, ...how); };
}"""


@pytest.mark.own_page
@pytest.mark.parametrize(("path", "said"), [("", "#notice"), ("embed#seed=3&width=12&depth=9", "#embed_said")])
def test_a_browser_that_draws_nothing_in_3d_is_told_what_is_missing(visit: Visit, path: str, said: str) -> None:
    visit.page.add_init_script(NO_WEBGL)
    visit.page.goto(visit.address + path)
    expect(visit.page.locator(said)).to_contain_text("WebGL 2 is missing or switched off")
    expect(visit.page.locator("#progress")).to_be_hidden()


@pytest.mark.own_page
def test_while_the_card_is_away_that_is_said(visit: Visit) -> None:
    """And no longer once it is back, and the house drawn again."""
    visit.open(SMALL.format(6))
    card = visit.page.evaluate_handle("document.querySelector('#stage > canvas').getContext('webgl2').getExtension('WEBGL_lose_context')")
    card.evaluate("card => card.loseContext()")
    expect(visit.page.get_by_role("alert")).to_contain_text("The graphics card was taken away")
    frames = visit.state()["frames"]
    card.evaluate("card => card.restoreContext()")
    expect(visit.page.get_by_role("alert")).to_be_hidden()
    visit.page.wait_for_function("frames => compose.state.frames > frames", arg=frames)
    visit.settle()
    assert visit.state()["drawCalls"] > 0
