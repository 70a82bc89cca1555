"""Furniture and decorations that are made when they are asked for: what asks for rows and what asks for bodies say the same."""

from __future__ import annotations

import copy
import pickle
from dataclasses import replace
from math import inf
from typing import Any

import pytest

from catalogs import load_catalogs
from service.dataset.shards import SCHEMAS
from solver import generate
from solver.body_rows import (
    BODY,
    DecorationRows,
    FurnitureRows,
    count_decorations,
    count_furniture,
    furniture_ids,
    furniture_names,
    rows_in,
)
from solver.certificate import mark_of
from solver.exchange import dump_scene, dump_text, write_scene
from solver.exports.table_rows import rows_of
from solver.free_floor import FreeFloor
from solver.free_places import Block, block_of, decoration_blocks, decorations_as_told, furniture_as_told
from solver.pipeline.room_spaces import spaces_in
from solver.request import Request
from solver.scene import Decoration, Dynamic, Furniture, Level, Room, Scene
from solver.scene_bodies import counted
from solver.streams import Stream
from solver.validator import check, metrics
from solver.validator.kinds import kinds_of
from solver.validator.sent_rooms import NumberedKinds, room_bytes
from solver.validator.world import world_of
from tests.validator.travels import front_travels

KNOWN = load_catalogs()
REQUESTS = (
    Request(seed=31, program="family", decorate=True),
    Request(seed=32, program="studio", decorate=True, style="modern"),
    Request(seed=33, decorate=True, width=9, depth=8),
    Request(seed=34, area=80, decorate=True, outline="L", people=False),
)


def untold(scene: Scene) -> Scene:
    """The same with its bodies one by one."""
    return replace(scene, rooms=tuple(Room(**{name: getattr(room, name) for name in Room.__dataclass_fields__}) for room in scene.rooms))


@pytest.fixture(scope="module", params=REQUESTS, ids=lambda request: str(request.seed))
def homes(request: pytest.FixtureRequest) -> tuple[Scene, Scene]:
    """A home as it is made, its bodies told as rows, and the same with each body made."""
    return generate(request.param, catalogs=KNOWN).scene, untold(generate(request.param, catalogs=KNOWN).scene)


def test_rows_are_kept_and_nothing_is_made_before_it_is_asked_for(homes: tuple[Scene, Scene]) -> None:
    told, made = homes
    for sort in (FurnitureRows, DecorationRows):
        assert all(rows_in(room, sort) is not None for room in told.rooms)
        assert all(rows_in(room, sort) is None for room in made.rooms)
    nobody_asked = (told.request or {}).get("people") is False  # who places people looks at the furniture about them
    assert not nobody_asked or not any({"furniture", "decorations"} & room.__dict__.keys() for room in told.rooms)
    assert [count_furniture(room) for room in told.rooms] == [len(room.furniture) for room in made.rooms]
    assert [count_decorations(room) for room in told.rooms] == [len(room.decorations) for room in made.rooms]
    assert counted(told.rooms, told.dynamic) == counted(made.rooms, made.dynamic)
    assert sum(map(count_decorations, told.rooms)) > 20
    for room, other in zip(told.rooms, made.rooms, strict=True):
        assert (furniture_ids(room), furniture_names(room)) == (furniture_ids(other), furniture_names(other))
        for rows in (furniture_as_told, decorations_as_told):
            assert [row[8:] for row in BODY.iter_unpack(rows(room))] == [row[8:] for row in BODY.iter_unpack(rows(other))]
        assert decoration_blocks(room) == decoration_blocks(other)
        assert mark_of(room) == mark_of(other)


def test_the_floor_that_is_left_is_alike(homes: tuple[Scene, Scene]) -> None:
    told, made = homes
    space, uses, verdicts = spaces_in(made), KNOWN.use_sides(), set[bool]()
    for k, (room, other) in enumerate(zip(told.rooms, made.rooms, strict=True)):
        floor, same = (FreeFloor.of_room(one, space(one), uses) for one in (room, other))
        stream = Stream(k, "floor", room.id)
        for _ in range(20):
            x, z, low = (stream.uniform(0.0, most) for most in (room.width, room.depth, 2.4))
            own = block_of(Dynamic("somebody", "person", x=x, y=low, z=z, width=0.5, depth=0.4, height=0.3))
            assert floor.nearest(own, 60) == same.nearest(own, 60)
            assert sorted(floor.obstacles(own)) == sorted(same.obstacles(own))
            assert floor.connects([own.rect]) == same.connects([own.rect])
            of = block_of(stream.pick(other.furniture)) if other.furniture else own
            bodies: list[Furniture | Decoration] = [*other.furniture, *other.decorations]
            there = [block_of(one) for one in bodies if one.height > 0.02 and one.id != of.id]
            there += [Block(zone.rect, -inf, inf) for zone in space(other).zones if zone.above_mm < 0]
            is_free = not any(one.rect.overlaps(own.rect) and one.between(own.low, own.high) for one in there)
            assert floor.is_free(own, of) == same.is_free(own, of) == is_free
            verdicts.add(is_free)
    assert verdicts == {True, False}


def test_a_home_is_written_alike(homes: tuple[Scene, Scene]) -> None:
    told, made = homes
    text = dump_scene(told, "json")
    assert text == dump_scene(made, "json") == dump_text(write_scene(made), "json")
    assert told == made
    assert dump_scene(told, "json") == text
    assert dump_scene(told, "yaml") == dump_text(write_scene(made), "yaml")


def test_a_home_is_judged_alike(homes: tuple[Scene, Scene]) -> None:
    told, made = homes
    assert check(told, KNOWN).issues == check(made, KNOWN).issues
    assert metrics(told, KNOWN) == metrics(made, KNOWN)
    assert front_travels(told, KNOWN) == front_travels(made, KNOWN)
    world, kinds = world_of(told), NumberedKinds(kinds_of(KNOWN))
    things = [room_bytes(world, place, kinds) for place in world.places]
    assert things != [room_bytes(world_of(made), place, kinds) for place in world_of(made).places]


def test_a_home_s_tables_are_alike(homes: tuple[Scene, Scene]) -> None:
    """Also where rooms do not begin at half millimetres, and floors lie elsewhere."""
    levels = (Level(elevation=0.1 + 0.2),)
    for askew in (0.0, 0.0001, 1 / 3):
        moved = [
            replace(home, levels=levels, rooms=tuple(copied(room, x=room.x + askew, z=room.z - askew) for room in home.rooms))
            for home in homes
        ]
        told, made = moved
        assert any(rows_in(room, DecorationRows) for room in told.rooms)
        assert rows_of(told, KNOWN) == rows_of(made, KNOWN)
    assert {name: {len(row) for row in rows} for name, rows in rows_of(told, KNOWN).items()} == {
        name: {len(SCHEMAS[name])} for name in SCHEMAS if name != "houses"
    }


def copied(room: Room, **changes: Any) -> Room:
    """A room that is told as it was, elsewhere."""
    other = copy.copy(room)
    other.__dict__.clear()
    other.__dict__.update(room.__dict__ | changes)
    return other


def test_what_is_broken_is_found_alike(homes: tuple[Scene, Scene]) -> None:
    """Under a ceiling of moved furniture the same small things float, cross and are sat on."""

    def shifted(scene: Scene) -> Scene:
        return replace(scene, dynamic=tuple(replace(one, x=one.x + 0.4) for one in scene.dynamic), request={"robot_width": 0.9})

    told, made = map(shifted, homes)
    issues = check(made, KNOWN).issues
    assert issues
    assert check(told, KNOWN).issues == issues
    first = next(room for room in told.rooms if count_decorations(room))
    sitter = replace(made.dynamic[0], room=first.id, on=first.decorations[0].id) if made.dynamic else None
    if sitter is not None:
        seated = [replace(scene, dynamic=(sitter, *scene.dynamic[1:])) for scene in (told, made)]
        assert check(seated[0], KNOWN).issues == check(seated[1], KNOWN).issues


def test_rooms_are_copied_pickled_and_changed_like_any_other() -> None:
    for way in (copy.copy, copy.deepcopy, lambda room: pickle.loads(pickle.dumps(room)), lambda room: replace(room, type="den")):
        told = next(room for room in generate(REQUESTS[0], catalogs=KNOWN).scene.rooms if count_decorations(room))
        done = way(told)
        assert rows_in(done, FurnitureRows) is rows_in(done, DecorationRows) is None
        assert (done.furniture, done.decorations) == (told.furniture, told.decorations)
        assert replace(done, type=told.type) == told
        assert hash((done.id, done.decorations[0].id)) == hash((told.id, told.decorations[0].id))
    assert replace(told, decorations=()).decorations == Room("empty").decorations == ()


def test_furniture_of_one_kind_has_one_look_whatever_room_lists_it() -> None:
    scene = generate(Request(seed=1, program="family")).scene
    by_room = [rows.looks for room in scene.rooms if (rows := rows_in(room, FurnitureRows))]
    keys = [{look.key for look in looks} for looks in by_room]
    assert any(one & other for k, one in enumerate(keys) for other in keys[:k])  # rooms of different types hold the same
    looks = {look.key: look for looks in by_room for look in looks}
    assert all(look is looks[look.key] for own in by_room for look in own)
