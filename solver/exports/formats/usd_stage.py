"""USD: a house that simulates (Isaac Sim, Isaac Lab, Omniverse, Blender): kinds once, colliders, masses, doors on joints, labels.

The frame is USD's for simulators: z up, y north, front towards -y, m, kg, degrees. The text needs no library; usd-core packs it.
Isaac Lab-Arena wants an environment beside it, which names what is in the house.
"""

import json
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Final

from solver.exports.colliders import box_between, carriers, floor_boxes, is_one_box, z_up
from solver.exports.model import Cuboid, FloorPlate, HouseModel, ModelBody, Paint, WallBox
from solver.exports.moving_parts import held_fast, moving_parts, still_part
from solver.exports.paints import PLAIN_CEILING
from solver.exports.usd_bodies import AssetLayers, body_guides, body_kind, door_text, front_text, held_text, wall_kind
from solver.exports.usd_text import LOOKS, cube, group, material_name, material_text, placed, prim, said, stretched, texts
from solver.exports.writers import ExportSettings, Files, zipped
from solver.free_names import FreeNames
from solver.geometry import rectangles_of
from solver.version import VERSION

CEILING: Final = 0.01
"""How thick ceilings are, m."""
_SORTS: Final = {"furniture": "Furniture", "decoration": "Decorations", "dynamic": "People"}
_SKY: Final = """def DomeLight "Sky"
{
float inputs:intensity = 1000
}
"""
_GRAVITY: Final = """def PhysicsScene "PhysicsScene"
{
vector3f physics:gravityDirection = (0, 0, -1)
float physics:gravityMagnitude = 9.81
}
"""
"""What stands beside the house: whoever refers to the house alone brings a sky and a scene of their own."""
_LABELS: Final = {"Walls": "wall", "Ceilings": "ceiling"}
"""The label of all that is in a group; what is in the others says its own."""
_FILTER: Final = """def PhysicsCollisionGroup "Building"
{
rel collection:colliders:includes = [</House/Floors>, </House/Walls>, </House/Fittings>]
}
def PhysicsCollisionGroup "Leaves"
{
rel collection:colliders:includes = </House/Doors>
rel physics:filteredGroups = </House/Building>
}
"""
"""Leaves turn inside their frames: the two do not touch."""
_ENVIRONMENT: Final = """\
# An environment of Isaac Lab-Arena. Register a background `{name}` whose usd_path is {name}.usda, and add `embodiment` and `task`.
"""


def write(model: HouseModel, settings: ExportSettings) -> Files:
    """Writes `<house>.usda`, or `.usdc` or `.usdz` where the format says so; for arena an environment beside it, which brings its light."""
    stage, name = _Stage(model), model.name
    text, beside = stage.text(_GRAVITY if settings.format == "arena" else _SKY + _GRAVITY), stage.layers.files
    if settings.format == "arena":
        return {f"{name}.usda": text.encode(), f"{name}_arena.yaml": _environment(model).encode(), **beside}
    if settings.format not in ("usdc", "usdz"):
        return {f"{name}.usda": text.encode(), **beside}
    from pxr import Sdf  # noqa: PLC0415 (an extra)

    layer = Sdf.Layer.CreateAnonymous(".usda")
    layer.ImportFromString(text)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"{name}.usdc")
        layer.Export(str(path))
        whole = {path.name: path.read_bytes(), **beside}
    return whole if settings.format == "usdc" else {f"{name}.usdz": zipped(whole, aligned=64)}


def _environment(model: HouseModel) -> str:
    """Returns an environment of Isaac Lab-Arena: the house as its background, and a reference for each body; in the frame of USD.

    It also wants a robot and a task, which are the user's: the text says where.
    """
    told = "".join(f"# {json.dumps(warning)}\n" for warning in model.warnings)
    references = [
        f"- {{id: {path.rpartition('/')[2]}, parent_id: {model.name}, prim_path: {path.removeprefix('/House/')}, object_type: {kind}}}\n"
        for path, kind in zip(prim_paths(model).values(), ("base" if body.fixed else "rigid" for body in model.bodies), strict=True)
    ]
    listed = f"object_references:\n{''.join(references)}" if references else "object_references: []\n"
    return (
        f"{_ENVIRONMENT.format(name=model.name)}{told}env_name: {model.name}\n"
        f"background: {{id: {model.name}, registry_name: {model.name}}}\nobjects: []\n{listed}relations: []\n"
    )


def prim_paths(model: HouseModel) -> dict[str, str]:
    """Returns the path of each body's prim, by the body's id."""
    names = FreeNames(r"[^A-Za-z0-9_]")
    return {body.id: f"/House/{_SORTS[body.sort]}/{prim_name(body.id, names)}" for body in model.bodies}


def front_names(model: HouseModel) -> dict[tuple[str, str], str]:
    """Returns the name of each front's prim, in /House/Fronts, by body and front."""
    names = FreeNames(r"[^A-Za-z0-9_]")
    return {(body.id, front.name): prim_name(f"{body.id}/{front.name}", names) for body in model.bodies for front in body.fronts}


def prim_name(wished: str, names: FreeNames) -> str:
    """Returns a name of a prim, which never begins with a digit."""
    return names.take(f"_{wished}" if wished[:1].isdigit() else wished)


class _Stage:
    """Puts one house together."""

    def __init__(self, model: HouseModel) -> None:
        self._model = model
        self.layers = AssetLayers(model.assets)
        self._carriers = carriers(model.bodies)
        self._names = FreeNames(r"[^A-Za-z0-9_]")
        self._held: Mapping[str, str] = {}
        """The joints of what does not move by itself and lies in drawers, by id."""
        self._kinds: dict[tuple[object, ...], str] = {}
        self._kind_texts: list[str] = []
        self._looks: dict[str, str] = {}

    def text(self, around: str) -> str:
        """Returns the stage; `around` is what stands beside the house."""
        model = self._model
        groups = {
            "Floors": "".join(map(self._floor, model.rooms)),
            "Ceilings": 'token visibility = "invisible"\n' + "".join(self._ceilings()),
            "Walls": "".join(self._wall(number, wall) for number, wall in enumerate(model.walls)),
            "Fittings": "".join(self._fittings()),
            "Doors": "".join(self._doors()),
            **dict.fromkeys(_SORTS.values(), ""),
        }
        bodies: dict[str, list[str]] = {}
        paths, names = prim_paths(model), front_names(model)
        self._held = {
            name: held_text(thing, f"/House/Fronts/{names[thing.piece, thing.front]}", paths[name])
            for name, thing in held_fast(model.bodies).items()
        }
        for body in model.bodies:
            bodies.setdefault(_SORTS[body.sort], []).append(self._body(body, paths[body.id].rpartition("/")[2]))
        groups |= {name: "".join(found) for name, found in bodies.items()}
        groups["Fronts"] = "".join(self._fronts(paths, names))
        inside = "".join(group(name, found, _LABELS.get(name)) for name, found in groups.items())
        looks = prim("Scope", "Looks", (), "".join(self._looks.values()))
        kinds = f'class Scope "Kinds"\n{{\n{"".join(self._kind_texts)}}}\n'
        told = f'string generator = "Compose {VERSION}"\nstring[] warnings = {texts(model.warnings)}\n'
        return (
            f'#usda 1.0\n(\ncustomLayerData = {{\n{told}}}\ndefaultPrim = "House"\n'
            f'kilogramsPerUnit = 1\nmetersPerUnit = 1\nupAxis = "Z"\n)\n'
            f'{around}def Xform "House" (\nkind = "assembly"\n)\n{{\n{looks}{kinds}{_FILTER}{inside}}}\n'
        )

    def _paint(self, paints: Iterable[Paint]) -> None:
        """Adds materials."""
        for paint in paints:
            name = material_name(paint)
            if name not in self._looks:
                self._looks[name] = material_text(paint)

    def _kind(self, key: tuple[object, ...], wished: str, inside: str) -> str:
        """Adds a kind and returns its name."""
        name = self._kinds[key] = prim_name(f"{wished}_1", self._names)
        self._kind_texts.append(f'class Xform "{name}"\n{{\n{inside}}}\n')
        return name

    def _body(self, body: ModelBody, name: str) -> str:
        boxed = is_one_box(body, self._carriers)
        if body.asset:
            return self._made(body, name, self.layers.shape(body) + body_guides(body, self._carriers))
        key = id(body.parts), id(body.paints), boxed, body.flat
        kind = self._kinds.get(key)
        if kind is None:
            self._paint(body.paints)
            kind = self._kind(key, body.shape or "block", body_kind(body, self._carriers))
        return self._made(body, name, f'def Xform "shape" (\ninstanceable = true\nreferences = </House/Kinds/{kind}>\n)\n{{\n}}\n')

    def _made(self, body: ModelBody, name: str, shape: str) -> str:
        """Returns the prim of a body, of which `shape` is what it looks like and collides as."""
        friction = f"friction_{body.friction * 1000:.0f}"
        if friction not in self._looks:
            self._looks[friction] = _friction(friction, body.friction)
        schemas = ["PhysicsMassAPI", "SemanticsLabelsAPI:class", "MaterialBindingAPI"]
        if not body.fixed or body.id in self._held:
            schemas.insert(0, "PhysicsRigidBodyAPI")
        size = body.width, body.depth, body.height
        words = {"id": body.id, "kind": body.kind, "category": body.category, "room": body.room, "parent": body.parent, "size": size}
        inside = (
            f"rel material:binding:physics = <{LOOKS}/{friction}>\nfloat physics:mass = {still_part(body, self._carriers).mass:.6g}\n"
            f"token[] semantics:labels:class = {texts(body.labels)}\n{placed(z_up(body.x, body.y, body.z), body.turn)}"
            f"{shape}{self._held.get(body.id, '')}"
        )
        return said("Xform", name, schemas, words, inside)

    def _floor(self, room: FloorPlate) -> str:
        self._paint([room.paint])
        boxes = "".join(cube(f"part_{i}", (box.size, box.at), room.paint) for i, box in enumerate(floor_boxes(room)))
        words = {"id": room.id, "type": room.type}
        inside = f"token[] semantics:labels:class = {texts(('floor', room.type))}\n{boxes}"
        return said("Xform", prim_name(room.id, self._names), ["SemanticsLabelsAPI:class"], words, inside)

    def _ceilings(self) -> Iterator[str]:
        """Yields ceilings, which are hidden until somebody shows them: a house is looked at from above."""
        self._paint([PLAIN_CEILING])
        for room in self._model.rooms:
            for west, north, east, south in () if room.outdoor else rectangles_of(room.corners):
                box = box_between(Cuboid(west, room.ceiling, north, east, room.ceiling + CEILING, south))
                yield cube(prim_name(f"ceiling_{room.id}", self._names), (box.size, box.at), PLAIN_CEILING, collides=False)

    def _wall(self, number: int, wall: WallBox) -> str:
        key = wall.axis, wall.lesser, wall.greater, wall.rest
        kind = self._kinds.get(key)
        if kind is None:
            self._paint(key[1:])
            kind = self._kind(key, f"wall_{wall.axis}", wall_kind(wall))
        box = box_between(wall.box)
        metadata = f"instanceable = true\nreferences = </House/Kinds/{kind}>\n"
        return f'def Xform "wall_{number}" (\n{metadata})\n{{\n{stretched(box.at, box.size)}}}\n'

    def _fittings(self) -> Iterator[str]:
        """Yields what is fitted into openings and to edges, a group a surface."""
        found: dict[str, str] = {}
        for number, fitting in enumerate(self._model.fittings):
            self._paint([fitting.paint])
            box, surface = box_between(fitting.box), fitting.surface
            made = cube(f"{surface}_{number}", (box.size, box.at), fitting.paint, surface != "threshold")
            found[surface] = found.get(surface, "") + made
        yield from (group(prim_name(surface, self._names), made, surface) for surface, made in found.items())

    def _doors(self) -> Iterator[str]:
        names = FreeNames(r"[^A-Za-z0-9_]")
        for leaf in self._model.leaves:
            self._paint(leaf.paints)
            yield door_text(leaf, prim_name(leaf.id, names))

    def _fronts(self, paths: Mapping[str, str], names: Mapping[tuple[str, str], str]) -> Iterator[str]:
        for body in self._model.bodies:
            for front in moving_parts(body):
                self._paint(front.paints)
                yield front_text(front, body, names[body.id, front.name], paths[body.id])


def _friction(name: str, friction: float) -> str:
    inside = f"float physics:dynamicFriction = {friction:g}\nfloat physics:staticFriction = {friction:g}\n"
    return prim("Material", name, ("PhysicsMaterialAPI",), inside)
