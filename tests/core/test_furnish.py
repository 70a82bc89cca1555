"""The core's furnish stage: bit for bit what the reference says, over our room types and random ones; and what it does with nonsense."""

from __future__ import annotations

import struct
from dataclasses import fields, is_dataclass
from hashlib import sha256
from random import Random
from typing import Any

import pytest

from catalogs import load_catalogs
from catalogs.schema import Catalogs
from solver.core import CoreFailed
from solver.furnish import space_of, wanted_pieces
from solver.furnish.compiled_types import compiled_type
from solver.furnish.core_rows import room_rows
from solver.scene import Room
from solver.streams import Stream
from tests.core.test_native_furnish import answer
from tests.furnish.random_types import WORDS, for_small_rooms, random_room, random_type
from tests.furnish.reference import stage
from tests.furnish.worlds import catalog
from tests.sweeps import seeds

KNOWN = load_catalogs()
GOLDEN = "50ab24b0955514f91abbd1aa34c5c9696f1cf2f22c28a43af25c2fcaa4648f9c"
"""Of 20 rooms of random types of the hand-made kinds, recorded from the Python stage."""


def bits(value: Any) -> Any:
    """Returns a value such that two are equal only where types and all bits of floats are."""
    if isinstance(value, float):
        return struct.pack("<d", value)
    if is_dataclass(value):
        return type(value).__name__, *(bits(getattr(value, field.name)) for field in fields(value))
    if isinstance(value, tuple):
        return type(value).__name__, *map(bits, value)
    return type(value).__name__, value


def both(room: Room, catalogs: Catalogs, seed: int) -> tuple[Any, Any]:
    """Returns what a room wants by the core and by the reference, each with where it left the stream."""
    mine, theirs = Stream(seed, "furnish", room.type), Stream(seed, "furnish", room.type)
    space = space_of(room, 0.1)
    return (bits(wanted_pieces(room, space, catalogs, mine)), mine.state), (
        bits(stage.wanted_pieces(room, space, catalogs, theirs)),
        theirs.state,
    )


@pytest.mark.parametrize("name", sorted(KNOWN.rooms))
def test_our_room_types_are_furnished_as_by_the_reference(name: str) -> None:
    for seed in seeds(range(40), 27):
        core, reference = both(random_room(Random(f"{name} {seed}"), name), KNOWN, seed)
        assert core == reference, seed


@pytest.mark.parametrize("block", range(4))
def test_random_room_types_are_furnished_as_by_the_reference(block: int) -> None:
    wanted = 0
    for seed in seeds(range(400), 41):
        rng = Random(f"{block} {seed}")
        catalogs = KNOWN.model_copy(update={"rooms": {"den": for_small_rooms(Random(seed), random_type(rng, KNOWN))}})
        core, reference = both(random_room(rng, "den"), catalogs, seed)
        assert core == reference, seed
        wanted += len(reference[0]) - 1
    assert wanted > 0


def test_what_twenty_rooms_want_is_what_they_wanted_when_the_stage_moved() -> None:
    digest, few = sha256(), catalog([])
    for seed in range(20):
        rng = Random(f"golden {seed}")
        room, known = random_room(rng, "den"), few.model_copy(update={"rooms": {"den": random_type(rng, few, WORDS[:17])}})
        digest.update(repr(bits(wanted_pieces(room, space_of(room, 0.1), known, Stream(seed, "furnish", "den")))).encode())
    assert digest.hexdigest() == GOLDEN


def request(name: str, seed: int = 1) -> tuple[bytes, bytes]:
    room = random_room(Random(seed), name)
    space = space_of(room, 0.1)
    return compiled_type(KNOWN.rooms[name], KNOWN).data, room_rows(room, space, room.floor_m2, seed)


@pytest.mark.parametrize("name", ["kitchen", "living_room", "dining_room"])
def test_bytes_that_are_spoiled_end_in_an_answer_or_a_refusal(name: str) -> None:
    rng, refused = Random(name), 0
    known, room = request(name)
    for _ in range(150):
        spoiled = [bytearray(known), bytearray(room)]
        for _ in range(rng.randint(1, 4)):
            part = rng.choice(spoiled)
            part[rng.randrange(len(part))] = rng.randrange(256)
        try:
            answer(bytes(spoiled[0]), bytes(spoiled[1]))
        except CoreFailed:
            refused += 1
    assert 0 < refused < 150
    assert len(answer(known, room)) > 24


@pytest.mark.parametrize("size", [0, 3, 63, 64, 200])
def test_bytes_that_are_cut_off_are_refused(size: int) -> None:
    known, room = request("bedroom")
    with pytest.raises(CoreFailed, match="the request is none"):
        answer(known[:size], room)
    with pytest.raises(CoreFailed, match="the request is none"):
        answer(known, room[:size] if size < len(room) else b"")


def test_a_type_without_pieces_and_a_room_without_floor_want_nothing_or_little() -> None:
    empty = KNOWN.rooms["bedroom"].model_copy(update={"pieces": ()})
    room = Room("r", 0, "bedroom", width=4.0, depth=3.0)
    assert wanted_pieces(room, space_of(room, 0.1), KNOWN.model_copy(update={"rooms": {"bedroom": empty}}), Stream(1, "x")) == ()
    for name in sorted(KNOWN.rooms):
        core, reference = both(Room("r", 0, name, width=0.001, depth=900.0), KNOWN, 1)
        assert core == reference


def test_many_openings_and_many_copies_are_furnished_as_by_the_reference() -> None:
    crowded = random_room(Random(1), "den")
    openings = tuple(opening for seed in range(120) for opening in random_room(Random(seed), "den").openings)
    pieces = [{"piece": f"piece_{i}", "kinds": [{"kind": "dining_chair"}], "count": 24} for i in range(4)]
    pieces += [{"piece": "table", "kinds": [{"kind": "dining_table"}], "count": 24}]
    pieces += [
        {"piece": "seat", "kinds": [{"kind": "dining_chair"}], "count": 24, "rules": [{"type": "around", "of": "table", "gap": -0.15}]}
    ]
    asked_for = {"area": {"min": (4, 4), "typical": 12, "max": 60}, "flooring": "wood", "accent": "#808080", "pieces": pieces}
    den = type(KNOWN.rooms["bedroom"]).model_validate(asked_for)
    room = Room("r", 0, "den", width=crowded.width + 9, depth=crowded.depth + 9, openings=openings)
    core, reference = both(room, KNOWN.model_copy(update={"rooms": {"den": den}}), 1)
    assert len(reference[0]) == 1 + 24 * (
        6 + len(KNOWN.furniture["dining_table"].comfort) + 5 * len(KNOWN.furniture["dining_chair"].comfort)
    )
    assert core == reference
