"""Where leaves hang: with their handles they stay over the floor that scenes keep free at doors, wherever they stand in their swing."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import product

import pytest

from catalogs import load_catalogs
from solver.exports import describe
from solver.exports.model import DoorLeaf, PlacedOpening
from solver.scene import Opening, Room, Scene

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
    for wall, hinge, swing, main in product(("north", "south", "east", "west"), ("start", "end"), ("in", "out"), (False, True)):
        opening = replace(door(wall, hinge, swing, width), main_entrance=main)
        room = Room("r", 0, "bedroom", x=1.0, z=2.0, width=4.0, depth=4.0, openings=(opening,))
        model = describe(Scene(wall_thickness=thickness, rooms=(room,)), load_catalogs())
        (leaf,), (placed,) = model.leaves, model.openings
        beside, before = farthest(leaf, placed)
        assert beside < 1e-9
        assert before < min(width, SQUARE) + 1e-9


def test_a_handle_that_stands_far_out_is_seen() -> None:
    room = Room("r", 0, "bedroom", x=1.0, z=2.0, width=4.0, depth=4.0, openings=(door("north", "start", "in", 0.9),))
    model = describe(Scene(wall_thickness=0.1, rooms=(room,)), load_catalogs())
    leaf = model.leaves[0]
    longer = tuple(part._replace(at=(part.at[0], part.at[1], part.at[2] * 1.5)) for part in leaf.parts)
    assert farthest(replace(leaf, parts=longer), model.openings[0])[0] > 0.01
