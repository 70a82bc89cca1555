"""Who sits belongs to the seat: no overlap with it, taken along by a repair, shown by the view, kept by a document."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver import Scene, fix, validate
from solver.exchange import read_scene, write_scene
from solver.scene import Dynamic, Furniture, Opening
from solver.view import view
from tests.pipeline.fix_rooms import body, errors, room_of


def seat(x: float, z: float, rotation: int = 0, **more: object) -> Furniture:
    piece = body("armchair_1", x, z, (0.8, 0.82, 0.85), **more)
    return replace(piece, category="seating", rotation=rotation)


def sitter(x: float, z: float, rotation: int = 0, **more: object) -> Dynamic:
    values = {"y": 0.44, "width": 0.46, "depth": 0.5, "height": 0.9, "on": "room_0/armchair_1", **more}
    return Dynamic("person_1", "person", "room_0", x, z=z, rotation=rotation, **values)  # type: ignore[arg-type]


def scene_of(*pieces: Furniture, people: tuple[Dynamic, ...], **more: object) -> Scene:
    return replace(room_of(*pieces, **more), dynamic=people)  # type: ignore[arg-type]


def offset(person: Dynamic, piece: Furniture) -> tuple[float, float, float]:
    """The person's place in the frame of the seat: across, along, turned."""
    dx, dz = person.x - piece.x, person.z - piece.z
    right, front = {0: ((1, 0), (0, 1)), 90: ((0, -1), (1, 0)), 180: ((-1, 0), (0, -1)), 270: ((0, 1), (-1, 0))}[
        round(piece.rotation) % 360
    ]
    across, along = dx * right[0] + dz * right[1], dx * front[0] + dz * front[1]
    return round(across, 4), round(along, 4), (person.rotation - piece.rotation) % 360


def test_who_sits_does_not_overlap_the_seat_but_anything_else() -> None:
    assert errors(scene_of(seat(2, 2), people=(sitter(2, 2.05),))) == []
    assert len(errors(scene_of(seat(2, 2), people=(sitter(2, 2.05, on=None),)))) == 1
    box = body("box_1", 2.0, 2.6, (0.6, 0.3, 1.0))
    assert errors(scene_of(seat(2, 2), box, people=())) != [] or errors(scene_of(seat(2, 2), box, people=(sitter(2, 2.3),))) != []
    two = (sitter(2, 2.05), replace(sitter(2, 2.05), id="person_2"))
    assert any("person_1" in message and "person_2" in message for message in errors(scene_of(seat(2, 2), people=two)))


def test_a_repair_takes_along_who_sits() -> None:
    """The seat is moved off a box, and turned where it was askew; whoever sits on it stays where they sat in its frame."""
    box = body("box_1", 2.0, 1.5, (1.0, 1.0, 1.0))
    moved = 0
    for rotation in (0, 90, 180, 270):
        piece = seat(2.3, 2.1, rotation)
        front = {0: (0, 0.05), 90: (0.05, 0), 180: (0, -0.05), 270: (-0.05, 0)}[rotation]
        scene = scene_of(piece, box, people=(sitter(piece.x + front[0], piece.z + front[1], rotation),))
        fixed = fix(scene, locked=["room_0/box_1"])
        assert errors(fixed.scene) == []
        now = next(one for one in fixed.scene.rooms[0].furniture if one.id == piece.id)
        (person,) = fixed.scene.dynamic
        assert person.on == piece.id and person.y == 0.44
        assert offset(person, now) == offset(scene.dynamic[0], piece)
        moved += (now.x, now.z) != (piece.x, piece.z)
        assert "person_1" in {move.id for move in fixed.moves}
    assert moved == 4


def test_a_locked_sitter_holds_the_seat() -> None:
    box = body("box_1", 2.0, 1.5, (1.0, 1.0, 1.0))
    scene = scene_of(seat(2.3, 2.1), box, people=(sitter(2.3, 2.15),))
    fixed = fix(scene, locked=["person_1"])
    assert errors(fixed.scene) == []
    assert fixed.scene.dynamic == scene.dynamic
    assert {move.id for move in fixed.moves} == {"room_0/box_1"}


def test_who_is_covered_on_the_seat_stands_up_elsewhere() -> None:
    shelf = replace(body("shelf_1", 2.0, 2.0, (0.6, 0.5, 0.4)), y=0.9)
    scene = scene_of(seat(2, 2), people=(sitter(2, 2.05),))
    scene = replace(scene, rooms=(replace(scene.rooms[0], furniture=(*scene.rooms[0].furniture, shelf)),))
    assert errors(scene) != []
    fixed = fix(scene, locked=["room_0/shelf_1", "room_0/armchair_1"])
    (person,) = fixed.scene.dynamic
    assert errors(fixed.scene) == []
    assert (person.on, person.y, person.width, person.depth, person.height) == (None, 0.0, 0.5, 0.3, 1.7)


@pytest.mark.usefixtures("geometry_alone")
def test_who_loses_the_seat_stands_up() -> None:
    """Two pieces in a room for one: the seat is taken out, the person is not."""
    big = body("box_1", 0.6, 0.6, (1.0, 1.0, 1.0))
    scene = scene_of(big, seat(0.6, 0.6), people=(sitter(0.6, 0.65),), width=1.4, depth=1.7)
    fixed = fix(scene, on_conflict="remove", locked=["room_0/box_1"])
    assert [removal["id"] for removal in fixed.removed][:1] == ["room_0/armchair_1"]
    assert errors(fixed.scene) == []
    assert [person.on for person in fixed.scene.dynamic] == [None]


def test_documents_keep_the_seat_and_the_view_shows_it() -> None:
    scene = read_scene(write_scene(scene_of(seat(2, 2), people=(sitter(2, 2.05),))))
    assert scene.dynamic[0].on == "room_0/armchair_1"
    assert write_scene(scene)["dynamic"][0]["on"] == "room_0/armchair_1"
    text, lines = view(scene, {room.id: 0.0 for room in scene.rooms})
    (line,) = [line for line, shown in zip(text.splitlines(), lines, strict=True) if shown == "person_1"]
    assert "on room_0/armchair_1" in line
    assert validate(scene, load_catalogs()) == ()


def blocked() -> Scene:
    """A person stands in the only way to a sofa: between two shelves that leave 0.9 m."""
    sofa = replace(body("sofa_1", 2.0, 0.5, (2.0, 0.9, 0.85)), category="seating")
    shelves = [body("shelf_1", 0.825, 2.5, (1.55, 0.4, 1.0)), body("shelf_2", 3.225, 2.5, (1.45, 0.4, 1.0))]
    door = Opening("door", "door", "south", 2.0, 0.9, connects_to="EXTERIOR", main_entrance=True)
    return scene_of(sofa, *shelves, people=(Dynamic("person_1", "person", "room_0", 2.05, z=2.5),), openings=(door,))


def test_who_stands_in_the_only_way_steps_aside_and_nothing_else_moves() -> None:
    scene = blocked()
    assert any("cannot get to" in message for message in errors(scene))
    assert errors(replace(scene, dynamic=())) == []
    fixed = fix(scene)
    assert errors(fixed.scene) == []
    assert fixed.conflicts == ()
    assert [move.id for move in fixed.moves] == ["person_1"]
    assert fixed.scene.rooms == scene.rooms
    assert fix(fixed.scene).scene == fixed.scene


def test_a_locked_person_in_the_only_way_stays() -> None:
    fixed = fix(blocked(), locked=["person_1"])
    assert fixed.scene == blocked()
    assert fixed.conflicts


def test_who_is_covered_is_not_put_into_the_only_way() -> None:
    """The nearest free place of somebody covered by a box that leaves but one way is in that way; another one is taken."""
    scene = blocked()
    (person,) = scene.dynamic
    covered = replace(scene, dynamic=(replace(person, x=1.5),))
    assert any("share space" in message for message in errors(covered))
    fixed = fix(covered)
    assert errors(fixed.scene) == []
    assert [move.id for move in fixed.moves] == ["person_1"]
