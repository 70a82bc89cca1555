"""What a room wants: order, number, chance, and what every alternative must be."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver.furnish import space_of, unwanted_pieces, wanted_pieces
from solver.pieces import Piece, Stand
from solver.placement import arrange
from solver.scene import Opening, Room
from solver.streams import Stream
from tests.every import every
from tests.furnish.reference.stage import LIMIT
from tests.furnish.worlds import DOOR, WINDOW, ask, box_of, catalog, clear_of_zones, den, piece

KNOWN = load_catalogs()
types = every("room_type", sorted(KNOWN.rooms))


def furnished(room_type: str, area: float, aspect: float, seed: int = 3) -> tuple[Room, tuple[Piece, ...]]:
    width, depth = round(math.sqrt(area * aspect), 2), round(math.sqrt(area / aspect), 2)
    openings = (
        Opening("door_1", "door", "south", round(width / 2, 3), 0.9, connects_to="hall"),
        Opening("door_2", "door", "west", round(depth - 0.6, 3), 0.9, connects_to="hall"),
        Opening("window_1", "window", "north", round(width / 2, 3), 1.2, 1.4, 0.9),
    )
    room = Room("r", 0, room_type, width=width, depth=depth, openings=openings)
    wanted = wanted_pieces(room, space_of(room, 0.1), KNOWN, Stream(seed, "furnish", 0))
    return room, tuple(piece for piece in wanted if not piece.is_floor)


def test_an_unknown_type_wants_nothing() -> None:
    room = Room("r", 0, "observatory", width=5.0, depth=4.0)
    assert wanted_pieces(room, space_of(room, 0.1), KNOWN, Stream(1, "furnish", 0)) == ()


def test_required_pieces_come_first_then_importance() -> None:
    labels = [one.label for one in ask(den(), piece("pot"), piece("table", required=True, count=2), piece("shelf"))]
    assert labels == ["table_1", "table_2", "pot_1", "shelf_1"]


@pytest.mark.parametrize(("more", "number"), [
    ({"count": 3}, 3), ({"min_area": 21}, 0), ({"min_area": 20}, 1), ({"count": 5, "per_area": 6}, 3),
    ({"count": 2, "per_area": 6}, 2), ({"per_area": 60}, 1),
])  # fmt: skip
def test_the_number_of_optional_pieces_follows_the_area(more: dict[str, float], number: int) -> None:
    assert len(ask(den(), piece("pot", **more))) == number


def test_chance_is_drawn_from_the_seed() -> None:
    there = [len(ask(den(), piece("pot", chance=0.3), seed=seed)) for seed in range(400)]
    assert 80 < sum(there) < 160
    assert there == [len(ask(den(), piece("pot", chance=0.3), seed=seed)) for seed in range(400)]


def test_of_a_piece_whose_place_is_at_one_that_is_not_wanted_that_is_said() -> None:
    rule = {"type": "beside", "of": ["couch"], "required": True}
    room, pieces = den(), [piece("couch", min_area=100), piece("pot", rule)]
    space, catalogs = space_of(room, 0.1), catalog(pieces)
    wanted = wanted_pieces(room, space, catalogs, Stream(1, "furnish", 0))
    unwanted = dict(unwanted_pieces(room, space, catalogs, Stream(1, "furnish", 0), wanted))
    assert unwanted == {"couch": "needs 100 m2", "pot": "it has to be beside couch, and none is wanted"}


def test_variants_may_need_an_area() -> None:
    couch = piece("couch", kinds=[{"kind": "couch", "min_area": 21}, {"kind": "short_couch", "cost": 1}])
    assert {a.kind for a in ask(den(), couch)[0].candidates} == {"short_couch"}
    assert {a.kind for a in ask(den(width=6.0), couch)[0].candidates} == {"couch", "short_couch"}


def test_variants_may_be_for_smaller_rooms_alone() -> None:
    couch = piece("couch", kinds=[{"kind": "couch"}, {"kind": "short_couch", "cost": 1, "max_area": 20}])
    assert {a.kind for a in ask(den(width=4.9), couch)[0].candidates} == {"couch", "short_couch"}
    assert {a.kind for a in ask(den(), couch)[0].candidates} == {"couch"}
    assert {a.kind for a in ask(den(), piece("couch", kinds=[{"kind": "short_couch", "max_area": 20}]))[0].candidates} == {"short_couch"}


def test_what_is_required_from_an_area_on_is_optional_below_it() -> None:
    pot, couch = ask(den(), piece("pot"), piece("couch", required=True, min_area=21, skip_cost=7))
    assert (pot.label, couch.label, couch.required, couch.skip_cost) == ("pot_1", "couch_1", False, 7)
    couch, pot = ask(den(width=6.0), piece("pot"), piece("couch", required=True, min_area=21, skip_cost=7))
    assert (pot.label, couch.label, couch.required) == ("pot_1", "couch_1", True)


def test_leaving_out_what_is_insisted_on_costs_what_it_costs_otherwise() -> None:
    room, pieces = den(), [piece("couch", required=True), piece("pot", skip_cost=7)]
    space = space_of(room, 0.1)
    couch, pot = wanted_pieces(room, space, catalog(pieces), Stream(1, "furnish", 0), "pot_1")
    assert (couch.skip_cost, pot.required, pot.skip_cost) == (math.inf, True, 7)
    without = [replace(one, candidates=()) for one in (couch, pot)]
    assert arrange(space, without).arrangement.skipped == {"couch_1": math.inf, "pot_1": 7}


def test_use_sides_and_approach_are_handed_over() -> None:
    couch, table = ask(den(), piece("couch", skip_cost=7), piece("table", approach=["front", "back"]))
    assert (couch.stands, couch.need_all, couch.skip_cost) == ((Stand("front"),), False, 7)
    assert (table.stands, table.need_all) == ((Stand("front"), Stand("back")), True)


def test_equal_walls_differ_by_the_seed() -> None:
    best = {min(ask(den(), piece("shelf"), seed=seed)[0].candidates, key=lambda a: a.cost).wall for seed in range(40)}
    assert best == {"north", "south", "east", "west"}


def test_small_things_are_wished_apart() -> None:
    corners = [min(one.candidates, key=lambda a: a.cost).anchor_mm for one in ask(den(), piece("pot", {"type": "in_corner"}, count=4))]
    assert len(set(corners)) == 4


def test_wall_pieces_are_first_wished_where_none_is_meant_to_stand() -> None:
    couch, shelf = ask(den(DOOR), piece("couch"), piece("shelf"))
    taken = box_of(couch.candidates[0])
    west, north, east, south = box_of(shelf.candidates[0])
    assert west >= taken[2] or taken[0] >= east or north >= taken[3] or taken[1] >= south


def test_a_piece_too_long_for_every_wall_keeps_alternatives() -> None:
    (shelf,) = ask(den(DOOR, width=1.2, depth=1.1), piece("shelf", required=True))
    assert {alternative.wall for alternative in shelf.candidates} == {"north", "south", "east", "west"}


@types
@every("aspect", [1.0, 1.5, 2.0])
@every("size", ["min", "typical", "max"])
def test_what_every_alternative_of_every_type_must_be(room_type: str, size: str, aspect: float) -> None:
    area = KNOWN.rooms[room_type].area
    room, wanted = furnished(room_type, {"min": area.min[1], "typical": area.typical, "max": area.max}[size], aspect)
    space = space_of(room, 0.1)
    seen: dict[str, set[str]] = {}
    for one in wanted:
        assert 1 <= len(one.candidates) <= LIMIT
        for alternative in one.candidates:
            assert alternative.cost >= 0 and math.isfinite(alternative.cost)
            assert all(0.02 <= weight <= 20 for weight in alternative.weights)
            assert alternative.size_mm == tuple(round(length * 1000) for length in KNOWN.furniture[alternative.kind].size)
            if alternative.attach is None:
                assert KNOWN.furniture[alternative.kind].stands == "free" or alternative.wall is not None
            else:
                assert alternative.attach.parent_kind in seen[alternative.attach.parent]
                assert alternative.wall is None
            assert {alternative.under, alternative.on} <= {None, *seen}
        assert all(link.of in seen for link in one.links)
        assert one.label not in seen
        seen[one.label] = {alternative.kind for alternative in one.candidates}
    certain = [piece for piece in KNOWN.rooms[room_type].pieces if piece.required and not piece.without and room.floor_m2 >= piece.min_area]
    required = [piece.piece for piece in certain for _ in range(piece.count)]
    assert [one.label.rsplit("_", 1)[0] for one in wanted if one.required] == required
    at_walls = [a for one in wanted for a in one.candidates if a.wall and not a.attach]
    if size != "min":
        assert all(clear_of_zones(space, alternative) for alternative in at_walls)


@types
def test_the_same_room_wants_the_same(room_type: str) -> None:
    area = KNOWN.rooms[room_type].area.typical
    assert furnished(room_type, area, 1.3) == furnished(room_type, area, 1.3)


def test_large_rooms_want_more() -> None:
    for room_type, room in KNOWN.rooms.items():
        few, many = (sum(len(furnished(room_type, area, 1.5, seed)[1]) for seed in range(8)) for area in (room.area.min[1], room.area.max))
        assert many > few, room_type


def test_a_den_with_everything_is_clear_of_its_zones() -> None:
    room = den(DOOR, WINDOW)
    for one in ask(room, piece("shelf", {"type": "in_corner"}), piece("couch", {"type": "centred"}, {"type": "at_window"})):
        for alternative in one.candidates:
            assert clear_of_zones(space_of(room, 0.1), alternative), alternative
