"""fix() of a piece that was moved without what lies inside it: that lies inside again, at its height, and nothing else moves."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import pytest

from catalogs import load_catalogs
from solver import Request, Scene, fix, generate, validate
from solver.scene import Decoration, Furniture, Level, Room
from solver.streams import Stream
from tests.sweeps import pairs

SEEDS = range(3)
TRIES = 20
JUTS = 0.005
"""What lies inside may reach so far out of its piece, m."""


@cache
def home(seed: int) -> Scene:
    return generate(Request(seed=seed, width=12, depth=9, decorate=True)).scene


def in_frame(thing: Decoration, piece: Furniture) -> tuple[float, float, float]:
    """Where a thing is from the middle of a piece's underside: to its right, up, and to its front, m."""
    dx, dz = thing.x - piece.x, thing.z - piece.z
    across, along = {0: (dx, dz), 90: (-dz, dx), 180: (-dx, -dz), 270: (dz, -dx)}[int(piece.rotation)]
    return across, thing.y - piece.y, along


def is_inside(thing: Decoration, piece: Furniture) -> bool:
    """Tells whether a thing's middle is in a piece's box, and its underside well below the piece's top."""
    across, up, along = in_frame(thing, piece)
    return 0 <= up < piece.height - 0.05 and abs(across) < piece.width / 2 and abs(along) < piece.depth / 2


def reaches_out(thing: Decoration, piece: Furniture) -> float:
    own = (thing.width, thing.depth) if round(thing.rotation / 90) % 2 == 0 else (thing.depth, thing.width)
    its = (piece.width, piece.depth) if round(piece.rotation / 90) % 2 == 0 else (piece.depth, piece.width)
    return max(
        abs(a - b) + (small - large) / 2 for a, b, small, large in zip((thing.x, thing.z), (piece.x, piece.z), own, its, strict=True)
    )


def with_furniture(scene: Scene, piece: Furniture) -> Scene:
    rooms = (replace(room, furniture=tuple(piece if one.id == piece.id else one for one in room.furniture)) for room in scene.rooms)
    return replace(scene, rooms=tuple(rooms))


def carried_by(label: str, things: dict[str, Decoration]) -> set[str]:
    """The things that are on, in or over a body, and on those."""
    found = {thing.id for thing in things.values() if thing.parent == label}
    return found.union(*(carried_by(one, things) for one in found))


def errors(scene: Scene) -> dict[str, set[str]]:
    found: dict[str, set[str]] = {}
    for issue in validate(scene, load_catalogs()):
        if issue.severity == "error":
            found.setdefault(issue.rule, set()).update(issue.ids)
    return found


def thrown(seed: int) -> Iterator[tuple[Scene, Furniture, list[Decoration]]]:
    """Yields a home with one piece elsewhere in its room, where it breaks no rule, without what it holds; the piece, and what that is."""
    made, catalogs = home(seed), load_catalogs()
    carved = {spec.name or kind for kind, spec in catalogs.furniture.items() if spec.category == "storage" and not spec.surfaces[:-1]}
    for room in made.rooms:
        for piece in room.furniture:
            own = [thing for thing in room.decorations if thing.parent == piece.id and thing.mounted_on_wall is None]
            held = [thing for thing in own if is_inside(thing, piece)]
            if piece.name not in carved or not held:
                continue
            stream = Stream(seed, "thrown", piece.id)
            for _ in range(TRIES):
                x, z = (round(room_at + stream.uniform(0.3, extent - 0.3), 3) for room_at, extent in ((0, room.width), (0, room.depth)))
                turn = (piece.rotation + 90 * stream.below(4)) % 360
                sent = with_furniture(made, replace(piece, x=x, z=z, rotation=turn, wall=None))
                wrong = errors(sent)
                if set(wrong) == {"floating"} and wrong["floating"] <= {one.id for one in own} and wrong["floating"] & {h.id for h in held}:
                    yield sent, replace(piece, x=x, z=z, rotation=turn, wall=None), own
                    break


@pytest.mark.parametrize("named", [False, True])
def test_what_lay_inside_a_moved_piece_lies_inside_again(named: bool) -> None:
    kinds = set()
    for seed in SEEDS:
        before = {piece.id: piece for room in home(seed).rooms for piece in room.furniture}
        for sent, piece, own in thrown(seed):
            fixed = fix(sent, moved=[piece.id] if named else [], repairs=False)
            assert (errors(fixed.scene), fixed.conflicts) == ({}, ()), piece.id
            now = {thing.id: thing for room in fixed.scene.rooms for thing in room.decorations}
            assert {move.id for move in fixed.moves} <= carried_by(piece.id, now), piece.id
            for thing in own:
                was = is_inside(thing, before[piece.id])
                assert is_inside(now[thing.id], piece) == was, thing.id
                assert abs(now[thing.id].y - thing.y) <= 0.011, thing.id
                assert not was or reaches_out(now[thing.id], piece) <= JUTS, thing.id
            assert fix(fixed.scene, repairs=False).scene == fixed.scene
            kinds.add(piece.name)
    assert len(kinds) >= 3, kinds


LOW = Level(0, height=2.4)
WARDROBE = Furniture("r/wardrobe_1", "wardrobe", "storage", x=2.0, z=0.35, width=1.2, depth=0.6, height=2.1, wall="north")


def with_thing(height: float, y: float) -> Scene:
    thing = Decoration("r/coat_1", "hanging_clothes", WARDROBE.id, None, 2.9, y, 1.6, 0, 0.2, 0.3, height)
    room = Room("r", width=4.0, depth=4.0, furniture=(WARDROBE,), decorations=(thing,))
    return Scene(wall_thickness=0.1, levels=(LOW,), rooms=(room,))


@pytest.mark.parametrize("y", [0.0, 0.7, 2.1])
def test_what_is_too_high_for_the_top_is_put_inside(y: float) -> None:
    fixed = fix(with_thing(1.2, y))
    (thing,) = fixed.scene.rooms[0].decorations
    assert errors(fixed.scene) == {} and is_inside(thing, WARDROBE) and thing.y + thing.height < WARDROBE.height
    low = fix(with_thing(0.2, 2.1)).scene.rooms[0].decorations[0]
    assert low.y == WARDROBE.height


def test_what_the_ceiling_lets_lie_nowhere_stays_and_is_named() -> None:
    sent = with_thing(2.39, 0.0)
    fixed = fix(sent)
    assert fixed.scene == sent
    assert [conflict.ids for conflict in fixed.conflicts] == [("r/coat_1",)]
    assert "floats" in fixed.conflicts[0].message


@pytest.mark.parametrize("by", [0.2, -0.2])
def test_a_cabinet_made_wider_or_narrower_keeps_what_is_inside(by: float) -> None:
    coats = 0
    for seed in SEEDS:
        made = home(seed)
        for room in made.rooms:
            for piece in room.furniture:
                if piece.name != "wardrobe":
                    continue
                other = replace(piece, width=round(piece.width + by, 2), kind=None)
                furniture = tuple(other if one is piece else one for one in room.furniture)
                sent = Scene(wall_thickness=made.wall_thickness, rooms=(replace(room, furniture=furniture),))
                fixed = fix(sent)
                assert "floating" not in {issue.rule for issue in fixed.issues}, (seed, piece.id)
                (now,) = [one for one in fixed.scene.rooms[0].furniture if one.id == piece.id]
                inside = [thing for thing in fixed.scene.rooms[0].decorations if thing.parent == piece.id and "clothes" in thing.name]
                assert all(now.y < thing.y < thing.y + thing.height <= now.y + now.height for thing in inside)
                coats += len(inside)
    assert coats > 5


@pytest.mark.parametrize(("seed", "by"), pairs(SEEDS, [0.02, -0.02]))
def test_things_that_float_inside_come_to_lie_inside(seed: int, by: float) -> None:
    """As they do where their cabinet becomes one with other boards: all that lies inside one is so much higher, or lower."""
    tried = 0
    for room in home(seed).rooms:
        for piece in room.furniture:
            inside = {thing.id for thing in room.decorations if thing.parent == piece.id and is_inside(thing, piece)}
            raised = tuple(replace(one, y=round(one.y + by, 4)) if one.id in inside else one for one in room.decorations)
            if not inside or any(one.y < piece.y or not is_inside(one, piece) for one in raised if one.id in inside):
                continue
            others = (replace(room, decorations=raised) if one.id == room.id else one for one in home(seed).rooms)
            answer = fix(replace(home(seed), rooms=tuple(others)), moved=[piece.id], on_conflict="report")
            things = {thing.id: thing for one in answer.scene.rooms for thing in one.decorations}
            assert not answer.conflicts, piece.id
            assert all(is_inside(things[name], piece) for name in inside), piece.id
            tried += 1
    assert tried > 3
