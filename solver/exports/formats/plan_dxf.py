"""DXF: a floor plan for CAD programmes, a file a storey, in metres: layers, a block a kind and size, dimensions that can be edited.

Its frame: x east, y north. A body is an insert of its block at its place and turn, with hidden attributes ID, KIND, Y (its underside in
the house), SIZE (width, depth, height) and MASS, in m and kg. What draws a room or an opening has extended data of the application OWN:
its id; an opening's sill and height, and whether it is the main entrance.
"""

import io
import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from importlib import import_module
from itertools import pairwise
from typing import Any, Final, NamedTuple

from solver.exports.model import DoorLeaf, HouseModel, ModelBody, PlacedOpening
from solver.exports.plan_rooms import LINE, Dimension, PlanBox, RoomLabel, said_of_room, too_short
from solver.exports.plan_storeys import HIGH, PlanMark, PlanStorey, marks_of, open_leaf, opening_box, storeys_of
from solver.exports.writers import ExportSettings, Files
from solver.free_names import FreeNames

LAYERS: Final = {
    "WALLS": 7, "DOORS": 1, "GARAGE_DOORS": 1, "WINDOWS": 5, "OPENINGS": 8, "RAILINGS": 8, "ROOMS": 252, "FURNITURE": 8, "DECORATIONS": 9,
    "HIGH": 9, "PEOPLE": 9, "NAMES": 7, "DIMENSIONS": 8,
}  # fmt: skip
"""Layers and their colours by AutoCAD's index."""
_LAYER_OF: Final = {"furniture": "FURNITURE", "decoration": "DECORATIONS", "dynamic": "PEOPLE"}
_FORBIDDEN: Final = "[^A-Za-z0-9_.-]"
_LONGEST: Final = 60
"""Letters of a kind in its block's name."""
_OF_BODIES: Final = ("ID", "NAME", "KIND", "Y", "SIZE", "MASS")
"""What the hidden attributes of an insert say of its body."""
OWN: Final = "COMPOSE_HOMES"
"""The application that extended data is of."""
_LONGEST_SAID: Final = 255
"""Bytes of a text in extended data."""
_METRES: Final = 6
_QUARTER: Final = math.tan(math.pi / 8)
"""What DXF calls the bulge of a quarter circle."""
_CONTROL: Final = str.maketrans({chr(code): f"^{chr(code + 64)}" for code in range(32)} | {"^": "^ "})
_HIDDEN: Final = 1


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.dxf`, or `<house>_level_<n>.dxf` where there are several storeys."""
    return {f"{storey.stem}.dxf": _DxfPlan(model, storey).text() for storey in storeys_of(model)}


def dxf_text(words: str) -> str:
    """Returns text for one line of a DXF file: control characters as it writes them, no half of a surrogate pair."""
    return words.encode("utf-8", "replace").decode().translate(_CONTROL)


class _Look(NamedTuple):
    """How a line of text looks: its letters' height, m, its turn in degrees, where its point is on it, and its layer."""

    size: float
    turn: float = 0.0
    align: str = "MIDDLE_CENTER"
    layer: str = "NAMES"


@contextmanager
def _undated(ezdxf: Any) -> Iterator[None]:
    """Lets the library write no day and no random number: equal houses give equal files."""
    options = ezdxf.options
    before, options.write_fixed_meta_data_for_testing = options.write_fixed_meta_data_for_testing, True
    try:
        yield
    finally:
        options.write_fixed_meta_data_for_testing = before


class _DxfPlan:
    """Draws one storey."""

    def __init__(self, model: HouseModel, storey: PlanStorey) -> None:
        self.model, self.storey = model, storey
        self.ezdxf: Any = import_module("ezdxf")  # an extra
        with _undated(self.ezdxf):
            self.doc = self.ezdxf.new("R2010")
        self.doc.units = _METRES
        for name, color in LAYERS.items():
            self.doc.layers.add(name, color=color)
        self.doc.appids.add(OWN)
        self.doc.linetypes.add("DASHED", [0.15, 0.1, -0.05])
        self.doc.layers.get("HIGH").dxf.linetype = "DASHED"
        self.doc.layers.get("OPENINGS").dxf.linetype = "DASHED"
        self.doc.styles.add("PLAN", font="arial.ttf")
        self.space: Any = self.doc.modelspace()
        self.blocks: dict[object, str] = {}
        self.names = FreeNames(_FORBIDDEN)

    def text(self) -> bytes:
        """Returns the file."""
        storey = self.storey
        for number, warning in enumerate(self.model.warnings, 1):
            self.doc.header.custom_vars.append(f"Warning {number}", dxf_text(warning))
        for room in storey.rooms:
            _say(self._polygon(room.corners, "ROOMS"), *said_of_room(room).values())
        self._walls(storey.walls)
        for box in storey.railings:
            self._polygon(_corners(box), "RAILINGS")
        for opening in storey.openings:
            self._opening(opening)
        for leaf in storey.leaves:
            if leaf.motion == "swing":
                self._leaf(leaf)
        for body in storey.bodies:
            self._body(body)
        for line in storey.outside:
            self._chain(line)
        for label in storey.labels:
            self._label(label)
        for row, words in enumerate(storey.words[:-1]):
            at = (storey.sheet.west + storey.sheet.gap, -storey.sheet.south + storey.sheet.gap * (2 - row))
            self._words(words, at, _Look(storey.sheet.letters, align="LEFT"))
        return self._written()

    def _written(self) -> bytes:
        """Returns the file's bytes: the same on every day."""
        sheet = self.storey.sheet
        self.doc.set_modelspace_vport(sheet.south - sheet.north, ((sheet.west + sheet.east) / 2, -(sheet.north + sheet.south) / 2))
        self._order_classes()
        text = io.StringIO()
        with _undated(self.ezdxf):
            self.doc.write(text)
        return text.getvalue().encode()

    def _order_classes(self) -> None:
        """Registers the classes in use by name: the library takes them from a set, whose order differs from process to process."""
        classes = self.doc.classes
        classes.add_required_classes(self.doc.dxfversion)
        classes.classes = dict(sorted(classes.classes.items()))

    def _polygon(self, corners: Iterable[tuple[float, float]], layer: str) -> Any:
        return self.space.add_lwpolyline([_flat(x, z) for x, z in corners], close=True, dxfattribs={"layer": layer})

    def _walls(self, boxes: Sequence[PlanBox]) -> None:
        """Draws walls as outlines, and filled."""
        for box in boxes:
            self._polygon(_corners(box), "WALLS")
            hatch = self.space.add_hatch(color=256, dxfattribs={"layer": "WALLS"})
            hatch.paths.add_polyline_path([_flat(x, z) for x, z in _corners(box)], is_closed=True)

    def _opening(self, opening: PlacedOpening) -> None:
        drawn = {"window": ("WINDOWS", (1.0, 0.24)), "garage_door": ("GARAGE_DOORS", (0.4,)), "passage": ("OPENINGS", (1.0,))}
        layer, shares = drawn.get(opening.kind, ("DOORS", ()))
        for share in shares:
            _say_opening(self._polygon(_corners(opening_box(opening, share)), layer), opening)

    def _leaf(self, leaf: DoorLeaf) -> None:
        drawn = [self._polygon(open_leaf(leaf).corners, "DOORS")]
        start, end = sorted((leaf.closed, leaf.closed + leaf.swing))
        x, _, z = leaf.hinge
        drawn.append(self.space.add_arc(_flat(x, z), leaf.width, start, end, dxfattribs={"layer": "DOORS"}))
        (opening,) = (one for one in self.storey.openings if one.id == leaf.opening)
        for entity in drawn:
            _say_opening(entity, opening)

    def _body(self, body: ModelBody) -> None:
        layer = "HIGH" if body.y >= HIGH and body.sort != "dynamic" else _LAYER_OF[body.sort]
        inserted = self.space.add_blockref(
            self._block(body), _flat(body.x, body.z), dxfattribs={"layer": layer, "rotation": _tidy(body.turn)}
        )
        size = f"{body.width:.10g} {body.depth:.10g} {body.height:.10g}"
        said = body.id, body.name, body.kind or "", f"{body.y:.10g}", size, f"{body.mass:.10g}"
        for tag, words in zip(_OF_BODIES, said, strict=True):
            shown = {"layer": layer, "height": 0.05, "style": "PLAN", "flags": _HIDDEN}
            inserted.add_attrib(tag, dxf_text(words), _flat(body.x, body.z), dxfattribs=shown)

    def _block(self, body: ModelBody) -> str:
        """Returns the name of a body's block: one for each kind and size, seen from above."""
        key = (body.shape, body.width, body.depth, body.height)
        if key not in self.blocks:
            wished = f"{(body.kind or body.name)[:_LONGEST]}_{body.width * 1000:.0f}x{body.depth * 1000:.0f}"
            name = self.blocks[key] = self.names.take(wished.upper())
            block = self.doc.blocks.new(name)
            for tag in _OF_BODIES:
                block.add_attdef(tag, (0.0, 0.0), dxfattribs={"height": 0.05, "style": "PLAN", "flags": _HIDDEN})
            for mark in marks_of(body.parts):
                _mark(block, mark)
        return self.blocks[key]

    def _chain(self, line: Dimension) -> None:
        """Draws a chain as dimensions that CAD programmes measure again when something is moved."""
        for (start, end), text in zip(pairwise(line.stops), line.texts, strict=True):
            self._dimension(line, (start, end), text)

    def _dimension(self, line: Dimension, ends: tuple[float, float], text: float) -> None:
        size, along_x = self.storey.sheet.numbers, line.axis == "x"
        first, last = (_flat(at, line.at) if along_x else _flat(line.at, at) for at in ends)
        above = size * (0.8 if not too_short(ends[1] - ends[0], size) else 1.9)
        middle = _flat(text, line.at - above) if along_x else _flat(line.at - above, text)
        geometry = self.doc.blocks.new_anonymous_block(type_char="D")
        shown = {"layer": "DIMENSIONS"}
        geometry.add_line(first, last, dxfattribs=shown)
        tick = size * 0.35
        for x, y in (first, last):
            geometry.add_line((x - tick, y - tick), (x + tick, y + tick), dxfattribs=shown)
        self._words(f"{ends[1] - ends[0]:.2f}", middle, _Look(size, 0.0 if along_x else 90.0, layer="DIMENSIONS"), geometry)
        said = {
            "layer": "DIMENSIONS", "geometry": geometry.name, "dimtype": 32, "attachment_point": 5, "angle": 0.0 if along_x else 90.0,
            "defpoint": (*last, 0.0), "defpoint2": (*first, 0.0), "defpoint3": (*last, 0.0), "text_midpoint": (*middle, 0.0),
            "actual_measurement": round(ends[1] - ends[0], 6),
        }  # fmt: skip
        self.space.new_entity("DIMENSION", said)

    def _label(self, label: RoomLabel) -> None:
        turn = 90.0 if label.upright else 0.0
        rows = [*((words, label.size) for words in label.rows), *((words, label.small) for words in label.below)]
        away = -sum(size for _, size in rows) * LINE / 2
        for words, size in rows:
            middle = away + size * LINE / 2
            at = (label.x + middle, label.z) if label.upright else (label.x, label.z + middle)
            self._words(words, _flat(*at), _Look(size * 0.9, turn))
            away += size * LINE

    def _words(self, words: str, at: tuple[float, float], look: _Look, on: Any = None) -> None:
        from ezdxf.enums import TextEntityAlignment  # noqa: PLC0415 (an extra)

        shown = {"layer": look.layer, "style": "PLAN", "rotation": look.turn}
        text = (self.space if on is None else on).add_text(
            dxf_text(words).replace("%%", "% %"), height=round(look.size, 6), dxfattribs=shown
        )
        text.set_placement(at, align=TextEntityAlignment[look.align])


def _say_opening(entity: Any, opening: PlacedOpening) -> None:
    lengths = (opening.sill, opening.head - opening.sill)  # a CAD programme scales them with the entity
    _say(entity, opening.id, more=(*((1041, _tidy(one)) for one in lengths), (1070, int(opening.is_main_entrance))))


def _say(entity: Any, *words: str, more: Sequence[tuple[int, float]] = ()) -> None:
    """Gives an entity extended data."""
    said = [(1000, dxf_text(word).encode()[:_LONGEST_SAID].decode(errors="ignore")) for word in words]
    entity.set_xdata(OWN, [*said, *more])


def _mark(block: Any, mark: PlanMark) -> None:
    (x, y), half, deep = _flat(mark.x, mark.z), mark.width / 2, mark.depth / 2
    if mark.form == "ellipse":
        if abs(half - deep) < 1e-4:
            block.add_circle((x, y), _tidy(half))
        else:
            major, ratio = ((half, 0.0), deep / half) if half > deep else ((0.0, deep), half / deep)
            block.add_ellipse((x, y), major_axis=(_tidy(major[0]), _tidy(major[1]), 0.0), ratio=_tidy(ratio))
        return
    r = mark.radius
    corners = [(-half, -deep), (half, -deep), (half, deep), (-half, deep)]
    if not r:
        block.add_lwpolyline([(_tidy(x + a), _tidy(y + b)) for a, b in corners], close=True)
        return
    ways = [((0, r), (r, 0)), ((-r, 0), (0, r)), ((0, -r), (-r, 0)), ((r, 0), (0, -r))]
    points = []
    for (a, b), (into, out) in zip(corners, ways, strict=True):
        points += [(_tidy(x + a + into[0]), _tidy(y + b + into[1]), _QUARTER), (_tidy(x + a + out[0]), _tidy(y + b + out[1]), 0.0)]
    block.add_lwpolyline(points, format="xyb", close=True)


def _corners(box: PlanBox) -> tuple[tuple[float, float], ...]:
    x0, z0, x1, z1 = box
    return (x0, z0), (x1, z0), (x1, z1), (x0, z1)


def _flat(x: float, z: float) -> tuple[float, float]:
    """Returns a point of the scene in the drawing."""
    return _tidy(x), _tidy(-z)


def _tidy(value: float) -> float:
    return round(value, 6) + 0.0
