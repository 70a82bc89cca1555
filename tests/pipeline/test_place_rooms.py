"""Fifty rooms of five types, as users might send them: they can be walked; what can be held is held, by an exact oracle's count."""

from __future__ import annotations

from typing import Any

import pytest

from catalogs import load_catalogs
from service.contract import PlaceBody
from solver import place
from solver.exchange import read
from solver.requested import Placement
from tests.place_oracle import Oracle
from tests.place_rooms import TYPES, place_request
from tests.sweeps import seeds

CATALOGS = load_catalogs()
KINDS = {name: (entry.size, entry.stands) for name, entry in CATALOGS.furniture.items()}
USE = {name: (entry.use.sides, entry.use.need == "all") for name, entry in CATALOGS.furniture.items() if entry.use}
SEEDS = seeds(range(50), 2)
SECONDS = 600.0
"""A guard against an oracle that never answers, by the clock; it needs up to four."""


@pytest.fixture(scope="module")
def rooms() -> list[tuple[dict[str, Any], Placement]]:
    found = []
    for seed in SEEDS:
        request = place_request(seed)
        body = read(PlaceBody, request)
        answer = place(body.room, body.pieces, wall_thickness=body.wall_thickness, catalogs=CATALOGS)
        found.append((request, answer.best))
    return found


def test_the_rooms_are_of_every_sort(rooms: list[tuple[dict[str, Any], Placement]]) -> None:
    requests = [request for request, _ in rooms]
    assert {request["room"]["type"] for request in requests} == set(TYPES)
    assert {len(request["pieces"]) for request in requests} >= {5, 6, 7, 8, 9, 11}
    assert all(sum(opening["kind"] == "door" for opening in request["room"]["openings"]) == 2 for request in requests)
    numbers = [len(piece["relations"]) for request in requests for piece in request["pieces"]]
    assert max(numbers) == 4
    assert sum(number >= 2 for number in numbers) >= 0.9 * len(numbers)


def test_every_piece_stands_and_every_room_can_be_walked(rooms: list[tuple[dict[str, Any], Placement]]) -> None:
    assert [entry for _, placement in rooms for entry in placement.unplaced] == []
    wrong = [issue for _, placement in rooms for issue in placement.issues if issue.severity == "error" or issue.rule == "unreachable"]
    assert wrong == []


def test_what_can_be_held_is_held(rooms: list[tuple[dict[str, Any], Placement]]) -> None:
    held = possible = 0
    for request, placement in rooms:
        own = sum(entry.held for entry in placement.relations)
        word, most = "solved", own
        if own < len(placement.relations):
            word, more, _ = Oracle(request, KINDS, USE).most(own, SECONDS)
            most = max(own, sum(more))
        assert word in ("solved", "infeasible"), request["room"]["id"]
        held, possible = held + own, possible + most
    assert possible > 16 * len(SEEDS)
    assert held >= 0.98 * possible, f"{held} of {possible}"


def test_the_oracle_does_not_hold_what_cannot_be() -> None:
    pieces = [
        {"id": name, "name": "crate", "width": 0.5, "depth": 0.5, "height": 0.5, "relations": [{"type": "in_corner"}]} for name in "abcde"
    ]
    request = {"room": {"width": 4.0, "depth": 4.0, "openings": []}, "pieces": pieces}
    assert Oracle(request, {}, {}).most(4, SECONDS)[0] == "infeasible"
    word, more, _ = Oracle(request, {}, {}).most(3, SECONDS)
    assert (word, sum(more)) == ("solved", 4)
    far = [{**pieces[0], "relations": []}, {**pieces[1], "relations": [{"type": "far_from", "of": "a", "distance": 6.0}]}]
    assert Oracle({**request, "pieces": far}, {}, {}).most(0, SECONDS)[0] == "infeasible"


def _wish(type: str, of: str | None = None, **more: Any) -> dict[str, Any]:
    return {"type": type, **({"of": of} if of else {}), **more}


def test_a_lamp_keeps_its_table_from_the_window() -> None:
    """It reaches above the sill: its table has to stand elsewhere, with the sofa and all that goes with that, which come before it."""
    at_table = [_wish("facing", "coffee"), _wish("near", "coffee", distance=1.0)]
    wishes: list[tuple[str, str, list[float], int, list[dict[str, Any]]]] = [
        ("sofa", "sofa", [2.2, 0.9, 0.85], 1, [_wish("facing", "stand")]),
        ("stand", "tv_stand", [1.5, 0.4, 0.5], 1, [_wish("against_wall"), _wish("opposite", "sofa")]),
        ("tv", "tv", [1.24, 0.14, 0.74], 1, [_wish("on", "stand")]),
        ("coffee", "coffee_table", [1.1, 0.6, 0.42], 1, [_wish("in_front_of", "sofa", gap=[0.3, 0.6])]),
        ("one", "armchair", [0.82, 0.82, 0.85], 1, at_table),
        ("lamp", "floor_lamp", [0.36, 0.36, 1.6], 1, [_wish("near", "sofa", distance=0.6), _wish("in_corner")]),
        ("desk", "desk", [1.2, 0.6, 0.75], 1, [_wish("against_wall")]),
        ("chair", "office_chair", [0.6, 0.6, 1.0], 1, [_wish("under", "desk")]),
        ("other", "armchair", [0.82, 0.82, 0.85], 1, at_table),
        ("palm", "plant", [0.4, 0.4, 1.2], 1, [_wish("in_corner")]),
        ("side", "side_table", [0.46, 0.46, 0.55], 1, [_wish("beside", "sofa")]),
        ("fern", "plant", [0.4, 0.4, 1.2], 1, [_wish("near", "window", distance=1.2)]),
        ("shelf", "bookshelf", [1.0, 0.3, 1.8], 2, [_wish("against_wall"), _wish("far_from", "window", distance=0.4)]),
        ("pouf", "ottoman", [0.45, 0.45, 0.4], 1, [_wish("near", "one", distance=0.5)]),
        ("small", "table_lamp", [0.25, 0.25, 0.45], 1, [_wish("on", "side")]),
    ]
    door = {
        "kind": "door",
        "wall": "north",
        "position": 0.6,
        "width": 0.85,
        "height": 2.05,
        "connects_to": "EXTERIOR",
        "main_entrance": True,
    }
    window = {"kind": "window", "wall": "east", "position": 1.04, "width": 1.6, "height": 1.2, "sill": 0.9, "connects_to": "EXTERIOR"}
    asked = [
        {"id": name, "name": kind, "width": w, "depth": d, "height": h, "count": count, "relations": relations}
        for name, kind, (w, d, h), count, relations in wishes
    ]
    body = read(PlaceBody, {"room": {"id": "room", "width": 5.44, "depth": 3.89, "openings": [door, window]}, "pieces": asked})
    found = place(body.room, body.pieces, catalogs=CATALOGS).best
    assert [(one.piece, one.type) for one in found.relations if not one.held] == []
    assert found.unplaced == ()
