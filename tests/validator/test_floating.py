"""The rule `floating`, on worlds of two: on a surface nothing, a step beside it or above it an issue."""

from __future__ import annotations

from typing import Any

import pytest

from catalogs import Catalogs
from catalogs.decoration_types import DecorationKind
from catalogs.entries import Surface
from solver.answers import Issue
from solver.scene import Decoration, Room
from solver.validator import validate
from tests.validator.worlds import CATALOGS, SIDE, WALLS, along, kind, piece, room, scene

SEAT = (Surface(name="seat", height=0.4, inset=0.1),)
KNOWN = CATALOGS.model_copy(
    update={
        "furniture": {
            "sofa": kind(size=(2.0, 1.0, 0.8), surfaces=SEAT),
            "shelf": kind(size=(1.0, 0.4, 1.8), surfaces=(Surface(name="low", height=0.2), Surface(name="high", height=1.2))),
            "chest": kind(size=(1.0, 0.5, 0.5)),
        },
        "decorations": {
            "tray": DecorationKind(
                group="decor", size=(0.4, 0.3, 0.05), color="#000000", mass=1.0, surfaces=(Surface(name="bottom", height=0.02, inset=0.05),)
            )
        },
    }
)
assert isinstance(KNOWN, Catalogs)
MM = 0.001


def thing(x: float, z: float, y: float = 0.0, parent: str | None = None, **more: Any) -> Decoration:
    values: dict[str, Any] = {"id": "thing_1", "name": "thing", "width": 0.2, "depth": 0.1, "height": 0.1, **more}
    return Decoration(x=x, y=y, z=z, parent=parent, **values)


def told(document: Room, thickness: float = 0.0) -> list[Issue]:
    found = validate(scene(document, wall_thickness=thickness), KNOWN)
    return [issue for issue in found if issue.rule == "floating"]


SOFA = piece(2.0, 2.0, 2.0, 1.0, id="sofa_1", name="sofa", height=0.8)


@pytest.mark.parametrize("turn", [0, 90, 180, 270])
def test_a_middle_lies_within_its_parents_surface(turn: int) -> None:
    sofa = piece(2.0, 2.0, 2.0, 1.0, id="sofa_1", name="sofa", height=0.8, rotation=turn)
    across, deep = (0.9, 0.4) if turn % 180 == 0 else (0.4, 0.9)
    for dx, dz in ((across, deep), (-across, -deep), (0.0, 0.0)):
        assert told(room(sofa, decorations=(thing(2 + dx, 2 + dz, 0.4, "sofa_1"),))) == []
    for dx, dz in ((across + MM, 0.0), (-across - MM, 0.0), (0.0, deep + MM), (0.0, -deep - MM)):
        (issue,) = told(room(sofa, decorations=(thing(2 + dx, 2 + dz, 0.4, "sofa_1"),)))
        assert (issue.severity, issue.ids, issue.room, issue.amount) == ("error", ("thing_1",), "room_0", MM)
        assert "sofa_1" in issue.message and "beside" in issue.message


@pytest.mark.parametrize(("y", "amount"), [(0.4, None), (0.41, None), (0.39, None), (0.411, 0.011), (0.0, 0.4), (0.8, 0.4)])
def test_a_thing_lies_at_its_surfaces_height(y: float, amount: float | None) -> None:
    found = told(room(SOFA, decorations=(thing(2.0, 2.0, y, "sofa_1"),)))
    assert [issue.amount for issue in found] == ([] if amount is None else [amount])


def test_a_thing_is_carried_by_its_own_parent_alone() -> None:
    chest = piece(1.0, 3.5, 1.0, 0.5, id="chest_1", name="chest", height=0.5)
    assert told(room(SOFA, chest, decorations=(thing(1.0, 3.5, 0.5, "chest_1"),))) == []
    assert len(told(room(SOFA, chest, decorations=(thing(1.0, 3.5, 0.5, "sofa_1"),)))) == 1


def test_every_shelf_of_a_shelf_carries() -> None:
    shelf = piece(2.0, 2.0, 1.0, 0.4, id="shelf_1", name="shelf", height=1.8)
    for y, count in ((0.2, 0), (1.2, 0), (0.7, 1), (1.8, 1)):
        assert len(told(room(shelf, decorations=(thing(2.0, 2.0, y, "shelf_1"),)))) == count


def test_an_unknown_piece_carries_on_its_top() -> None:
    crate = piece(2.0, 2.0, 1.0, 1.0, id="crate_1", name="never_heard_of", height=0.7)
    assert told(room(crate, decorations=(thing(2.5, 1.5, 0.7, "crate_1"),))) == []
    assert len(told(room(crate, decorations=(thing(2.5, 1.5, 0.4, "crate_1"),)))) == 1
    assert len(told(room(crate, decorations=(thing(2.501, 1.5, 0.7, "crate_1"),)))) == 1


def test_a_known_piece_of_another_size_carries_on_its_top_and_at_known_heights() -> None:
    sofa = piece(2.0, 2.0, 1.5, 1.0, id="sofa_1", name="sofa", height=0.9)
    for y, count in ((0.4, 0), (0.9, 0), (0.6, 1)):
        assert len(told(room(sofa, decorations=(thing(2.7, 2.0, y, "sofa_1"),)))) == count


def test_a_decoration_carries_what_lies_on_it() -> None:
    tray = thing(2.0, 2.0, 0.4, "sofa_1", id="tray_1", name="tray", width=0.4, depth=0.3, height=0.05)
    assert told(room(SOFA, decorations=(tray, thing(2.15, 2.0, 0.42, "tray_1")))) == []
    assert [issue.ids for issue in told(room(SOFA, decorations=(tray, thing(2.151, 2.0, 0.42, "tray_1"))))] == [("thing_1",)]


def test_without_a_parent_it_lies_on_the_floor_or_on_something() -> None:
    assert told(room(decorations=(thing(1.0, 1.0),))) == []
    assert told(room(decorations=(thing(1.0, 1.0, 0.01),))) == []
    assert [issue.amount for issue in told(room(decorations=(thing(1.0, 1.0, 0.5),)))] == [0.5]
    assert told(room(SOFA, decorations=(thing(2.0, 2.0, 0.4),))) == []
    assert len(told(room(decorations=(thing(-0.1, 1.0),)))) == 1


def test_a_parent_that_is_not_there_counts_as_none() -> None:
    assert told(room(SOFA, decorations=(thing(1.0, 3.5, 0.0, "gone"),))) == []
    assert told(room(SOFA, decorations=(thing(2.0, 2.0, 0.4, "gone"),))) == []
    assert len(told(room(SOFA, decorations=(thing(2.0, 2.0, 0.6, "gone"),)))) == 1


def test_nothing_carries_itself() -> None:
    assert len(told(room(decorations=(thing(1.0, 1.0, 0.1, "thing_1"),)))) == 1


@pytest.mark.parametrize("wall", WALLS)
@pytest.mark.parametrize("thickness", [0.0, 0.1])
def test_what_hangs_hangs_at_its_walls_face(wall: str, thickness: float) -> None:
    turned: dict[str, Any] = {"width": 0.1, "depth": 0.5} if wall in ("west", "east") else {"width": 0.5, "depth": 0.1}
    for away, count in ((0.0, 0), (0.03, 0), (0.031, 1), (-0.031, 1), (1.0, 1)):
        x, z = along(wall, 1.0, thickness / 2 + 0.05 + away)
        picture = thing(x, z, 1.5, mounted_on_wall=wall, **turned)
        assert len(told(room(decorations=(picture,)), thickness)) == count, (wall, away)
    for beyond, count in ((0.03, 0), (0.031, 1)):
        for at in (-beyond, SIDE + beyond):
            x, z = along(wall, at, thickness / 2 + 0.05)
            assert len(told(room(decorations=(thing(x, z, 1.5, mounted_on_wall=wall, **turned),)), thickness)) == count, (wall, at)


def test_on_an_outline_any_wall_of_that_side_will_do() -> None:
    outline = ((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0))
    for z, count in ((1.95, 0), (3.95, 1)):
        picture = thing(3.0, z, 1.5, mounted_on_wall="south")
        assert len(told(room(decorations=(picture,), outline=outline))) == count


@pytest.mark.parametrize("others", [[], ["a"], ["a", "b"]])
def test_things_that_carry_each_other_in_a_ring_lie_on_nothing(others: list[str]) -> None:
    names = ["thing_1", *others]
    things = [thing(1.0, 1.0, 1.5, above, id=name, height=0.005) for name, above in zip(names, [*names[1:], names[0]], strict=True)]
    found = told(room(decorations=tuple(things)))
    assert [issue.ids for issue in found] == [(name,) for name in names]
    assert all("nothing carries it" in issue.message for issue in found)


def test_what_a_hanging_thing_is_said_to_lie_on_makes_no_ring() -> None:
    shelf = thing(1.0, 0.05, 1.5, "thing_1", id="shelf_1", mounted_on_wall="north")
    assert told(room(decorations=(shelf, thing(1.0, 0.05, 1.6, "shelf_1")))) == []


CRATE = piece(2.0, 2.0, 1.0, 1.0, id="crate_1", name="never_heard_of", height=0.7)


@pytest.mark.parametrize(
    ("x", "y", "count"), [(2.0, 0.7, 0), (2.5, 0.7, 0), (2.501, 0.7, 1), (2.0, 0.71, 0), (2.0, 0.711, 1), (2.0, 0.0, 1), (3.5, 0.0, 1)]
)
def test_furniture_stands_on_what_it_says(x: float, y: float, count: int) -> None:
    case = piece(x, 2.0, 0.2, 0.2, id="case_1", name="case", height=0.3, y=y, on="crate_1")
    found = told(room(CRATE, case))
    assert [issue.ids for issue in found] == [("case_1",)] * count
    assert all("crate_1" in issue.message and "parent" not in issue.message for issue in found)


def test_furniture_that_says_nothing_may_hang() -> None:
    assert told(room(CRATE, piece(0.5, 0.5, 0.2, 0.2, id="cupboard_1", name="cupboard", height=0.3, y=1.4))) == []


def test_furniture_on_what_is_not_there_stands_on_the_floor_or_on_something() -> None:
    for x, y, count in ((0.5, 0.0, 0), (0.5, 0.7, 1), (2.0, 0.7, 0)):
        case = piece(x, 2.0, 0.2, 0.2, id="case_1", name="case", height=0.3, y=y, on="gone")
        assert len(told(room(CRATE, case))) == count


def test_pieces_that_stand_on_each_other_in_a_ring_stand_on_nothing() -> None:
    ring = [piece(x, 2.0, 0.2, 0.2, id=name, name="case", height=0.3, on=on) for name, on, x in (("a", "b", 1.0), ("b", "a", 2.0))]
    assert [issue.ids for issue in told(room(*ring))] == [("a",), ("b",)]
