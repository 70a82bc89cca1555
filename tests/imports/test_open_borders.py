"""Borders between two rooms without a wall: furniture that is drawn at them or across them stays where it is drawn."""

from __future__ import annotations

import pytest

from solver.imported import PlanImport
from tests.imports.plans import Feature, box, collection, line, piece, read

HALF_WALL = 0.05


def open_plan(*more: Feature) -> PlanImport:
    """A kitchen north of a living room, 5 x 3 m and 5 x 5 m, walls all around them and none between."""
    walls = [line("wall", a, b, thickness=0.1) for a, b in (((0, 0), (5, 0)), ((5, 0), (5, 8)), ((5, 8), (0, 8)), ((0, 8), (0, 0)))]
    door = line("door", (2, 8), (2.9, 8), main_entrance=True)
    return read(collection(box("Kitchen", 0, 0, 5, 3), box("Living room", 0, 3, 5, 8), *walls, door, *more, y="down", wall_thickness=0.1))


def moved(made: PlanImport) -> list[str]:
    return [str(one["message"]) for one in made.changes if one["step"] == "furniture"]


def named(made: PlanImport, name: str) -> tuple[str, float, float]:
    """A piece: its room's type, where it stands in the house."""
    every = ((room, one) for room in made.scene.rooms for one in room.furniture)
    return next((room.type, room.x + one.x, room.z + one.z) for room, one in every if one.name == name)


def floor_m2(made: PlanImport) -> float:
    return sum(room.floor_m2 for room in made.scene.rooms)


@pytest.mark.parametrize("beyond", [0.0, 0.05, 0.25])
def test_a_counter_at_or_across_an_open_border_stays_and_the_border_gives_way(beyond: float) -> None:
    counter = piece("Counter", 3.5, 3 - 0.3 + beyond, width=2.0, depth=0.6, height=0.9, rotation=180)
    made = open_plan(counter)
    kind, x, z = named(made, "Counter")
    assert kind == "kitchen" and (x, z) == (3.5, pytest.approx(2.7 + beyond))
    assert moved(made) == [] and [issue for issue in made.issues if issue.severity == "error"] == []
    kitchen, living = made.scene.rooms
    assert living.z == kitchen.depth == pytest.approx(3 + beyond + HALF_WALL)
    assert floor_m2(made) == pytest.approx(40.0)
    (told,) = [change for change in made.changes if "no wall is drawn, is moved" in str(change["message"])]
    assert told["amount"] == pytest.approx(beyond + HALF_WALL)
    assert any(opening.kind == "passage" and opening.width > 4 for opening in kitchen.openings)


def test_a_border_with_furniture_on_both_its_sides_stays() -> None:
    counter = piece("Counter", 3.5, 2.7, width=2.0, depth=0.6, height=0.9, rotation=180)
    stool = piece("Stool", 3.5, 3.25, width=0.4, depth=0.4, height=0.7)
    made = open_plan(counter, stool)
    assert made.scene.rooms[0].depth == 3.0
    assert [issue for issue in made.issues if issue.severity == "error"] == []


def test_only_the_open_part_of_a_border_is_moved() -> None:
    """West of 2 m there is a wall between the rooms; the sofa across the rest of their border is the living room's."""
    wall = line("wall", (0, 3), (2, 3), thickness=0.1)
    sofa = piece("Sofa", 3.6, 3.2, width=1.8, depth=0.8, height=0.8)
    made = open_plan(wall, sofa)
    kind, _, z = named(made, "Sofa")
    assert kind == "living_room" and z == pytest.approx(3.2)
    kitchen, living = made.scene.rooms
    assert kitchen.outline is not None and living.outline is not None
    assert kitchen.depth == 3.0 and living.z == pytest.approx(3.2 - 0.4 - HALF_WALL)
    assert floor_m2(made) == pytest.approx(40.0)
    assert [issue for issue in made.issues if issue.severity == "error"] == []


def test_a_window_stays_its_rooms() -> None:
    """A sofa lies 30 cm across the border; the strip it would take ends at a window of the kitchen."""
    window = line("window", (5, 2.5), (5, 3.4))
    sofa = piece("Sofa", 2.6, 3.1, width=1.8, depth=0.8, height=0.8)
    made = open_plan(window, sofa)
    assert made.scene.rooms[0].depth == 3.0
    assert [issue for issue in made.issues if issue.severity == "error"] == []
