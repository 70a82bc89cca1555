"""The core's validate stage: nonsense is refused, a hostile room comes to an end, and areas larger than 64 bits are exact."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from random import Random
from struct import Struct
from unittest import mock

import pytest

from catalogs import load_catalogs
from solver.core import CoreFailed, CoreInstance, ask
from solver.demanded import demanding_at_most
from solver.errors import SceneError, TooMuch
from solver.scene import Decoration, Furniture, Room, Scene
from solver.validator import metrics, validate
from solver.validator.kinds import kinds_of
from solver.validator.sent_rooms import Floors, NumberedKinds, room_bytes, storey_bytes
from solver.validator.world import world_of

KNOWN = load_catalogs()
FINDING, COUNT = Struct("<8q"), Struct("<q")
FIRST_ROOM = Struct("<q").pack(0)
"""The first room of a storey is to be judged."""
FLOOR_AND_AREAS, TOLD_OF_ROOM = 40 + 32, 24
"""What is told of the floor of a storey with one room before what is found in this."""
ANY_NUMBER = 1 << 60
BED = Furniture("bed", "double_bed", x=2.0, z=1.3, width=1.6, depth=2.0, height=0.5)


def sent(*furniture: Furniture) -> bytes:
    """A storey of one room as the core reads it."""
    world = world_of(Scene(rooms=(Room("room", width=4.0, depth=4.0, furniture=furniture),)))
    kinds = NumberedKinds(kinds_of(KNOWN))
    return storey_bytes(world, [(world.places[0], room_bytes(world, world.places[0], kinds))], kinds, Floors((), 400, 0))


def judged(rows: bytes, most: int = ANY_NUMBER) -> list[tuple[int, ...]]:
    """What the core finds in the room."""
    told = ask("judge_storey", rows, FIRST_ROOM, numbers=[most, ANY_NUMBER])
    (count,) = COUNT.unpack_from(told, FLOOR_AND_AREAS)
    return [FINDING.unpack_from(told, FLOOR_AND_AREAS + TOLD_OF_ROOM + FINDING.size * number) for number in range(count)]


def in_one_place(count: int) -> bytes:
    """A room with beds that all share space."""
    return sent(*(replace(BED, id=f"bed_{number}") for number in range(count)))


def test_a_room_is_answered_with_rows() -> None:
    assert judged(sent(BED)) == []
    assert len(judged(sent(BED, BED))) > 0


def test_all_pairs_are_told_in_order_or_one_more_than_may_be() -> None:
    rows, pairs = in_one_place(40), list(combinations(range(40), 2))
    for most in (len(pairs), ANY_NUMBER):
        assert [(first, second) for _, first, second, *_ in judged(rows, most)] == pairs
    for most in (0, 1, 100, len(pairs) - 1):
        assert len(judged(rows, most)) == most + 1


def test_thousands_of_bodies_in_one_place_take_no_more_memory_than_what_may_be_told() -> None:
    rows, most = in_one_place(4900), 1000
    core = CoreInstance()
    asked = core.write(FIRST_ROOM)
    told = core.call("judge_storey", core.write(rows), len(rows), asked, len(FIRST_ROOM), most, ANY_NUMBER)
    assert told >> 32 == FLOOR_AND_AREAS + TOLD_OF_ROOM + FINDING.size * (most + 1) + 4900
    assert core.size < 16 << 20
    beds = tuple(replace(BED, id=f"bed_{number}") for number in range(4900))
    with demanding_at_most(50_000), pytest.raises(TooMuch):
        validate(Scene(rooms=(Room("room", width=4.0, depth=4.0, furniture=beds),)), KNOWN)


@pytest.mark.parametrize("export", ["judge_storey", "free_floors", "measure_storey"])
def test_what_ends_early_is_refused_and_the_next_is_answered(export: str) -> None:
    whole, is_judging = sent(BED), export == "judge_storey"
    for size in (0, 8, 80, 200):
        with pytest.raises(CoreFailed, match="the request is none"):
            ask(export, whole[:size], *([FIRST_ROOM] if is_judging else []), numbers=[ANY_NUMBER, ANY_NUMBER] if is_judging else [])
        if is_judging and size:
            with pytest.raises(CoreFailed, match="the request is none"):
                ask(export, whole, FIRST_ROOM[: size // 40 + 1], numbers=[ANY_NUMBER, ANY_NUMBER])
    assert judged(whole) == []


def test_bytes_that_are_changed_end_the_call_or_are_answered() -> None:
    chance, whole = Random(1), sent(BED)
    refused = 0
    for _ in range(60):
        at = 8 * chance.randrange(3, 8)  # the counts in the storey's header
        changed = whole[:at] + chance.randbytes(8) + whole[at + 8 :]
        try:
            judged(changed)
        except CoreFailed:
            refused += 1
    assert refused > 50
    assert judged(whole) == []


def test_no_length_is_beyond_a_million_kilometres() -> None:
    far = Furniture("far", "double_bed", x=1e10, z=1.0, width=1.0, depth=1.0, height=1.0)
    scene = Scene(rooms=(Room("room", width=4.0, depth=4.0, furniture=(far,)),))
    with pytest.raises(SceneError, match="x: is 10000000000"):
        validate(scene, KNOWN)
    with mock.patch("solver.understanding.check_scene"), pytest.raises(CoreFailed, match="the request is none"):
        validate(scene, KNOWN)


def test_a_thousand_things_that_carry_each_other_come_to_an_end() -> None:
    def thing(number: int, parent: int) -> Decoration:
        x, y = 0.2 + 0.3 * (number % 12), 0.03 * (number // 12)  # apart: of half a million that overlap it would take long to tell
        return Decoration(f"book_{number}", "book", f"book_{parent}", None, x, y, 2.0, 0, 0.2, 0.2, 0.03)

    in_a_circle = tuple(thing(number, (number + 1) % 1000) for number in range(1000))
    found = validate(Scene(rooms=(Room("room", width=4.0, depth=4.0, decorations=in_a_circle),)), KNOWN)
    assert sum(issue.rule == "floating" and "nothing carries it" in issue.message for issue in found) == 1000


def test_areas_of_a_plain_are_exact() -> None:
    """Its square steps take 72 bits."""
    corners = ((0.0, 0.0), (16_000.0, 0.0), (16_000.0, 16_000.25), (0.0, 16_000.25))
    plain = Scene(rooms=(Room("plain", width=16_000.0, depth=16_000.25, outline=corners),))
    assert metrics(plain)["area"] == 16_000.0 * 16_000.25
