"""What the page says when the service refuses, is busy, or is gone."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Route, expect

from tests.browser.visit import SMALL, Visit, furniture_of, intercept


def test_a_refused_field_is_said_beside_it_and_the_house_stays(visit: Visit) -> None:
    visit.open(SMALL.format(3))
    yaml = visit.yaml()
    visit.page.locator("#width").fill("5000")
    visit.page.get_by_role("button", name="Generate").click()
    expect(visit.page.locator("#width_problem")).to_contain_text("1000")
    expect(visit.page.locator("#width")).to_have_attribute("aria-invalid", "true")
    expect(visit.page.get_by_role("alert")).to_be_visible()
    assert visit.yaml() == yaml
    visit.page.locator("#width").fill("12")
    visit.after(lambda: visit.page.get_by_role("button", name="Generate").click())
    expect(visit.page.get_by_role("alert")).to_be_hidden()
    expect(visit.page.locator("#width")).to_have_attribute("aria-invalid", "false")


def test_an_address_that_makes_no_sense_is_explained(visit: Visit) -> None:
    visit.page.goto(visit.address + "?width=wide")
    expect(visit.page.get_by_role("alert")).to_contain_text("Width: enter a number")
    visit.settle()


@pytest.mark.own_page
def test_words_of_an_address_that_mean_nothing_are_told_and_the_home_is_shown(visit: Visit) -> None:
    answer = visit.open(SMALL.format(3) + "&preset=foo&colour=red")
    expect(visit.page.get_by_role("alert")).to_contain_text("'preset', 'colour': the home is shown without")
    assert visit.count("rooms") == len(answer["scene"]["rooms"])
    assert "preset" not in visit.page.url
    visit.after(lambda: visit.page.get_by_role("button", name="Random").click())
    expect(visit.page.get_by_role("alert")).to_be_hidden()


def test_a_plan_that_was_not_drawn_is_asked_for_again(visit: Visit) -> None:
    visit.open(SMALL.format(3))
    intercept(visit.page, "**/export/svg", lambda route: route.abort())
    visit.page.keyboard.press("4")
    again = visit.page.get_by_role("button", name="Try again")
    expect(again).to_be_visible()
    visit.page.unroute("**/export/svg")
    again.click()
    expect(visit.page.get_by_role("alert")).to_be_hidden()
    visit.settle()
    expect(visit.page.locator("#stage .plan-sheet svg")).to_have_count(1)


def test_a_lost_service_is_said_to_be_lost_and_found_again(visit: Visit) -> None:
    page = visit.page
    visit.open(SMALL.format(8))
    rooms = visit.count("rooms")
    intercept(page, "**/generate", lambda route: route.abort("connectionrefused"))
    page.keyboard.press("r")
    expect(page.get_by_role("alert")).to_contain_text("does not answer")
    assert visit.count("rooms") == rooms
    page.unroute("**/generate")
    visit.after(lambda: page.get_by_role("button", name="Try again").click())
    expect(page.get_by_role("alert")).to_be_hidden()


def test_a_newer_question_withdraws_the_older(visit: Visit) -> None:
    visit.open(SMALL.format(1))
    held: list[Route] = []
    intercept(visit.page, "**/generate", lambda route: held.append(route) if not held else route.continue_())
    visit.page.locator("#seed").fill("2")
    visit.page.keyboard.press("Enter")
    expect(visit.page.locator("#stage")).to_have_attribute("aria-busy", "true")
    visit.page.locator("#seed").fill("3")
    assert visit.after(lambda: visit.page.keyboard.press("Enter"))["scene"]["seed"] == 3
    expect(visit.page.get_by_role("alert")).to_be_hidden()
    assert "seed 3" in visit.yaml() or "seed: 3" in visit.yaml()


@pytest.mark.own_page
def test_a_key_is_asked_for_kept_and_sent(visit: Visit) -> None:
    keys: list[str | None] = []

    def guarded(route: Route) -> None:
        keys.append(route.request.headers.get("x-api-key"))
        if keys[-1] == "sesame":
            route.continue_()
        else:
            route.fulfill(status=401, body="{}")

    intercept(visit.page, "**/generate", guarded)
    visit.page.goto(visit.address + SMALL.format(3))
    expect(visit.page.get_by_label("Key", exact=True)).to_be_focused()
    visit.page.keyboard.type("sesame")
    visit.after(lambda: visit.page.keyboard.press("Enter"))
    expect(visit.page.get_by_role("alert")).to_be_hidden()
    visit.page.keyboard.press("Escape")
    visit.after(visit.page.locator("#random").click)
    assert keys == [None, "sesame", "sesame"]


@pytest.mark.own_page
def test_too_many_requests_are_counted_down(visit: Visit) -> None:
    visit.open(SMALL.format(3))
    visit.page.evaluate("window.setInterval = (act, every) => { window.afterwards = {act, every}; return 0; }; 0")
    intercept(visit.page, "**/generate", lambda route: route.fulfill(status=429, headers={"Retry-After": "3"}, body="{}"))
    visit.page.locator("#generate").click()
    again = visit.page.locator(".notice-again")
    for words in ("3 seconds", "2 seconds", "1 second"):
        expect(again).to_have_text(f"Try again in {words}")
        expect(again).to_be_disabled()
        assert visit.page.evaluate("afterwards.act(), afterwards.every") == 1000
    expect(again).to_be_enabled()
    visit.page.unroute("**/generate")
    visit.after(again.click)
    expect(visit.page.get_by_role("alert")).to_be_hidden()


def test_long_work_is_said_and_short_work_is_not(visit: Visit) -> None:
    visit.open(SMALL.format(3))
    held: list[Route] = []

    def hold(route: Route) -> None:
        held.append(route)

    intercept(visit.page, "**/generate", hold)
    visit.page.locator("#generate").click()
    expect(visit.page.locator("#stage")).to_have_attribute("aria-busy", "true")
    expect(visit.page.locator("#progress")).to_contain_text("Laying out the house")
    visit.after(held[0].continue_)
    expect(visit.page.locator("#progress")).to_be_hidden()


def test_what_is_refused_beside_houses_is_said_and_tried_again_alone(visit: Visit) -> None:
    page = visit.page
    busy = {"type": "about:blank", "title": "The service is busy", "status": 503, "detail": "Come back in 2 s.", "errors": []}
    piece = next(iter(furniture_of(visit.open(SMALL.format(3)))))
    notice, again = page.get_by_role("alert"), page.get_by_role("button", name="Try again")

    def refused(call: str, act: Callable[[], object]) -> None:
        intercept(page, f"**/{call}", lambda route: route.fulfill(status=503, json=busy))
        act()
        expect(notice).to_contain_text("The service is busy")
        page.unroute(f"**/{call}")

    refused("view", lambda: visit.after(page.get_by_role("button", name="Generate").click))
    refused("export/yaml", page.get_by_role("button", name="Save YAML").click)
    with page.expect_download(), page.expect_response(lambda response: response.url.endswith("/view")):
        again.click()  # what is shown comes with it
    expect(notice).to_be_hidden()
    visit.line_of(piece).click()
    asks = {
        "explain": lambda: page.keyboard.press("h"),
        "floor": lambda: page.keyboard.press("o"),
        "generate": page.locator("#others_now").click,
    }
    page.locator("#room_choice").select_option(index=1)
    visit.line_of(piece).click()
    for call, ask in asks.items():
        refused(call, ask)
        with page.expect_response(lambda response, call=call: response.url.endswith(f"/{call}")):  # type: ignore[misc]
            again.click()
        expect(notice).to_be_hidden()
    expect(page.locator(".others-row button")).to_have_count(3)
    page.keyboard.press("Escape")
    visit.line_of(piece).click()
    refused("fix", lambda: page.keyboard.press("Delete"))
    page.locator(".notice-close").click()
    page.locator("#show_floor").uncheck()
    with page.expect_response(lambda response: response.url.endswith("/fix")):
        page.keyboard.press("Delete")
    expect(visit.line_of(piece)).to_have_count(0)
    assert sum(url.endswith("/generate") for url in visit.requests) == 2 + 1 + 3


@pytest.mark.own_page
def test_a_palette_that_was_refused_is_filled_once_it_is_asked_for_again(visit: Visit) -> None:
    page = visit.page
    intercept(page, "**/catalog", lambda route: route.fulfill(status=500, body="gone"))
    visit.open(SMALL.format(3))
    page.keyboard.press("a")
    expect(page.get_by_role("alert")).to_be_visible()
    page.unroute("**/catalog")
    page.get_by_role("button", name="Try again").click()
    expect(page.locator("#palette li").first).to_be_visible()
    expect(page.get_by_role("alert")).to_be_hidden()


@pytest.mark.own_page
def test_formats_that_were_not_told_are_asked_for_again_where_they_are_looked_for(visit: Visit) -> None:
    page = visit.page
    intercept(page, "**/export", lambda route: route.fulfill(status=503, body="busy"))
    visit.open(SMALL.format(3))
    page.locator("#files").evaluate("one => { one.open = false; }")
    expect(page.locator("#export")).to_be_hidden()
    page.unroute("**/export")
    page.locator("#files > summary").click()
    expect(page.locator("#export")).to_be_visible()
    assert page.locator("#export_format option").count() > 10


BARE = {413: "Too large", 429: "Too many requests", 503: "busy", 504: "slow", 500: "refused", 401: "wants a key"}


def test_a_bare_refusal_has_plain_words_and_the_page_goes_on(visit: Visit) -> None:
    status = next(iter(BARE))
    intercept(visit.page, "**/generate", lambda route: route.fulfill(status=status, body="<html>gone</html>"))
    alert, again = visit.page.get_by_role("alert"), visit.page.get_by_role("button", name="Try again")
    visit.page.goto(visit.address + SMALL.format(3))
    expect(alert).to_contain_text(BARE[status])
    for status, words in BARE.items():
        visit.page.locator("#generate").click()
        expect(alert).to_contain_text(words)
        expect(alert).not_to_contain_text("<html>")
        expect(again).to_be_visible(visible=status not in (401, 413))
    visit.page.unroute("**/generate")
    assert visit.after(visit.page.get_by_role("button", name="Random").click)["scene"]["rooms"]
    expect(alert).to_be_hidden()
