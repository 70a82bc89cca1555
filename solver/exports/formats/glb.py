"""glTF 2.0, binary: for viewers, Blender, game engines, the web; the scene itself is inside, so that the file reads back.

The frame is the scene's own (y up, front towards +z, m). Geometry is written once a shape, in a box of size 1, and scaled by nodes.
"""

from collections.abc import Iterator, Mapping
from functools import lru_cache
from json.encoder import encode_basestring as quoted
from math import cos, radians, sin
from typing import Final, NamedTuple

from catalogs.fronts import BodyFront
from catalogs.shapes import Axis
from solver.body_parts import BodyPart
from solver.exports.asset_surfaces import fit_of
from solver.exports.colliders import FLOOR
from solver.exports.formats.glb_book import AssetNodes, Geometry, GltfBook, geometry_of
from solver.exports.model import Cuboid, DoorLeaf, FloorPlate, HouseModel, ModelBody, Paint, Point, WallBox
from solver.exports.moving_parts import HeldThing, held_in, held_things
from solver.exports.paints import PLAIN_CEILING, by_paint
from solver.exports.solid_meshes import BoxFace, box_faces, joined, scaled, surface_of
from solver.exports.writers import ExportSettings, Files
from solver.geometry import FloorRectangle, rectangles_of

_CUBE: Final = ((1.0, 1.0, 1.0), (0.0, 0.0, 0.0))
_FACES: Final[tuple[BoxFace, ...]] = (("x", -1), ("x", 1), ("y", -1), ("y", 1), ("z", -1), ("z", 1))
_SORTS: Final = {"furniture": "house/furniture", "decoration": "house/decorations", "dynamic": "house/people"}
_Node = tuple[str, str]
"""The name of the group a node is in, and its text."""


def write(model: HouseModel, settings: ExportSettings) -> Files:
    """Writes `<house>.glb`: a node a body, wall, leaf and floor under `house`; ceilings and people under nodes of their own."""
    writer = _Writer(model)
    groups: dict[str, list[int]] = {}
    for name, text in writer.nodes():
        groups.setdefault(name, []).append(writer.book.node(text))
    tops = [writer.book.node(f'{{"name":"{name}","children":{nodes}}}') for name, nodes in groups.items()]
    root = writer.book.node(f'{{"name":"house","children":{tops}}}') if tops else None
    return {f"{model.name}.glb": writer.book.file(root, model.warnings, settings.scene_text())}


class _Group(NamedTuple):
    """The parts of a shape that have one paint: the number of the first, and all their triangles in a box of size 1."""

    first: int
    geometry: Geometry


class _Writer:
    """Writes the nodes of one house into a book."""

    def __init__(self, model: HouseModel) -> None:
        self.book = GltfBook()
        self._model = model
        self._held: Mapping[str, HeldThing] = held_things(model.bodies)
        """What lies in drawers, by id."""
        self._shapes: dict[tuple[str, str | None, tuple[float, ...]], tuple[_Group, ...]] = {}
        self._meshes: dict[tuple[object, ...], int] = {}
        self._assets = AssetNodes(self.book, model.assets)

    def nodes(self) -> Iterator[_Node]:
        """Yields every node of the house but the groups."""
        model = self._model
        for room in model.rooms:
            yield from self._floor(room)
        for number, wall in enumerate(model.walls):
            yield "house/walls", _box_node(f"wall_{number}", wall.box, self._wall_mesh(wall))
        for number, fitting in enumerate(model.fittings):
            yield "house/fittings", _box_node(f"{fitting.surface}_{number}", fitting.box, self._box_mesh(fitting.paint))
        for leaf in model.leaves:
            yield "house/doors", self._door(leaf)
        for body in model.bodies:
            if body.id not in self._held:
                yield _SORTS[body.sort], self._body(body, (body.x, body.y, body.z), body.turn)

    def _floor(self, room: FloorPlate) -> Iterator[_Node]:
        """Yields a room's floor, and its ceiling, which is seen from below alone."""
        rectangles = tuple(rectangles_of(room.corners))
        if not rectangles:
            return
        name, area, height = quoted(room.id), round(room.area, 6), round(room.ceiling - room.elevation, 6)
        corners = [[round(x, 6), round(z, 6)] for x, z in room.corners]
        says = f'"id":{name},"type":{quoted(room.type)},"level":{room.level},"outdoor":{_flag(room.outdoor)}'
        extras = f'{{{says},"area":{area},"height":{height},"corners":{corners}}}'
        mesh = self.book.mesh("floor", [(_slabs(rectangles), room.paint)])
        yield "house/floors", f'{{"name":{name},"translation":[0,{round(room.elevation, 6)},0],"mesh":{mesh},"extras":{extras}}}'
        if not room.outdoor:
            mesh = self.book.mesh("ceiling", [(_sheets(rectangles), PLAIN_CEILING)])
            place = f'"translation":[0,{round(room.ceiling, 6)},0],"mesh":{mesh}'
            yield "house/ceilings", f'{{"name":{quoted(room.id + "/ceiling")},{place},"extras":{{"room":{name}}}}}'

    def _wall_mesh(self, wall: WallBox) -> int:
        key = wall.axis, wall.lesser, wall.greater, wall.rest
        if key not in self._meshes:
            across: Axis = "z" if wall.axis == "x" else "x"
            faces: dict[Paint, list[BoxFace]] = {}
            for face in _FACES:
                paint = wall.rest if face[0] != across else wall.greater if face[1] > 0 else wall.lesser
                faces.setdefault(paint, []).append(face)
            self._meshes[key] = self.book.mesh("wall", [(_box(tuple(some)), paint) for paint, some in faces.items()])
        return self._meshes[key]

    def _box_mesh(self, paint: Paint) -> int:
        key = ("box", paint)
        if key not in self._meshes:
            self._meshes[key] = self.book.mesh("box", [(_box(_FACES), paint)])
        return self._meshes[key]

    def _door(self, leaf: DoorLeaf) -> str:
        """Returns the node of a hinge, its +x along the closed leaf; the leaf is the node below."""
        key = leaf.parts, leaf.paints
        if key not in self._meshes:
            self._meshes[key] = self.book.mesh(leaf.look, [(_leaf(some), paint) for paint, some in by_paint(*key).items()])
        half = round(leaf.width / 2, 6)
        child = self.book.node(f'{{"name":{quoted(leaf.id + "/leaf")},"translation":[{half},0,0],"mesh":{self._meshes[key]}}}')
        turns = leaf.motion == "swing"
        reach = sorted((0.0, leaf.swing if turns else round(leaf.height, 6)))
        at = f',"at":{round(leaf.opened, 6)}' if leaf.open else ""
        joint = (
            f'{{"type":"{"revolute" if turns else "prismatic"}","axis":[0,1,0],"range":{reach},"unit":"{"degree" if turns else "m"}"{at}}}'
        )
        extras = f'{{"id":{quoted(leaf.id)},"category":"door","mass":{leaf.mass},"joint":{joint}}}'
        x, y, z = (round(value, 6) for value in leaf.hinge)
        turn, lift = (leaf.opened, 0.0) if turns else (0.0, round(leaf.opened, 6))
        name = quoted(leaf.id)
        place = f'"translation":[{x},{round(y + lift, 6)},{z}],"rotation":{_turned(leaf.closed + turn)}'
        return f'{{"name":{name},{place},"children":[{child}],"extras":{extras}}}'

    def _body(self, body: ModelBody, at: Point, turn: float) -> str:
        """Returns the node of a body at a place, turned: in the house, or in the drawer it lies in."""
        name, kind, parent, room = quoted(body.id), _text(body.kind), _text(body.parent), _text(body.room)
        says = f'"id":{name},"sort":"{body.sort}","kind":{kind},"category":{quoted(body.category)},"room":{room},"parent":{parent}'
        extras = f'{{{says},"labels":{_labels(body.labels)},"mass":{body.mass},"fixed":{_flag(body.fixed)}}}'
        place = f'"translation":[{at[0]},{at[1]},{at[2]}],"rotation":{_turned(turn)}'
        if body.asset:
            fit = fit_of(self._model.assets[body.asset], (body.width, body.depth, body.height))
            return f'{{"name":{name},{place},"children":[{self._assets.below(body.asset, fit)}],"extras":{extras}}}'
        size = f"[{max(1e-6, round(body.width, 6))},{max(1e-6, round(body.height, 6))},{max(1e-6, round(body.depth, 6))}]"
        if not body.fronts:
            return f'{{"name":{name},{place},"scale":{size},"mesh":{self._body_mesh(body, None)},"extras":{extras}}}'
        shape = self.book.node(f'{{"name":{quoted(body.id + "/shape")},"scale":{size},"mesh":{self._body_mesh(body, None)}}}')
        children = [shape, *(self._front(body, front, size) for front in body.fronts)]
        return f'{{"name":{name},{place},"children":{children},"extras":{extras}}}'

    def _front(self, body: ModelBody, front: BodyFront, size: str) -> int:
        """Adds the node of a front at its hinge, and below it what moves; returns its number."""
        x, y, z = (round(value, 6) for value in front.hinge)
        name = f"{body.id}/{front.name}"
        back = f'"translation":[{-x},{-y},{-z}],"scale":{size}'
        child = self.book.node(f'{{"name":{quoted(name + "/panel")},{back},"mesh":{self._body_mesh(body, front.name)}}}')
        inside = [self.book.node(self._body(one.body, one.at, one.turn)) for one in held_in(self._held, body.id, front.name)]
        axis = [int(one == front.axis) for one in "xyz"]
        reach = sorted((0.0, round(front.end, 6)))
        kind, unit = ("prismatic", "m") if front.slides else ("revolute", "degree")
        joint = f'{{"type":"{kind}","axis":{axis},"range":{reach},"unit":"{unit}"}}'
        extras = f'{{"id":{quoted(name)},"front":{quoted(front.name)},"joint":{joint}}}'
        return self.book.node(f'{{"name":{quoted(name)},"translation":[{x},{y},{z}],"children":{[child, *inside]},"extras":{extras}}}')

    def _body_mesh(self, body: ModelBody, front: str | None) -> int:
        """Returns the mesh of a body's shape in its paints, or of one of its fronts; what has no shape gets one for its own size."""
        size = (body.width, body.height, body.depth)
        shape = body.shape, front, () if body.shape else size
        key = *shape, id(body.paints)
        if key not in self._meshes:
            if shape not in self._shapes:
                self._shapes[shape] = _groups(body.parts, size, front)
            painted = [(geometry, body.paints[first]) for first, geometry in self._shapes[shape]]
            self._meshes[key] = self.book.mesh(front or body.shape or "block", painted)
        return self._meshes[key]


@lru_cache(maxsize=2048)
def _groups(parts: tuple[BodyPart, ...], size: tuple[float, float, float], front: str | None) -> tuple[_Group, ...]:
    """Returns a body's parts that move with a front, or with none, by their slots, in a unit box; soft edges are right for this size."""
    slots: dict[str, list[int]] = {}
    for number in (number for number, part in enumerate(parts) if part.front == front):
        part = parts[number]
        slots.setdefault(part.material, []).append(number)
    share = [1 / value for value in size]
    return tuple(
        _Group(numbers[0], geometry_of(scaled(joined(surface_of(parts[number]) for number in numbers), share)))
        for numbers in slots.values()
    )


@lru_cache(maxsize=512)
def _leaf(parts: tuple[BodyPart, ...]) -> Geometry:
    return geometry_of(joined(map(surface_of, parts)))


@lru_cache(maxsize=64)
def _box(faces: tuple[BoxFace, ...]) -> Geometry:
    return geometry_of(box_faces(*_CUBE, faces))


@lru_cache(maxsize=1024)
def _slabs(rectangles: tuple[FloorRectangle, ...]) -> Geometry:
    return geometry_of(joined(box_faces(*_plate(rectangle), _FACES) for rectangle in rectangles))


@lru_cache(maxsize=1024)
def _sheets(rectangles: tuple[FloorRectangle, ...]) -> Geometry:
    """Returns a ceiling at height 0, to be seen from below."""
    plates = map(_plate, rectangles)
    return geometry_of(joined(box_faces(size, (x, -y, z), (("y", -1),)) for size, (x, y, z) in plates))


def _plate(rectangle: FloorRectangle) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """Returns the size and the middle of a plate whose top is at 0."""
    west, north, east, south = rectangle
    return (east - west, FLOOR, south - north), ((west + east) / 2, -FLOOR / 2, (north + south) / 2)


def _box_node(name: str, box: Cuboid, mesh: int) -> str:
    at, size = ([round(value, 6) for value in values] for values in (box.middle, box.size))
    return f'{{"name":"{name}","translation":{at},"scale":{size},"mesh":{mesh}}}'


@lru_cache(maxsize=4096)
def _turned(turn: float) -> str:
    """Returns a turn about y as a quaternion, x y z w."""
    half = radians(turn) / 2
    return f"[0,{round(sin(half), 9)},0,{round(cos(half), 9)}]"


@lru_cache(maxsize=4096)
def _labels(labels: tuple[str, ...]) -> str:
    return f"[{','.join(map(quoted, labels))}]"


def _text(text: str | None) -> str:
    return "null" if text is None else quoted(text)


def _flag(flag: bool) -> str:
    return "true" if flag else "false"
