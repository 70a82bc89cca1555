"""sh3d: a home for Sweet Home 3D (7.0 and newer): `Home.xml` and a model of triangles a kind, in one archive.

Its frame: x east, y south, cm; angles in radians, clockwise seen from above. Walls are whole, as the programme cuts openings itself.
Ids, kinds and masses are properties of the pieces: `id`, `kind`, `mass`; small things say `sort`: decoration. A piece's whole name is its
property `name`, and `label` what it is shown as.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from solver.body_parts import BodyPart
from solver.exports.door_leaves import hinge_in, shut_parts
from solver.exports.model import Cuboid, DoorLeaf, FloorPlate, HouseModel, Paint, PlacedOpening, WallPanel
from solver.exports.paints import SURFACES, by_paint, channels, srgb
from solver.exports.plan_rooms import name_of, said_of_room, words_of
from solver.exports.solid_meshes import surface_of
from solver.exports.writers import ExportSettings, Files, zipped
from solver.exports.xml_text import xml_text

VERSION: Final = 7000
_OPENING_NAMES: Final = {"door": "Door", "garage_door": "Garage door", "passage": "Passage", "window": "Window"}


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.sh3d`."""
    shelf = _Models()
    body = "".join(_home(model, shelf))
    said = {"generator": "Compose", **{f"warning {n + 1}": warning for n, warning in enumerate(model.warnings)}}
    properties = "".join(_property(name, value) for name, value in said.items())
    highest = max((panel.height for panel in model.panels), default=2.8)
    home = f"<home version='{VERSION}' name='{xml_text(words_of(model.name))}' camera='topCamera' wallHeight='{_cm(highest)}'>"
    text = f"<?xml version='1.0' encoding='UTF-8'?>\n{home}\n{properties}{body}</home>\n"
    return {f"{model.name}.sh3d": zipped({"Home.xml": text.encode(), **shelf.files})}


@dataclass
class _Models:
    """The models of triangles that pieces are made of, each once."""

    files: dict[str, bytes] = field(default_factory=dict)
    known: dict[object, str] = field(default_factory=dict)

    def of(self, parts: Sequence[BodyPart], paints: Sequence[Paint], size: tuple[float, float, float], key: object) -> str:
        """Returns the name of a model; `size` is the width, height and depth of its box, m."""
        if key not in self.known:
            folder = str(len(self.known))
            self.known[key] = f"{folder}/model.obj"
            groups = by_paint(parts, paints)
            self.files[f"{folder}/model.obj"] = "".join(_triangles(groups, size)).encode()
            self.files[f"{folder}/model.mtl"] = "".join(_material(n, paint) for n, paint in enumerate(groups)).encode()
        return self.known[key]


def _triangles(groups: Mapping[Paint, Sequence[BodyPart]], size: tuple[float, float, float]) -> Iterator[str]:
    """Yields a model's text in cm; two points as triangles without area make its box the body's, to which the programme fits it."""
    width, height, depth = (extent * 50 for extent in size)
    yield f"mtllib model.mtl\nv {-width:.3f} 0 {-depth:.3f}\nv {width:.3f} {2 * height:.3f} {depth:.3f}\n"
    first = 3
    for number, (_, parts) in enumerate(groups.items()):
        yield f"usemtl m{number}\n" + ("f 1 1 1\nf 2 2 2\n" if number == 0 else "")
        for part in parts:
            surface = surface_of(part)
            points = (surface.points * 100).round(3) + 0.0
            yield "".join([f"v {x:g} {y:g} {z:g}\n" for x, y, z in points.tolist()])
            yield "".join([f"f {a} {b} {c}\n" for a, b, c in (surface.triangles + first).tolist()])
            first += len(points)


def _material(number: int, paint: Paint) -> str:
    color = " ".join(f"{share:.4g}" for share in srgb(paint.color))
    return f"newmtl m{number}\nillum 1\nKa {color}\nKd {color}\nKs 0 0 0\nNs 0\nd {paint.opacity:g}\n"


def _home(model: HouseModel, shelf: _Models) -> Iterator[str]:
    """Yields what a home's element holds, in the order that its document type wants; low bodies first, as its plan draws them so."""
    storeys = {room.level: room for room in model.rooms}
    lone = len(storeys) == 1 and all(not room.elevation for room in storeys.values())
    level_of = {level: "" if lone else f" level='level{level}'" for level in storeys}
    if not lone:
        yield from (_level(storeys[level], model.thickness) for level in sorted(storeys))
    rooms = {room.id: room for room in model.rooms}
    for body in sorted(model.bodies, key=lambda body: body.y + body.height):
        key = (body.shape, body.paints, round(body.width, 4), round(body.height, 4), round(body.depth, 4))
        name = shelf.of(body.parts, body.paints, (body.width, body.height, body.depth), key)
        room = rooms.get(body.room or "")
        above, level = (body.y - room.elevation, level_of[room.level]) if room else (body.y, "")
        box = _Piece(body.x, above, body.z, body.turn, body.width, body.depth, body.height, level, name)
        said = {"id": body.id, "mass": f"{body.mass:g}", **({"kind": body.kind} if body.kind else {})}
        said |= {"sort": body.sort} if body.sort == "decoration" else {}
        shown = words_of(body.name)
        yield _piece("pieceOfFurniture", box, shown, {**said, "name": body.name, "label": shown})
    leaves = model.leaves_by_opening
    for opening in model.openings:
        yield _opening(opening, leaves.get(opening.id, []), shelf, level_of.get(opening.level, ""))
    yield from _railings(model, shelf, level_of)
    yield from (_wall(panel, level_of.get(panel.level, "")) for panel in model.panels)
    yield from (_room(room, level_of[room.level]) for room in model.rooms)


def _level(room: FloorPlate, thickness: float) -> str:
    name = f"Storey {room.level}"
    return (
        f"<level id='level{room.level}' name='{name}' elevation='{_cm(room.elevation)}' floorThickness='{_cm(thickness)}' "
        f"height='{_cm(room.ceiling - room.elevation)}' elevationIndex='0'/>\n"
    )


@dataclass(frozen=True)
class _Piece:
    """Where a piece is and how large, m: the middle of its footprint, its underside above its storey's floor, its turn in degrees.

    `level` is its storey as an attribute, `model` its model's name.
    """

    x: float
    y: float
    z: float
    turn: float
    width: float
    depth: float
    height: float
    level: str
    model: str


def _piece(tag: str, box: _Piece, name: str, said: Mapping[str, str], sash: str = "") -> str:
    angle = math.radians(-box.turn % 360.0)
    return (
        f"<{tag}{box.level} name='{xml_text(name)}' model='{box.model}' x='{_cm(box.x)}' y='{_cm(box.z)}' elevation='{_cm(box.y)}' "
        f"angle='{angle:.6g}' width='{_cm(box.width)}' depth='{_cm(box.depth)}' height='{_cm(box.height)}'>"
        f"{''.join(_property(key, value) for key, value in said.items())}{sash}</{tag}>\n"
    )


def _opening(opening: PlacedOpening, leaves: Sequence[DoorLeaf], shelf: _Models, level: str) -> str:
    """Returns a door, window or passage: its frame, its leaves or pane, and the sashes that the plan draws."""
    (x, z), turn = opening.middle, 0.0 if opening.axis == "x" else 90.0
    width, height, thickness = opening.end - opening.start, opening.head - opening.sill, opening.thickness
    made = shut_parts(opening, leaves, turn)
    parts, paints = tuple(_within_wall(part, thickness) for part, _ in made), tuple(paint for _, paint in made)
    sash = ""
    for leaf in leaves:
        if leaf.motion == "swing":
            hinge, relative = hinge_in(opening, leaf, turn), round(leaf.closed - turn)
            start, end = math.radians(relative), math.radians(relative + leaf.swing)
            where = f"xAxis='{hinge[0] / width + 0.5:.5g}' yAxis='{hinge[1] / thickness + 0.5:.5g}' width='{leaf.width / width:.5g}'"
            sash += f"<sash {where} startAngle='{start:.6g}' endAngle='{end:.6g}'/>"
    name = shelf.of(parts, paints, (width, height, thickness), (opening.kind, parts, paints, width, height))
    box = _Piece(x, opening.sill, z, turn, width, thickness, height, level, name)
    return _piece("doorOrWindow", box, _OPENING_NAMES.get(opening.kind, "Opening"), {"id": opening.id}, sash)


def _within_wall(part: BodyPart, thickness: float) -> BodyPart:
    """Returns a part of an opening, no deeper than the wall: the programme fits a model to its box."""
    (width, height, depth), (x, y, middle), most = part.size, part.at, thickness / 2
    low, high = max(-most, middle - depth / 2), min(most, middle + depth / 2)
    if high - low < 1e-4:
        low, high = (most - 1e-3, most) if middle > 0 else (-most, 1e-3 - most)
    return part._replace(size=(width, height, high - low), at=(x, y, (low + high) / 2))


def _railings(model: HouseModel, shelf: _Models, level_of: Mapping[int, str]) -> Iterator[str]:
    """Yields a piece for the railings of each storey."""
    for level, words in level_of.items():
        room = next(room for room in model.rooms if room.level == level)
        if boxes := model.railings(room):
            whole = Cuboid(*(min(box[i] for box in boxes) for i in range(3)), *(max(box[i] for box in boxes) for i in range(3, 6)))
            (x, _, z), (width, height, depth) = whole.middle, whole.size
            parts = [BodyPart("box", box.size, _from(box, whole), "y", 1.0, "body") for box in boxes]
            name = shelf.of(parts, [SURFACES["railing"]] * len(parts), whole.size, ("railing", level))
            box = _Piece(x, whole.y0 - room.elevation, z, 0.0, width, depth, height, words, name)
            yield _piece("pieceOfFurniture", box, "Railing", {})


def _from(box: Cuboid, whole: Cuboid) -> tuple[float, float, float]:
    (x, y, z), (a, _, c) = box.middle, whole.middle
    return x - a, y - whole.y0, z - c


def _wall(panel: WallPanel, level: str) -> str:
    ends = (panel.start, panel.line), (panel.end, panel.line)
    (x0, z0), (x1, z1) = ends if panel.axis == "x" else ((z, x) for x, z in ends)
    return (
        f"<wall{level} xStart='{_cm(x0)}' yStart='{_cm(z0)}' xEnd='{_cm(x1)}' yEnd='{_cm(z1)}' height='{_cm(panel.height)}' "
        f"thickness='{_cm(panel.thickness)}'/>\n"
    )


def _room(room: FloorPlate, level: str) -> str:
    points = "".join(f"<point x='{_cm(x)}' y='{_cm(z)}'/>" for x, z in room.corners)
    floor = f"floorColor='FF{''.join(f'{channel:02X}' for channel in channels(room.paint.color))}'"
    ceiling = "" if not room.outdoor else " ceilingVisible='false'"
    said = "".join(_property(key, value) for key, value in said_of_room(room).items())
    return f"<room{level} name='{xml_text(name_of(room))}' areaVisible='true' {floor}{ceiling}>{said}{points}</room>\n"


def _property(name: str, value: str) -> str:
    return f"<property name='{xml_text(name)}' value='{xml_text(value)}'/>"


def _cm(metres: float) -> str:
    return f"{metres * 100:.4f}".rstrip("0").rstrip(".") if metres else "0"
