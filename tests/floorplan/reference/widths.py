"""Columns of a strip: how wide each may be, exactly, and how a strip's length is shared out among them.

Comes in: sizes of rooms, a strip's depth, mm. Goes out: intervals of widths, widths and depths on the 50 mm lattice.
A strip has one depth; a column stacks one or more rooms over that depth, all as wide as it.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Final, NamedTuple

from solver.floorplan.programme.planned_rooms import RoomSize

LATTICE_MM: Final = 50
"""Lines between rooms fall on multiples of 5 cm: dimensions a person would draw."""
DEPTHS_MM: Final = range(2400, 7050, 150)
"""Depths that strips may have where nothing else decides them."""
WIDEST_MM: Final = 12000
"""No stack is wider. Our choice, twice the widest that any stack of a home needs."""


class WidthRange(NamedTuple):
    """An interval of widths (or depths) with what is wished, mm; `misses` tells that no width at all would do."""

    low: int
    wished: int
    high: int
    misses: bool = False


def _up(length: float) -> int:
    return -int(-length // LATTICE_MM) * LATTICE_MM


def _down(length: float) -> int:
    return int(length // LATTICE_MM) * LATTICE_MM


def _within(size: RoomSize, other: int) -> tuple[int, int]:
    """Returns the least and greatest extent of a room along one axis, given the other; on the lattice."""
    low = max(size.least / other, size.width, other / size.aspect)
    return _up(low), _down(min(size.most / other, other * size.aspect))


@lru_cache(maxsize=1 << 14)
def width_of(stack: tuple[RoomSize, ...], depth: int) -> WidthRange:
    """Returns how wide a column of these rooms may be in a strip of a depth.

    The widths at which every room of the stack keeps its limits are an interval; it is exact on the lattice.
    """
    wished = sum(size.typical for size in stack) / depth
    if len(stack) == 1:
        low, high = _within(stack[0], depth)
        misses = low > high or depth < max(stack[0].width, stack[0].length)
    else:
        fits = [width for width in range(max(s.width for s in stack), WIDEST_MM, LATTICE_MM) if _stands(stack, width, depth)]
        misses, low, high = not fits, fits[0] if fits else 0, fits[-1] if fits else 0
    if misses:
        low = high = max(_up(wished), *(size.width for size in stack))
    return WidthRange(low, min(max(_down(wished + LATTICE_MM / 2), low), high), high, misses)


@lru_cache(maxsize=1 << 12)
def depths_for(stack: tuple[RoomSize, ...]) -> int:
    """Returns the depths of a strip at which a column of these rooms has a width, as bits: bit k is DEPTHS_MM[k]."""
    return sum(1 << k for k, depth in enumerate(DEPTHS_MM) if not width_of(stack, depth).misses)


def _depths(stack: tuple[RoomSize, ...], width: int) -> list[WidthRange]:
    spans = []
    for size in stack:
        low, high = _within(size, width)
        low = max(low, size.length)
        spans.append(WidthRange(low, min(max(_down(size.typical / width), low), max(high, low)), high))
    return spans


def _stands(stack: tuple[RoomSize, ...], width: int, depth: int) -> bool:
    least = most = 0
    for size in stack:
        low, high = _within(size, width)
        low = max(low, size.length)
        if low > high:
            return False
        least, most = least + low, most + high
    return least <= depth <= most


@lru_cache(maxsize=1 << 15)
def depths_of(stack: tuple[RoomSize, ...], width: int, depth: int) -> tuple[int, ...]:
    """Shares a column's depth out among the rooms of its stack, first to last; the depths add up to it."""
    return shared_out(depth, _depths(stack, width))


def shared_out(length: int, spans: Sequence[WidthRange]) -> tuple[int, ...]:
    """Shares a length out: everyone starts at what is wished, the difference is spread by slack.

    Args:
        length: what the parts add up to, a multiple of the lattice but for what the last part takes, mm.
        spans: of the parts; where the length lies outside their sums, the parts miss their intervals in proportion.

    Returns:
        The parts, on the lattice: sums are rounded, so that no part leaves its interval.
    """
    over = length - sum(span.wished for span in spans)
    slack = [span.high - span.wished if over > 0 else span.wished - span.low for span in spans]
    whole = sum(slack)
    if abs(over) > whole:
        slack = [max(span.wished, 1) for span in spans]
        whole = sum(slack)
    parts, exact, at = [], 0.0, 0
    for span, spare in zip(spans[:-1], slack[:-1], strict=True):
        exact += span.wished + (over * spare / whole if whole else 0.0)
        line = int(exact / LATTICE_MM + 0.5) * LATTICE_MM
        parts.append(line - at)
        at = line
    parts.append(length - at)
    return tuple(parts)
