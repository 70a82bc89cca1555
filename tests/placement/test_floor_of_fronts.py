"""The floor that fronts open over lies before its piece and not within it, whichever wall the piece stands at."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver.furnish import space_of, wanted_pieces
from solver.pieces import Piece
from solver.placement import place
from solver.streams import Stream
from tests.furnish.worlds import den

KNOWN = load_catalogs()
STANDS = 7.0
"""What the floor costs here where it stands."""


def kitchen() -> tuple[Piece, ...]:
    room = replace(den(width=5.0, depth=4.0), type="kitchen")
    return wanted_pieces(room, space_of(room, 0.1, 0.6), KNOWN, Stream(1, "furnish", 0))


@pytest.mark.parametrize("wall", ["north", "east", "south", "west"])
@pytest.mark.parametrize("label", ["stove_1", "counter_1", "sink_1", "refrigerator_1"])
def test_a_piece_and_the_floor_before_it_stand_alone_in_a_room(label: str, wall: str) -> None:
    space = space_of(den(width=5.0, depth=4.0), 0.1, 0.6)
    pieces = {piece.label: piece for piece in kitchen()}
    floor = pieces[f"floor opened over at the front of {label}"]
    way = next(one for one in pieces[label].candidates if one.wall == wall)
    strips = tuple(replace(one, cost=STANDS) for one in floor.candidates if one.attach and one.attach.parent_kind == way.kind)
    found = place(
        [
            (
                space,
                (replace(pieces[label], candidates=(replace(way, cost=0.0),), links=()), replace(floor, candidates=strips, required=True)),
            )
        ]
    )
    assert found[0].cost >= STANDS
