"""Plans whose unit is guessed or wrong: none comes in larger than any home, and pieces with their names in them are no rooms."""

from __future__ import annotations

import pytest

from solver.answers import ImportSettings
from solver.errors import FieldError
from solver.pipeline.import_plan import import_plan

WALLS = (
    "0,0 100,0 100,30 30,30 30,470 150,470 150,500 0,500",
    "190,0 900,0 900,500 240,500 240,470 440,470 440,340 450,340 450,470 870,470 870,30 450,30 450,250 440,250 440,30 190,30",
)
"""Around two rooms of 4.1 by 4.4 and 4.2 by 4.4 m, in cm, with gaps of 0.9 m."""
PIECES = (("Bed", 60, 60, 160, 200), ("Table", 300, 100, 80, 120), ("Chair", 250, 150, 45, 45), ("Sofa", 600, 350, 200, 90))


def flat(pixels: float) -> bytes:
    """Returns the flat with so many pixels a cm; its table has round corners, quarter circles that are no leaves."""
    walls = "".join(f'<polygon points="{one}"/>' for one in WALLS)
    drawn = "".join(f'<rect x="{x}" y="{z}" width="{w}" height="{d}"/>' for _, x, z, w, d in PIECES)
    names = "".join(f'<text x="{x + w / 2}" y="{z + d / 2}">{name}</text>' for name, x, z, w, d in PIECES)
    corners = "".join(f'<path d="M {x} 700 A 3 3 0 0 1 {x + 3} 703 L {x} 703 Z"/>' for x in (600, 620, 640, 660))
    return f'<svg xmlns="http://www.w3.org/2000/svg"><g transform="scale({pixels})">{walls}{drawn}{corners}{names}</g></svg>'.encode()


@pytest.mark.parametrize("pixels", [0.37, 2.9])
def test_pieces_with_names_are_no_rooms_and_round_corners_do_not_tell_the_unit(pixels: float) -> None:
    made = import_plan(flat(pixels))
    assert sorted(room.width - made.scene.wall_thickness for room in made.scene.rooms) == pytest.approx([4.1, 4.2], abs=0.1)
    assert {room.name for room in made.scene.rooms} == {None}
    assert sum("names a piece" in one["reason"] for one in made.unread) == len(PIECES)


def hall(side: float, unit: str) -> bytes:
    """Returns a plan of one room without doors, twice as long as wide."""
    ring = f"[[0, 0], [{side}, 0], [{side}, {2 * side}], [0, {2 * side}]]"
    room = f'{{"properties": {{"name": "Hall"}}, "geometry": {{"type": "Polygon", "coordinates": [{ring}]}}}}'
    return f'{{"type": "FeatureCollection", "unit": "{unit}", "features": [{room}]}}'.encode()


def test_a_room_larger_than_any_is_asked_for_its_unit() -> None:
    with pytest.raises(FieldError, match=r"unit.*is told to be 1 m.*largest room has 352800 m2"):
        import_plan(hall(420, "m"))
    assert import_plan(hall(420, "cm")).scene.rooms[0].width == pytest.approx(4.2)
    assert import_plan(hall(420, "m"), settings=ImportSettings(unit="cm")).scene.rooms[0].width == pytest.approx(4.2)
    assert import_plan(hall(420, "m"), settings=ImportSettings(unit="m")).scene.rooms[0].width == pytest.approx(420)
