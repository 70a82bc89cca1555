"""The controls: another house, back and forward, cameras, the cut, the keyboard."""

from __future__ import annotations

from urllib.parse import parse_qs, urlparse

import pytest
from playwright.sync_api import expect

from tests.browser.visit import SMALL, Visit

TURNS = "([compass]) => [compass, compass.firstElementChild].map(one => parseFloat(getComputedStyle(one).rotate) || 0)"
"""How far a compass is turned, and how far its letter on it [degrees]."""


def asked(visit: Visit) -> dict[str, str]:
    """The request that the address holds."""
    return {name: values[0] for name, values in parse_qs(urlparse(visit.page.url).query).items()}


def test_generate_makes_the_house_of_the_form(visit: Visit) -> None:
    before = visit.open(SMALL.format(11))["scene"]
    yaml = visit.yaml()
    visit.page.get_by_label("Seed", exact=True).fill("12")
    visit.page.locator("#width").fill("14")
    visit.page.get_by_label("Outdoor rooms").uncheck()
    after = visit.after(lambda: visit.page.get_by_role("button", name="Generate").click())["scene"]
    assert (after["seed"], after["size"]["width"]) == (12, 14)
    assert not any(room["outdoor"] for room in after["rooms"])
    assert before != after
    assert visit.yaml() != yaml
    assert asked(visit) == {
        "seed": "12", "width": "14", "depth": "9", "min_room_size": "3", "max_depth": "5", "use_spine": "true", "outdoor": "false",
    }  # fmt: skip


def test_a_link_is_a_house(visit: Visit) -> None:
    first = visit.open("?seed=5&width=11&depth=9&use_spine=false")
    link = visit.page.url
    visit.open(SMALL.format(6))
    again = visit.after(lambda: visit.page.goto(link))
    assert again["scene"] == first["scene"]
    assert again["scene"]["request"]["use_spine"] is False


def test_back_and_forward_show_the_houses_of_before(visit: Visit) -> None:
    visit.open(SMALL.format(21))
    visit.page.locator("#seed").fill("22")
    visit.after(lambda: visit.page.keyboard.press("Enter"))
    assert visit.reopened(visit.page.go_back)["seed"] == 21
    expect(visit.page.locator("#seed")).to_have_value("21")
    assert visit.reopened(visit.page.go_forward)["seed"] == 22
    expect(visit.page.locator("#seed")).to_have_value("22")


def test_the_same_request_again_is_no_new_page_of_history(visit: Visit) -> None:
    visit.open(SMALL.format(31))
    length = visit.page.evaluate("history.length")
    visit.after(lambda: visit.page.get_by_role("button", name="Generate").click())
    assert visit.page.evaluate("history.length") == length


def test_random_draws_another_seed_by_key_and_by_button(visit: Visit) -> None:
    seeds = [visit.open(SMALL.format(41))["scene"]["seed"]]
    for act in (lambda: visit.page.keyboard.press("r"), visit.page.get_by_role("button", name="Random").click):
        seeds.append(visit.after(act)["scene"]["seed"])
        expect(visit.page.locator("#seed")).to_have_value(str(seeds[-1]))
        assert asked(visit)["seed"] == str(seeds[-1])
    assert len(set(seeds)) == 3


def test_r_typed_into_a_field_is_not_a_command(visit: Visit) -> None:
    visit.open(SMALL.format(41))
    visit.page.locator("#width").focus()
    visit.page.keyboard.press("r")
    visit.settle()
    assert asked(visit)["seed"] == "41"
    assert sum(url.endswith("/generate") for url in visit.requests) == 1


def test_sliders_and_numbers_say_the_same(visit: Visit) -> None:
    visit.open(SMALL.format(40))
    visit.page.get_by_label("Smallest room side, slider").fill("4")
    expect(visit.page.locator("#min_room_size")).to_have_value("4")
    visit.page.locator("#max_depth").fill("3")
    expect(visit.page.get_by_label("Depth of cuts, slider")).to_have_value("3")


def test_camera_presets_by_button_and_key(visit: Visit) -> None:
    visit.open(SMALL.format(40))
    for name, key, other in (("Top down", "2", "3"), ("3D", "3", "2")):
        presets_agree(visit, name, key, other)


def presets_agree(visit: Visit, name: str, key: str, other: str) -> None:
    """A preset by its button, jumped to, is that by its key, flown to."""
    places = []
    button = visit.page.get_by_role("button", name=name, exact=True)
    for act, calm in ((button.click, True), (lambda: visit.page.keyboard.press(key), False)):
        visit.page.emulate_media(reduced_motion="reduce")
        visit.page.keyboard.press(other)
        visit.settle()
        visit.page.emulate_media(reduced_motion="reduce" if calm else "no-preference")
        act()
        visit.settle()
        places.append(visit.state()["eye"])
    assert places[0] == pytest.approx(places[1], abs=1e-3)
    eye, target = visit.state()["eye"], visit.state()["target"]
    aside = ((eye[0] - target[0]) ** 2 + (eye[2] - target[2]) ** 2) ** 0.5
    assert aside < 0.1 if key == "2" else aside > 5


def test_dragging_turns_the_house_and_the_compass_whose_letter_stays_upright(visit: Visit) -> None:
    visit.open(SMALL.format(40))
    eye = visit.state()["eye"]
    before, letter = visit.page.locator("#compass").evaluate_all(TURNS)
    assert round(before + letter) % 360 == 0
    box = visit.page.locator("#stage > canvas").bounding_box()
    assert box
    beside = box["x"] + 0.95 * box["width"], box["y"] + 0.6 * box["height"]  # on a piece it would move that
    visit.page.mouse.move(*beside)
    visit.page.mouse.down()
    visit.page.mouse.move(beside[0] - 160, beside[1], steps=4)
    visit.page.mouse.up()
    visit.settle()
    assert visit.state()["eye"] != eye
    after, letter = visit.page.locator("#compass").evaluate_all(TURNS)
    assert abs(after - before) > 5
    assert round(after + letter) % 360 == 0


def test_every_control_has_a_name(visit: Visit) -> None:
    visit.open(SMALL.format(40))
    nameless = visit.page.evaluate(
        """() => [...document.querySelectorAll('input, button')]
            .filter(one => !(one.labels?.length || one.ariaLabel || one.textContent.trim())).map(one => one.outerHTML)"""
    )
    assert nameless == []
