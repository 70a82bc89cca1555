"""The sheet that a plan is drawn on, as SVG: its scale and size, its dimension lines, names, title, scale bar and north arrow.

Comes in: what a storey covers, m; dimensions and labels. Goes out: SVG text in millimetres of the house. May import: a plan's rooms.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from solver.exports.model import PlacedOpening
from solver.exports.plan_facades import too_short
from solver.exports.plan_rooms import LINE, Dimension, PlanBox, RoomLabel, length_of, number_box
from solver.exports.xml_text import xml_text
from solver.geometry import square_metres

SCALES: Final = (20, 25, 50, 75, 100, 150, 200, 250, 500, 1000, 2000)
PAPER: Final = (408.0, 285.0)
"""What a printer reaches of an A3 sheet, mm; either way round. A smaller plan makes a smaller sheet."""
MARGIN, STRIP, GAP, LEAST_WIDTH = 28.0, 21.0, 6.0, 150.0
"""Round the house, of the title below, between chains of dimensions, of the whole; mm on paper."""
LETTERS, NUMBERS, TITLE = 2.5, 2.1, 5.0
"""Heights of letters, mm on paper."""
ENTRANCE: Final = (0.8, 2.6, 3.0)
"""How far from its wall the mark of the main entrance is, how deep and how wide, mm on paper."""
_STYLE: Final = (
    "text{{font-family:Helvetica,Arial,sans-serif;fill:#1a1a1a;text-anchor:middle;"
    "paint-order:stroke;stroke:#fff;stroke-width:{halo:g};stroke-opacity:.8;stroke-linejoin:round}}"
    ".floor,.walls{{stroke:none}}.walls,.entrance{{fill:#2e2e2e}}"
    ".body{{stroke:#5c5c5c;stroke-width:{fine:g}}}.item{{stroke:#7a7a7a;stroke-width:{hair:g}}}"
    ".high{{fill:none;stroke:#7a7a7a;stroke-width:{hair:g};stroke-dasharray:{dash:g}}}"
    ".opening{{fill:#fff;stroke:#2e2e2e;stroke-width:{fine:g}}}"
    ".arc{{fill:none;stroke:#2e2e2e;stroke-width:{hair:g}}}"
    ".dashed{{fill:none;stroke:#2e2e2e;stroke-width:{hair:g};stroke-dasharray:{dash:g}}}"
    ".line{{fill:none;stroke:#8a8a8a;stroke-width:{hair:g}}}"
    ".tick{{fill:none;stroke:#1a1a1a;stroke-width:{bold:g}}}"
    ".number{{font-size:{numbers:g}px}}.name{{font-weight:bold}}"
    ".left{{text-anchor:start}}"
)


@dataclass(frozen=True)
class PlanSheet:
    """A sheet: what of the house it shows, m, and how many millimetres of the house one on paper is."""

    west: float
    north: float
    east: float
    south: float
    scale: int

    @property
    def letters(self) -> float:
        """How high letters of names are, m in the house."""
        return LETTERS * self.scale / 1000

    @property
    def numbers(self) -> float:
        """How high numbers are, m in the house."""
        return NUMBERS * self.scale / 1000

    @property
    def gap(self) -> float:
        """From one chain of dimensions to the next, m in the house."""
        return GAP * self.scale / 1000

    def opened(self, said: str) -> str:
        """Returns the file's beginning: its size, on paper and in the house, more attributes, and how things are drawn."""
        left, top, wide, high = self.west * 1000, self.north * 1000, (self.east - self.west) * 1000, (self.south - self.north) * 1000
        strokes = {"hair": 0.09, "fine": 0.13, "bold": 0.3, "dash": 0.7, "numbers": NUMBERS, "halo": 0.7}
        style = _STYLE.format(**{name: round(paper * self.scale, 3) for name, paper in strokes.items()})
        return (
            '<?xml version="1.0" encoding="UTF-8"?>\n'
            f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="{wide / self.scale:g}mm" '
            f'height="{high / self.scale:g}mm" viewBox="{left:.0f} {top:.0f} {wide:.0f} {high:.0f}" {said}>\n<style>{style}</style>\n'
            f'<rect x="{left:.0f}" y="{top:.0f}" width="{wide:.0f}" height="{high:.0f}" fill="#fff"/>\n'
        )


def sheet_for(bounds: PlanBox, wanted: int | None = None) -> PlanSheet:
    """Returns the sheet that shows a storey of these outer faces, m: at 1 to `wanted`, else at the largest scale that A3 holds."""
    west, north, east, south = bounds
    for scale in (wanted,) if wanted else SCALES:
        wide, high = (east - west) * 1000 / scale + 2 * MARGIN, (south - north) * 1000 / scale + 2 * MARGIN + STRIP
        if min(wide, high) <= PAPER[1] and max(wide, high) <= PAPER[0]:
            break
    margin, strip = MARGIN * scale / 1000, STRIP * scale / 1000
    more = max(0.0, LEAST_WIDTH * scale / 1000 - (east - west + 2 * margin)) / 2
    return PlanSheet(west - margin - more, north - margin, east + margin + more, south + margin + strip, scale)


def dimension(line: Dimension, sheet: PlanSheet) -> tuple[str, str, str]:
    """Returns a chain of dimensions: (its line as a path, its ticks as a path, its numbers)."""
    at, stops, tick = line.at * 1000, [stop * 1000 for stop in line.stops], 0.9 * sheet.scale
    along_x = line.axis == "x"
    path = f"M{stops[0]:.0f} {at:.0f}H{stops[-1]:.0f}" if along_x else f"M{at:.0f} {stops[0]:.0f}V{stops[-1]:.0f}"
    points = [(stop, at) if along_x else (at, stop) for stop in stops]
    path += "".join(f"M{x:.0f} {y - tick:.0f}v{2 * tick:.0f}" if along_x else f"M{x - tick:.0f} {y:.0f}h{2 * tick:.0f}" for x, y in points)
    ticks = "".join(f"M{x - tick * 0.6:.0f} {y + tick * 0.6:.0f}l{tick * 1.2:.0f} {-tick * 1.2:.0f}" for x, y in points)
    return path, ticks, "".join(_numbers(line, sheet))


def _numbers(line: Dimension, sheet: PlanSheet) -> Iterator[str]:
    """Yields the numbers of a chain; what is too long for its length stands one row further, or not at all where that is taken."""
    raised_to = float("-inf")
    size = sheet.numbers
    for (start, end), text in zip(pairwise(line.stops), line.texts, strict=True):
        above = 0.35 * size
        if too_short(end - start, size):
            half = number_box(end - start, size)[0] / 2
            if text - half < raised_to:
                continue
            raised_to, above = text + half + 0.2 * size, 1.45 * size
        at, words = ((text, line.at - above) if line.axis == "x" else (line.at - above, text)), length_of(end - start)
        yield number(words, at, line.axis == "z")


def number(words: str, at: tuple[float, float], upright: bool) -> str:
    """Returns a number whose baseline has its middle there, m; upright ones are read from the right."""
    x, y = at[0] * 1000, at[1] * 1000
    where = f'transform="translate({x:.0f} {y:.0f})rotate(-90)"' if upright else f'x="{x:.0f}" y="{y:.0f}"'
    return f'<text class="number" {where}>{words}</text>'


def room_name(label: RoomLabel) -> str:
    """Returns a room's name and area."""
    size, x, y = label.size * 1000, label.x * 1000, label.z * 1000
    turned = f' transform="rotate(-90 {x:.0f} {y:.0f})"' if label.upright else ""
    top = y + (0.92 - (len(label.rows) + 1) / 2 * LINE) * size
    names = "".join(
        f'<text class="name" x="{x:.0f}" y="{top + row * LINE * size:.0f}" font-size="{size:.0f}">{xml_text(words)}</text>'
        for row, words in enumerate(label.rows)
    )
    last = top + (len(label.rows) * LINE - 0.02) * size
    area = f'<text x="{x:.0f}" y="{last:.0f}" font-size="{size * 0.86:.0f}">{square_metres(label.area)}</text>'
    return f"<g{turned}>{names}{area}</g>\n"


def entrance_mark(opening: PlacedOpening, sheet: PlanSheet) -> str:
    """Returns a triangle before the main entrance that points at it from outside, beyond its leaf where that swings out."""
    outward = 1 if opening.rooms[0] is None else -1 if opening.rooms[1] is None else -opening.towards
    apart, deep, wide = (length * sheet.scale for length in ENTRANCE)
    apart += opening.thickness * 500 + (opening.end - opening.start) * 1000 * (opening.towards == outward)
    at, tip = (opening.start + opening.end) * 500, opening.line * 1000 + outward * apart
    corners = [(at, tip), (at - wide / 2, tip + outward * deep), (at + wide / 2, tip + outward * deep)]
    points = " ".join(f"{x:.0f},{z:.0f}" for x, z in (corners if opening.axis == "x" else [(z, x) for x, z in corners]))
    return f'<polygon class="entrance" points="{points}"/>\n'


def title(sheet: PlanSheet, words: Sequence[str]) -> str:
    """Returns the title and the lines below it, the scale bar and the north arrow at the sheet's foot."""
    unit, left, foot = sheet.scale, sheet.west * 1000 + 8 * sheet.scale, sheet.south * 1000 - STRIP * sheet.scale
    rows = [f'<text class="left name" x="{left:.0f}" y="{foot + 4 * unit:.0f}" font-size="{TITLE * unit:.0f}">{xml_text(words[0])}</text>']
    for index, row in enumerate(words[1:]):
        at = foot + (9.5 + 3.9 * index) * unit
        style = "left scale" if index == len(words) - 2 else "left"
        rows.append(f'<text class="{style}" x="{left:.0f}" y="{at:.0f}" font-size="{2.5 * unit:.0f}">{xml_text(row)}</text>')
    return f'<g class="foot">{"".join(rows)}{_bar(sheet, foot)}{_arrow(sheet, foot)}</g>\n'


def _bar(sheet: PlanSheet, foot: float) -> str:
    """Returns the scale bar: five parts of a metre or more each, dark and light by turns."""
    unit = sheet.scale
    step = next(metres for metres in (1, 2, 5, 10, 20, 50) if metres * 1000 / unit >= 8) * 1000
    left, top, high = sheet.east * 1000 - 24 * unit - 5 * step, foot + 4 * unit, 1.5 * unit
    cells = "".join(
        f'<rect x="{left + i * step:.0f}" y="{top:.0f}" width="{step}" height="{high:.0f}" fill="{"#2e2e2e" if i % 2 == 0 else "#fff"}" '
        f'stroke="#2e2e2e" stroke-width="{0.13 * unit:g}"/>'
        for i in range(5)
    )
    marks = "".join(number(f"{i * step // 1000}", ((left + i * step) / 1000, (top - unit) / 1000), False) for i in range(5))
    return cells + marks + number(f"{5 * step // 1000} m", ((left + 5 * step) / 1000, (top - unit) / 1000), False)


def _arrow(sheet: PlanSheet, foot: float) -> str:
    unit = sheet.scale
    x, y, half, high = sheet.east * 1000 - 11 * unit, foot + 13 * unit, 2.6 * unit, 11 * unit
    return (
        f'<path d="M{x:.0f} {y:.0f}l{-half:.0f} {0.25 * high:.0f}L{x:.0f} {y - 0.75 * high:.0f}z" fill="#fff" class="opening"/>'
        f'<path d="M{x:.0f} {y:.0f}l{half:.0f} {0.25 * high:.0f}L{x:.0f} {y - 0.75 * high:.0f}z" fill="#2e2e2e"/>'
        f'<text class="name" x="{x:.0f}" y="{y - 0.82 * high:.0f}" font-size="{3.4 * unit:.0f}">N</text>'
    )
