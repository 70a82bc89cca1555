"""Lists that a room hardly holds: wishes leave nothing out that stands without them; none calls impossible what another answer shows."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from itertools import combinations, takewhile
from random import Random

import pytest

from catalogs.schema import RelationSpec
from solver import place
from solver.pieces import Piece
from solver.pipeline.place_task import PlaceTask
from solver.pipeline.rounds import Round, best_placement, quick_placement
from solver.requested import Answered, PieceRequest
from solver.scene import Furniture, Opening, Room
from tests.sweeps import seeds, times
from tests.told_forms import has_form

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


@pytest.mark.parametrize("word", ["beside", "in_front_of", "opposite", "facing"])
@pytest.mark.parametrize("kind", ["bookshelf", "stove", "sideboard"])
def test_what_has_to_stand_by_something_stands_free_where_no_wall_is_near(word: str, kind: str) -> None:
    """A workbench in the middle of a hall 9 x 9 m: what is asked for beside it is not for walls 3 m away."""
    door = Opening("door", "door", "west", 1.0, 0.9, connects_to="EXTERIOR")
    bench = Furniture("bench", "workbench", x=4.5, z=4.5, rotation=180, width=1.8, depth=0.7, height=0.9)
    hall = Room("hall", width=9.0, depth=9.0, openings=(door,), furniture=(bench,))
    answer = place(hall, [PieceRequest("asked", kind, relations=(RelationSpec(type=word, of=("bench",), required=True),))])
    assert [held.held for held in answer.best.relations] == [True]
    assert answer.conflicts == () == answer.best.unplaced
    assert not [issue for issue in answer.best.issues if issue.severity == "error"]


def test_at_a_wall_is_better_where_the_relation_holds_there() -> None:
    door = Opening("door", "door", "west", 1.0, 0.9, connects_to="EXTERIOR")
    bench = Furniture("bench", "workbench", x=4.5, z=0.38, rotation=0, width=1.8, depth=0.7, height=0.9, wall="north")
    hall = Room("hall", width=9.0, depth=9.0, openings=(door,), furniture=(bench,))
    answer = place(hall, [PieceRequest("asked", "bookshelf", relations=(RelationSpec(type="beside", of=("bench",), required=True),))])
    assert {piece.id: piece.wall for piece in answer.best.scene.rooms[0].furniture}["asked"] == "north"


def test_that_no_place_holds_what_is_required_is_not_called_impossible() -> None:
    """Places where a relation holds are tried in part alone; what is too large without any relation is."""
    door = Opening("door", "door", "west", 1.26, 0.8, connects_to="EXTERIOR")
    room = Room("den", width=2.667, depth=3.589, openings=(door,))
    far = RelationSpec(type="far_from_door", distance=2.6, required=True)
    near = RelationSpec(type="near_door", distance=0.5, required=True)
    for rules, without in (((far,), "; without far_from_door there is one"), ((far, near), "; without far_from_door there is one")):
        (conflict,) = place(room, [PieceRequest("table", "side_table", relations=rules)]).conflicts
        assert conflict.message == f"not found: a place for table 0.46 x 0.46 m where the required relations hold{without}"
        assert has_form(conflict.message)
        assert [repair["id"] for repair in conflict.repairs] == ["table"]
    (conflict,) = place(room, [PieceRequest("box", width=3.0, depth=3.0, height=1.0, relations=(far,))]).conflicts
    assert "cannot stand as asked anywhere" in conflict.message


def test_what_is_far_enough_in_a_corner_alone_stands_there() -> None:
    door = Opening("door", "door", "west", 1.26, 0.8, connects_to="EXTERIOR")
    far = RelationSpec(type="far_from_door", distance=2.32, required=True)
    answer = place(Room("den", width=2.667, depth=3.589, openings=(door,)), [PieceRequest("table", "side_table", relations=(far,))])
    assert [one.held for one in answer.best.relations] == [True]


@pytest.mark.parametrize(
    ("width", "depth", "door_at", "sizes"),
    [
        (1.5, 1.55, 1.05, {"armchair": (0.85, 0.7, 0.8)}),
        (1.85, 2.1, 1.3, {"dining_table": (1.8, 0.9, 0.5), "bed": (0.75, 1.1, 1.3)}),
    ],
)
def test_what_leaves_but_bent_floor_to_come_to_it_stands(
    width: float, depth: float, door_at: float, sizes: dict[str, tuple[float, float, float]]
) -> None:
    """No rectangle of floor beside them holds the quarter of a square metre of free centres that a room must have."""
    door = Opening("door", "door", "west", door_at, 0.8, 2.0, connects_to="EXTERIOR", main_entrance=True)
    best = place(Room("den", width=width, depth=depth, openings=(door,)), [PieceRequest(k, k, *size) for k, size in sizes.items()]).best
    assert {one.id for one in best.scene.rooms[0].furniture} == {*sizes}
    assert best.issues == ()


def test_of_two_wishes_at_odds_one_is_held() -> None:
    """Either may hold by chance where neither piece is placed by the other: that neither does was called best."""
    near, far = RelationSpec(type="near", of=("piano",)), RelationSpec(type="far_from", of=("stand",))
    door = Opening("door", "door", "east", 1.0, 0.8, connects_to="EXTERIOR", main_entrance=True)
    wanted = [PieceRequest("stand", "nightstand", 0.45, 0.4, 0.55, relations=(near,)), PieceRequest("piano", "piano", relations=(far,))]
    answer = place(Room("den", width=3.0, depth=2.75, openings=(door,)), wanted)
    assert sorted(one.held for one in answer.best.relations) == [False, True]


def _rule(word: str, *of: str, **more: object) -> RelationSpec:
    return RelationSpec(type=word, of=of, required=True, **more)


def test_a_wish_to_one_piece_breaks_no_required_relation_to_another() -> None:
    """All but the wish that is at odds with it is held: that one was kept, and in the end none was asked for."""
    door = Opening("door", "door", "east", 1.0, 0.8, connects_to="EXTERIOR", main_entrance=True)
    wishes = {
        "desk": (RelationSpec(type="near_door"),),
        "lamp": (RelationSpec(type="far_from", of=("desk",), distance=2.0), RelationSpec(type="in_corner")),
        "stool": (RelationSpec(type="in_front_of", of=("desk",)), _rule("near", "lamp", distance=0.5)),
    }
    sizes = {"desk": (1.2, 0.6, 0.75), "lamp": (0.4, 0.4, 1.6), "stool": (0.4, 0.4, 0.45)}
    wanted = [PieceRequest(k, k, *sizes[k], relations=own) for k, own in wishes.items()]
    best = place(Room("den", width=4.0, depth=3.5, openings=(door,)), wanted).best
    assert [(one.piece, one.type) for one in best.relations if not one.held] == [("stool", "in_front_of")]


NEAR, FAR = {"distance": 0.5}, {"distance": 2.0}
AT_ODDS = {
    "own": ((), (_rule("near", "desk", **NEAR), _rule("far_from", "desk", **FAR)), {"near", "far_from"}),
    "each other's": ((_rule("far_from", "shelf", **FAR),), (_rule("near", "desk", **NEAR),), {"near", "far_from (desk)"}),
    "a circle": ((_rule("on", "shelf"),), (_rule("on", "desk"),), {"on", "on (desk)"}),
    "beyond the room": ((), (_rule("far_from", "desk", distance=6.0),), {"far_from"}),
}


@pytest.mark.parametrize("case", AT_ODDS)
def test_of_relations_at_odds_it_is_said_without_which_there_is_a_place_and_there_is(case: str) -> None:
    """Followed, each leads to a room in which both stand, and what is still asked for is so, by lengths measured here."""
    den = Room("den", width=4.0, depth=3.5, openings=(Opening("door", "door", "south", 0.8, 0.9, connects_to="EXTERIOR"),))
    desks, shelves, words = AT_ODDS[case]
    asked = [
        PieceRequest("desk", "slab", 0.8, 0.3, 0.6, relations=desks),
        PieceRequest("shelf", "slab", 0.8, 0.3, 0.6, relations=shelves),
    ]
    told = {conflict.ids[0]: conflict.message for conflict in place(den, asked).conflicts}
    assert set(told) <= {"desk", "shelf"} and "shelf" in told
    assert has_form(told["shelf"])
    named = told["shelf"].partition("; without ")[2].removesuffix(" there is one").split(" or ")
    assert set(named) == words
    for word in named:
        kind, _, owner = word.rstrip(")").partition(" (")
        left = [
            replace(one, relations=tuple(rule for rule in one.relations if one.id != (owner or "shelf") or rule.type != kind))
            for one in asked
        ]
        answer = place(den, left)
        assert answer.conflicts == () == answer.best.unplaced
        desk, shelf = sorted(answer.best.scene.rooms[0].furniture, key=lambda one: one.id)
        gaps = (_gap(desk, shelf, axis) for axis in ("x", "z"))
        apart = sum(max(gap, 0.0) ** 2 for gap in gaps) ** 0.5
        for rule in (rule for one in left for rule in one.relations):
            assert {"near": apart <= 0.5, "far_from": apart >= 2.0, "on": desk.y + shelf.y > 0.5}[rule.type]


def _gap(a: Furniture, b: Furniture, axis: str) -> float:
    def extent(one: Furniture) -> float:
        return one.width if (axis == "x") == (one.rotation % 180 == 0) else one.depth

    return float(abs(getattr(a, axis) - getattr(b, axis)) - (extent(a) + extent(b)) / 2)


@pytest.mark.parametrize(("other", "members"), [((2.0, 3.0, 0.8), {"bed", "crate"}), ((0.3, 0.3, 0.8), {"bed"})], ids=["floor", "way"])
def test_what_is_missing_is_named_though_another_keeps_its_distance_from_it(other: tuple[float, float, float], members: set[str]) -> None:
    """The one that keeps it stands: it is not what has no place."""
    shy = PieceRequest("bunk_bed", relations=(RelationSpec(type="far_from", of=("bed",), required=True),))
    wishes = [PieceRequest("bed", "bed", 7.5, 2.0, 0.5), shy, PieceRequest("crate", "crate", *other)]
    hall = Room("hall", width=7.6, depth=3.8)
    answer = place(hall, wishes)
    assert [one.id for one in answer.best.unplaced] == ["bed"]
    (conflict,) = answer.conflicts
    assert set(conflict.ids) == members
    assert conflict.repairs[0] == {"action": "leave_out", "id": "bed"}
    assert place(hall, [replace(shy, relations=()), wishes[2]]).conflicts == ()


@pytest.mark.parametrize("front_door", [True, False])
@pytest.mark.parametrize("depth", [2.6, 3.2, 4.0])
def test_a_door_that_even_the_empty_room_does_not_join_leaves_the_others_to_be_joined(depth: float, front_door: bool) -> None:
    south = depth - 1.0  # of the leg, which is 0.4 m wide: nobody can walk in it
    outline = ((0.0, 0.0), (3.0, 0.0), (3.0, south), (3.4, south), (3.4, depth), (0.0, depth))
    openings = (
        Opening("in the leg", width=0.38, position=3.2, edge=4, connects_to="cellar"),
        Opening("in", width=0.9, position=0.8, edge=5, connects_to="EXTERIOR", main_entrance=front_door),
        Opening("hall", width=0.9, position=0.7, edge=0, connects_to="hall"),
    )
    kinds = ("wardrobe", "sofa", "bed", "desk", "bookshelf", "treadmill", "stove", "deck_chair", "armchair", "tv_stand")
    wanted = [PieceRequest(kind, required=not k) for k, kind in enumerate(kinds)]
    found = place(Room("den", width=3.4, depth=depth, outline=outline, openings=openings), wanted).best
    assert [one for one in found.issues if one.severity == "error"] == []
    assert len(found.scene.rooms[0].furniture) >= 2


def test_what_is_offered_to_be_left_out_leaves_a_way_to_all_others() -> None:
    """Without the fire pit the island can stand, but not be come to."""
    openings = (
        Opening("d", width=0.9, wall="north", position=1.1, connects_to="EXTERIOR"),
        Opening("w", "window", "east", position=1.03, width=1.2, height=1.2, sill=0.9),
    )
    room = Room("den", width=1.94, depth=2.06, openings=openings)
    near = (RelationSpec(type="near_door", required=True),)
    wanted = [
        PieceRequest("small_desk"),
        PieceRequest("fire_pit", relations=near),
        PieceRequest("narrow_counter", relations=near),
        PieceRequest("nightstand"),
        PieceRequest("small_kitchen_island"),
    ]
    (conflict,) = place(room, wanted).conflicts
    assert "fire_pit" in conflict.ids and conflict.repairs
    for repair in conflict.repairs:
        assert place(room, [one for one in wanted if one.id != repair["id"]]).best.unplaced == ()


def test_a_piece_for_which_a_limit_ended_the_search_may_be_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """All others stand in the answer, so that helps."""
    monkeypatch.setattr("solver.pipeline.place.ROOM_WORK", 0.0)
    (conflict,) = place(Room("den", width=2.2, depth=2.4), [PieceRequest("bed"), PieceRequest("single_bed")]).conflicts
    assert conflict.message.startswith("not found") and conflict.repairs == ({"action": "leave_out", "id": conflict.ids[0]},)


def test_a_call_whose_work_is_spent_tries_no_other_ways_to_place_its_list(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whichever would be tried: the list as it was sent, without partings, free of walls, without wishes."""
    tried: list[str] = []

    def telling(name: str, way: Callable[..., Round]) -> Callable[..., Round]:
        def told(task: PlaceTask, pieces: Sequence[Piece], **how: bool) -> Round:
            tried.append(" ".join([name, *how]))
            return way(task, pieces, **how)

        return told

    for name, way in (("best_placement", best_placement), ("quick_placement", quick_placement)):
        monkeypatch.setattr(f"solver.pipeline.place.{name}", telling(name, way))
    apart = RelationSpec(type="far_from", of=("bed",), distance=0.5, required=True)
    wanted = [PieceRequest("bed", width=4.0), PieceRequest("wardrobe", width=4.0, relations=(apart,))]
    room = Room("den", width=2.2, depth=2.4)
    assert [one.id for one in place(room, wanted).best.unplaced] == ["bed", "wardrobe"]
    each = {"best_placement": 1, "best_placement quick": 5, "quick_placement": 1}
    assert Counter(tried) == each, "quick: as it was sent, each by name of the two first, free of walls, without wishes"
    tried.clear()
    monkeypatch.setattr("solver.pipeline.place.is_call_spent", lambda: True)
    assert [one.id for one in place(room, wanted).best.unplaced] == ["bed", "wardrobe"]
    assert tried == ["best_placement"]


def test_of_two_that_cannot_both_stand_the_first_does_where_it_can_alone() -> None:
    """The list is in order of importance; the larger one went, wherever it stood in it."""
    kinds, both = ("bed", "single_bed", "sofa", "wardrobe", "desk", "bathtub", "dining_table", "dresser", "piano", "bookshelf"), 0
    for seed in seeds(range(150), 11):
        chance = Random(seed)
        width, depth = round(chance.uniform(1.8, 3), 2), round(chance.uniform(1.8, 3), 2)
        first, second = (PieceRequest(kind) for kind in chance.sample(kinds, 2))
        door = Opening("d", wall="south", position=round(chance.uniform(0.5, width - 0.5), 2), width=0.8, connects_to="EXTERIOR")
        room = Room("den", width=width, depth=depth, openings=(door,))
        gone = {one.id for one in place(room, [first, second]).best.unplaced}
        both += not gone
        assert first.id not in gone or place(room, [first]).best.unplaced, (seed, first.id, second.id)
    assert both


def test_of_three_none_is_left_out_that_could_stand_instead_of_a_later_one_or_beside_the_others() -> None:
    """Where a later one had no place, either, the first went."""
    kinds, some = ("bed", "single_bed", "sofa", "wardrobe", "desk", "bathtub", "dining_table", "dresser", "piano", "bookshelf"), 0
    for seed in seeds(range(400), 31):
        chance = Random(seed)
        room = Room("den", width=round(chance.uniform(1.9, 3.2), 2), depth=round(chance.uniform(1.9, 3.2), 2))
        listed = [PieceRequest(kind) for kind in chance.sample(kinds, 3)]
        gone = {one.id for one in place(room, listed).best.unplaced}
        stand = tuple(one for one in listed if one.id not in gone)
        some += len(stand) == 2
        beside = [(*stand, one) for one in listed if one.id in gone]
        for better in (*beside, *takewhile(lambda part: part != stand, combinations(listed, len(stand)))):  # noqa: B023
            assert place(room, better).best.unplaced, (seed, gone, better)
    assert some


def test_of_optional_pieces_as_many_stand_as_can_in_nearly_every_room() -> None:
    """They were tried once, each in its turn: one had gone where two others had their only places."""
    kinds, some, more = ("bed", "single_bed", "sofa", "wardrobe", "desk", "bathtub", "dining_table", "dresser", "piano", "bookshelf"), 0, 0
    door = Opening("d", wall="south", position=1.0, width=0.8, connects_to="EXTERIOR")
    for seed in range(times(300, 17)):
        chance = Random(seed)
        room = Room("den", width=round(chance.uniform(2.2, 3.4), 2), depth=round(chance.uniform(2.2, 3.4), 2), openings=(door,))
        listed = [PieceRequest(kind, required=False) for kind in chance.sample(kinds, 4)]
        gone = len(place(room, listed).best.unplaced)
        fewer = (part for count in range(gone) for part in combinations(listed, len(listed) - count))
        some += gone > 0
        more += any(not place(room, part).best.unplaced for part in fewer)
    assert some > more * 16
