"""Rooms decorated by the core as it is built, and by a native build that checks every index and traps at undefined behaviour."""

from __future__ import annotations

from random import Random

from catalogs import load_catalogs
from solver.core import borrowed
from solver.decorations.decorating import compiled_decorating, decorated_rows
from solver.furnish import space_of
from tests.core.native import Native
from tests.decorations.random_rooms import furnished, settings_named
from tests.sweeps import seeds

KNOWN = load_catalogs()


def request(seed: int) -> tuple[bytes, bytes]:
    """Returns a random room decorated as ours are or at random, as rows."""
    settings = settings_named(f"native dressing {seed // 20}")
    room, known = furnished(Random(f"native {seed}"), KNOWN), compiled_decorating(settings)
    return known.data, decorated_rows(room, space_of(room, 0.1), known, settings, seed)


def answer(known: bytes, room: bytes) -> bytes:
    """Returns what the core as it is built says."""
    with borrowed() as core:
        sent = core.send([room])
        core.call("decorate", core.write(known), len(known), sent, 1)
        return core.told(sent, 1)[0][1]


def test_checked_and_as_built_agree_to_the_last_bit(native: Native) -> None:
    asked = [request(seed) for seed in seeds(range(1200), 9)]
    assert native.answers("decorate", asked) == b"".join(answer(*one) for one in asked)
