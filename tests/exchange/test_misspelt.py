"""Keys that are nearly known ones are told where a scene keeps them, and kept."""

from __future__ import annotations

import json
from typing import Any

import pytest

from solver import generate
from solver.exchange import misspelt, read_scene, write_scene
from solver.request import Request
from tests.imports.plans import read

ROOM: dict[str, Any] = {"id": "a", "width": 4.0, "depth": 3.0}
DOOR: dict[str, Any] = {"id": "d", "kind": "door", "wall": "north", "position": 1.0}


@pytest.mark.parametrize(("room", "told"), [
    ({"openigns": []}, {"rooms[0].openigns": "openings"}),
    ({"Flooring": {}}, {"rooms[0].Flooring": "flooring"}),
    ({"openings": [{**DOOR, "connectsTo": "EXTERIOR", "hieght": 2.0}]},
     {"rooms[0].openings[0].connectsTo": "connects_to", "rooms[0].openings[0].hieght": "height"}),
    ({"name": "Küche", "notes": "sunny", "colour_scheme": 3}, {}),
])  # fmt: skip
def test_a_key_that_is_nearly_known_is_told_and_kept(room: dict[str, Any], told: dict[str, str]) -> None:
    document = {"rooms": [{**ROOM, **room}]}
    scene = read_scene(document)
    assert misspelt(scene) == told
    (kept,) = json.loads(json.dumps(write_scene(scene)))["rooms"]
    assert all(key in kept for key in room)
    unread = read(document).unread
    assert [(one["place"], one["reason"]) for one in unread] == [
        (place.rpartition(".")[0], f"no property is called {place.rpartition('.')[2]!r}; {meant}?") for place, meant in told.items()
    ]


def test_what_we_write_ourselves_has_no_such_key() -> None:
    assert misspelt(read_scene(write_scene(generate(Request(program="studio", seed=3)).scene))) == {}


def test_no_more_are_told_than_one_reads() -> None:
    rooms = [{**ROOM, "id": str(at), "levle": 0} for at in range(300)]
    assert len(misspelt(read_scene({"rooms": rooms}))) == 20
