"""A list leaves the floor free that fronts open over, wherever its relations let it."""

from __future__ import annotations

import pytest

from catalogs.schema import RelationSpec
from solver import place
from solver.requested import Answered, PieceRequest
from solver.scene import Furniture, Opening, Room

DOOR = Opening("door", "door", "south", 1.5, 0.85, 2.05, connects_to="EXTERIOR")
AHEAD = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}
DOORS = 0.45
"""How far the doors of a wardrobe of 1.8 m come out at least, m."""
STANDING = Furniture("wardrobe", "wardrobe", x=0.95, z=0.33, rotation=0, width=1.8, depth=0.6, height=2.1, wall="north")


def box(piece: Furniture, ahead: float = 0.0) -> tuple[float, float, float, float]:
    """The footprint, or so much floor before it."""
    width, depth = (piece.width, piece.depth) if piece.rotation % 180 == 0 else (piece.depth, piece.width)
    dx, dz = (part * ahead for part in AHEAD[round(piece.rotation)])
    x, z = piece.x + dx, piece.z + dz
    return x - width / 2, z - depth / 2, x + width / 2, z + depth / 2


def meet(a: tuple[float, float, float, float], b: tuple[float, float, float, float]) -> bool:
    return a[0] < b[2] - 1e-6 and b[0] < a[2] - 1e-6 and a[1] < b[3] - 1e-6 and b[1] < a[3] - 1e-6


def basket(answer: Answered) -> tuple[bool, bool]:
    """Whether all relations are held, and whether the basket stands before the wardrobe's doors."""
    bodies = {piece.id: piece for piece in answer.best.scene.rooms[0].furniture}
    return all(one.held for one in answer.best.relations), meet(box(bodies["basket"]), box(bodies["wardrobe"], DOORS))


def asked(*relations: RelationSpec) -> PieceRequest:
    return PieceRequest("basket", "basket", 0.4, 0.35, 0.5, relations=relations)


NEAR = RelationSpec(type="near", of=("wardrobe",), distance=0.5)
WARDROBE = PieceRequest("wardrobe", "wardrobe", relations=(RelationSpec(type="against_wall"),))


@pytest.mark.parametrize("stands", [False, True], ids=["listed", "standing"])
def test_what_stands_near_a_wardrobe_leaves_its_doors_free(stands: bool) -> None:
    room = Room("den", width=2.6, depth=2.6, openings=(DOOR,), furniture=(STANDING,) if stands else ())
    assert basket(place(room, [asked(NEAR)] if stands else [WARDROBE, asked(NEAR)])) == (True, False)


def test_a_relation_that_is_asked_for_is_worth_more_than_a_front() -> None:
    before = RelationSpec(type="in_front_of", of=("wardrobe",), gap=(0.0, 0.2), cost=0.01)
    assert basket(place(Room("den", width=2.6, depth=2.6, openings=(DOOR,)), [WARDROBE, asked(before)])) == (True, True)
