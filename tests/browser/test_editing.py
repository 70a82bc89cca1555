"""Editing by hand: the service judges every wish, what it answers is shown, and every step can be undone."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Request, Route, expect

from tests.browser.visit import ANSWER_MS, Document, Visit, intercept, told_sentence

ONE, OTHER = "den/one", "den/other"


def crate(id_of: str, x: float, z: float, side: float = 1.0, *, locked: bool = False) -> Document:
    """A square piece [m]."""
    sizes = {"width": side, "depth": side, "height": 0.5}
    return {"id": id_of, "name": "crate", "category": "storage", "x": x, "z": z, "locked": locked, **sizes}


def den(*pieces: Document, width: float = 4, depth: float = 3) -> Document:
    """A house of one room that asks for nothing [m]."""
    room = {"id": "den", "type": "storage", "x": 0, "z": 0, "width": width, "depth": depth, "furniture": list(pieces)}
    return {"rooms": [room]}


class Bench:
    """A page that shows a scene from above, and all that it asks of /fix."""

    def __init__(self, visit: Visit, scene: Document) -> None:
        self.visit, self.page = visit, visit.page
        self.under_way, self.most_under_way, self.fixes = 0, 0, 0
        self.ended: list[Request] = []
        self.page.on("request", self._asked)
        self.page.on("requestfinished", self._ended)
        self.page.on("requestfailed", self._ended)
        self.before = self.ask("export/json", scene)
        answer = {"scene": self.before, "issues": self.ask("validate", {"scene": self.before})["issues"], "timing_ms": 1}
        intercept(self.page, "**/generate", lambda route: route.fulfill(json=answer))
        visit.open()
        self.page.keyboard.press("2")
        visit.settle()

    def _asked(self, request: Request) -> None:
        if request.url.endswith("/fix"):
            self.fixes += 1
            self.under_way += 1
            self.most_under_way = max(self.most_under_way, self.under_way)

    def _ended(self, request: Request) -> None:
        if request.url.endswith("/fix"):
            self.under_way -= 1
            self.ended.append(request)

    def last_answer(self) -> Document:
        """What /fix answered last."""
        response = self.ended[-1].response()
        assert response is not None
        answer: Document = response.json()
        return answer

    def ask(self, call: str, body: Document) -> Any:
        """What the service answers to the test's own question."""
        return self.page.request.post(self.visit.address + call, data=body, timeout=ANSWER_MS).json()

    def scene(self) -> Document:
        shown: Document = self.page.evaluate("compose.scene")
        return shown

    def at(self, id_of: str) -> tuple[int, int]:
        """Where in the window a piece is."""
        at = self.page.evaluate("id => compose.whereIs(id)", id_of)
        return at["x"], at["y"]

    def drag(self, id_of: str, to: tuple[int, int], steps: int = 12) -> None:
        """Drag a piece's middle to a point of the window and hold it there."""
        self.page.mouse.move(*self.at(id_of))
        self.page.mouse.down()
        self.page.mouse.move(*to, steps=steps)

    def rest(self) -> None:
        """Wait until every edit is answered and every body has come to rest."""
        self.visit.settle()

    def choose(self, id_of: str) -> None:
        self.visit.line_of(id_of).click()

    def press(self, *keys: str) -> None:
        """Press keys one after the other, as the canvas has them, and wait for what comes of it."""
        self.page.locator("#stage > canvas").evaluate("() => document.activeElement.blur()")
        for key in keys:
            self.page.keyboard.press(key)
        self.rest()

    def errors(self) -> list[Document]:
        """What the service finds wrong with the shown scene, asked anew."""
        issues = self.ask("validate", {"scene": self.scene()})["issues"]
        return [issue for issue in issues if issue["severity"] == "error"]


def poses(scene: Document) -> dict[str, tuple[float, ...]]:
    return {piece["id"]: (piece["x"], piece["z"], piece["rotation"]) for room in scene["rooms"] for piece in room["furniture"]}


def drawn(bench: Bench) -> dict[str, Any]:
    """Where the pieces are drawn in the only room, which begins at nought."""
    places = bench.page.evaluate("compose.places")
    return {id_of: pytest.approx((x, z, turn % 360), abs=1e-6) for id_of, (x, z, turn) in places.items()}


def test_a_dragged_piece_makes_its_neighbour_move_as_the_service_says(moving: Visit) -> None:
    bench = Bench(moving, den(crate(ONE, 1, 1), crate(OTHER, 2.8, 1.8)))
    bench.drag(ONE, bench.at(OTHER), steps=25)
    bench.page.mouse.up()
    bench.rest()
    after = bench.scene()
    assert poses(after)[OTHER] != poses(bench.before)[OTHER]
    assert poses(after)[ONE] != poses(bench.before)[ONE]
    assert poses(after) == poses(bench.last_answer()["scene"]) == drawn(bench)
    assert bench.errors() == []
    assert bench.fixes >= 2
    assert bench.most_under_way == 1


def test_a_locked_neighbour_stays_and_cannot_be_dragged(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1), crate(OTHER, 3, 2, locked=True)))
    bench.drag(ONE, bench.at(OTHER))
    bench.page.mouse.up()
    bench.rest()
    assert poses(bench.scene())[OTHER] == poses(bench.before)[OTHER]
    assert bench.errors() == []
    asked, once = bench.fixes, poses(bench.scene())
    bench.drag(OTHER, bench.at(ONE))
    bench.page.mouse.up()
    bench.rest()
    assert poses(bench.scene()) == once
    assert bench.fixes == asked


SEEN = """id => {
    const places = globalThis.seen = [];
    const look = globalThis.look = () => {
        const [x] = compose.places[id];
        if (places.at(-1) !== x) places.push(x);
        if (globalThis.seen === places) requestAnimationFrame(look);
    };
    look();
}"""
"""Notes, frame by frame and once more when asked for, where a piece is drawn: each place once. It may come to rest after a frame's note."""


def test_a_moved_piece_glides_to_its_place_but_is_there_at_once_to_who_wants_no_motion(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1)))
    bench.choose(ONE)

    def seen(key: str) -> list[float]:
        bench.page.evaluate(SEEN, ONE)
        bench.press(key)
        places: list[float] = bench.page.evaluate("() => { look(); const places = seen; globalThis.seen = null; return places; }")
        return places

    often = {"reduce": 1, "no-preference": 4}
    for moves in ("reduce", "no-preference"):
        bench.page.emulate_media(reduced_motion=moves)
        glides = [seen(key) for key in ("ArrowRight", "ArrowLeft") * often[moves]]
        for there, back in zip(glides[::2], glides[1::2], strict=True):
            assert (there[0], there[-1], back[0], back[-1]) == pytest.approx((1, 1.05, 1.05, 1), abs=1e-3)
            assert (there, back[::-1]) == (sorted(there), sorted(back))
        among = {len(places) > 2 for places in glides}  # a busy machine may show the end alone
        assert (True in among) == (moves == "no-preference")


def test_keys_turn_a_piece_and_undo_and_redo_go_back_and_forth(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1), crate(OTHER, 3, 2)))
    bench.choose(ONE)
    bench.press("q")
    turned = bench.scene()
    assert poses(turned)[ONE] == (1, 1, 90)
    assert poses(turned) == drawn(bench)
    bench.press("e", "e")
    assert poses(bench.scene())[ONE] == (1, 1, 270)
    bench.press("Control+z", "Control+z", "Control+z")
    assert bench.scene() == bench.before
    bench.press("Control+Shift+z")
    assert bench.scene() == turned


def test_arrow_keys_alone_move_a_piece_the_way_they_point(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1), crate(OTHER, 3, 2)))
    visit.line_of(ONE).focus()
    bench.page.keyboard.press("Enter")
    bench.press("ArrowRight", "ArrowRight", "ArrowDown")
    x, z, _ = poses(bench.scene())[ONE]
    assert (x, z) == pytest.approx((1.1, 1.05), abs=1e-6)
    bench.press("Shift+ArrowLeft")
    assert poses(bench.scene())[ONE][0] == pytest.approx(1.09, abs=1e-6)
    assert bench.errors() == []


def test_an_arrow_key_on_a_locked_piece_says_why_it_stays_and_offers_to_unlock_it(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1, locked=True)))
    bench.choose(ONE)
    bench.press("ArrowRight")
    expect(bench.page.locator("#conflict")).to_contain_text("is locked: it stays where it is")
    bench.page.locator("#conflict").get_by_role("button", name="Unlock").click()
    bench.rest()
    bench.press("ArrowRight")
    expect(bench.page.locator("#conflict")).to_be_hidden()
    assert poses(bench.scene())[ONE] == pytest.approx((1.05, 1, 0), abs=1e-6)
    assert bench.errors() == []


def test_a_conflict_is_said_in_the_services_words_and_a_repair_ends_it(visit: Visit) -> None:
    bench = Bench(visit, den(crate(OTHER, 1.1, 1.1, 1.8, locked=True), width=2.2, depth=2.2))
    bench.press("a")
    bench.page.get_by_role("searchbox", name="Add a piece").fill("armchair")
    with bench.page.expect_response(lambda response: response.url.endswith("/fix")):
        bench.page.locator("#palette button[data-kind=armchair]").click()
    bench.rest()
    conflicts = bench.last_answer()["conflicts"]
    assert conflicts
    assert bench.scene() == bench.before
    panel = bench.page.locator("#conflict")
    for conflict in conflicts:
        expect(panel).to_contain_text(told_sentence(conflict["message"], bench.before))
    with bench.page.expect_response(lambda response: response.url.endswith("/fix")):
        panel.get_by_role("button", name="Leave out").first.click()
    bench.rest()
    expect(panel).to_be_hidden()
    assert len(poses(bench.scene())) == 1
    assert bench.errors() == []


HANDLES = "[...document.querySelectorAll('.handle')].filter(one => !one.hidden).map(one => one.style.transform)"
"""Where the handles of the chosen piece are seen."""


def test_a_service_lost_during_a_drag_is_said_and_all_stays(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 1, 1), crate(OTHER, 3, 2)))

    def lose(route: Route) -> None:
        route.abort()

    for call in ("fix", "drag", "floor"):  # all that a drag asks for
        intercept(bench.page, f"**/{call}", lose)
    bench.choose(ONE)
    bench.rest()
    handles = bench.page.evaluate(HANDLES)
    x, y = bench.at(OTHER)
    with bench.page.expect_event("requestfailed", lambda request: request.url.endswith("/fix")):
        bench.drag(ONE, (x, y))
    notice = bench.page.get_by_role("alert")
    bench.page.mouse.move(x + 2, y)
    bench.page.mouse.move(x, y)
    expect(notice).to_be_hidden()
    bench.page.mouse.up()
    expect(notice).to_contain_text("does not answer")
    expect(notice).to_contain_text("The home is as it was before the change.")
    bench.rest()
    assert bench.scene() == bench.before
    assert poses(bench.before) == drawn(bench)
    assert handles and bench.page.evaluate(HANDLES) == handles
    for call in ("fix", "drag", "floor"):
        bench.page.unroute(f"**/{call}", lose)
    notice.get_by_role("button", name="Try again").click()
    expect(notice).to_be_hidden()
    bench.rest()
    assert poses(bench.scene())[ONE] != poses(bench.before)[ONE]


def test_who_walks_drags_nothing(visit: Visit) -> None:
    bench = Bench(visit, den(crate(ONE, 2, 1.5), crate(OTHER, 3.4, 0.6)))
    bench.page.keyboard.press("1")
    visit.settle()
    seen = OTHER
    x, y = bench.at(seen)
    before = visit.state()
    assert before["walking"]
    bench.drag(seen, (x - 120, y))
    bench.page.mouse.up()
    bench.rest()
    after = visit.state()
    assert after["eye"] == before["eye"]
    assert after["target"] != before["target"]
    assert bench.fixes == 0
    assert poses(bench.before) == drawn(bench)
