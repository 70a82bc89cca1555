"""The core's decorations: what it made when it was moved from Python, and what it does with nonsense."""

from __future__ import annotations

from dataclasses import replace
from hashlib import sha256
from random import Random

import pytest

from catalogs import load_catalogs
from solver.core import CoreFailed
from solver.decorations import BareRoom, decorated_rooms
from solver.furnish import space_of
from solver.streams import Stream
from tests.core.test_native_decorate import answer, request
from tests.decorations.random_rooms import furnished, random_decorating, random_settings, settings_named

KNOWN = load_catalogs()
GOLDEN = "d77e2c9e83aec9fe69fe950d62e54f835e94001dfc7ea4c435e60139164747ed"
"""Of 300 random rooms, half of them decorated at random, recorded when what belongs beside a piece stood nowhere without it."""


def test_random_rooms_are_decorated_as_they_always_were() -> None:
    digest, things = sha256(), 0
    for seed in range(300):
        settings = settings_named(f"golden dressing {seed // 10}")
        room, stream = furnished(Random(f"golden {seed}"), KNOWN), Stream(seed, "decorations", "golden")
        made = decorated_rooms([BareRoom(room, space_of(room, 0.1), stream)], settings)[0].decorations
        things += len(made)
        digest.update(repr(([replace(thing, kind=None) for thing in made], stream.state)).encode())
    assert things > 600
    assert digest.hexdigest() == GOLDEN


def test_random_decoratings_have_rows_of_every_sort() -> None:
    entries = random_decorating(Random("sorts"), KNOWN).values()
    assert {row.where for entry in entries for row in entry.stands} == {"middle", "corner", "beside", "wall", "free", "under"}
    assert {word for entry in entries for row in entry.holds for word in row.surface} == {"shelves", "drawers"}
    lies = [row for entry in entries for row in entry.lies]
    assert all(any(have(row) for row in lies) for have in (lambda row: row.at == "seats", lambda row: row.on, lambda row: row.fill))


@pytest.mark.parametrize("cut", [0, 8, 100])
def test_a_request_that_is_cut_off_is_refused(cut: int) -> None:
    known, room = request(3)
    for rows in ((known[:cut], room), (known, room[:cut])):
        with pytest.raises(CoreFailed, match="the request is none"):
            answer(*rows)


def test_rows_that_speak_of_what_is_not_there_are_refused() -> None:
    known, room = request(3)
    head, entry, ranges = 14 * 4, 10 * 4, 8 * 4
    for at in (head + entry * number + at for number in range(3) for at in range(0, ranges, 4)):
        with pytest.raises(CoreFailed):
            answer(known[:at] + (10**6).to_bytes(4, "little") + known[at + 4 :], room)


def test_a_room_too_small_to_stand_in_has_nothing_on_its_floor() -> None:
    room = replace(furnished(Random("small"), KNOWN), type="kids_bedroom", furniture=(), outline=None, width=0.12, depth=0.12)
    bare = BareRoom(room, space_of(room, 0.1), Stream(1, "decorations", 0))
    made = decorated_rooms([bare], random_settings(Random(1), KNOWN))[0].decorations
    assert [thing for thing in made if thing.mounted_on_wall is None] == []
