"""Plans as DXF, read and audited by ezdxf."""

from __future__ import annotations

import pytest

from catalogs import load_catalogs
from solver.exports import ExportSettings, describe, written_as
from solver.exports.formats.plan_dxf import dxf_text
from solver.exports.model import HouseModel
from solver.scene import Room, Scene
from tests.exports import homes
from tests.exports.readers import dxf


def written(model: HouseModel) -> dict[str, bytes]:
    return written_as(model, ExportSettings("dxf"))


@pytest.mark.parametrize("name", ["own", "default", "hostile", "storeys"])
def test_nothing_is_to_be_mended(name: str) -> None:
    for drawing in dxf.drawings(written(homes.described(name))):
        audit = drawing.audit()
        assert [one.message for one in (*audit.errors, *audit.fixes)] == []
        assert drawing.units == 6


def test_doors_turn_about_their_hinges() -> None:
    model = homes.described("own")
    (drawing,) = dxf.drawings(written(model))
    arcs = drawing.modelspace().query("ARC")
    leaves = [leaf for leaf in model.leaves if leaf.motion == "swing"]
    assert len(arcs) == len(leaves) == 9
    for arc, leaf in zip(arcs, leaves, strict=True):
        assert tuple(arc.dxf.center)[:2] == pytest.approx((leaf.hinge[0], -leaf.hinge[2]), abs=1e-5)
        assert (arc.dxf.end_angle - arc.dxf.start_angle) % 360 == pytest.approx(90)
        ends = {round(arc.dxf.start_angle) % 360, round(arc.dxf.end_angle) % 360}
        assert ends == {round(leaf.closed) % 360, round(leaf.closed + leaf.swing) % 360}


def test_dimensions_measure_what_they_say() -> None:
    (drawing,) = dxf.drawings(written(homes.described("own")))
    found = drawing.modelspace().query("DIMENSION")
    assert len(found) > 30
    for one in found:
        (text,) = [entity for entity in one.get_geometry_block() if entity.dxftype() == "TEXT"]
        assert text.dxf.text == f"{one.get_measurement():.2f}"
    assert {14.1, 10.1, 8.15} <= {round(one.get_measurement(), 6) for one in found}


def test_rooms_say_how_wide_and_deep_they_are() -> None:
    (drawing,) = dxf.drawings(written(homes.described("own")))
    texts = {text.dxf.text for text in drawing.modelspace().query("TEXT")}
    assert {"5.90 × 4.90", "3.40 × 1.90", "7.90 × 2.90"} <= texts


def test_blocks_are_shared_by_bodies_of_a_kind_and_size() -> None:
    model = homes.described("default")
    (drawing,) = dxf.drawings(written(model))
    blocks = {insert.dxf.name for insert in drawing.modelspace().query("INSERT")}
    assert len(blocks) == len({(body.shape, body.width, body.depth, body.height) for body in model.bodies}) < 0.8 * len(model.bodies)
    assert any(name.startswith("DOUBLE_VANITY_") for name in blocks)


def test_text_stays_on_its_line() -> None:
    assert dxf_text("a\nb^\tc") == "a^Jb^ ^Ic"
    files = written(describe(Scene(rooms=(Room("a", width=4, depth=3),)), load_catalogs(), warnings=["one\n0\nEOF"]))
    (drawing,) = dxf.drawings(files)
    assert drawing.header.custom_vars.get("Warning 1") == "one^J0^JEOF"
