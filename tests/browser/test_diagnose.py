"""The diagnosis: the service's report in a dialog, copied, fixed, with what a person flagged."""

from __future__ import annotations

import re
from typing import Any

import pytest
from playwright.sync_api import Locator, Route, expect

from tests.browser.visit import SMALL, Document, Visit, furniture_of, intercept, said, sent_by, told_sentence

QUERY = SMALL.format(4)


def ask(visit: Visit, call: str, body: Document) -> Any:
    """What the service answers to the test's own question."""
    return visit.page.request.post(visit.address + call, data=body).json()


def spoiled(visit: Visit) -> Document:
    """Opens a house in which one piece was pushed into another, as the service judges it; returns the answer shown."""
    shown: Document = {}

    def push(route: Route) -> None:
        answer = route.fetch().json()
        room = next(room for room in answer["scene"]["rooms"] if sum(not piece["on"] for piece in room["furniture"]) > 1)
        still, moved, *_ = [piece for piece in room["furniture"] if not piece["on"]]
        moved["x"], moved["z"] = still["x"] + 0.05, still["z"]
        answer["issues"] = ask(visit, "validate", {"scene": answer["scene"]})["issues"]
        shown.update(answer)
        route.fulfill(json=answer)

    intercept(visit.page, "**/generate", push)
    visit.open(QUERY)
    visit.page.unroute("**/generate")
    return shown


def lines(visit: Visit) -> Locator:
    return visit.page.locator("#report .report-line")


def opened(visit: Visit) -> Locator:
    """Presses the key, waits for the report and unfolds it."""
    visit.page.keyboard.press("d")
    dialog = visit.page.get_by_role("dialog", name="Diagnosis")
    expect(dialog).to_have_attribute("aria-busy", "false")
    expect(lines(visit).first).to_contain_text("Diagnosis")
    if not visit.page.evaluate("report_whole.open"):
        visit.page.get_by_text("The whole report").click()
    return dialog


def text_of(visit: Visit) -> str:
    return "\n".join(lines(visit).all_text_contents()) + "\n"


def errors(issues: list[Document]) -> list[Document]:
    return [issue for issue in issues if issue["severity"] == "error"]


def poses(scene: Document) -> dict[str, tuple[float, ...]]:
    return {body["id"]: (body["x"], body["z"], body["rotation"]) for room in scene["rooms"] for body in room["furniture"]}


def test_the_report_is_the_services_word_for_word(visit: Visit) -> None:
    scene = visit.open(QUERY)["scene"]
    visit.page.get_by_role("button", name="Diagnose").click()
    expect(visit.page.get_by_role("dialog", name="Diagnosis")).to_be_visible()
    expect(visit.page.get_by_role("dialog", name="Diagnosis")).to_have_attribute("aria-busy", "false")
    expect(lines(visit).first).to_contain_text("Diagnosis")
    assert text_of(visit) == ask(visit, "validate", {"scene": scene, "report": True})["report"]["text"]
    expect(visit.page.locator(".report-wrong")).to_have_count(0)
    expect(visit.page.locator("#diagnose_fix")).to_be_disabled()
    expect(visit.page.locator("#diagnose_copy")).to_be_focused()


def test_it_says_first_what_is_wrong_where_and_what_to_do(visit: Visit) -> None:
    answer = spoiled(visit)
    visit.page.locator("#diagnose").click()
    found = visit.page.locator("#diagnose_found")
    expect(found).to_contain_text("press Fix")
    expect(visit.page.locator("#diagnose_dialog button:visible").first).to_have_id("diagnose_fix")
    expect(visit.page.locator("#diagnose_fix")).to_be_focused()
    dialog, last = (visit.page.locator(one).bounding_box() for one in ("#diagnose_dialog", "#report_whole"))
    assert dialog and last
    assert dialog["y"] + dialog["height"] - last["y"] - last["height"] < 4  # no empty floor beneath
    expect(visit.page.locator("#report")).to_be_hidden()
    told = [told_sentence(issue["message"], answer["scene"]) for issue in answer["issues"]]
    assert sorted(found.get_by_role("button").all_text_contents()) == sorted(told)
    wrong = errors(answer["issues"])[0]
    room = next(room for room in answer["scene"]["rooms"] if room["id"] == wrong["room"])
    heads = found.locator("h3").all_text_contents()
    assert heads[0].lower().startswith(room["type"].replace("_", " "))
    assert len(heads) == len({issue["room"] for issue in answer["issues"]})
    found.get_by_role("button", name=told_sentence(wrong["message"], answer["scene"])).first.click()
    expect(visit.page.get_by_role("dialog", name="Diagnosis")).to_be_hidden()
    visit.settle()
    assert visit.state()["selected"] == wrong["ids"][0]


def test_where_nothing_is_wrong_that_is_said(visit: Visit) -> None:
    assert visit.open(QUERY)["issues"] == []
    visit.page.keyboard.press("d")
    found = visit.page.locator("#diagnose_found")
    expect(found).to_have_text("Nothing is wrong: every rule is kept.")
    visit.page.keyboard.press("Tab")
    for _ in range(6):
        if visit.page.evaluate("document.activeElement.tagName") == "SUMMARY":
            break
        visit.page.keyboard.press("Tab")
    visit.page.keyboard.press("Enter")
    expect(lines(visit).first).to_be_visible()


def test_escape_closes_and_gives_the_focus_back(visit: Visit) -> None:
    visit.open(QUERY)
    button = visit.page.get_by_role("button", name="Diagnose")
    button.focus()
    visit.page.keyboard.press("Enter")
    dialog = visit.page.get_by_role("dialog", name="Diagnosis")
    expect(dialog).to_be_visible()
    for _ in range(8):
        visit.page.keyboard.press("Tab")
        assert visit.page.evaluate("document.activeElement === document.body || diagnose_dialog.contains(document.activeElement)")
    visit.page.keyboard.press("Escape")
    expect(dialog).to_be_hidden()
    expect(button).to_be_focused()


def test_what_is_wrong_stands_out_and_leads_to_the_piece(visit: Visit) -> None:
    answer = spoiled(visit)
    opened(visit)
    told = ask(visit, "validate", {"scene": answer["scene"], "report": True})["report"]
    marked = [line for line in told["text"].splitlines() if line.startswith(">>")]
    assert len(marked) > 3
    assert visit.page.locator(".report-wrong").all_text_contents() == marked
    red = visit.page.locator(".report-wrong").first.evaluate("line => getComputedStyle(line).backgroundColor")
    plain = visit.page.locator(".report-plain").first.evaluate("line => getComputedStyle(line).backgroundColor")
    assert red != plain
    for part in ("#report", ".diagnose-body"):
        assert visit.page.locator(part).evaluate("one => one.scrollWidth <= one.clientWidth"), "no line ends out of sight"
    wronged = next(issue for issue in answer["issues"] if issue["rule"] == "overlap")["ids"][0]
    visit.page.locator(f'.report-wrong[data-id="{wronged}"]').first.click()
    expect(visit.page.get_by_role("dialog", name="Diagnosis")).to_be_hidden()
    visit.settle()
    assert visit.state()["selected"] == wronged


def test_fix_shows_what_the_service_made_of_it_and_undo_is_one_step(visit: Visit) -> None:
    answer = spoiled(visit)
    assert errors(answer["issues"])
    assert visit.count("issues") == len(answer["issues"])
    opened(visit)
    with visit.page.expect_response(lambda response: response.url.endswith("/fix")) as caught:
        visit.page.get_by_role("button", name="Fix", exact=True).click()
    fixed = caught.value.json()
    assert sent_by(caught.value.request)["scene"] == answer["scene"]
    assert errors(fixed["issues"]) == []
    expect(visit.page.locator("#diagnose_said")).to_contain_text(f"{len(fixed['moves'])} piece")
    expect(visit.page.locator("#diagnose_said")).to_contain_text("no error is left")
    expect(visit.page.locator(".report-wrong")).to_have_count(0)
    told = ask(visit, "validate", {"scene": fixed["scene"], "report": True})["report"]["text"]
    assert text_of(visit) == told
    assert visit.count("issues") == len(fixed["issues"])
    assert poses(fixed["scene"]) != poses(answer["scene"])
    visit.page.keyboard.press("Escape")
    visit.page.keyboard.press("Control+z")
    expect(visit.page.locator("[data-count=issues]")).to_have_text(str(len(answer["issues"])))
    opened(visit)
    expect(visit.page.locator(".report-wrong").first).to_be_visible()
    assert text_of(visit) == ask(visit, "validate", {"scene": answer["scene"], "report": True})["report"]["text"]


def test_what_cannot_stand_is_left_out_only_when_asked(visit: Visit) -> None:
    answer = spoiled(visit)
    removed = {"id": furniture_of(answer)[0], "reason": "there is no floor for it"}
    name = removed["id"].partition("/")[2].removesuffix("_1").replace("_", " ")
    no_door: Document = {"ids": [], "message": "no door joins them", "repairs": []}
    of_the_plan = {**answer, "moves": [], "removed": [], "conflicts": [no_door]}

    def refuse(route: Route) -> None:
        kept = {
            **answer,
            "moves": [],
            "removed": [],
            "conflicts": [{"ids": [removed["id"]], "message": "0.2 m are missing", "repairs": []}],
        }
        gone = {**kept, "removed": [removed], "issues": [], "conflicts": []}
        route.fulfill(json=kept if sent_by(route.request)["on_conflict"] == "report" else gone)

    intercept(visit.page, "**/fix", lambda route: route.fulfill(status=503, body=""))
    opened(visit)
    visit.page.get_by_role("button", name="Fix", exact=True).click()
    expect(visit.page.locator("#diagnose_said")).to_contain_text("The service is busy")
    visit.page.unroute("**/fix")
    intercept(visit.page, "**/fix", lambda route: route.fulfill(json=of_the_plan))
    visit.page.locator("#diagnose_said").get_by_role("button", name="Try again").click()
    change = visit.page.locator("#diagnose_plan")
    expect(change).to_be_visible()
    expect(visit.page.get_by_role("button", name="Fix, leaving out what cannot stand")).to_be_hidden()
    change.click()
    expect(visit.page.locator("#drawing")).to_be_visible()
    visit.page.locator("#drawing [data-tool=close]").click()
    visit.page.unroute("**/fix")

    intercept(visit.page, "**/fix", refuse)
    opened(visit)
    expect(change).to_be_hidden()
    leaving = visit.page.get_by_role("button", name="Fix, leaving out what cannot stand")
    expect(leaving).to_be_hidden()
    visit.page.get_by_role("button", name="Fix", exact=True).click()
    said = visit.page.locator("#diagnose_said")
    expect(said).to_contain_text("0.2 m are missing")
    leaving.click()
    expect(said).to_contain_text(f"Left out {name}: there is no floor for it")
    expect(leaving).to_be_hidden()


@pytest.mark.own_page
def test_opened_again_before_its_closing_is_told_it_reads_the_report_anew(visit: Visit) -> None:
    visit.open(QUERY)
    dialog = opened(visit)
    expect(dialog).to_have_attribute("aria-busy", "false")
    visit.page.evaluate("""async () => {
        const { fetch } = window;
        const told = new Promise((resolve) => document.querySelector("dialog[open]").addEventListener("close", resolve, {once: true}));
        window.fetch = async (...asked) => { await told; return fetch(...asked); };
        document.querySelector("dialog[open]").close();
        document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "d", bubbles: true}));
        await told;
    }""")
    expect(dialog).to_be_visible()
    expect(dialog).to_have_attribute("aria-busy", "false")


@pytest.mark.own_page
def test_copy_gives_the_whole_report_or_selects_it(visit: Visit) -> None:
    visit.open(QUERY)
    visit.page.evaluate(
        "globalThis.allowed = true; navigator.clipboard.writeText = async text => "
        "{ if (!allowed) throw new Error('no'); globalThis.copied = text }; 0"
    )
    opened(visit)
    copy, said = visit.page.get_by_role("button", name="Copy", exact=True), visit.page.locator("#diagnose_said")
    copy.click()
    expect(said).to_have_text("Copied.")
    assert visit.page.evaluate("copied") == text_of(visit)
    visit.page.evaluate("allowed = false")
    copy.click()
    expect(said).to_contain_text("Ctrl+C")
    assert "Summary: " in visit.page.evaluate("getSelection().toString()")


def test_a_flagged_piece_is_problematic_in_text_and_report(visit: Visit) -> None:
    scene = visit.open(QUERY)["scene"]
    one, other = [piece["id"] for room in scene["rooms"] for piece in room["furniture"]][:2]
    flag = visit.page.get_by_role("button", name="Flag")
    expect(flag).to_be_disabled()
    visit.line_of(one).click()
    flag.click()
    expect(flag).to_have_attribute("aria-pressed", "true")
    visit.line_of(other).click()
    expect(flag).to_have_attribute("aria-pressed", "false")
    visit.page.keyboard.press("f")
    marked = visit.page.locator("#yaml").get_by_text("PROBLEMATIC")
    expect(marked).to_have_count(2)
    expect(visit.line_of(one)).to_have_text(re.compile(r"\S {2}PROBLEMATIC$"))
    visit.page.keyboard.press("f")
    expect(flag).to_have_attribute("aria-pressed", "false")
    expect(marked).to_have_count(1)
    opened(visit)
    assert text_of(visit) == ask(visit, "validate", {"scene": scene, "flagged": [one]})["report"]["text"]
    expect(visit.page.locator(f'.report-flagged[data-id="{one}"]').first).to_contain_text("PROBLEMATIC")


def test_a_service_that_is_lost_is_said_in_the_dialog(visit: Visit) -> None:
    visit.open(QUERY)
    intercept(visit.page, "**/validate", lambda route: route.abort())
    visit.page.keyboard.press("d")
    expect(visit.page.locator("#diagnose_said")).to_contain_text("does not answer")


def test_keys_in_the_dialog_do_nothing_behind_it(visit: Visit) -> None:
    visit.open(QUERY)
    opened(visit)
    visit.page.keyboard.press("r")
    visit.settle()
    assert sum(url.endswith("/generate") for url in visit.requests) == 1


def test_the_search_finds_pieces_and_goes_from_one_to_the_next(visit: Visit) -> None:
    scene = visit.open(QUERY)["scene"]
    name = scene["rooms"][0]["furniture"][0]["name"]
    asked = len(visit.requests)
    visit.page.get_by_role("searchbox", name="Find a piece").fill(said(name))
    found = visit.page.locator(".yaml-line.found")
    ids = found.evaluate_all("lines => lines.map(line => line.dataset.id)")
    assert ids
    assert all(name in line for line in found.all_text_contents())
    expect(visit.page.locator("#find_words")).to_have_text(f"{len(ids)} found")
    for wanted in (ids[0], ids[1 % len(ids)]):
        visit.page.keyboard.press("Enter")
        assert visit.state()["selected"] == wanted
    visit.page.keyboard.press("r")
    assert len(visit.requests) == asked
    visit.page.keyboard.press("Escape")
    expect(found).to_have_count(0)


def test_issues_are_grouped_and_lead_to_their_piece(visit: Visit) -> None:
    answer = spoiled(visit)
    rules = list(dict.fromkeys(issue["rule"] for issue in answer["issues"]))
    titles = visit.page.locator(".issue-rule").all_text_contents()
    counts = [f"{rule.replace('_', ' ')} {sum(issue['rule'] == rule for issue in answer['issues'])}" for rule in rules]
    assert sorted(titles) == sorted(counts)
    first = errors(answer["issues"])[0]
    visit.page.locator("#issue_list").get_by_role("button", name=told_sentence(first["message"], answer["scene"])).first.click()
    visit.settle()
    assert visit.state()["selected"] == first["ids"][0]
    at = visit.page.evaluate("id => compose.whereIs(id)", first["ids"][0])
    stage = visit.page.locator("#stage").bounding_box()
    if at and stage:
        assert abs(at["x"] - stage["x"] - stage["width"] / 2) < 12


def test_words_stand_at_what_is_wrong(visit: Visit) -> None:
    answer = spoiled(visit)
    visit.page.keyboard.press("2")
    visit.settle()
    rules: dict[str, set[str]] = {}
    for issue in errors(answer["issues"]):
        for name in issue["ids"] or [issue["room"]]:
            rules.setdefault(name, set()).add(issue["rule"].replace("_", " ").upper())
    marks = visit.page.locator(".mark-label").all_text_contents()
    assert sorted(sorted(mark.split(", ")) for mark in marks) == sorted(sorted(words) for words in rules.values())
    expect(visit.page.locator(".mark-label").first).to_be_visible()
