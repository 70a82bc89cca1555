"""A slice of the 2,000 dense rooms: valid, walkable, everything required there, and as full as people's rooms."""

from __future__ import annotations

import statistics

import pytest

from solver.geometry import Rect
from solver.pieces import Arrangement, Candidate, Placed
from tests.dense.__main__ import COVER, jobs
from tests.dense.furnishing import catalogs, covered, result, tight
from tests.dense.rooms import KINDS, dense_room

ROOMS = 24
TIGHT = 16
SPREAD = 0.04
"""How far below the median of 500 rooms that of six may lie."""


@pytest.mark.parametrize("name", sorted(KINDS))
def test_dense_rooms_are_valid_walkable_complete_and_full(name: str) -> None:
    rooms = [result(job) for job in jobs(ROOMS) if job[0] == name]
    assert [(room.seed, room.faults) for room in rooms if room.faults] == []
    assert [room.seed for room in rooms if not room.walkable] == []
    assert [room.seed for room in rooms if not room.required] == []
    assert statistics.median(room.cover for room in rooms) >= COVER[name] - SPREAD


def test_the_verdict_on_tight_rooms_is_the_oracles() -> None:
    rooms = [tight(job) for job in jobs(TIGHT)]
    assert [room for room in rooms if room.oracle is not None and room.ours != room.oracle] == []
    assert {room.oracle for room in rooms} == {True, False}


def test_the_rooms_keep_their_ranges() -> None:
    for name, kind in KINDS.items():
        rooms = [dense_room(name, seed) for seed in range(200)]
        areas = [room.width * room.depth for room in rooms]
        assert kind.dense[0] - 0.05 <= min(areas) and max(areas) <= kind.dense[1] + 0.05
        assert min(min(room.width, room.depth) for room in rooms) >= 1.99
        assert max(max(room.width, room.depth) / min(room.width, room.depth) for room in rooms) <= 1.62
        doors = {sum(opening.kind == "door" for opening in room.openings) for room in rooms}
        assert doors == ({1} if name == "bathroom" else {1, 2})


def test_the_catalog_requires_what_it_places_as_required() -> None:
    for kind in KINDS.values():
        room_type = catalogs().rooms[kind.room_type]
        required = sum(piece.required and not piece.without for piece in room_type.pieces)
        assert required == len(room_type.requires)


def test_what_two_pieces_cover_counts_once() -> None:
    chosen = Candidate("box", (1000, 1000, 500), 0)
    rects = [Rect(0, 0, 1000, 1000), Rect(500, 0, 1500, 1000), Rect(3000, 0, 4000, 1000), Rect(3000, 1000, 4000, 1500)]
    placed = tuple(Placed(str(k), chosen, 0, None, rect) for k, rect in enumerate(rects))
    assert covered(Arrangement("room", placed)) == 1.5 + 1.5
