"""Dragging: with the poses of the last answer fewer neighbours jump; without them nothing changes."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import pairwise

import pytest

from catalogs import load_catalogs
from service.calls import fix_scene
from solver import Request, Scene, fix, generate
from solver.answers import Pose
from solver.errors import FieldError
from solver.exchange import write_scene
from tests.pipeline.fix_rooms import body, errors, pieces, room_of
from tests.sweeps import times

JUMP = 0.3
FRAMES = times(60, 30)
Poses = dict[str, tuple[float, float, float]]


@cache
def living_room(seed: int) -> Scene:
    """A furnished living room of a generated house, alone."""
    house = generate(Request(seed=seed, width=11, depth=9)).scene
    room = next(room for room in house.rooms if room.type == "living_room" and len(room.furniture) >= 4)
    return Scene(rooms=(room,), wall_thickness=house.wall_thickness)


def sofa_at(scene: Scene, share: float) -> tuple[Scene, str]:
    """The room with its sofa on the way to the opposite place of the room, free of its wall."""
    room = scene.rooms[0]
    sofa = next(piece for piece in room.furniture if piece.name == "sofa")
    x = round(sofa.x + share * (room.width - 2 * sofa.x), 3)
    z = round(sofa.z + share * (room.depth - 2 * sofa.z), 3)
    furniture = tuple(replace(piece, x=x, z=z, wall=None) if piece is sofa else piece for piece in room.furniture)
    return replace(scene, rooms=(replace(room, furniture=furniture),)), sofa.id


def poses(scene: Scene) -> Poses:
    return {piece.id: (piece.x, piece.z, piece.rotation) for piece in pieces(scene).values()}


def dragged(scene: Scene, frames: int, hold: bool) -> list[Poses]:
    answers: list[Poses] = []
    for k in range(frames):
        sent, sofa = sofa_at(scene, k / (frames - 1))
        last = tuple(Pose(label, *pose) for label, pose in answers[-1].items()) if hold and answers else ()
        fixed = fix(sent, moved=[sofa], previous=last)
        assert bool(errors(fixed.scene)) == bool(fixed.conflicts)
        answers.append({label: pose for label, pose in poses(fixed.scene).items() if label != sofa})
    return answers


def jumps(answers: list[Poses]) -> int:
    """Frames in which some neighbour goes farther than JUMP."""
    steps = pairwise(answers)
    return sum(any((a[i][0] - b[i][0]) ** 2 + (a[i][1] - b[i][1]) ** 2 > JUMP**2 for i in a) for a, b in steps)


@pytest.mark.usefixtures("geometry_alone")
def test_fewer_neighbours_jump_while_a_sofa_is_dragged() -> None:
    free = [jumps(dragged(living_room(seed), FRAMES, False)) for seed in range(8)]
    held = [jumps(dragged(living_room(seed), FRAMES, True)) for seed in range(8)]
    assert sum(free) > 0
    assert all(h <= f for h, f in zip(held, free, strict=True))
    assert sum(held) < sum(free)


def test_no_more_neighbours_jump_where_ways_are_kept_free() -> None:
    free, held = (jumps(dragged(living_room(1), 2 * FRAMES, hold)) for hold in (False, True))
    assert held <= free


def by_its_doors(scene: Scene) -> Scene:
    """A room alone whose doors lead out of it, as the page asks for it."""
    room = scene.rooms[0]
    openings = tuple(replace(one, connects_to="EXTERIOR") if one.kind != "window" else one for one in room.openings)
    return replace(scene, rooms=(replace(room, openings=openings),))


@pytest.mark.parametrize("seed", range(3))
def test_what_stood_is_always_an_answer(seed: int) -> None:
    scene = by_its_doors(living_room(seed))
    assert errors(scene) == []
    last = tuple(Pose(label, *pose) for label, pose in poses(scene).items())
    for k in range(40):
        sent, sofa = sofa_at(scene, k / 39)
        fixed = fix(sent, moved=[sofa], previous=last)
        assert (fixed.conflicts, errors(fixed.scene)) == ((), [])
        assert fix(fixed.scene, moved=[sofa], previous=last).scene == fixed.scene
        last = tuple(Pose(label, *pose) for label, pose in poses(fixed.scene).items())


def test_neighbours_stay_each_on_its_side_of_the_dragged_piece() -> None:
    long = body("sofa_1", 2.0, 2.0, (2.6, 1.0, 0.8))
    near = (body("box_1", 1.2, 1.95, (0.5, 0.5, 0.4)), body("box_2", 2.8, 1.95, (0.5, 0.5, 0.4)))
    last = [Pose("room_0/box_1", 1.2, 2.75, 0), Pose("room_0/box_2", 2.8, 1.25, 0)]
    free = pieces(fix(room_of(long, *near), moved=["room_0/sofa_1"]).scene)
    held = pieces(fix(room_of(long, *near), moved=["room_0/sofa_1"], previous=last).scene)
    assert free["room_0/box_1"].z < 1.5
    assert held["room_0/box_1"].z == pytest.approx(2.75, abs=0.2)
    assert held["room_0/box_2"].z == pytest.approx(1.25, abs=0.2)


def between() -> Scene:
    """A box in the middle of a narrow way: it gives way north or south, alike but for a centimetre."""
    return room_of(body("sofa_1", 2.0, 2.0, (1.0, 1.0, 0.8)), body("box_1", 2.0, 1.995, (0.4, 0.4, 0.4)), width=4.0)


def test_a_piece_stays_on_its_side_unless_the_other_is_clearly_better() -> None:
    north = fix(between(), moved=["room_0/sofa_1"])
    assert pieces(north.scene)["room_0/box_1"].z < 1.9
    last = Pose("room_0/box_1", 2.0, 2.7, 0)
    south = fix(between(), moved=["room_0/sofa_1"], previous=[last])
    assert pieces(south.scene)["room_0/box_1"].z > 2.1
    assert errors(south.scene) == []
    nearer = replace(between().rooms[0], furniture=tuple(replace(p, z=1.9) if "box" in p.id else p for p in between().rooms[0].furniture))
    clearly = fix(replace(between(), rooms=(nearer,)), moved=["room_0/sofa_1"], previous=[last])
    assert pieces(clearly.scene)["room_0/box_1"].z < 1.9


def test_chairs_stay_at_a_table_that_stays_on_its_side() -> None:
    """A table in the middle of a room gives way to the north or south, alike but for centimetres: last it stood in the south."""
    table, sofa = body("dining_table_1", 2.0, 2.99, (1.6, 0.9, 0.75)), body("sofa_1", 2.0, 3.0, (2.2, 0.9, 0.8))
    beside = ((-0.4, -0.55, 0), (0.4, -0.55, 0), (-0.4, 0.55, 180), (0.4, 0.55, 180))
    chairs = [body(f"dining_chair_{k}", 2.0 + dx, 2.99 + dz, (0.46, 0.5, 0.9), under=table.id) for k, (dx, dz, _) in enumerate(beside)]
    chairs = [replace(chair, rotation=rotation) for chair, (_, _, rotation) in zip(chairs, beside, strict=True)]
    scene = room_of(sofa, table, *chairs, depth=6.0)
    assert pieces(fix(scene, moved=[sofa.id]).scene)[table.id].z < 2.5
    last = [Pose(piece.id, piece.x, round(piece.z + 1.5, 3), piece.rotation) for piece in (table, *chairs)]
    held = fix(scene, moved=[sofa.id], previous=last)
    now = pieces(held.scene)
    assert errors(held.scene) == []
    assert now[table.id].z == pytest.approx(4.49, abs=0.2)
    for chair, (dx, dz, rotation) in zip(chairs, beside, strict=True):
        own, at = now[chair.id], now[table.id]
        assert (own.x - at.x, own.z - at.z, own.rotation) == (pytest.approx(dx, abs=2e-3), pytest.approx(dz, abs=2e-3), rotation)


def test_poses_of_what_is_gone_are_passed_over() -> None:
    scene = between()
    assert fix(scene, previous=[Pose("room_0/ghost", 1.0, 1.0, 0)]).scene == fix(scene).scene


def test_a_clean_scene_stays_clean_whatever_was_before() -> None:
    scene = living_room(0)
    assert fix(scene, previous=[Pose(label, 1.0, 1.0, 0) for label in pieces(scene)]).scene == scene


def test_the_call_takes_previous_and_names_what_is_wrong_in_it() -> None:
    sent = {"scene": write_scene(between()), "moved": ["room_0/sofa_1"], "previous": [{"id": "room_0/box_1", "x": 2.0, "z": 2.7}]}
    answer = fix_scene(sent, load_catalogs())
    box = next(piece for piece in answer["scene"]["rooms"][0]["furniture"] if piece["id"] == "room_0/box_1")
    assert box["z"] > 2.1
    for pose, field in (({"id": "a", "x": 1.0}, r"previous\[0\]\.z"), ({"x": 1.0, "z": 1.0}, r"previous\[0\]\.id")):
        with pytest.raises(FieldError, match=field):
            fix_scene({**sent, "previous": [pose]}, load_catalogs())
