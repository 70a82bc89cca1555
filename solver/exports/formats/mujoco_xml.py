"""MJCF: one file for MuJoCo: visual geoms in group 2, colliders in group 3, hinged doors, free joints for what may move.

Frame: x east, y north, z up; (x, y, z) of the scene is (x, -z, y) here and turns keep their value, about +z.
"""

import json
import math
from collections.abc import Collection, Iterator, Mapping
from functools import lru_cache
from typing import Final, NamedTuple

from solver.body_parts import BodyPart
from solver.exports.colliders import FLOOR, Collider, Triple, box_around, box_between, carriers, floor_boxes, shares_of, wall_solids, z_up
from solver.exports.model import Cuboid, DoorLeaf, HouseModel, ModelBody, Paint
from solver.exports.moving_parts import (
    LEAF_DAMPING,
    LEAF_FRICTION,
    SLIDE_DAMPING,
    SLIDE_FRICTION,
    TURN_DAMPING,
    TURN_FRICTION,
    UNIT,
    HeldThing,
    MovingPart,
    held_fast,
    held_in,
    moving_leaf,
    moving_parts,
    still_part,
)
from solver.exports.object_files import AssetObjects
from solver.exports.paints import srgb
from solver.exports.writers import ExportSettings, Files
from solver.exports.xml_text import xml_numbers, xml_text
from solver.free_names import FreeNames

SLEEPS: Final = 0.005
"""What moves more slowly falls asleep, m/s: what lies on rounded rims rocks at up to 2 mm/s for ever, and keeps all about it awake."""
_HEAD: Final = f"""\
<compiler angle="degree"/>
<option timestep="0.004" integrator="implicitfast" sleep_tolerance="{SLEEPS:g}"><flag sleep="enable"/></option>
<visual><global offwidth="1920" offheight="1080"/><headlight ambient="0.35 0.35 0.35" diffuse="0.5 0.5 0.5"/></visual>
<default>
<default class="visual"><geom type="box" group="2" contype="0" conaffinity="0" mass="0"/></default>
<default class="wall"><geom type="box" group="3" rgba="0.6 0.6 0.6 1"/></default>
<default class="collider"><geom type="box" group="3" conaffinity="3" rgba="0.5 0.6 0.8 1"/></default>
<default class="flat"><geom type="box" group="3" contype="0" conaffinity="0"/></default>
<default class="leaf"><geom type="box" group="3" contype="2" conaffinity="2"/>\
<joint limited="true" damping="{LEAF_DAMPING:g}" frictionloss="{LEAF_FRICTION:g}" armature="0.05"/></default>
<default class="turns"><joint limited="true" damping="{TURN_DAMPING:g}" frictionloss="{TURN_FRICTION:g}" armature="0.01"/></default>
<default class="slides"><joint type="slide" limited="true" damping="{SLIDE_DAMPING:g}" frictionloss="{SLIDE_FRICTION:g}"/></default>
<default class="use"><site type="cylinder" size="0.1 0.005" group="4" rgba="0.2 0.7 0.3 0.5"/></default>
</default>"""
"""Bits of contacts: walls and floors meet bodies, bodies meet all, leaves meet bodies and each other, not the walls they hang in."""
YARD: Final = 5.0
"""How far the ground goes on around a house, m."""
_SUN: Final = '<light directional="true" pos="0 0 20" dir="0.3 0.4 -1" diffuse="0.5 0.5 0.5"/>'


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.xml`: names are ids; seed, catalog, labels and warnings stand in `custom`, the start in the key `home`."""
    objects = AssetObjects(model.assets, False)
    looks, names = MujocoLooks(objects), FreeNames()
    names.take("world")  # MuJoCo calls what all bodies hang on so
    carry = carriers(model.bodies)
    held = held_fast(model.bodies)
    bodies = _Bodies(looks, names, carry, held, [])
    world = [
        *_house(model, looks),
        *(bodies.text(body) for body in model.bodies if body.id not in held),
        *(bodies.leaf(leaf) for leaf in model.leaves),
        *_uses(model),
    ]
    lines = [
        f'<mujoco model="{xml_text(model.name)}">',
        _HEAD,
        *_custom(model),
        "<asset>",
        *looks.assets(),
        "</asset>",
        "<worldbody>",
        _SUN,
        *world,
        "</worldbody>",
        *_contacts(bodies.apart),
        f'<keyframe><key name="home" qpos="{_home(model)}"/></keyframe>',
        "</mujoco>",
    ]
    return {f"{model.name}.xml": "\n".join(lines).encode() + b"\n", **objects.files}


def _custom(model: HouseModel) -> Iterator[str]:
    """Yields what a simulator keeps but does not use: where the house is from, and what things are."""
    scene = model.scene
    labels = {body.id: body.labels for body in model.bodies}
    said = {
        "seed": "" if scene.seed is None else str(scene.seed),
        "catalog": xml_text(str((scene.generator or {}).get("catalog", ""))),
        "labels": f"{{{','.join([f'{_json(identity)}:{_json(words)}' for identity, words in labels.items()])}}}",
        "warnings": xml_text("\n".join(model.warnings)),
    }
    yield "<custom>"
    yield from (f'<text name="{name}" data="{words}"/>' for name, words in said.items() if words)
    yield "</custom>"


@lru_cache(maxsize=1 << 12)
def _json(value: str | tuple[str, ...]) -> str:
    """Returns an id or labels as JSON within an attribute."""
    return xml_text(json.dumps(value, ensure_ascii=False, separators=(",", ":")))


def _house(model: HouseModel, looks: "MujocoLooks") -> Iterator[str]:
    """Yields the walls, what is fitted to them, and the floors, which belong to the world."""
    for solid, paint in wall_solids(model):
        yield geom(solid, "visual", looks.painted(paint)) if paint else geom(solid, "wall")
    ground = min((floor.elevation for floor in model.rooms), default=0.0)
    yield geom(_ground(model, ground), "wall", ' name="ground"')
    for floor in model.rooms:
        for box in floor_boxes(floor):
            if floor.elevation > ground:
                yield geom(box, "wall")
            yield geom(box, "visual", looks.painted(floor.paint))


def _ground(model: HouseModel, height: float) -> Collider:
    """Returns the box that the lowest floors are the top of; a plane, which Drake cannot read, would do as well."""
    xs, zs = ([corner[i] for floor in model.rooms for corner in floor.corners] or [0.0] for i in (0, 1))
    around = Cuboid(min(xs) - YARD, height - FLOOR, min(zs) - YARD, max(xs) + YARD, height, max(zs) + YARD)
    return box_between(around)


class _Bodies(NamedTuple):
    """What bodies are written with; `held` are those that do not move by themselves and lie in drawers.

    What is written adds to `apart`: names of bodies that do not touch each other.
    """

    looks: "MujocoLooks"
    names: FreeNames
    carry: Collection[str]
    held: Mapping[str, HeldThing]
    apart: list[tuple[str, str]]

    def text(self, body: ModelBody) -> str:
        """Returns a body where it stands in the house."""
        return self._placed(body, z_up(body.x, body.y, body.z), body.turn)

    def _placed(self, body: ModelBody, at: Triple, turn: float) -> str:
        still, classed = still_part(body, self.carry), "flat" if body.flat else "collider"
        friction = f' friction="{xml_numbers(body.friction)}"'
        touching = touching_geoms(still.solids, still.mass, classed, friction)
        name = self.names.take(body.id)
        joint = "" if body.fixed else f'<freejoint name="{xml_text(name)}"/>'
        shown = self._shown(name, self.looks.asset(body) if body.asset else self.looks.parts(still.parts, still.paints))
        fronts = "".join([self._front(one, (body.id, name), friction) for one in moving_parts(body)])
        return f"{_opened(name, at, turn)}{joint}{touching}{shown}{fronts}</body>"

    def _shown(self, name: str, looks: str) -> str:
        """Returns what a body looks like, as a body in it: MuJoCo bounds all geoms of whatever touches anything in every step."""
        return f'<body name="{xml_text(self.names.take(f"{name}/looks"))}">{looks}</body>' if looks else ""

    def _front(self, front: MovingPart, of: tuple[str, str], friction: str) -> str:
        """Returns a front on its joint, in the body of a piece, by that one's id and its own name, and what is held in it; zero is shut."""
        (piece, body), name = of, self.names.take(front.id)
        self.apart.append((body, name))
        joint = _joint(front, name, "slides" if front.slides else "turns")
        touching = touching_geoms(front.solids, front.mass, "collider", friction)
        inside = "".join(self._placed(one.body, z_up(*one.at), one.turn) for one in held_in(self.held, piece, front.name))
        shown = self._shown(name, self.looks.parts(front.parts, front.paints))
        return f"{_opened(name, front.hinge, 0.0)}{joint}{touching}{shown}{inside}</body>"

    def leaf(self, leaf: DoorLeaf) -> str:
        """Returns a leaf on its hinge, or a garage door that slides up; zero is closed."""
        name, part = self.names.take(leaf.id), moving_leaf(leaf)
        joint = _joint(part, name, "leaf", ' type="slide"' if part.slides else "")
        touching = touching_geoms(part.solids, part.mass, "leaf")
        shown = self._shown(name, self.looks.parts(part.parts, part.paints))
        return f"{_opened(name, part.hinge, leaf.closed)}{joint}{touching}{shown}</body>"


def _joint(part: MovingPart, name: str, classed: str, more: str = "") -> str:
    """Returns the joint of what moves, in a body of that name; `more` attributes than its class has."""
    limits = f'axis="{UNIT[part.axis]}" range="{xml_numbers(*part.limits)}"'
    return f'<joint name="{xml_text(name)}/{part.way}" class="{classed}"{more} {limits}/>'


def _contacts(pairs: Collection[tuple[str, str]]) -> Iterator[str]:
    """Yields which bodies do not touch: a front and the body that it is a front of."""
    if pairs:
        yield "<contact>"
        yield from (f'<exclude body1="{xml_text(one)}" body2="{xml_text(other)}"/>' for one, other in pairs)
        yield "</contact>"


def _opened(name: str, at: Triple, turn: float) -> str:
    turned = f' euler="0 0 {xml_numbers(turn)}"' if turn else ""
    return f'<body name="{xml_text(name)}" pos="{xml_numbers(*at)}"{turned}>'


def _uses(model: HouseModel) -> Iterator[str]:
    """Yields where somebody stands who uses a piece; a site's x axis points to it."""
    floors = {floor.id: floor.elevation for floor in model.rooms}
    names = FreeNames()
    for body in model.bodies:
        for x, z, turn in body.uses:
            name = xml_text(names.take(f"{body.id}/use"))
            at = xml_numbers(*z_up(x, floors.get(body.room or "", 0.0), z))
            yield f'<site name="{name}" class="use" pos="{at}" euler="0 0 {xml_numbers(turn - 90)}"/>'


def _home(model: HouseModel) -> str:
    """Returns all joints' positions: free bodies where they stand, doors as open as they are, fronts shut; in the order of the bodies."""
    values: list[float] = []
    for body in model.bodies:
        if not body.fixed:
            half = math.radians(body.turn) / 2
            values += (*z_up(body.x, body.y, body.z), math.cos(half), 0.0, 0.0, math.sin(half))
        values += (0.0 for _ in body.fronts)
    return xml_numbers(*values, *(math.radians(leaf.opened) if leaf.motion == "swing" else leaf.opened for leaf in model.leaves))


_TURNED: Final = {"x": ' euler="0 90 0"', "y": ' euler="90 0 0"', "z": ""}
"""How a form along z turns to lie along an axis, its far end where the scene's axis points."""
_TIPPED: Final = {"x": ' euler="0 -90 0"', "y": ' euler="-90 0 0"', "z": ' euler="180 0 0"'}
"""The same with its far end at the other side."""
_LOCAL: Final = {"x": (2, 1, 0), "y": (0, 2, 1), "z": (0, 1, 2)}
"""Which extents of a turned form are its own x, y and z."""
_EDGES: Final = 16
"""Corners of a round that MuJoCo has no form for: a cone, an oval; only looked at."""


def geom(solid: Collider, classed: str, more: str = "") -> str:
    """Returns a geom of a class; `more` are further attributes, a space before each."""
    return f"{_begun(solid, classed)}{more}/>"


def _begun(solid: Collider, classed: str) -> str:
    """Returns a geom that further attributes may follow."""
    at = f'pos="{xml_numbers(*solid.at)}"'
    if solid.form in ("box", "ellipsoid"):
        kind = "" if solid.form == "box" else ' type="ellipsoid"'
        w, d, h = solid.size
        return f'<geom class="{classed}"{kind} size="{xml_numbers(w / 2, d / 2, h / 2)}" {at}'
    radius, length = solid.round_size
    half = length / 2 - (radius if solid.form == "capsule" else 0.0)
    return f'<geom class="{classed}" type="{solid.form}" size="{xml_numbers(radius, half)}" {at}{_TURNED[solid.axis]}'


@lru_cache(maxsize=1 << 12)
def _all_begun(solids: tuple[Collider, ...], classed: str) -> tuple[str, ...]:
    return tuple(_begun(solid, classed) for solid in solids)


def touching_geoms(solids: tuple[Collider, ...], mass: float, classed: str, more: str = "") -> str:
    """Returns the geoms with which a body of a mass, kg, touches others."""
    several = zip(_all_begun(solids, classed), shares_of(solids), strict=True)
    return "".join([f'{begun}{more} mass="{mass * volume / whole:.9g}"/>' for begun, (volume, whole) in several])


class _ShownPart(NamedTuple):
    """A part's geom until its material; what comes before that is the name of its mesh, where it has one."""

    begun: str
    mesh: tuple[str, str] | None = None


class MujocoLooks:
    """What a file's bodies look like; keeps the materials and meshes that they need."""

    def __init__(self, objects: AssetObjects) -> None:
        self._objects = objects
        self._own: dict[tuple[str, Triple], str] = {}
        self._pictured: dict[tuple[Paint, str], str] = {}
        self._materials: dict[Paint, str] = {}
        self._meshes: dict[tuple[str, str], str] = {}
        self._shown: dict[tuple[int, int], tuple[str, tuple[BodyPart, ...], tuple[Paint, ...]]] = {}
        """Texts by the identities of what they show, which is kept with them, so that no other takes its identity."""

    def parts(self, parts: tuple[BodyPart, ...], paints: tuple[Paint, ...]) -> str:
        """Returns the visual geoms of a body."""
        key = id(parts), id(paints)
        found = self._shown.get(key)
        if found is None:
            several = zip(_shown(parts), paints, strict=True)
            text = "".join([f"{self._meshed(part)}{self.painted(paint)}/>" for part, paint in several])
            found = self._shown[key] = text, parts, paints
        return found[0]

    def asset(self, body: ModelBody) -> str:
        """Returns the visual geoms of a body that is shown as an asset."""
        found = []
        for path, stretch, paint, picture in self._objects.of(body):
            mesh = self._own.setdefault((path, stretch), f"asset_{len(self._own)}")
            look = self.painted(paint)
            if picture and picture.endswith(".png"):  # the only pictures that MuJoCo reads
                look = f' material="{self._pictured.setdefault((paint, picture), f"pictured_{len(self._pictured)}")}"'
            found.append(f'<geom class="visual" type="mesh" mesh="{mesh}"{look}/>')
        return "".join(found)

    def painted(self, paint: Paint) -> str:
        """Returns the attribute that paints a geom."""
        found = self._materials.get(paint)
        if found is None:
            found = self._materials[paint] = f"paint_{len(self._materials)}"
        return f' material="{found}"'

    def _meshed(self, part: _ShownPart) -> str:
        if part.mesh is None:
            return part.begun
        return f'<geom class="visual" type="mesh" mesh="{self._meshes.setdefault(part.mesh, f"mesh_{len(self._meshes)}")}"{part.begun}'

    def assets(self) -> Iterator[str]:
        """Yields the materials and meshes of all that was shown."""
        for paint, name in self._materials.items():
            rgba = xml_numbers(*srgb(paint.color), paint.opacity)
            shine = xml_numbers(round(1 - paint.roughness, 3))
            yield f'<material name="{name}" rgba="{rgba}" specular="{shine}" shininess="{shine}" emission="{xml_numbers(paint.glow)}"/>'
        for (paint, picture), name in self._pictured.items():
            rgba = xml_numbers(*srgb(paint.color), paint.opacity)
            yield f'<texture name="{name}" type="2d" file="{xml_text(picture)}"/>'
            yield f'<material name="{name}" texture="{name}" rgba="{rgba}"/>'
        for (path, stretch), name in self._own.items():
            yield f'<mesh name="{name}" file="{xml_text(path)}" scale="{xml_numbers(*stretch)}" inertia="shell"/>'
        for (scale, ratio), name in self._meshes.items():
            yield f'<mesh name="{name}" builtin="cone" params="{_EDGES} {ratio}" scale="{scale}"/>'


@lru_cache(maxsize=1 << 12)
def _shown(parts: tuple[BodyPart, ...]) -> tuple[_ShownPart, ...]:
    return tuple(map(_shown_part, parts))


def _shown_part(part: BodyPart) -> _ShownPart:
    box = box_around(part)
    if part.form == "capsule" and box.circular and box.round_size[1] > box.across[0]:
        box = box._replace(form="capsule")
    elif part.form in ("ball", "capsule"):
        box = box._replace(form="ellipsoid")
    elif part.form == "cylinder" and part.taper == 1 and box.circular:
        box = box._replace(form="cylinder")
    elif part.form not in ("box", "rounded"):
        return _mesh(box, part.taper)
    return _ShownPart(_begun(box, "visual"))


def _mesh(box: Collider, taper: float) -> _ShownPart:
    """Returns the geom of a cone, a stump or an oval."""
    tipped = taper > 1
    halves = (box.size[i] / 2 for i in _LOCAL[box.axis])
    mesh = xml_numbers(*halves), xml_numbers(round(1 / taper if tipped else taper, 3))
    return _ShownPart(f' pos="{xml_numbers(*box.at)}"{(_TIPPED if tipped else _TURNED)[box.axis]}', mesh)
