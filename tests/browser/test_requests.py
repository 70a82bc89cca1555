"""The request form beyond plain plans: programmes, areas, styles, decorations, links to them, refusals beside fields."""

from __future__ import annotations

from collections import Counter
from urllib.parse import parse_qs, urlparse

from playwright.sync_api import expect

from tests.browser.visit import SMALL, Document, Visit


def generate(visit: Visit) -> Document:
    """Ask for what the form says."""
    return visit.after(lambda: visit.page.locator("#generate").click())["scene"]


def asked(visit: Visit) -> dict[str, str]:
    """The request that the address holds."""
    return {name: values[0] for name, values in parse_qs(urlparse(visit.page.url).query).items()}


def test_a_preset_by_the_form_and_by_its_link(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    visit.page.locator("#reset").click()
    visit.settle()
    visit.page.locator("#program").select_option(label="One bedroom")
    expect(visit.page.locator("#width")).to_have_value("")
    expect(visit.page.locator("#min_room_size")).to_be_hidden()
    expect(visit.page.locator("#cuts_words")).to_be_visible()
    scene = generate(visit)
    assert scene["request"]["program"] == "one_bed"
    assert asked(visit) == {"seed": "42", "outdoor": "true", "decorate": "true", "program": "one_bed"}
    assert visit.reopened(visit.page.reload) == scene
    expect(visit.page.locator("#program")).to_have_value("preset:one_bed")


def test_own_rooms_are_counted(visit: Visit) -> None:
    visit.open(SMALL.format(4))
    visit.page.locator("#program").select_option("own")
    visit.page.get_by_label("Bedrooms").fill("2")
    visit.page.get_by_label("Office").fill("1")
    for side in ("width", "depth"):
        visit.page.locator(f"#{side}").fill("")
    scene = generate(visit)
    types = Counter(room["type"] for room in scene["rooms"])
    assert types["office"] == 1
    assert types["bedroom"] + types["bedroom_master"] + types["kids_bedroom"] == 2
    assert asked(visit)["program.bedrooms"] == "2"
    assert visit.reopened(visit.page.reload) == scene
    expect(visit.page.get_by_label("Office")).to_have_value("1")


def test_an_area_alone_and_back_to_a_plain_plan(visit: Visit) -> None:
    visit.open("?area=60&seed=3")
    expect(visit.page.locator("#program")).to_have_value("by_area")
    visit.page.locator("#program").select_option("")
    scene = generate(visit)
    assert scene["request"]["area"] is None
    assert (scene["size"]["width"], scene["size"]["depth"]) == (20, 15)
    assert visit.reopened(visit.page.go_back)["request"]["area"] == 60


def test_style_decorations_and_robot(visit: Visit) -> None:
    plain = visit.open(SMALL.format(4))["scene"]
    assert not any(room["decorations"] for room in plain["rooms"])
    decorated = visit.after(lambda: visit.page.locator("#decorate_now").click())["scene"]
    assert [room["furniture"] for room in decorated["rooms"]] == [room["furniture"] for room in plain["rooms"]]
    assert visit.count("decorations") == sum(len(room["decorations"]) for room in decorated["rooms"]) > 0
    styled = visit.after(lambda: visit.page.locator("#style").select_option("scandi"))["scene"]
    assert styled["request"]["style"] == "scandi"
    visit.page.locator("#robot_width").fill("0.5")
    request = generate(visit)["request"]
    assert (request["style"], request["robot_width"], request["decorate"]) == ("scandi", 0.5, True)
    assert asked(visit).items() >= {"style": "scandi", "robot_width": "0.5", "decorate": "true"}.items()


def test_camel_case_is_read(visit: Visit) -> None:
    request = visit.open("?seed=4&width=12&depth=9&useSpine=0&decorate=1&outdoor=0")["scene"]["request"]
    assert (request["use_spine"], request["decorate"], request["outdoor"]) == (False, True, False)


def test_refused_words_are_said_beside_their_fields(visit: Visit) -> None:
    visit.page.goto(visit.address + "?program.bedrooms=99&robot_width=9")
    visit.settle()
    refused = visit.page.locator("[aria-invalid=true]")
    expect(refused).to_have_count(2)
    expect(refused.first).to_be_focused()
    expect(visit.page.get_by_role("alert")).to_be_visible()


def test_the_status_says_what_is_proven(visit: Visit) -> None:
    rooms = visit.open(SMALL.format(4))["scene"]["certificate"]["rooms"]
    proven = sum(room["proven"] for room in rooms.values())
    place = visit.page.locator("[data-count=optimality]")
    expect(place).to_have_text(f"proven optimal in {proven} of {len(rooms)} rooms")
    assert "No other placement" in (place.get_attribute("title") or "")
