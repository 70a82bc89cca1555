"""The sheet that a plan is drawn on, as SVG in millimetres of the house: paper, scale, dimension lines, names, frame, title block."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from solver.exports.model import PlacedOpening
from solver.exports.plan_rooms import LINE, WIDE, Dimension, PlanBox, RoomLabel, length_of, number_box, too_short
from solver.exports.xml_text import xml_text

SCALES: Final = (20, 25, 50, 75, 100, 150, 200, 250, 500, 1000, 2000)
PAPERS: Final = ((297.0, 210.0), (420.0, 297.0), (594.0, 420.0), (841.0, 594.0), (1189.0, 841.0))
"""A4 to A0 lying on their long side, mm."""
USUAL: Final = PAPERS[:2]
"""Papers that a plan at no wanted scale is drawn for."""
BORDER, MARGIN, BLOCK, GAP = 7.0, 27.0, 20.0, 6.0
"""From the paper's edge to the frame, from that to the house, of the title block at the foot, between chains of dimensions; mm on paper."""
NORTH, BAR = 18.0, 68.0
"""How wide the cells of the title block are that hold the north arrow and the scale, mm on paper; the title has what is left."""
LETTERS, NUMBERS, TITLE = 2.5, 2.1, 5.0
"""Heights of letters, mm on paper."""
ENTRANCE: Final = (0.8, 2.6, 3.0)
"""How far from its wall the mark of the main entrance is, how deep and how wide, mm on paper."""
_STEPS: Final = (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50)
"""Lengths of a part of the scale bar, m."""
_BELOW: Final = ("", 'class="size"')
"""How a room's area and its size are marked."""
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
    ".left{{text-anchor:start}}.frame{{fill:none;stroke:#1a1a1a;stroke-width:{bold:g}}}"
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
    def left(self) -> float:
        """Where the paper's west edge is, mm of the house."""
        return self.west * 1000

    @property
    def right(self) -> float:
        """Where the paper's east edge is, mm of the house."""
        return self.east * 1000

    @property
    def foot(self) -> float:
        """Where the frame ends in the south, mm of the house."""
        return self.south * 1000 - BORDER * self.scale

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
    """Returns the sheet with a storey of these outer faces, m, in its middle: the smallest paper at 1 to `wanted`, else at what A3 holds.

    What no paper holds has a sheet as large as it needs.
    """
    west, north, east, south = bounds
    for scale in (wanted,) if wanted else SCALES:
        wide, high = ((side * 1000 / scale + 2 * (MARGIN + BORDER)) for side in (east - west, south - north))
        ways = [way for paper in (PAPERS if wanted else USUAL) for way in (paper, paper[::-1])]
        paper = next((way for way in ways if wide <= way[0] and high + BLOCK <= way[1]), None)
        if paper:
            break
    width, height = (side * scale / 1000 for side in paper or (max(wide, PAPERS[0][1]), high + BLOCK))
    left, top = (west + east - width) / 2, (north + south - height + BLOCK * scale / 1000) / 2
    return PlanSheet(left, top, left + width, top + height, scale)


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
    """Returns a room's name, its area, and its size where there is room for it."""
    size, small, x, y = label.size * 1000, label.small * 1000, label.x * 1000, label.z * 1000
    turned = f' transform="rotate(-90 {x:.0f} {y:.0f})"' if label.upright else ""
    rows = [*((words, 'class="name"', size) for words in label.rows), *zip(label.below, _BELOW, (small, small), strict=False)]
    top, texts = y - sum(high for *_, high in rows) * LINE / 2, []
    for words, said, high in rows:
        texts.append(f'<text {said} x="{x:.0f}" y="{top + 0.95 * high:.0f}" font-size="{high:.0f}">{xml_text(words)}</text>')
        top += LINE * high
    return f"<g{turned}>{''.join(texts)}</g>\n"


def entrance_mark(opening: PlacedOpening, sheet: PlanSheet) -> str:
    """Returns a triangle before the main entrance that points at it from outside, beyond its leaf where that swings out."""
    outward = 1 if opening.rooms[0] is None else -1 if opening.rooms[1] is None else -opening.towards
    apart, deep, wide = (length * sheet.scale for length in ENTRANCE)
    apart += opening.thickness * 500 + (opening.end - opening.start) * 1000 * (opening.towards == outward)
    at, tip = (opening.start + opening.end) * 500, opening.line * 1000 + outward * apart
    corners = [(at, tip), (at - wide / 2, tip + outward * deep), (at + wide / 2, tip + outward * deep)]
    points = " ".join(f"{x:.0f},{z:.0f}" for x, z in (corners if opening.axis == "x" else [(z, x) for x, z in corners]))
    return f'<polygon class="entrance" points="{points}"/>\n'


def frame(sheet: PlanSheet) -> str:
    """Returns the frame of the sheet and of its title block's cells."""
    unit = sheet.scale
    left, right, top, foot = sheet.left + BORDER * unit, sheet.right - BORDER * unit, sheet.north * 1000 + BORDER * unit, sheet.foot
    cells = "".join(f"M{right - across * unit:.0f} {foot - BLOCK * unit:.0f}V{foot:.0f}" for across in (NORTH, NORTH + BAR))
    path = f"M{left:.0f} {top:.0f}H{right:.0f}V{foot:.0f}H{left:.0f}zM{left:.0f} {foot - BLOCK * unit:.0f}H{right:.0f}{cells}"
    return f'<path class="frame" d="{path}"/>\n'


def foot(sheet: PlanSheet, words: Sequence[str]) -> str:
    """Returns what stands in the title block: the title and the lines below it, the scale bar with the last line, the north arrow."""
    unit, left, top = sheet.scale, sheet.left + (BORDER + 4) * sheet.scale, sheet.foot - BLOCK * sheet.scale
    free = (sheet.right - sheet.left) / unit - 2 * BORDER - NORTH - BAR - 8
    size = min(TITLE, free / (len(words[0]) * WIDE))
    middle = sheet.right - (BORDER + NORTH + BAR / 2) * unit
    rows = [f'<text class="left name" x="{left:.0f}" y="{top + 6.5 * unit:.0f}" font-size="{size * unit:.0f}">{xml_text(words[0])}</text>']
    for index, row in enumerate(words[1:-1]):
        at = top + (10.8 + 3.3 * index) * unit
        rows.append(f'<text class="left" x="{left:.0f}" y="{at:.0f}" font-size="{NUMBERS * unit:.0f}">{xml_text(row)}</text>')
    rows.append(f'<text x="{middle:.0f}" y="{top + 15.5 * unit:.0f}" font-size="{LETTERS * unit:.0f}">{xml_text(words[-1])}</text>')
    return f'<g class="foot">{"".join(rows)}{_arrow(sheet)}</g>\n{_bar(sheet, middle, top + 8.5 * unit)}\n'


def _bar(sheet: PlanSheet, middle: float, foot: float) -> str:
    """Returns the scale bar, its middle and its foot there, mm of the house: parts of a length each, dark and light by turns."""
    unit = sheet.scale
    step = next(metres for metres in _STEPS if metres * 1000 / unit >= 7.5)
    count, part = (5 if step * 5000 / unit <= 50 else 3), step * 1000
    left, high, edge = -count * part / 2, 1.5 * unit, f'stroke="#2e2e2e" stroke-width="{0.13 * unit:g}"'
    cells = "".join(
        f'<rect x="{left + i * part:.0f}" y="{-high:.0f}" width="{part:.0f}" height="{high:.0f}" fill="{fill}" {edge}/>'
        for i, fill in enumerate(("#2e2e2e", "#fff", "#2e2e2e", "#fff", "#2e2e2e")[:count])
    )
    said = [f"{i * step:g}" for i in range(count)] + [f"{count * step:g} m"]
    marks = "".join(number(words, ((left + i * part) / 1000, (-high - unit) / 1000), False) for i, words in enumerate(said))
    return f'<g class="bar" data-wide="{count * part:.0f}" transform="translate({middle:.0f} {foot:.0f})">{cells}{marks}</g>'


def _arrow(sheet: PlanSheet) -> str:
    unit = sheet.scale
    x, y, half, high = sheet.right - (BORDER + NORTH / 2) * unit, sheet.foot - 4.8 * unit, 2.6 * unit, 11 * unit
    return (
        f'<path d="M{x:.0f} {y:.0f}l{-half:.0f} {0.25 * high:.0f}L{x:.0f} {y - 0.75 * high:.0f}z" fill="#fff" class="opening"/>'
        f'<path d="M{x:.0f} {y:.0f}l{half:.0f} {0.25 * high:.0f}L{x:.0f} {y - 0.75 * high:.0f}z" fill="#2e2e2e"/>'
        f'<text class="name" x="{x:.0f}" y="{y - 0.82 * high:.0f}" font-size="{3.4 * unit:.0f}">N</text>'
    )
