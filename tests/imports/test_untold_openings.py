"""Doors and windows in one layer of openings: told apart by leaves, outer walls and what lies outdoors; what was guessed is said."""

from __future__ import annotations

import re
from typing import Any

import ezdxf.filemanagement as files
import ifcopenshell
import pytest

from solver import export
from solver.answers import PlanImport
from tests.imports.plans import imported, read
from tests.imports.test_round_trips import home

ROOMS = {"Flur": (0, 0, 2000, 4000), "Schlafzimmer": (2100, 0, 6000, 4000)}
BALCONY = {"Balkon": (2100, 4100, 6000, 5600)}
LAYERS = ("Öffnungen", "OPENINGS", "Türen und Fenster", "A-DOOR-WINDOW", "MENUISERIES")


def drawing(
    *openings: tuple[int, int, int, int], layer: str = "OPENINGS", arcs: tuple[tuple[int, int, int, int], ...] = (), **more: Any
) -> Any:
    """Rooms 100 mm apart, openings as three lines along their walls, mm."""
    made: Any = files.new()
    made.header["$INSUNITS"] = 4
    space = made.modelspace()
    for name, (x0, y0, x1, y1) in {**ROOMS, **more.get("rooms", {})}.items():
        space.add_lwpolyline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], close=True, dxfattribs={"layer": "ROOMS"})
        space.add_text(name, dxfattribs={"layer": "TEXT", "insert": ((x0 + x1) / 2, (y0 + y1) / 2)})
    for x0, y0, x1, y1 in openings:
        across = (0, 50) if y0 == y1 else (50, 0)
        for at in (-1, 0, 1):
            space.add_line(
                (x0 + at * across[0], y0 + at * across[1]), (x1 + at * across[0], y1 + at * across[1]), dxfattribs={"layer": layer}
            )
    for x, y, radius, start in arcs:
        space.add_arc((x, y), radius, start, start + 90, dxfattribs={"layer": layer})
    return made


def kinds(answer: PlanImport) -> dict[str, list[tuple[str, float, str | None]]]:
    return {str(room.name): [(one.kind, one.width, one.connects_to) for one in room.openings] for room in answer.scene.rooms}


def guessed(answer: PlanImport) -> list[str]:
    """What was guessed, as often as it was: those alike are told in one line."""
    told = [(str(one["taken"]), str(one["message"])) for one in answer.guesses if one["what"] == "kind"]
    assert len({(kind, re.sub(r": \d+ in all", "", words)) for kind, words in told}) == len(told)
    counts = [re.search(r": (\d+) in all$", words) for _, words in told]
    return [kind for (kind, _), count in zip(told, counts, strict=True) for _ in range(int(count[1]) if count else 1)]


SOUTH = (3000, -50, 4400, -50)
BETWEEN = (2050, 1000, 2050, 1900)
FRONT = (-50, 1000, -50, 1900)


@pytest.mark.parametrize("layer", LAYERS)
def test_what_has_no_leaf_in_an_outer_wall_is_a_window_where_doors_have_theirs(layer: str) -> None:
    answer = imported(drawing(SOUTH, layer=layer, arcs=((0, 1000, 900, 0), (2100, 1000, 900, 0))))
    found = kinds(answer)
    assert sorted(found["Flur"]) == [("door", 0.9, "EXTERIOR"), ("door", 0.9, answer.scene.rooms[1].id)]
    assert sorted(found["Schlafzimmer"])[1:] == [("window", 1.4, "EXTERIOR")]
    assert guessed(answer) == ["window"]
    assert not answer.unread


def test_without_any_leaf_the_likeliest_of_a_doors_width_is_where_one_comes_in() -> None:
    """The bedroom has one of a door's width, too: one comes in by the hallway."""
    answer = imported(drawing(SOUTH, FRONT, BETWEEN, (4000, 4050, 4800, 4050)))
    found = kinds(answer)
    assert sorted(found["Flur"]) == [("door", 0.9, "EXTERIOR"), ("passage", 0.9, answer.scene.rooms[1].id)]
    assert sorted(one[:2] for one in found["Schlafzimmer"]) == [("passage", 0.9), ("window", 0.8), ("window", 1.4)]
    assert [one.main_entrance for one in answer.scene.rooms[0].openings if one.kind == "door"] == [True]
    assert sorted(guessed(answer)) == ["door", "passage", "window", "window"]


def test_what_leads_to_a_balcony_is_a_door_and_the_balconys_own_side_stays_open() -> None:
    answer = imported(drawing(FRONT, (3000, 4050, 3900, 4050), (3000, 5650, 4400, 5650), rooms=BALCONY))
    found = kinds(answer)
    assert ("door", 0.9, answer.scene.rooms[2].id) in found["Schlafzimmer"]
    assert ("passage", 1.4, "EXTERIOR") in found["Balkon"]


def test_a_layer_of_windows_tells_that_openings_are_none_but_the_one_to_come_in_by() -> None:
    made = drawing(FRONT, BETWEEN)
    made.modelspace().add_line((3000, -50), (4400, -50), dxfattribs={"layer": "WINDOWS"})
    answer = imported(made)
    assert sorted(one[0] for one in kinds(answer)["Flur"]) == ["door", "passage"]
    assert guessed(answer) == ["door"]


def test_a_drawing_in_svg_is_told_alike() -> None:
    body = "<g id='Räume'><rect id='Flur' width='2' height='4'/><rect id='Schlafzimmer' x='2' width='4' height='4'/></g>"
    body += "<g id='Öffnungen'><line x1='0' y1='1' x2='0' y2='1.9'/><line x1='3' y1='0' x2='4.4' y2='0'/>"
    body += "<path d='M2 2 A0.9 0.9 0 0 1 2.9 2.9 L2 2.9 Z'/></g>"
    answer = read(f"<svg xmlns='http://www.w3.org/2000/svg' data-unit='m'>{body}</svg>".encode(), "plan.svg")
    assert sorted(one[0] for one in kinds(answer)["Flur"]) == ["door", "door"]
    assert sorted(one[0] for one in kinds(answer)["Schlafzimmer"]) == ["door", "window"]


def test_what_is_too_narrow_to_step_outdoors_by_is_a_window() -> None:
    answer = imported(drawing(FRONT, (3000, 4050, 3900, 4050), (5000, 4050, 5450, 4050), rooms=BALCONY))
    assert sorted(one[:2] for one in kinds(answer)["Schlafzimmer"]) == [("door", 0.9), ("window", 0.45)]


def without_windows(program: str, left: int = 0, sill: float | None = None) -> tuple[int, PlanImport]:
    """What is read of a home of which so many windows are left, and holes of the others; of how many. The holes may have other sills."""
    building: Any = ifcopenshell.file.from_string(next(iter(export(home(program), "ifc").values())).decode())
    windows = building.by_type("IfcWindow")
    for window in windows[left:]:
        for fills in window.FillsVoids:
            place = fills.RelatingOpeningElement.ObjectPlacement.RelativePlacement
            x, z, y = place.Location.Coordinates
            place.Location = building.create_entity("IfcCartesianPoint", (x, z, y if sill is None else sill))
            building.remove(fills)
        building.remove(window)
    return len(windows), read(str(building.to_string()).encode())


def windows_of(answer: PlanImport) -> set[str]:
    return {one.id for room in answer.scene.rooms for one in room.openings if one.kind == "window"}


@pytest.mark.parametrize("left", [0, 1])
def test_holes_of_a_building_without_any_window_are_windows_where_their_sills_are_high(left: int) -> None:
    """Where one window is left, holes without one are niches."""
    many, answer = without_windows("family", left)
    assert many > 4
    assert len(windows_of(answer)) == (left or many)
    assert guessed(answer).count("window") == (0 if left else many)


@pytest.mark.parametrize(("sill", "is_high"), [(0.3, True), (0.299, False)])
def test_a_sill_is_high_from_30_centimetres_on(sill: float, is_high: bool) -> None:
    many, answer = without_windows("studio", sill=sill)
    assert len(windows_of(answer)) == (many if is_high else 0)
    unread = [one["reason"] for one in answer.unread]
    assert unread.count("a hole in a wall that is neither filled nor a passage") == (0 if is_high else many)


@pytest.mark.parametrize(("layer", "told"), [("Fenster", []), ("Türen", ["window"])])
def test_doors_on_the_layer_of_windows_have_leaves_and_windows_on_that_of_doors_have_none(layer: str, told: list[str]) -> None:
    """Of the leaf itself, which lies open in the room, nothing is left, and the leafless opening between the rooms stays a door."""
    made = drawing(SOUTH, (2050, 2500, 2050, 3400), layer=layer, arcs=((0, 1000, 900, 0),))
    made.modelspace().add_line((0, 1000), (900, 1000), dxfattribs={"layer": layer})
    answer = imported(made)
    assert sorted(one[:2] for one in kinds(answer)["Flur"]) == [("door", 0.9), ("window" if layer == "Fenster" else "door", 0.9)]
    assert [one[:2] for one in kinds(answer)["Schlafzimmer"] if one[2] == "EXTERIOR"] == [("window", 1.4)]
    assert guessed(answer) == told
    assert not answer.unread
