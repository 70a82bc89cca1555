"""Fronts in formats that have joints: the same axes, hinges and limits everywhere; what they are made of stays whole."""

from __future__ import annotations

import math
from functools import cache

import pytest

from catalogs import load_catalogs
from solver import Request, generate
from solver.exports import ExportSettings, HouseModel, describe, written_as
from solver.exports.moving_parts import moving_parts, still_part
from solver.scene import Furniture, Room, Scene
from tests.exports.homes import described
from tests.exports.joints import READERS, described_joints, joint_differences
from tests.sweeps import seeds

SEEDS = seeds(range(50), 25)
PROGRAMS = (None, "family", "large")


@cache
def home(seed: int) -> HouseModel:
    return describe(generate(Request(seed=seed, program=PROGRAMS[seed % 3])).scene, load_catalogs())


@cache
def turned() -> HouseModel:
    """A piece of each way to open, turned by an odd angle."""
    names = ("wardrobe", "dresser", "stove", "toy_chest", "toilet", "refrigerator", "shoe_cabinet", "microwave")
    kinds = load_catalogs().furniture
    pieces = tuple(
        Furniture(name, name, x=1.5 * number + 1, z=2.0, rotation=37.0 * number, width=kinds[name].size[0], depth=kinds[name].size[1],
                  height=kinds[name].size[2])
        for number, name in enumerate(names)
    )  # fmt: skip
    return describe(Scene(wall_thickness=0.1, rooms=(Room("den", 0, "den", width=14.0, depth=4.0, furniture=pieces),)), load_catalogs())


@pytest.mark.parametrize("format", READERS)
def test_joints_are_the_descriptions(format: str) -> None:
    for model in (turned(), *map(home, SEEDS)):
        seen = READERS[format](written_as(model, ExportSettings(format)))
        assert len(described_joints(model)) > 10
        assert joint_differences(model, format, seen) == []


def test_another_joint_would_be_seen() -> None:
    model = turned()
    seen = described_joints(model)
    name = next(iter(seen))
    for change in ({"low": -80.0}, {"axis": (1.0, 0.0, 0.0)}, {"slides": True}, {"point": (0.0, 0.0, 0.0)}):
        assert len(joint_differences(model, "file", seen | {name: seen[name]._replace(**change)})) == 1
    assert joint_differences(model, "file", {}) != []


def test_a_body_is_its_fronts_and_what_stays() -> None:
    for body in described("family").bodies:
        still, moving = still_part(body, {body.id}), moving_parts(body)
        assert len(body.parts) == len(still.parts) + sum(len(front.parts) for front in moving)
        assert body.mass == pytest.approx(still.mass + sum(front.mass for front in moving))
        assert all(front.mass > 0 for front in moving)


def test_what_opens_goes_out_to_the_front_or_up() -> None:
    """Half open, the middle of a front's panel is farther out or higher than shut."""
    for body in turned().bodies:
        for front in body.fronts:
            panel = body.parts[front.parts[0]]
            away = [at - hinge for at, hinge in zip(panel.at, front.hinge, strict=True)]
            if front.slides:
                assert front.axis == "z"
                assert 0.1 < front.end < body.depth
                continue
            cosine, sine = math.cos(math.radians(front.end / 2)), math.sin(math.radians(front.end / 2))
            x, y, z = away
            moved = (
                (x, y * cosine - z * sine, y * sine + z * cosine)
                if front.axis == "x"
                else (x * cosine + z * sine, y, z * cosine - x * sine)
            )
            lid = panel.size[1] < panel.size[2]
            assert moved[1 if lid else 2] - away[1 if lid else 2] > 0.2 * sorted(panel.size)[1], (body.id, front.name)
