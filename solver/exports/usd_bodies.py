"""What USD files hold of bodies: the kinds that bodies and walls refer to, seen and colliding; leaves and fronts on joints.

Own assets are layers of their own, z up, which bodies refer to: meshes, materials, pictures beside them.
"""

from collections.abc import Collection, Mapping
from functools import lru_cache
from math import radians
from typing import Final

from catalogs.assets.asset_entry import Asset
from solver.body_parts import BodyPart
from solver.exports.asset_surfaces import AssetSurface, fit_of, surfaces_of
from solver.exports.colliders import Collider, colliders_of, is_one_box, z_up
from solver.exports.model import DoorLeaf, ModelBody, Paint, WallBox
from solver.exports.moving_parts import HeldThing, MovingPart, moving_leaf, still_part
from solver.exports.paints import linear
from solver.exports.usd_text import (
    bound,
    cube,
    guide,
    material_name,
    moved_by,
    part_text,
    placed,
    prim,
    said,
    stretched,
    triangles,
    triple,
    triples,
    turned,
)

_CORNERS: Final = [(x, y, z) for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
_QUADS: Final = {
    "-x": (0, 4, 6, 2), "+x": (1, 3, 7, 5), "-y": (0, 1, 5, 4), "+y": (2, 6, 7, 3), "-z": (0, 2, 3, 1), "+z": (4, 5, 7, 6),
}  # fmt: skip
"""The faces of a block by where they look, counter-clockwise seen from outside."""
_UNIT: Final = ((1.0, 1.0, 1.0), (0.0, 0.0, 0.0))


def body_kind(body: ModelBody, carries: Collection[str]) -> str:
    """Returns the parts of a body but its fronts, z up, and what they collide as; `carries` are the ids of all that carry something."""
    if body.flat:
        return _parts(body.parts, body.paints, None)
    if is_one_box(body, carries):
        return _parts(body.parts, body.paints, None) + guide("collider", colliders_of(body, carries)[0])
    still = still_part(body, carries)
    return _parts(still.parts, still.paints, still.solids)


def body_guides(body: ModelBody, carries: Collection[str]) -> str:
    """Returns what a body collides as that is shown as something else."""
    return "" if body.flat else _guides(colliders_of(body, carries))


def _guides(solids: tuple[Collider, ...]) -> str:
    return "".join(guide(f"collider_{number}", solid) for number, solid in enumerate(solids))


@lru_cache(maxsize=2048)
def _parts(parts: tuple[BodyPart, ...], paints: tuple[Paint, ...], solids: tuple[Collider, ...] | None) -> str:
    collide = solids or (None,) * len(parts)
    several = zip(parts, paints, collide, strict=True)
    return "".join(part_text(f"part_{number}", part, paint, solid) for number, (part, paint, solid) in enumerate(several))


@lru_cache(maxsize=512)
def wall_kind(wall: WallBox) -> str:
    """Returns a piece of wall, 1 m each way: its faces in the paints of the rooms they look into, and the block that collides."""
    faces: dict[Paint, list[int]] = {}
    lesser, greater = ("+y", "-y") if wall.axis == "x" else ("-x", "+x")
    for number, face in enumerate(_QUADS):
        paint = {lesser: wall.lesser, greater: wall.greater}.get(face, wall.rest)
        faces.setdefault(paint, []).append(number)
    if len(faces) == 1:
        return cube("faces", _UNIT, wall.rest)
    subsets = "".join(
        prim(
            "GeomSubset",
            material_name(paint),
            ("MaterialBindingAPI",),
            f'uniform token elementType = "face"\nuniform token familyName = "materialBind"\nint[] indices = {numbers}\n{bound(paint)}',
        )
        for paint, numbers in faces.items()
    )
    quads = [corner for quad in _QUADS.values() for corner in quad]
    inside = (
        f"float3[] extent = {triples((_CORNERS[0], _CORNERS[-1]))}\nint[] faceVertexCounts = {[4] * 6}\nint[] faceVertexIndices = {quads}\n"
        f'point3f[] points = {triples(_CORNERS)}\nuniform token subdivisionScheme = "none"\n'
        f'uniform token subsetFamily:materialBind:familyType = "partition"\n{subsets}'
    )
    return prim("Mesh", "faces", (), inside) + guide("collider", Collider("box", *_UNIT))


_NO_TURN: Final = "(1, 0, 0, 0)"


def door_text(leaf: DoorLeaf, name: str) -> str:
    """Returns a leaf, as far open as it stands, its origin at its hinge and its +x along its width; the joint is inside."""
    hung = moving_leaf(leaf)
    parts, solids = _parts(hung.parts, hung.paints, None), _guides(hung.solids)
    joint = _joint(hung, ("/House", f"/House/Doors/{name}"), leaf.mass if hung.slides else hung.damping)
    inside = f'float physics:mass = {leaf.mass:.6g}\ntoken[] semantics:labels:class = ["door"]\n{_stands(leaf)}{parts}{solids}{joint}'
    schemas = "PhysicsRigidBodyAPI", "PhysicsMassAPI", "SemanticsLabelsAPI:class"
    return said("Xform", name, schemas, {"id": leaf.id, "look": leaf.look}, inside)


def _stands(leaf: DoorLeaf) -> str:
    """Returns where a leaf stands: turned open, or lifted."""
    x, y, z = z_up(*leaf.hinge)
    return placed((x, y, z), leaf.closed + leaf.opened) if leaf.motion == "swing" else placed((x, y, z + leaf.opened), leaf.closed)


def front_text(front: MovingPart, body: ModelBody, name: str, path: str) -> str:
    """Returns a front, shut, its origin at its hinge; the joint to its furniture, the prim at `path`, is inside."""
    parts = _parts(front.parts, front.paints, front.solids)
    at = moved_by(z_up(body.x, body.y, body.z), body.turn, front.hinge)
    inside = (
        f"rel physics:filteredPairs = <{path}>\nfloat physics:mass = {front.mass:.6g}\n"
        f'token[] semantics:labels:class = ["{"drawer" if front.slides else "front"}"]\n'
        f"{placed(at, body.turn)}{parts}{_joint(front, (path, f'/House/Fronts/{name}'), front.damping)}"
    )
    schemas = "PhysicsRigidBodyAPI", "PhysicsMassAPI", "PhysicsFilteredPairsAPI", "SemanticsLabelsAPI:class"
    return said("Xform", name, schemas, {"id": front.id, "body": body.id, "front": front.name}, inside)


def held_text(held: HeldThing, front: str, own: str) -> str:
    """Returns the joint that holds a body in a drawer, both given by their prims' paths."""
    inside = (
        f"rel physics:body0 = <{front}>\nrel physics:body1 = <{own}>\n"
        f"point3f physics:localPos0 = {triple(z_up(*held.at))}\npoint3f physics:localPos1 = (0, 0, 0)\n"
        f"quatf physics:localRot0 = {turned(held.turn)}\nquatf physics:localRot1 = {_NO_TURN}\n"
    )
    return prim("PhysicsFixedJoint", "held", (), inside)


def _joint(part: MovingPart, ends: tuple[str, str], damping: float) -> str:
    """Returns the joint of what moves to what it hangs on, two prims' paths; shut is 0. Damping is in N m s/rad: USD counts in degrees."""
    (held, own), (low, high) = ends, part.limits
    drive, slowed = ("linear", damping) if part.slides else ("angular", radians(damping))
    inside = (
        f'uniform token physics:axis = "{part.axis.upper()}"\nrel physics:body0 = <{held}>\nrel physics:body1 = <{own}>\n'
        f"point3f physics:localPos0 = {triple(part.hinge)}\npoint3f physics:localPos1 = (0, 0, 0)\n"
        f"quatf physics:localRot0 = {_NO_TURN if part.turn is None else turned(part.turn)}\nquatf physics:localRot1 = {_NO_TURN}\n"
        f"float physics:lowerLimit = {low:.6g}\nfloat physics:upperLimit = {high:.6g}\n"
        f"float drive:{drive}:physics:damping = {slowed:.6g}\nfloat drive:{drive}:physics:stiffness = 0\n"
        f'uniform token drive:{drive}:physics:type = "force"\n'
    )
    return prim("PhysicsPrismaticJoint" if part.slides else "PhysicsRevoluteJoint", "hinge", (f"PhysicsDriveAPI:{drive}",), inside)


FOLDER: Final = "assets"
_HEAD: Final = '#usda 1.0\n(\ndefaultPrim = "Asset"\nkilogramsPerUnit = 1\nmetersPerUnit = 1\nupAxis = "Z"\n)\n'


class AssetLayers:
    """The layers of one export; `files` are theirs by path."""

    def __init__(self, assets: Mapping[str, Asset]) -> None:
        self._assets = assets
        self.files: dict[str, bytes] = {}

    def shape(self, body: ModelBody) -> str:
        """Returns the prim of a body's shape: a reference to its asset, stretched into the body's box.

        Raises:
            RequestError: the asset's file cannot be used any more.
        """
        name = body.asset or ""
        path = f"{FOLDER}/{name}.usda"
        if path not in self.files:
            self.files[path] = self._layer(name).encode()
        x, y, z = fit_of(self._assets[name], (body.width, body.depth, body.height)).stretch
        return f'def Xform "shape" (\nreferences = @./{path}@\n)\n{{\n{stretched((0.0, 0.0, 0.0), (x, z, y))}}}\n'

    def _layer(self, name: str) -> str:
        surfaces = surfaces_of(name, self._assets[name])
        looks = "".join(self._look(name, number, surface) for number, surface in enumerate(surfaces))
        meshes = "".join(_mesh(number, surface) for number, surface in enumerate(surfaces))
        return f'{_HEAD}def Xform "Asset"\n{{\n{prim("Scope", "Looks", (), looks)}{meshes}}}\n'

    def _look(self, name: str, number: int, surface: AssetSurface) -> str:
        """Returns a material, and keeps its picture."""
        paint, at = surface.paint, f"/Asset/Looks/look_{number}"
        color = f"color3f inputs:diffuseColor = {triple(linear(paint.color))}\n"
        more = ""
        if surface.picture:
            file = f"{name}_{number}.{surface.picture.ending}"
            self.files[f"{FOLDER}/{file}"] = surface.picture.content
            color = f"color3f inputs:diffuseColor.connect = <{at}/Picture.outputs:rgb>\n"
            more = prim("Shader", "Places", (), _PLACES) + prim("Shader", "Picture", (), _PICTURE.format(
                file=file, factor=", ".join(f"{value:.4g}" for value in linear(paint.color)), reader=f"{at}/Places.outputs:result"
            ))  # fmt: skip
        shader = (
            f'uniform token info:id = "UsdPreviewSurface"\n{color}float inputs:metallic = {paint.metalness:.4g}\n'
            f"float inputs:opacity = {paint.opacity:.4g}\nfloat inputs:roughness = {paint.roughness:.4g}\ntoken outputs:surface\n"
        )
        inside = f"token outputs:surface.connect = <{at}/Surface.outputs:surface>\n{prim('Shader', 'Surface', (), shader)}{more}"
        return prim("Material", f"look_{number}", (), inside)


_PLACES: Final = 'uniform token info:id = "UsdPrimvarReader_float2"\nstring inputs:varname = "st"\nfloat2 outputs:result\n'
_PICTURE: Final = (
    'uniform token info:id = "UsdUVTexture"\nasset inputs:file = @./{file}@\nfloat4 inputs:scale = ({factor}, 1)\n'
    'token inputs:sourceColorSpace = "sRGB"\nfloat2 inputs:st.connect = <{reader}>\n'
    'token inputs:wrapS = "repeat"\ntoken inputs:wrapT = "repeat"\nfloat3 outputs:rgb\n'
)


def _mesh(number: int, surface: AssetSurface) -> str:
    places = ""
    if surface.places is not None:
        listed = ", ".join(f"({u:.6g}, {v:.6g})" for u, v in surface.places.tolist())
        places = f'texCoord2f[] primvars:st = [{listed}] (\ninterpolation = "vertex"\n)\n'
    inside = triangles(surface, f"rel material:binding = </Asset/Looks/look_{number}>\n", places)
    return prim("Mesh", f"mesh_{number}", ("MaterialBindingAPI",), inside)
