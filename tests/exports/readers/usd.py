"""Reads a stage with usd-core: poses as composed, masses by UsdPhysics, ids and sizes from custom data."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Mapping
from pathlib import Path

from pxr import Sdf, Usd, UsdGeom, UsdPhysics, UsdValidation

from tests.exports.readers import Seen

SORTS = ("Furniture", "Decorations", "People")


def stage_of(files: Mapping[str, bytes]) -> Usd.Stage:
    """The stage of a text, of a binary file or of a packed one; an environment's YAML beside it is passed over."""
    ((name, content),) = [one for one in files.items() if Path(one[0]).suffix.startswith(".usd")]
    if not content.startswith(b"#usda"):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, name)
            path.write_bytes(content)
            return Usd.Stage.Open(str(path))
    layer = Sdf.Layer.CreateAnonymous(".usda")
    assert layer.ImportFromString(content.decode())
    return Usd.Stage.Open(layer)


def findings(of: Usd.Stage) -> list[str]:
    """What all of usd-core's validators find."""
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    assert len(validators) >= 30
    return [error.GetErrorAsString() for error in UsdValidation.ValidationContext(validators).Validate(of)]


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    """The bodies of a house, by their ids."""
    return read_stage(stage_of(files))


def read_stage(stage: Usd.Stage) -> dict[str, Seen]:
    """The bodies of a stage, by their ids."""
    assert (UsdGeom.GetStageUpAxis(stage), UsdGeom.GetStageMetersPerUnit(stage)) == ("Z", 1.0)
    cache = UsdGeom.XformCache()
    found: dict[str, Seen] = {}
    of_fronts: dict[str, float] = {}
    for prim in stage.GetDefaultPrim().GetChild("Fronts").GetChildren():
        body = prim.GetCustomDataByKey("body")
        of_fronts[body] = of_fronts.get(body, 0.0) + UsdPhysics.MassAPI(prim).GetMassAttr().Get()
    for sort in SORTS:
        for prim in stage.GetDefaultPrim().GetChild(sort).GetChildren():
            at = cache.GetLocalToWorldTransform(prim)
            x, north, up = at.ExtractTranslation()
            across = at.TransformDir((1, 0, 0))
            width, depth, height = prim.GetCustomDataByKey("size")
            mass = UsdPhysics.MassAPI(prim).GetMassAttr().Get() * UsdPhysics.GetStageKilogramsPerUnit(stage)
            mass += of_fronts.get(prim.GetCustomDataByKey("id"), 0.0)
            turn = math.degrees(math.atan2(across[1], across[0])) % 360
            found[prim.GetCustomDataByKey("id")] = Seen(x, up, -north, turn, width, depth, height, mass)
    return found
