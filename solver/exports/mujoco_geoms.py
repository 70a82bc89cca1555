"""Geoms, meshes and materials as MJCF writes them; z up, as in colliders."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Final, NamedTuple

from solver.body_parts import BodyPart
from solver.exports.asset_objects import AssetObjects
from solver.exports.colliders import AXES, Collider, Triple, shares_of, z_up
from solver.exports.model import ModelBody, Paint
from solver.exports.paints import channels
from solver.exports.xml_text import xml_numbers, xml_text

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
            red, green, blue = channels(paint.color)
            rgba = xml_numbers(red / 255, green / 255, blue / 255, paint.opacity)
            shine = xml_numbers(round(1 - paint.roughness, 3))
            yield f'<material name="{name}" rgba="{rgba}" specular="{shine}" shininess="{shine}" emission="{xml_numbers(paint.glow)}"/>'
        for (paint, picture), name in self._pictured.items():
            rgb = xml_numbers(*(channel / 255 for channel in channels(paint.color)))
            yield f'<texture name="{name}" type="2d" file="{xml_text(picture)}"/>'
            yield f'<material name="{name}" texture="{name}" rgba="{rgb} {xml_numbers(paint.opacity)}"/>'
        for (path, stretch), name in self._own.items():
            yield f'<mesh name="{name}" file="{xml_text(path)}" scale="{xml_numbers(*stretch)}" inertia="shell"/>'
        for (scale, ratio), name in self._meshes.items():
            yield f'<mesh name="{name}" builtin="cone" params="{_EDGES} {ratio}" scale="{scale}"/>'


@lru_cache(maxsize=1 << 12)
def _shown(parts: tuple[BodyPart, ...]) -> tuple[_ShownPart, ...]:
    return tuple(map(_shown_part, parts))


def _shown_part(part: BodyPart) -> _ShownPart:
    (w, h, d), at, axis = part.size, z_up(*part.at), AXES[part.axis]
    size = (w, d, h)
    if part.form in ("box", "rounded"):
        return _ShownPart(_begun(Collider("box", size, at), "visual"))
    across, along = [size[i] for i in _LOCAL[axis][:2]], size[_LOCAL[axis][2]]
    is_round = abs(across[0] - across[1]) < 1e-4
    if part.form == "capsule" and is_round and along > across[0]:
        return _ShownPart(_begun(Collider("capsule", size, at, axis), "visual"))
    if part.form in ("ball", "capsule"):
        return _ShownPart(_begun(Collider("ellipsoid", size, at), "visual"))
    if part.form == "cylinder" and part.taper == 1 and is_round:
        return _ShownPart(_begun(Collider("cylinder", size, at, axis), "visual"))
    return _mesh((*across, along), at, axis, part.taper)


def _mesh(local: Sequence[float], at: tuple[float, float, float], axis: str, taper: float) -> _ShownPart:
    """Returns the geom of a cone, a stump or an oval."""
    tipped = taper > 1
    mesh = xml_numbers(*(extent / 2 for extent in local)), xml_numbers(round(1 / taper if tipped else taper, 3))
    return _ShownPart(f' pos="{xml_numbers(*at)}"{(_TIPPED if tipped else _TURNED)[axis]}', mesh)
