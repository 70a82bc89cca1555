"""The rule `unreachable`: gaps at the robot's width and a millimetre less, doors, ways in, use sides."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from solver.answers import Issue
from solver.scene import Furniture, Scene
from solver.validator import metrics, validate
from tests.validator.worlds import CATALOGS, TURNED, WALLS, along, issues, opening, piece, room, scene

MM = 0.001


def named(found: list[Issue]) -> list[tuple[str | None, tuple[str, ...]]]:
    return [(issue.room, issue.ids) for issue in found]


def divided(gap: float, **more: Any) -> Scene:
    """A room whose south half lies behind a row of crates with one gap; the way in is in the north wall."""
    west = piece(0.75, 2.0, 1.5, 0.5, id="west")
    east = piece((1.5 + gap + 4.0) / 2, 2.0, 2.5 - gap, 0.5, id="east")
    sofa = piece(3.2, 2.9, 1.5, 0.6, id="sofa_1", name="sofa")
    door = opening(main_entrance=True, connects_to="EXTERIOR")
    return scene(room(west, east, sofa, openings=(door,)), **more)


@pytest.mark.parametrize(
    ("gap", "robot", "reached"),
    [
        (0.6, None, True),
        (0.599, None, False),
        (0.599, 0.599, True),
        (0.5995, 0.6, False),
        (0.45, 0.45, True),
        (0.65, 0.65, True),
        (0.65, 0.651, False),
    ],
)
def test_gaps_of_exactly_the_robots_width_pass(gap: float, robot: float | None, reached: bool) -> None:
    request = None if robot is None else {"robot_width": robot}
    told = issues(divided(gap, request=request), "unreachable")
    assert named(told) == ([] if reached else [("room_0", ("sofa_1",))])
    assert all(issue.severity == "error" for issue in told)


def test_the_gap_beside_a_wall_is_measured_from_its_face() -> None:
    def told(east_end: float) -> int:
        row = piece(east_end / 2, 2.0, east_end, 0.5)
        sofa = piece(1.0, 3.0, 1.5, 0.6, id="sofa_1", name="sofa")
        door = opening(main_entrance=True, connects_to="EXTERIOR")
        return len(issues(scene(room(row, sofa, openings=(door,)), wall_thickness=0.1), "unreachable"))

    assert told(4.0 - 0.05 - 0.6) == 0
    assert told(4.0 - 0.05 - 0.599) == 1


def test_half_a_micrometre_less_does_not_pass() -> None:
    """Edges lie on half micrometres where a width is odd; the finest gap there is decides."""
    for width, found in ((1.9, []), (1.900001, [("room_0", ("sofa_1",))])):
        west, east = piece(0.75, 2.0, 1.5, 0.5, id="west"), piece(3.05, 2.0, width, 0.5, id="east")
        sofa = piece(3.2, 2.9, 1.5, 0.6, id="sofa_1", name="sofa")
        house = scene(room(west, east, sofa, openings=(opening(main_entrance=True),)))
        assert named(issues(house, "unreachable")) == found


def test_a_reflex_corner_has_a_post() -> None:
    """From an L's east leg to its south leg past a crate in the north-west: only the post's corner is in the way."""
    outline = ((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0))
    for size, found in ((1.35, []), (1.351, [("room_0", ("sofa_1",))])):
        crate = piece(size / 2, size / 2, size, size)
        sofa = piece(1.0, 3.5, 1.0, 0.6, id="sofa_1", name="sofa", rotation=180)
        door = opening("east", 1.0, main_entrance=True)
        house = scene(room(crate, sofa, outline=outline, openings=(door,)), wall_thickness=0.1)
        assert named(issues(house, "unreachable")) == found


def two_rooms(wall: str, width: float, **more: Any) -> Scene:
    """Two rooms beside each other, a door of a width between them, the way in by the first one's far wall."""
    back = {"north": "south", "south": "north", "east": "west", "west": "east"}[wall]
    x, z = {"north": (0.0, -4.0), "south": (0.0, 4.0), "east": (4.0, 0.0), "west": (-4.0, 0.0)}[wall]
    entrance = opening(back, id="entrance", main_entrance=True, connects_to="EXTERIOR")
    door = opening(wall, width=width, connects_to="room_1")
    mirror = opening(back, width=width, connects_to="room_0")
    second = room(id="room_1", x=x, z=z, openings=(mirror,))
    return scene(room(openings=(entrance, door)), second, **more)


@pytest.mark.parametrize("wall", WALLS)
@pytest.mark.parametrize("thickness", [0.0, 0.1])
def test_doors_lead_from_room_to_room(wall: str, thickness: float) -> None:
    assert issues(two_rooms(wall, 0.6, wall_thickness=thickness), "unreachable") == []
    assert named(issues(two_rooms(wall, 0.599, wall_thickness=thickness), "unreachable")) == [("room_1", ())]


def test_a_door_that_only_one_room_lists_leads_through() -> None:
    both = two_rooms("south", 0.9, wall_thickness=0.1)
    first, second = both.rooms
    assert issues(scene(first, room(id="room_1", z=4.0), wall_thickness=0.1), "unreachable") == []
    assert named(issues(scene(room(openings=first.openings[:1]), second), "unreachable")) == []
    assert named(issues(scene(room(openings=first.openings[:1]), room(id="room_1", z=4.0)), "unreachable")) == [("room_1", ())]


@pytest.mark.parametrize("listed", ["by both", "by one"])
def test_rooms_whose_walls_lie_apart_are_joined_by_their_door(listed: str) -> None:
    """As deep as a wall is there: up to 0.6 m, whichever of the rooms lists the door."""
    both = two_rooms("south", 0.9)
    openings = both.rooms[1].openings if listed == "by both" else ()
    for z in (4.2, 4.42, 4.6):
        apart = room(id="room_1", z=z, openings=openings)
        assert issues(scene(both.rooms[0], apart), "unreachable") == []
    far = room(id="room_1", z=4.601, openings=openings)
    assert named(issues(scene(both.rooms[0], far), "unreachable")) == [("room_1", ())]


@pytest.mark.parametrize(("z", "reached"), [(3.75, True), (3.749, False)])
def test_a_door_leads_through_the_wall_of_a_room_that_overlaps_by_25_cm(z: float, reached: bool) -> None:
    first = two_rooms("south", 0.9).rooms[0]
    told = issues(scene(first, room(id="room_1", z=z)), "unreachable")
    assert named(told) == ([] if reached else [("room_1", ())])


def test_a_deep_wall_without_a_door_is_not_walked_through() -> None:
    both = two_rooms("south", 0.9)
    elsewhere = [replace(one, connects_to="room_9", main_entrance=False) for one in both.rooms[0].openings]
    shut = room(openings=(*elsewhere, opening("north", id="front", main_entrance=True)))
    assert ("room_1", ()) in named(issues(scene(shut, room(id="room_1", z=4.4)), "unreachable"))


def test_a_body_in_the_next_room_can_block_a_door() -> None:
    both = two_rooms("south", 0.9)
    for distance, found in ((0.6, []), (0.599, [("room_1", ())])):
        plug = piece(1.5, distance + 1.5, 3.0, 3.0)  # from the west wall to a metre before the east wall
        second = room(plug, id="room_1", z=4.0, openings=both.rooms[1].openings)
        assert named(issues(scene(both.rooms[0], second), "unreachable")) == found
    low = room(piece(2.0, 1.0, 4.0, 1.0, y=2.0), id="room_1", z=4.0, openings=both.rooms[1].openings)
    assert issues(scene(both.rooms[0], low), "unreachable") == []


@pytest.mark.parametrize(("side", "reached"), [(1.1, True), (1.099, False)])
def test_a_room_needs_a_quarter_square_metre_of_free_centres(side: float, reached: bool) -> None:
    told = issues(scene(room(width=side, depth=side)), "unreachable")
    assert named(told) == ([] if reached else [("room_0", ())])
    assert all("0.25 m2" in issue.message and issue.amount == 0.6 for issue in told)


def test_the_way_in_is_the_main_entrance_then_any_outside_door_then_the_largest_patch() -> None:
    def split(**doors: Any) -> Scene:
        wall = piece(1.5, 2.0, 0.2, 4.0, id="wall")
        west = piece(0.2, 2.0, 0.4, 0.4, id="west", name="sofa", rotation=90)
        east = piece(3.8, 2.0, 0.4, 0.4, id="east", name="sofa", rotation=270)
        return scene(room(wall, west, east, openings=tuple(opening(id=name, **door) for name, door in doors.items())))

    west_door, east_door = {"position": 0.7, "connects_to": "EXTERIOR"}, {"position": 3.0, "connects_to": "EXTERIOR"}
    assert named(issues(split(a={**west_door, "main_entrance": True}, b=east_door), "unreachable")) == [("room_0", ("east",))]
    assert issues(split(a=west_door, b=east_door), "unreachable") == []
    assert named(issues(split(b=east_door), "unreachable")) == [("room_0", ("west",))]
    assert named(issues(split(), "unreachable")) == [("room_0", ("west",))]
    assert named(issues(split(a={**west_door, "kind": "window"}), "unreachable")) == [("room_0", ("west",))]


def test_the_largest_patch_is_the_largest_without_what_lies_in_doorways() -> None:
    """East of a wall there is 2 cm more floor than west of it, where the passage is, which leads nowhere."""
    wall = piece(1.99, 2.0, 0.2, 4.0, id="wall")
    west, east = (piece(x, 2.0, 0.4, 0.4, id=f"at {x}", name="sofa", rotation=turn) for x, turn in ((0.2, 90), (3.8, 270)))
    passage = opening(id="a", kind="passage", position=0.7)
    assert named(issues(scene(room(wall, west, east, openings=(passage,))), "unreachable")) == [("room_0", (west.id,))]


def test_a_blocked_entrance_lets_nobody_anywhere() -> None:
    entrance = opening(main_entrance=True)
    told = issues(scene(room(piece(2.0, 0.5), openings=(entrance,)), room(id="room_1", z=4.0)), "unreachable")
    assert named(told) == [("room_0", ()), ("room_1", ())]
    assert "door_1" in told[0].message


def test_storeys_are_walked_apart() -> None:
    door = opening(main_entrance=True)
    upstairs = room(piece(2.0, 2.0, 4.0, 4.0), id="room_1", level=1)
    assert named(issues(scene(room(openings=(door,)), upstairs), "unreachable")) == [("room_1", ())]
    assert issues(scene(room(openings=(door,)), room(id="room_1", level=1)), "unreachable") == []


# --- use sides -------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("wall", WALLS)
def test_a_use_side_needs_the_robots_width_before_it(wall: str) -> None:
    """A sofa with its back to a wall, a row of crates before it with a way around at one end."""
    for distance, found in ((0.6, []), (0.599, [("room_0", ("sofa_1",))])):
        x, z = along(wall, 2.0, 0.5)
        sofa = piece(x, z, 1.0, 1.0, id="sofa_1", name="sofa", rotation=TURNED[wall])
        x, z = along(wall, 2.0, 1.0 + distance + 0.25)
        row = piece(x, z, 2.4, 0.5, rotation=TURNED[wall])
        assert named(issues(scene(room(sofa, row)), "unreachable")) == found


@pytest.mark.parametrize("wall", WALLS)
@pytest.mark.parametrize("end", [-1, 1])
def test_the_centre_stays_within_the_sides_extent(wall: str, end: int) -> None:
    """Before a sofa 1 m wide, crates leave the floor free from one of its corners on: the centre just gets there."""
    for shift, found in ((0.0, []), (MM, [("room_0", ("sofa_1",))])):
        x, z = along(wall, 2.0, 0.5)
        sofa = piece(x, z, 1.0, 1.0, id="sofa_1", name="sofa", rotation=TURNED[wall])
        x, z = along(wall, 2.0 + end * (0.2 + shift - 1.0), 2.0)
        row = piece(x, z, 2.0, 2.0, rotation=TURNED[wall])
        assert named(issues(scene(room(sofa, row)), "unreachable")) == found


def beside(body: Furniture, blocked: str) -> Scene:
    """A body in the middle of a room with a crate against one of its sides."""
    x, z = {"north": (2.0, 0.75), "south": (2.0, 3.25), "west": (0.75, 2.0), "east": (3.25, 2.0)}[blocked]
    return scene(room(body, piece(x, z, 1.5, 1.5)))


SIDES_AT: dict[float, str] = {0: "south", 90: "east", 180: "north", 270: "west", 360: "south", -90: "west", 88: "east"}


@pytest.mark.parametrize("rotation", SIDES_AT)
def test_the_front_turns_with_the_piece(rotation: float) -> None:
    for blocked in WALLS:
        sofa = piece(2.0, 2.0, id="sofa_1", name="sofa", rotation=rotation)
        assert len(issues(beside(sofa, blocked), "unreachable")) == (blocked == SIDES_AT[rotation])


@pytest.mark.parametrize(("rotation", "right"), [(0, "east"), (90, "north"), (180, "west"), (270, "south")])
def test_the_right_side_is_east_of_a_piece_that_faces_south(rotation: float, right: str) -> None:
    for blocked in WALLS:
        desk = piece(2.0, 2.0, id="desk_1", name="desk", rotation=rotation)
        assert len(issues(beside(desk, blocked), "unreachable")) == (blocked == right)


def test_any_side_will_do_unless_all_are_needed() -> None:
    bed = piece(2.0, 2.0, id="bed_1", name="bed")
    assert issues(beside(bed, "east"), "unreachable") == []
    both = scene(room(bed, piece(0.75, 2.0, 1.5, 1.5), piece(3.25, 2.0, 1.5, 1.5, id="crate_2")))
    (told,) = issues(both, "unreachable")
    assert "left (west) or its right (east)" in told.message
    stove = piece(2.0, 2.0, id="stove_1", name="stove")
    assert issues(beside(stove, "east"), "unreachable") == []
    for blocked in ("south", "west"):
        (told,) = issues(beside(stove, blocked), "unreachable")
        assert blocked in told.message


def test_unknown_pieces_and_crates_ask_for_nothing() -> None:
    assert issues(beside(piece(2.0, 2.0, id="x", name="thingamajig"), "south"), "unreachable") == []


# --- measures --------------------------------------------------------------------------------------------------------
def test_measures_of_a_room() -> None:
    bed = piece(0.55, 1.05, 1.0, 2.0, id="bed_1", name="bed")
    pillow = piece(0.55, 0.5, 0.5, 0.5, id="pillow_1", y=1.0, on="bed_1")
    measured = metrics(scene(room(bed, pillow, openings=(opening(main_entrance=True),)), wall_thickness=0.1), CATALOGS)
    assert measured["counts"] == {"rooms": 1, "doors": 1, "windows": 0, "furniture": 2, "decorations": 0, "dynamic": 0}
    assert measured["area"] == 16.0
    (measures,) = measured["rooms"].values()
    assert measures["clear_area"] == round(3.9**2, 4)
    assert measures["cover"] == measured["cover"] == round(2.0 / 3.9**2, 4)
    # Centres: 3.3 x 3.3 m less the bed's strip grown by 0.3 (x to 1.35, z to 2.35); those in the doorway do not count.
    walkable = 3.3**2 - 1.0 * 2.0
    assert measures["walkable"] == pytest.approx(walkable / 3.9**2, abs=1e-4)
    assert measured["use_sides"] == {"wanted": 1, "reached": 1}
    assert (measured["reached"], measures["reached"]) == (1, True)


def test_measures_of_an_outline_and_of_nothing() -> None:
    outline = ((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0))
    measured = metrics(scene(room(outline=outline), wall_thickness=0.1))
    assert measured["area"] == 12.0
    assert measured["rooms"]["room_0"]["clear_area"] == round(3.9 * 1.9 + 1.9 * 2.0, 4)
    assert metrics(scene())["cover"] == 0.0
    assert validate(scene(), CATALOGS) == ()


def test_a_room_without_a_door_is_told_so_and_behind_which_wall_another_lies() -> None:
    """Two rooms lie beside it, one along 4 and one along 1.5 m; one above shares as much, one that touches a corner nothing."""
    entered = room(id="hall", x=4.0, openings=(opening("east", main_entrance=True),))
    small = room(id="small", z=4.0, width=1.5, openings=(opening("south", 0.7, id="door_2", main_entrance=True),))
    above, apart = room(id="above", x=-4.0, level=1), room(id="apart", x=4.0, z=4.0)
    window = opening("west", id="window_1", kind="window")
    told = {}
    for number, (hall, holes) in enumerate(((entered, ()), (entered, (window,)), (replace(entered, x=4.1), ()))):
        house = scene(room(id="bare", openings=holes), hall, small, above, apart)
        told[number] = next(issue.message for issue in issues(house, "unreachable") if issue.room == "bare")
    most = "bare has no door or passage; it shares 4.00 m of its east wall with hall"
    assert told == {0: most, 1: most, 2: "bare has no door or passage; it shares 1.50 m of its south wall with small"}


def test_a_room_without_a_door_beside_nothing_is_told_that_alone() -> None:
    house = scene(room(id="hall", openings=(opening(main_entrance=True),)), room(id="bare", x=9.0))
    assert [issue.message for issue in issues(house, "unreachable")] == ["bare has no door or passage"]


def test_a_room_whose_door_another_lists_is_not_told_to_have_none() -> None:
    hall = room(id="hall", openings=(opening(main_entrance=True), opening("east", id="door_2", width=0.5, connects_to="bare")))
    (issue,) = issues(scene(hall, room(id="bare", x=4.0)), "unreachable")
    assert "no door" not in issue.message
