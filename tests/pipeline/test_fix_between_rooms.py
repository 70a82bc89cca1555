"""fix() where what keeps people out of a room stands in another one, and where a chair is pushed too far under its table."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from importlib import import_module

import pytest

from catalogs import Catalogs
from solver import Scene, fix
from solver.answers import Issue
from solver.scene import Dynamic, Furniture, Opening, Room
from solver.validator import checking
from solver.validator.judging import RuleCase
from solver.validator.rules import issues_of
from tests.pipeline.fix_rooms import BACK_TO, body, errors, pieces, room_of

FRONT = Opening("front", "door", "west", 1.0, 0.9, connects_to="EXTERIOR", main_entrance=True)
NEXT = Opening("next", "door", "east", 1.0, 0.9, connects_to="back_1")


def house(*furniture: Furniture, people: tuple[Dynamic, ...] = ()) -> Scene:
    """A hall of 6 x 2 m from the front door in the west to the door of the back room in the east."""
    hall = Room("room_0", 0, "room", 0, 0.0, 0.0, 6.0, 2.0, openings=(FRONT, NEXT), furniture=furniture)
    back = Room("back_1", 1, "room", 0, 6.0, 0.0, 3.0, 2.0, openings=(replace(NEXT, wall="west", connects_to="room_0"),))
    return Scene(rooms=(hall, back), dynamic=people)


def test_a_piece_that_shuts_the_way_to_another_room_gives_way() -> None:
    sent = house(body("chest_1", 4.0, 1.0, (0.6, 1.3, 0.8)))
    assert [message for message in errors(sent) if "back_1" in message]
    assert errors(fix(sent).scene) == []


def test_a_sound_room_before_one_that_stays_shut_comes_back_as_sent() -> None:
    basket = replace(body("basket_1", 2.9425, 1.7, (0.36, 0.3, 0.3)), rotation=185)
    hall, back = house(basket).rooms
    chest = replace(body("chest_1", 1.0, 1.0, (0.8, 1.9, 0.8), locked=True), id="back_1/chest_1")
    sent = Scene(rooms=(hall, replace(back, furniture=(chest,))))
    assert [issue.room for issue in fix(sent).issues if issue.rule == "unreachable" and not issue.ids] == ["back_1"]
    assert fix(sent).scene.rooms[0] == hall


@pytest.mark.parametrize("kind", ["person", "dog"])
def test_somebody_who_shuts_the_way_to_another_room_steps_aside(kind: str) -> None:
    crates = (body("crate_1", 3.0, 0.5, (0.6, 0.95, 0.8)), body("crate_2", 4.6, 1.5, (0.6, 0.9, 0.8)))
    sent = house(*crates, people=(Dynamic("one", kind, "room_0", 3.0, 0.0, 1.4, 0, 0.5, 0.5, 0.9),))
    assert [message for message in errors(sent) if "back_1" in message]
    fixed = fix(sent)
    assert errors(fixed.scene) == []
    assert pieces(fixed.scene) == pieces(sent), "the furniture shuts nobody out"


def test_what_a_body_of_the_next_room_keeps_out_of_reach_has_that_ones_repairs() -> None:
    """A locked chest that stands half through the wall, before the only free side of a wardrobe of the next room."""
    side = Opening("side", "door", "west", 5.0, 0.9, connects_to="EXTERIOR")
    chest = body("chest_1", 3.9, 1.0, (2.0, 1.6, 0.8), locked=True)
    wardrobe = replace(body("wardrobe_1", 1.7, 1.0, (1.6, 0.6, 2.0)), id="back_1/wardrobe_1", rotation=270, wall="east")
    inner = Opening("inner", "door", "east", 5.0, 0.9, connects_to="back_1")
    front = Room("room_0", 0, "room", 0, 0.0, 0.0, 4.0, 6.0, openings=(side, inner), furniture=(chest,))
    back = Room(
        "back_1", 1, "room", 0, 4.0, 0.0, 2.0, 6.0, openings=(replace(inner, wall="west", connects_to="room_0"),), furniture=(wardrobe,)
    )
    sent = Scene(rooms=(front, back))
    fixed = fix(sent)
    assert [issue.ids for issue in fixed.issues if issue.rule == "unreachable"] == [(wardrobe.id,)]
    conflict, shut = fixed.conflicts
    assert (conflict.ids, shut.ids) == ((chest.id,), (wardrobe.id,))
    assert shut.repairs == conflict.repairs
    assert errors(fix(replace(sent, rooms=(replace(front, furniture=()), back))).scene) == []


@pytest.mark.parametrize(("wall", "step"), [("north", (0, 1)), ("west", (1, 0)), ("south", (0, -1)), ("east", (-1, 0))])
def test_a_chair_too_far_under_its_table_is_drawn_out(wall: str, step: tuple[int, int]) -> None:
    table = body("dining_table_1", 2.0, 2.0, (0.8, 0.8, 0.75))
    x, z = 2.0 - 0.1 * step[0], 2.0 - 0.1 * step[1]
    chair = replace(body("dining_chair_1", x, z, (0.46, 0.5, 0.9)), rotation=BACK_TO[wall], under=table.id)
    sent = room_of(table, chair)
    assert [message for message in errors(sent) if "too far to sit down" in message]
    fixed = fix(sent)
    assert errors(fixed.scene) == []
    now = pieces(fixed.scene)
    assert now[chair.id].under == table.id
    out = [(a - b) * s for a, b, s in zip((now[chair.id].x, now[chair.id].z), (x, z), step, strict=True)]
    moved = [now[table.id].x - 2.0, now[table.id].z - 2.0]
    assert sum(out) - sum(m * s for m, s in zip(moved, step, strict=True)) == pytest.approx(-0.2), "until 35 cm of its 50 are under it"
    assert fix(fixed.scene).scene == fixed.scene


def test_the_house_is_checked_once_and_then_only_where_it_changed(monkeypatch: pytest.MonkeyPatch) -> None:
    whole, judged = list[Scene](), list[tuple[str, str]]()
    check = checking.check

    def counted(rules: Iterable[str], case: RuleCase) -> dict[str, tuple[Issue, ...]]:
        asked = list(rules)
        judged.extend((case.room.room.id, rule) for rule in asked)
        return issues_of(asked, case)

    def checked(scene: Scene, catalogs: Catalogs) -> checking.Checked:
        whole.append(scene)
        return check(scene, catalogs)

    monkeypatch.setattr(checking, "issues_of", counted)
    monkeypatch.setattr(import_module("solver.pipeline.fix"), "check", checked)
    people = (Dynamic("one", "person", "room_0", 3.0, 0.0, 1.4, 0, 0.5, 0.5, 0.9),)
    fixed = fix(house(body("chest_1", 4.0, 1.0, (0.6, 1.3, 0.8)), people=people))
    assert len(whole) == 1
    assert judged.count(("back_1", "front_blocked")) == 1, "nothing in it changes"
    assert judged.count(("room_0", "front_blocked")) > 1
    assert errors(fixed.scene) == []
