"""The judge of relations, on rooms made by hand: each just inside and just outside what it allows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from catalogs.schema import RelationSpec
from solver.furnish import scope_of, space_of
from solver.relations.held import FinishedRoom, held, standing
from solver.scene import Furniture, Opening, Room
from tests.every import every

DOOR = Opening("door_1", "door", "south", 2.0, 0.9)
FRONT_DOOR = Opening("door_0", "door", "east", 1.0, 0.9, main_entrance=True)
WINDOW = Opening("window_1", "window", "north", 2.0, 1.4, 1.2, 0.9)
NEAR_DOOR, FAR_DOOR = {"distance": 1.0}, {"distance": 1.0}

Pose = tuple[float, float, int]


def verdict(rule: dict[str, Any], own: Pose, other: Pose | None = None, **more: Any) -> bool:
    """Judges a body of 0.6 x 0.4 m against one of 1.6 x 0.8 m in a room of 4 x 4 m with walls of no thickness."""
    x, z, rotation = own
    bodies = [Furniture("own", "box", x=x, z=z, rotation=rotation, width=0.6, depth=0.4, height=0.5, **more)]
    if other is not None:
        x, z, rotation = other
        bodies.append(Furniture("it", "table", x=x, z=z, rotation=rotation, width=1.6, depth=0.8, height=0.7))
    return _stands(rule, bodies, (DOOR, WINDOW))


def _stands(rule: dict[str, Any], bodies: Sequence[Furniture], openings: tuple[Opening, ...]) -> bool:
    room = Room("r", width=4.0, depth=4.0, openings=openings, furniture=tuple(bodies))
    names = {"own": ("own",), "it": ("it",)}
    holds, _ = held(finished(room, names), "own", RelationSpec.model_validate(rule))
    return holds


def finished(room: Room, names: Mapping[str, tuple[str, ...]]) -> FinishedRoom:
    space = space_of(room, 0.0)
    bodies = {body.id: standing(body, space.clear, [0.7] if body.id == "it" else []) for body in room.furniture}
    return FinishedRoom(scope_of(room, space), bodies, names)


IT = (2.0, 2.0, 0)
CASES: list[tuple[dict[str, Any], Pose, Pose, Pose | None]] = [
    ({"type": "against_wall"}, (1.0, 0.25, 0), (1.0, 0.251, 0), None),
    ({"type": "against_wall"}, (1.0, 0.23, 0), (1.0, 0.23, 180), None),
    ({"type": "in_corner"}, (0.4, 0.3, 0), (0.401, 0.3, 0), None),
    ({"type": "centred"}, (2.1, 0.23, 0), (2.101, 0.23, 0), None),
    ({"type": "centred"}, (2.1, 1.9, 0), (2.1, 1.899, 0), None),
    ({"type": "at_window"}, (1.9, 0.23, 0), (1.899, 0.23, 0), None),
    ({"type": "at_window"}, (2.0, 0.4, 90), (2.0, 0.501, 90), None),
    ({"type": "near_door", "distance": 1.0}, (2.0, 2.8, 0), (2.0, 2.799, 0), None),
    ({"type": "far_from_door", "distance": 1.0}, (2.0, 2.8, 0), (2.0, 2.801, 0), None),
    ({"type": "near", "of": "window", "distance": 0.5}, (2.0, 0.7, 0), (2.0, 0.701, 0), None),
    ({"type": "facing", "of": "door"}, (1.0, 1.0, 0), (1.0, 1.0, 90), None),
    ({"type": "near", "of": "it", "distance": 0.5}, (0.4, 2.0, 0), (0.399, 2.0, 0), IT),
    ({"type": "far_from", "of": "it", "distance": 0.5}, (0.4, 2.0, 0), (0.401, 2.0, 0), IT),
    ({"type": "near", "of": "it", "distance": 0.5}, (0.6, 1.0, 0), (0.5, 1.0, 0), IT),
    ({"type": "aligned_with", "of": "it"}, (2.1, 0.5, 0), (2.101, 0.5, 0), IT),
    ({"type": "beside", "of": "it"}, (0.6, 1.8, 0), (0.599, 1.8, 0), IT),
    ({"type": "beside", "of": "it", "gap": 0.1}, (0.8, 1.8, 0), (0.779, 1.8, 0), IT),
    ({"type": "beside", "of": "it"}, (0.9, 1.6, 0), (0.9, 1.599, 0), IT),
    ({"type": "beside", "of": "it", "sides": ["left"]}, (0.9, 2.0, 0), (3.1, 2.0, 0), IT),
    ({"type": "in_front_of", "of": "it"}, (2.0, 3.3, 0), (2.0, 3.301, 0), IT),
    ({"type": "in_front_of", "of": "it", "align": "centre"}, (2.1, 2.7, 0), (2.101, 2.7, 0), IT),
    ({"type": "around", "of": "it"}, (2.0, 2.7, 180), (2.0, 2.7, 0), IT),
    ({"type": "under", "of": "it"}, (2.0, 2.59, 180), (2.0, 2.6, 180), IT),
    ({"type": "in_row", "of": "it"}, (3.1, 1.8, 0), (3.121, 1.8, 0), IT),
    ({"type": "facing", "of": "it"}, (1.0, 1.0, 0), (0.999, 1.001, 180), IT),
    ({"type": "facing", "of": "it"}, (1.0, 1.0, 90), (1.0, 1.0, 270), IT),
    ({"type": "opposite", "of": "it"}, (2.0, 3.77, 180), (2.0, 3.77, 0), (2.0, 0.43, 0)),
    ({"type": "opposite", "of": "it"}, (1.2, 3.77, 180), (0.8, 3.77, 180), (2.0, 0.43, 0)),
    ({"type": "beside", "of": "it", "wall": "same"}, (0.9, 0.23, 0), (0.9, 0.43, 0), (2.0, 0.43, 0)),
]


@every(("rule", "inside", "outside", "other"), CASES)
def test_a_relation_holds_up_to_its_bound(rule: dict[str, Any], inside: Pose, outside: Pose, other: Pose | None) -> None:
    assert (verdict(rule, inside, other), verdict(rule, outside, other)) == (True, False)


def test_on_asks_for_the_surface_and_for_being_over_it() -> None:
    rule = {"type": "on", "of": "it"}
    assert verdict(rule, (2.0, 2.0, 0), IT, y=0.7, on="it")
    assert not verdict(rule, (2.0, 2.0, 0), IT, y=0.6, on="it")
    assert not verdict(rule, (2.9, 2.0, 0), IT, y=0.7, on="it")
    assert not verdict(rule, (2.0, 2.0, 0), IT, y=0.7)


def test_the_front_door_is_a_door_and_no_other_one_is_it() -> None:
    """A box of 0.6 x 0.4 m, its right edge 1 m from the middle of the front door, then 1 mm farther; the other door is far from both."""
    near, farther = (Furniture("own", "box", x=x, z=1.0, width=0.6, depth=0.4, height=0.5) for x in (2.7, 2.699))
    for of, doors, holds in (("front_door", (DOOR, FRONT_DOOR), True), ("door", (DOOR, FRONT_DOOR), True), ("front_door", (DOOR,), False)):
        rule = {"type": "near", "of": of, "distance": 1.0}
        assert [_stands(rule, [box], doors) for box in (near, farther)] == [holds, False]


def test_what_is_not_there_holds_nothing_but_distance() -> None:
    assert not verdict({"type": "near", "of": "it"}, (2.0, 2.0, 0))
    assert verdict({"type": "far_from", "of": "it"}, (2.0, 2.0, 0))
