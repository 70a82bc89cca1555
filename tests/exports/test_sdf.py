"""What the XML of SDF holds; libsdformat reads it in `python -m tests.targets physics`."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest

from solver.exports import ExportSettings, written_as
from tests.exports.homes import SCENES, described
from tests.exports.readers.sdf import ID

HOMES = [*SCENES, "hostile", "storeys"]


@pytest.mark.parametrize("home", HOMES)
def test_every_body_is_a_model_static_or_free(home: str) -> None:
    model = described(home)
    files = written_as(model, ExportSettings("sdf"))
    world = ElementTree.fromstring(next(content for name, content in files.items() if name.endswith(".sdf")))
    models = {one.findtext(ID): one for one in world.iter("model") if one.find(ID) is not None}
    names = [one.get("name") for one in world.iter("model")]
    assert len(set(names)) == len(names)
    assert not any("::" in str(name) or str(name).startswith("__") for name in names)
    for body in model.bodies:
        held = models[body.id].find("joint[@name='fixed']") is not None
        assert (models[body.id].findtext("static") == "true", held) == (body.fixed and not body.fronts, body.fixed and bool(body.fronts))
        assert len(list(models[body.id].iter("link"))) == 1 + len(body.fronts)
        assert bool(list(models[body.id].iter("collision"))) != body.flat
    for leaf in model.leaves:
        assert [joint.get("type") for joint in models[leaf.id].iter("joint")] == ["revolute" if leaf.motion == "swing" else "prismatic"]
    assert {uri.text for uri in world.iter("uri")} == {name for name in files if name.endswith(".obj")}
