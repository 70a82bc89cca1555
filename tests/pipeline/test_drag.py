"""Frames of a drag: every answer is valid, neighbours go little by little, the work is bounded by a count."""

from __future__ import annotations

import statistics
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache
from math import ceil, dist, nan

import pytest

from catalogs import load_catalogs
from solver import Scene, validate
from solver.core import CoreFailed
from solver.furnish import space_of
from solver.furnish.zones import bounds_of
from solver.geometry import Rect
from solver.pieces import Arrangement, Placed, Space
from solver.pipeline.drag import DRAWN, NO_ANSWER, PLACED, STAYED, Dragging, opening_of
from solver.repair import InHand, RepairSettings, RoomProblem, Walls, in_hand
from solver.repair.in_hand import HELD_REACH_MM
from solver.scene import WALLS, robot_width_of
from solver.scene_bodies import bodies_of
from tests.oracles.rules import faults, unreached
from tests.pipeline.drags import STEP_M, Step, dense_rooms, dragged, jump, neighbours, scene_at, spots_of
from tests.pipeline.fix_rooms import body, room_of
from tests.sweeps import seeds, times

FRAMES = 60
USUAL_WORK, MOST_WORK = 20, 530
"""QPs and walks that half of all frames take at most, and any: the core stops after 400 QPs and 120 walks, between two nodes."""
JUMP_M = 0.2
WALL_M = 0.1
"""What is wished this far from the walls may stand there by them."""
RULES_EVERY = times(1, 12)
"""Every so many frames the service's own validator reads the whole answer; the oracle reads each."""
SEEDS = seeds(range(1, 13), 6)


@cache
def drags(seed: int) -> tuple[tuple[Scene, str, list[Step]], ...]:
    """Every piece of the dense rooms of a home, dragged."""
    found = []
    for scene in dense_rooms(seed):
        for piece in scene.rooms[0].furniture:
            steps = dragged(scene, piece.id, FRAMES)
            found += [(scene, piece.id, steps)] if steps else []
    return tuple(found)


def asked(scene: Scene, label: str) -> tuple[Space, InHand]:
    room = scene.rooms[0]
    room = replace(room, furniture=tuple(replace(one, wall=None) if one.id == label else one for one in room.furniture))
    space, lines = space_of(room, scene.wall_thickness, robot_width_of(scene)), bounds_of(room)
    walls = Walls(space.clear, space.clear.x0 - lines.x0, tuple((wall, lines.line(wall), *lines.along(wall)) for wall in WALLS))
    settings = RepairSettings(load_catalogs(), moved=frozenset({label}))
    hand = in_hand(RoomProblem(room, space, walls, settings), label, scene.dynamic)
    assert hand is not None
    return space, hand


def arrangement_of(scene: Scene, hand: InHand, step: Step) -> Arrangement:
    """The answer as the oracle reads arrangements, on whole millimetres."""
    numbers = {one.id: number for number, one in enumerate(bodies_of(scene))}
    turns: dict[str, int] = {}
    placed = []
    for piece in hand.pieces:
        for way in piece.candidates[:1]:
            turn = (way.rotation + (turns[way.attach.parent] if way.attach else 0)) % 360
            wide, deep = way.size_mm[:2] if turn % 180 == 0 else way.size_mm[1::-1]
            x, z = (1000 * step.answer.spots[2 * numbers[piece.label] + axis] for axis in (0, 1))
            west, north = round(x - wide / 2), round(z - deep / 2)
            turns[piece.label] = turn
            placed.append(Placed(piece.label, way, turn, way.wall, Rect(west, north, west + wide, north + deep)))
    return Arrangement(scene.rooms[0].id, tuple(placed), (), 0.0, True, 0)


def before_window(scene: Scene) -> tuple[str, ...]:
    """What the oracle says of people before windows, who may stand there: they keep no light off for good."""
    windows = [one.id for one in scene.rooms[0].openings if one.kind == "window"]
    return tuple(f"{one.id} stands in the zone of {window}" for one in scene.dynamic for window in windows)


def answers(seed: int) -> Iterator[tuple[Scene, str, Step]]:
    for scene, label, steps in drags(seed):
        for step in steps:
            yield scene, label, step


@pytest.mark.parametrize("seed", SEEDS)
def test_every_answer_is_valid_by_the_oracle(seed: int) -> None:
    frames = 0
    for scene, label, steps in drags(seed):
        space, hand = asked(scene, label)
        pieces = [piece for piece in hand.pieces if len(piece.candidates) == 1]
        assert pieces == list(hand.pieces)
        for step in steps:
            found = arrangement_of(scene, hand, step)
            wrong = [fault for fault in faults(space, pieces, found) if fault not in before_window(scene)]
            assert wrong == []
            assert unreached(space, pieces, found) == []
            frames += 1
    assert frames > 5 * FRAMES


@pytest.mark.parametrize("seed", SEEDS)
def test_every_answer_breaks_no_rule(seed: int) -> None:
    for scene, label, steps in drags(seed):
        for step in steps[::RULES_EVERY]:
            issues = validate(scene_at(scene, step.answer.spots, label), load_catalogs())
            assert [issue.message for issue in issues if issue.severity == "error"] == []


@pytest.mark.parametrize("seed", SEEDS)
def test_neighbours_never_jump(seed: int) -> None:
    assert max(jump(step, neighbours(scene, label)) for scene, label, step in answers(seed)) < JUMP_M


@pytest.mark.parametrize("seed", SEEDS)
def test_what_is_in_hand_does_not_jump_away_from_where_it_is_wished(seed: int) -> None:
    for scene, label, step in answers(seed):
        number, held = next((number, one) for number, one in enumerate(bodies_of(scene)) if one.id == label)
        most, room = max(held.width, held.depth) / 2 + WALL_M, scene.rooms[0]
        if most < step.wish[0] < room.width - most and most < step.wish[1] < room.depth - most:
            assert _off(step.answer.spots, number, step.wish) < _off(step.before, number, step.wish) + HELD_REACH_MM / 1000 + 0.002


def _off(spots: Sequence[float], number: int, wish: tuple[float, float]) -> float:
    """How far a body is from where it is wished, along the axis on which it is farther, m."""
    return max(abs(spots[2 * number + axis] - wish[axis]) for axis in (0, 1))


def test_what_stood_wrongly_when_the_drag_began_is_placed() -> None:
    """The piece in hand is wished where it is, within what is locked: the nearest place is farther than it may go otherwise."""
    scene = room_of(body("bed_1", 2.0, 2.0, (2.4, 2.4, 0.5)), body("box_1", 2.0, 2.0, (0.8, 0.8, 0.4)), width=4.0, depth=5.0)
    opening = opening_of(scene, "room_0/box_1", ("room_0/bed_1",), load_catalogs())
    assert opening is not None
    assert Dragging(opening).frame(2.0, 2.0, spots_of(scene)).outcome == PLACED


@pytest.mark.parametrize("seed", SEEDS)
def test_the_work_is_bounded_by_a_count(seed: int) -> None:
    work = [step.answer.work for _, _, step in answers(seed)]
    assert 1 < statistics.median(work) <= USUAL_WORK
    assert max(work) <= MOST_WORK


@pytest.mark.parametrize("seed", SEEDS)
def test_nearly_every_frame_moves_something_and_most_are_answered_by_the_search(seed: int) -> None:
    outcomes = [step.answer.outcome for _, _, step in answers(seed)]
    assert outcomes.count(NO_ANSWER) == 0
    assert outcomes.count(PLACED) > 0.6 * len(outcomes)
    assert outcomes.count(STAYED) < 0.1 * len(outcomes)
    assert outcomes.count(PLACED) + outcomes.count(STAYED) + outcomes.count(DRAWN) == len(outcomes)


def test_the_same_frame_is_answered_alike_whatever_was_asked_before() -> None:
    scene = dense_rooms(1)[0]
    label = next(piece.id for piece in scene.rooms[0].furniture if dragged(scene, piece.id, 1))
    opening = opening_of(scene, label, (), load_catalogs())
    assert opening is not None
    steps = dragged(scene, label, 20)
    for step in reversed(steps):
        assert Dragging(opening).frame(*step.wish, step.before) == step.answer


def test_where_it_was_is_wished_for_nothing_moves() -> None:
    scene = dense_rooms(1)[0]
    for piece in scene.rooms[0].furniture:
        if opening := opening_of(scene, piece.id, (), load_catalogs()):
            answer = Dragging(opening).frame(piece.x, piece.z, spots_of(scene))
            assert answer.spots == pytest.approx(spots_of(scene), abs=0.0011), "by more than the millimetre that rounding may shift"


def test_neighbours_are_pushed_and_come_back() -> None:
    scene = room_of(body("sofa_1", 2.0, 1.0, (2.0, 0.9, 0.8)), body("box_1", 2.0, 2.4, (0.5, 0.5, 0.4)), width=4.0, depth=5.0)
    opening = opening_of(scene, "room_0/sofa_1", (), load_catalogs())
    assert opening is not None
    drag, spots = Dragging(opening), spots_of(scene)
    for k in range(10):
        spots = drag.frame(2.0, 1.0 + 0.1 * k, spots).spots
    assert spots[3] > 2.5
    for _ in range(6):
        spots = drag.frame(2.0, 1.0, spots).spots
    assert spots == spots_of(scene)


def test_what_is_in_hand_backs_off_to_let_others_give_way() -> None:
    """A counter drawn up to its neighbours gets past them by going back a little first: 0.4 m from where it is wished, else 0.74 m."""
    scene = next(scene for scene in dense_rooms(2) if scene.rooms[0].type == "kitchen")
    number, held = next((number, one) for number, one in enumerate(scene.rooms[0].furniture) if one.id.endswith("/counter_2"))
    opening = opening_of(scene, held.id, (), load_catalogs())
    assert opening is not None
    drag, spots, wish = Dragging(opening), spots_of(scene), (0.25 * scene.rooms[0].width, 0.75 * scene.rooms[0].depth)
    frames = ceil(dist(wish, (held.x, held.z)) / STEP_M)
    for share in (min(1.0, k / frames) for k in range(1, frames + 13)):
        spots = drag.frame(held.x + share * (wish[0] - held.x), held.z + share * (wish[1] - held.z), spots).spots
    assert _off(spots, number, wish) < 0.5


def test_where_no_place_is_known_there_is_no_answer() -> None:
    scene = room_of(*(body(f"box_{k}", 1.0, 1.0, (1.5, 1.5, 0.4)) for k in range(3)), width=2.0, depth=2.0)
    opening = opening_of(scene, "room_0/box_0", (), load_catalogs())
    assert opening is not None
    answer = Dragging(opening).frame(1.0, 1.0, [nan] * 6)
    assert answer.outcome == NO_ANSWER


def test_what_is_locked_flat_or_stands_on_another_is_not_dragged_by_itself() -> None:
    scene = next(scene for scene in dense_rooms(1) if any(piece.on for piece in scene.rooms[0].furniture))
    on, free = (next(piece for piece in scene.rooms[0].furniture if bool(piece.on) is stands) for stands in (True, False))
    assert opening_of(scene, on.id, (), load_catalogs()) is None
    assert opening_of(scene, free.id, (free.id,), load_catalogs()) is None
    assert opening_of(scene, free.id, (), load_catalogs()) is not None


def test_bytes_that_are_no_drag_end_in_an_error_and_the_next_is_answered() -> None:
    scene = dense_rooms(1)[0]
    label = next(piece.id for piece in scene.rooms[0].furniture if dragged(scene, piece.id, 1))
    opening = opening_of(scene, label, (), load_catalogs())
    assert opening is not None
    for broken in (opening[:64], opening[: len(opening) // 2], b"\x07" + opening[1:], opening[:-24]):
        with pytest.raises(CoreFailed):
            Dragging(broken)
    assert dragged(scene, label, 1)[0].answer.outcome == PLACED
