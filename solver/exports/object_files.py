"""OBJ files, z up, for simulators, which stretch them.

Own assets: one a material, with its picture beside it. And forms that URDF and SDF have no element for, of size 1: cones, ovals, balls.
"""

from collections.abc import Iterator, Mapping
from typing import Final, NamedTuple

from catalogs.assets.asset_entry import Asset
from catalogs.shapes import Axis, Form
from solver.body_parts import BodyPart
from solver.exports.asset_surfaces import AssetSurface, fit_of, surfaces_of
from solver.exports.colliders import Collider, Triple, box_around
from solver.exports.model import ModelBody, Paint
from solver.exports.moving_parts import LinkPart
from solver.exports.paints import srgb
from solver.exports.solid_meshes import Points, SolidSurface, surface_of

FOLDER: Final = "assets"
LEAST_AREA: Final = 1e-12
"""A triangle of less area, by the square of the asset's extent, is left out: simulators refuse it."""


class AssetObject(NamedTuple):
    """A file, the factors it is stretched by along x, y and z (z up), its paint; its picture's file, or None."""

    path: str
    stretch: Triple
    paint: Paint
    picture: str | None


class AssetObjects:
    """The OBJ files of one export; with `material_files` they name .mtl files, which hold paint and picture."""

    def __init__(self, assets: Mapping[str, Asset], material_files: bool) -> None:
        self._assets, self._material_files = assets, material_files
        self._known: dict[str, list[tuple[str, Paint, str | None]]] = {}
        self.files: dict[str, bytes] = {}

    def of(self, body: ModelBody) -> list[AssetObject]:
        """Returns what a body is shown as.

        Raises:
            RequestError: the asset's file cannot be used any more.
        """
        name = body.asset or ""
        if name not in self._known:
            self._known[name] = [self._written(f"{name}_{number}", one) for number, one in enumerate(surfaces_of(name, self._assets[name]))]
        x, y, z = fit_of(self._assets[name], (body.width, body.depth, body.height)).stretch
        return [AssetObject(path, (x, z, y), paint, picture) for path, paint, picture in self._known[name]]

    def _written(self, name: str, surface: AssetSurface) -> tuple[str, Paint, str | None]:
        picture = f"{FOLDER}/{name}.{surface.picture.ending}" if surface.picture else None
        if surface.picture and picture:
            self.files[picture] = surface.picture.content
        head = ""
        if self._material_files:
            head = f"mtllib {name}.mtl\nusemtl look\n"
            self.files[f"{FOLDER}/{name}.mtl"] = _material(surface, f"{name}.{surface.picture.ending}" if surface.picture else None)
        path = f"{FOLDER}/{name}.obj"
        self.files[path] = head.encode() + _object_text(surface, surface.places, 4)
        return path, surface.paint, picture


def _material(surface: AssetSurface, picture: str | None) -> bytes:
    rgb = " ".join(f"{share:.4g}" for share in srgb(surface.paint.color))
    shown = f"map_Kd {picture}\n" if picture else ""
    return f"newmtl look\nKa {rgb}\nKd {rgb}\nKs 0 0 0\nd {surface.paint.opacity:.4g}\n{shown}".encode()


def _object_text(surface: AssetSurface | SolidSurface, places: Points | None, digits: int) -> bytes:
    """Returns a surface as OBJ, z up: (x, y, z) is (x, -z, y) there; places on its picture; how many digits its normals have."""
    a, b, c = (surface.points[surface.triangles[:, k]] for k in range(3))
    extent = float((surface.points.max(axis=0) - surface.points.min(axis=0)).max())
    areas = (((b - a)[:, [1, 2, 0]] * (c - a)[:, [2, 0, 1]] - (b - a)[:, [2, 0, 1]] * (c - a)[:, [1, 2, 0]]) ** 2).sum(axis=1) ** 0.5
    triangles = surface.triangles[areas > LEAST_AREA * extent**2] + 1
    lines = [f"v {x:.6g} {0.0 - z:.6g} {y:.6g}" for x, y, z in surface.points.tolist()]
    lines += [f"vn {x:.{digits}g} {0.0 - z:.{digits}g} {y:.{digits}g}" for x, y, z in surface.normals.tolist()]
    if places is None:
        lines += [f"f {i}//{i} {j}//{j} {k}//{k}" for i, j, k in triangles.tolist()]
    else:
        lines += [f"vt {u:.6g} {v:.6g}" for u, v in places.tolist()]
        lines += [f"f {i}/{i}/{i} {j}/{j}/{j} {k}/{k}/{k}" for i, j, k in triangles.tolist()]
    return "\n".join(lines).encode() + b"\n"


UNITS: Final = "meshes"


class StretchedMesh(NamedTuple):
    """A file beside the one that uses it; its extents and its middle there, m, z up."""

    path: str
    size: Triple
    at: Triple


class UnitMeshes:
    """The meshes of one export."""

    def __init__(self) -> None:
        self._forms: dict[tuple[Form, Axis, float], str] = {}

    def looks(self, seen: LinkPart) -> Iterator[tuple[Collider | StretchedMesh, Paint]]:
        """Yields what something looks like, in its paints."""
        return zip(map(self._shown, seen.parts), seen.paints, strict=True)

    def _shown(self, part: BodyPart) -> Collider | StretchedMesh:
        """Returns what a part looks like: a box, a round cylinder, else a mesh."""
        box = box_around(part)
        if part.form in ("box", "rounded"):
            return box
        if part.form == "cylinder" and part.taper == 1 and box.circular:
            return box._replace(form="cylinder")
        return self._mesh(part.form, part.axis, part.taper, box)

    def touched(self, solid: Collider) -> Collider | StretchedMesh:
        """Returns a collider, those that are round at their ends as a mesh."""
        if solid.form in ("box", "cylinder"):
            return solid
        return self._mesh("ball", "y", 1.0, solid)

    def _mesh(self, form: Form, axis: Axis, taper: float, box: Collider) -> StretchedMesh:
        key: tuple[Form, Axis, float] = ("ball", "y", 1.0) if form in ("ball", "capsule") else (form, axis, round(taper, 3))
        if key not in self._forms:
            self._forms[key] = f"{UNITS}/{key[0]}_{len(self._forms)}.obj"
        return StretchedMesh(self._forms[key], box.size, box.at)

    def files(self) -> dict[str, bytes]:
        """Returns the meshes that were asked for, by path."""
        return {path: _obj(form, axis, taper) for (form, axis, taper), path in self._forms.items()}


def _obj(form: Form, axis: Axis, taper: float) -> bytes:
    surface = surface_of(BodyPart(form, (1.0, 1.0, 1.0), (0.0, 0.0, 0.0), axis, taper, ""))
    points, normals = (rows.round(6) + 0.0 for rows in surface[:2])
    return _object_text(SolidSurface(points, normals, surface.triangles), None, 6)
