"""Outlines that are no rectangles: where a wing may lie beside the public rooms, and what outline that makes.

Comes in: depths, mm. Goes out: offsets, mm. May import: the floor plan's tiling. Positions are along z: the public block begins
at 0, a wing at its offset, negative where it juts out to the north. A wing's hallway ends at the public block, over its whole width.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import Final, NamedTuple

from tests.floorplan.reference.asked import hallway
from tests.floorplan.reference.widths import LATTICE_MM

JOG_MM: Final = 900
"""A wing that is not flush is out of line by at least this: less looks like a mistake. Our choice."""
COURT_MM: Final = 1500
"""The court of a U is at least so deep. Our choice."""


class Wing(NamedTuple):
    """Depths of a wing's strips north and south of its hallway, mm."""

    north: int
    south: int

    @property
    def depth(self) -> int:
        """From outer wall to outer wall, mm."""
        return self.north + hallway() + self.south


def offsets(outline: str, public: int, wings: tuple[Wing, ...]) -> tuple[tuple[int, ...], ...]:
    """Returns where wings may begin so that a home has an outline: one offset a wing, mm.

    Args:
        outline: L, T or U. A U has two wings and a court between them; it may have one on either side, as an H.
        public: depth of the public block, mm.
        wings: the wing beside it, or the two at its ends.
    """
    each = [list(dict.fromkeys(_offsets(public, wing))) for wing in wings]
    return tuple(chosen for chosen in product(*each) if _outline(_jogs(public, wings, chosen)) == outline)


def _offsets(public: int, wing: Wing) -> Iterator[int]:
    """Yields a wing's offsets: flush with either side, in the middle, as far out as its hallway allows."""
    first, last = -wing.north, public - hallway() - wing.north
    flush = public - wing.depth
    for offset in (0, flush, flush // 2 // LATTICE_MM * LATTICE_MM, first, last):
        if first <= offset <= last and all(jog == 0 or abs(jog) >= JOG_MM for jog in _out(public, wing, offset)):
            yield offset


def _out(public: int, wing: Wing, offset: int) -> tuple[int, int]:
    """Returns how far a wing juts out to the north and to the south; negative where the public block does."""
    return -offset, offset + wing.depth - public


def _jogs(public: int, wings: Sequence[Wing], chosen: Sequence[int]) -> list[tuple[int, int]]:
    return [_out(public, wing, offset) for wing, offset in zip(wings, chosen, strict=True)]


def _outline(jogs: Sequence[tuple[int, int]]) -> str:
    """Names an outline by how far its wings jut out; nothing where it is none of ours."""
    if not any(north or south for north, south in jogs):
        return "rectangle"
    if len(jogs) == 1:
        ((north, south),) = jogs
        return "L" if not north * south else "T" if north * south > 0 else ""
    court = any(min(side) >= COURT_MM for side in zip(*jogs, strict=True))
    return "U" if court else ""
