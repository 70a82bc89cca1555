"""An arrangement against what was asked for, in exact integers.

Written from the rules of docs/scene.md and from the docstrings of solver/pieces.py. Comes in: a `Space`, the wanted pieces and the
arrangement. Goes out: what is wrong, in words; empty if nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations

from solver.geometry import Rect
from solver.pieces import LOOKS_AT, Arrangement, Link, Piece, Placed, Space, Stand
from tests.oracles.walk import missed, side_towards

AT_WALL_MM = 150
"""A piece said to stand at a wall is at most this far from its face: 0.2 m from the line of a wall 0.1 m thick (wall_far)."""
HEADROOM_MM = 2000
QUARTERS = {0: ((1, 0), (0, 1)), 90: ((0, -1), (1, 0)), 180: ((-1, 0), (0, -1)), 270: ((0, 1), (-1, 0))}
"""By rotation: the room's (x, z) of a body's right side and of its front. A quarter turn takes the front from south to east."""
BEHIND = {0: "north", 90: "west", 180: "south", 270: "east"}
FACING = {"north": "south", "south": "north", "east": "west", "west": "east"}


def faults(space: Space, wanted: Sequence[Piece], arrangement: Arrangement) -> list[str]:
    """Lists what is wrong with where the pieces stand; walking is `unreached`'s."""
    by_label = {piece.label: piece for piece in arrangement.placed}
    asked = {piece.label: piece for piece in wanted}
    found = list(_roll(wanted, arrangement))
    for piece in arrangement.placed:
        if piece.label in asked:
            found += _by_itself(space, asked[piece.label], piece)
            found += _with_parent(by_label, piece)
            found += _links(by_label, asked[piece.label], piece)
    for a, b in combinations(arrangement.placed, 2):
        found += _pair(a, b)
    return found


def _roll(wanted: Sequence[Piece], arrangement: Arrangement) -> Iterator[str]:
    """Every wanted piece is there once, placed or left out."""
    there = sorted([piece.label for piece in arrangement.placed] + [label for label, _ in arrangement.left_out])
    if there != sorted(piece.label for piece in wanted):
        yield f"placed and left out are {there}"


def _by_itself(space: Space, asked: Piece, piece: Placed) -> Iterator[str]:
    chosen, r = piece.chosen, piece.footprint
    if chosen not in asked.candidates:
        yield f"{piece.label} stands in a way that nobody asked for"
    wide, deep = chosen.size_mm[:2] if piece.rotation % 180 == 0 else chosen.size_mm[1::-1]
    if (r.x1 - r.x0, r.z1 - r.z0) != (wide, deep):
        yield f"{piece.label} has the wrong extents {r}"
    for name, box in (("the room", space.clear), ("where it must stay", chosen.within or space.clear)):
        if not (box.x0 <= r.x0 and r.x1 <= box.x1 and box.z0 <= r.z0 and r.z1 <= box.z1):
            yield f"{piece.label} leaves {name}: {r}"
    if chosen.attach is None and piece.rotation != chosen.rotation:
        yield f"{piece.label} is turned by {piece.rotation}"
    yield from _at_wall(space, piece)
    top = chosen.bottom_mm + chosen.size_mm[2]
    for zone in space.zones:
        if top > zone.above_mm and r.x0 < zone.rect.x1 and zone.rect.x0 < r.x1 and r.z0 < zone.rect.z1 and zone.rect.z0 < r.z1:
            yield f"{piece.label} stands in the zone of {zone.cause}"


def _at_wall(space: Space, piece: Placed) -> Iterator[str]:
    chosen, r, clear = piece.chosen, piece.footprint, space.clear
    if chosen.attach is None and piece.wall != chosen.wall:
        yield f"{piece.label} says it is at {piece.wall}, asked was {chosen.wall}"
    if piece.wall is None:
        return
    gaps = {"north": r.z0 - clear.z0, "south": clear.z1 - r.z1, "west": r.x0 - clear.x0, "east": clear.x1 - r.x1}
    low, high = (0, AT_WALL_MM)
    if chosen.attach is None:
        low, high = (space.gap_mm, space.gap_mm) if chosen.slack_mm is None else (0, chosen.slack_mm)
    if not low <= gaps[piece.wall] <= high:
        yield f"{piece.label} is {gaps[piece.wall]} mm from the {piece.wall} wall"


def _with_parent(placed: Mapping[str, Placed], piece: Placed) -> Iterator[str]:
    """Stands at its slot: the centres' difference in the parent's frame, doubled, to the half millimetre that odd sizes force."""
    attach = piece.chosen.attach
    if attach is None:
        return
    parent = placed.get(attach.parent)
    if parent is None or (parent.chosen.kind, parent.chosen.stance) != (attach.parent_kind, attach.parent_stance):
        yield f"{piece.label} is attached to {attach.parent}, which is not there as {attach.parent_kind}"
        return
    if (parent.rotation + piece.chosen.rotation - piece.rotation) % 360:
        yield f"{piece.label} is turned by {piece.rotation} at a parent turned by {parent.rotation}"
    a, b = parent.footprint, piece.footprint
    off = (b.x0 + b.x1 - a.x0 - a.x1, b.z0 + b.z1 - a.z0 - a.z1)
    for axis, name, (least, most) in zip(QUARTERS[parent.rotation], ("across", "along"), (attach.across_mm, attach.along_mm), strict=True):
        value = off[0] * axis[0] + off[1] * axis[1]
        if not 2 * least - value % 2 <= value <= 2 * most + value % 2:
            yield f"{piece.label} is {value / 2} mm {name} from {attach.parent}, asked were {least} to {most}"
    for other in placed.values():
        theirs = other.chosen.attach
        same = theirs is not None and (theirs.parent, theirs.slot) == (attach.parent, attach.slot)
        if attach.slot and same and other.label < piece.label:
            yield f"{piece.label} and {other.label} take one slot"


def _looks_at(piece: Placed, other: Placed) -> bool:
    """Tells whether the other's anchor lies before a piece's front, no farther aside than ahead."""
    dx, dz = (theirs - own for own, theirs in zip(piece.chosen.anchor_mm, other.chosen.anchor_mm, strict=True))
    aside, ahead = (x * dx + z * dz for x, z in QUARTERS[piece.rotation])
    return ahead > 0 and abs(aside) <= ahead


def _links(placed: Mapping[str, Placed], wanted: Piece, piece: Placed) -> Iterator[str]:
    for link in wanted.links:
        other = placed.get(link.of)
        if not link.required or other is None:
            continue
        asked = link
        if link.turn == LOOKS_AT:
            free = piece.chosen.attach is None and other.chosen.attach is None
            if free and not _looks_at(piece, other):
                yield f"{piece.label} does not look at {link.of}"
            asked = replace(link, turn=None if free else 180)
        if not holds(asked, (piece.rotation, piece.chosen.wall), (other.rotation, other.chosen.wall)):
            yield f"{piece.label} is not {link.relation} {link.of}"


def holds(link: Link, own: tuple[int, str | None], other: tuple[int, str | None]) -> bool:
    """Tells whether a link's condition holds between two pieces, each given by rotation and the wall it asked for."""
    if link.turn is not None and (own[0] - other[0] - link.turn) % 360 != 0:
        return False
    if link.walls is None:
        return True
    if own[1] is None or other[1] is None:
        return False
    same, across = own[1] == other[1], FACING[own[1]] == other[1]
    return {"same": same, "opposite": across, "adjacent": not same and not across, "other": not same}[link.walls]


def _pair(a: Placed, b: Placed) -> Iterator[str]:
    """Two pieces that share a height range are apart, but for a chair under its table and a thing on what carries it."""
    for one, two in ((a, b), (b, a)):
        if two.label in (one.chosen.under, one.chosen.on):
            return
    low = max(a.chosen.bottom_mm, b.chosen.bottom_mm)
    high = min(a.chosen.bottom_mm + a.chosen.size_mm[2], b.chosen.bottom_mm + b.chosen.size_mm[2])
    p, q = a.footprint, b.footprint
    if low < high and p.x0 < q.x1 and q.x0 < p.x1 and p.z0 < q.z1 and q.z0 < p.z1:
        yield f"{a.label} and {b.label} overlap"


def unreached(space: Space, wanted: Sequence[Piece], arrangement: Arrangement) -> list[str]:
    """Lists the doors and the pieces with use sides that cannot be come to from the first door."""
    asked = {piece.label: piece for piece in wanted}
    solids = [piece.footprint for piece in arrangement.placed if piece.chosen.bottom_mm < HEADROOM_MM]
    uses: list[tuple[str, Rect, list[str], bool]] = []
    for piece in arrangement.placed:
        stands: Sequence[Stand] = asked[piece.label].stands
        if stands:
            walls = [side_towards(stand.side, piece.rotation) for stand in stands]
            uses.append((piece.label, piece.footprint, walls, asked[piece.label].need_all))
    return missed(space, solids, uses)
