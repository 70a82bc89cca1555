"""Where leaves hang: with their handles they stay over the floor that scenes keep free at doors, wherever they stand in their swing."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import product

import pytest
from pxr import UsdGeom

from catalogs import load_catalogs
from solver.exports import ExportSettings, describe, written_as
from solver.exports.model import DoorLeaf, PlacedOpening
from solver.scene import Opening, Room, Scene
from tests.exports.homes import own
from tests.exports.physics import mjcf, started
from tests.exports.readers import glb, usd
from tests.sweeps import seeds

SQUARE = 0.9
"""A door keeps as much free before it as it is wide, at most this (docs/scene.md, blocks_door), m."""


def corners(leaf: DoorLeaf, degrees: float) -> list[tuple[float, float]]:
    """Returns the corners of a leaf's parts from above, x and z in the house, so far open."""
    turn = math.radians(leaf.closed + math.copysign(degrees, leaf.swing))
    found = []
    for part in leaf.parts:
        for across, aside in product((-1, 1), repeat=2):
            u, v = leaf.width / 2 + part.at[0] + across * part.size[0] / 2, part.at[2] + aside * part.size[2] / 2
            found.append((leaf.hinge[0] + u * math.cos(turn) + v * math.sin(turn), leaf.hinge[2] - u * math.sin(turn) + v * math.cos(turn)))
    return found


def farthest(leaf: DoorLeaf, opening: PlacedOpening) -> tuple[float, float]:
    """Returns how far a leaf comes out sideways of its opening, and before or behind its wall's line, on its whole way, m."""
    beside, before = -math.inf, 0.0
    for degrees in range(91):
        for x, z in corners(leaf, degrees):
            along, across = (x, z - opening.line) if opening.axis == "x" else (z, x - opening.line)
            beside = max(beside, opening.start - along, along - opening.end)
            before = max(before, abs(across))
    return beside, before


def door(wall: str, hinge: str, swing: str, width: float) -> Opening:
    return Opening("d", wall=wall, position=2.0, connects_to="EXTERIOR", hinge=hinge, swing=swing, width=width)


@pytest.mark.parametrize(("width", "thickness"), [(0.6, 0.1), (0.7, 0.27), (0.9, 0.02), (0.9, 0.1), (0.9, 0.27), (0.98, 0.1)])
def test_a_leaf_stays_over_the_square_before_its_opening(width: float, thickness: float) -> None:
    for wall, hinge, swing, main in seeds(
        [*product(("north", "south", "east", "west"), ("start", "end"), ("in", "out"), (False, True))], 5
    ):
        opening = replace(door(wall, hinge, swing, width), main_entrance=main)
        room = Room("r", 0, "bedroom", x=1.0, z=2.0, width=4.0, depth=4.0, openings=(opening,))
        model = describe(Scene(wall_thickness=thickness, rooms=(room,)), load_catalogs())
        (leaf,), (placed,) = model.leaves, model.openings
        beside, before = farthest(leaf, placed)
        assert beside < 1e-9
        assert before < min(width, SQUARE) + 1e-9


def shut_corners(leaf: DoorLeaf) -> tuple[list[float], list[float]]:
    found = corners(leaf, 0)
    return [x for x, _ in found], [z for _, z in found]


@pytest.mark.parametrize(("wall", "hinge", "swing"), [*product(("north", "south", "east", "west"), ("start", "end"), ("in", "out"))])
def test_a_wide_door_has_two_leaves_that_fill_it_and_open_to_one_side(wall: str, hinge: str, swing: str) -> None:
    opening = door(wall, hinge, swing, 1.9)
    model = describe(Scene(rooms=(Room("r", 0, "bedroom", x=1.0, z=2.0, width=4.0, depth=4.0, openings=(opening,)),)), load_catalogs())
    first, second = model.leaves
    assert (first.id, second.id, {first.opening, second.opening}) == ("d", "d/2", {"d"})
    (placed,) = model.openings
    along = 0 if placed.axis == "x" else 1
    spans = sorted((min(shut_corners(leaf)[along]), max(shut_corners(leaf)[along])) for leaf in model.leaves)
    frame = [placed.start + 0.06, (placed.start + placed.end) / 2, (placed.start + placed.end) / 2, placed.end - 0.06]
    assert [end for span in spans for end in span] == pytest.approx(frame)
    hangs = placed.start if hinge == "start" else placed.end
    assert abs((first.hinge[0] if along == 0 else first.hinge[2]) - hangs) < 0.1
    beyond = (corners(leaf, 90) for leaf in model.leaves)
    middles = [sum(spot[1 - along] for spot in stands) / len(stands) - placed.line for stands in beyond]
    inwards = 1 if wall in ("north", "west") else -1
    assert {math.copysign(1, middle) for middle in middles} == {inwards if swing == "in" else -inwards}
    assert all(farthest(leaf, placed)[0] < 1e-9 and farthest(leaf, placed)[1] < 1.0 for leaf in model.leaves)


@pytest.mark.parametrize(("width", "height"), [(0.8, 0.7), (0.8, 1.2), (0.1, 2.0), (0.2, 0.05), (1.4, 0.3), (3.0, 0.9)])
def test_openings_too_small_for_a_whole_frame_are_filled_by_boxes_that_lie_in_them(width: float, height: float) -> None:
    for kind, outdoor in product(("door", "garage_door", "window"), (False, True)):
        opening = replace(door("north", "start", "in", width), kind=kind, height=height, sill=0.0)
        model = describe(Scene(rooms=(Room("r", 0, "patio", width=4.0, depth=4.0, openings=(opening,), outdoor=outdoor),)), load_catalogs())
        for leaf in model.leaves:
            for part in leaf.parts:
                low, high = part.at[1] - part.size[1] / 2, part.at[1] + part.size[1] / 2
                assert min(part.size) > 0 and low > -1e-9 and high < height - 0.01 + 1e-9
                assert abs(part.at[0]) + part.size[0] / 2 < leaf.width / 2 + 1e-9
        assert min(extent for fitting in model.fittings for extent in fitting.box.size) > 0
        started(mjcf(model))


def test_a_door_as_wide_as_one_leaf_goes_has_one() -> None:
    for width, count in ((1.25, 1), (1.251, 2)):
        room = Room("r", 0, "bedroom", width=4.0, depth=4.0, openings=(door("north", "start", "in", width),))
        assert len(describe(Scene(rooms=(room,)), load_catalogs()).leaves) == count


def test_a_handle_that_stands_far_out_is_seen() -> None:
    room = Room("r", 0, "bedroom", x=1.0, z=2.0, width=4.0, depth=4.0, openings=(door("north", "start", "in", 0.9),))
    model = describe(Scene(wall_thickness=0.1, rooms=(room,)), load_catalogs())
    leaf = model.leaves[0]
    longer = tuple(part._replace(at=(part.at[0], part.at[1], part.at[2] * 1.5)) for part in leaf.parts)
    assert farthest(replace(leaf, parts=longer), model.openings[0])[0] > 0.01


def test_a_door_stands_as_far_open_as_the_scene_says() -> None:
    """In MuJoCo's key, in usd's and glb's poses: the leaf's own x axis, half open."""
    scene = own()
    rooms = tuple(replace(room, openings=tuple(replace(one, open=0.5) for one in room.openings)) for room in scene.rooms)
    model = describe(replace(scene, rooms=rooms), load_catalogs())
    assert model.leaves
    _, state = started(mjcf(model))
    stage = usd.stage_of(written_as(model, ExportSettings("usd")))
    cache = UsdGeom.XformCache()
    (content,) = written_as(model, ExportSettings("glb")).values()
    nodes = {node["name"]: node for node in glb.document(content)["nodes"]}
    doors = {prim.GetCustomDataByKey("id"): prim for prim in stage.GetDefaultPrim().GetChild("Doors").GetChildren()}
    for leaf in model.leaves:
        swings = leaf.motion == "swing"
        turn = math.radians(leaf.closed + (leaf.swing / 2 if swings else 0.0))
        lift = 0.0 if swings else leaf.height / 2
        assert state.body(leaf.id).xmat.reshape(3, 3)[:2, 0] == pytest.approx((math.cos(turn), math.sin(turn)), abs=1e-6)
        assert state.body(leaf.id).xpos[2] == pytest.approx(leaf.hinge[1] + lift, abs=1e-6)
        at = cache.GetLocalToWorldTransform(doors[leaf.id])
        assert list(at.TransformDir((1, 0, 0)))[:2] == pytest.approx((math.cos(turn), math.sin(turn)), abs=1e-6)
        assert at.ExtractTranslation()[2] == pytest.approx(leaf.hinge[1] + lift, abs=1e-5)
        node = nodes[leaf.id]
        assert 2 * math.atan2(node["rotation"][1], node["rotation"][3]) % (2 * math.pi) == pytest.approx(turn % (2 * math.pi), abs=1e-6)
        assert node["extras"]["joint"]["at"] == pytest.approx(leaf.opened)
