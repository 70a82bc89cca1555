"""The rules of standing bodies, on worlds of two: at the limit nothing, a millimetre beyond an issue, at every wall."""

from __future__ import annotations

from typing import Any

import pytest

from solver.scene import Decoration, Dynamic, Furniture, Level, Size
from tests.validator.worlds import TURNED, WALLS, along, issues, opening, piece, room, scene

MM = 0.001
HALF_WALL = 0.05


# --- out_of_bounds -------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("wall", WALLS)
@pytest.mark.parametrize(("thickness", "margin"), [(0.0, 0.0), (0.1, HALF_WALL)])
def test_a_body_may_touch_the_clear_area_and_not_leave_it(wall: str, thickness: float, margin: float) -> None:
    for beyond, found in ((0.0, 0), (MM, 1)):
        x, z = along(wall, 2.0, margin + 0.3 - beyond)
        body = piece(x, z, 1.0, 0.6, rotation=TURNED[wall])
        told = issues(scene(room(body), wall_thickness=thickness), "out_of_bounds")
        assert len(told) == found
        for issue in told:
            assert (issue.severity, issue.room, issue.ids, issue.amount) == ("error", "room_0", ("crate_1",), 0.001)
            assert wall in issue.message
            assert "0.1 cm" in issue.message


def test_half_millimetre_centres_are_exact() -> None:
    assert issues(scene(room(piece(0.5005, 2.0005, 1.001, 1.001))), "out_of_bounds") == []
    assert [issue.amount for issue in issues(scene(room(piece(0.5, 2.0, 1.001, 1.001))), "out_of_bounds")] == [0.0005]


def test_an_odd_angle_counts_as_its_bounding_rectangle() -> None:
    half = 0.70710678  # half the diagonal of a square metre
    assert issues(scene(room(piece(half + 1e-6, 2.0, rotation=45))), "out_of_bounds") == []
    assert len(issues(scene(room(piece(half - MM, 2.0, rotation=45))), "out_of_bounds")) == 1
    assert issues(scene(room(piece(0.3, 2.0, 2.0, 0.6, rotation=-90))), "out_of_bounds") == []


L_SHAPE = ((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0))
U_SHAPE = ((0.0, 0.0), (1.0, 0.0), (1.0, 3.0), (3.0, 3.0), (3.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0))
T_SHAPE = ((0.0, 0.0), (4.0, 0.0), (4.0, 1.5), (3.0, 1.5), (3.0, 4.0), (1.0, 4.0), (1.0, 1.5), (0.0, 1.5))


@pytest.mark.parametrize("outline", [L_SHAPE, L_SHAPE[::-1], (*L_SHAPE[2:], *L_SHAPE[:2])])
def test_an_outline_ends_the_clear_area_at_its_reflex_corner(outline: tuple[tuple[float, float], ...]) -> None:
    def told(x: float, z: float) -> list[float]:
        house = scene(room(piece(x, z), outline=outline), wall_thickness=0.1)
        return [issue.amount for issue in issues(house, "out_of_bounds")]

    assert told(1.45, 1.45) == []
    assert told(1.45, 3.0) == []
    assert told(3.0, 1.45) == []
    assert told(1.451, 3.0) == [0.001]
    assert told(3.0, 1.451) == [0.001]
    assert told(1.5, 1.5) == [0.05]  # the wall's post at the reflex corner
    assert told(3.0, 3.0) == [1.1]  # all of it, and half a wall on either side


@pytest.mark.parametrize(("outline", "good", "bad"), [(U_SHAPE, (2.0, 3.5), (2.0, 3.499)), (T_SHAPE, (1.5, 3.0), (1.499, 3.0))])
def test_every_rectilinear_outline_is_honoured(
    outline: tuple[tuple[float, float], ...], good: tuple[float, float], bad: tuple[float, float]
) -> None:
    assert issues(scene(room(piece(*good), outline=outline)), "out_of_bounds") == []
    assert [issue.amount for issue in issues(scene(room(piece(*bad), outline=outline)), "out_of_bounds")] == [0.001]


def test_people_are_bodies_and_one_without_a_room_is_nowhere() -> None:
    def told(**where: Any) -> list[tuple[str | None, tuple[str, ...]]]:
        person = Dynamic(id="person_1", width=0.5, depth=0.5, **where)
        house = scene(room(), room(id="room_1", x=4.0), dynamic=(person,))
        return [(issue.room, issue.ids) for issue in issues(house, "out_of_bounds")]

    assert told(room="room_1", x=0.25, z=0.25) == []
    assert told(room="room_1", x=0.249, z=0.25) == [("room_1", ("person_1",))]
    assert told(room="cellar", x=1.0, z=1.0) == [(None, ("person_1",))]
    assert told(x=1.0, z=1.0) == [(None, ("person_1",))]
    alone = scene(room(), dynamic=(Dynamic(id="person_1", x=0.2, z=2.0),))
    assert [issue.room for issue in issues(alone, "out_of_bounds")] == ["room_0"]


# --- overlap ---------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("dx", "dz"), [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)])
def test_bodies_may_touch_and_not_share_space(dx: float, dz: float) -> None:
    for nearer, found in ((0.0, []), (MM, [0.001])):
        other = piece(2.0 + dx - nearer * (dx > 0) + nearer * (dx < 0), 2.0 + dz - nearer * (dz > 0) + nearer * (dz < 0), id="crate_2")
        told = issues(scene(room(piece(2.0, 2.0), other)), "overlap")
        assert [issue.amount for issue in told] == found
        assert all(issue.ids == ("crate_1", "crate_2") and issue.severity == "error" for issue in told)


def test_heights_count() -> None:
    assert issues(scene(room(piece(2.0, 2.0), piece(2.0, 2.0, id="crate_2", y=1.0))), "overlap") == []
    sunk = issues(scene(room(piece(2.0, 2.0), piece(2.0, 2.0, id="crate_2", y=0.999))), "overlap")
    assert [issue.amount for issue in sunk] == [0.001]


def test_a_thing_may_stand_on_another_but_not_on_any() -> None:
    stand, screen = piece(2.0, 2.0, id="stand_1"), piece(2.0, 2.0, id="tv_1", y=0.5, on="stand_1")
    assert issues(scene(room(stand, screen)), "overlap") == []
    assert issues(scene(room(screen, stand)), "overlap") == []
    told = issues(scene(room(stand, screen, piece(2.0, 2.0, id="crate_1"))), "overlap")
    assert [issue.ids for issue in told] == [("stand_1", "crate_1"), ("tv_1", "crate_1")]


@pytest.mark.parametrize("wall", WALLS)
def test_a_chair_is_tucked_by_its_depth_less_what_sitting_takes(wall: str) -> None:
    """A table in the middle, 1 x 1 m; a chair 0.6 deep before the side of `wall`, facing the table."""
    facing = {"north": 0, "west": 90, "south": 180, "east": 270}[wall]
    for tucked, found in ((0.45, []), (0.451, [0.001]), (0.6, [0.15]), (1.0, [0.15])):
        x, z = along(wall, 2.0, 1.5 - 0.3 + tucked)
        chair = piece(x, z, 0.5, 0.6, id="chair_1", rotation=facing, under="table_1")
        told = issues(scene(room(piece(2.0, 2.0, id="table_1"), chair)), "overlap")
        assert [issue.amount for issue in told] == found
        assert all(issue.ids == ("chair_1", "table_1") for issue in told)


def test_a_chair_is_tucked_under_its_own_table_only() -> None:
    chair = piece(2.0, 1.4, 0.5, 0.6, id="chair_1", under="table_2")
    told = issues(scene(room(piece(2.0, 2.0, id="table_1"), chair)), "overlap")
    assert [issue.ids for issue in told] == [("table_1", "chair_1")]


def test_rugs_are_not_bodies_and_taller_floor_decorations_are() -> None:
    def told(**more: Any) -> int:
        values: dict[str, Any] = {"x": 2.0, "z": 2.0, "width": 1.0, "depth": 1.0, "height": 0.021, **more}
        plant = Decoration(id="plant_1", name="plant", **values)
        return len(issues(scene(room(piece(2.0, 2.0), decorations=(plant,))), "overlap"))

    assert told() == 1
    assert told(height=0.02) == 0
    assert told(y=0.5) == 0
    assert told(parent="crate_1") == 0
    assert told(mounted_on_wall="north") == 0
    assert issues(scene(room(piece(2.0, 2.0), piece(2.0, 2.0, id="mat_1", height=0.02))), "overlap") == []


def test_every_pair_is_named_once_in_the_documents_order() -> None:
    bodies = [piece(2.5, 2.0, id="c"), piece(2.0, 2.0, id="a"), piece(1.5, 2.0, id="b"), piece(3.5, 3.5, id="d")]
    assert [issue.ids for issue in issues(scene(room(*bodies)), "overlap")] == [("c", "a"), ("a", "b")]


# --- wall_far --------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("wall", WALLS)
def test_a_piece_with_a_wall_stands_within_20_cm_of_its_line(wall: str) -> None:
    for distance, found in ((0.2, []), (0.201, [0.001]), (0.0, [])):
        x, z = along(wall, 2.0, distance + 0.3)
        body = piece(x, z, 1.0, 0.6, rotation=TURNED[wall], wall=wall)
        told = issues(scene(room(body), wall_thickness=0.1), "wall_far")
        assert [issue.amount for issue in told] == found
        assert all(issue.severity == "error" and wall in issue.message for issue in told)


@pytest.mark.parametrize("wall", WALLS)
def test_of_a_thick_wall_the_face_counts(wall: str) -> None:
    for distance, found in ((0.33, []), (0.331, [0.001]), (0.18, [])):
        x, z = along(wall, 2.0, distance + 0.3)
        body = piece(x, z, 1.0, 0.6, rotation=TURNED[wall], wall=wall)
        told = issues(scene(room(body), wall_thickness=0.36), "wall_far")
        assert [issue.amount for issue in told] == found


def test_a_piece_without_a_wall_may_stand_anywhere_and_one_outside_is_far() -> None:
    assert issues(scene(room(piece(2.0, 2.0))), "wall_far") == []
    assert [issue.amount for issue in issues(scene(room(piece(2.0, -1.0, wall="north"))), "wall_far")] == [0.3]


def test_the_wall_of_an_outline_is_the_piece_before_it() -> None:
    def far(x: float, z: float) -> list[float]:
        return [issue.amount for issue in issues(scene(room(piece(x, z, wall="south"), outline=L_SHAPE)), "wall_far")]

    assert far(3.5, 1.3) == []
    assert far(3.5, 1.299) == [0.001]
    assert far(1.0, 3.3) == []
    assert far(1.0, 1.5) == [1.8]


# --- blocks_door -----------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("wall", WALLS)
@pytest.mark.parametrize(("width", "deep"), [(0.8, 0.8), (0.9, 0.9), (1.6, 0.9)])
@pytest.mark.parametrize("kind", ["door", "passage"])
def test_a_door_keeps_its_square_free(wall: str, width: float, deep: float, kind: str) -> None:
    door = opening(wall, 2.0, width=width, kind=kind)

    def told(position: float, distance: float) -> list[float]:
        x, z = along(wall, position, distance)
        return [issue.amount for issue in issues(scene(room(piece(x, z), openings=(door,)), wall_thickness=0.1), "blocks_door")]

    assert told(2.0, deep + 0.5) == []
    assert told(2.0, deep + 0.499) == [0.001]
    assert told(2.0 - width / 2 - 0.5, 0.6) == []
    assert told(2.0 - width / 2 - 0.499, 0.6) == [0.001]
    assert told(2.0 + width / 2 + 0.5, 0.6) == []
    assert told(2.0 + width / 2 + 0.499, 0.6) == [0.001]


def test_a_garage_door_and_a_window_have_no_square() -> None:
    for kind in ("garage_door", "window"):
        blocked = scene(room(piece(2.0, 0.5, height=0.5), openings=(opening(kind=kind, sill=0.9 if kind == "window" else 0.0),)))
        assert issues(blocked, "blocks_door") == []


def test_what_hangs_above_a_door_does_not_stand_in_it() -> None:
    for y, found in ((2.1, 0), (2.099, 1)):
        assert len(issues(scene(room(piece(2.0, 0.5, y=y), openings=(opening(),))), "blocks_door")) == found


@pytest.mark.parametrize("lists_it", [True, False])
@pytest.mark.parametrize(("wall", "x", "z"), [("south", 0.0, 4.0), ("north", 0.0, -4.0), ("east", 4.0, 0.0), ("west", -4.0, 0.0)])
def test_a_door_keeps_its_square_free_in_the_other_room_too(wall: str, x: float, z: float, lists_it: bool) -> None:
    """Whether the other room lists the door or not; the rooms lie side by side, shifted by half a metre."""
    back = {"north": "south", "south": "north", "east": "west", "west": "east"}[wall]
    shift = (0.5, 0.0) if wall in ("north", "south") else (0.0, 0.5)
    door = opening(wall, 2.0, connects_to="room_1")
    mirror = opening(back, 1.5, connects_to="room_0")
    for distance, found in ((1.4, []), (1.399, ["room_1"])):
        px, pz = along(back, 1.5, distance)
        other = room(piece(px, pz), id="room_1", x=x + shift[0], z=z + shift[1], openings=(mirror,) if lists_it else ())
        told = issues(scene(room(openings=(door,)), other), "blocks_door")
        assert [issue.room for issue in told] == found


def test_a_door_on_an_edge_of_an_outline() -> None:
    """Edge 2 of the L runs from (4, 2) to (2, 2): a south wall, its positions from its west end."""
    for z, found in ((0.6, 0), (0.601, 1)):
        door = opening(None, 0.5, edge=2)
        assert len(issues(scene(room(piece(2.5, z), outline=L_SHAPE, openings=(door,))), "blocks_door")) == found
    reversed_l = L_SHAPE[::-1]
    door = opening(None, 0.5, edge=2)  # from (2, 2) to (4, 2), the same wall
    assert len(issues(scene(room(piece(2.5, 0.601), outline=reversed_l, openings=(door,))), "blocks_door")) == 1


def test_a_wall_of_an_outline_is_where_the_opening_is() -> None:
    """`wall: south` at 3 m is the short leg's south wall, at 1 m the long leg's."""
    short, long = opening("south", 3.0), opening("south", 1.0)
    assert len(issues(scene(room(piece(3.0, 1.4), outline=L_SHAPE, openings=(short,))), "blocks_door")) == 1
    assert len(issues(scene(room(piece(1.0, 3.4), outline=L_SHAPE, openings=(long,))), "blocks_door")) == 1
    assert issues(scene(room(piece(1.0, 1.4), outline=L_SHAPE, openings=(long,))), "blocks_door") == []


def test_an_opening_in_no_wall_is_nowhere() -> None:
    assert issues(scene(room(piece(0.5, 0.5), openings=(opening(None, 0.5),))), "blocks_door") == []


def test_people_stand_in_doors_too() -> None:
    person = Dynamic(id="person_1", room="room_0", x=2.0, z=0.5)
    told = issues(scene(room(openings=(opening(),)), dynamic=(person,)), "blocks_door")
    assert [issue.ids for issue in told] == [("person_1",)]


# --- blocks_window ---------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("wall", WALLS)
def test_a_tall_piece_leaves_a_window_free(wall: str) -> None:
    window = opening(wall, 2.0, id="window_1", kind="window", width=1.2, height=1.2, sill=0.9)

    def told(position: float, distance: float, height: float = 0.901, **more: float) -> list[float]:
        x, z = along(wall, position, distance)
        body = piece(x, z, height=height, **more)
        return [issue.amount for issue in issues(scene(room(body, openings=(window,)), wall_thickness=0.1), "blocks_window")]

    assert told(2.0, 1.0) == []
    assert told(2.0, 0.999) == [0.001]
    assert told(2.0, 0.6, height=0.9) == []
    assert told(2.0 - 0.7 - 0.5, 0.6) == []
    assert told(2.0 - 0.7 - 0.499, 0.6) == [0.001]
    assert told(2.0 + 0.7 + 0.5, 0.6) == []
    assert told(2.0 + 0.7 + 0.499, 0.6) == [0.001]
    assert told(2.0, 0.6, y=2.1) == []
    assert told(2.0, 0.6, y=0.1, height=0.8) == []
    assert len(told(2.0, 0.6, y=0.1, height=0.801)) == 1


def test_people_may_look_out_of_windows() -> None:
    window = opening(kind="window", sill=0.9)
    person = Dynamic(id="person_1", x=2.0, z=0.3)
    assert issues(scene(room(openings=(window,)), dynamic=(person,)), "blocks_window") == []


# --- above_ceiling ---------------------------------------------------------------------------------------------------

HOUSE = Size(4.0, 4.0, 2.5)


def too_high(*pieces: Furniture, levels: tuple[Level, ...] = (), size: Size | None = HOUSE, **more: Any) -> list[tuple[str, float]]:
    found = issues(scene(room(*pieces, **more), levels=levels, size=size), "above_ceiling")
    assert {issue.severity for issue in found} <= {"error"}
    return [(issue.ids[0], issue.amount) for issue in found]


def test_what_is_as_high_as_its_room_fits_it() -> None:
    assert too_high(piece(2, 2, height=2.5)) == []
    assert too_high(piece(2, 2, height=2.501)) == [("crate_1", pytest.approx(0.001))]
    assert too_high(piece(2, 2, height=0.5, y=2.0)) == []
    assert too_high(piece(2, 2, height=0.5, y=2.001)) == [("crate_1", pytest.approx(0.001))]
    assert too_high(piece(2, 2, height=900.0)) == [("crate_1", pytest.approx(897.5))]
    (told,) = issues(scene(room(piece(2, 2, height=2.62)), size=HOUSE), "above_ceiling")
    assert told.message == "crate_1 reaches 12 cm above the ceiling of room_0, which is 2.50 m high"


def test_the_storey_says_how_high_a_room_is_before_the_house_does() -> None:
    high, low = Level(0, 0.0, 3.1), Level(1, 3.1, 1.9)
    crate = piece(2, 2, height=3.0)
    assert too_high(crate, levels=(high, low)) == []
    assert too_high(crate, levels=(high, low), level=1) == [("crate_1", pytest.approx(1.1))]
    assert too_high(crate) == [("crate_1", pytest.approx(0.5))]
    assert too_high(crate, size=None) == []


def test_the_height_of_a_house_of_storeys_is_none_of_a_room() -> None:
    tower = scene(room(piece(2, 2, height=7.0)), room(id="room_1", level=1), size=Size(4.0, 4.0, 6.0))
    assert issues(tower, "above_ceiling") == []


def test_small_things_are_judged_wherever_they_are_people_and_gardens_are_not() -> None:
    things = (
        Decoration("hung", "frame", mounted_on_wall="north", x=2, y=2.0, z=0.02, width=0.5, depth=0.03, height=0.6),
        Decoration("lying", "vase", parent="crate_1", x=2, y=2.4, z=2, width=0.2, depth=0.2, height=0.2),
        Decoration("low", "vase", x=1, z=1, width=0.2, depth=0.2, height=0.2),
    )
    crate = piece(2, 2, height=2.4)
    assert [name for name, _ in too_high(crate, decorations=things)] == ["hung", "lying"]
    assert too_high(piece(2, 2, height=9.0), outdoor=True, decorations=things) == []
    person = Dynamic("giant", room="room_0", x=2, z=2, height=2.6)
    assert issues(scene(room(), size=HOUSE, dynamic=(person,)), "above_ceiling") == []
