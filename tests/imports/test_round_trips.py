"""What our own exports draw reads back: rooms, openings and walls to 1 cm, types and names as they were."""

from __future__ import annotations

from functools import cache

import pytest

from solver import Request, export, generate
from solver.imported import PlanImport
from solver.scene import Room, Scene
from tests.imports.plans import read

PROGRAMMES = ("studio", "family")
CLOSE = 0.0101
"""m."""


@cache
def home(program: str) -> Scene:
    return generate(Request(seed=5, program=program)).scene


@cache
def again(program: str, format: str) -> PlanImport:
    (name, content), *_ = export(home(program), format).items()
    return read(content, name)


def box_of(room: Room) -> tuple[float, ...]:
    return room.x, room.z, room.width, room.depth


def openings_of(scene: Scene, swings: bool) -> set[tuple[object, ...]]:
    """Every entry of an opening, the house's own id left out: kind, room, wall, place, width, height, sill, other room, entrance."""
    return {
        (one.kind, room.type, one.wall, round(one.position, 2), round(one.width, 2), round(one.height, 2), round(one.sill, 2))
        + ((one.hinge, one.swing) if swings and one.kind == "door" else ())
        for room in scene.rooms
        for one in room.openings
    }


@pytest.mark.parametrize("program", PROGRAMMES)
@pytest.mark.parametrize("format", ["procthor", "sh3d", "ifc", "svg"])
def test_a_house_reads_back(program: str, format: str) -> None:
    before, answer = home(program), again(program, format)
    after = answer.scene
    assert answer.format == format
    origin = min(room.x for room in before.rooms), min(room.z for room in before.rooms)
    for one, other in zip(before.rooms, after.rooms, strict=True):
        assert (one.id, one.type, one.outdoor) == (other.id, other.type, other.outdoor)
        moved = (one.x - origin[0], one.z - origin[1], one.width, one.depth)
        assert max(abs(a - b) for a, b in zip(moved, box_of(other), strict=True)) <= CLOSE
        assert (one.outline is None) == (other.outline is None)
    assert openings_of(after, format == "procthor") == openings_of(before, format == "procthor")
    assert abs(after.wall_thickness - before.wall_thickness) <= CLOSE
    assert set(before.adjacency) <= set(after.adjacency)
    entrances = [[one.id for room in scene.rooms for one in room.openings if one.main_entrance] for scene in (before, after)]
    assert entrances[0] == entrances[1]
    changed = [change["of"] for change in answer.changes if change["step"] in ("straighten", "wall_lines", "join")]
    assert changed == (["plan"] if format == "ifc" else [])  # its spaces are drawn by their inner faces


@pytest.mark.parametrize("program", PROGRAMMES)
@pytest.mark.parametrize("format", ["procthor", "sh3d", "ifc", "svg"])
def test_its_furniture_reads_back(program: str, format: str) -> None:
    before, after = (
        {piece.id: piece for room in scene.rooms for piece in room.furniture} for scene in (home(program), again(program, format).scene)
    )
    assert before.keys() == after.keys()
    for name, piece in before.items():
        other = after[name]
        assert "_".join(other.name.lower().split()) == piece.name
        assert max(abs(a - b) for a, b in zip((piece.x, piece.y, piece.z), (other.x, other.y, other.z), strict=True)) <= CLOSE, name
        assert abs((piece.rotation - other.rotation + 180) % 360 - 180) < 1.0


@pytest.mark.parametrize("program", PROGRAMMES)
def test_a_drawing_reads_back_as_far_as_it_says(program: str) -> None:
    """A plan in DXF tells no heights, ids or entrances; its doors are arcs, as wide as the gaps in its walls."""
    before, answer = home(program), again(program, "dxf")

    def seen(scene: Scene, swings: bool) -> set[tuple[object, ...]]:
        return {
            (one.kind, room.type, one.wall, round(one.position, 2), round(one.width, 2), *((one.hinge, one.swing) if swings else ()))
            for room in scene.rooms
            for one in room.openings
            if one.kind == "door" or not swings
        }

    assert answer.format == "dxf"
    assert sorted((room.type, room.width, room.depth) for room in answer.scene.rooms) == sorted(
        (room.type, room.width, room.depth) for room in before.rooms
    )
    assert seen(answer.scene, False) == seen(before, False)
    assert seen(answer.scene, True) == seen(before, True)
    assert {str(left["place"]) for left in answer.unread} <= {f"layer '{name}'" for name in ("DIMENSIONS", "FURNITURE", "PEOPLE", "WALLS")}
