"""The judge judged: each check must see the fault it is for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver.floorplan import draw
from solver.request import Request
from solver.scene import Opening, Room, Sides
from tests.floorplan import checks

ROOMS = draw(Request(seed=7), load_catalogs()).rooms
Rooms = tuple[Room, ...]


def changed(index: int, **fields: object) -> Rooms:
    return tuple(replace(room, **fields) if i == index else room for i, room in enumerate(ROOMS))  # type: ignore[arg-type]


def every(change: Callable[[Opening], Opening | None], wanted: Callable[[Opening], bool]) -> Rooms:
    def all_of(room: Room) -> tuple[Opening, ...]:
        return tuple(new for o in room.openings for new in [change(o) if wanted(o) else o] if new is not None)

    return tuple(replace(room, openings=all_of(room)) for room in ROOMS)


def test_the_plan_they_are_tried_on_is_sound() -> None:
    assert checks.sound(ROOMS, 20.0, 15.0) == []
    assert checks.violations(ROOMS) == []


@pytest.mark.parametrize(
    ("rooms", "words"),
    [
        (changed(3, width=ROOMS[3].width + 0.1), "overlaps"),
        (changed(3, width=ROOMS[3].width - 0.1), "cover"),
        (changed(0, x=-0.1), "leaves the house"),
        (changed(3, wall_flags=Sides()), "flag"),
        (changed(3, exterior_walls=Sides()), "exterior wall"),
        (every(lambda o: None, lambda o: o.main_entrance), "0 main entrances"),
        (every(lambda o: None, lambda o: o.kind == "door" and not o.main_entrance), "cannot be reached"),
        (every(lambda o: replace(o, position=0.3), lambda o: o.kind == "window"), "does not fit"),
        (every(lambda o: replace(o, width=o.width + 0.02), lambda o: o.swing == "in"), "two places"),
        (every(lambda o: replace(o, swing="in"), lambda o: o.swing == "out"), "both ways"),
        (every(lambda o: replace(o, hinge="start", swing="in"), lambda o: o.kind == "passage"), "leaf it should not have"),
        (every(lambda o: replace(o, render_panel=True), lambda o: True), "drawn twice"),
        (every(lambda o: replace(o, connects_to="EXTERIOR"), lambda o: o.kind == "passage"), "lead outside"),
    ],
)
def test_sound_sees(rooms: Rooms, words: str) -> None:
    assert any(words in fault for fault in checks.sound(rooms, 20.0, 15.0))


def test_leaves_see_two_doors_in_one_corner() -> None:
    corner = (
        Opening("a", wall="north", position=0.55, connects_to="x", hinge="start", swing="in"),
        Opening("b", wall="west", position=0.55, connects_to="y", hinge="start", swing="out"),
    )
    assert checks.leaves([Room("r", width=3.0, depth=3.0, openings=corner)])
    apart = (corner[0], replace(corner[1], position=1.5))
    assert not checks.leaves([Room("r", width=3.0, depth=3.0, openings=apart)])


def test_violations_see_a_bedroom_behind_a_bedroom() -> None:
    row = ("hallway", "bedroom", "bedroom", "bathroom")
    rooms = []
    for i, name in enumerate(row):
        doors = [Opening(f"d{i}", wall="east", position=1.5, connects_to=f"{row[i + 1]}_{i + 1}")] if i < 3 else []
        doors += [Opening(f"d{i - 1}", wall="west", position=1.5, connects_to=f"{row[i - 1]}_{i - 1}")] if i else []
        doors += [Opening("main", wall="west", position=1.5, connects_to="EXTERIOR", main_entrance=True)] if not i else []
        rooms.append(Room(f"{name}_{i}", i, name, x=3.0 * i, width=3.0, depth=3.0, openings=tuple(doors)))
    assert checks.violations(rooms) == ["bedroom_2 is off the hallway", "bedroom_1 is the way to bedroom_2"]


def test_gardens_see_a_room_behind_a_garden() -> None:
    garden = Room(
        "patio_0", 0, "patio", width=3.0, depth=3.0, outdoor=True,
        openings=(Opening("main", connects_to="EXTERIOR", main_entrance=True), Opening("d", connects_to="office_1")),
    )  # fmt: skip
    office = Room("office_1", 1, "office", x=3.0, width=3.0, depth=3.0, openings=(Opening("d", connects_to="patio_0"),))
    assert checks.gardens([garden, office])
    assert not checks.gardens([replace(garden, outdoor=False), office])
