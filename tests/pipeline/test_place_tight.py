"""Lists that a room hardly holds: wishes leave nothing out that stands without them; none calls impossible what another answer shows."""

from __future__ import annotations

from functools import cache

import pytest

from catalogs.schema import RelationSpec
from solver import place
from solver.requested import Answered, PieceRequest
from solver.scene import Opening, Room

Wishes = tuple[tuple[str, str], ...]
TIGHT: dict[str, tuple[tuple[float, float], tuple[str, float], tuple[str, float], tuple[tuple[str, Wishes], ...]]] = {
    "to eat and sleep": (
        (4.1, 2.51), ("west", 0.59), ("east", 0.78),
        (("filing_cabinet", (("opposite", "p5"), ("around", "p5"))), ("dining_table", (("opposite", "p0"),)),
         ("dining_chair", (("in_front_of", "p3"),)), ("dining_chair", (("centred", ""), ("in_corner", ""))), ("floor_lamp", ()),
         ("dining_chair", (("around", "p2"),)), ("bed", (("facing", "p7"),)), ("plant", (("in_front_of", "p1"),))),
    ),
    "to sleep": (
        (2.23, 4.43), ("south", 0.77), ("east", 2.31),
        (("coffee_table", (("far_from", "p4"), ("opposite", "p6"))), ("bookshelf", (("against_wall", ""),)),
         ("tv_stand", (("far_from_door", ""), ("near", "p3"))), ("armchair", (("in_front_of", "p4"),)),
         ("wardrobe", (("in_row", "p2"), ("near", "p5"), ("in_front_of", "p1"))), ("plant", ()), ("wardrobe", (("near", "p2"),)),
         ("bed", (("facing", "p6"), ("near", "p0")))),
    ),
}  # fmt: skip


@cache
def answer(name: str, wishes: bool) -> Answered:
    (width, depth), door, window, pieces = TIGHT[name]
    openings = (
        Opening("door", "door", *door, 0.8, 2.0, connects_to="EXTERIOR", main_entrance=True),
        Opening("window", "window", *window, 1.2, 1.2, 0.9, "EXTERIOR"),
    )
    rules = [tuple(RelationSpec.model_validate({"type": what, **({"of": of} if of else {})}) for what, of in own) for _, own in pieces]
    wanted = [PieceRequest(f"p{k}", kind, relations=rules[k] if wishes else ()) for k, (kind, _) in enumerate(pieces)]
    return place(Room("den", width=width, depth=depth, openings=openings), wanted)


def missing(name: str, wishes: bool) -> set[str]:
    return {one.id for one in answer(name, wishes).best.unplaced}


@pytest.mark.parametrize("name", TIGHT)
def test_wishes_leave_nothing_out_where_all_stands_without_them(name: str) -> None:
    assert missing(name, True) == set() or missing(name, False) != set()
    assert [one for one in answer(name, True).best.issues if one.severity == "error"] == []
    asked = sum(len(own) for _, own in TIGHT[name][3])
    assert len(answer(name, True).best.relations) == asked  # all are judged, however the place was found


@pytest.mark.parametrize("name", TIGHT)
@pytest.mark.parametrize("wishes", [True, False])
def test_what_stands_in_another_answer_is_called_impossible_in_none(name: str, wishes: bool) -> None:
    for conflict in answer(name, wishes).conflicts:
        stand = not missing(name, not wishes).intersection(conflict.ids)
        assert conflict.message.startswith("not found: ") or not stand


@pytest.mark.parametrize("wish", [None, "against_wall", "in_corner"])
@pytest.mark.parametrize("spare", [0, 1, 20, 29, 30, 45])
def test_what_is_as_long_as_the_room_is_wide_stands_across(spare: int, wish: str | None) -> None:
    width = 2.0 + spare / 1000
    door = Opening("door", "door", "south", 0.6, 0.8, 2.0, connects_to="EXTERIOR")
    rules = (RelationSpec(type=wish),) if wish else ()
    found = place(Room("den", width=width, depth=2.7, openings=(door,)), [PieceRequest("bed", "bed", 1.2, 2.0, 0.5, relations=rules)])
    (bed,) = found.best.scene.rooms[0].furniture
    assert bed.rotation in (90, 270)
    from_west, from_east = bed.x - 1.0, width - (bed.x + 1.0)
    assert min(from_west, from_east) >= -1e-9
    back = from_west if bed.rotation == 90 else from_east
    assert back == pytest.approx(0.03 if spare >= 30 else 0.0)
    assert all(one.held for one in found.best.relations)
    assert (found.conflicts, found.best.issues) == ((), ())


def test_what_is_longer_than_the_room_is_wide_is_said_to_stand_nowhere() -> None:
    door = Opening("door", "door", "south", 0.6, 0.8, 2.0, connects_to="EXTERIOR")
    found = place(Room("den", width=1.999, depth=2.7, openings=(door,)), [PieceRequest("bed", "bed", 1.2, 2.0, 0.5)])
    assert found.best.scene.rooms[0].furniture == ()
    assert [conflict.ids for conflict in found.conflicts] == [("bed",)]
