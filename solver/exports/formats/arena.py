"""Isaac Lab-Arena: the house as a background, and the environment's YAML that names what is in it.

An environment also wants a robot and a task, which are the user's: the YAML says where. The frame is that of USD.
"""

from __future__ import annotations

import json
from typing import Final

from solver.exports.formats.usd_stage import prim_paths, stage_text
from solver.exports.model import HouseModel
from solver.exports.writers import ExportSettings, Files

_HEAD: Final = """\
# An environment of Isaac Lab-Arena. Register a background `{name}` whose usd_path is {name}.usda, and add `embodiment` and `task`.
"""


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.usda`, without a light since Arena brings one, and `<house>_arena.yaml`: a reference for each body."""
    told = "".join(f"# {json.dumps(warning)}\n" for warning in model.warnings)
    references = [
        f"- {{id: {path.rpartition('/')[2]}, parent_id: {model.name}, prim_path: {path.removeprefix('/House/')}, object_type: {kind}}}\n"
        for path, kind in zip(prim_paths(model).values(), ("base" if body.fixed else "rigid" for body in model.bodies), strict=True)
    ]
    listed = f"object_references:\n{''.join(references)}" if references else "object_references: []\n"
    text = (
        f"{_HEAD.format(name=model.name)}{told}env_name: {model.name}\n"
        f"background: {{id: {model.name}, registry_name: {model.name}}}\nobjects: []\n{listed}relations: []\n"
    )
    stage, beside = stage_text(model, lit=False)
    return {f"{model.name}.usda": stage.encode(), f"{model.name}_arena.yaml": text.encode(), **beside}
