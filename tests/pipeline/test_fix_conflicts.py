"""Conflicts and repairs of fix() over seeded rooms, judged by a mixed-integer programme and the validator."""

from __future__ import annotations

import re
from collections.abc import Container
from dataclasses import replace
from functools import cache, reduce
from importlib import import_module

import pytest

from solver import Scene, fix
from solver.answers import Conflict, Fixed
from solver.scene import Opening, Room
from tests.pipeline.fix_oracle import can_stand
from tests.pipeline.fix_rooms import body, errors, fuzzed, pieces, room_of, untrue_repairs, with_repair
from tests.sweeps import seeds

pytestmark = pytest.mark.usefixtures("geometry_alone")
ALL_SEEDS = range(60)
SEEDS = seeds(ALL_SEEDS, 5)
NOT_FOUND = "not found: "


def room(seed: int) -> Scene:
    return fuzzed(seed, 3 + seed % 3, locks=seed % 2 == 1)


@cache
def repaired(seed: int) -> Fixed:
    return fix(room(seed))


def is_minimal(here: Room, conflict: Conflict) -> bool:
    """Its members alone are infeasible, and without any one of them the rest of it is feasible."""
    members = [piece for piece in here.furniture if piece.id in conflict.ids]
    rests = [[other for other in members if other is not piece] for piece in members]
    return bool(members) and not can_stand(here, members) and all(can_stand(here, rest) for rest in rests)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_verdict_is_the_oracles_and_every_conflict_minimal(seed: int) -> None:
    scene, fixed = room(seed), repaired(seed)
    here = scene.rooms[0]
    assert (errors(fixed.scene) == []) == can_stand(here, here.furniture)
    assert [conflict.message for conflict in fixed.conflicts if conflict.message.startswith(NOT_FOUND)] == []
    assert [conflict for conflict in fixed.conflicts if not is_minimal(here, conflict)] == []


def test_all_rooms_of_the_sweep_are_of_all_kinds() -> None:
    answers = [repaired(seed) for seed in ALL_SEEDS]
    assert {len(conflict.ids) for answer in answers for conflict in answer.conflicts} >= {1, 2, 3}
    assert any(not answer.conflicts for answer in answers)
    actions = {repair["action"] for answer in answers for conflict in answer.conflicts for repair in conflict.repairs}
    assert actions == {"move", "unlock", "turn", "shrink", "leave_out"}


def test_what_could_stand_if_it_were_turned_is_said_not_to_as_it_is() -> None:
    turnable = 0
    for seed in ALL_SEEDS:
        here = room(seed).rooms[0]
        for conflict in repaired(seed).conflicts:
            members = [piece for piece in here.furniture if piece.id in conflict.ids and not piece.locked]
            turned = [replace(piece, rotation=(piece.rotation + 90) % 360, wall=None) for piece in members]
            if len(conflict.ids) == 1 and turned and can_stand(here, turned):
                turnable += 1
                assert "as turned now" in conflict.message
    assert turnable >= 3


@pytest.mark.parametrize("seed", SEEDS)
def test_every_repair_leaves_the_room_clean_with_the_first_of_each_other_conflict(seed: int) -> None:
    scene, fixed = room(seed), repaired(seed)
    assert all(1 <= len(conflict.repairs) <= 6 for conflict in fixed.conflicts)
    assert untrue_repairs(scene, fixed) == []


def test_without_repairs_the_same_scene_and_conflicts_are_answered() -> None:
    offered = 0
    for seed in range(0, 24, 2):
        whole, bare = repaired(seed), fix(room(seed), repairs=False)
        offered += sum(bool(conflict.repairs) for conflict in whole.conflicts)
        assert bare.scene == whole.scene
        assert [conflict.ids for conflict in bare.conflicts] == [conflict.ids for conflict in whole.conflicts]
        assert not any(conflict.repairs for conflict in bare.conflicts)
    assert offered > 3


@pytest.mark.parametrize("seed", SEEDS)
def test_an_answer_is_repaired_to_itself_and_the_locked_stay(seed: int) -> None:
    scene, fixed = room(seed), repaired(seed)
    again = fix(fixed.scene)
    assert again.scene == fixed.scene
    assert again.moves == ()
    after = pieces(fixed.scene)
    assert after.keys() == pieces(scene).keys()
    assert [piece for piece in scene.rooms[0].furniture if piece.locked and after[piece.id] != piece] == []


@pytest.mark.parametrize("seed", SEEDS)
def test_with_remove_the_rest_is_clean_and_everything_gone_is_named(seed: int) -> None:
    scene = room(seed)
    fixed = fix(scene, on_conflict="remove")
    assert errors(fixed.scene) == []
    gone = pieces(scene).keys() - pieces(fixed.scene).keys()
    assert {removal["id"] for removal in fixed.removed} == gone
    assert all(removal["reason"] for removal in fixed.removed)
    assert bool(gone) == bool(errors(repaired(seed).scene))


SHORT = re.compile(r"([\d.]+) m (?:that are clear |are clear )?(?:from (\w+) to|along the (\w+) wall).*?([\d.]+) cm (?:too long|short)")


def grown(here: Room, wall: str, by: float) -> Room:
    if wall in ("west", "north wall", "south wall"):
        return replace(here, width=round(here.width + by, 4))
    return replace(here, depth=round(here.depth + by, 4))


@pytest.mark.parametrize("seed", seeds(range(0, 80, 2), 5))
def test_the_missing_centimetres_are_the_least_that_help(seed: int) -> None:
    scene = room(seed)
    here = scene.rooms[0]
    for conflict in fix(scene).conflicts:
        found = SHORT.search(conflict.message)
        assert found, conflict.message
        clear, start, wall, missing = found.groups()
        along = start or f"{wall} wall"
        members = [piece for piece in here.furniture if piece.id in conflict.ids]
        by = float(missing) / 100
        assert can_stand(grown(here, along, by), members)
        for axis in ("west", "north"):
            assert not can_stand(grown(here, axis, by - 0.001), members), conflict.message
        assert float(clear) in (here.width, here.depth)


@pytest.mark.parametrize("seed", seeds(range(0, 80, 2), 5))
def test_the_chain_of_lengths_adds_up(seed: int) -> None:
    for conflict in fix(room(seed)).conflicts:
        if " = " not in conflict.message:
            assert re.search(r"is [\d.]+ m long", conflict.message) or "m that are clear" in conflict.message
            continue
        terms, rest = conflict.message.split(": ", 1)[1].split(" = ")
        total, clear, missing = (float(number) for number in re.match(r"([\d.]+) > ([\d.]+) m .*: ([\d.]+) cm short", rest).groups())  # type: ignore[union-attr]
        assert sum(float(term.rsplit(" ", 1)[1]) for term in terms.split(" + ")) == pytest.approx(total, abs=1e-9)
        assert total - clear == pytest.approx(missing / 100, abs=1e-9)


def test_a_chain_names_its_pieces_and_the_centimetres() -> None:
    scene = room_of(body("bed_1", 0.8, 1.0, (1.6, 2.0, 0.9)), body("wardrobe_1", 1.5, 1.0, (0.6, 1.9, 2.0)), width=2.1, depth=2.1)
    (conflict,) = fix(scene).conflicts
    assert conflict.message.endswith("bed 1.60 + wardrobe 0.60 = 2.20 > 2.10 m from west to east: 10 cm short")
    shrunk = {repair["id"]: repair["width"] for repair in conflict.repairs if repair["action"] == "shrink"}
    assert shrunk == {"room_0/bed_1": 1.5, "room_0/wardrobe_1": 0.5}


def test_a_piece_longer_than_the_room_says_by_how_much() -> None:
    (conflict,) = fix(room_of(body("wardrobe_1", 1.0, 1.0, (2.5, 0.6, 2.0)), width=2.1, depth=2.0)).conflicts
    assert conflict.message.endswith("wardrobe is 2.50 m long, 2.10 m are clear from west to east: 40 cm too long")
    assert [repair["action"] for repair in conflict.repairs] == ["shrink", "leave_out"]


def test_a_chain_begins_at_the_floor_before_a_door() -> None:
    door = Opening("door_1", "door", "west", 0.5, 0.9, connects_to="EXTERIOR", main_entrance=True)
    scene = room_of(body("sofa_1", 1.8, 0.5, (1.4, 0.9, 0.8)), openings=(door,), width=2.2, depth=1.0)
    (conflict,) = fix(scene).conflicts
    assert "to the far side of the floor before door_1 0.90 + sofa 1.40 = 2.30 > 2.20 m" in conflict.message


def test_a_locked_piece_in_the_way_is_offered_to_be_unlocked_with_its_move() -> None:
    still = body("chest_1", 1.0, 1.0, (0.8, 0.8, 0.8), locked=True)
    scene = room_of(still, body("bed_1", 1.0, 1.0, (1.6, 1.1, 0.5)), width=2.0, depth=2.0)
    (conflict,) = fix(scene).conflicts
    unlock = next(repair for repair in conflict.repairs if repair["action"] == "unlock")
    again = fix(with_repair(scene, unlock))
    (move,) = [move for move in again.moves if move.id == still.id]
    assert (move.dx, move.dz, move.rotation) == (unlock["dx"], unlock["dz"], unlock["rotation"])


def test_a_locked_chair_that_holds_its_desk_is_unlocked_with_its_own_move() -> None:
    desk = body("desk", 2.0, -0.1, (1.4, 0.7, 0.75))
    chair = replace(body("office_chair", 2.0, 0.5, (0.6, 0.6, 0.9), under=desk.id, locked=True), rotation=180)
    scene = room_of(desk, chair)
    (conflict,) = fix(scene).conflicts
    unlock = next(repair for repair in conflict.repairs if repair["action"] == "unlock")
    (move,) = [move for move in fix(with_repair(scene, unlock)).moves if move.id == chair.id]
    assert unlock == {"action": "unlock", "id": chair.id, "dx": move.dx, "dz": move.dz, "rotation": move.rotation}


def needless(scene: Scene) -> list[str]:
    """What is said of a limit though all else that is said, ended by its first repair, ends it too."""
    told = [conflict for conflict in fix(scene).conflicts if conflict.repairs]
    found = []
    for conflict in told:
        firsts = [other.repairs[0] for other in told if other is not conflict]
        if firsts and "ended at its limit" in conflict.message and not errors(fix(reduce(with_repair, firsts, scene)).scene):
            found.append(conflict.message)
    return found


@pytest.mark.parametrize("seed", [3038, *seeds(range(3030, 3045), 9)])
def test_a_search_that_only_other_conflicts_bring_to_its_limit_is_no_conflict_of_its_own(seed: int) -> None:
    assert needless(fuzzed(seed, 7, locks=True)) == []


def test_what_only_the_request_locks_is_unlocked_by_leaving_it_out_of_locked() -> None:
    still = body("chest_1", 1.0, 1.0, (0.8, 0.8, 0.8))
    scene = room_of(still, body("bed_1", 1.0, 1.0, (1.6, 1.1, 0.5)), width=2.0, depth=2.0)
    (conflict,) = fix(scene, locked=[still.id]).conflicts
    assert {"unlock", "leave_out"} <= {repair["action"] for repair in conflict.repairs}
    assert fix(scene).conflicts == ()


def test_a_piece_locked_outside_the_room_is_named_and_the_others_are_repaired() -> None:
    still = body("chest_1", 3.8, 2.0, (0.8, 0.8, 0.8), locked=True)
    fixed = fix(room_of(still, body("a_1", 1.5, 2.0, (1.0, 1.0, 1.0)), body("b_1", 2.3, 2.0, (1.0, 1.0, 1.0))))
    (conflict,) = fixed.conflicts
    assert conflict.ids == (still.id,)
    assert "locked where it cannot stand" in conflict.message
    assert [issue.rule for issue in fixed.issues if issue.severity == "error"] == ["out_of_bounds"]
    assert pieces(fixed.scene)[still.id] == still


@pytest.mark.parametrize("locked", [True, False])
def test_only_of_a_piece_that_may_move_it_is_said_that_it_cannot_stand_anywhere(locked: bool) -> None:
    """A bed before the door: where it is locked, half a metre aside it could stand; where it is not, the room is too small for it."""
    door = Opening("door", wall="south", position=1.0, width=0.9, connects_to="EXTERIOR")
    bed = body("bed_1", 1.0, 1.5, (1.6, 2.0, 0.5), locked=locked)
    (conflict,) = fix(room_of(bed, openings=(door,), width=3.0 if locked else 2.0, depth=2.6)).conflicts
    assert f"bed 1.60 x 2.00 m cannot stand{'' if locked else ' anywhere'} in room_0" in conflict.message
    assert conflict.message.endswith("it stays as sent, 80 cm in the floor before door") == locked


def test_what_a_removed_piece_carries_is_named_too() -> None:
    table = body("table_1", 1.0, 1.0, (2.5, 1.0, 0.7))
    lamp = replace(body("lamp_1", 1.0, 1.0, (0.2, 0.2, 0.4)), y=0.7, on=table.id)
    fixed = fix(room_of(table, lamp, width=2.0, depth=2.0), on_conflict="remove")
    assert {removal["id"] for removal in fixed.removed} == {table.id, lamp.id}


@pytest.mark.parametrize("seed", seeds(range(30), 5))
def test_when_a_limit_was_hit_nothing_possible_is_called_impossible(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(import_module("solver.pipeline.fix"), "SCENE_WORK", 3.0 * seed)
    scene = fuzzed(seed, 5)
    for conflict in fix(scene).conflicts:
        members = [piece for piece in scene.rooms[0].furniture if piece.id in conflict.ids]
        assert conflict.message.startswith(NOT_FOUND) or not can_stand(scene.rooms[0], members)


def test_a_limit_that_is_hit_says_not_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(import_module("solver.pipeline.fix"), "SCENE_WORK", 1.0)
    messages = [conflict.message for seed in range(20) for conflict in fix(fuzzed(seed, 5)).conflicts]
    assert any(message.startswith(NOT_FOUND) for message in messages)


@pytest.mark.parametrize("does_help", [True, False])
def test_rooms_without_the_others_are_built_one_by_one(does_help: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """The first of many that cannot stand tells whether to leave all out helps: of it the room as sent and answered, or answered alone."""
    flow, rooms = import_module("solver.pipeline.conflicts"), list[Room]()
    without = flow.without
    monkeypatch.setattr(flow, "helps", lambda *_: does_help)

    def build(room: Room, gone: Container[str]) -> Room:
        rooms.append(without(room, gone))
        return rooms[-1]

    monkeypatch.setattr(flow, "without", build)
    fixed = fix(room_of(*(body(f"armchair_{k}", 0.1 * k, 0.0, (0.5, 0.5, 0.9)) for k in range(14)), width=2.0, depth=1.0))
    assert len(fixed.conflicts) > 5
    assert len(rooms) >= len(fixed.conflicts) if does_help else len(rooms) <= 3
    assert all(bool(conflict.repairs) == does_help for conflict in fixed.conflicts)
