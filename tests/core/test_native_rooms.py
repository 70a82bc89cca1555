"""Rooms made by the core as it is built, and by a native build that checks every index and traps at undefined behaviour."""

from __future__ import annotations

from math import inf

import pytest

from solver.core import CoreFailed, borrowed
from solver.placement import ROOM_WORK
from tests.core.native import Native
from tests.furnish.wanting_rooms import wanting_room
from tests.sweeps import seeds


def request(seed: int) -> tuple[bytes, bytes]:
    """Returns a random room that is to be made, as rows."""
    rows = wanting_room(seed).rows()
    return rows.type_rows, rows.room_rows


def answer(known: bytes, room: bytes) -> bytes:
    """Returns what the core as it is built says."""
    with borrowed() as core:
        sent = core.send([room])
        core.call("make_rooms", core.send([known]), core.write(bytes(4)), sent, 1, 1, ROOM_WORK, inf)
        return core.told(sent, 1)[0][1]


def test_checked_and_as_built_agree_to_the_last_bit(native: Native) -> None:
    asked = [request(seed) for seed in seeds(range(600), 13)]
    assert native.answers("make_room", asked) == b"".join(answer(*one) for one in asked)


@pytest.mark.parametrize("size", [0, 60, -24, -8])
def test_bytes_that_are_cut_off_are_refused(size: int) -> None:
    known, room = request(3)
    with pytest.raises(CoreFailed, match="the request is none"):
        answer(known, room[:size])
