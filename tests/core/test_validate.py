"""The core's validate stage: nonsense is refused, a hostile room comes to an end, and areas larger than 64 bits are exact."""

from __future__ import annotations

from random import Random

import pytest

from catalogs import load_catalogs
from solver.core import CoreFailed, ask
from solver.scene import Decoration, Furniture, Room, Scene
from solver.validator import metrics, validate
from solver.validator.kinds import kinds_of
from solver.validator.sent_rooms import room_bytes
from solver.validator.world import world_of

KNOWN = load_catalogs()
BED = Furniture("bed", "double_bed", x=2.0, z=1.3, width=1.6, depth=2.0, height=0.5)


def sent(*furniture: Furniture) -> bytes:
    """A room as the core reads it."""
    world = world_of(Scene(rooms=(Room("room", width=4.0, depth=4.0, furniture=furniture),)))
    return room_bytes(world, world.places[0], kinds_of(KNOWN))


def test_a_room_is_answered_with_rows() -> None:
    assert ask("judge_room", sent(BED)) == b""
    assert len(ask("judge_room", sent(BED, BED))) > 0


@pytest.mark.parametrize("export", ["judge_room", "walk_storey", "free_floors", "measure_storey"])
def test_what_ends_early_is_refused_and_the_next_is_answered(export: str) -> None:
    whole = sent(BED)
    for size in (0, 8, 80, 200):
        with pytest.raises(CoreFailed, match="the request is none"):
            ask(export, whole[:size])
    assert ask("judge_room", whole) == b""


def test_bytes_that_are_changed_end_the_call_or_are_answered() -> None:
    chance, whole = Random(1), sent(BED)
    refused = 0
    for _ in range(60):
        at = 8 * chance.randrange(5, 11)  # the header's counts
        changed = whole[:at] + chance.randbytes(8) + whole[at + 8 :]
        try:
            ask("judge_room", changed)
        except CoreFailed:
            refused += 1
    assert refused > 50
    assert ask("judge_room", whole) == b""


def test_no_length_is_beyond_a_million_kilometres() -> None:
    far = Furniture("far", "double_bed", x=1e10, z=1.0, width=1.0, depth=1.0, height=1.0)
    with pytest.raises(CoreFailed, match="the request is none"):
        validate(Scene(rooms=(Room("room", width=4.0, depth=4.0, furniture=(far,)),)), KNOWN)


def test_a_thousand_things_that_carry_each_other_come_to_an_end() -> None:
    def thing(number: int, parent: int) -> Decoration:
        return Decoration(f"book_{number}", "book", f"book_{parent}", None, 2.0, 0.5, 2.0, 0, 0.2, 0.2, 0.03)

    in_a_circle = tuple(thing(number, (number + 1) % 1000) for number in range(1000))
    found = validate(Scene(rooms=(Room("room", width=4.0, depth=4.0, decorations=in_a_circle),)), KNOWN)
    assert sum(issue.rule == "floating" and "nothing carries it" in issue.message for issue in found) == 1000


def test_areas_of_a_plain_are_exact() -> None:
    """Its square steps take 72 bits."""
    corners = ((0.0, 0.0), (16_000.0, 0.0), (16_000.0, 16_000.25), (0.0, 16_000.25))
    plain = Scene(rooms=(Room("plain", width=16_000.0, depth=16_000.25, outline=corners),))
    assert metrics(plain)["area"] == 16_000.0 * 16_000.25
