"""People and pets in fix(): placed anew where they are covered, at the nearest free place, and nobody else."""

from __future__ import annotations

import itertools
from dataclasses import replace

import pytest

from solver import Scene, fix
from solver.scene import Decoration, Dynamic, Furniture, Opening
from solver.streams import Stream
from tests.pipeline.fix_rooms import body, errors, room_of

pytestmark = pytest.mark.usefixtures("geometry_alone")
STEP = 0.05


def person(number: int, x: float, z: float, **more: object) -> Dynamic:
    return Dynamic(f"person_{number}", "person", "room_0", x, 0.0, z, 90, 0.5, 0.3, 1.7, **more)  # type: ignore[arg-type]


def crowded(seed: int) -> Scene:
    """Furniture that stands well, and three people thrown in, everything on a raster of 5 cm."""
    stream = Stream(seed, "crowd")
    door = Opening("door", "door", "south", 1.5, 0.8, connects_to="EXTERIOR", main_entrance=True)
    furniture: list[Furniture] = []
    for k in range(4):
        size = (0.5 + 0.1 * stream.below(8), 0.5 + 0.1 * stream.below(6), 0.8)
        place = (STEP * stream.below(80), STEP * stream.below(70))
        piece = body(f"box_{k}", round(place[0], 4), round(place[1], 4), size)
        if not errors(room_of(*furniture, piece, depth=3.5, openings=(door,))):
            furniture.append(piece)
    people = [person(k, round(0.15 + STEP * stream.below(74), 4), round(0.25 + STEP * stream.below(60), 4)) for k in range(3)]
    return replace(room_of(*furniture, depth=3.5, openings=(door,)), dynamic=tuple(people))


def covered(scene: Scene) -> set[str]:
    """Those who break a rule alone, and of two left in one place the later."""
    alone = {one.id for one in scene.dynamic if errors(replace(scene, dynamic=(one,)))}
    found = set(alone)
    for first, second in itertools.combinations([one for one in scene.dynamic if one.id not in alone], 2):
        if not found & {first.id, second.id} and errors(replace(scene, dynamic=(first, second))):
            found.add(second.id)
    return found


def distance(a: Dynamic, b: Dynamic) -> float:
    return ((a.x - b.x) ** 2 + (a.z - b.z) ** 2) ** 0.5


@pytest.mark.parametrize("seed", range(25))
def test_the_covered_go_to_the_nearest_free_place_and_nobody_else_moves(seed: int) -> None:
    scene = crowded(seed)
    fixed = fix(scene)
    assert errors(fixed.scene) == []
    assert fixed.scene.rooms == scene.rooms
    moved = covered(scene)
    after = {one.id: one for one in fixed.scene.dynamic}
    assert {move.id for move in fixed.moves} == moved
    still = [one for one in scene.dynamic if one.id not in moved]
    for one in (one for one in scene.dynamic if one.id in moved):
        steps = [k * STEP for k in range(-80, 81)]
        places = sorted(itertools.product(steps, steps), key=lambda step: step[0] ** 2 + step[1] ** 2)
        tried = (replace(one, x=round(one.x + dx, 4), z=round(one.z + dz, 4)) for dx, dz in places)
        best = next(place for place in tried if not errors(replace(scene, dynamic=(*still, place))))
        assert distance(one, after[one.id]) == pytest.approx(distance(one, best), abs=1e-6)
        still.append(after[one.id])


def test_there_are_covered_people_above() -> None:
    assert sum(len(covered(crowded(seed))) for seed in range(25)) > 20


def test_a_person_at_an_odd_angle_keeps_it() -> None:
    scene = replace(room_of(body("box_1", 1.0, 1.0, (1.0, 1.0, 1.0))), dynamic=(replace(person(1, 1.2, 1.0), rotation=33.0),))
    fixed = fix(scene)
    assert errors(fixed.scene) == []
    assert fixed.scene.dynamic[0].rotation == 33.0
    assert [move.id for move in fixed.moves] == ["person_1"]


def test_who_is_covered_by_repaired_furniture_is_placed_anew() -> None:
    scene = room_of(body("a_1", 1.5, 2.0, (1.0, 1.0, 1.0)), body("b_1", 2.3, 2.0, (1.0, 1.0, 1.0)), body("c_1", 2.4, 0.6, (0.8, 0.8, 1.0)))
    scene = replace(scene, dynamic=(person(1, 2.97, 2.0),))
    fixed = fix(scene)
    assert errors(fixed.scene) == []
    assert {move.id for move in fixed.moves} == {"room_0/a_1", "room_0/b_1", "person_1"}


def test_a_locked_person_stays_and_is_named() -> None:
    scene = replace(room_of(body("box_1", 1.0, 1.0, (1.0, 1.0, 1.0))), dynamic=(person(1, 1.2, 1.0),))
    fixed = fix(scene, locked=["person_1"])
    assert fixed.scene == scene
    assert {label for conflict in fixed.conflicts for label in conflict.ids} >= {"person_1"}


@pytest.mark.parametrize(("sort", "thickness", "y"), [(Furniture, 0.0204, 0.0), (Decoration, 0.0204, 0.0), (Furniture, 0.3, 1.6996)])
def test_nobody_is_put_into_what_is_no_whole_number_of_millimetres_high(
    sort: type[Furniture] | type[Decoration], thickness: float, y: float
) -> None:
    """A platform a little higher than a rug, and a board whose underside is a little lower than a head."""
    pillar, own = body("pillar_1", 2.0, 2.0, (0.6, 0.6, 2.0), locked=True), person(1, 2.0, 1.8)
    mat = sort("room_0/mat_1", "mat", x=2.0, y=y, z=1.2, width=1.0, depth=1.0, height=thickness)
    door = Opening("door", "door", "south", 3.4, 0.8, connects_to="EXTERIOR", main_entrance=True)
    scene = replace(room_of(pillar, openings=(door,)), dynamic=(own,))
    lying = {"furniture": (pillar, replace(mat, locked=True))} if isinstance(mat, Furniture) else {"decorations": (mat,)}
    fixed = fix(replace(scene, rooms=(replace(scene.rooms[0], **lying),)))
    assert errors(fixed.scene) == []
    assert [move.id for move in fixed.moves] == ["person_1"]


@pytest.mark.parametrize(("thickness", "y"), [(0.02, 0.0), (0.02, 0.0003), (0.3, 1.7)])
def test_somebody_is_put_on_a_rug_and_under_what_hangs_above_heads(thickness: float, y: float) -> None:
    pillar = body("pillar_1", 2.0, 2.0, (0.6, 0.6, 2.0), locked=True)
    mat = replace(body("mat_1", 2.0, 1.2, (1.0, 1.0, thickness), locked=True), y=y)
    move = fix(replace(room_of(pillar, mat), dynamic=(person(1, 2.0, 1.8),))).moves[0]
    assert (move.dx, move.dz) == pytest.approx((0.0, -0.35))


def full() -> Scene:
    return replace(room_of(body("box_1", 0.5, 0.5, (1.0, 1.0, 1.0)), width=1.0, depth=1.0), dynamic=(person(1, 0.5, 0.5),))


def test_where_no_place_is_free_the_person_stays_and_is_named() -> None:
    fixed = fix(full())
    assert fixed.scene == full()
    assert [conflict.ids for conflict in fixed.conflicts] == [("person_1",)]
    assert "no free place" in fixed.conflicts[0].message


def test_with_remove_the_person_goes_and_is_named() -> None:
    fixed = fix(full(), on_conflict="remove")
    assert fixed.scene.dynamic == ()
    assert [removal["id"] for removal in fixed.removed] == ["person_1"]
    assert errors(fixed.scene) == []
