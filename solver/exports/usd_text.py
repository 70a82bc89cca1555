"""Pieces of USD's text format (.usda): texts, numbers, transforms, solids, materials; z up, metres, each statement on a line of its own."""

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from math import cos, radians, sin
from typing import TYPE_CHECKING, Final

from catalogs.shapes import Form
from solver.body_parts import BodyPart
from solver.exports.colliders import Collider, Triple, box_around, z_up
from solver.exports.model import Paint
from solver.exports.paints import channels, linear
from solver.exports.solid_meshes import SolidSurface, surface_of
from solver.geometry import turned_by

if TYPE_CHECKING:
    from solver.exports.asset_surfaces import AssetSurface

LOOKS: Final = "/House/Looks"
_ESCAPED: Final = re.compile(r'[\x00-\x1f\x7f"\\]')
_ORDER: Final = "uniform token[] xformOpOrder = "
_BLOCK: Final = "extent = [(-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)]"
_GUIDE: Final = 'uniform token purpose = "guide"\n'


def text(words: str) -> str:
    """Returns a text in quotes."""
    return f'"{_ESCAPED.sub(_escape, words)}"'


def _escape(found: re.Match[str]) -> str:
    character = found.group()
    return "\\" + character if character in '"\\' else f"\\x{ord(character):02x}"


def texts(words: Iterable[str]) -> str:
    """Returns a list of texts."""
    return f"[{', '.join(map(text, words))}]"


def triple(values: Sequence[float]) -> str:
    """Returns three numbers of six digits."""
    x, y, z = values
    return f"({x + 0.0:.6g}, {y + 0.0:.6g}, {z + 0.0:.6g})"


def triples(values: Iterable[Sequence[float]]) -> str:
    """Returns a list of points."""
    return f"[{', '.join(map(triple, values))}]"


def placed(at: Sequence[float], turn: float) -> str:
    """Returns a translation, m, and a turn about z, degrees."""
    return (
        f"quatd xformOp:orient = {turned(turn)}\ndouble3 xformOp:translate = {triple(at)}\n"
        f'{_ORDER}["xformOp:translate", "xformOp:orient"]\n'
    )


def moved_by(at: Triple, turn: float, by: Triple) -> Triple:
    """Returns a point that is given in the frame of something at a place, turned about z, degrees."""
    east, south = turned_by(by[0], -by[1], turn)
    return at[0] + east, at[1] - south, at[2] + by[2]


@lru_cache(maxsize=4096)
def turned(turn: float) -> str:
    """Returns a turn about z, degrees, as a quaternion, w first."""
    half = radians(turn) / 2
    return f"({round(cos(half), 9) + 0.0}, 0, 0, {round(sin(half), 9) + 0.0})"


def stretched(at: Sequence[float], size: Sequence[float]) -> str:
    """Returns a translation and extents along the axes, m, for what is 1 m wide."""
    return (
        f'float3 xformOp:scale = {triple(size)}\ndouble3 xformOp:translate = {triple(at)}\n{_ORDER}["xformOp:translate", "xformOp:scale"]\n'
    )


def _moved(at: Sequence[float]) -> str:
    return f'double3 xformOp:translate = {triple(at)}\n{_ORDER}["xformOp:translate"]\n'


def bound(paint: Paint) -> str:
    """Returns the binding of a material."""
    return f"rel material:binding = <{LOOKS}/{material_name(paint)}>\n"


def prim(kind: str, name: str, schemas: Iterable[str], inside: str) -> str:
    """Returns a prim with applied schemas."""
    listed = ", ".join(f'"{schema}"' for schema in schemas)
    applied = f" (\nprepend apiSchemas = [{listed}]\n)" if listed else ""
    return f'def {kind} "{name}"{applied}\n{{\n{inside}}}\n'


def group(name: str, inside: str, label: str | None = None) -> str:
    """Returns a group of prims, of which all have a label if one is given."""
    labelled = 'prepend apiSchemas = ["SemanticsLabelsAPI:class"]\n' if label else ""
    words = f'token[] semantics:labels:class = ["{label}"]\n' if label else ""
    return f'def Xform "{name}" (\n{labelled}kind = "group"\n)\n{{\n{words}{inside}}}\n'


def said(kind: str, name: str, schemas: Iterable[str], words: Mapping[str, str | Triple | None], inside: str) -> str:
    """Returns a component with applied schemas, and words and points that are its custom data."""
    custom = "".join(
        f"string {key} = {text(word)}\n" if isinstance(word, str) else f"double3 {key} = {triple(word)}\n"
        for key, word in words.items()
        if word is not None
    )
    listed = ", ".join(f'"{schema}"' for schema in schemas)
    metadata = f'prepend apiSchemas = [{listed}]\ncustomData = {{\n{custom}}}\nkind = "component"\n'
    return f'def {kind} "{name}" (\n{metadata})\n{{\n{inside}}}\n'


def cube(name: str, box: tuple[Triple, Triple], paint: Paint, collides: bool = True) -> str:
    """Returns a box that is seen, and collides if it is said to; `box` is its extents and its middle, m."""
    schemas = ("MaterialBindingAPI", *(("PhysicsCollisionAPI",) if collides else ()))
    return prim("Cube", name, schemas, f"float3[] {_BLOCK}\n{bound(paint)}double size = 1\n{stretched(box[1], box[0])}")


def guide(name: str, solid: Collider) -> str:
    """Returns a solid that collides and is not seen; where its radii differ, it is the box around it."""
    if solid.form in ("cylinder", "capsule"):
        inside = _long(solid.form, solid.axis, *solid.round_size) + _moved(solid.at)
        return prim(solid.form.capitalize(), name, ("PhysicsCollisionAPI",), _GUIDE + inside)
    return prim("Cube", name, ("PhysicsCollisionAPI",), f"float3[] {_BLOCK}\n{_GUIDE}double size = 1\n{stretched(solid.at, solid.size)}")


def part_text(name: str, part: BodyPart, paint: Paint, solid: Collider | None) -> str:
    """Returns a part of a body, given in the scene's frame, and what it collides as.

    `solid` is the prim itself where it is that solid, else a guide beside it; None: it does not collide.
    """
    box = box_around(part)
    if part.form == "box":
        return cube(name, (box.size, box.at), paint, solid is not None)
    if part.form == "rounded":
        return _mesh(name, part, paint, solid is not None)
    exact = False
    if part.form == "cone" or part.taper != 1:
        seen = _mesh(name, part, paint, False)
    else:
        one, other = box.across
        exact = one == other and (part.form != "ball" or one == box.size[2])
        exact = exact and solid is not None and part.form in ("ball", solid.form)
        seen = _round(name, part.form, box, paint, exact)
    return seen + guide(f"{name}_collider", solid) if solid and not exact else seen


def _round(name: str, form: Form, box: Collider, paint: Paint, collides: bool) -> str:
    _, size, at, axis = box
    schemas = ("MaterialBindingAPI", *(("PhysicsCollisionAPI",) if collides else ()))
    if form == "ball":
        if collides:
            reach = size[0] / 2
            inside = f"float3[] extent = {triples(((-reach,) * 3, (reach,) * 3))}\ndouble radius = {reach:.6g}\n{_moved(at)}"
        else:
            inside = f"float3[] {_BLOCK}\ndouble radius = 0.5\n{stretched(at, size)}"
        return prim("Sphere", name, schemas, bound(paint) + inside)
    (one, other), length = box.across, box.round_size[1]
    radius = min(one, other) / 2
    inside = _long("capsule" if form == "capsule" else "cylinder", axis, radius, length)
    scale = [1.0 if name == axis else extent / (2 * radius) for name, extent in zip("xyz", size, strict=True)]
    place = _moved(at) if one == other else stretched(at, scale)
    kind = "Capsule" if form == "capsule" and length > 2 * radius else "Cylinder"
    return prim(kind, name, schemas, bound(paint) + inside + place)


def _long(form: str, axis: str, radius: float, length: float) -> str:
    """Returns the measures of a cylinder or capsule; a capsule's `height` leaves its round ends out."""
    ends = [length / 2 if letter == axis else radius for letter in "xyz"]
    height = length - 2 * radius if form == "capsule" else length
    return (
        f'uniform token axis = "{axis.upper()}"\nfloat3[] extent = {triples(([-end for end in ends], ends))}\n'
        f"double height = {height:.6g}\ndouble radius = {radius:.6g}\n"
    )


def triangles(surface: "SolidSurface | AssetSurface", binding: str, more: str = "") -> str:
    """Returns what a mesh holds of a surface in the scene's frame; its binding, and what comes after its points."""
    points = [z_up(*point) for point in surface.points.tolist()]
    normals = [z_up(*(round(value, 4) for value in normal)) for normal in surface.normals.tolist()]
    ends = [[pick(point[i] for point in points) for i in range(3)] for pick in (min, max)]
    return (
        f"float3[] extent = {triples(ends)}\nint[] faceVertexCounts = {[3] * len(surface.triangles)}\n"
        f"int[] faceVertexIndices = {surface.triangles.reshape(-1).tolist()}\n{binding}"
        f'normal3f[] normals = {triples(normals)} (\ninterpolation = "vertex"\n)\npoint3f[] points = {triples(points)}\n'
        f'{more}uniform token subdivisionScheme = "none"\n'
    )


def _mesh(name: str, part: BodyPart, paint: Paint, collides: bool) -> str:
    """Returns a block with soft edges or a tapered cylinder; the block collides as a box."""
    inside = triangles(surface_of(part), bound(paint))
    if not collides:
        return prim("Mesh", name, ("MaterialBindingAPI",), inside)
    schemas = "MaterialBindingAPI", "PhysicsCollisionAPI", "PhysicsMeshCollisionAPI"
    return prim("Mesh", name, schemas, inside + 'uniform token physics:approximation = "boundingCube"\n')


@lru_cache(maxsize=4096)
def material_name(paint: Paint) -> str:
    """Returns a name that says all of a paint that a material holds: equal names are equal materials."""
    shares = "_".join(f"{share * 1000:.0f}" for share in paint[1:5])
    kind = paint.texture if paint.texture and paint.texture.isascii() and paint.texture.isalpha() else "plain"
    red, green, blue = channels(paint.color)
    return f"{kind}_{red:02x}{green:02x}{blue:02x}_{shares}"


@lru_cache(maxsize=4096)
def material_text(paint: Paint) -> str:
    """Returns a paint as a material, its shares to a thousandth."""
    name, color = material_name(paint), linear(paint.color)
    glow = f"color3f inputs:emissiveColor = {triple([channel * paint.glow for channel in color])}\n" if paint.glow else ""
    shader = prim(
        "Shader",
        "Surface",
        (),
        f'uniform token info:id = "UsdPreviewSurface"\ncolor3f inputs:diffuseColor = {triple(color)}\n{glow}'
        f"float inputs:metallic = {paint.metalness:g}\nfloat inputs:opacity = {paint.opacity:g}\n"
        f"float inputs:roughness = {paint.roughness:g}\ntoken outputs:surface\n",
    )
    return prim("Material", name, (), f"token outputs:surface.connect = <{LOOKS}/{name}/Surface.outputs:surface>\n{shader}")
