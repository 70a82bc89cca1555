"""Rooms that are no rectangle are furnished as rectangles are: clean, and with all they need, or with a proof that they cannot."""

from __future__ import annotations

from dataclasses import replace

import pytest

from solver import reroll
from solver.pipeline.own_plan import furnish
from solver.scene import Opening, Room, Scene
from tests.pipeline.stepped_rooms import stepped_room
from tests.sweeps import pairs, seeds

PROVEN = "cannot stand"
"""In the reason for a required piece that is missing."""


def test_random_rooms_of_any_outline_are_clean_and_complete_or_proven_too_small() -> None:
    wanted = seeds(range(2000), 25)
    whole = 0
    for seed in wanted:
        room = stepped_room(seed)
        made = furnish(Scene(wall_thickness=0.1, rooms=(room,)), seed=seed, style="modern")
        assert [(seed, issue.message) for issue in made.issues if issue.severity == "error"] == []
        missing = [issue.message for issue in made.issues if issue.rule == "missing_required"]
        assert [(seed, message) for message in missing if PROVEN not in message] == []
        whole += not missing
    assert whole >= 0.96 * len(wanted)


@pytest.mark.parametrize("scale", [1.0, 1.000373])
def test_a_door_in_an_inner_wall_is_come_in_by(scale: float) -> None:
    """The door of an L in the side of its notch: the way into the room begins at that wall, also where it lies between millimetres."""
    rooms = [_scaled(stepped_room(seed), scale) for seed in range(200)]
    inner = [k for k, room in enumerate(rooms) if _is_inner(room.outline or (), room.openings[0].edge or 0)]
    assert len(inner) > 40
    for seed in inner[::12]:
        made = furnish(Scene(wall_thickness=0.1, rooms=(rooms[seed],)), seed=seed)
        assert [(seed, issue.message) for issue in made.issues if issue.severity == "error"] == []


def _scaled(room: Room, scale: float) -> Room:
    corners = tuple((x * scale, z * scale) for x, z in room.outline or ())
    return replace(room, width=room.width * scale, depth=room.depth * scale, outline=corners)


def _is_inner(corners: tuple[tuple[float, float], ...], edge: int) -> bool:
    (x0, z0), (x1, _) = corners[edge], corners[(edge + 1) % len(corners)]
    axis, at = (0, x0) if x0 == x1 else (1, z0)
    along = [corner[axis] for corner in corners]
    return at not in (min(along), max(along))


def _halves(neck: float, kind: str, second_leads_out: bool) -> Scene:
    """A room of two halves between which only who is no wider than the neck can go, a door in each; beyond the second a storage room."""
    low, high = 1.5 - neck / 2, 1.5 + neck / 2
    outline = ((0, 0), (3, 0), (3, low), (4, low), (4, 0), (7, 0), (7, 3), (4, 3), (4, high), (3, high), (3, 3), (0, 3))
    first = Opening("first", position=1.5, edge=11, connects_to="hall")
    second = Opening("second", position=1.5, edge=5, connects_to="store")
    out = Opening("out", wall="west", position=1.5, connects_to="EXTERIOR")
    hall = (replace(first, edge=None, wall="east"), *(() if second_leads_out else (out,)))
    store = (replace(second, edge=None, wall="west"), *((replace(out, wall="east"),) if second_leads_out else ()))
    rooms = (
        Room("hall", type="hallway", width=2.0, depth=3.0, openings=hall),
        Room("halves", type=kind, x=2.0, width=7.0, depth=3.0, outline=outline, openings=(first, second)),
        Room("store", type="storage", x=9.0, width=2.0, depth=3.0, openings=store),
    )
    return Scene(wall_thickness=0.1, rooms=rooms)


@pytest.mark.parametrize(("kind", "second_leads_out"), pairs(["bedroom", "living_room", "kitchen", "office"], [False, True]))
def test_where_the_doors_of_a_room_are_not_joined_all_can_be_used_from_that_by_which_one_comes_in(
    kind: str, second_leads_out: bool
) -> None:
    """Nobody can walk from door to door, even in the empty room: no ways at all were asked for, and pieces stood out of reach."""
    plan = _halves(0.5, kind, second_leads_out)
    for made in (furnish(plan, rooms=["halves"], decorate=True, seed=1), reroll(plan, ["halves"], seed=2)):
        pieces = made.scene.rooms[1].furniture
        assert len(pieces) >= 3
        assert [issue.message for issue in made.issues if issue.severity == "error" and issue.ids] == []
