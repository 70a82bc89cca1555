"""A programme in an outline that is given: the rooms cover it and nothing else, and are a home; what holds none is refused in words."""

from __future__ import annotations

import random

import pytest

from catalogs import load_catalogs
from solver import Request, generate
from solver.errors import RequestError
from solver.floorplan import FloorPlan, draw
from tests.floorplan import checks, homes
from tests.sweeps import ALL

CATALOGS = load_catalogs()
Corners = list[tuple[float, float]]
FORMS: dict[str, tuple[str, ...]] = {
    "rectangle": ("###", "###"),
    "L": ("#..", "###"),
    "T": ("###", ".#."),
    "U": ("#.#", "###"),
    "Z": ("##.", ".##"),
    "plus": (".#.", "###", ".#."),
    "steps": ("#..", "##.", "###"),
}
"""Outlines as cells of a grid."""
FLOORS = {"studio": 42, "one_bed": 70, "family": 135, "large": 205}
"""Floors that suit the presets, m2."""


def lines(count: int, stream: random.Random) -> list[float]:
    found = [0.0]
    for _ in range(count):
        found.append(found[-1] + stream.uniform(3, 5))
    return found


def outline(form: str, floor: float, seed: int) -> tuple[Corners, set[tuple[int, int]], list[float], list[float]]:
    """Corners of an outline of a form and about so much floor, with the cells and lines it is made of, on 5 cm, m."""
    rows, stream = FORMS[form], random.Random(f"{form} {seed}")
    xs, zs = lines(len(rows[0]), stream), lines(len(rows), stream)
    cells = {(i, j) for j, row in enumerate(rows) for i, cell in enumerate(row) if cell == "#"}
    area = sum((xs[i + 1] - xs[i]) * (zs[j + 1] - zs[j]) for i, j in cells)
    scale = (floor / area) ** 0.5
    xs, zs = ([round(line * scale * 20) / 20 for line in part] for part in (xs, zs))
    ways: dict[tuple[int, int], tuple[int, int]] = {}
    for i, j in cells:
        square = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
        beyond = [(i, j - 1), (i + 1, j), (i, j + 1), (i - 1, j)]
        ways |= {start: end for start, end, other in zip(square, [*square[1:], square[0]], beyond, strict=True) if other not in cells}
    path = [min(ways)]
    while ways[path[-1]] != path[0]:
        path.append(ways[path[-1]])
    return [(xs[i], zs[j]) for i, j in path], cells, xs, zs


def covers(plan: FloorPlan, cells: set[tuple[int, int]], xs: list[float], zs: list[float]) -> bool:
    """Whether every point of a lattice of 5 cm lies in exactly one room inside the outline, in none outside."""
    count = [[0] * round(xs[-1] * 20) for _ in range(round(zs[-1] * 20))]
    for room in plan.rooms:
        for row in count[round(room.z * 20) : round((room.z + room.depth) * 20)]:
            for k in range(round(room.x * 20), round((room.x + room.width) * 20)):
                row[k] += 1
    for i, j in cells:
        for row in count[round(zs[j] * 20) : round(zs[j + 1] * 20)]:
            for k in range(round(xs[i] * 20), round(xs[i + 1] * 20)):
                row[k] -= 1
    return not any(any(row) for row in count)


CASES = [(program, form) for i, program in enumerate(FLOORS) for j, form in enumerate(FORMS) if ALL or (i + j) % len(FLOORS) == 0]


@pytest.mark.parametrize(("program", "form"), CASES)
def test_a_programme_fills_a_given_outline(program: str, form: str) -> None:
    """All rooms on the ground asked for, entered as in other planned homes, the way in at the street."""
    corners, cells, xs, zs = outline(form, FLOORS[program], 1)
    plan = draw(Request(seed=1, program=program, outline=tuple(corners)), CATALOGS)
    assert covers(plan, cells, xs, zs)
    assert checks.sound(plan.rooms, xs[-1], zs[-1], bent=True) == []
    assert homes.violations(plan.rooms) == []
    ((_, door),) = checks.entrances(plan.rooms)
    assert door.wall == "south"
    lit = [room for room in plan.rooms if CATALOGS.rooms[room.type].plan.habitable]
    assert [room.id for room in lit if not any(one.kind == "window" for one in room.openings)] == []


@pytest.mark.parametrize("form", ["L", "U", "plus"])
def test_a_furnished_home_in_a_given_outline_is_clean(form: str) -> None:
    corners, cells, xs, zs = outline(form, FLOORS["family"], 3)
    answer = generate(Request(seed=3, program="family", outline=tuple(corners)))
    assert [issue for issue in answer.issues if issue.severity == "error"] == []
    floor = sum((xs[i + 1] - xs[i]) * (zs[j + 1] - zs[j]) for i, j in cells)
    assert sum(room.width * room.depth for room in answer.scene.rooms) == pytest.approx(floor)


def test_a_given_outline_lies_as_it_was_given() -> None:
    """The first corner may be any, the way round too."""
    corners = outline("L", FLOORS["one_bed"], 1)[0]
    paths = (corners, corners[2:] + corners[:2], corners[::-1])
    plans = [draw(Request(seed=5, program="one_bed", outline=tuple(path)), CATALOGS) for path in paths]
    assert plans[0].rooms == plans[1].rooms == plans[2].rooms


def test_rooms_left_out_for_want_of_space_are_named() -> None:
    corners = outline("L", 90, 1)[0]
    plan = draw(Request(seed=1, program="large", outline=tuple(corners)), CATALOGS)
    assert any("left out, for want of space in the outline's" in note for note in plan.notes)


HOPELESS: dict[str, tuple[Corners, str, str]] = {
    "narrow": ([(0, 0), (6, 0), (6, 1), (1, 1), (1, 6), (0, 6)], "family", "a part that is 1 m wide"),
    "small": (
        [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)],
        "family",
        r"holds no home of this program in 12 m2, its narrowest part 2 m",
    ),
    "many parts": (
        [(x, z) for k in range(9) for x, z in ((k * 5.0, k % 2 * 2.0), (k * 5.0 + 5, k % 2 * 2.0))] + [(45.0, 9.0), (0.0, 9.0)],
        "studio",
        "rectangles",
    ),
}


@pytest.mark.parametrize("name", HOPELESS)
def test_an_outline_that_holds_no_home_is_refused_in_words(name: str) -> None:
    corners, program, words = HOPELESS[name]
    with pytest.raises(RequestError, match=words):
        draw(Request(seed=1, program=program, outline=tuple(corners)), CATALOGS)
