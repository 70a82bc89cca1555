"""Rooms that are no rectangle are furnished as rectangles are: clean, and with all they need, or with a proof that they cannot."""

from __future__ import annotations

from solver.pipeline.own_plan import furnish
from solver.scene import Scene
from tests.pipeline.stepped_rooms import stepped_room
from tests.sweeps import seeds

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


def test_a_door_in_an_inner_wall_is_come_in_by() -> None:
    """The door of an L in the side of its notch: the way into the room begins at that wall, not at the outermost one."""
    rooms = [stepped_room(seed) for seed in range(200)]
    inner = [k for k, room in enumerate(rooms) if _is_inner(room.outline or (), room.openings[0].edge or 0)]
    assert len(inner) > 40
    for seed in inner[::6]:
        made = furnish(Scene(wall_thickness=0.1, rooms=(rooms[seed],)), seed=seed)
        assert [(seed, issue.message) for issue in made.issues if issue.severity == "error"] == []


def _is_inner(corners: tuple[tuple[float, float], ...], edge: int) -> bool:
    (x0, z0), (x1, _) = corners[edge], corners[(edge + 1) % len(corners)]
    axis, at = (0, x0) if x0 == x1 else (1, z0)
    along = [corner[axis] for corner in corners]
    return at not in (min(along), max(along))
