"""SVG: a floor plan to scale, a file a storey, as an architect draws it; north is up, a unit is a millimetre of the house.

What a body is stands at its `<use>`: `data-id`, `data-kind`, `data-y` (its underside in the house), `data-mass`; its unrotated size at
the symbol that it uses (`data-size`: width, depth, height), in m and kg. Rooms say `data-id` and `data-room` (their type); each opening is
also an invisible line along its wall with `data-opening` (its kind), so that /import reads the plan back.
"""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Final

from solver.body_parts import BodyPart
from solver.exports.model import DoorLeaf, FloorPlate, HouseModel, ModelBody, Paint, PlacedOpening
from solver.exports.paints import shade
from solver.exports.plan_rooms import PlanBox, words_of
from solver.exports.plan_sheet import dimension, entrance_mark, foot, frame, room_name
from solver.exports.plan_storeys import HIGH, PlanStorey, drawing_ranks, marks_of, open_leaf, opening_box, storeys_of
from solver.exports.writers import ExportSettings, Files
from solver.exports.xml_text import xml_text

LIGHTER: Final = 0.74
"""How far colours are moved towards white, so that all words can be read and ink is spared."""
FLOOR_LIGHTER: Final = 0.86


def write(model: HouseModel, settings: ExportSettings) -> Files:
    """Writes `<house>.svg`, or `<house>_level_<n>.svg` where there are several storeys."""
    return {f"{storey.stem}.svg": "".join(_drawn(model, storey)).encode() for storey in storeys_of(model, settings.scale, settings.called)}


def _drawn(model: HouseModel, storey: PlanStorey) -> Iterator[str]:
    """Yields a file's text, what lies lowest first."""
    yield storey.sheet.opened(_said_of_all(model, storey)) + f"<title>{xml_text(words_of(model.name))}</title>\n"
    yield from (f"<desc>{xml_text(warning)}</desc>\n" for warning in model.warnings)
    yield from map(_floor, storey.rooms)
    yield from _bodies(storey.bodies)
    yield _path("walls", storey.walls) + _path("opening", storey.railings)
    yield from map(_opening, storey.openings)
    yield from map(_stated, storey.openings)
    yield from (_leaf(leaf) for leaf in storey.leaves if leaf.motion == "swing")
    yield from (entrance_mark(opening, storey.sheet) for opening in storey.openings if opening.is_main_entrance)
    for axis in ("x", "z"):  # a group each: who shows a part of the sheet leaves out those that are cut
        yield _chains(axis, [dimension(line, storey.sheet) for line in storey.outside if line.axis == axis])
    yield from map(room_name, storey.labels)
    yield frame(storey.sheet) + foot(storey.sheet, storey.words) + "</svg>\n"


def _said_of_all(model: HouseModel, storey: PlanStorey) -> str:
    """Returns the attributes by which the file's lengths are understood: its unit, the walls', and its storey in that unit."""
    said = f'data-unit="mm" data-drawn="lines" data-wall-thickness="{model.thickness * 1000:g}"'
    if not storey.rooms:
        return said
    room = storey.rooms[0]
    height, floor = (room.ceiling - room.elevation) * 1000, room.elevation * 1000
    return f'{said} data-level="{room.level}" data-elevation="{floor:g}" data-level-height="{height:.10g}"'


def _floor(room: FloorPlate) -> str:
    points = " ".join(f"{x * 1000:.0f},{z * 1000:.0f}" for x, z in room.corners)
    said = f'data-id="{xml_text(room.id)}" data-room="{xml_text(room.type)}" data-outdoor="{"true" if room.outdoor else "false"}"'
    called = f' data-name="{xml_text(room.name)}"' if room.name else ""
    outer = " ".join("-" if one is None else f"{one * 1000:.10g}" for one in room.outer)
    called += f' data-outer-walls="{outer}"' if outer else ""
    return f'<polygon class="floor" {said}{called} points="{points}" fill="{light(room.paint.color, FLOOR_LIGHTER)}"/>\n'


def _bodies(bodies: Sequence[ModelBody]) -> Iterator[str]:
    """Yields the symbols that bodies use, then the bodies, the lowest first; what hangs high is dashed."""
    symbols: dict[tuple[object, ...], str] = {}
    ranks = drawing_ranks(bodies)
    drawn, texts = [], ["<defs>\n"]
    for body in bodies:
        high = body.y >= HIGH and body.sort != "dynamic"
        key = (id(body.parts), id(body.paints), high, body.sort)
        symbol = symbols.get(key)
        if symbol is None:
            symbol = symbols[key] = f"s{len(symbols)}"
            texts.append(_symbol(symbol, body, high))
        kind = f' data-kind="{xml_text(body.kind)}"' if body.kind else ""
        turn = f"rotate({-body.turn:g})" if body.turn else ""
        at = f"translate({body.x * 1000:.10g} {body.z * 1000:.10g}){turn}"
        said = f'data-id="{xml_text(body.id)}" data-name="{xml_text(body.name)}"{kind} data-sort="{body.sort}"'
        said += f' data-y="{body.y:g}" data-mass="{body.mass:g}"'
        drawn.append((high, ranks[body.id], f'<use xlink:href="#{symbol}" transform="{at}" {said}/>\n'))
    drawn.sort(key=lambda one: one[:2])
    texts.append("</defs>\n")
    yield "".join(texts)
    yield from (text for _, _, text in drawn)


def _symbol(name: str, body: ModelBody, high: bool) -> str:
    style = "high" if high else "item" if body.sort == "decoration" else "body"
    size = f"{body.width:.10g} {body.depth:.10g} {body.height:.10g}"
    return f'<g id="{name}" class="{style}" data-size="{size}">{_shapes(body.parts, () if high else body.paints)}</g>\n'


@lru_cache(maxsize=1 << 12)
def _shapes(parts: tuple[BodyPart, ...], paints: tuple[Paint, ...]) -> str:
    """Returns the outlines of parts, filled with their paints if there are any."""
    shapes = []
    for form, x, z, width, depth, radius, part in marks_of(parts):
        fill = f' fill="{light(paints[part].color, LIGHTER)}"' if paints else ""
        if form == "ellipse":
            radii = f'rx="{width * 500:.0f}" ry="{depth * 500:.0f}"'
            shapes.append(f'<ellipse cx="{x * 1000:.0f}" cy="{z * 1000:.0f}" {radii}{fill}/>')
        else:
            rounded = f' rx="{radius * 1000:.0f}"' if radius else ""
            at = f'x="{(x - width / 2) * 1000:.0f}" y="{(z - depth / 2) * 1000:.0f}"'
            shapes.append(f'<rect {at} width="{width * 1000:.0f}" height="{depth * 1000:.0f}"{rounded}{fill}/>')
    return "".join(shapes)


def _opening(opening: PlacedOpening) -> str:
    """Returns a window as its frame and pane, a garage door as its panel, a passage as the dashed edges of what is above."""
    if opening.kind == "window":
        return _path("opening", [opening_box(opening), opening_box(opening, 0.24)], opening.id)
    if opening.kind == "garage_door":
        return _path("opening", [opening_box(opening, 0.4)], opening.id)
    return _path("dashed", [opening_box(opening)], opening.id) if opening.kind == "passage" else ""


def _stated(opening: PlacedOpening) -> str:
    """Returns an opening as a line that is not seen, and what cannot be drawn of it."""
    line, ends = opening.line * 1000, (opening.start * 1000, opening.end * 1000)
    (x0, z0), (x1, z1) = ((end, line) if opening.axis == "x" else (line, end) for end in ends)
    said = f'data-id="{xml_text(opening.id)}" data-opening="{opening.kind}" x1="{x0:.10g}" y1="{z0:.10g}" x2="{x1:.10g}" y2="{z1:.10g}"'
    said += f' data-sill="{opening.sill * 1000:.10g}" data-height="{(opening.head - opening.sill) * 1000:.10g}"'
    if opening.kind == "door":
        aim = 1000 * opening.towards
        x, z = ((x0 + x1) / 2, z0 + aim) if opening.axis == "x" else (x0 + aim, (z0 + z1) / 2)
        said += f' data-hinge="{opening.hinge}" data-towards="{x:.10g} {z:.10g}"'
    main = "true" if opening.is_main_entrance else "false"
    return f'<line {said} data-main-entrance="{main}"/>\n'


def _leaf(leaf: DoorLeaf) -> str:
    """Returns a leaf that stands open, and the arc that its end moves on."""
    stands, radius = open_leaf(leaf), f"{leaf.width * 1000:.0f}"
    points = " ".join(f"{x * 1000:.0f},{z * 1000:.0f}" for x, z in stands.corners)
    start, end = (f"{x * 1000:.0f} {z * 1000:.0f}" for x, z in (stands.shut, stands.opened))
    arc = f"M{start}A{radius} {radius} 0 0 {0 if leaf.swing > 0 else 1} {end}"
    return f'<path class="arc" d="{arc}"/><polygon class="opening" data-id="{xml_text(leaf.opening)}" points="{points}"/>\n'


def _chains(axis: str, drawn: Sequence[tuple[str, str, str]]) -> str:
    paths, ticks, numbers = ("".join(one[i] for one in drawn) for i in range(3))
    return f'<g class="lengths" data-along="{axis}"><path class="line" d="{paths}"/><path class="tick" d="{ticks}"/>\n{numbers}</g>\n'


def _path(style: str, boxes: Sequence[PlanBox], identity: str | None = None) -> str:
    said = "" if identity is None else f' data-id="{xml_text(identity)}"'
    d = "".join(f"M{x0 * 1000:.0f} {z0 * 1000:.0f}H{x1 * 1000:.0f}V{z1 * 1000:.0f}H{x0 * 1000:.0f}z" for x0, z0, x1, z1 in boxes)
    return f'<path class="{style}"{said} d="{d}"/>\n' if boxes else ""


@lru_cache(4096)
def light(color: str, share: float) -> str:
    """Returns a colour moved towards white."""
    return shade(color, share)
