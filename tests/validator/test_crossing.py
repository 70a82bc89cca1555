"""The rule `shapes_cross`: two bodies at the last millimetre that is right and the first that is wrong, and against the oracle."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest

from catalogs import load_catalogs
from solver.answers import Issue
from solver.scene import Decoration, Dynamic, Furniture, Room, Scene
from solver.validator import validate
from solver.validator.checking import check
from tests.every import every
from tests.oracles.crossing import crossings

KNOWN = load_catalogs()
TABLE = Furniture("t", "dining_table", x=3, z=3, width=1.6, depth=0.9, height=0.75)
CHAIR = Furniture("c", "dining_chair", x=3, z=3.5, rotation=180, width=0.46, depth=0.5, height=0.9, under="t")
INNER_FACE = 0.8 - 0.085 * 1.6
"""From the table's middle to the inner face of its legs, m."""


def scene(*furniture: Furniture, things: tuple[Decoration, ...] = (), people: tuple[Dynamic, ...] = ()) -> Scene:
    return Scene(rooms=(Room("r", width=6, depth=6, furniture=furniture, decorations=things),), dynamic=people)


def told(document: Scene) -> list[Issue]:
    return [issue for issue in validate(document, KNOWN) if issue.rule == "shapes_cross"]


@pytest.mark.parametrize("turn", [0, 90, 180, 270])
def test_a_chair_may_touch_a_tables_leg_by_two_millimetres(turn: int) -> None:
    across = INNER_FACE - 0.46 / 2

    def moved(by: float) -> Scene:
        dx, dz = across + by, 0.5
        x, z = {0: (dx, dz), 90: (dz, -dx), 180: (-dx, -dz), 270: (-dz, dx)}[turn]
        chair = replace(CHAIR, x=round(3 + x, 6), z=round(3 + z, 6), rotation=(180 + turn) % 360)
        return scene(replace(TABLE, rotation=turn), chair)

    assert told(moved(0.0)) == told(moved(0.002)) == []
    assert len(told(moved(0.0021))) == 1
    (issue,) = told(moved(0.003))
    assert (issue.severity, issue.room, issue.ids, issue.amount) == ("warning", "r", ("c", "t"), 0.003)
    assert issue.message == "c and t cross: a part of one is 0.3 cm deep in a part of the other"


def test_a_seat_goes_under_a_top_and_a_high_back_does_not() -> None:
    assert told(scene(TABLE, CHAIR)) == []
    (issue,) = told(scene(TABLE, replace(CHAIR, rotation=0)))
    assert issue.amount > 0.03


def test_what_stands_in_another_without_leave_is_told_once_by_overlap() -> None:
    found = validate(scene(TABLE, replace(CHAIR, x=3.5, under=None)), KNOWN)
    assert [issue.rule for issue in found if set(issue.ids) == {"c", "t"}] == ["overlap"]


def test_somebody_in_a_blanket_crosses_it_and_on_top_of_it_does_not() -> None:
    sofa = Furniture("s", "sofa", x=3, z=3, width=2.2, depth=0.9, height=0.85)
    blanket = Decoration("b", "throw_blanket", parent="s", x=3, y=0.45, z=3.1, width=0.6, depth=0.5, height=0.04)
    sitter = Dynamic("p", "person", "r", x=3, y=0.45, z=3.1, width=0.46, depth=0.5, height=0.9, on="s")
    (issue,) = told(scene(sofa, things=(blanket,), people=(sitter,)))
    assert issue.ids == ("b", "p")
    assert told(scene(sofa, things=(blanket,), people=(replace(sitter, y=0.49),))) == []


@pytest.mark.parametrize(("high", "count"), [(0.01, 0), (0.02, 0), (0.021, 1)])
def test_what_is_no_higher_than_2_cm_and_lies_on_the_floor_crosses_nothing(high: float, count: int) -> None:
    plinth = replace(TABLE, name="dresser", height=high)
    assert len(told(scene(plinth, replace(CHAIR, under="t")))) == count


def test_kinds_without_a_shape_are_passed_over() -> None:
    assert told(scene(replace(TABLE, name="unheard_of"), replace(CHAIR, x=3.5))) == []


def test_a_changed_room_is_judged_anew() -> None:
    before = check(scene(TABLE, CHAIR), KNOWN)
    after = before.after(scene(TABLE, replace(CHAIR, x=3.5)))
    assert [issue.rule for issue in after.issues if issue not in before.issues] == ["shapes_cross"]


@every("seed", range(40))
def test_the_oracle_says_the_same_of_what_is_made_of_boxes(seed: int) -> None:
    """Tables and chairs have no round parts: both see the same crossings, as deep, at any angle."""
    random = Random(seed)
    table = replace(TABLE, rotation=random.choice((0, 90, 15, 200)))
    x, z = 3 + random.uniform(-1, 1), 3 + random.uniform(-1, 1)
    chair = replace(CHAIR, x=round(x, 4), z=round(z, 4), rotation=random.choice((0, 90, 180, 270, 33, 305)))
    document = scene(table, chair)
    mine = {frozenset(issue.ids): issue.amount for issue in told(document)}
    its = {frozenset((a, b)): deep for a, b, deep in crossings(document, KNOWN)}
    assert mine.keys() == its.keys()
    assert all(mine[pair] == pytest.approx(its[pair], abs=1e-5) for pair in mine)
