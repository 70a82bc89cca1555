"""SVG: a floor plan to scale, a file a storey, as an architect draws it; north is up, a unit is a millimetre of the house.

What a body is stands at its `<use>`: `data-id`, `data-kind`, `data-y` (its underside in the house), `data-mass`; its unrotated size at
the symbol that it uses (`data-size`: width, depth, height), in m and kg.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Final

from solver.exports.model import DoorLeaf, FloorPlate, HouseModel, ModelBody, PlacedOpening
from solver.exports.paints import shade
from solver.exports.plan_facades import Facades, chains_of
from solver.exports.plan_rooms import Dimension, PlanBox, PlanRoom, RoomLabel, clear_corners, clear_sizes, label_of, words_of
from solver.exports.plan_sheet import PlanSheet, dimension, room_name, sheet_for, title
from solver.exports.plan_symbols import HIGH, PlanMark, marks_of
from solver.exports.wall_panels import between
from solver.exports.writers import ExportSettings, Files
from solver.exports.xml_text import xml_text

LIGHTER: Final = 0.74
"""How far colours are moved towards white, so that all words can be read and ink is spared."""


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.svg`, or `<house>_level_<n>.svg` where there are several storeys."""
    levels = sorted({room.level for room in model.rooms}) or [0]
    names = {level: f"{model.name}.svg" if len(levels) == 1 else f"{model.name}_level_{level}.svg" for level in levels}
    return {names[level]: "".join(_Storey(model, level).drawn()).encode() for level in levels}


class _Storey:
    """What is drawn of one storey."""

    def __init__(self, model: HouseModel, level: int) -> None:
        self.model, self.level = model, level
        self.rooms = [room for room in model.rooms if room.level == level]
        inside = {room.id for room in self.rooms}
        self.bodies = [body for body in model.bodies if body.room in inside]
        self.openings = [opening for opening in model.openings if opening.level == level]
        here = {opening.id for opening in self.openings}
        self.leaves = [leaf for leaf in model.leaves if leaf.id in here]

    def drawn(self) -> Iterator[str]:
        """Yields the file's text, what lies lowest first."""
        if not self.rooms:
            yield sheet_for((0.0, 0.0, 1.0, 1.0)).opened() + _said(self.model) + "</svg>\n"
            return
        facades = Facades(self.rooms, self.openings, self.model.thickness / 2)
        sheet = sheet_for(facades.bounds())
        yield sheet.opened() + _said(self.model)
        yield from (_floor(room) for room in self.rooms)
        yield from _bodies(self.bodies)
        yield self._walls()
        yield from map(_opening, self.openings, [self.model.thickness] * len(self.openings))
        yield from map(_leaf, self.leaves)
        labels, lines = self._named(sheet)
        yield _dimensions(chains_of(facades, sheet.gap), lines, sheet)
        yield from map(room_name, labels)
        yield title(sheet, self._words(labels, sheet)) + "</svg>\n"

    def _walls(self) -> str:
        path = []
        for panel in self.model.panels:
            if panel.level != self.level:
                continue
            holes = sorted((hole.start, hole.end) for hole in panel.holes)
            for start, end in between(panel.start, panel.end, holes):
                along, across = (start, end), (panel.line - panel.thickness / 2, panel.line + panel.thickness / 2)
                path.append(_rectangle(*(along + across if panel.axis == "x" else across + along)))
        return f'<path class="walls" d="{"".join(path)}"/>\n' + self._railings()

    def _railings(self) -> str:
        low, high = self.rooms[0].elevation, self.rooms[0].ceiling
        boxes = [one.box for one in self.model.fittings if one.surface == "railing" and low <= one.box.y0 < high]
        path = "".join(dict.fromkeys(_rectangle(box.x0, box.x1, box.z0, box.z1) for box in boxes))
        return f'<path class="opening" d="{path}"/>\n' if path else ""

    def _named(self, sheet: PlanSheet) -> tuple[list[RoomLabel], list[Dimension]]:
        obstacles: dict[str, list[PlanBox]] = {room.id: [] for room in self.rooms}
        for body in self.bodies:
            if body.sort == "furniture" and body.y + body.height > 0.1 and body.room:
                obstacles[body.room].append(_footprint(body))
        opened = {leaf.id: _swept(leaf) for leaf in self.leaves}
        for opening in self.openings:
            for room in opening.rooms:
                if room in obstacles and opening.id in opened:
                    obstacles[room].append(opened[opening.id])
        labels, lines = [], []
        for plate in self.rooms:
            clear = clear_corners(plate, self.model.panels)
            planned = PlanRoom(plate, clear, obstacles[plate.id], sheet.letters, sheet.numbers)
            labels.append(label_of(planned))
            lines += clear_sizes(planned, labels[-1])
        return labels, lines

    def _words(self, labels: Sequence[RoomLabel], sheet: PlanSheet) -> list[str]:
        indoors = [label for label in labels if not label.room.outdoor]
        storey = f", storey {self.level}" if len({room.level for room in self.model.rooms}) > 1 else ""
        return [
            words_of(self.model.name) + storey,
            f"{len(indoors)} rooms, {sum(label.area for label in indoors):.1f} m² indoors. Scale 1:{sheet.scale} as printed.",
            "Lengths in metres. Areas and room sizes between wall faces; outside to wall lines.",
        ]


def _said(model: HouseModel) -> str:
    warnings = "".join(f"<desc>{xml_text(warning)}</desc>\n" for warning in model.warnings)
    return f"<title>{xml_text(words_of(model.name))}</title>\n{warnings}"


def _floor(room: FloorPlate) -> str:
    points = " ".join(f"{x * 1000:.0f},{z * 1000:.0f}" for x, z in room.corners)
    return f'<polygon class="floor" data-id="{xml_text(room.id)}" points="{points}" fill="{light(room.paint.color, 0.86)}"/>\n'


def _bodies(bodies: Sequence[ModelBody]) -> Iterator[str]:
    """Yields the symbols that bodies use, then the bodies, the lowest first; what hangs high is dashed."""
    symbols: dict[tuple[object, ...], str] = {}
    marks: dict[int, list[PlanMark]] = {}
    drawn, texts = [], ["<defs>\n"]
    for body in bodies:
        high = body.y >= HIGH and body.sort != "dynamic"
        key = (id(body.parts), id(body.paints), high, body.sort)
        symbol = symbols.get(key)
        if symbol is None:
            symbol = symbols[key] = f"s{len(symbols)}"
            seen = marks.get(id(body.parts)) or marks.setdefault(id(body.parts), marks_of(body.parts))
            texts.append(_symbol(symbol, body, seen, high))
        kind = f' data-kind="{xml_text(body.kind)}"' if body.kind else ""
        turn = f"rotate({-body.turn:g})" if body.turn else ""
        at = f"translate({body.x * 1000:.10g} {body.z * 1000:.10g}){turn}"
        said = f'data-id="{xml_text(body.id)}"{kind} data-y="{body.y:g}" data-mass="{body.mass:g}"'
        drawn.append((high, body.y + body.height, f'<use xlink:href="#{symbol}" transform="{at}" {said}/>\n'))
    drawn.sort(key=lambda one: one[:2])
    texts.append("</defs>\n")
    yield "".join(texts)
    yield from (text for _, _, text in drawn)


def _symbol(name: str, body: ModelBody, marks: Sequence[PlanMark], high: bool) -> str:
    style = "high" if high else "item" if body.sort == "decoration" else "body"
    shapes = []
    for form, x, z, width, depth, radius, part in marks:
        fill = "" if high else f' fill="{light(body.paints[part].color, LIGHTER)}"'
        if form == "ellipse":
            radii = f'rx="{width * 500:.0f}" ry="{depth * 500:.0f}"'
            shapes.append(f'<ellipse cx="{x * 1000:.0f}" cy="{z * 1000:.0f}" {radii}{fill}/>')
        else:
            rounded = f' rx="{radius * 1000:.0f}"' if radius else ""
            at = f'x="{(x - width / 2) * 1000:.0f}" y="{(z - depth / 2) * 1000:.0f}"'
            shapes.append(f'<rect {at} width="{width * 1000:.0f}" height="{depth * 1000:.0f}"{rounded}{fill}/>')
    size = f"{body.width:g} {body.depth:g} {body.height:g}"
    return f'<g id="{name}" class="{style}" data-size="{size}">{"".join(shapes)}</g>\n'


def _opening(opening: PlacedOpening, thickness: float) -> str:
    """Returns a window as its frame and pane, a passage or garage door as dashed lines where walls go on above; doors have leaves."""
    half = thickness / 2
    along, across = (opening.start, opening.end), (opening.line - half, opening.line + half)

    def stretch(low: float, high: float) -> str:
        return _rectangle(*((*along, low, high) if opening.axis == "x" else (low, high, *along)))

    if opening.kind == "window":
        frame, pane = stretch(*across), stretch(opening.line - half * 0.24, opening.line + half * 0.24)
        return f'<path class="opening" data-id="{xml_text(opening.id)}" d="{frame}{pane}"/>\n'
    style = "opening" if opening.kind == "garage_door" else "dashed"
    box = stretch(opening.line - half * 0.4, opening.line + half * 0.4) if opening.kind == "garage_door" else stretch(*across)
    return "" if opening.kind == "door" else f'<path class="{style}" data-id="{xml_text(opening.id)}" d="{box}"/>\n'


def _leaf(leaf: DoorLeaf) -> str:
    """Returns a leaf that stands open at a right angle, and the arc that its end moves on."""
    if leaf.motion != "swing":
        return ""
    (x, _, z), width, half = leaf.hinge, leaf.width, leaf.thickness / 2
    shut, opened = math.radians(leaf.closed), math.radians(leaf.closed + leaf.swing)
    dx, dz = math.cos(opened), -math.sin(opened)
    ends = [(x - dz * half, z + dx * half), (x + dz * half, z - dx * half)]
    ends += [(ends[1][0] + dx * width, ends[1][1] + dz * width), (ends[0][0] + dx * width, ends[0][1] + dz * width)]
    points = " ".join(f"{a * 1000:.0f},{b * 1000:.0f}" for a, b in ends)
    tips = [(x + math.cos(at) * width, z - math.sin(at) * width) for at in (shut, opened)]
    start, end = (f"{a * 1000:.0f} {b * 1000:.0f}" for a, b in tips)
    arc = f"M{start}A{width * 1000:.0f} {width * 1000:.0f} 0 0 {0 if leaf.swing > 0 else 1} {end}"
    return f'<path class="arc" d="{arc}"/><polygon class="opening" data-id="{xml_text(leaf.id)}" points="{points}"/>\n'


def _swept(leaf: DoorLeaf) -> PlanBox:
    """Returns the box of the quarter circle that a leaf sweeps."""
    (x, _, z), shut, opened = leaf.hinge, math.radians(leaf.closed), math.radians(leaf.closed + leaf.swing)
    reach = 0.0 if leaf.motion == "roll" else leaf.width
    xs = (x, x + math.cos(shut) * leaf.width, x + math.cos(opened) * reach)
    zs = (z, z - math.sin(shut) * leaf.width, z - math.sin(opened) * reach)
    return min(xs), min(zs), max(xs), max(zs)


def _dimensions(outside: Sequence[Dimension], inside: Sequence[Dimension], sheet: PlanSheet) -> str:
    drawn = [*(dimension(line, sheet) for line in outside), *(dimension(line, sheet, backed=True) for line in inside)]
    paths, ticks, numbers = ("".join(one[i] for one in drawn) for i in range(3))
    return f'<path class="line" d="{paths}"/><path class="tick" d="{ticks}"/>\n{numbers}\n'


def _footprint(body: ModelBody) -> PlanBox:
    turn = math.radians(body.turn)
    cos, sin = abs(math.cos(turn)), abs(math.sin(turn))
    half_x, half_z = (body.width * cos + body.depth * sin) / 2, (body.width * sin + body.depth * cos) / 2
    return body.x - half_x, body.z - half_z, body.x + half_x, body.z + half_z


def _rectangle(x0: float, x1: float, z0: float, z1: float) -> str:
    return f"M{x0 * 1000:.0f} {z0 * 1000:.0f}H{x1 * 1000:.0f}V{z1 * 1000:.0f}H{x0 * 1000:.0f}z"


@lru_cache(4096)
def light(color: str, share: float) -> str:
    """Returns a colour moved towards white."""
    return shade(color, share)
