"""Decorated houses, whole: judged by the validator and by plane geometry; furniture as it was; the same every time."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace
from operator import itemgetter
from typing import Any

import pytest

from catalogs import load_catalogs
from solver import Request, generate, reroll
from solver.exchange import dump_text, write_scene
from solver.scene import Decoration, Furniture, Room, Scene
from solver.view import view
from tests.decorations.oracle import complaints, shares, turned
from tests.sweeps import times
from tests.validator.travels import front_travels

KNOWN = load_catalogs()
CASES: list[dict[str, Any]] = [
    *({"seed": seed, "outdoor": seed % 2 == 0} for seed in range(4)),
    *({"seed": seed, "program": "family"} for seed in range(4, 8)),
    {"seed": 8, "width": 12.0, "depth": 9.0, "use_spine": False},
    {"seed": 9, "robot_width": 0.75, "program": "one_bed"},
]


@pytest.fixture(scope="module", params=range(len(CASES)), ids=str)
def pair(request: pytest.FixtureRequest) -> tuple[Scene, Scene]:
    """A house decorated and bare."""
    asked = Request(**CASES[request.param])
    made = generate(replace(asked, decorate=True))
    assert [issue.message for issue in made.issues if issue.severity == "error"] == []
    return made.scene, generate(asked).scene


def test_plane_geometry_finds_nothing_wrong(pair: tuple[Scene, Scene]) -> None:
    assert list(complaints(pair[0])) == []


def test_no_thing_keeps_a_front_from_opening(pair: tuple[Scene, Scene]) -> None:
    fronts = [one for several in front_travels(pair[0], KNOWN).values() for one in several]
    things = {thing.id for room in pair[0].rooms for thing in room.decorations}
    assert len(fronts) > 20
    assert [one for one in fronts if one.meets in things and one.share < 0.95] == []


def test_furniture_is_the_same_with_and_without(pair: tuple[Scene, Scene]) -> None:
    decorated, bare = pair
    assert [room.furniture for room in decorated.rooms] == [room.furniture for room in bare.rooms]
    assert [replace(room, decorations=()) for room in decorated.rooms] == list(bare.rooms)
    assert all(not room.decorations for room in bare.rooms)
    assert all(room.decorations for room in decorated.rooms if min(room.width, room.depth) > 1.5 and not room.outdoor)


def test_nothing_but_toys_is_put_before_cupboards_nightstands_and_mirrors(pair: tuple[Scene, Scene]) -> None:
    faced = {"wardrobe", "dresser", "bookshelf", "nightstand", "standing_mirror", "shoe_cabinet", "console_table", "vanity"}
    met = 0
    for room in pair[0].rooms:
        put = [d for d in room.decorations if d.parent is None and d.mounted_on_wall is None and d.height > 0.02]
        for piece in (one for one in room.furniture if one.name in faced):
            reach = 0.29 + piece.depth / 2
            away = {0: (0.0, reach), 90: (reach, 0.0), 180: (0.0, -reach), 270: (-reach, 0.0)}[round(piece.rotation)]
            before = turned(replace(piece, x=piece.x + away[0] / 2, z=piece.z + away[1] / 2, depth=reach))
            met += 1
            assert [d.id for d in put if not d.name.startswith("toy_") and shares(turned(d), before)] == [], piece.id
    assert met > 3


def test_ids_parents_rotations_and_colours(pair: tuple[Scene, Scene]) -> None:
    style = KNOWN.styles[str((pair[0].request or {})["style"])]
    for room in pair[0].rooms:
        bodies = {body.id for group in (room.furniture, room.decorations) for body in group}
        assert len(bodies) == len(room.furniture) + len(room.decorations)
        for thing in room.decorations:
            kind = KNOWN.decorations[thing.name]
            assert thing.id.rpartition("_")[0] == f"{room.id}/{thing.name}"
            assert thing.parent is None or thing.parent in bodies
            assert 0 <= thing.rotation < 360
            assert thing.color in {kind.color, *kind.variants, *style.colours(thing.name, kind.group), room.accent}
            askew = (thing.rotation + 45) % 90 - 45
            assert abs(askew) <= (15 if kind.jitter else 0)


def test_bounds_lie_on_the_lattice(pair: tuple[Scene, Scene]) -> None:
    for room in pair[0].rooms:
        for thing in room.decorations:
            assert all(abs(value * 2000 - round(value * 2000)) < 1e-6 for value in (thing.x, thing.z))
            assert all(abs(value * 1000 - round(value * 1000)) < 1e-6 for value in (thing.y, thing.width, thing.depth, thing.height))


def test_the_check_sees_what_is_wrong(pair: tuple[Scene, Scene]) -> None:
    """Every thing that is shoved out of the room or lifted is complained of."""
    room = max(pair[0].rooms, key=lambda room: len(room.decorations))
    for k in range(0, len(room.decorations), 7):
        thing = room.decorations[k]
        if thing.parent is None and thing.height <= 0.02:
            continue
        for wrong in (replace(thing, x=thing.x + room.width), replace(thing, y=thing.y + 0.031)):
            if thing.mounted_on_wall and wrong.y != thing.y:
                continue
            spoilt: Room = replace(room, decorations=(*room.decorations[:k], wrong, *room.decorations[k + 1 :]))
            assert any(thing.id in told for told in complaints(replace(pair[0], rooms=(spoilt,))))


def test_the_check_sees_what_hangs_in_a_door_s_way(pair: tuple[Scene, Scene]) -> None:
    """A shelf beside a door at its height is complained of, one above the door is not."""
    doors = ((room, one) for room in pair[0].rooms for one in room.openings if one.kind == "door")
    room, door = next((room, one) for room, one in doors if one.wall in ("north", "south"))
    hung = next(one for other in pair[0].rooms for one in other.decorations if one.mounted_on_wall is not None)
    side, away = min(("west", door.position), ("east", room.width - door.position), key=itemgetter(1))
    depth = min(0.3, door.width / 2)
    shelf = replace(hung, mounted_on_wall=side, rotation=0.0, width=2 * away)
    for low, is_wrong in ((door.height - 0.2, True), (door.height + 0.1, False)):
        z = depth if door.wall == "north" else room.depth - depth
        wrong = replace(shelf, x=0.0 if side == "west" else room.width, z=z, depth=0.2, y=low)
        told = complaints(replace(pair[0], rooms=(replace(room, decorations=(wrong,)),)))
        assert any("in the way through" in one for one in told) == is_wrong


def test_the_same_bytes_every_time() -> None:
    asked = Request(seed=5, program="family", decorate=True)
    assert dump_text(write_scene(generate(asked).scene), "json") == dump_text(write_scene(generate(asked).scene), "json")


def test_other_seeds_decorate_otherwise() -> None:
    houses = [generate(Request(seed=seed, width=8.0, depth=6.0, decorate=True)).scene for seed in range(3)]
    colours = [Counter(thing.color for room in house.rooms for thing in room.decorations) for house in houses]
    assert colours[0] != colours[1] != colours[2]


def test_rerolled_rooms_are_decorated_anew_and_the_others_stay() -> None:
    scene = generate(Request(seed=6, program="one_bed", decorate=True)).scene
    chosen = next(room.id for room in scene.rooms if room.type == "living_room")
    made = reroll(scene, [chosen], seed=77)
    assert [issue.message for issue in made.issues if issue.severity == "error"] == []
    for before, after in zip(scene.rooms, made.scene.rooms, strict=True):
        assert (before == after) == (before.id != chosen)
        assert after.decorations
    assert list(complaints(made.scene)) == []


def test_a_bare_house_stays_bare_when_rerolled() -> None:
    scene = generate(Request(seed=6, program="one_bed")).scene
    assert not any(room.decorations for room in reroll(scene, [scene.rooms[0].id], seed=7).scene.rooms)


def test_the_readable_yaml_nests_things_under_what_carries_them(pair: tuple[Scene, Scene]) -> None:
    text, lines = view(pair[0], {room.id: 0.0 for room in pair[0].rooms})
    rows = text.splitlines()
    at = {body: k for k, body in enumerate(lines) if body}
    indents = [len(row) - len(row.lstrip()) for row in rows]
    for room in pair[0].rooms:
        for thing in room.decorations:
            line = at[thing.id]
            above = [k for k in range(line) if lines[k] and indents[k] < indents[line]]
            if thing.parent:
                assert lines[above[-1]] == thing.parent
                assert any("decorations:" in rows[k] for k in range(at[thing.parent], line))
            else:
                section = next(
                    rows[k].strip() for k in range(line, 0, -1) if not lines[k] and rows[k].startswith("    ") and indents[k] == 4
                )
                assert section == ("wall_decorations:" if thing.mounted_on_wall else "floor_decorations:")
            mounted = f"mounted on {thing.mounted_on_wall} wall"
            assert (mounted in rows[line]) == (thing.mounted_on_wall is not None)


def seen_of(rug: Decoration, room: Room) -> float:
    """Returns the share of a rug, turned by right angles, that lies under no furniture: of the middles of 400 equal parts."""
    standing = [piece for piece in room.furniture if not piece.y]
    wide, deep = (rug.width, rug.depth) if rug.rotation % 180 == 0 else (rug.depth, rug.width)
    steps = [(k + 0.5) / 20 - 0.5 for k in range(20)]
    return sum(not any(_covers(piece, rug.x + wide * u, rug.z + deep * v) for piece in standing) for u in steps for v in steps) / 400


def _covers(piece: Furniture, x: float, z: float) -> bool:
    angle, dx, dz = math.radians(piece.rotation), x - piece.x, z - piece.z
    across, along = dx * math.cos(angle) - dz * math.sin(angle), dx * math.sin(angle) + dz * math.cos(angle)
    return abs(across) < piece.width / 2 and abs(along) < piece.depth / 2


def test_of_rugs_in_bedrooms_more_is_seen_than_a_strip_and_mats_are_none() -> None:
    """No more than one of twenty rugs lies with three quarters of it under furniture; no mat or runner is narrower than 0.43 m."""
    shown, broad = [], []
    for seed in range(900, 900 + times(40, 12)):
        for room in generate(Request(seed=seed, program="large", decorate=True)).scene.rooms:
            broad += [min(thing.width, thing.depth) for thing in room.decorations if thing.name in ("runner", "floor_rug_small")]
            if "bedroom" in room.type:
                shown += [seen_of(thing, room) for thing in room.decorations if thing.name == "rug"]
    assert len(shown) > 40
    assert 20 * sum(share < 0.25 for share in shown) <= len(shown)
    assert len(broad) > 40 and min(broad) >= 0.43
