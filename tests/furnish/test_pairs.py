"""Relations between two pieces: slots by their geometry in all four rotations of the parent, links by what they ask for."""

from __future__ import annotations

from typing import Any

import pytest

from solver.pieces import LOOKS_AT, Candidate, Link, Piece
from tests.furnish.reference.drawn import QUARTER_PREFERENCE, SIDE_PREFERENCE
from tests.furnish.worlds import KINDS, ask, box_of, den, front_of, gap, piece

TURNS = (0, 90, 180, 270)
Rule = dict[str, Any]


def second(parent: dict[str, Any], *rules: Rule, kind: str = "chair", **more: Any) -> Piece:
    """Returns the wanted piece that stands with a parent."""
    return ask(den(), parent, piece(kind, *rules, **more))[-1]


def slots(wanted: Piece) -> list[Candidate]:
    return [alternative for alternative in wanted.candidates if alternative.attach]


def parent_box(kind: str, turn: float) -> tuple[float, float, float, float]:
    width, depth = (length * 1000 for length in KINDS[kind]["size"][:2])
    if turn % 180:
        width, depth = depth, width
    return (2000 - width / 2, 2000 - depth / 2, 2000 + width / 2, 2000 + depth / 2)


def side_of(alternative: Candidate, kind: str, turn: float) -> str:
    """Returns the side of the parent an alternative stands at, seen by the parent."""
    box, other = box_of(alternative, (2000, 2000, turn)), parent_box(kind, turn)
    ahead = front_of(turn)
    ways = {"front": ahead, "back": (-ahead[0], -ahead[1]), "right": (ahead[1], -ahead[0]), "left": (-ahead[1], ahead[0])}
    reach = {
        (1, 0): box[0] - other[2], (-1, 0): other[0] - box[2], (0, 1): box[1] - other[3], (0, -1): other[1] - box[3],
    }  # fmt: skip
    return max(ways, key=lambda side: reach[ways[side]])


@pytest.mark.parametrize("turn", TURNS)
def test_beside_stands_left_or_right_backs_in_line(turn: int) -> None:
    found = slots(second(piece("couch"), {"type": "beside", "of": "couch", "gap": 0.1, "required": True}, kind="shelf"))
    couch = parent_box("couch", turn)
    assert [side_of(alternative, "couch", turn) for alternative in found] == ["left", "right"]
    dx, dz = front_of(turn)
    for alternative in found:
        box = box_of(alternative, (2000, 2000, turn))
        assert gap(box, couch) == pytest.approx(100)
        backs = {(0, 1): (box[1], couch[1]), (0, -1): (box[3], couch[3]), (1, 0): (box[0], couch[0]), (-1, 0): (box[2], couch[2])}
        assert backs[(dx, dz)][0] == pytest.approx(backs[(dx, dz)][1])
        assert alternative.rotation == 0


@pytest.mark.parametrize(("align", "at"), [("centre", 0.0), ("front", 50.0), ("back", -50.0)])
def test_beside_lines_up_as_told(align: str, at: float) -> None:
    rule = {"type": "beside", "of": "table", "align": align, "gap": 0, "required": True}
    for alternative in slots(second(piece("table"), rule, kind="chair")):
        assert alternative.attach is not None
        # The table is 0.8 deep, the chair 0.6: lined up at the front its middle is 0.1 nearer to the front.
        assert alternative.attach.along_mm == (2 * at, 2 * at)


def test_a_gap_may_be_an_interval() -> None:
    for alternative in slots(second(piece("couch"), {"type": "beside", "of": "couch", "gap": [0.1, 0.5], "required": True})):
        boxes = [box_of(alternative, (2000, 2000, 0), (at, 0)) for at in (0, 1)]
        assert sorted(gap(box, parent_box("couch", 0)) for box in boxes) == [100, 500]


def test_beside_may_ask_for_walls() -> None:
    wanted = second(piece("couch"), {"type": "beside", "of": "couch", "wall": "same", "cost": 3}, kind="shelf")
    assert Link("beside", "couch_1", walls="same", cost=3.0) in wanted.links


@pytest.mark.parametrize("turn", TURNS)
def test_in_front_of_stands_before_the_front_centred(turn: int) -> None:
    (slot,) = slots(second(piece("couch"), {"type": "in_front_of", "of": "couch", "gap": 0.4, "required": True}, kind="table"))
    assert side_of(slot, "couch", turn) == "front"
    box = box_of(slot, (2000, 2000, turn))
    assert gap(box, parent_box("couch", turn)) == pytest.approx(400)
    dx, dz = front_of(turn)
    middle = ((box[0] + box[2]) / 2 - 2000, (box[1] + box[3]) / 2 - 2000)
    assert abs(middle[0] * dz - middle[1] * dx) < 1e-6


def test_any_lets_it_slide_along_the_side() -> None:
    (slot,) = slots(second(piece("couch"), {"type": "in_front_of", "of": "couch", "align": "any", "required": True}))
    ends = [box_of(slot, (2000, 2000, 0), (at, 0)) for at in (0, 1)]
    assert (ends[0][0], ends[1][2]) == (1000, 3000)


@pytest.mark.parametrize("turn", TURNS)
@pytest.mark.parametrize("relation", ["beside", "in_front_of", "around", "under"])
def test_facing_turns_it_to_its_parent(relation: str, turn: int) -> None:
    rules: list[Rule] = [{"type": relation, "of": "table", "sides": ["front", "back", "left", "right"], "required": True}]
    if relation in ("beside", "in_front_of"):
        rules.append({"type": "facing", "of": "table"})
    wanted = second(piece("table"), *rules)
    assert wanted.links == ()
    for slot in slots(wanted):
        box = box_of(slot, (2000, 2000, turn))
        dx, dz = front_of(turn + slot.rotation)
        table = parent_box("table", turn)
        ahead = (box[0] + dx * 800, box[1] + dz * 800, box[2] + dx * 800, box[3] + dz * 800)
        assert gap(ahead, table) < 0
        behind = (box[0] - dx * 800, box[1] - dz * 800, box[2] - dx * 800, box[3] - dz * 800)
        assert gap(behind, table) > 0


@pytest.mark.parametrize("turn", TURNS)
def test_around_fills_the_long_sides_in_pairs_without_overlap(turn: int) -> None:
    chairs = second(piece("table"), {"type": "around", "of": "table", "gap": 0.05, "required": True})
    found = sorted(slots(chairs), key=lambda alternative: alternative.cost)
    boxes = [box_of(alternative, (2000, 2000, turn)) for alternative in found]
    # A side of 1.6 m takes three chairs of 0.4 m with 0.1 m of elbow room, one of 0.8 m takes one.
    assert len(found) == 8
    assert {side_of(alternative, "table", turn) for alternative in found[:2]} == {"front", "back"}
    assert {side_of(alternative, "table", turn) for alternative in found[-2:]} == {"left", "right"}
    assert all(gap(box, parent_box("table", turn)) == pytest.approx(50) for box in boxes)
    assert all(gap(a, b) > 0 for i, a in enumerate(boxes) for b in boxes[:i])
    assert len({alternative.attach.slot for alternative in found if alternative.attach}) == 8


def test_around_with_a_negative_gap_tucks_under() -> None:
    for slot in slots(second(piece("table"), {"type": "around", "of": "table", "gap": -0.2, "required": True})):
        assert slot.under == "table_1"
        assert gap(box_of(slot, (2000, 2000, 0)), parent_box("table", 0)) == pytest.approx(-200)


def test_under_reaches_under_its_parent() -> None:
    (slot,) = slots(second(piece("table"), {"type": "under", "of": "table", "gap": -0.35, "required": True}))
    assert (slot.under, slot.bottom_mm) == ("table_1", 0)
    assert gap(box_of(slot, (2000, 2000, 0)), parent_box("table", 0)) == pytest.approx(-350)


@pytest.mark.parametrize("turn", TURNS)
@pytest.mark.parametrize("align", [None, "back", "any"])
def test_on_stands_on_the_surface(turn: int, align: str | None) -> None:
    rule: Rule = {"type": "on", "of": "table", "required": True, **({"align": align} if align else {})}
    (slot,) = slots(second(piece("table"), rule, kind="box"))
    assert (slot.on, slot.bottom_mm) == ("table_1", 700)
    table = parent_box("table", turn)
    for at in (0, 1):
        west, north, east, south = box_of(slot, (2000, 2000, turn), (at, at))
        assert west >= table[0] and north >= table[1] and east <= table[2] and south <= table[3]
        if align == "back":
            dx, dz = front_of(turn)
            assert {(0, 1): north == table[1], (0, -1): south == table[3], (1, 0): west == table[0], (-1, 0): east == table[2]}[(dx, dz)]
    assert slot.attach is not None
    assert (slot.attach.across_mm[0] < slot.attach.across_mm[1]) == (align == "any")


def test_nothing_stands_on_what_has_no_surface_for_it() -> None:
    wanted = ask(den(), piece("shelf"), piece("box", {"type": "on", "of": "shelf", "required": True}))
    assert [one.label for one in wanted] == ["shelf_1"]


@pytest.mark.parametrize("turn", TURNS)
def test_in_row_continues_it_at_either_end(turn: int) -> None:
    found = slots(second(piece("couch"), {"type": "in_row", "of": "couch", "required": True}, kind="shelf"))
    assert [side_of(alternative, "couch", turn) for alternative in found] == ["left", "right"]
    for alternative in found:
        assert gap(box_of(alternative, (2000, 2000, turn)), parent_box("couch", turn)) == pytest.approx(0)


def test_in_row_of_itself_begins_with_the_first_copy() -> None:
    first, then, last = ask(den(), piece("wagon", {"type": "in_row", "of": "wagon", "gap": 0.6, "cost": 2}, count=3))
    assert slots(first) == [] and min(a.cost for a in first.candidates) < 2
    assert {slot.attach.parent for slot in slots(then) if slot.attach} == {"wagon_1"}
    assert {slot.attach.parent for slot in slots(last) if slot.attach} == {"wagon_1", "wagon_2"}
    assert all(a.cost >= 2 for a in last.candidates if a.attach is None)


def test_in_row_round_the_corner_leaves_room_for_the_rows_depth() -> None:
    rule = {"type": "in_row", "of": "couch", "wall": "adjacent", "cost": 3, "weight": 0.2}
    wanted = second(piece("couch"), rule, {"type": "centred", "cost": 0}, kind="shelf")
    assert Link("in_row", "couch_1", walls="adjacent", cost=3.0, near=0.2) in wanted.links
    # Wall face + 3 cm + the couch's 0.9 m + half the shelf's 1 m.
    assert any(a.wall == "west" and a.anchor_mm[1] == 50 + 30 + 900 + 500 for a in wanted.candidates)


def test_opposite_asks_for_the_other_wall_the_turn_and_the_middle() -> None:
    wanted = second(piece("couch"), {"type": "opposite", "of": "couch", "cost": 4, "weight": 2}, kind="shelf")
    assert wanted.links == (Link("opposite", "couch_1", turn=180, walls="opposite", cost=4.0, align=2.0),)
    must = second(piece("couch"), {"type": "opposite", "of": "couch", "required": True}, kind="shelf")
    assert must.links[0].required


def test_facing_a_piece_without_a_slot_there_is_a_turn() -> None:
    wanted = second(piece("couch"), {"type": "facing", "of": "couch", "cost": 3})
    assert wanted.links == (Link("facing", "couch_1", turn=LOOKS_AT, cost=3.0),)


def test_near_pulls_and_may_ask_for_walls() -> None:
    wanted = second(piece("couch"), {"type": "near", "of": "couch", "weight": 0.5})
    assert wanted.links == (Link("near", "couch_1", near=0.5),)
    wanted = second(piece("couch"), {"type": "near", "of": "couch", "weight": 0.5, "wall": "same", "cost": 2}, kind="shelf")
    assert wanted.links == (Link("near", "couch_1", walls="same", cost=2.0, near=0.5),)


def test_far_from_costs_by_the_metre_from_every_copy() -> None:
    wanted = second(piece("pot", count=2), {"type": "far_from", "of": "pot", "distance": 2.5, "cost": 0.7})
    assert wanted.links == tuple(Link("far_from", label, apart_m=2.5, apart_cost=0.7) for label in ("pot_1", "pot_2"))


def test_aligned_with_pulls_the_middles_in_line() -> None:
    wanted = second(piece("table"), {"type": "aligned_with", "of": "table", "weight": 0.4}, kind="shelf")
    assert wanted.links == (Link("aligned_with", "table_1", cost=2.0, align=0.4),)


def test_slots_are_for_one_size_variant_of_the_parent() -> None:
    couch = piece("couch", kinds=[{"kind": "couch"}, {"kind": "short_couch", "cost": 1}])
    found = slots(second(couch, {"type": "beside", "of": "couch", "gap": 0, "required": True}))
    reach = {slot.attach.parent_kind: slot.attach.across_mm[1] for slot in found if slot.attach and slot.attach.slot == "right"}
    assert reach == {"couch": 1000 + 200, "short_couch": 700 + 200}


def test_a_slot_pays_for_the_other_slots_it_misses() -> None:
    rules: list[Rule] = [{"type": "beside", "of": "couch", "cost": 3}, {"type": "beside", "of": "table", "cost": 1}]
    wanted = ask(den(), piece("couch"), piece("table"), piece("pot", *rules))[-1]
    least = {
        parent: min(a.cost for a in wanted.candidates if (a.attach.parent if a.attach else None) == parent)
        for parent in ("couch_1", "table_1", None)
    }
    most = {"couch_1": SIDE_PREFERENCE, "table_1": SIDE_PREFERENCE, None: QUARTER_PREFERENCE}
    for parent, cost in (("couch_1", 1), ("table_1", 3), (None, 4)):
        assert cost <= least[parent] <= cost + most[parent]


def test_a_piece_that_needs_another_is_not_wanted_without_it() -> None:
    pieces = (piece("couch", min_area=50), piece("pot", {"type": "beside", "of": "couch", "required": True}))
    assert ask(den(), *pieces) == ()
    assert [one.label for one in ask(den(), pieces[0] | {"min_area": 0}, pieces[1])] == ["couch_1", "pot_1"]
