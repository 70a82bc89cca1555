"""Areas that are written in the rooms of a drawing tell how long its unit is, where nothing else does or what does is wrong."""

from __future__ import annotations

from io import StringIO
from typing import Any

import ezdxf.filemanagement as files
import pytest

from solver.answers import PlanImport
from solver.imports.units import without_area
from tests.imports.plans import read

ROOMS = {"Wohnen": (0.0, 0.0, 5.0, 4.0), "Bad": (5.1, 0.0, 7.1, 4.0), "Schlafen": (0.0, 4.1, 7.1, 7.1)}
"""Floors, m, 0.1 m apart; with one door of 0.8 m."""


def areas(**more: float) -> dict[str, float]:
    return {name: (x1 - x0) * (y1 - y0) for name, (x0, y0, x1, y1) in ROOMS.items()} | more


def dxf(per_metre: float, insunits: int, written: dict[str, float]) -> bytes:
    made: Any = files.new()
    made.header["$INSUNITS"] = insunits
    space = made.modelspace()
    for name, (x0, y0, x1, y1) in ROOMS.items():
        corners = [(x * per_metre, y * per_metre) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
        space.add_lwpolyline(corners, close=True, dxfattribs={"layer": "ROOMS"})
        words = f"{name}\\P{written[name]:.2f} m²".replace(".", ",") if name in written else name
        space.add_mtext(words, dxfattribs={"insert": ((x0 + x1) / 2 * per_metre, (y0 + y1) / 2 * per_metre)})
    space.add_line((5.05 * per_metre, 1.0 * per_metre), (5.05 * per_metre, 1.8 * per_metre), dxfattribs={"layer": "DOORS"})
    text = StringIO()
    made.write(text)
    return text.getvalue().encode()


def svg(per_metre: float, written: dict[str, float]) -> bytes:
    shapes = []
    for name, (x0, y0, x1, y1) in ROOMS.items():
        x, y, width, depth = (value * per_metre for value in (x0, y0, x1 - x0, y1 - y0))
        shapes.append(f'<rect class="room" x="{x}" y="{y}" width="{width}" height="{depth}"/>')
        shapes.append(f'<text x="{x + width / 2}" y="{y + depth / 2}">{name} {written[name]:.2f} m²</text>')
    x, y0, y1 = (value * per_metre for value in (5.05, 1.0, 1.8))
    shapes.append(f'<line class="door" x1="{x}" y1="{y0}" x2="{x}" y2="{y1}"/>')
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 900 900">{"".join(shapes)}</svg>'.encode()


def sizes(answer: PlanImport) -> list[tuple[float, float]]:
    return sorted((room.width, room.depth) for room in answer.scene.rooms)


DRAWN = [(2.1, 4.1), (5.1, 4.1), (7.2, 3.1)]
"""The rooms of ROOMS, along the lines of their walls, m."""


def units(answer: PlanImport) -> list[str]:
    return [str(one["taken"]) for one in answer.guesses if one["what"] == "unit"]


def test_a_file_that_says_inches_and_is_drawn_in_centimetres_is_told_by_its_areas() -> None:
    answer = read(dxf(100.0, 1, areas()))
    assert (sizes(answer), units(answer)) == (DRAWN, ["cm"])
    assert [room.name for room in answer.scene.rooms] == list(ROOMS)


@pytest.mark.parametrize("count", [1, 2])
def test_two_areas_tell_and_one_does_not(count: int) -> None:
    answer = read(dxf(100.0, 1, dict([*areas().items()][:count])))
    assert (units(answer) == ["cm"]) == (count == 2)
    assert (sizes(answer) == DRAWN) == (count == 2)


def test_pixels_are_as_long_as_areas_say_where_doors_are_no_ninety_centimetres_wide() -> None:
    """By its door alone, 0.8 m wide, the drawing would be an eighth larger."""
    assert sizes(read(svg(43.7, areas()))) == pytest.approx(DRAWN, abs=0.011)
    assert sizes(read(svg(43.7, dict.fromkeys(ROOMS, 0.0))))[0][0] > 2.3


def test_areas_tell_pixels_even_where_a_usual_door_is_nearly_right() -> None:
    """With its door of 0.86 m the drawing would be a twentieth larger."""
    content = svg(43.7, areas()).replace(f'y2="{1.8 * 43.7}"'.encode(), f'y2="{1.86 * 43.7}"'.encode())
    assert sizes(read(content)) == pytest.approx(DRAWN, abs=0.011)


@pytest.mark.parametrize("written", [areas(Wohnen=10.0, Bad=16.0), dict.fromkeys(ROOMS, 0.0), areas(Bad=4 * 8.0)])
def test_areas_that_disagree_or_are_none_change_nothing(written: dict[str, float]) -> None:
    """Two of three must agree; where they do, the third may be wrong."""
    answer = read(dxf(1000.0, 4, written))
    assert (sizes(answer), units(answer)) == (DRAWN, [])


@pytest.mark.parametrize(("insunits", "share"), [(0, 0.97), (4, 0.97), (4, 0.75)])
def test_areas_within_plaster_or_thick_walls_do_not_shorten_a_unit_that_has_a_name(insunits: int, share: float) -> None:
    answer = read(dxf(1000.0, insunits, {name: share * area for name, area in areas().items()}))
    assert (sizes(answer), units(answer)) == (DRAWN, ["mm"] if insunits == 0 else [])


def test_what_the_caller_says_counts_before_areas() -> None:
    answer = read(dxf(100.0, 5, {name: area / 4 for name, area in areas().items()}), unit="cm")
    assert (sizes(answer), units(answer)) == (DRAWN, [])


@pytest.mark.parametrize(
    ("words", "left", "area"),
    [
        ("Wohnen\n24,5 m²", "Wohnen\n", 24.5), ("12.30 m2", "", 12.3), ("A = 12.30 m²", "", 12.3), ("85 qm", "", 85.0),
        ("Kitchen 100 SQ. FT.", "Kitchen ", 9.290304), ("3 x 4 m", "3 x 4 m", 0.0), ("m2", "m2", 0.0), ("20 m2/h", "20 m2/h", 0.0),
        ("Комната 12,1 м²", "Комната ", 12.1),
    ],
)  # fmt: skip
def test_an_area_is_read_in_the_ways_it_is_written(words: str, left: str, area: float) -> None:
    found = without_area(words)
    assert (found[0].rstrip("."), found[1]) == (left.rstrip("."), pytest.approx(area))
