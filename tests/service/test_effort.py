"""One limit of work for a whole call: counted, said in the answer, never more than was asked for."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from typing import Any

import pytest
from starlette.responses import Response

from catalogs import load_catalogs
from service.calls import CALLS
from service.contract import PlaceBody
from service.effort import EFFORTS, USUAL, Terms, limited_to, on_terms
from service.packed_catalogs import mark_of, packed
from service.work import Job, do
from solver import fix, place
from solver.errors import FieldError
from solver.exchange import read, read_scene
from solver.pieces import Piece
from solver.pipeline.left_over import LEAVING_WORK, WALKED_WORK
from solver.placement import work_of_call
from solver.repair import as_sent
from solver.scene import Scene
from solver.validator import Checked

TERMS = Terms(work=30_000)
OVERSHOOT = 150_000
"""What writing the rows of these rooms once counts, and the searches that are known to end; a normal call has 1,500,000."""
ROOM = {"id": "den", "width": 10, "depth": 10}
SOFAS = {"room": ROOM, "pieces": [{"name": "sofa", "count": 24, "relations": [{"type": "near", "of": "sofa"}]}], "alternatives": 16}
CHAIR = {"name": "chair", "width": 0.5, "depth": 0.5, "height": 0.9}
CHAIRS = [{**CHAIR, "x": 1 + k % 7 / 9, "z": 1 + k % 5 / 7} for k in range(40)]
CROWD = {"scene": {"rooms": [{**ROOM, "width": 3, "depth": 3, "furniture": CHAIRS}]}}
"""Chairs upon one another, more than the room has floor for."""
EMPTY = {
    "scene": {"rooms": [{**ROOM, "id": f"room_{k}", "type": "living_room", "width": 5.0 + k, "depth": 6} for k in range(6)]},
    "seed": 1,
}
HEAVY = [("place", SOFAS), ("fix", CROWD), ("furnish", EMPTY), ("generate", {**EMPTY, "reroll": [f"room_{k}" for k in range(6)]})]


def answered(call: str, body: dict[str, Any], terms: Terms = TERMS) -> dict[str, Any]:
    with on_terms(terms):
        answer = CALLS[call](body, load_catalogs())
    return {key: value for key, value in answer.items() if key != "timing_ms"}


@pytest.mark.parametrize(("call", "body"), HEAVY, ids=[call for call, _ in HEAVY])
def test_the_limit_ends_the_search_says_so_and_gives_the_same_bytes(call: str, body: dict[str, Any]) -> None:
    terms = Terms(work=3000)
    first = answered(call, body, terms)
    assert first["limited"]["effort"] == "normal"
    assert first["limited"]["work"] == 3000
    assert "effort thorough" in first["limited"]["message"]
    assert json.dumps(answered(call, body, terms)) == json.dumps(first)


def place_sofas() -> None:
    asked = read(PlaceBody, SOFAS)
    place(asked.room, asked.pieces, alternatives=asked.alternatives)


def fix_crowd() -> None:
    fix(read_scene(CROWD["scene"]))


@pytest.mark.parametrize("call", [place_sofas, fix_crowd])
def test_no_call_works_much_longer_than_its_limit(call: Callable[[], None]) -> None:
    for most in (TERMS.work, 10 * TERMS.work):
        with work_of_call(most) as counted:
            call()
        assert most <= counted.done < most + OVERSHOOT


def judged(room: dict[str, Any], judging: float = USUAL.judging, call: str = "validate", wanted: str = "json") -> Response:
    """Returns what the service answers to a scene of one room."""
    body = json.dumps({"scene": {"rooms": [{"id": "a", "width": 1000.0, "depth": 1000.0, **room}]}}).encode()
    done = do(Job(call, body, "json", wanted, mark_of(packed(load_catalogs())), Terms(judging=judging)))
    assert isinstance(done, Response)
    return done


def upon_one_another(number: int) -> dict[str, Any]:
    return {"furniture": [{**CHAIR, "x": 5, "z": 5}] * number}


def comb(teeth: int) -> dict[str, Any]:
    """An outline with teeth to the north."""
    ends = [k / 10 for k in range(teeth)]
    points = [p for x in ends for p in ([x, 1], [x + 0.05, 1], [x + 0.05, 500], [x + 0.1, 500])]
    return {"outline": [[0, 500], *points, [1000, 500], [1000, 999], [0, 999]]}


def test_what_breaks_the_rules_too_often_is_refused_before_it_is_told() -> None:
    refused = judged(upon_one_another(2000))
    assert refused.status_code == 422
    told = json.loads(bytes(refused.body))
    assert (told["title"], told["errors"][0]["field"]) == ("The work is too much", "scene")
    answer = judged(upon_one_another(100))
    assert answer.status_code == 200
    assert sum(issue["rule"] == "overlap" for issue in json.loads(bytes(answer.body))["issues"]) == 100 * 99 / 2


def test_an_outline_counts_by_its_boxes_and_not_by_its_corners_squared() -> None:
    assert judged(comb(400), judging=16_000).status_code == 200
    assert judged(comb(400), judging=400, call="floor").status_code == 422


def test_a_greater_effort_does_more() -> None:
    quick, normal = (answered("place", {**SOFAS, "effort": effort}, Terms(work=20_000)) for effort in ("quick", "normal"))
    assert len(quick["alternatives"]) <= len(normal["alternatives"])
    assert (quick["limited"]["work"], normal["limited"]["work"]) == (2000, 20_000)


def test_what_ends_by_itself_says_nothing() -> None:
    small = {"room": ROOM, "pieces": [{"name": "sofa"}]}
    assert "limited" not in answered("place", small, Terms())


def test_more_than_the_service_allows_is_refused() -> None:
    with on_terms(Terms(most="normal")), pytest.raises(FieldError) as refused, limited_to("thorough"):
        pass
    assert refused.value.field == "effort"
    assert refused.value.allowed == "quick, normal"
    assert list(EFFORTS) == ["quick", "normal", "thorough"]


@pytest.mark.parametrize("format", ["png", "nav2"])
def test_maps_count_by_their_cells(format: str) -> None:
    assert judged({"width": 5.0, "depth": 5.0}, judging=200_000, call="export", wanted=format).status_code == 200
    refused = judged({}, call="export", wanted=format)
    assert (refused.status_code, json.loads(bytes(refused.body))["title"]) == (422, "The work is too much")


TABLE = {"name": "dining_table", "width": 0.5, "depth": 0.5, "height": 0.9}
SHELF = {"name": "bookshelf", "width": 1.0, "depth": 1.0, "height": 0.9}


def removed(rooms: list[dict[str, Any]]) -> dict[str, Any]:
    return answered("fix", {"scene": {"rooms": rooms}, "on_conflict": "remove"}, Terms())


def test_what_would_help_is_sought_among_the_pieces_of_a_conflict_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """More than a thousand trials in a heap of 120: each told all the heap anew, 136,600 pieces."""
    told, tell, draw = [0], as_sent._piece, random.Random(2)

    def counted(*given: Any) -> Piece:
        told[0] += 1
        return tell(*given)

    monkeypatch.setattr(as_sent, "_piece", counted)
    heap = [{**TABLE, "x": 6, "z": 3, "locked": draw.random() < 0.4} for _ in range(120)]
    removed([{"id": "den", "type": "living_room", "width": 12, "depth": 6, "furniture": heap}])
    assert 120 < told[0] < 20_000


def test_a_house_of_many_bodies_is_judged_without_one_and_another_less_often(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each time all of it is walked through: 630,465 bodies where rooms alone were counted."""
    judged, judge, draw = list[int](), Checked.after, random.Random(1)

    def counted(house: Checked, scene: Scene) -> Checked:
        judged.append(sum(len(room.furniture) for room in scene.rooms))
        return judge(house, scene)

    monkeypatch.setattr(Checked, "after", counted)
    spread = [[{**SHELF, "x": round(draw.uniform(0, 12), 3), "z": round(draw.uniform(0, 6), 3)} for _ in range(40)] for _ in range(64)]
    rooms = [
        {"id": f"r{k}", "type": "dining_room", "width": 12, "depth": 6, "x": 12 * (k % 8), "z": 6 * (k // 8), "furniture": heap}
        for k, heap in enumerate(spread)
    ]
    removed(rooms)
    assert max(judged) > 2000
    assert sum(judged) < 2 * LEAVING_WORK / WALKED_WORK + 4 * max(judged)
