"""Shapes of decorations and of the living: complete, within their boxes, at their surfaces, without faces that fight."""

from __future__ import annotations

from itertools import combinations

import pytest

from catalogs import load_catalogs
from catalogs.shapes import Solid
from tests.every import every

CATALOGS = load_catalogs()
LIVING = tuple(kind for kind, entry in CATALOGS.furniture.items() if entry.category == "dynamic")
THINGS = (*CATALOGS.decorations, *LIVING)
POSED = {"pillow": "upright", "throw_pillow": "upright", "book": "upright", "person": "seated", "child": "seated"}
DRAWN = (*THINGS, *(f"{kind}_{pose}" for kind, pose in POSED.items()))
HUNG = sorted({name for entry in CATALOGS.decorating.values() for row in entry.hangs for name in row.put})
RUGS = ("rug", "floor_rug_small", "runner")
MARGIN = 0.002
"""How far from a surface the top of what carries may lie, m."""


def _top_at(solids: tuple[Solid, ...], x: float, z: float) -> float:
    """Returns the highest point over a place of a plan, as a share, where boxes and upright cylinders are all there is."""
    tops = [0.0]
    for solid in solids:
        u, v = ((at - (low + high) / 2) / (high - low) for at, (low, high) in ((x, solid.x), (z, solid.z)))
        inside = u * u + v * v <= 0.25 if solid.form == "cylinder" else max(abs(u), abs(v)) <= 0.5
        tops.append(solid.y[1] if inside else 0.0)
    return max(tops)


@every("kind", DRAWN)
def test_a_thing_fills_its_box_and_leaves_it_nowhere(kind: str) -> None:
    solids = CATALOGS.shapes[kind]
    assert 1 <= len(solids) <= 16
    for axis in "xyz":
        spans = [getattr(solid, axis) for solid in solids]
        assert all(0 <= low < high <= 1 for low, high in spans), axis
        assert max(high for _, high in spans) - min(low for low, _ in spans) > (0.9 if axis == "y" else 0.3), axis
    assert min(solid.y[0] for solid in solids) == 0, "it stands on nothing"
    assert all(solid.material in CATALOGS.materials for solid in solids)


@every("kind", HUNG)
def test_what_hangs_touches_its_wall(kind: str) -> None:
    assert min(solid.z[0] for solid in CATALOGS.shapes[kind]) == 0


@every("kind", [kind for kind, entry in CATALOGS.decorations.items() if entry.surfaces])
def test_what_carries_has_its_top_at_its_surface(kind: str) -> None:
    entry = CATALOGS.decorations[kind]
    for surface in entry.surfaces:
        top = _top_at(CATALOGS.shapes[kind], 0.5, 0.5) * entry.size[2]
        assert top == pytest.approx(surface.height, abs=MARGIN)
        assert max(solid.y[1] for solid in CATALOGS.shapes[kind]) * entry.size[2] <= surface.height + MARGIN


@every("kind", RUGS)
def test_rugs_are_flat_with_a_border_of_another_shade(kind: str) -> None:
    solids = CATALOGS.shapes[kind]
    assert CATALOGS.decorations[kind].size[2] <= 0.02
    assert all(solid.form == "box" and solid.y[0] == 0 for solid in solids)
    assert _top_at(solids, 0.5, 0.5) == 1 > _top_at(solids, 0.005, 0.5) > 0
    shades = {(CATALOGS.materials[s.material].color, CATALOGS.materials[s.material].shade) for s in solids}
    assert len(shades) == len(solids)


@every("kind", DRAWN)
def test_no_two_materials_show_in_one_plane(kind: str) -> None:
    """Flat faces that look the same way, lie in one plane and overlap, would flicker; undersides and backs are not seen."""
    boxes = [solid for solid in CATALOGS.shapes[kind] if solid.form == "box"]
    for one, other in combinations(boxes, 2):
        for axis, end in (("x", 0), ("x", 1), ("y", 1), ("z", 1)):
            across = [name for name in "xyz" if name != axis]
            same = one.material != other.material and abs(getattr(one, axis)[end] - getattr(other, axis)[end]) < 1e-9
            shared = [min(getattr(one, a)[1], getattr(other, a)[1]) - max(getattr(one, a)[0], getattr(other, a)[0]) for a in across]
            assert not (same and min(shared) > 1e-9), (one, other, axis)


@every("kind", [kind for kind, pose in POSED.items() if pose == "upright"])
def test_what_is_tipped_upright_keeps_its_width_and_swaps_the_rest(kind: str) -> None:
    lying, tipped = CATALOGS.shapes[kind], CATALOGS.shapes[f"{kind}_upright"]
    for one, other in zip(lying, tipped, strict=False):
        assert one.material == other.material
        assert one.y[1] - one.y[0] == pytest.approx(other.z[1] - other.z[0])


def test_pets_have_ears_on_both_sides_and_legs_on_the_floor() -> None:
    for kind in ("dog", "cat"):
        solids = CATALOGS.shapes[kind]
        ears = [solid for solid in solids if solid.material == "body_dark" and solid.y[1] > 0.9 and solid.z[0] > 0.5]
        assert {solid.x[1] <= 0.5 for solid in ears} == {True, False}
        assert sum(solid.y[0] == 0 for solid in solids) == 4


def test_every_style_changes_known_slots_and_none_looks_like_another() -> None:
    for style in CATALOGS.styles.values():
        assert {"wood", "metal", "metal_dark", "worktop", "fabric", "lamp_shade"} <= set(style.materials) <= set(CATALOGS.materials)
    for slot in ("wood", "wood_dark", "metal", "worktop", "fabric"):
        assert len({style.materials[slot].color for style in CATALOGS.styles.values()}) == len(CATALOGS.styles)
