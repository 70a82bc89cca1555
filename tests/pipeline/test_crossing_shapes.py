"""Bodies of finished homes do not cross as shapes: an oracle on the catalogs' parts, which shares no code with what places."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver import Request, generate
from solver.scene import Dynamic, Furniture, Room, Scene
from tests.oracles.crossing import crossings

KNOWN = load_catalogs()
HOMES = (
    Request(seed=7001, program="family", decorate=True, style="classic"),
    Request(seed=7002, program="one_bed", decorate=True, style="rustic"),
    Request(seed=7003, program="studio", decorate=True),
    Request(seed=7004, width=14, depth=11, decorate=True, outdoor=True),
)


@pytest.mark.parametrize("request_", HOMES, ids=lambda one: str(one.seed))
def test_no_two_bodies_of_a_home_cross(request_: Request) -> None:
    assert list(crossings(generate(request_).scene, KNOWN)) == []


def room(*furniture: Furniture, people: tuple[Dynamic, ...] = ()) -> Scene:
    return Scene(rooms=(Room("r", width=6, depth=6, furniture=furniture),), dynamic=people)


TABLE = Furniture("t", "dining_table", x=3, z=3, width=1.2, depth=0.8, height=0.75)
CHAIR = Furniture("c", "dining_chair", x=3, z=3 + 0.4 + 0.1, rotation=180, width=0.46, depth=0.5, height=0.9, under="t")


def test_the_oracle_sees_a_leg_in_a_seat_and_not_a_seat_under_a_top() -> None:
    assert list(crossings(room(TABLE, CHAIR), KNOWN)) == []
    [(one, other, deep)] = crossings(room(TABLE, replace(CHAIR, x=3.3)), KNOWN)
    assert (one, other) == ("t", "c") and deep == pytest.approx(0.032, abs=1e-4)


def test_the_oracle_measures_turned_boxes_and_balls() -> None:
    box = Furniture("a", "unknown", x=2, z=2, width=1, depth=1, height=1)
    turned = replace(box, id="b", x=2 + 0.5 + 0.5 * 2**0.5 - 0.03, rotation=45)
    assert [round(deep, 3) for _, _, deep in crossings(room(box, turned), KNOWN)] == [0.03]
    assert not list(crossings(room(box, replace(turned, x=2 + 0.5 + 0.5 * 2**0.5 - 0.001)), KNOWN))
    cat = Dynamic("cat", "cat", "r", x=2.5 + 0.1 + 0.05, z=2, width=0.2, depth=0.45, height=0.25)
    assert not list(crossings(room(box, people=(cat,)), KNOWN))
    assert [found[:2] for found in crossings(room(box, people=(replace(cat, x=2.55),)), KNOWN)] == [("a", "cat")]
