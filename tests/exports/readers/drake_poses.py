"""Reads a home with Drake, which parses all three formats by code of its own, and compares where bodies are."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from solver.exports import HouseModel

NEAR = 1e-3
"""How far a body may be from where the description has it, m."""


def findings(folder: Path, model: HouseModel) -> Iterator[str]:
    """Yields a line a format; FAULT begins what is wrong."""
    for ending in ("xml", "urdf", "sdf"):
        yield _finding(folder / f"{model.name}.{ending}", model)


def _finding(path: Path, model: HouseModel) -> str:
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
    from pydrake.multibody.tree import BodyIndex
    from pydrake.systems.framework import DiagramBuilder

    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, time_step=0.004)
    Parser(plant).AddModels(path)
    plant.Finalize()
    diagram = builder.Build()
    context = plant.GetMyContextFromRoot(diagram.CreateDefaultContext())
    found: dict[str, np.ndarray] = {}
    for i in range(plant.num_bodies()):
        body = plant.get_body(BodyIndex(i))
        instance = plant.GetModelInstanceName(body.model_instance())
        name = instance.split("::")[-1] if path.suffix == ".sdf" else body.name()
        found.setdefault(name, plant.EvalBodyPoseInWorld(context, body).translation())  # the first link of a model, before its fronts
    missing = [body.id for body in model.bodies if body.id not in found]
    wrong = [
        body.id for body in model.bodies if body.id in found and np.abs(found[body.id] - np.array((body.x, -body.z, body.y))).max() > NEAR
    ]
    fault = "FAULT " if missing or wrong else ""
    return f"{fault}drake {path.suffix}: {len(found)} bodies, {len(missing)} missing, {len(wrong)} elsewhere {(missing + wrong)[:3]}"
