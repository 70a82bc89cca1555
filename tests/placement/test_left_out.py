"""Reasons in lengths at the level of spaces and pieces: gaps, doors, what goes along with a wall, and what is not claimed."""

from __future__ import annotations

from dataclasses import replace

import pytest

from solver.geometry import ROTATION_AT_WALL, Rect
from solver.pieces import Arrangement, Attach, Candidate, Piece, Space, Stand, Zone
from solver.placement import Budget, arrange, feasible, minimal_conflict, move_least, place
from solver.placement.layout import COVERED
from solver.placement.lengths import Shortfall, centimetres, longer_pieces, longer_space, metres, sentence, shortfall


def room(width: int, depth: int, *zones: Zone) -> Space:
    return Space("room", Rect(0, 0, width, depth), zones, ())


def free(label: str, width: int, depth: int, **more: object) -> Piece:
    return Piece(label, True, (Candidate(label, (width, depth, 800), 0, None, (500, 500)),), **more)  # type: ignore[arg-type]


def at_wall(label: str, width: int, depth: int, wall: str) -> Piece:
    return Piece(label, True, (Candidate(label, (width, depth, 800), ROTATION_AT_WALL[wall], wall, (500, 500)),))


def placed(space: Space, pieces: object) -> Arrangement:
    return move_least(space, list(pieces), Budget()).arrangement  # type: ignore[call-overload]


def found(space: Space, *pieces: Piece, walk: bool = False) -> Shortfall | None:
    return shortfall(space, pieces, lambda longer, some: feasible(longer, some, Budget(), walk), placed)


def test_two_pieces_side_by_side() -> None:
    short = found(room(2100, 2000), free("bed", 1600, 2000), free("wardrobe", 600, 1900))
    assert short is not None
    assert (short.axis, short.missing_mm, short.clear_mm) == (0, 100, 2100)
    assert sorted((length.name, length.mm) for length in short.lengths) == [("bed", 1600), ("wardrobe", 600)]


def test_the_gap_to_the_wall_is_a_length_of_its_own() -> None:
    short = found(room(1800, 2100), at_wall("bed", 1600, 2000, "north"), at_wall("shelf", 1500, 300, "south"))
    assert short is not None
    assert sentence(short) == "wall gap 0.03 + bed 2.00 + shelf 0.30 + wall gap 0.03 = 2.36 > 2.10 m from north to south: 26 cm short"


def test_pieces_along_one_wall_name_it() -> None:
    space = room(2000, 3000)
    short = found(space, at_wall("desk", 1200, 600, "north"), at_wall("chest", 900, 600, "north"))
    assert short is not None
    assert sentence(short).endswith("= 2.10 > 2.00 m along the north wall: 10 cm short")


def test_what_hangs_on_the_far_wall_goes_along_and_the_near_stays() -> None:
    zones = (
        Zone(Rect(2100, 0, 3000, 900), -1, "east_door"),
        Zone(Rect(0, 0, 900, 900), -1, "west_door"),
        Zone(Rect(0, 0, 3000, 90), -1, "strip"),
    )
    longer = longer_space(room(3000, 2000, *zones), 0, 250)
    assert [zone.rect for zone in longer.zones] == [Rect(2350, 0, 3250, 900), Rect(0, 0, 900, 900), Rect(0, 0, 3250, 90)]
    assert longer.clear == Rect(0, 0, 3250, 2000)
    held = Piece("a", True, (Candidate("a", (500, 500, 500), 0, within=Rect(2500, 0, 3000, 500)),))
    (moved,) = longer_pieces(room(3000, 2000), [held], 0, 250)
    assert moved.candidates[0].within == Rect(2750, 0, 3250, 500)


def test_a_locked_piece_begins_a_chain() -> None:
    locked = Piece("chest", True, (Candidate("chest", (800, 1000, 800), 0, within=Rect(0, 0, 800, 1000)),))
    short = found(room(2000, 1000), locked, free("bed", 1300, 900))
    assert short is not None
    assert sentence(short) == "to the far side of chest 0.80 + bed 1.30 = 2.10 > 2.00 m from west to east: 10 cm short"


def test_a_person_before_a_use_side_takes_up_length() -> None:
    wardrobe = free("wardrobe", 1000, 600, stands=(Stand("front"),))
    short = found(room(3000, 1100), wardrobe, walk=True)
    assert short is not None
    assert sentence(short) == "wardrobe 0.60 + to stand 0.60 = 1.20 > 1.10 m from north to south: 10 cm short"


def test_where_no_growth_along_one_axis_helps_nothing_is_claimed() -> None:
    assert found(room(1000, 1000), free("slab", 1200, 1200)) is None


def test_where_more_is_missing_than_there_is_no_one_length_is_claimed() -> None:
    assert found(room(1600, 1600), free("bed", 1600, 2000), free("wardrobe", 1500, 600)) is not None
    assert found(room(700, 700), free("bed", 1600, 2000), free("wardrobe", 1500, 600)) is None


def test_where_the_search_ends_at_its_limit_nothing_is_claimed() -> None:
    space, pieces = room(2100, 2000), (free("bed", 1600, 2000), free("wardrobe", 600, 1900))
    assert shortfall(space, pieces, lambda longer, some: None, placed) is None


def test_without_a_chain_the_sentence_only_says_how_much() -> None:
    assert sentence(Shortfall(1, 135, 2000)) == "the 2.00 m that are clear from north to south are 13.5 cm short"


@pytest.mark.parametrize(("mm", "words"), [(2100, "2.10"), (2105, "2.105"), (30, "0.03")])
def test_metres_are_exact(mm: int, words: str) -> None:
    assert metres(mm) == words


@pytest.mark.parametrize(("mm", "words"), [(130, "13 cm"), (132, "13.2 cm"), (1, "0.1 cm")])
def test_centimetres_are_exact(mm: int, words: str) -> None:
    assert centimetres(mm) == words


def test_a_conflict_leaves_out_who_has_nothing_to_do_with_it() -> None:
    pieces = [free("stool", 300, 300), free("bed", 1600, 2000), free("wardrobe", 600, 1900)]
    assert minimal_conflict(room(2100, 2000), pieces, "wardrobe") == ("bed", "wardrobe")
    assert minimal_conflict(room(2600, 2000), pieces, "wardrobe") is None


def test_a_conflict_on_a_piece_is_found_before_all_else_is_placed() -> None:
    """Two cases of 0.4 m do not stand side by side on a stool; that nine pieces barely stand in the room takes long to see."""
    crowd = [free(f"case_{k}", 700 + 31 * k, 1150 - 37 * k) for k in range(9)]
    upon = Attach("stool", "stool", (-50, 50), (0, 0))
    way = Candidate("case", (400, 300, 300), 0, attach=upon, on="stool", bottom_mm=800)
    pieces = [*crowd, free("stool", 500, 400), *(Piece(label, True, (way,)) for label in ("box", "bin"))]
    assert minimal_conflict(room(3000, 3300), pieces, "bin", Budget(300)) == ("stool", "box", "bin")


def test_of_what_stands_at_a_piece_that_was_left_out_too_the_reason_says_so() -> None:
    seat = Candidate("chair", (400, 400, 800), 0, attach=Attach("table_1", "table", (0, 0), (700, 700)))
    pieces = [Piece("bed_1", True, free("bed", 2500, 1200).candidates), Piece("table_1", False, free("table", 800, 1200).candidates)]
    (made,) = place([(room(3000, 2000), [*pieces, Piece("chair_1", False, (seat,))])])
    reasons = dict(made.left_out)
    assert reasons["chair_1"].endswith("needs 0.40 x 0.40 m at its place by table_1, which was left out itself")
    assert "left out itself" not in reasons["table_1"]


def test_a_piece_that_may_stand_elsewhere_is_not_said_to_have_its_place_at_another() -> None:
    at_sofa = Candidate("table", (400, 400, 800), 0, attach=Attach("sofa_1", "sofa", (0, 0), (900, 900)))
    sofa = free("sofa_1", 1400, 300)
    elsewhere = replace(at_sofa, size_mm=(600, 600, 800), attach=None)
    rooms = [(room(1500, 300), [sofa, Piece("table_1", False, ways)]) for ways in ((at_sofa,), (at_sofa, elsewhere))]
    told = [dict(made.left_out)["table_1"].split("; ", 1)[1] for made in place(rooms)]
    assert told[0].endswith("the smallest, table, needs 0.40 x 0.40 m at its place by sofa_1")
    assert told[1].startswith("the smallest, table, needs 0.40 x 0.40 m and a free way to it")


def test_what_is_left_out_already_is_told_of_the_room_as_it_stands() -> None:
    """As when fronts are cleared: the others are placed again, and the reason tells what their new places leave of the walls."""
    shelf, gone = at_wall("shelf_1", 1200, 300, "north"), replace(at_wall("case_1", 900, 400, "north"), required=False, left_out=COVERED)
    made = arrange(room(4000, 3000), [shelf, gone]).arrangement
    ((label, reason),) = made.left_out
    (stands,) = made.placed
    longest = max(stands.footprint.x0, 4000 - stands.footprint.x1)
    assert (stands.label, label) == ("shelf_1", "case_1")
    assert reason.startswith("the floor is covered as densely as wished without it; the smallest, case_1, needs 0.90 x 0.40 m")
    assert f"north {longest / 1000:.2f} m" in reason and "south 4.00 m" in reason
