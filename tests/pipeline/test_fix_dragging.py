"""fix_frame(), a frame of a drag: as the core answers it, in the room of the piece in hand alone; others fall back on the whole repair."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace

import pytest

from catalogs import load_catalogs
from service.calls import fix_scene, take_in_hand
from solver import Scene, fix, fix_frame, validate
from solver.answers import Fixed, Pose
from solver.errors import RequestError
from solver.exchange import write_scene
from solver.scene import Decoration, Furniture
from solver.scene_bodies import bodies_of
from tests.pipeline.drags import dense_rooms, dragged, home, scene_at, way
from tests.pipeline.fix_rooms import body, errors, pieces, room_of

FRAMES = 12


def free_piece(scene: Scene) -> Furniture:
    """A piece that carries something and can be dragged."""
    carriers = {thing.parent for thing in scene.rooms[0].decorations if thing.mounted_on_wall is None}
    return next(piece for piece in scene.rooms[0].furniture if piece.id in carriers and dragged(scene, piece.id, 1))


def poses_of(scene: Scene) -> tuple[Pose, ...]:
    return tuple(Pose(one.id, one.x, one.z, one.rotation) for one in bodies_of(scene))


def sent(scene: Scene, label: str, wish: tuple[float, float]) -> Scene:
    """The scene as the page sends it: the piece where it is wished, what it carries and its chairs with it, the rest where it was."""
    bodies = {one.id: one for one in bodies_of(scene)}
    dx, dz = wish[0] - bodies[label].x, wish[1] - bodies[label].z
    goes, before = {label}, 0
    while before < len(goes):
        before = len(goes)
        goes |= {
            one.id for one in bodies.values() if not _hangs(one) and goes & {getattr(one, name, None) for name in ("on", "under", "parent")}
        }
    spots = [value for one in bodies_of(scene) for value in _gone(one, dx * (one.id in goes), dz * (one.id in goes))]
    return scene_at(scene, spots, label)


def _hangs(one: object) -> bool:
    return isinstance(one, Decoration) and one.mounted_on_wall is not None


def _gone(one: object, dx: float, dz: float) -> tuple[float, float]:
    return round(one.x + dx, 4), round(one.z + dz, 4)  # type: ignore[attr-defined]


def frame(scene: Scene, label: str, previous: Sequence[Pose] = ()) -> Fixed:
    fixed = fix_frame(scene, [label], previous=previous)
    assert fixed is not None
    return fixed


def frames(scene: Scene, label: str, alone: bool = False) -> list[Fixed]:
    """A drag by fix_frame(); with `alone` the piece is sent where it is wished without what it carries."""
    found, last = [], poses_of(scene)
    for wish in way(scene, label, FRAMES):
        asked = sent(scene, label, wish)
        if alone:
            spots = [value for one in bodies_of(scene) for value in (wish if one.id == label else (one.x, one.z))]
            asked = scene_at(scene, spots, label)
        fixed = frame(asked, label, last)
        found.append(fixed)
        last = poses_of(fixed.scene)
    return found


def test_fix_answers_as_the_core_does() -> None:
    for scene in dense_rooms(1)[:2]:
        piece = free_piece(scene)
        steps = dragged(scene, piece.id, FRAMES)
        for fixed, step in zip(frames(scene, piece.id), steps, strict=True):
            told = tuple(value for one in bodies_of(fixed.scene) for value in (one.x, one.z))
            assert told == pytest.approx(step.answer.spots, abs=2e-4)
            assert (fixed.conflicts, fixed.removed, fixed.issues) == ((), (), ())
            assert fixed.timing_ms["work"] == step.answer.work
            assert [issue for issue in validate(fixed.scene, load_catalogs()) if issue.severity == "error"] == []


def test_what_it_carries_may_be_left_where_it_was() -> None:
    for scene in dense_rooms(1)[:2]:
        for fixed in frames(scene, free_piece(scene).id, alone=True):
            assert fixed.conflicts == ()
            assert [issue for issue in validate(fixed.scene, load_catalogs()) if issue.severity == "error"] == []


def test_only_the_room_of_the_piece_in_hand_is_answered() -> None:
    whole = home(1)
    room = next(room for room in whole.rooms if len(room.furniture) >= 7)
    piece = next(piece for piece in room.furniture if piece.on is None and not piece.under)
    there = replace(piece, x=piece.x + 0.4, z=piece.z + 0.3, wall=None)
    moved = replace(room, furniture=tuple(there if one is piece else one for one in room.furniture))
    asked = replace(whole, rooms=tuple(moved if one is room else one for one in whole.rooms))
    fixed = frame(asked, piece.id, poses_of(whole))
    for before, after in zip(asked.rooms, fixed.scene.rooms, strict=True):
        assert after.id == room.id or after == before
    assert {move.id for move in fixed.moves} <= {
        *(one.id for one in room.furniture),
        *(one.id for one in room.decorations),
        *(one.id for one in whole.dynamic),
    }


def test_what_moved_is_told_against_what_was_sent() -> None:
    scene = room_of(body("sofa_1", -0.5, 2.0, (2.0, 0.9, 0.8)), body("box_1", 3.0, 3.5, (0.4, 0.4, 0.4)))
    fixed = frame(scene, "room_0/sofa_1", [Pose("room_0/sofa_1", 1.0, 2.0, 0)])
    assert [(move.id, move.dx, move.dz) for move in fixed.moves] == [("room_0/sofa_1", 1.5, 0.0)]
    assert errors(fixed.scene) == []


def test_without_a_valid_place_the_scene_comes_back_with_a_conflict_and_no_repairs() -> None:
    scene = room_of(*(body(f"box_{k}", 1.0, 1.0, (1.5, 1.5, 0.4)) for k in range(2)), width=2.0, depth=2.0)
    fixed = frame(scene, "room_0/box_0")
    assert fixed.scene == scene
    assert [(conflict.ids, conflict.repairs) for conflict in fixed.conflicts] == [(("room_0/box_0",), ())]


def test_a_piece_that_stands_on_another_is_repaired_as_ever() -> None:
    scene = next(scene for scene in dense_rooms(1) if any(piece.on for piece in scene.rooms[0].furniture))
    piece = next(piece for piece in scene.rooms[0].furniture if piece.on)
    asked = sent(scene, piece.id, (piece.x + 0.1, piece.z))
    assert fix_frame(asked, [piece.id], previous=poses_of(scene)) is None
    document = {"scene": write_scene(asked), "moved": [piece.id], "previous": [asdict(pose) for pose in poses_of(scene)]}
    once, ever = (fix_scene(document | {"dragging": flag}, load_catalogs()) for flag in (True, False))
    assert {**once, "timing_ms": {}} == {**ever, "timing_ms": {}}
    assert once["scene"] == write_scene(fix(asked, moved=[piece.id], previous=poses_of(scene)).scene)


@pytest.mark.parametrize("moved", [[], ["room_0/box_0", "room_0/box_1"]])
def test_a_frame_names_the_one_piece_in_hand(moved: list[str]) -> None:
    scene = room_of(*(body(f"box_{k}", 1.0 + k, 1.0, (0.5, 0.5, 0.4)) for k in range(2)))
    with pytest.raises(RequestError, match="moved"):
        fix_frame(scene, moved)


def test_drags_of_several_rooms_and_catalogs_are_kept_apart() -> None:
    one, other = dense_rooms(1)[:2]
    labels = free_piece(one).id, free_piece(other).id
    apart = [frames(one, labels[0]), frames(other, labels[1])]
    wishes = [list(way(one, labels[0], FRAMES)), list(way(other, labels[1], FRAMES))]
    last = [poses_of(one), poses_of(other)]
    for k in range(FRAMES):
        for n, scene in enumerate((one, other)):
            fixed = frame(sent(scene, labels[n], wishes[n][k]), labels[n], last[n])
            assert fixed.scene == apart[n][k].scene
            last[n] = poses_of(fixed.scene)


def test_the_calls_take_a_frame_and_prepare_a_drag() -> None:
    scene = room_of(body("sofa_1", 1.0, 2.0, (2.0, 0.9, 0.8)), body("box_1", 3.0, 3.5, (0.4, 0.4, 0.4)))
    document = {"scene": write_scene(scene), "moved": ["room_0/sofa_1"], "dragging": True}
    assert fix_scene(document, load_catalogs())["timing_ms"]["work"] >= 1
    taken = take_in_hand({"scene": write_scene(scene), "id": "room_0/sofa_1"}, load_catalogs())
    assert taken["bodies"] == list(pieces(scene))
    assert taken["opening"]
    assert (
        take_in_hand({"scene": write_scene(scene), "id": "room_0/sofa_1", "locked": ["room_0/sofa_1"]}, load_catalogs())["opening"] is None
    )
