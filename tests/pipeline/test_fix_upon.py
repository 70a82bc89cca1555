"""fix() of furniture that stands on furniture: dragged off, it comes back, changes its carrier or is set down; it never floats."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver import Request, Scene, fix, generate, validate
from solver.scene import Decoration, Furniture, Opening
from tests.pipeline.fix_rooms import body, errors, pieces, room_of

STAND = body("tv_stand_1", 2.0, 0.23, (1.6, 0.4, 0.5), wall="north")
TV = replace(body("tv_1", 2.0, 0.2, (1.24, 0.14, 0.74)), y=0.5, on=STAND.id)
BENCH = body("bench_1", 2.0, 2.0, (1.2, 0.6, 0.5))
CASE = replace(body("case_1", 2.0, 2.0, (0.3, 0.3, 0.3)), y=0.5, on=BENCH.id)


def at(piece: Furniture, x: float, z: float) -> Furniture:
    return replace(piece, x=x, z=z)


def one(scene: Scene, piece: Furniture) -> Furniture:
    return pieces(scene)[piece.id]


def floating(scene: Scene) -> list[str]:
    return [label for issue in validate(scene, load_catalogs()) if issue.rule == "floating" for label in issue.ids]


@pytest.mark.parametrize("moved", [(), (TV.id,), (STAND.id,)])
@pytest.mark.parametrize(("sent", "there"), [((3.3, 0.9), (2.18, 0.36)), ((2.1, 2.5), (2.1, 0.36)), ((0.7, 0.2), (1.82, 0.2))])
def test_what_stands_on_others_alone_comes_back_the_shortest_way(
    sent: tuple[float, float], there: tuple[float, float], moved: tuple[str, ...]
) -> None:
    scene = room_of(STAND, at(TV, *sent))
    assert floating(scene) == [TV.id]
    fixed = fix(scene, moved=moved)
    assert fixed.scene.rooms[0].furniture == (STAND, at(TV, *there))
    assert [move.id for move in fixed.moves] == [TV.id]
    assert fixed.issues == fixed.conflicts == ()
    assert fix(fixed.scene).scene == fixed.scene


def test_one_that_stays_over_its_carrier_stays_where_it_was_put() -> None:
    scene = room_of(STAND, at(TV, 1.7, 0.3))
    assert fix(scene, moved=[TV.id]).scene == scene


def test_one_of_any_kind_comes_back_from_near_and_is_set_down_from_far() -> None:
    near = fix(room_of(BENCH, at(CASE, 2.7, 2.1)), moved=[CASE.id]).scene
    assert one(near, CASE) == at(CASE, 2.45, 2.1)
    far = fix(room_of(BENCH, at(CASE, 3.4, 3.2)), moved=[CASE.id]).scene
    assert one(far, CASE) == replace(at(CASE, 3.4, 3.2), y=0.0, on=None)
    for scene in (near, far):
        assert errors(scene) == [] and fix(scene).scene == scene


@pytest.mark.parametrize(("sent", "there"), [(30, 0), (100, 90), (315.0, 0)])
def test_one_at_an_odd_angle_is_squared_up(sent: float, there: int) -> None:
    fixed = fix(room_of(BENCH, replace(CASE, rotation=sent), body("crate", 2.2, 2.5, (0.6, 0.6, 0.5))))
    assert one(fixed.scene, CASE).rotation == there and errors(fixed.scene) == []
    assert fix(fixed.scene).scene == fixed.scene


def test_one_at_an_odd_angle_for_which_there_is_no_room_so_turns_as_its_carrier_is() -> None:
    """Across the stand the TV would be in the wall; turned back by as much as that, it stood at 320 degrees."""
    fixed = fix(room_of(STAND, replace(TV, rotation=50)))
    assert one(fixed.scene, TV) == TV and fixed.conflicts == ()
    assert fix(fixed.scene).scene == fixed.scene


def test_it_goes_along_with_its_carrier() -> None:
    scene = room_of(at(BENCH, 2.0, 3.2), CASE)
    fixed = fix(scene, moved=[BENCH.id]).scene
    assert one(fixed, BENCH) == at(BENCH, 2.0, 3.2)
    assert one(fixed, CASE) == at(CASE, 2.0, 3.05)


def test_dropped_on_another_that_carries_its_kind_it_stands_on_that() -> None:
    other = body("tv_stand_2", 2.0, 3.5, (1.1, 0.38, 0.5))
    sofa = body("sofa_1", 2.0, 2.2, (2.0, 0.9, 0.8))
    fixed = fix(room_of(STAND, other, at(TV, 2.1, 3.6)), moved=[TV.id]).scene
    assert one(fixed, TV) == replace(TV, x=2.0, z=3.6, on=other.id)
    assert one(fix(room_of(STAND, sofa, at(TV, 2.1, 2.2)), moved=[TV.id]).scene, TV) == at(TV, 2.1, 0.36)


def test_two_on_one_carrier_stand_beside_each_other() -> None:
    second = replace(at(CASE, 1.6, 2.0), id="room_0/case_2")
    fixed = fix(room_of(BENCH, CASE, at(second, 2.2, 2.05)), moved=[second.id]).scene
    assert (one(fixed, CASE), one(fixed, second)) == (CASE, at(second, 2.3, 2.05))
    assert errors(fixed) == []


def test_the_last_of_eight_comes_to_the_only_place_that_is_left() -> None:
    eight = [replace(at(CASE, x, z), id=f"room_0/case_{x}_{z}") for x in (1.55, 1.85, 2.15, 2.45) for z in (1.85, 2.15)]
    fixed = fix(room_of(BENCH, *eight[:-1], at(eight[-1], 2.0, 2.0)), moved=[eight[-1].id]).scene
    assert [one(fixed, case) for case in eight] == eight


def test_height_is_mended_too() -> None:
    for y in (0.0, 0.3, 1.2):
        assert one(fix(room_of(STAND, replace(TV, y=y))).scene, TV) == TV


def test_what_lies_on_it_comes_along() -> None:
    lamp = Decoration("room_0/lamp_1", "table_lamp", CASE.id, None, 2.75, 0.8, 2.15, 0, 0.1, 0.1, 0.3)
    scene = room_of(BENCH, at(CASE, 2.7, 2.1), decorations=(lamp,))
    fixed = fix(scene, moved=[CASE.id]).scene
    assert fixed.rooms[0].decorations == (replace(lamp, x=2.5),)
    fallen = fix(room_of(BENCH, at(CASE, 3.4, 3.2), decorations=(replace(lamp, x=3.45, z=3.25),)), moved=[CASE.id]).scene
    assert fallen.rooms[0].decorations == (replace(lamp, x=3.45, y=0.3, z=3.25),)


def test_without_its_carrier_it_is_set_down() -> None:
    assert one(fix(room_of(TV)).scene, TV) == replace(TV, on=None, y=0.0)
    assert one(fix(room_of(replace(STAND, id="room_0/tv_stand_9"), at(TV, 2.0, 2.0))).scene, TV).on == "room_0/tv_stand_9"


def test_pieces_that_stand_on_each_other_are_taken_apart() -> None:
    ring = room_of(replace(CASE, on="room_0/case_2"), replace(CASE, id="room_0/case_2", y=0.8, on=CASE.id))
    assert floating(ring) == [CASE.id, "room_0/case_2"]
    fixed = fix(ring).scene
    assert errors(fixed) == []
    assert [(piece.y, piece.on) for piece in fixed.rooms[0].furniture] == [(0.0, None), (0.3, CASE.id)]
    assert fix(fixed).scene == fixed


def test_a_locked_one_stays_and_is_named() -> None:
    scene = room_of(STAND, replace(at(TV, 3.0, 2.0), locked=True))
    fixed = fix(scene, moved=[TV.id])
    assert fixed.scene == scene
    assert [conflict.ids for conflict in fixed.conflicts] == [(TV.id,)]
    assert "locked" in fixed.conflicts[0].message


def test_a_carrier_that_is_squared_up_keeps_what_stands_on_it() -> None:
    scene = room_of(replace(at(STAND, 1.0, 2.0), rotation=83.0, wall=None), replace(at(TV, 0.4, 2.0), rotation=90))
    fixed = fix(scene).scene
    assert errors(fixed) == [] and fix(fixed).scene == fixed


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("by", [(1.4, 0.4), (-1.0, 1.1)])
def test_dragged_off_in_a_house_it_never_hangs_in_the_air(seed: int, by: tuple[float, float]) -> None:
    made = generate(Request(seed=seed, width=12, depth=9)).scene
    carried = [piece for room in made.rooms for piece in room.furniture if piece.on is not None]
    assert carried
    for piece in carried:
        off = replace(piece, x=round(piece.x + by[0], 4), z=round(piece.z + by[1], 4))
        rooms = tuple(replace(room, furniture=tuple(off if own is piece else own for own in room.furniture)) for room in made.rooms)
        fixed = fix(replace(made, rooms=rooms), moved=[piece.id])
        after = {own.id: own for room in fixed.scene.rooms for own in room.furniture}
        under = after[after[piece.id].on or ""]
        assert errors(fixed.scene) == [] and (under.x, under.z) == next(
            (own.x, own.z) for room in made.rooms for own in room.furniture if own.id == under.id
        )
        assert abs(after[piece.id].x - under.x) <= max(under.width, under.depth) / 2
        assert fix(fixed.scene).scene == fixed.scene


def test_a_carrier_too_full_for_all_is_answered_at_once_and_in_words() -> None:
    cases = [replace(at(CASE, 3.4, 1.0 + k / 100), id=f"room_0/case_{k}") for k in range(24)]
    fixed = fix(room_of(BENCH, *cases), moved=[BENCH.id])
    assert floating(fixed.scene) == [] and fixed.conflicts
    assert fix(fixed.scene).scene == fixed.scene


def test_one_that_juts_out_into_a_narrow_way_is_drawn_in() -> None:
    """0.62 m are left before the counters: no more than a person needs, so nothing may jut out by 3 cm."""
    counter = body("counter_1", 0.3, 1.5, (0.6, 0.6, 0.9), wall="west")
    facing = [body(f"counter_{2 + k}", 1.52, 0.3 + 0.6 * k, (0.6, 0.6, 0.9), wall="east") for k in range(5)]
    oven = replace(body("microwave_1", 0.44, 1.45, (0.5, 0.38, 0.3)), rotation=90, y=0.9, on=counter.id)
    counters = [replace(counter, rotation=90), *(replace(one, rotation=270) for one in facing)]
    door = Opening("door", "door", "south", 0.91, 0.62, connects_to="EXTERIOR", main_entrance=True)
    sent = room_of(*counters, oven, width=1.82, depth=4.0, openings=(door,))
    assert {issue.rule for issue in validate(sent, load_catalogs()) if issue.severity == "error"} == {"unreachable"}
    fixed = fix(sent)
    assert one(fixed.scene, oven) == at(oven, 0.41, 1.45)
    assert [move.id for move in fixed.moves] == [oven.id]
    assert fixed.conflicts == ()


@pytest.mark.parametrize("rotation", [0, 90, 180, 270])
def test_what_shares_space_on_a_counter_slides_apart_over_it(rotation: int) -> None:
    """A kettle 5 cm in a microwave, a box right beside the kettle, a cup on each: there is room on the counter, so nothing else moves."""
    ahead = {0: (1, 0), 90: (0, -1), 180: (-1, 0), 270: (0, 1)}[rotation]
    counter = replace(body("counter_1", 2.0, 2.0, (1.6, 0.6, 0.9)), rotation=rotation)
    sizes = (("microwave_1", -0.4, (0.5, 0.4, 0.3)), ("kettle_1", -0.1, (0.2, 0.2, 0.3)), ("box_1", 0.1, (0.2, 0.3, 0.3)))
    there = [body(name, 2.0 + aside * ahead[0], 2.0 + aside * ahead[1], size) for name, aside, size in sizes]
    upon = [replace(piece, y=0.9, on=counter.id, rotation=rotation) for piece in there]
    cups = [replace(body(f"cup_{k}", piece.x, piece.z, (0.08, 0.08, 0.1)), y=1.2, on=piece.id) for k, piece in enumerate(upon)]
    fixed = fix(room_of(counter, *cups, *upon))
    assert (errors(fixed.scene), fixed.conflicts) == ([], ())
    assert sum(abs(move.dx) + abs(move.dz) for move in fixed.moves) <= 0.204
    assert counter.id not in {move.id for move in fixed.moves}
    assert all((one(fixed.scene, cup).x, one(fixed.scene, cup).z) == pytest.approx(_at(fixed.scene, cup.on)) for cup in cups)
    assert fix(fixed.scene).moves == ()


def _at(scene: Scene, label: str | None) -> tuple[float, float]:
    carrier = pieces(scene)[label or ""]
    return carrier.x, carrier.z
