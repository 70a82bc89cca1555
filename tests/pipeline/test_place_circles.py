"""Pieces whose required relations refer to each other: held as a ruler measures, or the piece is not there and that is said."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from catalogs.schema import RelationSpec
from solver import place
from solver.requested import Answered, PieceRequest
from solver.scene import Furniture, Opening, Room
from tests.every import every
from tests.sweeps import seeds

DOOR = Opening("door_1", "door", "south", 0.7, 0.9, connects_to="EXTERIOR")
ROOM = Room("den_0", 0, "den", width=4.4, depth=4.0, openings=(DOOR,))
Wish = tuple[str, str, str, float]
"""Whose it is, near or far_from, of what, how far, m."""
SPARE = 0.3


def apart(a: Furniture, b: Furniture) -> float:
    """The free distance between two footprints, m."""
    sides = [(p.width, p.depth) if p.rotation % 180 == 0 else (p.depth, p.width) for p in (a, b)]
    across = max(abs(a.x - b.x) - (sides[0][0] + sides[1][0]) / 2, 0.0)
    along = max(abs(a.z - b.z) - (sides[0][1] + sides[1][1]) / 2, 0.0)
    return float((across**2 + along**2) ** 0.5)


def drawn(seed: int, names: str, words: str) -> list[Wish]:
    """Each piece's relation to the next, the last one's to the first, which all hold for pieces thrown into the room."""
    random = Random(seed)
    thrown = {name: Furniture(name, name, x=random.uniform(0.4, 4.0), z=random.uniform(0.4, 3.0), width=0.5, depth=0.5) for name in names}
    wishes = []
    for own, other, word in zip(names, names[1:] + names[0], words, strict=True):
        gap = apart(thrown[own], thrown[other])
        near = word == "n"
        wishes.append((own, "near" if near else "far_from", other, round(max(gap + (SPARE if near else -SPARE), 0.1), 2)))
    return wishes


def answered(wishes: list[Wish]) -> Answered:
    asked = [
        PieceRequest(own, "crate", 0.5, 0.5, 0.6, relations=(RelationSpec(type=word, of=other, distance=far, required=True),))
        for own, word, other, far in wishes
    ]
    return place(ROOM, asked)


def check(wishes: list[Wish], answer: Answered) -> int:
    """What stands holds its wish, what does not is explained; returns how many stand."""
    bodies = {piece.id: piece for piece in answer.best.scene.rooms[0].furniture}
    for own, word, other, far in wishes:
        if own in bodies:
            assert word == "far_from" or other in bodies
            gap = apart(bodies[own], bodies[other]) if other in bodies else 100.0
            assert gap <= far + 1e-6 if word == "near" else gap >= far - 1e-6, (own, word, other, far, gap)
    gone = {own for own, *_ in wishes} - bodies.keys()
    assert {entry.id for entry in answer.best.unplaced} == gone
    assert {label for conflict in answer.conflicts for label in conflict.ids} >= gone
    return len(bodies)


@every("seed", seeds(range(200), 12))
@every("words", ["nf", "fn", "nn", "ff"])
def test_two_that_refer_to_each_other_both_stand(seed: int, words: str) -> None:
    wishes = drawn(seed, "ab", words)
    assert check(wishes, answered(wishes)) == 2


@pytest.mark.parametrize("words", ["nfn", "fnf", "ffn", "nnf"])
def test_three_in_a_circle_hold_or_are_not_there(words: str) -> None:
    stood = 0
    for seed in range(10):
        wishes = drawn(seed, "abc", words)
        stood += check(wishes, answered(wishes))
    assert stood >= 15  # a place in two pieces' frames at once is sought only where both stand already


def test_what_cannot_hold_together_is_left_out_and_said() -> None:
    wishes: list[Wish] = [("a", "near", "b", 0.5), ("b", "far_from", "a", 2.0)]
    answer = answered(wishes)
    assert check(wishes, answer) == 1  # b is far from what is not there
    certificate: Any = answer.best.scene.certificate
    assert not certificate["rooms"]["den_0"]["best"]


def test_what_relates_to_one_that_is_not_there_is_not_there_either() -> None:
    crate = (0.5, 0.5, 0.6)
    asked = [
        PieceRequest("a", "crate", *crate, relations=(RelationSpec(type="near", of="big", distance=0.5, required=True),)),
        PieceRequest("big", "crate", 5.0, 5.0, 1.0, relations=(RelationSpec(type="far_from", of="a", distance=0.2),)),
    ]
    answer = place(ROOM, asked)
    assert {entry.id for entry in answer.best.unplaced} == {"a", "big"}
    assert answer.best.scene.rooms[0].furniture == ()
