"""The space of a room: the rectangles of docs/scene.md, in numbers worked out by hand."""

from __future__ import annotations

import pytest

from solver import Request, generate
from solver.furnish import space_of, zones
from solver.geometry import Rect
from solver.scene import Opening, Room

L_SHAPE = ((0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (4.0, 3.0), (4.0, 5.0), (0.0, 5.0))


def room(*openings: Opening, outline: tuple[tuple[float, float], ...] | None = None) -> Room:
    return Room("r", width=6.0, depth=5.0, openings=openings, outline=outline)


def test_the_clear_rectangle_is_half_a_wall_in() -> None:
    assert space_of(room(), 0.1).clear == Rect(50, 50, 5950, 4950)
    assert space_of(room(), 0.0).clear == Rect(0, 0, 6000, 5000)


def test_the_walker_is_as_wide_as_asked() -> None:
    assert space_of(room(), 0.1).robot_mm == 600
    assert space_of(room(), 0.1, 0.75).robot_mm == 750


@pytest.mark.parametrize(
    ("wall", "rect"),
    [
        ("north", Rect(1550, 0, 2450, 900)),
        ("south", Rect(1550, 4100, 2450, 5000)),
        ("west", Rect(0, 1550, 900, 2450)),
        ("east", Rect(5100, 1550, 6000, 2450)),
    ],
)
def test_a_door_keeps_its_square_free_for_every_body(wall: str, rect: Rect) -> None:
    space = space_of(room(Opening("d", "door", wall, 2.0, 0.9, connects_to="hall")), 0.1)
    (zone,) = space.zones
    assert (zone.rect, zone.cause) == (rect, "d")
    assert zone.above_mm < 0
    (doorway,) = space.doorways
    assert (doorway.square, doorway.wall, doorway.connects_to) == (rect, wall, "hall")


@pytest.mark.parametrize(("width", "depth"), [(0.8, 800), (0.9, 900), (1.6, 900)])
def test_a_square_is_as_deep_as_the_door_is_wide_but_at_most_900(width: float, depth: int) -> None:
    (zone,) = space_of(room(Opening("d", "passage", "north", 3.0, width)), 0.1).zones
    assert (zone.rect.width, zone.rect.depth) == (round(width * 1000), depth)


def test_a_window_keeps_tall_things_away() -> None:
    space = space_of(room(Opening("w", "window", "east", 2.5, 1.2, 1.4, 0.9)), 0.1)
    (zone,) = space.zones
    assert zone.rect == Rect(5500, 1800, 6000, 3200)
    assert zone.above_mm == 900
    assert space.doorways == ()


def test_a_garage_door_has_no_square_but_is_walked_through() -> None:
    space = space_of(room(Opening("g", "garage_door", "south", 3.0, 2.4)), 0.1)
    assert space.zones == ()
    assert [(doorway.id, doorway.wall, doorway.square.along("south")) for doorway in space.doorways] == [("g", "south", (1800, 4200))]


def test_only_what_lies_inside_the_room_counts() -> None:
    (zone,) = space_of(room(Opening("d", "door", "north", 0.2, 0.9)), 0.1).zones
    assert zone.rect == Rect(0, 0, 650, 900)
    assert space_of(room(Opening("d", "door", "north", 9.0, 0.9)), 0.1).zones == ()


@pytest.mark.parametrize("opening", [Opening("d", "door", None, 1.0), Opening("d", "door", None, 1.0, edge=9)])
def test_an_opening_in_no_wall_keeps_nothing_free(opening: Opening) -> None:
    assert space_of(room(opening), 0.1).zones == ()


def test_missing_parts_are_zones_half_a_wall_larger() -> None:
    (zone,) = space_of(room(outline=L_SHAPE), 0.1).zones
    assert zone.rect == Rect(3950, 2950, 6000, 5000)
    assert (zone.cause, zone.above_mm < 0) == ("outline", True)


def test_missing_parts_of_a_stair_cover_what_is_outside_and_nothing_else() -> None:
    stair = ((0.0, 1.0), (2.0, 1.0), (2.0, 0.0), (4.0, 0.0), (4.0, 1.5), (6.0, 1.5), (6.0, 5.0), (0.0, 5.0))
    zones = [zone.rect for zone in space_of(room(outline=stair), 0.0).zones]
    for x in range(250, 6000, 500):
        for z in range(250, 5000, 500):
            inside = z > 1500 or (x < 4000 and z > 1000) or 2000 < x < 4000
            covered = sum(rect.x0 < x < rect.x1 and rect.z0 < z < rect.z1 for rect in zones)
            assert covered == (0 if inside else 1), (x, z)


def test_missing_parts_of_a_comb_of_many_corners_are_found_in_few_steps() -> None:
    comb = [(x, z) for k in range(600) for x, z in ((k, 1.0), (k, 4.0), (k + 0.5, 4.0), (k + 0.5, 1.0))]
    corners = tuple((float(x), z) for x, z in [*comb, (599.5, 0.0), (0.0, 0.0)])
    zones = [zone.rect for zone in space_of(room(outline=corners), 0.0).zones]
    assert zones == [Rect(k * 1000 + 500, 1000, k * 1000 + 1000, 4000) for k in range(599)]


def test_corners_a_micrometre_apart_harm_nothing() -> None:
    corners = ((0.0, 0.0), (4.0004999, 0.0), (4.0005001, 3.0), (6.0, 3.0), (6.0, 5.0), (0.0, 5.0))
    (zone, *slivers) = sorted((zone.rect for zone in space_of(room(outline=corners), 0.0).zones), key=lambda rect: -rect.width)
    assert zone.common(Rect(4001, 0, 6000, 3000)) == Rect(4001, 0, 6000, 3000)
    assert all(rect.width <= 3 for rect in slivers)


@pytest.mark.parametrize(
    ("edge", "position", "rect"),
    [
        (0, 2.0, Rect(1550, 0, 2450, 900)),  # north
        (1, 1.5, Rect(5100, 1050, 6000, 1950)),  # east, the upper arm's end
        (2, 1.0, Rect(4550, 2100, 5450, 3000)),  # south side of the upper arm, from x = 4
        (3, 1.0, Rect(3100, 3550, 4000, 4450)),  # east side of the lower arm, from z = 3
        (4, 2.0, Rect(1550, 4100, 2450, 5000)),  # south
        (5, 2.5, Rect(0, 2050, 900, 2950)),  # west
    ],
)
def test_an_opening_may_name_an_edge_of_the_outline(edge: int, position: float, rect: Rect) -> None:
    space = space_of(room(Opening("d", "door", None, position, 0.9, edge=edge), outline=L_SHAPE), 0.1)
    assert [zone.rect for zone in space.zones if zone.cause == "d"] == [rect]
    assert space.doorways[0].wall == ("north", "east", "south", "east", "south", "west")[edge]


def test_each_opening_of_a_home_is_sought_in_its_wall_once(monkeypatch: pytest.MonkeyPatch) -> None:
    sought, seek = list[str](), zones._line_among

    def seeking(lines: Rect, edges: list[zones.WallLine], opening: Opening) -> zones.WallLine | None:
        sought.append(opening.id)
        return seek(lines, edges, opening)

    monkeypatch.setattr(zones, "_line_among", seeking)
    made = generate(Request(program="studio", seed=3)).scene
    assert sorted(sought) == sorted(opening.id for room in made.rooms for opening in room.openings)
