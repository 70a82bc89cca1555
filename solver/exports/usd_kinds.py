"""Kinds as USD has them, which bodies and walls refer to: what is seen, and what collides."""

from __future__ import annotations

from functools import lru_cache
from typing import Final

from solver.body_parts import BodyPart
from solver.exports.colliders import Collider, colliders_of
from solver.exports.model import ModelBody, Paint, WallBox
from solver.exports.moving_parts import still_part
from solver.exports.usd_text import bound, cube, guide, material_name, part_text, prim, triples

_CORNERS: Final = [(x, y, z) for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
_QUADS: Final = {
    "-x": (0, 4, 6, 2), "+x": (1, 3, 7, 5), "-y": (0, 1, 5, 4), "+y": (2, 6, 7, 3), "-z": (0, 2, 3, 1), "+z": (4, 5, 7, 6),
}  # fmt: skip
"""The faces of a block by where they look, counter-clockwise seen from outside."""
_UNIT: Final = ((1.0, 1.0, 1.0), (0.0, 0.0, 0.0))


def body_kind(body: ModelBody, boxed: bool) -> str:
    """Returns the parts of a body but its fronts, z up; what they collide as; `boxed`: the whole body as one box, if it collides at all."""
    if body.flat:
        return _parts(body.parts, body.paints, None)
    if boxed:
        return _parts(body.parts, body.paints, None) + guide("collider", colliders_of(body, ())[0])
    still = still_part(body, (body.id,))
    return _parts(still.parts, still.paints, still.solids)


def body_guides(body: ModelBody, boxed: bool) -> str:
    """Returns what a body collides as that is shown as something else."""
    solids = () if body.flat else colliders_of(body, () if boxed else (body.id,))
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
