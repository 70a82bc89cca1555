"""reroll() of rooms with locked pieces: those stay to the millimetre with what lies on them, the rest is furnished around them."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import pytest

from catalogs import load_catalogs
from solver import Request, Scene, generate, reroll, validate
from solver.answers import Generated
from solver.errors import SceneError
from solver.scene import Decoration, Furniture, Opening, Room
from solver.streams import Stream
from tests.sweeps import seeds


@lru_cache(maxsize=8)
def house(seed: int) -> Scene:
    return generate(Request(seed=seed, width=14, depth=10, decorate=True)).scene


def with_furniture(scene: Scene, name: str, *furniture: Furniture) -> Scene:
    return replace(scene, rooms=tuple(replace(room, furniture=furniture) if room.id == name else room for room in scene.rooms))


def locking(scene: Scene, room: Room, ids: set[str]) -> Scene:
    return with_furniture(scene, room.id, *(replace(piece, locked=piece.id in ids) for piece in room.furniture))


def room_in(scene: Scene, name: str) -> Room:
    return next(room for room in scene.rooms if room.id == name)


def bodies_of(room: Room) -> list[Furniture | Decoration]:
    return [*room.furniture, *room.decorations]


def check(sent: Scene, name: str, made: Generated) -> None:
    """All that was locked is there as it was, nothing breaks a rule, no required piece is missing and no id is given twice.

    Floor is not kept free before the fronts of what is locked: the rest may stand there.
    """
    after = {piece.id: piece for piece in room_in(made.scene, name).furniture}
    for piece in room_in(sent, name).furniture:
        if piece.locked:
            assert after[piece.id] == piece
    assert [issue.message for issue in validate(made.scene, load_catalogs()) if issue.rule != "front_blocked"] == []
    ids = [body.id for room in made.scene.rooms for body in bodies_of(room)]
    assert len(ids) == len(set(ids))
    assert [room for room in made.scene.rooms if room.id != name] == [room for room in sent.rooms if room.id != name]


@pytest.mark.parametrize("seed", seeds(range(3), 3))
def test_one_locked_piece_stays_and_the_rest_is_furnished_around_it(seed: int) -> None:
    scene, changed = house(seed), 0
    for room in scene.rooms:
        for number, piece in enumerate(room.furniture[::3]):
            sent = locking(scene, room, {piece.id})
            made = reroll(sent, [room.id], seed=1000 * seed + number)
            check(sent, room.id, made)
            after = room_in(made.scene, room.id)
            assert [own.id for own in after.furniture if own.locked] == [piece.id]
            changed += {own.id: own for own in after.furniture} != {own.id: own for own in room_in(sent, room.id).furniture}
    assert changed > 15


@pytest.mark.parametrize("seed", range(4))
def test_several_locked_pieces_stay(seed: int) -> None:
    scene, stream = house(seed), Stream(seed, "locks")
    for room in scene.rooms:
        sent = locking(scene, room, {piece.id for piece in room.furniture if stream.chance(0.4)})
        check(sent, room.id, reroll(sent, [room.id], seed=seed + 50))
    everything = locking(scene, room, {piece.id for piece in room.furniture})
    check(everything, room.id, reroll(everything, [room.id], seed=seed))


def living(scene: Scene) -> Room:
    return next(room for room in scene.rooms if room.type == "living_room")


def named(room: Room, name: str) -> Furniture:
    return next(piece for piece in room.furniture if piece.name == name)


def test_a_locked_piece_takes_the_place_of_the_one_that_was_wanted() -> None:
    scene = house(0)
    room = living(scene)
    sofa = named(room, "sofa")
    for seed in range(8):
        after = room_in(reroll(locking(scene, room, {sofa.id}), [room.id], seed=seed).scene, room.id)
        assert [piece.name for piece in after.furniture].count("sofa") == 1
        table = next((piece for piece in after.furniture if piece.name == "coffee_table"), None)
        assert table is None or abs(table.x - sofa.x) < 0.01 or abs(table.z - sofa.z) < 0.01


def test_what_carries_a_locked_piece_and_its_table_stay_too() -> None:
    for seed in seeds(range(3), 2):
        scene = house(seed)
        for room in scene.rooms:
            for piece in room.furniture:
                below = piece.on or piece.under
                if below is not None and piece.id.endswith("_1"):
                    made = reroll(locking(scene, room, {piece.id}), [room.id], seed=seed + 9).scene
                    after = {own.id: own for own in room_in(made, room.id).furniture}
                    assert after[below] == next(own for own in room.furniture if own.id == below)
                    assert after[piece.id] == replace(piece, locked=True)


def test_what_lies_on_a_locked_piece_stays() -> None:
    scene = house(0)
    room = living(scene)
    sofa = named(room, "sofa")
    lying = [thing for thing in room.decorations if thing.parent == sofa.id and thing.mounted_on_wall is None]
    mug = Decoration(f"{room.id}/own_mug_1", "mug", sofa.id, None, sofa.x, 0.45, sofa.z, 0, 0.1, 0.1, 0.1)
    sent = locking(scene, room, {sofa.id})
    sent = replace(sent, rooms=tuple(replace(one, decorations=(*one.decorations, mug)) if one.id == room.id else one for one in sent.rooms))
    after = room_in(reroll(sent, [room.id], seed=3).scene, room.id).decorations
    assert [thing for thing in after if thing.parent == sofa.id and thing.mounted_on_wall is None] == [*lying, mug]


def test_a_locked_piece_that_nothing_knows_stays_too() -> None:
    crate = Furniture("own_crate", "never_heard_of", None, 2.0, 0.0, 2.2, 0, 0.6, 0.5, 0.4, locked=True)
    sent = Scene(seed=1, rooms=(Room("r", 0, "bedroom", 0, 0.0, 0.0, 4.0, 4.0, furniture=(crate,)),))
    for seed in range(4):
        made = reroll(sent, ["r"], seed=seed)
        check(sent, "r", made)
        assert len(made.scene.rooms[0].furniture) > 3


def test_where_nothing_can_be_furnished_around_it_the_room_is_refused_in_words() -> None:
    wall = Furniture("r/wall_1", "wall", None, 2.0, 0.0, 2.0, 0, 4.0, 3.0, 2.0, locked=True)
    sent = Scene(seed=1, rooms=(Room("r", 0, "bedroom", 0, 0.0, 0.0, 4.0, 4.0, furniture=(wall,)),))
    bare = Scene(seed=1, rooms=(Room("q", 0, "bedroom", 0, 0.0, 0.0, 4.0, 4.0), *sent.rooms))
    with pytest.raises(SceneError) as refused:
        reroll(bare, ["q", "r"], seed=1)
    assert refused.value.field == "reroll[1]"
    assert "locked" in refused.value.problem and "r/wall_1" in refused.value.problem
    assert "unlock" in refused.value.allowed and "another room" in refused.value.allowed


def test_one_that_is_in_the_way_already_stays_and_is_named_as_before() -> None:
    window = Opening("window_1", "window", "north", 2.0, 1.2, 1.2, 0.9, "EXTERIOR")
    tall = Furniture("r/wardrobe_1", "wardrobe", "storage", 2.0, 0.0, 0.33, 0, 1.2, 0.6, 2.0, wall="north", locked=True)
    sent = Scene(seed=1, rooms=(Room("r", 0, "bedroom", 0, 0.0, 0.0, 4.0, 4.5, openings=(window,), furniture=(tall,)),))
    before = [issue for issue in validate(sent, load_catalogs()) if issue.severity == "error"]
    assert [(issue.rule, issue.ids) for issue in before] == [("blocks_window", (tall.id,))]
    made = reroll(sent, ["r"], seed=2)
    assert tall in made.scene.rooms[0].furniture and len(made.scene.rooms[0].furniture) > 3
    assert [piece.name for piece in made.scene.rooms[0].furniture].count("wardrobe") == 1
    assert list(made.issues) == before
