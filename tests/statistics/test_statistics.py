"""Statistics against figures added up anew from the finished scenes, by plane geometry and counting of their own."""

from __future__ import annotations

import json
from collections import Counter, defaultdict
from dataclasses import replace
from functools import cache
from itertools import permutations
from typing import Any

import numpy as np
import pytest

from catalogs import load_catalogs
from service.many import survey
from solver import generate
from solver.answers import Issue
from solver.exchange import write_scene
from solver.request import Request
from solver.statistics import House, house_of, summary
from solver.statistics.house import graph_signature, room_signature
from solver.statistics.summary import spread
from solver.validator import RULES, metrics

SEEDS = range(5, 9)
ASKED = {"program": "one_bed", "decorate": True, "outdoor": True}
CELL_MM = 5


@cache
def scenes() -> tuple[dict[str, Any], ...]:
    """Finished homes as documents."""
    made = [generate(Request(seed=seed, program="one_bed", decorate=True, outdoor=True)) for seed in SEEDS]
    return tuple(json.loads(json.dumps(write_scene(one.scene))) for one in made)


@cache
def found() -> dict[str, Any]:
    """Statistics of the same homes."""
    document = survey([{**ASKED, "seed": SEEDS[0]}], len(SEEDS), 1, load_catalogs())
    return dict(document["sets"][0])


def rooms_by_type() -> dict[str, list[dict[str, Any]]]:
    rooms: dict[str, list[dict[str, Any]]] = defaultdict(list)
    for scene in scenes():
        for room in scene["rooms"]:
            rooms[room["type"]].append({**room, "alive": [one for one in scene["dynamic"] if one["room"] == room["id"]]})
    return rooms


def painted(room: dict[str, Any]) -> float:
    """Share of a room's rectangle under pieces on the floor, on a raster."""
    floor = np.zeros((round(room["width"] * 1000 / CELL_MM), round(room["depth"] * 1000 / CELL_MM)), dtype=bool)
    for piece in room["furniture"]:
        if piece["y"] > 0:
            continue
        along, across = (piece["width"], piece["depth"]) if piece["rotation"] % 180 == 0 else (piece["depth"], piece["width"])
        west, east = (round((piece["x"] + side * along / 2) * 1000 / CELL_MM) for side in (-1, 1))
        north, south = (round((piece["z"] + side * across / 2) * 1000 / CELL_MM) for side in (-1, 1))
        floor[west:east, north:south] = True
    return float(floor.mean())


def spread_of(values: list[float]) -> dict[str, float]:
    low, middle, high = np.percentile(values, [10, 50, 90])
    return {"p10": low, "median": middle, "p90": high, "mean": float(np.mean(values))}


def test_rooms_are_counted_and_measured() -> None:
    expected = rooms_by_type()
    assert list(found()["rooms"]) == sorted(expected)
    for name, rooms in expected.items():
        shown = found()["rooms"][name]
        assert shown["count"] == len(rooms)
        assert shown["per_home"] == len(rooms) / len(SEEDS)
        assert shown["area"] == pytest.approx(spread_of([room["width"] * room["depth"] for room in rooms]), abs=1e-3)
        assert shown["cover"] == pytest.approx(spread_of([painted(room) for room in rooms]), abs=6e-3)
        assert shown["pieces"] == pytest.approx(spread_of([len(room["furniture"]) for room in rooms]), abs=1e-3)
        assert shown["decorations"] == pytest.approx(spread_of([len(room["decorations"]) for room in rooms]), abs=1e-3)
        together: list[float] = [len(room["furniture"]) + len(room["decorations"]) for room in rooms]
        assert shown["together"] == pytest.approx(spread_of(together), abs=1e-3)
        assert shown["people"] == pytest.approx(sum(len(room["alive"]) for room in rooms) / len(rooms), abs=1e-3)
        alike = Counter(tuple(sorted((piece["name"], str(piece["wall"])) for piece in room["furniture"])) for room in rooms)
        assert (shown["signatures"], shown["most_alike"]) == (len(alike), max(alike.values()))


def test_homes_are_counted_and_measured() -> None:
    home = found()["home"]
    indoor = [[room for room in scene["rooms"] if not room["outdoor"]] for scene in scenes()]
    floors = [sum(room["width"] * room["depth"] for room in rooms) for rooms in indoor]
    assert home["floor"] == pytest.approx(spread_of(floors), abs=1e-3)
    halls = [sum(room["width"] * room["depth"] for room in rooms if room["type"] == "hallway") for rooms in indoor]
    assert home["hallway"] == pytest.approx(spread_of([hall / floor for hall, floor in zip(halls, floors, strict=True)]), abs=1e-3)
    assert home["pieces"]["mean"] == pytest.approx(np.mean([scene["certificate"]["counts"]["furniture"] for scene in scenes()]))
    assert home["windows"]["mean"] == pytest.approx(np.mean([scene["certificate"]["counts"]["windows"] for scene in scenes()]))
    kinds = [[one["kind"] for one in scene["dynamic"]] for scene in scenes()]
    assert home["people"]["mean"] == np.mean([names.count("person") for names in kinds])
    assert home["pets"]["mean"] == np.mean([len(names) - names.count("person") for names in kinds])
    assert found()["shares"]["with_pet"] == np.mean([any(name != "person" for name in names) for names in kinds])
    assert found()["styles"] == Counter(scene["request"]["style"] for scene in scenes())
    left_out = sum(len(room["left_out"]) for scene in scenes() for room in scene["certificate"]["rooms"].values())
    assert sum(found()["left_out"].values()) == left_out > 0


@cache
def house(seed: int) -> House:
    made = generate(Request(seed=seed, width=9.0, depth=8.0))
    return house_of(made.scene, made.issues, metrics(made.scene, load_catalogs()))


def test_errors_and_warnings_are_counted_by_rule_and_listed_with_their_seeds() -> None:
    clean, broken = replace(house(3), issues=()), house(4)
    room = broken.rooms[0]
    issues = (
        Issue("missing_required", "warning", None, (), 0.0, "no bed"),
        Issue("overlap", "error", None, ("a", "b"), 0.1, "a and b"),
        Issue("overlap", "error", None, ("a", "c"), 0.1, "a and c"),
    )
    broken = replace(broken, issues=issues, rooms=(replace(room, missing=2), *broken.rooms[1:]))
    shown = summary([clean, clean, broken], RULES)
    assert list(shown["rules"]) == list(RULES)
    assert shown["rules"]["overlap"] == {"issues": 2, "houses": 1}
    assert shown["rules"]["missing_required"] == {"issues": 1, "houses": 1}
    assert shown["rules"]["wall_far"] == {"issues": 0, "houses": 0}
    assert [(issue["seed"], issue["message"]) for issue in shown["issues"]] == [(4, "a and b"), (4, "a and c"), (4, "no bed")]
    assert shown["shares"]["clean"] == shown["shares"]["complete"] == pytest.approx(2 / 3, abs=1e-4)
    assert shown["rooms"][room.type]["missing"] == 2
    assert shown["variety"] == {"adjacency": len({clean.adjacency, broken.adjacency}), "ways": len({clean.ways, broken.ways})}


def test_a_spread_is_the_percentiles() -> None:
    for values in ([3.0], [1.0, 2.0], [5.0, 1.0, 4.0, 2.5, 8.0, 0.5, 7.0]):
        assert spread(values) == pytest.approx(spread_of(values), abs=1e-4)


def test_graphs_are_the_same_whatever_their_nodes_are_called() -> None:
    labels = {"a": "hallway", "b": "bedroom", "c": "bedroom", "d": "bathroom"}
    edges = [("a", "b"), ("a", "c"), ("b", "d")]
    word = graph_signature(labels, edges)
    for names in permutations("wxyz"):
        new = dict(zip(labels, names, strict=True))
        renamed = [(new[other], new[one]) for one, other in reversed(edges)]
        assert graph_signature({new[name]: label for name, label in labels.items()}, renamed) == word
    assert graph_signature(labels, [("a", "b"), ("a", "c"), ("a", "d")]) != word
    assert graph_signature(labels, edges[:2]) != word
    assert graph_signature({**labels, "d": "office"}, edges) != word
    assert graph_signature(labels, [("a", "b"), ("a", "c"), ("c", "d")]) == word


def test_rooms_are_alike_if_their_pieces_stand_at_the_same_walls() -> None:
    furnished = [room for room in generate(Request(seed=3, width=9.0, depth=8.0)).scene.rooms if len(room.furniture) > 2]
    pieces = furnished[0].furniture
    word = room_signature(pieces)
    assert room_signature([replace(piece, x=piece.x + 0.1) for piece in reversed(pieces)]) == word
    assert room_signature([replace(pieces[0], wall="north" if pieces[0].wall != "north" else "south"), *pieces[1:]]) != word
    assert room_signature(pieces[1:]) != word
