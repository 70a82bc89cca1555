"""A house whose outline is given: its rooms tile it, whatever its form; what is no outline is refused in words."""

from __future__ import annotations

import random

import pytest

from solver import Request, generate
from solver.errors import FieldError
from solver.exchange import read_request
from solver.floorplan.given import parts_of
from solver.geometry import Rect
from tests.every import every

LEAST = 2_000
FORMS: dict[str, list[tuple[float, float]]] = {
    "L": [(0, 0), (10, 0), (10, 6), (6, 6), (6, 12), (0, 12)],
    "U, counter-clockwise": [(0, 10), (4.5, 10), (4.5, 5), (10.5, 5), (10.5, 10), (15, 10), (15, 0), (0, 0)],
    "cross, away from the origin": [(5, -3), (9, -3), (9, 0), (14, 0), (14, 8), (9, 8), (9, 12), (5, 12), (5, 8), (0, 8), (0, 0), (5, 0)],
    "with corners that are none": [(0, 0), (5, 0), (8, 0), (8, 0), (8, 7), (0, 7), (0, 2)],
}


def area_of(corners: list[tuple[float, float]]) -> float:
    pairs = zip(corners, [*corners[1:], corners[0]], strict=True)
    return abs(sum(x * next_z - next_x * z for (x, z), (next_x, next_z) in pairs)) / 2


def stairs(seed: int) -> list[tuple[float, float]]:
    """Columns side by side, each 2 to 5 m wide, all of them across z = 0: an outline with up to eight inner corners."""
    draw = random.Random(seed)
    x = 0.0
    tops: list[tuple[float, float]] = []
    feet: list[tuple[float, float]] = []
    for _ in range(draw.randint(1, 5)):
        wide, north, south = draw.randint(40, 100) / 20, -draw.randint(40, 120) / 20, draw.randint(40, 120) / 20
        tops += [(x, north), (x + wide, north)]
        feet += [(x, south), (x + wide, south)]
        x += wide
    return tops + feet[::-1]


def share_floor(one: Rect, other: Rect) -> bool:
    return one.x0 < other.x1 and other.x0 < one.x1 and one.z0 < other.z1 and other.z0 < one.z1


@every("seed", range(60))
def test_parts_tile_the_outline(seed: int) -> None:
    corners = stairs(seed)
    parts = [part.rect for part in parts_of(corners, LEAST)]
    assert sum(rect.width * rect.depth for rect in parts) == round(area_of(corners) * 1e6)
    assert not any(share_floor(one, other) for at, one in enumerate(parts) for other in parts[:at])
    assert all(min(rect.width, rect.depth) >= LEAST for rect in parts)
    assert (min(rect.x0 for rect in parts), min(rect.z0 for rect in parts)) == (0, 0)


@pytest.mark.parametrize("name", FORMS)
@pytest.mark.parametrize("seed", [1, 2])
def test_a_home_fills_its_outline(name: str, seed: int) -> None:
    answer = generate(Request(seed=seed, outline=tuple(FORMS[name])))
    rooms = answer.scene.rooms
    assert sum(room.width * room.depth for room in rooms) == pytest.approx(area_of(FORMS[name]))
    assert [issue for issue in answer.issues if issue.severity == "error"] == []
    assert [one.id for room in rooms for one in room.openings if one.main_entrance]
    assert [one for room in rooms for one in room.openings if one.kind == "window"]


def test_the_same_outline_and_seed_give_the_same_home() -> None:
    first, second = (generate(Request(seed=3, outline=tuple(FORMS["L"]))).scene for _ in range(2))
    turned = generate(Request(seed=3, outline=tuple(FORMS["L"][2:] + FORMS["L"][:2]))).scene
    assert first == second
    assert first.rooms == turned.rooms


REFUSED = {
    "slanted": ([[0, 0], [9, 0], [9, 5], [1, 6]], "slanted edge from"),
    "crossing": ([[0, 0], [5, 0], [5, 5], [2, 5], [2, -4], [0, -4]], "crosses or touches itself"),
    "touching": ([[0, 0], [12, 0], [12, 4], [4, 4], [4, 8], [8, 8], [8, 4], [6, 4], [6, 12], [0, 12]], "crosses or touches itself"),
    "no floor": ([[0, 0], [4, 0], [4, 0], [0, 0]], "encloses no floor"),
    "a narrow arm": ([[0, 0], [10, 0], [10, 2], [5, 2], [5, 8], [0, 8]], "a part that is 2 m wide"),
    "too long": ([[0, 0], [200, 0], [200, 4], [0, 4]], "is 200 m long"),
    "three corners": ([[0, 0], [4, 0], [4, 4]], "has 3 entries"),
    "many corners": ([[0, 0]] * 25, "has 25 entries"),
    "no numbers": ([[0, 0], [1, "a"], [4, 4], [0, 4]], "a number from"),
    "far away": ([[0, 0], [1e9, 0], [1e9, 4], [0, 4]], "a number from"),
    "another word": ("X", "rectangle, L, T, U, any or a list"),
    "a number": (7, "rectangle, L, T, U, any or a list"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_no_outline_is_refused_in_words(name: str) -> None:
    outline, words = REFUSED[name]
    with pytest.raises(FieldError, match=words):
        generate(read_request({"seed": 1, "outline": outline}))


@pytest.mark.parametrize("beside", [{"area": 80}, {"area": 80, "program": "family"}, {"width": 10}, {"program": "family", "depth": 10}])
def test_corners_stand_alone(beside: dict[str, object]) -> None:
    with pytest.raises(FieldError, match="beside"):
        generate(read_request({"seed": 1, "outline": FORMS["L"], **beside}))
