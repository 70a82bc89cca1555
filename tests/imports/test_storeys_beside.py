"""Storeys drawn side by side in one drawing: each is a level of its own, by its title, else from left to right."""

from __future__ import annotations

import pytest

from solver.answers import PlanImport
from solver.errors import FieldError
from tests.imports.plans import read

UPPER = ("Bedroom", "Bathroom", "Office")
GROUND = ("Kitchen", "Living room", "Hall")


def storey(names: tuple[str, ...], x: float, title: str = "") -> str:
    """Rooms of 4 x 3 m in a row, doors between them and one to come in by, a title below."""
    made = f"<text x='{x + 2}' y='6'>{title}</text>"
    for at, name in enumerate(names):
        west = x + 4 * at
        made += f"<rect class='room' x='{west}' width='4' height='3'/><text x='{west + 1}' y='1'>{name}</text>"
        made += f"<line class='door' x1='{west}' y1='1' x2='{west}' y2='1.9'/>"
    return made


def drawn(body: str, **settings: object) -> PlanImport:
    return read(f"<svg xmlns='http://www.w3.org/2000/svg' data-unit='m'>{body}</svg>".encode(), "plan.svg", **settings)


def names(answer: PlanImport) -> tuple[str, ...]:
    return tuple(str(room.name) for room in sorted(answer.scene.rooms, key=lambda room: room.x))


@pytest.mark.parametrize(
    ("left", "right"), [("First floor", "Ground floor"), ("Obergeschoss", "GRUNDRISS ERDGESCHOSS"), ("2. OG", "Étage")]
)
def test_titles_tell_which_storey_is_which(left: str, right: str) -> None:
    both = storey(UPPER, 0, left) + storey(GROUND, 15, right)
    answer = drawn(both)
    assert names(answer) == GROUND
    assert [len(room.openings) for room in answer.scene.rooms] == [2, 2, 1]
    reasons = [str(one["reason"]) for one in answer.unread]
    assert reasons[0].startswith("lie in 2 groups apart from one another, or on layers of their own, which are taken as storeys")
    assert reasons[1:] == ["3 rooms left out: only level 0 was read; ask for level 1 to read this one"]
    assert [one["place"] for one in answer.unread] == ["rooms", f"level 1 ({left})"]
    above = drawn(both, level=1)
    assert names(above) == UPPER
    assert min(room.x for room in above.scene.rooms) == 0.0
    with pytest.raises(FieldError, match="2 has no rooms"):
        drawn(both, level=2)


@pytest.mark.parametrize("titles", [("", ""), ("Ground floor", ""), ("Ground floor", "Erdgeschoss")])
def test_without_titles_of_their_own_the_left_storey_is_the_lowest(titles: tuple[str, str]) -> None:
    assert names(drawn(storey(UPPER, 0, titles[0]) + storey(GROUND, 15, titles[1]))) == UPPER


@pytest.mark.parametrize(("second", "x"), [(("Garage", "Workshop"), 15), (GROUND, 12.9)])
def test_a_shed_and_what_lies_within_a_metre_are_on_the_same_storey(second: tuple[str, ...], x: float) -> None:
    answer = drawn(storey(UPPER, 0) + storey(second, x))
    assert len(answer.scene.rooms) == 3 + len(second)
    assert not answer.unread


@pytest.mark.parametrize(("low", "high"), [("EG", "OG"), ("ground floor", "Attic"), ("Level 1", "Level 2"), ("1F", "02F"), ("GF", "L3")])
def test_storeys_on_layers_of_their_own_lie_one_above_another(low: str, high: str) -> None:
    both = f"<g id='{high}'>{storey(UPPER, 0.5)}</g><g id='{low}'>{storey(GROUND, 0)}</g>"
    assert names(drawn(both)) == GROUND
    above = drawn(both, level=1)
    assert names(above) == UPPER
    assert [len(room.openings) for room in above.scene.rooms] == [2, 2, 1]
    few = f"<g id='{high}'>{storey(UPPER[:1], 0)}</g><g id='{low}'>{storey(GROUND, 0)}</g>"
    assert names(drawn(few, level=1)) == UPPER[:1]


def test_layers_of_storeys_that_lie_apart_are_left_where_they_are() -> None:
    answer = drawn(f"<g id='OG'>{storey(UPPER, 15)}</g><g id='EG'>{storey(GROUND, 0)}</g>", level=1)
    assert names(answer) == UPPER


def walls(x: float, width: float, *names: str) -> str:
    """Two rooms of a height of 3 m between walls that are single lines; texts in the first of them."""
    lines = [(x, 0, x + width, 0), (x, 3, x + width, 3), *((x + at, 0, x + at, 3) for at in (0, width / 2, width))]
    made = "".join(f"<line class='wall' x1='{x1}' y1='{y1}' x2='{x2}' y2='{y2}'/>" for x1, y1, x2, y2 in lines)
    return made + "".join(f"<text x='{x + 1}' y='1'>{name}</text>" for name in names)


SHED = "<path class='wall' d='M 14 3 V 0 H 12 V 3 {}'/><line class='door' x1='12.5' y1='3' x2='13.4' y2='3'/>"
LEAF = "<path class='door' d='M 1.5 3 A 0.9 0.9 0 0 0 2.4 2.1'/>"


@pytest.mark.parametrize(("plan", "beside", "left"), [
    (walls(0, 8, "Kitchen"), walls(12, 6), 2), (walls(0, 8) + LEAF, walls(12, 6, "SECTION A-A"), 2), (walls(0, 8), walls(12, 6), 4),
    (walls(0, 8, "Kitchen"), walls(12, 6, "Garage"), 4), (walls(0, 8) + LEAF, walls(12, 6, "Garage"), 4),
    (walls(0, 8, "Kitchen"), walls(12, 6, "9 m²"), 4), (walls(0, 8, "Kitchen"), SHED.format("H 12.5 M 13.4 3 H 14"), 3),
    (walls(0, 8, "Kitchen"), SHED.format("Z"), 2),
])  # fmt: skip
def test_what_stands_apart_without_a_name_or_a_door_is_a_view(plan: str, beside: str, left: int) -> None:
    answer = drawn(plan + beside)
    assert len(answer.scene.rooms) == left
    told = [one for one in answer.unread if "elevations" in str(one["reason"])]
    assert bool(told) == (left == 2)


@pytest.mark.parametrize(("outer", "left"), [("H 16.2 V 4.2 H 11.8 Z", 2), ("H 16.2 M 11.8 4.2 H 16.2 V -.2", 1), ("", 1)])
def test_what_has_walls_of_two_faces_all_around_is_no_view(outer: str, left: int) -> None:
    home = "<path class='wall' d='M 0 0 H 4 V 4 H 0 Z M -.2 -.2 H 4.2 V 4.2 H -.2 Z'/><text x='1' y='1'>Kitchen</text>"
    answer = drawn(f"{home}<path class='wall' d='M 12 0 H 16 V 4 H 12 Z M 11.8 -.2 {outer}'/>")
    assert len(answer.scene.rooms) == left
