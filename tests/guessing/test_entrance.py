"""The main entrance of a home that says none."""

from __future__ import annotations

from dataclasses import replace

from catalogs import load_catalogs
from solver.guessing import with_entrance
from solver.scene import EXTERIOR, Opening, Room, Scene
from solver.validator import validate

KNOWN = load_catalogs()


def room(name: str, type_name: str, *doors: Opening) -> Room:
    return Room(name, type=type_name, width=4, depth=3, openings=doors)


OUT = Opening("out", wall="south", position=1, connects_to=EXTERIOR)


def test_one_comes_in_by_the_hallway_rather_than_by_the_living_room_or_a_bedroom() -> None:
    rooms = [room(name, name, replace(OUT, id=name)) for name in ("bedroom", "living_room", "hallway", "kitchen")]
    scene, chosen = with_entrance(Scene(rooms=tuple(rooms)), KNOWN)
    assert chosen is not None
    assert (chosen.id, chosen.room) == ("hallway", "hallway")
    assert [one.id for place in scene.rooms for one in place.openings if one.main_entrance] == ["hallway"]


def test_a_main_entrance_that_is_there_stays() -> None:
    plan = Scene(rooms=(room("a", "bedroom", replace(OUT, main_entrance=True)), room("b", "hallway", replace(OUT, id="b"))))
    assert with_entrance(plan, KNOWN) == (plan, None)


def test_a_door_that_says_nothing_leads_outside_where_no_other_room_lists_it() -> None:
    silent = replace(OUT, connects_to=None)
    assert with_entrance(Scene(rooms=(room("a", "hallway", silent), room("b", "bedroom", silent))), KNOWN)[1] is None
    scene, chosen = with_entrance(Scene(rooms=(room("a", "hallway", silent), room("b", "bedroom"))), KNOWN)
    assert chosen is not None
    assert scene.rooms[0].openings == (replace(OUT, main_entrance=True),)


def test_without_a_door_to_the_outside_none_is_chosen() -> None:
    plan = Scene(
        rooms=(room("a", "hallway", replace(OUT, kind="window")), replace(room("b", "backyard", replace(OUT, id="b")), outdoor=True))
    )
    assert with_entrance(plan, KNOWN) == (plan, None)


def test_a_door_into_the_next_room_is_no_entrance_though_it_says_that_it_leads_outside() -> None:
    plan = Scene(rooms=(room("a", "hallway", OUT), replace(room("b", "bedroom", replace(OUT, id="b")), z=3.1)))
    chosen = with_entrance(plan, KNOWN)[1]
    assert chosen is not None
    assert chosen.id == "b"


def side_by_side() -> tuple[Room, ...]:
    """Two dwellings of a hallway and a bedroom each, and a shed; nothing joins them."""
    doors = [Opening(f"d{k}", wall="east", position=1, connects_to=f"bedroom{k}") for k in (0, 1)]
    halls = [replace(room(f"hallway{k}", "hallway", replace(OUT, id=f"out{k}"), doors[k]), x=10.0 * k) for k in (0, 1)]
    beds = [
        replace(
            room(f"bedroom{k}", "bedroom", replace(doors[k], wall="west", connects_to=f"hallway{k}"), replace(OUT, id=f"b{k}")),
            x=4 + 10.0 * k,
        )
        for k in (0, 1)
    ]
    return (*halls, *beds, replace(room("shed", "workshop", replace(OUT, id="shed_door")), x=30))


def test_each_of_two_dwellings_has_a_main_entrance_but_no_shed() -> None:
    scene, chosen = with_entrance(Scene(rooms=side_by_side()), KNOWN)
    assert chosen is not None
    assert (chosen.id, chosen.room) == ("out0", "hallway0")
    assert "out1 of hallway1" in chosen.message
    assert [one.id for place in scene.rooms for one in place.openings if one.main_entrance] == ["out0", "out1"]
    assert "unreachable" not in {issue.rule for issue in validate(scene) if issue.room != "shed"}


def test_rooms_of_a_storey_above_have_no_main_entrance() -> None:
    plan = Scene(rooms=tuple(replace(one, level=1) if one.id in ("hallway1", "bedroom1") else one for one in side_by_side()))
    scene, _ = with_entrance(plan, KNOWN)
    assert [one.id for place in scene.rooms for one in place.openings if one.main_entrance] == ["out0"]
