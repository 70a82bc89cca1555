"""Geoms, meshes and materials as MJCF writes them.

Comes in: colliders, parts and paints. Goes out: lines of XML. May import: the model, colliders.

Frame: z up, as in colliders.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

from solver.body_parts import BodyPart
from solver.exports.colliders import AXES, Collider, z_up
from solver.exports.model import Paint
from solver.exports.paints import channels
from solver.exports.xml_text import xml_numbers

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
    at = f'pos="{xml_numbers(*solid.at)}"'
    if solid.form in ("box", "ellipsoid"):
        kind = "" if solid.form == "box" else ' type="ellipsoid"'
        return f'<geom class="{classed}"{kind} size="{xml_numbers(*(extent / 2 for extent in solid.size))}" {at}{more}/>'
    radius, length = solid.round_size
    half = length / 2 - (radius if solid.form == "capsule" else 0.0)
    return f'<geom class="{classed}" type="{solid.form}" size="{xml_numbers(radius, half)}" {at}{_TURNED[solid.axis]}{more}/>'


class MujocoLooks:
    """What a file's bodies look like; keeps the materials and meshes that they need."""

    def __init__(self) -> None:
        self._materials: dict[Paint, str] = {}
        self._meshes: dict[tuple[str, str], str] = {}
        self._shown: dict[tuple[tuple[BodyPart, ...], tuple[Paint, ...]], str] = {}

    def parts(self, parts: tuple[BodyPart, ...], paints: tuple[Paint, ...]) -> str:
        """Returns the visual geoms of a body."""
        key = parts, paints
        if key not in self._shown:
            self._shown[key] = "".join([self._part(part, paint) for part, paint in zip(parts, paints, strict=True)])
        return self._shown[key]

    def painted(self, paint: Paint) -> str:
        """Returns the attribute that paints a geom."""
        return f' material="{self._materials.setdefault(paint, f"paint_{len(self._materials)}")}"'

    def assets(self) -> Iterator[str]:
        """Yields the materials and meshes of all that was shown."""
        for paint, name in self._materials.items():
            red, green, blue = channels(paint.color)
            rgba = xml_numbers(red / 255, green / 255, blue / 255, paint.opacity)
            shine = xml_numbers(round(1 - paint.roughness, 3))
            yield f'<material name="{name}" rgba="{rgba}" specular="{shine}" shininess="{shine}" emission="{xml_numbers(paint.glow)}"/>'
        for (scale, ratio), name in self._meshes.items():
            yield f'<mesh name="{name}" builtin="cone" params="{_EDGES} {ratio}" scale="{scale}"/>'

    def _part(self, part: BodyPart, paint: Paint) -> str:
        (w, h, d), at, axis = part.size, z_up(*part.at), AXES[part.axis]
        size, look = (w, d, h), self.painted(paint)
        if part.form in ("box", "rounded"):
            return geom(Collider("box", size, at), "visual", look)
        across, along = [size[i] for i in _LOCAL[axis][:2]], size[_LOCAL[axis][2]]
        is_round = abs(across[0] - across[1]) < 1e-4
        if part.form == "capsule" and is_round and along > across[0]:
            return geom(Collider("capsule", size, at, axis), "visual", look)
        if part.form in ("ball", "capsule"):
            return geom(Collider("ellipsoid", size, at), "visual", look)
        if part.form == "cylinder" and part.taper == 1 and is_round:
            return geom(Collider("cylinder", size, at, axis), "visual", look)
        return self._mesh((*across, along), at, axis, part.taper) + f"{look}/>"

    def _mesh(self, local: Sequence[float], at: tuple[float, float, float], axis: str, taper: float) -> str:
        """Returns the begin of a geom for a cone, a stump or an oval."""
        tipped = taper > 1
        key = xml_numbers(*(extent / 2 for extent in local)), xml_numbers(round(1 / taper if tipped else taper, 3))
        name = self._meshes.setdefault(key, f"mesh_{len(self._meshes)}")
        turn = (_TIPPED if tipped else _TURNED)[axis]
        return f'<geom class="visual" type="mesh" mesh="{name}" pos="{xml_numbers(*at)}"{turn}'
