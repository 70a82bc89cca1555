"""One pose for somebody in a room: standing, sitting, or a pet's.

Comes in: a `Floor` and somebody without a place. Goes out: the same with a place, or None. May import: the ground floor, catalogs.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from catalogs.entries import Surface
from solver.free_places import Solid, footprint
from solver.geometry import rotate
from solver.people.floor import Floor
from solver.people.sights import Sight, faces, sights
from solver.scene import Dynamic, Furniture
from solver.streams import Stream

TRIES: Final = 40
"""Wishes that are tried; after half of them nobody asks for a gap around any more."""
GAP_MM: Final = 60
"""What somebody likes to keep free around."""
TALKING: Final = (0.5, 1.4)
"""How far from a thing one stands to look at it, m, to one's middle."""
STEP: Final = 15
"""Degrees that people turn by."""
SEAT_HEIGHTS: Final = (0.35, 0.6)
"""A surface at these heights, m, is sat on."""
SITTING: Final = (0.46, 0.5, 0.9)
"""Shoulders, thighs and sitting height of somebody who sits, m: 95th, 50th and 50th percentile of men (S. Pheasant,
Bodyspace, 2nd edition, table 10.1, rounded)."""
CUSHION_MM: Final = 60
"""What lies on a seat and is no thicker is sat on."""
SEATS: Final = ("seating", "bed")


def standing(floor: Floor, person: Dynamic, stream: Stream) -> Dynamic | None:
    """Returns a person on free floor who faces something near, within reach and in nobody's way."""
    seen = sights(floor.room, floor.space, floor.catalogs)
    for k in range(TRIES if seen else 0):
        sight = stream.pick(seen)
        wish = _before(sight, person, stream)
        placed = floor.near(wish, GAP_MM if k < TRIES // 2 else 0)
        if placed and faces(placed, sight) and floor.leaves_all_reachable(placed):
            return placed
    return None


def _before(sight: Sight, person: Dynamic, stream: Stream) -> Dynamic:
    """Returns a person somewhere before a thing, turned to its middle."""
    rect, away = sight.rect, stream.uniform(*TALKING)
    along = stream.uniform(-0.2, 1.2)
    x, z = rect.x0 + along * rect.width, rect.z0 + along * rect.depth
    x = {"west": rect.x0 - 1000 * away, "east": rect.x1 + 1000 * away}.get(sight.seen_from, x)
    z = {"north": rect.z0 - 1000 * away, "south": rect.z1 + 1000 * away}.get(sight.seen_from, z)
    turn = math.degrees(math.atan2((rect.x0 + rect.x1) / 2 - x, (rect.z0 + rect.z1) / 2 - z))
    return replace(person, x=round(x) / 1000, z=round(z) / 1000, rotation=round(turn / STEP) * STEP % 360)


def roaming(floor: Floor, pet: Dynamic, stream: Stream) -> Dynamic | None:
    """Returns a pet somewhere on free floor, within reach and in nobody's way."""
    clear = floor.space.clear
    for k in range(TRIES):
        x, z = stream.uniform(clear.x0, clear.x1), stream.uniform(clear.z0, clear.z1)
        turn = STEP * stream.below(360 // STEP)
        wish = replace(pet, x=round(x) / 1000, z=round(z) / 1000, rotation=turn)
        placed = floor.near(wish, GAP_MM if k < TRIES // 2 else 0)
        if placed and floor.leaves_all_reachable(placed):
            return placed
    return None


def sitting(floor: Floor, person: Dynamic, stream: Stream) -> Dynamic | None:
    """Returns a person who sits on a seat or at the end of a bed, whose front can be reached."""
    seats = [(piece, seat) for piece in floor.room.furniture if (seat := _seat(floor, piece))]
    stream.shuffle(seats)
    for piece, seat in seats:
        for across in _places(piece, seat, stream):
            for behind in (seat.inset, 0.0):  # at the very edge before what leans on the back
                placed = _seated(person, piece, seat, (across, behind))
                if _fits(floor, placed, piece) and floor.front_reachable(piece):
                    return placed
    return None


def _seat(floor: Floor, piece: Furniture) -> Surface | None:
    """Returns what somebody can sit on of a piece; nobody sits on a chair that is tucked in, or on one that stands on something."""
    if piece.category not in SEATS or piece.under or piece.on or piece.y or piece.rotation % 90:
        return None
    kinds = floor.catalogs.furniture
    sizes = (piece.width, piece.depth, piece.height)
    kind = next((kind for name, kind in kinds.items() if floor.catalogs.name_of(name) == piece.name and kind.size == sizes), None)
    surfaces = kind.surfaces if kind else ()
    low, high = SEAT_HEIGHTS
    return next((one for one in surfaces if low <= one.height <= high and one.clearance is None), None)


def _places(piece: Furniture, seat: Surface, stream: Stream) -> Sequence[int]:
    """Returns middles across a seat to try, mm: one at random, then from end to end."""
    room = round((piece.width - 2 * seat.inset - SITTING[0]) * 1000) // 2
    if room <= 0:
        return (0,)
    ends = [-room, room, 0, -room // 2, room // 2]
    stream.shuffle(ends)
    return [round(stream.uniform(-room, room) / 50) * 50 if abs(room) > 50 else 0, *ends]


def _seated(person: Dynamic, piece: Furniture, seat: Surface, place: tuple[int, float]) -> Dynamic:
    """Returns a person on a seat, within the piece's footprint: so far across (mm), so far behind its front edge (m)."""
    across, behind = place
    width, depth = min(SITTING[0], piece.width), min(SITTING[1], piece.depth)
    along = max(0, round((piece.depth / 2 - behind - depth / 2) * 1000), round((depth - piece.depth) * 500))
    x, z = rotate(across, along, round(piece.rotation))
    centre = (round(piece.x + x / 1000, 4), round(piece.z + z / 1000, 4))
    return replace(
        person, x=centre[0], y=round(piece.y + seat.height, 4), z=centre[1], rotation=piece.rotation,
        width=width, depth=depth, height=SITTING[2], on=piece.id,
    )  # fmt: skip


def _fits(floor: Floor, placed: Dynamic, piece: Furniture) -> bool:
    low = round(placed.y * 1000)
    body = Solid(footprint(placed), low + CUSHION_MM, low + placed.height * 1000)
    return floor.is_free(body, frozenset({piece.id}))
