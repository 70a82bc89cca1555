"""Scenes in the words of others: judged, repaired and furnished like those in ours, and given back in theirs."""

from __future__ import annotations

from dataclasses import replace

from catalogs import load_catalogs
from compose_homes import Decoration, Furniture, Opening, PieceRequest, Room, Scene, fix, place, validate
from solver.understanding import with_understood_kinds

DOOR = Opening("door", "door", wall="south", position=1.0, connects_to="EXTERIOR")
THEIRS = {"bed": "DoubleBed", "wardrobe": "Kleiderschrank", "desk": "writing table"}


def room(names: dict[str, str]) -> Room:
    bed = Furniture("a", names["bed"], x=2.2, z=1.03, width=1.6, depth=2.0, height=0.9)
    wardrobe = Furniture("b", names["wardrobe"], x=3.1, z=1.4, width=1.8, depth=0.6, height=2.1, rotation=270)
    desk = Furniture("c", names["desk"], x=0.4, z=2.0, width=1.4, depth=0.7, height=0.75, rotation=90)
    return Room("den", width=4.0, depth=3.6, openings=(DOOR,), furniture=(bed, wardrobe, desk))


OURS = Scene(rooms=(room({name: name for name in THEIRS}),))
FOREIGN = Scene(rooms=(room(THEIRS),))


def poses(scene: Scene) -> list[tuple[str, float, float, float]]:
    return [(piece.id, piece.x, piece.z, piece.rotation) for piece in scene.rooms[0].furniture]


def test_it_is_judged_like_ours() -> None:
    ours = validate(OURS)
    assert ours
    assert validate(FOREIGN) == ours


def test_it_is_repaired_like_ours_and_keeps_its_names() -> None:
    ours, theirs = fix(OURS), fix(FOREIGN)
    assert theirs.moves == ours.moves
    assert poses(theirs.scene) == poses(ours.scene)
    assert [piece.name for piece in theirs.scene.rooms[0].furniture] == list(THEIRS.values())
    assert [piece.kind for piece in theirs.scene.rooms[0].furniture] == [None] * 3
    assert (ours.understood_as, theirs.understood_as) == ({}, {"a": "bed", "b": "wardrobe", "c": "desk"})
    assert fix(theirs.scene).moves == ()


def test_the_kind_that_a_piece_names_counts() -> None:
    piece = replace(OURS.rooms[0].furniture[1], name="monolith")
    said = replace(piece, kind="wardrobe")
    for one, understood in ((piece, {}), (said, {"b": "wardrobe"})):
        assert fix(Scene(rooms=(replace(OURS.rooms[0], furniture=(one,)),))).understood_as == understood


def test_a_list_is_placed_like_ours() -> None:
    bare = Room("den", width=4.0, depth=3.6, openings=(DOOR,))
    ours = place(bare, [PieceRequest(name, name) for name in THEIRS])
    theirs = place(bare, [PieceRequest(name, foreign) for name, foreign in THEIRS.items()])
    assert poses(theirs.best.scene) == poses(ours.best.scene)
    assert [piece.name for piece in theirs.best.scene.rooms[0].furniture] == [
        THEIRS[piece.id] for piece in theirs.best.scene.rooms[0].furniture
    ]
    assert (ours.understood_as, theirs.understood_as) == ({}, {name: name for name in THEIRS})
    assert theirs.best.issues == ()


def test_what_stands_already_is_used_like_ours() -> None:
    bed = Furniture("a", "DoubleBed", x=2.0, z=1.03, width=1.6, depth=2.0, height=0.9)
    answer = place(Room("den", width=2.8, depth=3.6, openings=(DOOR,), furniture=(bed,)), [PieceRequest("shelf", "Bookcase")])
    assert answer.understood_as == {"a": "bed", "shelf": "bookshelf"}
    assert answer.best.scene.rooms[0].furniture[0] == bed
    assert answer.best.issues == ()


def test_it_can_say_what_its_pieces_are_understood_as_and_keeps_its_names() -> None:
    lamp = Decoration("d", "AlarmClock", x=1.0, z=1.0, width=0.1, depth=0.06, height=0.09)
    named = Furniture("e", "DoubleBed", x=1.0, z=1.0, width=1.6, depth=2.0, height=0.9, kind="thing_of_mine")
    scene = Scene(rooms=(replace(FOREIGN.rooms[0], furniture=(*FOREIGN.rooms[0].furniture, named), decorations=(lamp,)),))
    (told,) = with_understood_kinds(scene, load_catalogs()).rooms
    assert [piece.name for piece in told.furniture] == [*THEIRS.values(), "DoubleBed"]
    assert [piece.kind for piece in told.furniture] == ["bed", "wardrobe", "desk", "thing_of_mine"]
    assert [(thing.name, thing.kind) for thing in told.decorations] == [("AlarmClock", "alarm_clock")]
