"""What a moved piece says of itself afterwards: at which wall its back is, and whether it is still its table's."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest

from solver import Request, fix, generate
from solver.free_places import footprint
from solver.repair.bodies import AT_TABLE_MM
from solver.scene import Furniture
from tests.pipeline.fix_rooms import body, errors, pieces, room_of
from tests.sweeps import seeds


def turned(name: str, x: float, z: float, size: tuple[float, float, float], rotation: int) -> Furniture:
    return replace(body(name, x, z, size), rotation=rotation)


SOFA = (2.0, 0.9, 0.85)
AT = {"north": (2.0, 0.48, 0), "west": (0.48, 2.0, 90), "south": (2.0, 3.52, 180), "east": (3.52, 2.0, 270)}


@pytest.mark.parametrize("wall", AT)
def test_a_piece_whose_back_is_dropped_at_a_wall_says_so(wall: str) -> None:
    x, z, rotation = AT[wall]
    scene = room_of(turned("sofa_1", x, z, SOFA, rotation))
    sofa = pieces(fix(scene, moved=["room_0/sofa_1"]).scene)["room_0/sofa_1"]
    assert (sofa.wall, sofa.x, sofa.z, sofa.rotation) == (wall, x, z, rotation)


@pytest.mark.parametrize(("x", "z", "rotation"), [(2.0, 0.7, 0), (2.0, 2.0, 0), (2.0, 3.5, 0), (0.5, 2.0, 0)])
def test_one_that_stands_free_or_shows_its_front_to_the_wall_says_none(x: float, z: float, rotation: int) -> None:
    scene = room_of(turned("sofa_1", x, z, SOFA, rotation))
    assert pieces(fix(scene, moved=["room_0/sofa_1"]).scene)["room_0/sofa_1"].wall is None


def test_only_kinds_that_stand_at_walls_and_only_moved_ones_say_it() -> None:
    sofa, plant = body("sofa_1", 2.0, 0.48, SOFA), body("plant_1", 0.3, 0.3, (0.4, 0.4, 1.0))
    assert pieces(fix(room_of(sofa, plant), moved=["room_0/plant_1"]).scene)["room_0/plant_1"].wall is None
    assert pieces(fix(room_of(sofa, plant)).scene)["room_0/sofa_1"].wall is None


def test_at_an_inner_wall_of_an_outline_too() -> None:
    outline = ((0.0, 0.0), (6.0, 0.0), (6.0, 5.0), (3.0, 5.0), (3.0, 3.0), (0.0, 3.0))
    for z, wall in ((2.5, "south"), (2.0, None)):
        sofa = turned("sofa_1", 1.5, z, SOFA, 180)
        scene = room_of(sofa, width=6.0, depth=5.0, outline=outline)
        assert pieces(fix(scene, moved=["room_0/sofa_1"]).scene)["room_0/sofa_1"].wall == wall


def test_what_was_dropped_at_a_wall_stays_at_it_when_it_has_to_give_way() -> None:
    dropped = fix(room_of(body("sofa_1", 2.0, 0.48, SOFA)), moved=["room_0/sofa_1"]).scene
    pushed = room_of(*dropped.rooms[0].furniture, body("crate_1", 1.2, 0.9, (0.6, 0.6, 0.6), locked=True))
    after = fix(pushed).scene
    assert errors(after) == []
    sofa = pieces(after)["room_0/sofa_1"]
    assert (sofa.wall, sofa.z) == ("north", pytest.approx(0.48, abs=0.2))


def test_a_chair_taken_from_its_table_is_no_longer_that_tables() -> None:
    table = body("dining_table_1", 1.5, 1.5, (1.6, 0.9, 0.75))
    for z, under in ((2.06, table.id), (2.9, None)):
        chair = replace(turned("dining_chair_1", 1.5, z, (0.46, 0.5, 0.9), 180), under=table.id)
        assert pieces(fix(room_of(table, chair), moved=[chair.id]).scene)[chair.id].under == under


@pytest.mark.parametrize("seed", range(1, 4))
def test_chairs_do_not_stay_behind_where_their_table_goes(seed: int) -> None:
    """A sofa is dropped on the dining table of a living room: chairs that find no place as they stood sit elsewhere at it."""
    home = generate(Request(seed=seed, program="one_bed")).scene
    room = next(one for one in home.rooms if one.type == "living_room")
    sofa, table = (next(piece for piece in room.furniture if piece.name == name) for name in ("sofa", "dining_table"))
    dropped = tuple(replace(piece, x=table.x, z=table.z, wall=None) if piece is sofa else piece for piece in room.furniture)
    rooms = tuple(replace(one, furniture=dropped) if one is room else one for one in home.rooms)
    now = pieces(fix(replace(home, rooms=rooms), moved=[sofa.id], repairs=False).scene)
    chairs = [piece for piece in now.values() if piece.under == table.id]
    assert chairs
    assert all(footprint(chair).overlaps(footprint(now[table.id]).shrunk(-AT_TABLE_MM)) for chair in chairs)


THROWN = 32
"""Times that each dining room is thrown about."""


@pytest.mark.parametrize("seed", seeds([11, 59], 2))
def test_a_dining_room_thrown_about_and_turned_is_put_right(seed: int) -> None:
    scene = generate(Request(seed=seed, program="large", decorate=False)).scene
    room = next(room for room in scene.rooms if sum(piece.name == "dining_chair" for piece in room.furniture) == 6)
    for k in range(THROWN):
        chance = random.Random(k)
        furniture = {piece.id: piece for piece in room.furniture}
        thrown = chance.sample(room.furniture, len(room.furniture) * 2 // 5)
        for piece in thrown:
            x, z = (round(chance.uniform(0.2, side - 0.2), 3) for side in (room.width, room.depth))
            furniture[piece.id] = replace(piece, x=x, z=z, rotation=chance.choice([0, 90, 180, 270]))
        rooms = tuple(replace(one, furniture=tuple(furniture.values())) if one is room else one for one in scene.rooms)
        answer = fix(replace(scene, rooms=rooms), moved=[piece.id for piece in thrown])
        assert (k, [one.message for one in answer.conflicts], errors(answer.scene)) == (k, [], [])
