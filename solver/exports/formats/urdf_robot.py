"""URDF: the house as one robot: all fixed to the link `house`, but doors and fronts, which turn or slide.

Frame: x east, y north, z up; (x, y, z) of the scene is (x, -z, y) here and turns keep their value, about +z, in radians.
"""

import math
from collections.abc import Iterator
from itertools import starmap

from solver.exports.colliders import RPY, Collider, Triple, carriers, inertia_of, shell_solids, z_up
from solver.exports.model import HouseModel, ModelBody, Paint
from solver.exports.moving_parts import UNIT, LinkPart, MovingPart, held_things, moving_leaf, moving_parts, still_part
from solver.exports.object_files import StretchedMesh, UnitMeshes
from solver.exports.paints import srgb
from solver.exports.writers import ExportSettings, Files
from solver.exports.xml_text import xml_comment, xml_name, xml_numbers, xml_text
from solver.free_names import FreeNames

LinkForm = Collider | StretchedMesh


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.urdf` and the meshes it names; links are called as the scene's ids."""
    robot = _Robot()
    return {f"{model.name}.urdf": "\n".join(robot.lines(model)).encode() + b"\n", **robot.meshes.files()}


class _Robot:
    """One file: its materials, meshes and names."""

    def __init__(self) -> None:
        self.meshes = UnitMeshes()
        self._materials: dict[Paint, str] = {}
        self._links, self._joints = FreeNames(cut=xml_name), FreeNames(cut=xml_name)
        self._fronts: dict[tuple[str, str], str] = {}

    def lines(self, model: HouseModel) -> Iterator[str]:
        """Yields the file's lines."""
        self._links.take("world")  # Drake calls what all robots hang on so
        house, carry = self._links.take("house"), carriers(model.bodies)
        links = [f'<link name="{house}">{"".join(self._shell(model))}</link>']
        held = held_things(model.bodies)
        for body in sorted(model.bodies, key=lambda one: one.id in held):
            thing = held.get(body.id)
            parent = self._fronts[thing.piece, thing.front] if thing else house
            placed = _origin(z_up(*thing.at), thing.turn) if thing else _origin(z_up(body.x, body.y, body.z), body.turn)
            links.append(self._body(body, still_part(body, carry), parent, placed))
        links += [self._moving(moving_leaf(leaf), house)[1] for leaf in model.leaves]
        yield '<?xml version="1.0" encoding="utf-8"?>'
        yield f'<robot name="{xml_text(model.name)}">'
        yield from (f"<!-- {xml_comment(words)} -->" for words in model.origin())
        for paint, name in self._materials.items():
            rgba = xml_numbers(*srgb(paint.color), paint.opacity)
            yield f'<material name="{name}"><color rgba="{rgba}"/></material>'
        yield from links
        yield "</robot>"

    def _shell(self, model: HouseModel) -> Iterator[str]:
        """Returns walls, what is fitted to them, and floors."""
        return (self._seen(solid, paint) if paint else self._touching(solid) for solid, paint in shell_solids(model))

    def _body(self, body: ModelBody, still: LinkPart, parent: str, placed: str) -> str:
        """Returns the link of a body, its fixed joint to the house or to the drawer it lies in, and its fronts."""
        link = self._links.take(body.id)
        made, fronts = self._link(link, still, not body.flat), ""
        for front in moving_parts(body):
            named, text = self._moving(front, link)
            self._fronts[body.id, front.name], fronts = named, f"{fronts}\n{text}"
        return made + self._joint(f"{body.id}/fixed", "fixed", (parent, link), placed) + fronts

    def _moving(self, part: MovingPart, parent: str) -> tuple[str, str]:
        """Returns the name of the link of what moves; the link with its joint to what it hangs on."""
        link, (low, high) = self._links.take(part.id), part.reach
        made = self._link(link, part, True)
        limit = f'<limit lower="{low:.9g}" upper="{high:.9g}" effort="100" velocity="3"/>'
        dynamics = f'<dynamics damping="{part.damping:g}" friction="{part.friction:g}"/>'
        moving = f'{_origin(part.hinge, part.turn or 0.0)}<axis xyz="{UNIT[part.axis]}"/>{limit}{dynamics}'
        return link, made + self._joint(f"{part.id}/{part.way}", part.joint, (parent, link), moving)

    def _link(self, name: str, seen: LinkPart, touches: bool) -> str:
        body, looks = inertia_of(seen.solids, seen.mass), starmap(self._seen, self.meshes.looks(seen))
        touching = (self._touching(self.meshes.touched(solid)) for solid in seen.solids if touches)
        values = " ".join(f'{name}="{value + 0.0:.9g}"' for name, value in body.named.items())
        inertial = f'<inertial><origin xyz="{xml_numbers(*body.middle)}"/><mass value="{seen.mass:.9g}"/><inertia {values}/></inertial>'
        return f'<link name="{xml_text(name)}">{inertial}{"".join((*touching, *looks))}</link>'

    def _joint(self, name: str, kind: str, ends: tuple[str, str], placed: str) -> str:
        parent, child = (xml_text(end) for end in ends)
        called = xml_text(self._joints.take(name))
        return f'\n<joint name="{called}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{placed}</joint>'

    def _touching(self, form: LinkForm) -> str:
        return f"\n<collision>{_geometry(form)}</collision>"

    def _seen(self, form: LinkForm, paint: Paint) -> str:
        material = self._materials.setdefault(paint, f"paint_{len(self._materials)}")
        return f'\n<visual>{_geometry(form)}<material name="{material}"/></visual>'


def _origin(at: Triple, turn: float) -> str:
    return f'<origin xyz="{xml_numbers(*at)}" rpy="0 0 {math.radians(turn):.9g}"/>'


def _geometry(form: LinkForm) -> str:
    at = f'xyz="{xml_numbers(*form.at)}"'
    if isinstance(form, StretchedMesh):
        return f'<origin {at}/><geometry><mesh filename="{form.path}" scale="{xml_numbers(*form.size)}"/></geometry>'
    if form.form == "cylinder":
        radius, length = form.round_size
        turned = "" if form.axis == "z" else f' rpy="{RPY[form.axis]}"'
        return f'<origin {at}{turned}/><geometry><cylinder radius="{xml_numbers(radius)}" length="{xml_numbers(length)}"/></geometry>'
    return f'<origin {at}/><geometry><box size="{xml_numbers(*form.size)}"/></geometry>'
