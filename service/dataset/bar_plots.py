"""Plots of counts as SVG: bars with their names and numbers, readable by day and by night."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final
from xml.sax.saxutils import escape

WIDTH, LINE, NAME, ROOM = 640, 18, 170, 60
"""Pixels: of the picture, of a line, of a name, of a number."""
BINS: Final = 16
COLOUR, INK = "#4f7cac", "#808080"


def bars(title: str, counts: Mapping[str, int]) -> str:
    """Returns a bar for each count, in the mapping's order."""
    most = max(counts.values(), default=0) or 1
    height = LINE * (len(counts) + 2)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" viewBox="0 0 {WIDTH} {height}" '
        f'font-family="sans-serif" font-size="12" fill="{INK}">',
        f'<text x="0" y="14" font-size="14">{escape(title)}</text>',
    ]
    for row, (name, count) in enumerate(counts.items()):
        y, long = LINE * (row + 1) + 6, round((WIDTH - NAME - ROOM) * count / most, 1)
        lines.append(f'<text x="{NAME - 8}" y="{y + 12}" text-anchor="end">{escape(name)}</text>')
        lines.append(f'<rect x="{NAME}" y="{y + 2}" width="{long}" height="{LINE - 4}" fill="{COLOUR}"/>')
        lines.append(f'<text x="{NAME + long + 4:g}" y="{y + 12}">{count:,}</text>')
    return "\n".join([*lines, "</svg>", ""])


def spread_bars(title: str, values: Sequence[float]) -> str:
    """Returns how many values lie in each of some steps of equal width."""
    if not values:
        return bars(title, {})
    low, high = min(values), max(values)
    step = next(size for power in range(-3, 9) for k in (1, 2, 5) if (high - low) / (size := k * 10.0**power) < BINS)
    first, last = int(low // step), int(high // step)
    counts = {f"{k * step:g} - {(k + 1) * step:g}": 0 for k in range(first, last + 1)}
    names = list(counts)
    for value in values:
        counts[names[int(value // step) - first]] += 1
    return bars(title, counts)
