"""Why a piece was left out: what room it needs and what is left of the walls, and the fewest pieces that cannot stand together.

Not here: by how much a room is too short (lengths).
"""

from collections.abc import Container, Mapping, Sequence
from functools import lru_cache

from solver.geometry import WALL_BEHIND, Rect
from solver.pieces import Candidate, Extents, NamedKind, Piece, Placed, Space
from solver.placement.arrange import feasible
from solver.placement.budget import Budget

WALLS = tuple(WALL_BEHIND.values())
"""In the order in which reasons name them."""
_STRETCHES = "longest free stretches of wall at that depth and height: " + ", ".join(f"{wall} %.2f m" for wall in WALLS)


def _least(piece: Piece) -> Candidate:
    return min(piece.candidates, key=lambda a: (a.size_mm[0] * a.size_mm[1], a.size_mm))


def why_left_out(space: Space, piece: Piece, placed: Sequence[Placed], gone: Container[str] = ()) -> str:
    """Says how much room the smallest variant needs and how much the others leave; `gone` are all pieces that were left out."""
    if not piece.candidates:
        if piece.only and not _fits_somehow(piece.only[1], space.clear):
            kind, (width, depth, _) = piece.only
            return f"{kind} {width / 1000:.2f} x {depth / 1000:.2f} m is larger than the room, {clear_size(space.clear)}"
        return "the room offers no wall or place of the kind its relations ask for"
    least = _least(piece)
    _, depth, height = least.size_mm
    parent = least.attach.parent if least.attach and all(way.attach for way in piece.candidates) else None
    longest: Sequence[int] = ()
    if any(a.wall for a in piece.candidates):
        bodies = [other.footprint for other in placed if other.chosen.bottom_mm < height]
        longest = [max((e - s for s, e in space.free_stretches(wall, depth, height, bodies)), default=0) for wall in WALLS]
    at = parent and named_parent(parent, parent in gone)
    return room_needed((least.kind, least.size_mm), at, longest, f"{clear_size(space.clear)} and holds {len(placed)} pieces")


def _fits_somehow(size: Extents, clear: Rect) -> bool:
    """Tells whether a rectangle fits into another, turned or not."""
    (least, most), (narrow, long) = sorted(size[:2]), sorted((clear.width, clear.depth))
    return least <= narrow and most <= long


def named_parent(parent: str, is_gone: bool) -> str:
    """Names the piece at whose slot another one stands, and says so where that was left out, too."""
    return f"{parent}, which was left out itself" if is_gone else parent


def room_needed(least: NamedKind, parent: str | None, longest: Sequence[int], room: str) -> str:
    """Says how much room the smallest variant of a piece needs, by its kind and size, and how much there is.

    `parent` is at whose slot it stands, in words; `longest` are the free stretches of the WALLS at its depth and height, mm, if any variant
    stands at a wall; `room` is the room's size and what it holds.
    """
    size = _size_needed(least)
    if parent is not None:
        return f"{size} at its place by {parent}"
    if longest:
        return f"{size} and a free way to it; {_STRETCHES % tuple([length / 1000 for length in longest])}"
    return f"{size} and a free way to it; the room is {room}"


def minimal_conflict(
    space: Space, pieces: Sequence[Piece], missing: str, budget: Budget | None = None, walk: bool = False
) -> tuple[str, ...] | None:
    """Finds a minimal set of pieces that cannot stand together, or with `walk` cannot be used together.

    Pieces are added, `missing` and what carries it first, then what else stands there, until they are infeasible; then a deletion
    filter: a piece whose absence leaves the rest infeasible is not part of the reason. Who goes takes along what stands only at it.

    Returns:
        Labels, in the order given, such that they alone are infeasible and without any one of them the rest of them is
        feasible; None where a limit left a question open or all can stand.
    """
    allowed = budget or Budget()
    known = {piece.label: piece for piece in pieces}

    def verdict(labels: set[str]) -> bool | None:
        return feasible(space, [piece for piece in pieces if piece.label in labels], allowed, walk)

    members: set[str] = set()
    stand: bool | None = True
    beside = sorted(known, key=lambda label: known[label].parents.isdisjoint(known[missing].parents))
    for label in (missing, *beside):
        members |= _with_carriers(known, label)
        if (stand := verdict(members)) is not True:
            break
    if stand is not False:
        return None
    before: set[str] = set()
    while members != before:  # who lost what it could have been attached to may count no more
        before = members
        for label in known:
            if label in members:
                rest = members - _with_carried(known, members, label)
                if (stand := verdict(rest)) is None:
                    return None
                if stand is False:
                    members = rest
    return tuple(piece.label for piece in pieces if piece.label in members)


def _carrier(piece: Piece) -> str | None:
    """Returns the one piece without which a piece cannot stand, if there is one."""
    return next(iter(piece.parents)) if len(piece.parents) == 1 else None


def _with_carriers(known: Mapping[str, Piece], label: str) -> set[str]:
    """Returns a piece and those it can only stand with, one upon the other."""
    found: set[str] = set()
    at: str | None = label
    while at is not None and at in known and at not in found:
        found.add(at)
        at = _carrier(known[at])
    return found


def _with_carried(known: Mapping[str, Piece], members: set[str], label: str) -> set[str]:
    """Returns a member and all members that have nothing left to stand with once it is gone."""
    gone = {label}
    while True:
        left = members - gone
        more = {other for other in left if known[other].candidates and known[other].parents.isdisjoint({None, *left})}
        if not more:
            return gone
        gone |= more


@lru_cache(maxsize=1024)
def _size_needed(least: NamedKind) -> str:
    kind, (width, depth, _) = least
    return f"the smallest, {kind}, needs {width / 1000:.2f} x {depth / 1000:.2f} m"


def clear_size(rect: Rect) -> str:
    """Says how large a room's clear rectangle is."""
    return f"{rect.width / 1000:.2f} x {rect.depth / 1000:.2f} m clear"
