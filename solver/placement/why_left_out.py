"""Why a piece was left out, in words: what room it needs, and what is left of the walls."""

from collections.abc import Sequence
from functools import lru_cache

from solver.geometry import WALL_BEHIND, Rect
from solver.pieces import Extents, Piece, Space

WALLS = tuple(WALL_BEHIND.values())
"""In the order in which reasons name them."""
_STRETCHES = "longest free stretches of wall at that depth and height: " + ", ".join(f"{wall} %.2f m" for wall in WALLS)


def why_nowhere(space: Space, piece: Piece) -> str:
    """Says why a piece has no way to stand at all."""
    if piece.only and not _fits_somehow(piece.only[1], space.clear):
        kind, (width, depth, _) = piece.only
        return f"{kind} {width / 1000:.2f} x {depth / 1000:.2f} m is larger than the room, {clear_size(space.clear)}"
    return "the room offers no wall or place of the kind its relations ask for"


def _fits_somehow(size: Extents, clear: Rect) -> bool:
    """Tells whether a rectangle fits into another, turned or not."""
    (least, most), (narrow, long) = sorted(size[:2]), sorted((clear.width, clear.depth))
    return least <= narrow and most <= long


def named_parent(parent: str, is_gone: bool) -> str:
    """Names the piece at whose slot another one stands, and says so where that was left out, too."""
    return f"{parent}, which was left out itself" if is_gone else parent


def room_needed(least: tuple[str, int, int], parent: str | None, longest: Sequence[int], room: str) -> str:
    """Says how much room the smallest variant of a piece needs, by its kind, width and depth, mm, and how much there is.

    `parent` is at whose slot it stands, in words; `longest` are the free stretches of the WALLS at its depth and height, mm, if any variant
    stands at a wall; `room` is the room's size and what it holds.
    """
    size = _size_needed(least)
    if parent is not None:
        return f"{size} at its place by {parent}"
    if longest:
        return f"{size} and a free way to it; {_STRETCHES % tuple([length / 1000 for length in longest])}"
    return f"{size} and a free way to it; the room is {room}"


@lru_cache(maxsize=1024)
def _size_needed(least: tuple[str, int, int]) -> str:
    kind, width, depth = least
    return f"the smallest, {kind}, needs {width / 1000:.2f} x {depth / 1000:.2f} m"


def clear_size(rect: Rect) -> str:
    """Says how large a room's clear rectangle is."""
    return f"{rect.width / 1000:.2f} x {rect.depth / 1000:.2f} m clear"
