"""The small house that formats are tested on holds what it is for."""

from __future__ import annotations

from tests.exports import homes


def test_the_small_house_has_a_door_for_each_hinge_swing_and_axis() -> None:
    model = homes.described("own")
    doors = [one for one in model.openings if one.kind == "door"]
    assert len({(one.axis, one.hinge, one.towards) for one in doors}) == 8
    assert {one.kind for one in model.openings} == {"door", "garage_door", "passage", "window"}
    assert len({one.id for one in model.openings}) == len(model.openings) == 13
    assert {len(room.corners) for room in model.rooms} == {4, 6}


def test_hostile_names_are_as_many_as_their_bodies() -> None:
    model, plain = homes.described("hostile"), homes.described("own")
    ids = [body.id for body in model.bodies]
    assert len(set(ids)) == len(ids) == len(plain.bodies)
    assert set(homes.HOSTILE) <= {*ids, *(room.id for room in model.rooms), *(one.id for one in model.openings)}
    assert {body.parent for body in model.bodies if body.parent} <= set(ids)
    assert [body.room for body in model.bodies if body.room not in {room.id for room in model.rooms}] == []
