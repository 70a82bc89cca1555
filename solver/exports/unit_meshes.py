"""Forms that URDF and SDF have no element for, as OBJ files of size 1 that a file stretches: cones, ovals, balls."""

from __future__ import annotations

from typing import Final, NamedTuple

from catalogs.shapes import Axis, Form
from solver.body_parts import BodyPart
from solver.exports.colliders import AXES, Collider, Triple, z_up
from solver.exports.solid_meshes import surface_of

FOLDER: Final = "meshes"
EQUAL: Final = 1e-4
"""Radii that differ by less are one, m."""


class StretchedMesh(NamedTuple):
    """A file beside the one that uses it; its extents and its middle there, m, z up."""

    path: str
    size: Triple
    at: Triple


class UnitMeshes:
    """The meshes of one export."""

    def __init__(self) -> None:
        self._forms: dict[tuple[Form, Axis, float], str] = {}

    def shown(self, part: BodyPart) -> Collider | StretchedMesh:
        """Returns what a part looks like: a box, a round cylinder, else a mesh."""
        (w, h, d), at = part.size, z_up(*part.at)
        size, axis = (w, d, h), AXES[part.axis]
        if part.form in ("box", "rounded"):
            return Collider("box", size, at)
        across = [extent for i, extent in enumerate(size) if "xyz"[i] != axis]
        if part.form == "cylinder" and part.taper == 1 and abs(across[0] - across[1]) < EQUAL:
            return Collider("cylinder", size, at, axis)
        return self._mesh(part.form, part.axis, part.taper, size, at)

    def touched(self, solid: Collider) -> Collider | StretchedMesh:
        """Returns a collider, those that are round at their ends as a mesh."""
        if solid.form in ("box", "cylinder"):
            return solid
        return self._mesh("ball", "y", 1.0, solid.size, solid.at)

    def _mesh(self, form: Form, axis: Axis, taper: float, size: Triple, at: Triple) -> StretchedMesh:
        key: tuple[Form, Axis, float] = ("ball", "y", 1.0) if form in ("ball", "capsule") else (form, axis, round(taper, 3))
        if key not in self._forms:
            self._forms[key] = f"{FOLDER}/{key[0]}_{len(self._forms)}.obj"
        return StretchedMesh(self._forms[key], size, at)

    def files(self) -> dict[str, bytes]:
        """Returns the meshes that were asked for, by path."""
        return {path: _obj(form, axis, taper) for (form, axis, taper), path in self._forms.items()}


def _obj(form: Form, axis: Axis, taper: float) -> bytes:
    surface = surface_of(BodyPart(form, (1.0, 1.0, 1.0), (0.0, 0.0, 0.0), axis, taper, ""))
    lines = [f"v {x:.6g} {y:.6g} {z:.6g}" for x, y, z in (_settled(point) for point in surface.points.tolist())]
    lines += [f"vn {x:.6g} {y:.6g} {z:.6g}" for x, y, z in (_settled(normal) for normal in surface.normals.tolist())]
    lines += [f"f {a}//{a} {b}//{b} {c}//{c}" for a, b, c in (surface.triangles + 1).tolist()]
    return "\n".join(lines).encode() + b"\n"


def _settled(point: Triple) -> Triple:
    x, y, z = (round(value, 6) + 0.0 for value in z_up(*point))
    return x, y, z
