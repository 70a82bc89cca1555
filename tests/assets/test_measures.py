"""An asset's size: measured as trimesh measures it, in the one unit that fits, in the frame of its front."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from catalogs import CatalogError, Catalogs, add_assets, load_catalogs
from catalogs.assets.asset_entry import FRONT_TURNS
from catalogs.assets.glb_file import bounds_of, read_glb
from tests.assets.makers import folder, shape, under

KINDS = sorted(key for key, kind in load_catalogs().furniture.items() if kind.category != "dynamic")
QUARTER = [0, 0.5**0.5, 0, 0.5**0.5]
"""A quarter turn about y, as a quaternion."""


def assets(at: Path, content: bytes, **entry: object) -> Catalogs:
    return add_assets(load_catalogs(), folder(at, {"a.glb": content}, {"a": {"file": "a.glb", "license": "CC0-1.0", **entry}}))


def drawn(content: bytes) -> Any:
    """A file as trimesh opens it."""
    import trimesh

    return trimesh.load_scene(io.BytesIO(content), file_type="glb")


def test_bounds_are_those_of_the_points(tmp_path: Path) -> None:
    for kind in KINDS:
        content = under(shape(kind), translation=[3, -1, 2], scale=[1.1, 0.9, 1.3], rotation=QUARTER)
        (tmp_path / "a.glb").write_bytes(content)
        scene, found = drawn(content), bounds_of(read_glb(tmp_path / "a.glb"))
        assert np.allclose([found.low, found.high], scene.bounds, atol=1e-5), kind
        assert found.triangles == sum(len(mesh.faces) for mesh in scene.geometry.values())


@pytest.mark.parametrize(("factor", "guessed"), [(1, ()), (100, ("size",)), (1000, ("size",)), (1 / 0.0254, ("size",))])
def test_metres_centimetres_millimetres_and_inches_are_told_apart(factor: float, guessed: tuple[str, ...], tmp_path: Path) -> None:
    files = {f"{kind}.glb": under(shape(kind), scale=[factor * 1.1] * 3) for kind in KINDS}
    at = folder(tmp_path, files, {kind: {"file": f"{kind}.glb", "kinds": [kind]} for kind in KINDS})
    found = add_assets(load_catalogs(), at, "any").assets
    assert sorted(found) == KINDS
    for kind, asset in found.items():
        width, height, depth = (1.1 * side for side in drawn(shape(kind)).extents)
        assert asset.size == pytest.approx((width, depth, height), rel=1e-4), kind
        assert asset.guessed == guessed


@pytest.mark.parametrize("factor", [10, 0.1, 3, 250, 1e-6])
def test_an_unknown_unit_is_refused(factor: float, tmp_path: Path) -> None:
    with pytest.raises(CatalogError, match=r"a\.file: a\.glb is of an unknown unit.*say its `size`"):
        assets(tmp_path, under(shape("sofa"), scale=[factor] * 3), kinds=["sofa"])


def test_a_size_that_is_said_says_the_unit(tmp_path: Path) -> None:
    found = assets(tmp_path, under(shape("sofa"), scale=[10, 10, 10]), kinds=["sofa"], size=[2.2, 0.9, 0.85]).assets["a"]
    assert (found.size, found.guessed) == ((2.2, 0.9, 0.85), ())
    with pytest.raises(CatalogError, match="proportions"):
        assets(tmp_path, shape("sofa"), kinds=["sofa"], size=[0.9, 2.2, 0.85])


@pytest.mark.parametrize("front", FRONT_TURNS)
def test_width_is_across_the_front(front: str, tmp_path: Path) -> None:
    found = assets(tmp_path, shape("sofa"), kinds=["sofa"], front=front, size=[2.2, 0.9, 0.85] if front[1] == "z" else [0.9, 2.2, 0.85])
    assert found.assets["a"].front == front


def test_an_unknown_kind_is_refused_with_the_line(tmp_path: Path) -> None:
    with pytest.raises(CatalogError, match=r"assets\.yaml:\d: a\.kinds\.0: unknown kind 'soffa'; sofa\?"):
        assets(tmp_path, shape("sofa"), kinds=["soffa"])


def test_a_surface_above_its_top_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CatalogError, match=r"has a surface at 2\.0 m"):
        assets(tmp_path, shape("sofa"), kinds=["sofa"], surfaces=[2.0])


def test_homes_of_a_seed_do_not_depend_on_assets(tmp_path: Path) -> None:
    assert assets(tmp_path, shape("sofa"), kinds=["sofa"]).fingerprint == load_catalogs().fingerprint


@pytest.mark.parametrize(
    ("license", "used"),
    [
        ("CC0-1.0", True), ("CC-BY-4.0", True), ("MIT", True), ("CC-BY-SA-4.0", True), ("CC-BY-NC-4.0", False), ("CC BY NC SA 3.0", False),
        ("cc-by-nc-nd-4.0", False), ("Creative Commons Attribution-NonCommercial", False), ("for non-commercial use", False),
        ("unsaid", False), ("Incremental licence", True),
    ],
)  # fmt: skip
def test_licences_that_forbid_commercial_use_are_asked_for(license: str, used: bool, tmp_path: Path) -> None:
    at = folder(tmp_path, {"a.glb": shape("sofa")}, {"a": {"file": "a.glb", "kinds": ["sofa"], "license": license}})
    assert ("a" in add_assets(load_catalogs(), at).assets) is used
    assert "a" in add_assets(load_catalogs(), at, "any").assets


def test_a_folder_without_the_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CatalogError, match="compose assets check"):
        add_assets(load_catalogs(), tmp_path)
