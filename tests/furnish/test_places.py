"""Relations of a piece to the room, on a hand-made den of 5 x 4 m (clear floor [50, 4950] x [50, 3950] mm)."""

from __future__ import annotations

import math

import pytest

from solver.pieces import Candidate, Piece
from solver.scene import Opening
from tests.furnish.reference.drawn import WALL_PREFERENCE
from tests.furnish.worlds import DOOR, WINDOW, ask, box_of, cheapest, den, front_of, piece

GARAGE_DOOR = Opening("gate", "garage_door", "east", 2.0, 2.4)


def only(wanted: tuple[Piece, ...]) -> Piece:
    (one,) = wanted
    return one


def costs(wanted: Piece, keep: str) -> dict[str | None, float]:
    """Returns the least cost by wall, of one kind."""
    found: dict[str | None, float] = {}
    for alternative in wanted.candidates:
        if alternative.kind == keep:
            found[alternative.wall] = min(found.get(alternative.wall, math.inf), alternative.cost)
    return found


def in_corner(alternative: Candidate) -> bool:
    west, north, east, south = box_of(alternative)
    return min(west - 50, 4950 - east) <= 30 and min(north - 50, 3950 - south) <= 30


def test_a_wall_piece_has_its_back_3_cm_from_each_wall() -> None:
    for alternative in only(ask(den(), piece("shelf"))).candidates:
        west, north, east, south = box_of(alternative)
        back = {"north": north - 50, "south": 3950 - south, "west": west - 50, "east": 4950 - east}[alternative.wall or ""]
        assert back == 30
        into = {"north": (0, 1), "south": (0, -1), "west": (1, 0), "east": (-1, 0)}[alternative.wall or ""]
        assert front_of(alternative.rotation) == into


def test_against_wall_adds_what_sorts_of_walls_cost() -> None:
    walls = {"door": 5.0, "window": 7.0, "short": 11.0}
    plain, judged = (
        costs(only(ask(den(DOOR, WINDOW), piece("shelf", {"type": "against_wall", "walls": w}))), "shelf") for w in ({}, walls)
    )
    added = {wall: round(judged[wall] - plain[wall], 3) for wall in plain}
    # The shelf finds a place at the north wall that is not behind the window.
    assert added == {"north": 0, "south": 5, "east": 11, "west": 11}


def test_against_wall_counts_a_window_only_right_behind_the_piece() -> None:
    rules = ({"type": "against_wall", "walls": {"window": 50.0}}, {"type": "at_window", "cost": 60.0})
    low = only(ask(den(WINDOW), piece("couch", *rules)))
    for alternative in low.candidates:
        west, _, east, _ = box_of(alternative)
        behind = alternative.wall == "north" and west < 2100 and east > 900
        assert (alternative.cost % 60 >= 49.9) == behind or alternative.cost >= 50


def test_against_wall_gives_a_free_piece_walls_to_stand_at() -> None:
    free = only(ask(den(), piece("pot", {"type": "against_wall", "cost": 3.0})))
    assert {alternative.wall for alternative in free.candidates} == {None, "north", "south", "east", "west"}
    assert min(a.cost for a in free.candidates if a.wall is None) >= 3
    must = only(ask(den(), piece("pot", {"type": "against_wall", "required": True})))
    assert None not in {alternative.wall for alternative in must.candidates}


@pytest.mark.parametrize("kind", ["shelf", "pot"])
def test_in_corner_costs_elsewhere(kind: str) -> None:
    wanted = only(ask(den(DOOR), piece(kind, {"type": "in_corner", "cost": 4.0, "weight": 2.0})))
    assert in_corner(cheapest(wanted))
    for alternative in wanted.candidates:
        assert (alternative.cost < 4) == in_corner(alternative)
        assert alternative.weights == (2.0, 2.0)


def test_in_corner_offers_a_free_piece_all_four() -> None:
    wanted = only(ask(den(), piece("pot", {"type": "in_corner", "required": True})))
    assert {(a.anchor_mm[0] < 2500, a.anchor_mm[1] < 2000) for a in wanted.candidates} == {(x, z) for x in (0, 1) for z in (0, 1)}


def test_centred_wants_the_middle_of_the_wall_or_of_the_room() -> None:
    shelf = only(ask(den(), piece("shelf", {"type": "centred", "cost": 4.0})))
    for wall, middle in (("north", 2500), ("south", 2500), ("east", 2000), ("west", 2000)):
        best = min((a for a in shelf.candidates if a.wall == wall), key=lambda a: a.cost)
        assert best.anchor_mm[0 if wall in ("north", "south") else 1] == middle
        assert best.cost < WALL_PREFERENCE
    table = only(ask(den(), piece("table", {"type": "centred"})))
    assert {alternative.anchor_mm for alternative in table.candidates} == {(2500, 2000)}
    assert {alternative.rotation for alternative in table.candidates} == {0, 90}


def test_centred_costs_by_the_distance_from_the_middle() -> None:
    wanted = only(ask(den(), piece("shelf", {"type": "centred", "cost": 4.0})))
    off = [a for a in wanted.candidates if a.wall == "north" and a.anchor_mm[0] != 2500]
    assert off and all(a.cost >= 4 for a in off)


def test_at_window_stands_centred_on_it() -> None:
    wanted = only(ask(den(WINDOW, DOOR), piece("couch", {"type": "at_window", "cost": 4.0})))
    best = cheapest(wanted)
    assert (best.wall, best.anchor_mm[0]) == ("north", 1500)
    assert all(a.cost >= 4 for a in wanted.candidates if a.wall != "north")


def test_at_window_falls_away_without_a_window() -> None:
    wanted = only(ask(den(DOOR), piece("couch", {"type": "at_window", "cost": 4.0})))
    assert cheapest(wanted).cost < 1


def door_distance(alternative: Candidate) -> float:
    west, north, east, south = box_of(alternative)
    return math.hypot(max(west - 2500, 2500 - east, 0), max(north - 4000, 4000 - south, 0)) / 1000


def test_near_door_costs_beyond_its_distance() -> None:
    wanted = only(ask(den(DOOR), piece("shelf", {"type": "near_door", "distance": 1.0, "cost": 8.0})))
    assert door_distance(cheapest(wanted)) < 1.1
    for alternative in wanted.candidates:
        beyond = max(0.0, min(1.0, door_distance(alternative) - 1.0))
        assert 8 * beyond - 1e-6 <= alternative.cost <= 8 * beyond + WALL_PREFERENCE


def test_far_from_door_costs_short_of_its_distance() -> None:
    wanted = only(ask(den(DOOR), piece("shelf", {"type": "far_from_door", "distance": 3.0, "cost": 8.0})))
    assert door_distance(cheapest(wanted)) > 3
    for alternative in wanted.candidates:
        short = max(0.0, 3.0 - door_distance(alternative)) / 3.0
        assert 8 * short - 1e-6 <= alternative.cost <= 8 * short + WALL_PREFERENCE


@pytest.mark.parametrize("word", ["near_door", "far_from_door"])
def test_a_required_distance_forbids(word: str) -> None:
    wanted = only(ask(den(DOOR), piece("shelf", {"type": word, "distance": 2.0, "required": True})))
    assert wanted.candidates
    for alternative in wanted.candidates:
        assert (door_distance(alternative) <= 2.0) == (word == "near_door")


@pytest.mark.parametrize(("word", "near"), [("near", True), ("far_from", False)])
def test_near_and_far_from_an_opening(word: str, near: bool) -> None:
    wanted = only(ask(den(WINDOW, DOOR), piece("pot", {"type": word, "of": "window", "distance": 1.5, "cost": 8.0})))
    x, z = cheapest(wanted).anchor_mm
    assert (math.hypot(x - 1500, z) < 1700) == near


def test_facing_an_opening_turns_to_its_wall() -> None:
    wagon = piece("wagon", {"type": "facing", "of": "garage_door", "cost": 4.0})
    wanted = only(ask(den(GARAGE_DOOR), wagon))
    assert front_of(cheapest(wanted).rotation) == (1, 0)
    assert all(a.cost >= 4 for a in wanted.candidates if a.rotation != 90)
    assert cheapest(only(ask(den(), wagon))).cost < 1


def test_a_chair_does_not_look_at_a_wall() -> None:
    wanted = only(ask(den(), piece("chair", {"type": "in_corner", "required": True})))
    x, z = cheapest(wanted).anchor_mm
    dx, dz = front_of(cheapest(wanted).rotation)
    assert (dx == 0 or (dx > 0) == (x < 2500)) and (dz == 0 or (dz > 0) == (z < 2000))


def test_free_pieces_are_not_wished_before_a_garage_door() -> None:
    gate = Opening("gate", "garage_door", "east", 3.0, 2.0)
    wanted = only(ask(den(gate), piece("pot", {"type": "in_corner", "required": True})))
    dear = {alternative.anchor_mm for alternative in wanted.candidates if alternative.cost > 1}
    assert dear == {(4720, 3720)}
