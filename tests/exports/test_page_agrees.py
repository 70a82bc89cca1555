"""The page and the exports build the same house: walls, fittings, leaves and parts agree to a millimetre, paints to a shade.

The page's own functions, in TypeScript, write down what they build of seven homes; the description must say the same.
"""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import pytest

from catalogs import load_catalogs
from compose_homes import Request, Scene, generate, load
from solver.body_parts import BodyPart
from solver.exchange import write_scene
from solver.exports import HouseModel, describe
from solver.exports.model import Cuboid, Paint
from solver.exports.plan_rooms import clear_corners
from solver.named_assets import with_kinds
from tests.architecture.tree import ROOT
from tests.imports.plans import floor_area

MM = 0.001
REQUESTS = (
    {"seed": 11, "program": "family", "decorate": True, "style": "rustic"},
    {"seed": 12, "program": "studio", "decorate": True},
    {"seed": 13, "width": 14, "depth": 11, "outdoor": True, "decorate": True},
    {"seed": 14, "program": "one_bed", "decorate": True},
)
L_SHAPED = """
wall_thickness: 0.12
levels: [{index: 0, elevation: 0.5, height: 2.5}]
rooms:
- id: den
  type: living_room
  x: 1.0
  z: 2.0
  width: 5.0
  depth: 4.0
  outline: [[0, 0], [5, 0], [5, 2], [3, 2], [3, 4], [0, 4]]
  walls: {type: wood, color: "#aa8866"}
  openings:
  - {id: d, kind: door, edge: 2, position: 1.0, width: 0.9, hinge: end, swing: out}
  - {id: w, kind: window, wall: north, position: 2.5, width: 1.6, height: 1.2, sill: 0.9}
  furniture:
  - {id: s, name: sofa, x: 1.2, z: 1.0, rotation: 30, width: 1.9, depth: 0.9, height: 0.85, color: "#335577"}
  - {id: u, name: armchair, x: 1.2, z: 3.0, width: 0.8, depth: 0.8, height: 0.85}
  - {id: q, name: no_such_thing, x: 4.0, z: 1.0, width: 0.5, depth: 0.6, height: 0.7}
- id: yard
  type: backyard
  x: 6.0
  z: 2.0
  width: 4.0
  depth: 2.0
  outdoor: true
  openings: [{id: g, kind: door, wall: east, position: 1.0, width: 1.0, connects_to: EXTERIOR}]
dynamic:
- {id: p, kind: person, room: den, "on": s, x: 1.2, y: 0.45, z: 1.0, rotation: 30, width: 0.46, depth: 0.5, height: 0.9}
"""

THICK_WALLS = """
wall_thickness: 0.1
size: {width: 8.25, depth: 8.14, height: 2.4}
rooms:
- {id: a, x: 0.0, z: 0.0, width: 3.0, depth: 4.0, wall_thickness: [0.4, null, 0.3, 0.36], openings: [
    {id: ab, kind: door, wall: east, position: 1.5, connects_to: b},
    {id: front, kind: door, wall: north, position: 1.2, width: 1.7, hinge: end, connects_to: EXTERIOR, main_entrance: true},
    {id: pane, kind: window, wall: west, position: 2.0, width: 1.2, height: 1.2, sill: 0.9}]}
- {id: b, x: 3.25, z: 0.0, width: 3.0, depth: 4.0, wall_thickness: [0.4, 0.4], openings: [
    {id: ab, kind: door, wall: west, position: 1.5, connects_to: a, render_panel: false},
    {id: bc, kind: passage, wall: south, position: 1.0, width: 1.2, connects_to: c}]}
- {id: c, x: 0.0, z: 4.14, width: 8.25, depth: 4.0, outline: [[0, 0], [6.25, 0], [6.25, 1], [8.25, 1], [8.25, 4], [0, 4]],
   wall_thickness: [null, 0.4, 0.4, 0.4, 0.4, 0.2],
   openings: [{id: bc, kind: passage, edge: 0, position: 4.25, width: 1.2, connects_to: b}]}
"""

UNLISTED = """
wall_thickness: 0.1
levels: [{index: 1, elevation: 3.0, height: 2.5}]
rooms:
- {id: cellar, level: 0, x: 0.0, z: 0.0, width: 4.0, depth: 3.0, openings: [
    {id: hatch, kind: door, wall: north, position: 1.0, width: 0.8, height: 0.7, swing: in},
    {id: slot, kind: door, wall: south, position: 1.0, width: 0.1, height: 0.005},
    {id: flap, kind: garage_door, wall: east, position: 1.0, width: 0.2, height: 0.3},
    {id: slit, kind: window, wall: west, position: 2.0, width: 0.1, height: 0.06, sill: 1.0}]}
- {id: hall, level: 1, x: 0.0, z: 0.0, width: 4.0, depth: 3.0, openings: [{id: w, kind: window, wall: north, position: 2.0}], furniture: [
    {id: s, name: sofa, x: 2.0, z: 2.5, rotation: 180, width: 1.9, depth: 0.9, height: 0.85}]}
- {id: attic, level: 3, x: 0.0, z: 0.0, width: 4.0, depth: 3.0, furniture: [
    {id: a, name: armchair, x: 1.0, z: 1.0, width: 0.8, depth: 0.8, height: 0.85}]}
"""


@pytest.fixture(scope="module")
def homes() -> list[Scene]:
    made = [generate(Request(**wish)).scene for wish in REQUESTS]
    return [*made, *(with_kinds(load(text), load_catalogs()) for text in (UNLISTED, L_SHAPED, THICK_WALLS))]


@pytest.fixture(scope="module")
def built(homes: list[Scene], tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    """What the page builds of the homes."""
    given = tmp_path_factory.mktemp("page") / "homes.json"
    document = {"catalog": load_catalogs().model_dump(mode="json"), "scenes": [write_scene(scene) for scene in homes]}
    given.write_text(json.dumps(document))
    command = [sys.executable, str(ROOT / "scripts" / "page.py"), "test", "tests/described.test.ts"]
    run = subprocess.run(command, env={**os.environ, "COMPOSE_DESCRIBE": str(given)}, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    described: list[dict[str, Any]] = json.loads(Path(f"{given}.page").read_text())
    return described


@pytest.fixture(scope="module")
def models(homes: list[Scene]) -> list[HouseModel]:
    return [describe(scene, load_catalogs()) for scene in homes]


def test_walls_are_as_high_as_the_size_says_where_no_storey_is_listed(models: list[HouseModel]) -> None:
    assert {panel.height for panel in models[-1].panels} == {2.4}
    assert {panel.height for panel in models[-2].panels} == {2.5}


def test_storeys_that_are_not_listed_lie_on_those_beneath_them(models: list[HouseModel]) -> None:
    assert {(panel.level, panel.elevation, panel.height) for panel in models[-3].panels} == {(0, 0.0, 2.8), (1, 3.0, 2.5), (3, 5.5, 2.8)}
    assert {body.id: body.y for body in models[-3].bodies} == {"s": 3.0, "a": 5.5}


def close(ours: Iterable[float], theirs: Iterable[float]) -> bool:
    return all(abs(a - b) <= MM for a, b in zip(ours, theirs, strict=True))


def same_paint(ours: Paint, theirs: dict[str, Any]) -> bool:
    channels = [[int(color[i : i + 2], 16) for i in (1, 3, 5)] for color in (ours.color, theirs["color"])]
    shares = [(ours.roughness, "roughness"), (ours.metalness, "metalness"), (ours.opacity, "opacity"), (ours.glow, "glow")]
    return (
        all(abs(a - b) <= 1 for a, b in zip(*channels, strict=True))
        and all(abs(one - theirs[name]) < 1e-9 for one, name in shares)
        and ours.texture == theirs["texture"]
    )


def same_parts(parts: Sequence[BodyPart], paints: Sequence[Paint], theirs: Sequence[dict[str, Any]]) -> bool:
    return len(parts) == len(theirs) and all(
        part.form == other["form"]
        and part.axis == other["axis"]
        and math.isclose(part.taper, other["taper"], rel_tol=1e-9)
        and close(part.size, other["size"])
        and close(part.at, other["at"])
        and same_paint(paint, other["paint"])
        for part, paint, other in zip(parts, paints, theirs, strict=True)
    )


def ends(box: Cuboid) -> tuple[float, ...]:
    return (box.x0, box.x1, box.y0, box.y1, box.z0, box.z1)


def test_walls_agree(models: list[HouseModel], built: list[dict[str, Any]]) -> None:
    for model, page in zip(models, built, strict=True):
        assert len(model.panels) == len(page["panels"]) > 3
        for ours, theirs in zip(model.panels, page["panels"], strict=True):
            assert (ours.axis, ours.level) == (theirs["axis"], theirs["level"])
            across = (ours.line - ours.thickness / 2, ours.line + ours.thickness / 2)
            assert close((ours.start, ours.end, *across), (*theirs["along"].values(), *theirs["across"].values()))
            assert close((ours.elevation, ours.height), (theirs["elevation"], theirs["height"]))
            holes = [(h["along"]["from"], h["along"]["to"], h["up"]["from"], h["up"]["to"]) for h in theirs["holes"]]
            assert all(close(one[1:], other) for one, other in zip(ours.holes, holes, strict=True))
            assert close(ours.seams, theirs["seams"])


def test_clear_floors_agree(models: list[HouseModel], built: list[dict[str, Any]]) -> None:
    for model, page in zip(models, built, strict=True):
        assert len(model.rooms) == len(page["floors"]) > 0
        for plate, theirs in zip(model.rooms, page["floors"], strict=True):
            corners = clear_corners(plate, model.panels, model.thickness / 2)
            extents = [max(ends) - min(ends) for ends in zip(*corners, strict=True)]
            assert close((floor_area(corners), *extents), (theirs["area"], theirs["width"], theirs["depth"])), plate.id


def test_fittings_agree(models: list[HouseModel], built: list[dict[str, Any]]) -> None:
    for model, page in zip(models, built, strict=True):
        assert len(model.fittings) == len(page["fittings"]) > 5
        for ours, theirs in zip(model.fittings, page["fittings"], strict=True):
            assert ours.surface == theirs["surface"]
            assert close(ends(ours.box), [theirs["box"][key] for key in ("x0", "x1", "y0", "y1", "z0", "z1")])


def test_leaves_agree(models: list[HouseModel], built: list[dict[str, Any]]) -> None:
    looks, second = set(), 0
    for model, page in zip(models, built, strict=True):
        for ours, theirs in zip(model.leaves, page["leaves"], strict=True):
            looks.add(ours.look)
            second += ours.id != ours.opening
            assert (ours.id, ours.opening, ours.motion, ours.look) == (theirs["id"], theirs["opening"], theirs["motion"], theirs["look"])
            assert close((*ours.hinge, ours.width, ours.height), (*theirs["hinge"].values(), theirs["width"], theirs["height"]))
            assert math.isclose(math.cos(math.radians(ours.closed) - theirs["closedAngle"]), 1, abs_tol=1e-9)
            assert math.isclose(math.radians(ours.swing), theirs["turn"], abs_tol=1e-6)
            assert same_parts(ours.parts, ours.paints, theirs["parts"])
    assert {"inner", "entrance", "glazed", "gate"} <= looks
    assert second == 1


def test_bodies_agree(models: list[HouseModel], built: list[dict[str, Any]]) -> None:
    for model, page in zip(models, built, strict=True):
        assert [body.id for body in model.bodies] == [body["id"] for body in page["bodies"]]
        for ours, theirs in zip(model.bodies, page["bodies"], strict=True):
            assert close((ours.x, ours.y, ours.z), (theirs["x"], theirs["y"], theirs["z"]))
            assert close((ours.width, ours.depth, ours.height), (theirs["width"], theirs["depth"], theirs["height"]))
            assert math.isclose(math.radians(ours.turn), theirs["turn"], abs_tol=1e-9)
            drawn = theirs["parts"][: len(ours.parts)]  # the page marks the front of what it does not know
            assert ours.id == "q" or len(drawn) == len(theirs["parts"])
            assert ours.id == "q" or same_parts(ours.parts, ours.paints, drawn), ours.id


def test_openings_agree(models: list[HouseModel], built: list[dict[str, Any]]) -> None:
    for model, page in zip(models, built, strict=True):
        for ours, theirs in zip(model.openings, page["openings"], strict=True):
            assert (ours.id, ours.kind, ours.axis, ours.hinge, ours.towards, ours.is_main_entrance) == (
                theirs["id"], theirs["kind"], theirs["axis"], theirs["hinge"], theirs["opensTowards"], theirs["mainEntrance"],
            )  # fmt: skip
            assert close(
                (ours.line, ours.thickness, ours.start, ours.end, ours.sill, ours.head),
                [theirs[k] for k in ("line", "thickness", "from", "to", "sill", "head")],
            )


def test_wall_boxes_fill_the_panels_but_for_their_holes(models: list[HouseModel]) -> None:
    for model in models:
        for panel in model.panels:
            solid = (panel.end - panel.start) * panel.height
            for hole in panel.holes:
                across = min(hole.end, panel.end) - max(hole.start, panel.start)
                solid -= max(0.0, across) * (min(hole.high, panel.height) - hole.low)
            boxes = [wall.box for wall in model.walls if wall.axis == panel.axis and on(panel.line, wall.box, panel.axis)]
            within = [box for box in boxes if panel.start - MM <= along(box, panel.axis)[0] and along(box, panel.axis)[1] <= panel.end + MM]
            floor, top = panel.elevation - MM, panel.elevation + panel.height + MM
            within = [box for box in within if floor <= box.y0 and box.y1 <= top]
            assert math.isclose(sum(face(box, panel.axis) for box in within), solid, rel_tol=1e-6)


def on(line: float, box: Cuboid, axis: str) -> bool:
    return abs((box.z0 + box.z1 if axis == "x" else box.x0 + box.x1) / 2 - line) < MM


def along(box: Cuboid, axis: str) -> tuple[float, float]:
    return (box.x0, box.x1) if axis == "x" else (box.z0, box.z1)


def face(box: Cuboid, axis: str) -> float:
    low, high = along(box, axis)
    return (high - low) * (box.y1 - box.y0)
