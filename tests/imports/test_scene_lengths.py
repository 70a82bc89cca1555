"""Scenes that others wrote in centimetres, millimetres or inches come in as large as they are, and it is said."""

from __future__ import annotations

import json
from typing import Any

import pytest

from solver.errors import FieldError
from tests.imports.plans import read

ROOM: dict[str, Any] = {"id": "a", "type": "bedroom", "width": 4.0, "depth": 3.5}
DOOR: dict[str, Any] = {"id": "front", "wall": "south", "position": 3.2, "width": 0.9, "height": 2.1, "connects_to": "EXTERIOR"}
BED: dict[str, Any] = {"id": "bed", "name": "bed", "x": 1.0, "z": 1.1, "width": 1.6, "depth": 2.0, "height": 0.5, "rotation": 0}


def scene(scale: float, *, doors: bool = True, **more: Any) -> bytes:
    """A bedroom and an L beside it, in a unit of which a metre is so many."""

    def grown(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: one if key in ("rotation", "level") else grown(one) for key, one in value.items()}
        return [grown(one) for one in value] if isinstance(value, list) else value * scale if isinstance(value, float) else value

    ell = {"id": "b", "type": "kitchen", "x": 4.0, "width": 4.0, "depth": 4.0, "outline": [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0],
                                                                                            [2.0, 4.0], [0.0, 4.0]]}  # fmt: skip
    rooms = [{**ROOM, "openings": [DOOR] if doors else [], "furniture": [BED]}, ell]
    return json.dumps(grown({"wall_thickness": 0.12, "rooms": rooms, **more})).encode()


@pytest.mark.parametrize(
    ("unit", "scale", "doors"),
    [("cm", 100.0, True), ("mm", 1000.0, True), ("in", 1 / 0.0254, True), ("cm", 100.0, False), ("mm", 1000.0, False)],
)
def test_the_unit_is_told_by_doors_else_by_rooms_and_said(unit: str, scale: float, doors: bool) -> None:
    answer, wanted = read(scene(scale, doors=doors), "home.json"), read(scene(1.0, doors=doors), "home.json")
    assert answer.scene.rooms == wanted.scene.rooms
    assert answer.scene.wall_thickness == 0.12
    (told,) = [one for one in answer.guesses if one["what"] == "unit"]
    assert told["taken"] == unit
    assert ("doors' median width would be" if doors else "rooms' median side is") in str(told["message"])
    assert not [one for one in wanted.guesses if one["what"] == "unit"]


def test_the_caller_may_say_the_unit_and_one_that_nothing_tells_is_asked_for() -> None:
    assert read(scene(10.0), "home.json", unit="0.1").scene.rooms == read(scene(1.0), "home.json").scene.rooms
    with pytest.raises(FieldError, match="unit"):
        read(scene(1e6, doors=False), "home.json")
