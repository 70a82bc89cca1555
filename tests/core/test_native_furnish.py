"""Rooms furnished by the core as it is built, and by a native build that checks every index and traps at undefined behaviour."""

from __future__ import annotations

from random import Random

from catalogs import load_catalogs
from solver.core import borrowed
from solver.furnish import space_of
from solver.furnish.compiled_types import compiled_type
from solver.furnish.core_rows import room_rows
from tests.core.native import Native
from tests.furnish.random_types import random_room, random_type
from tests.sweeps import seeds

KNOWN = load_catalogs()


def request(seed: int) -> tuple[bytes, bytes]:
    """Returns a random room, of one of our types or of a random one, as rows."""
    rng = Random(f"native {seed}")
    room = random_room(rng, rng.choice(sorted(KNOWN.rooms)))
    room_type = KNOWN.rooms[room.type] if seed % 2 else random_type(rng, KNOWN)
    space = space_of(room, 0.1)
    return compiled_type(room_type, KNOWN).data, room_rows(room, space, room.floor_m2, seed)


def answer(known: bytes, room: bytes) -> bytes:
    """Returns what the core as it is built says."""
    with borrowed() as core:
        packed = core.call("furnish", core.write(known), len(known), core.write(room), len(room))
        return core.read(packed & 0xFFFFFFFF, packed >> 32)


def test_checked_and_as_built_agree_to_the_last_bit(native: Native) -> None:
    asked = [request(seed) for seed in seeds(range(1200), 9)]
    assert native.answers("furnish", asked) == b"".join(answer(*one) for one in asked)
