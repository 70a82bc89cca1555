"""reroll(): the named rooms are furnished, decorated and peopled anew; everything else stays to the byte."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from functools import lru_cache
from typing import Any

import pytest

from catalogs import load_catalogs
from solver import Request, Scene, generate, reroll, validate
from solver.exchange import dump_text, write_scene

OUTSIDE_ROOMS = ("rooms", "dynamic", "certificate")


@lru_cache(maxsize=4)
def house(decorate: bool) -> Scene:
    """A house with a pet and three people or more."""
    made = (generate(Request(seed=seed, width=16, depth=12, outdoor=True, decorate=decorate)).scene for seed in range(60, 120))
    return next(scene for scene in made if sum(one.kind == "person" for one in scene.dynamic) >= 3 and len(scene.dynamic) > 3)


def written(scene: Scene, room: str) -> tuple[bytes, list[bytes], bytes]:
    """A room, who is in it, and what the certificate says of it, as text."""
    document = write_scene(scene)
    own = next(one for one in document["rooms"] if one["id"] == room)
    here = [dump_text(one, "json") for one in document["dynamic"] if one["room"] == room]
    return dump_text(own, "json"), here, dump_text(document["certificate"]["rooms"][room], "json")


def named(scene: Scene) -> list[str]:
    """Two rooms with somebody in them, and one without."""
    peopled = list(dict.fromkeys(str(one.room) for one in scene.dynamic))
    empty = next(room.id for room in scene.rooms if room.id not in peopled and len(room.furniture) > 3)
    return [*peopled[:2], empty]


@pytest.mark.parametrize("decorate", [False, True])
def test_the_other_rooms_and_their_people_stay_to_the_byte(decorate: bool) -> None:
    scene, changed = house(decorate), Counter[str]()
    chosen = named(scene)
    for seed in (1, 2, 3):
        after = reroll(scene, chosen, seed=seed).scene
        assert [issue.message for issue in validate(after, load_catalogs()) if issue.severity == "error"] == []
        for room in scene.rooms:
            if room.id not in chosen:
                assert written(after, room.id) == written(scene, room.id)
            elif written(after, room.id) != written(scene, room.id):
                changed[room.id] += 1
        before, now = write_scene(scene), write_scene(after)
        assert {key: before[key] for key in before if key not in OUTSIDE_ROOMS} == {
            key: now[key] for key in now if key not in OUTSIDE_ROOMS
        }
    assert set(changed) == set(chosen)


def test_the_named_rooms_are_decorated_only_where_the_house_is() -> None:
    for decorate in (False, True):
        scene = house(decorate)
        chosen = named(scene)
        rooms = {room.id: room for room in reroll(scene, chosen, seed=5).scene.rooms}
        assert all(bool(rooms[name].decorations) is decorate for name in chosen)


def test_rerolled_rooms_keep_floors_walls_and_openings() -> None:
    def shell(scene: Scene) -> list[Any]:
        return [replace(room, furniture=(), decorations=()) for room in scene.rooms]

    scene = house(True)
    assert shell(reroll(scene, [room.id for room in scene.rooms], seed=77).scene) == shell(scene)


def test_with_the_same_seed_all_rooms_come_back_as_they_were_made() -> None:
    scene = house(True)
    again = reroll(scene, [room.id for room in scene.rooms]).scene
    assert [room.decorations for room in again.rooms] == [room.decorations for room in scene.rooms]
    assert again.dynamic == scene.dynamic


def test_never_more_than_four_people_and_the_pet_stays_in_the_house() -> None:
    scene = house(False)
    (pet,) = [one for one in scene.dynamic if one.kind != "person"]
    for seed in range(12):
        chosen = [*(room.id for room in scene.rooms[:6]), str(pet.room)]
        after = reroll(scene, chosen, seed=seed).scene
        people = [one for one in after.dynamic if one.kind == "person"]
        assert len(people) <= 4 and len({one.id for one in after.dynamic}) == len(after.dynamic)
        assert [(one.id, one.kind, one.color) for one in after.dynamic if one.kind != "person"] == [(pet.id, pet.kind, pet.color)]
        certificate: Any = after.certificate
        assert certificate["counts"]["dynamic"] == len(after.dynamic)


def test_nobody_comes_where_the_request_says_so() -> None:
    scene = house(False)
    request = {**(scene.request or {}), "people": False}
    asked = Request(seed=scene.seed, width=16, depth=12, outdoor=True, people=False)
    empty = generate(asked).scene
    counts = (empty.certificate or {})["counts"]
    assert empty == replace(scene, request=request, dynamic=(), certificate={**(scene.certificate or {}), "counts": counts})
    assert not reroll(empty, named(scene), seed=2).scene.dynamic
    chosen = str(scene.dynamic[0].room)
    others = [one for one in scene.dynamic if one.room != chosen]
    assert list(reroll(replace(scene, request=request), [chosen], seed=2).scene.dynamic) == others
