"""Every sentence that the service says of homes is said in German too: in the page's table, read by other code than the page's."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest

from solver import Request, Scene, explain, fix, generate, validate
from solver.pipeline.reasons import at_limit
from tests.pipeline.test_fix import stirred
from tests.sweeps import seeds
from tests.told_forms import has_form

LOCKED, EXPLAINED = 6, 3
ASKED: list[dict[str, object]] = [
    {"program": "studio", "decorate": True},
    {"program": "family", "area": 60},
    {"program": "large", "width": 9.0, "depth": 8.0},
    {"program": "one_bed", "width": 14.0, "depth": 3.2, "access": "din_18040_2"},
    {"width": 8.0, "depth": 6.0, "decorate": True},
    {"width": 20.0, "depth": 4.0},
]


def said_of(scene: Scene) -> Iterator[str]:
    """All that a home's certificate says in sentences."""
    told: dict[str, Any] = dict(scene.certificate or {})
    yield from told.get("notes", ())
    yield from (told.get("access") or {}).get("unmet", ())
    for room in told.get("rooms", {}).values():
        yield from room.get("notes", ())
        yield from (left["reason"] for left in room.get("left_out", ()))


def disturbed(scene: Scene, seed: int) -> Scene:
    """A home in which furniture and things were thrown about."""
    drawn = random.Random(seed)
    thrown = stirred(scene, seed)
    rooms = []
    for room in thrown.rooms:
        moved = (replace(one, x=one.x + drawn.choice((0, 0.5)), y=one.y + drawn.choice((0, 0.1))) for one in room.decorations)
        rooms.append(replace(room, decorations=tuple(moved)))
    return replace(thrown, rooms=tuple(rooms))


def said_of_faults(scene: Scene, seed: int) -> Iterator[str]:
    """All that is said of a home that is not as it should be, and of mending it."""
    pieces = [piece.id for room in scene.rooms for piece in room.furniture]
    locked = random.Random(seed).sample(pieces, min(LOCKED, len(pieces)))
    yield from (issue.message for issue in validate(scene))
    yield from (conflict.message for conflict in fix(scene, locked=locked).conflicts)
    yield from (gone["reason"] for gone in fix(scene, locked=locked, on_conflict="remove").removed)


def said_of_places(scene: Scene, seed: int) -> Iterator[str]:
    """All that is said of why pieces stand where they do."""
    pieces = [piece.id for room in scene.rooms for piece in room.furniture]
    for piece in random.Random(seed).sample(pieces, min(EXPLAINED, len(pieces))):
        why = explain(scene, piece)
        yield from why.notes
        yield from (hold.message for hold in why.holds)
        yield from (way.message for way in why.ways)


@pytest.mark.parametrize("seed", seeds(range(700, 740), 40))
@pytest.mark.parametrize("asked", ASKED, ids=str)
def test_every_sentence_is_in_a_form(asked: dict[str, object], seed: int) -> None:
    scene = generate(Request(seed=seed, **asked)).scene  # type: ignore[arg-type]
    thrown = disturbed(scene, seed)
    said = {*said_of(scene), *said_of_faults(thrown, seed), *said_of_places(scene, seed)}
    assert said
    assert sorted(one for one in said if not has_form(one)) == []


def test_a_search_that_ended_at_its_limit_says_what_was_sought_and_what_may_help() -> None:
    """A bed is dragged into a kitchen where it can stand, but shuts ways."""
    home = generate(Request(seed=2, program="studio")).scene
    bed = next(piece for room in home.rooms for piece in room.furniture if piece.name == "bed")
    dropped = replace(bed, x=0.9, z=1.0, rotation=0, wall=None)
    rooms = []
    for room in home.rooms:
        others = tuple(piece for piece in room.furniture if piece is not bed)
        rooms.append(replace(room, furniture=(*others, dropped) if room.type == "kitchen" else others))
    conflicts = fix(replace(home, rooms=tuple(rooms)), moved=[bed.id]).conflicts
    first = next(one for one in conflicts if one.ids == (bed.id,))
    kitchen = next(room.id for room in home.rooms if room.type == "kitchen")
    name = f"bed {bed.width:.2f} x {bed.depth:.2f} m"
    assert first.message.startswith(f"not found: ways in {kitchen} by which somebody can get to {name}: it can stand there, but ")
    assert "with less in the room, or with it turned or smaller" in first.message
    assert {repair["action"] for repair in first.repairs} >= {"leave_out", "shrink"}


@pytest.mark.parametrize("walk", [False, True])
@pytest.mark.parametrize("where", ["", " in kitchen_2"])
def test_what_was_sought_is_said_in_german(walk: bool, where: str) -> None:
    assert has_form(at_limit("sofa 1.80 x 0.88 m", walk, where))
