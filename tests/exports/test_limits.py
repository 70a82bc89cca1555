"""Where the limits of exports lie: on either side of each, or what it comes to."""

from __future__ import annotations

import io
import json
from dataclasses import replace
from xml.etree import ElementTree

import pytest
from ezdxf.filemanagement import read as read_dxf

from catalogs import load_catalogs
from compose_homes import export
from solver.exports import ExportSettings, HouseModel, describe, written_as
from solver.exports.formats.pieces_csv import harmless
from solver.scene import Decoration, Furniture, Opening, Room, Scene
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


def numbers(element: ElementTree.Element, name: str) -> list[float]:
    return [float(word) for word in element.attrib[name].split()]


def test_the_ground_goes_on_5_m_around_a_house_and_is_5_cm_thick() -> None:
    (text,) = (content for name, content in written(model(side=2.0), "mjcf").items() if name.endswith(".xml"))
    (ground,) = ElementTree.fromstring(text).findall(".//geom[@name='ground']")
    assert numbers(ground, "size") == pytest.approx([6.0, 6.0, 0.025])
    assert numbers(ground, "pos") == pytest.approx([1.0, -1.0, -0.025])


def test_a_leaf_weighs_12_kg_a_square_metre_and_is_touched_2_mm_off_its_frame() -> None:
    opening = Opening("door", wall="north", position=2.0, width=0.9, connects_to="EXTERIOR", hinge="start", swing="in")
    room = Room("den", 0, "office", width=4.0, depth=4.0, openings=(opening,))
    described = describe(Scene(wall_thickness=0.1, rooms=(room,)), CATALOGS)
    (leaf,) = described.leaves
    assert leaf.mass == pytest.approx(12.0 * leaf.width * leaf.height, abs=0.001)
    (text,) = (content for name, content in written(described, "mjcf").items() if name.endswith(".xml"))
    slab = ElementTree.fromstring(text).findall(".//body[@name='door']/geom[@class='leaf']")[0]
    assert numbers(slab, "size")[0] == pytest.approx(leaf.width / 2 - 0.002)


def test_a_drawing_says_names_in_at_most_255_bytes_and_whole_letters() -> None:
    name = "\u00e9" * 200
    described = describe(Scene(rooms=(Room(name, 0, "office", width=4.0, depth=4.0),)), CATALOGS)
    document = read_dxf(io.StringIO(written(described, "dxf")["house.dxf"].decode()))
    said = {tag.value for entity in document.modelspace() if entity.xdata for tags in entity.xdata.data.values() for tag in tags}
    assert name[:127] in said


@pytest.mark.parametrize(("errors", "last"), [(20, "out_of_bounds"), (21, "and 1 more errors")])
def test_20_errors_are_told_and_how_many_more_there_are(errors: int, last: str) -> None:
    outside = tuple(replace(TABLE, id=f"den/table_{k}", name="crate", x=-5.0 - 3 * k) for k in range(errors))
    (content,) = export(Scene(rooms=(Room("den", width=4.0, depth=4.0, furniture=outside),)), "procthor").values()
    told = json.loads(content)["metadata"]["compose"]["warnings"]
    assert len(told) == min(errors, 21)
    assert told[-1].startswith(last)
