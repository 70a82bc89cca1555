"""Where the limits lie that docs/exports.md names: on either side of each."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver.exports import ExportSettings, HouseModel, describe, written_as
from solver.exports.formats.pieces_csv import harmless
from solver.scene import Decoration, Furniture, Room, Scene
from tests.exports.readers.nav2 import read_map

CATALOGS = load_catalogs()
TABLE = Furniture("den/table", "dining_table", x=2.0, z=2.0, width=1.6, depth=0.9, height=0.75)


def model(*furniture: Furniture, things: tuple[Decoration, ...] = (), side: float = 6.0) -> HouseModel:
    room = Room("den", 0, "office", x=0.0, z=0.0, width=side, depth=side, furniture=furniture, decorations=things)
    return describe(Scene(wall_thickness=0.1, rooms=(room,)), CATALOGS)


def written(described: HouseModel, form: str) -> dict[str, bytes]:
    return dict(written_as(described, ExportSettings(form)))


def hung(y: float) -> Decoration:
    return Decoration("den/lamp", "nobody_knows", x=1.0, y=y, z=1.0, width=0.4, depth=0.4, height=0.3)


@pytest.mark.parametrize(("weighs", "is_free"), [(14.99, True), (15.0, False)])
def test_what_weighs_less_than_15_kg_is_free(weighs: float, is_free: bool) -> None:
    (usual,) = model(replace(TABLE, name="crate")).bodies
    (crate,) = model(replace(TABLE, name="crate", width=TABLE.width * weighs / usual.mass)).bodies
    assert (crate.mass, crate.fixed) == (weighs, not is_free)


def test_one_stands_45_cm_before_what_one_uses_and_nothing_weighs_nothing() -> None:
    (chair,) = model(replace(TABLE, name="armchair")).bodies
    assert [*chair.uses[0]] == pytest.approx([2.0, 2.0 + TABLE.depth / 2 + 0.45, 180.0])
    (bead,) = model(replace(TABLE, name="crate", width=0.01, depth=0.01, height=0.01)).bodies
    assert bead.mass == 0.01


@pytest.mark.parametrize(("y", "is_taken"), [(1.499, True), (1.5, False)])
def test_a_robot_drives_under_what_begins_1_5_m_above_the_floor(y: float, is_taken: bool) -> None:
    grid = read_map(written(model(things=(hung(y),), side=2.0), "nav2"))
    assert grid.occupied[grid.cell(1.0, -1.0)] == is_taken
    assert grid.origin == pytest.approx((-0.5, -2.5))


@pytest.mark.parametrize("begins", ["=", "+", "-", "@", "\t", "\r"])
def test_no_word_begins_as_a_formula_does(begins: str) -> None:
    assert (harmless(f"{begins}1"), harmless(f"1{begins}"), harmless(-1.0)) == (f"'{begins}1", f"1{begins}", -1.0)
