"""SDF: a world for Gazebo with a model a body: static, or free where it may move; doors and fronts on joints.

Frame: x east, y north, z up; (x, y, z) of the scene is (x, -z, y) here and turns keep their value, about +z, in radians.
"""

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from itertools import starmap
from typing import Final

from solver.exports.colliders import RPY, Collider, Triple, carriers, inertia_of, shell_solids, z_up
from solver.exports.model import DoorLeaf, HouseModel, ModelBody, Paint
from solver.exports.moving_parts import UNIT, HeldThing, LinkPart, MovingPart, held_fast, held_in, moving_leaf, moving_parts, still_part
from solver.exports.object_files import AssetObjects, StretchedMesh, UnitMeshes
from solver.exports.paints import srgb
from solver.exports.writers import ExportSettings, Files
from solver.exports.xml_text import xml_comment, xml_name, xml_numbers, xml_text
from solver.free_names import FreeNames

FORBIDDEN: Final = r"^(_|::){2,}|(_|::){2,}$|::|^world$"
"""What SDF keeps for itself in names."""
WALLS, LEAVES, BODIES = 1, 2, 3
"""Bits of contacts: a leaf meets bodies, not the wall it hangs in."""
_LIGHT: Final = '<light name="sun" type="directional"><cast_shadows>true</cast_shadows><direction>0.3 0.4 -1</direction></light>'
STATIC: Final = "<static>true</static>"


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.sdf` and the meshes it names; models are called as the scene's ids, which they keep as `compose:id`."""
    world = _World(AssetObjects(model.assets, True))
    return {f"{model.name}.sdf": "\n".join(world.lines(model)).encode() + b"\n", **world.meshes.files(), **world.objects.files}


class _World:
    """One file: its meshes and names."""

    def __init__(self, objects: AssetObjects) -> None:
        self.meshes, self.objects = UnitMeshes(), objects
        self._models = FreeNames(FORBIDDEN, xml_name)
        self._painted: dict[Paint, str] = {}

    def lines(self, model: HouseModel) -> Iterator[str]:
        """Yields the file's lines."""
        carry, house = carriers(model.bodies), self._models.take("house")
        yield '<?xml version="1.0" encoding="utf-8"?>'
        yield '<sdf version="1.9" xmlns:compose="compose-scene">'
        yield from (f"<!-- {xml_comment(words)} -->" for words in model.origin())
        yield f'<world name="{xml_text(model.name)}">{_LIGHT}'
        yield f'<model name="{house}"><static>true</static><link name="link">{"".join(_numbered(self._shell(model)))}</link></model>'
        held = held_fast(model.bodies)
        for body in model.bodies:
            if body.id not in held:
                yield self._body(body, still_part(body, carry), self._held(body, held, carry))
        yield from map(self._leaf, model.leaves)
        yield "</world></sdf>"

    def _shell(self, model: HouseModel) -> Iterator[tuple[str, str]]:
        """Returns walls, what is fitted to them, and floors."""
        return (self._seen(solid, paint) if paint else _touching(solid, WALLS) for solid, paint in shell_solids(model))

    def _held(self, piece: ModelBody, held: Mapping[str, HeldThing], carry: Collection[str]) -> dict[str, list[tuple[str, str]]]:
        """Returns what is held in each front of a piece: models within its own, by name."""
        found: dict[str, list[tuple[str, str]]] = {}
        for front in piece.fronts:
            for one in held_in(held, piece.id, front.name):
                at = tuple(own + hinge for own, hinge in zip(one.at, front.hinge, strict=True))
                name, opened = self._opened(one.body.id, (at[0], at[1], at[2]), one.turn)
                bits = None if one.body.flat else BODIES
                link = self._link("link", still_part(one.body, carry), bits, one.body)
                found.setdefault(front.name, []).append((name, f"{opened}{link}</model>"))
        return found

    def _body(self, body: ModelBody, still: LinkPart, held: Mapping[str, list[tuple[str, str]]]) -> str:
        """Returns a model, static or free; one with fronts that does not move itself hangs on the world: all of a static model is still."""
        bits = None if body.flat else BODIES
        links = self._link("link", still, bits, body)
        names = FreeNames(FORBIDDEN)
        names.take("link")
        for front in moving_parts(body):
            name = names.take(front.name)
            links += self._link(name, front, BODIES, body, front.hinge) + _joint(front, f"{name}_joint", ("link", name))
            links += "".join(model + _held_joint(inside, name) for inside, model in held.get(front.name, ()))
        fixed = '<joint name="fixed" type="fixed"><parent>world</parent><child>link</child></joint>' if body.fronts else STATIC
        _, opened = self._opened(body.id, (body.x, body.y, body.z), body.turn)
        return f"{opened}{fixed if body.fixed else ''}{links}</model>"

    def _link(self, name: str, seen: LinkPart, bits: int | None, body: ModelBody | None = None, at: Triple = (0.0, 0.0, 0.0)) -> str:
        """Returns a link of a body or a leaf; `bits` are those of its contacts, if it has any."""
        shown = self._own(body) if body and body.asset else starmap(self._seen, self.meshes.looks(seen))
        friction = (body.friction,) if body else ()
        touching = () if bits is None else (_touching(solid, bits, *friction) for solid in seen.solids)
        pose = f"<pose>{xml_numbers(*at)} 0 0 0</pose>" if any(at) else ""
        return f'<link name="{xml_text(name)}">{pose}{_inertial(seen.solids, seen.mass)}{"".join(_numbered((*touching, *shown)))}</link>'

    def _own(self, body: ModelBody) -> list[tuple[str, str]]:
        """Returns the visuals of a body that is shown as an asset; one with a picture is painted by its own file."""
        found = []
        for path, stretch, paint, picture in self.objects.of(body):
            tag, text = self._seen(StretchedMesh(path, stretch, (0.0, 0.0, 0.0)), paint)
            found.append((tag, text.removesuffix(self._painted[paint]) if picture else text))
        return found

    def _leaf(self, leaf: DoorLeaf) -> str:
        part = moving_leaf(leaf)
        opened = self._opened(leaf.id, leaf.hinge, leaf.closed)[1]
        return f"{opened}{self._link('link', part, LEAVES)}{_joint(part, part.way, ('world', 'link'))}</model>"

    def _opened(self, called: str, at: Triple, turn: float) -> tuple[str, str]:
        """Returns the name of a model, and its begin: the name, its id, where it is."""
        name = xml_text(self._models.take(called))
        pose = f"<pose>{xml_numbers(*z_up(*at))} 0 0 {math.radians(turn):.9g}</pose>"
        return name, f'<model name="{name}"><compose:id>{xml_text(called)}</compose:id>{pose}'

    def _seen(self, form: Collider | StretchedMesh, paint: Paint) -> tuple[str, str]:
        if paint not in self._painted:
            rgb = xml_numbers(*srgb(paint.color))
            glow = f"<emissive>{rgb} 1</emissive>" if paint.glow else ""
            clear = f"<transparency>{xml_numbers(1 - paint.opacity)}</transparency>" if paint.opacity < 1 else ""
            material = f"<material><ambient>{rgb} 1</ambient><diffuse>{rgb} 1</diffuse>{glow}</material>"
            self._painted[paint] = clear + material
        return "visual", _geometry(form) + self._painted[paint]


def _held_joint(name: str, front: str) -> str:
    """Returns what holds a model in the drawer it lies in."""
    inside = f"<parent>{xml_text(front)}</parent><child>{name}::link</child>"
    return f'<joint name="{name}_held" type="fixed">{inside}</joint>'


def _joint(part: MovingPart, name: str, ends: tuple[str, str]) -> str:
    """Returns the joint of what moves, in its own frame, between a parent and a child; shut is 0."""
    (low, high), (parent, child) = part.reach, map(xml_text, ends)
    limit = f"<limit><lower>{low:.9g}</lower><upper>{high:.9g}</upper></limit>"
    dynamics = f"<dynamics><damping>{part.damping:g}</damping><friction>{part.friction:g}</friction></dynamics>"
    return (
        f'<joint name="{xml_text(name)}" type="{part.joint}"><parent>{parent}</parent><child>{child}</child>'
        f"<axis><xyz>{UNIT[part.axis]}</xyz>{limit}{dynamics}</axis></joint>"
    )


def _touching(solid: Collider, bits: int, friction: float = 0.6) -> tuple[str, str]:
    ode = f"<ode><mu>{friction:g}</mu><mu2>{friction:g}</mu2></ode>"
    surface = f"<surface><contact><collide_bitmask>{bits}</collide_bitmask></contact><friction>{ode}</friction></surface>"
    return "collision", _geometry(solid) + surface


def _numbered(elements: Iterable[tuple[str, str]]) -> Iterator[str]:
    """Yields elements with names of their own."""
    for number, (tag, content) in enumerate(elements):
        yield f'\n<{tag} name="{tag}_{number}">{content}</{tag}>'


def _inertial(solids: Sequence[Collider], mass: float) -> str:
    body = inertia_of(solids, mass)
    values = "".join(f"<{name}>{value + 0.0:.9g}</{name}>" for name, value in body.named.items())
    return f"<inertial><pose>{xml_numbers(*body.middle)} 0 0 0</pose><mass>{mass:.9g}</mass><inertia>{values}</inertia></inertial>"


def _geometry(form: Collider | StretchedMesh) -> str:
    """Returns a pose and a geometry."""
    at = xml_numbers(*form.at)
    if isinstance(form, StretchedMesh):
        return f"<pose>{at} 0 0 0</pose><geometry><mesh><uri>{form.path}</uri><scale>{xml_numbers(*form.size)}</scale></mesh></geometry>"
    if form.form == "box":
        return f"<pose>{at} 0 0 0</pose><geometry><box><size>{xml_numbers(*form.size)}</size></box></geometry>"
    if form.form == "ellipsoid":
        radii = xml_numbers(*(extent / 2 for extent in form.size))
        return f"<pose>{at} 0 0 0</pose><geometry><ellipsoid><radii>{radii}</radii></ellipsoid></geometry>"
    radius, length = form.round_size
    straight = length - (2 * radius if form.form == "capsule" else 0.0)
    said = f"<radius>{xml_numbers(radius)}</radius><length>{xml_numbers(straight)}</length>"
    return f"<pose>{at} {RPY[form.axis]}</pose><geometry><{form.form}>{said}</{form.form}></geometry>"
