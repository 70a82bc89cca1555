"""Every length and area on a plan is the scene's own, to the millimetre, for fresh homes of all outlines; read from the SVG alone."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple
from xml.etree import ElementTree

import pytest

from catalogs import load_catalogs
from service.calls import view_scene
from solver import Request, Scene, export, generate
from solver.exchange import write_scene
from solver.pipeline.import_plan import import_plan
from solver.scene import Room
from tests.architecture.tree import ROOT
from tests.sweeps import seeds

SVG = "{http://www.w3.org/2000/svg}"
CHAIN = re.compile(r"M(-?\d+) (-?\d+)([HV])(-?\d+)((?:M-?\d+ -?\d+[vh]\d+)+)")
MARK = re.compile(r"M(-?\d+) (-?\d+)([vh])(\d+)")
PLACE = re.compile(r"translate\((-?\d+) (-?\d+)\)rotate\(-90\)")
WRITTEN = re.compile(r"(\d+)\.(\d\d)([¹²³⁴-⁹]?)")
RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹"
ROUNDED = 1
"""What is written in whole millimetres may be off by, mm."""
HOMES: list[dict[str, object]] = [
    {"program": "family", "outline": "L", "outdoor": True},
    {"program": "large", "outline": "U"},
    {"program": "one_bed", "outline": "T"},
    {"program": "studio", "wall_thickness": 0.14},
    {"area": 95.0},
    {"width": 17.0, "depth": 9.0},
    {"program": "family", "outline": ((0, 0), (14, 0), (14, 7), (9, 7), (9, 12), (0, 12))},
]


class Chain(NamedTuple):
    """A chain of dimensions: whether it runs from west to east, where it lies across, and its marks along, mm."""

    along_x: bool
    at: int
    marks: tuple[int, ...]


def chains(root: ElementTree.Element) -> list[Chain]:
    drawn = "".join(path.get("d", "") for path in root.iter(f"{SVG}path") if path.get("class") == "line")
    found = []
    for x, y, way, end, ticks in (one.groups() for one in CHAIN.finditer(drawn)):
        at = int(y) if way == "H" else int(x)
        ends = [(int(a), int(b)) for a, b, _, _ in MARK.findall(ticks)]
        marks = tuple(a if way == "H" else b for a, b in ends)
        assert (marks[0], marks[-1]) == (int(x if way == "H" else y), int(end))
        found.append(Chain(way == "H", at, marks))
    assert "".join(one.group(0) for one in CHAIN.finditer(drawn)) == drawn
    return found


def numbers(root: ElementTree.Element) -> Iterator[tuple[bool, int, int, str]]:
    """Every length that is written: whether along x, its middle along and its place across, mm, and the words."""
    for text in root.iter(f"{SVG}text"):
        words = text.text or ""
        if text.get("class") == "number" and WRITTEN.fullmatch(words):
            turned = PLACE.fullmatch(text.get("transform", ""))
            x, y = (int(turned[1]), int(turned[2])) if turned else (int(text.get("x", "")), int(text.get("y", "")))
            yield (False, y, x, words) if turned else (True, x, y, words)


def millimetres(words: str) -> int:
    """A length as it is written: metres, raised the millimetres beside whole centimetres."""
    found = WRITTEN.fullmatch(words)
    assert found
    return int(found[1]) * 1000 + int(found[2]) * 10 + (RAISED.index(found[3]) if found[3] else 0)


def corners_of(room: Room) -> list[tuple[float, float]]:
    inner = room.outline or ((0.0, 0.0), (room.width, 0.0), (room.width, room.depth), (0.0, room.depth))
    return [(room.x + x, room.z + z) for x, z in inner]


def lines_of(scene: Scene, axis: int) -> set[int]:
    """Where wall lines and the ends of openings are along an axis, 0 from west to east, mm."""
    found = {round(corner[axis] * 1000) for room in scene.rooms for corner in corners_of(room)}
    for room in scene.rooms:
        for one in room.openings:
            corners = corners_of(room)
            edges = list(zip(corners, (*corners[1:], corners[0]), strict=True))
            sides = {"north": 0, "east": 1, "south": 2, "west": 3}
            a, b = edges[one.edge] if one.edge is not None else edges[sides[str(one.wall)]]
            low = min(a[axis], b[axis])
            if a[1 - axis] == b[1 - axis]:
                found |= {round((low + one.position + side * one.width / 2) * 1000) for side in (-1, 1)}
    return found


def is_near(value: int, among: set[int]) -> bool:
    return any(abs(value - one) <= ROUNDED for one in among)


def clear_corners(room: Room, half: int) -> list[tuple[int, int]]:
    """The corners of the floor within an outline of walls along x and z that go clockwise, `half` mm of each inside; mm."""
    corners = [(round(x * 1000), round(z * 1000)) for x, z in corners_of(room)]
    edges = list(zip(corners, (*corners[1:], corners[0]), strict=True))
    moved = []
    for before, after in zip((edges[-1], *edges[:-1]), edges, strict=True):
        (a, z), (b, _) = next(edge for edge in (before, after) if edge[0][1] == edge[1][1])  # from west to east, its room is south of it
        (x, c), (_, d) = next(edge for edge in (before, after) if edge[0][0] == edge[1][0])  # from north to south, its room is west of it
        moved.append((x - half if d > c else x + half, z + half if b > a else z - half))
    return moved


def clear_area(room: Room, half: int) -> str:
    """The clear floor of a room in words; half a tenth is more."""
    moved = clear_corners(room, half)
    twice = sum(x * d - c * z for (x, z), (c, d) in zip(moved, (*moved[1:], moved[0]), strict=True))
    tenths = (twice + 100_000) // 200_000
    return f"{tenths // 10}.{tenths % 10} m²"


def clear_size(room: Room, half: int) -> tuple[int, int]:
    """How far one can go in a room straight from west to east at most, and from north to south, mm: over the cells between its corners."""
    moved = clear_corners(room, half)
    xs, zs = (sorted({corner[axis] for corner in moved}) for axis in (0, 1))
    edges = list(zip(moved, (*moved[1:], moved[0]), strict=True))

    def is_floor(x: float, z: float) -> bool:
        return sum(a[0] == b[0] > x and min(a[1], b[1]) < z < max(a[1], b[1]) for a, b in edges) % 2 == 1

    floor = {(i, j) for i, x in enumerate(pairwise(xs)) for j, z in enumerate(pairwise(zs)) if is_floor(sum(x) / 2, sum(z) / 2)}
    runs: dict[int, list[int]] = {0: [], 1: []}
    for axis, (along, across) in enumerate(((xs, zs), (zs, xs))):
        for row in range(len(across) - 1):
            run = 0
            for column in range(len(along) - 1):
                here = (column, row) if axis == 0 else (row, column)
                run = run + along[column + 1] - along[column] if here in floor else 0
                runs[axis].append(run)
    return max(runs[0]), max(runs[1])


@pytest.mark.parametrize("seed", seeds(range(91000, 91012), 6))
@pytest.mark.parametrize("asked", HOMES, ids=str)
def test_lengths_and_areas_are_the_scenes(asked: dict[str, object], seed: int) -> None:
    check(generate(Request(seed=seed, decorate=True, **asked)).scene)  # type: ignore[arg-type]


@pytest.mark.parametrize("format", ["svg", "dxf", "sh3d", "ifc"])
def test_those_of_a_plan_that_was_read_are_its_own(format: str) -> None:
    made = generate(Request(seed=91020, program="family", outline="L", wall_thickness=0.13)).scene
    ((name, content),) = export(made, format).items()
    check(import_plan(content, name).scene)


def test_those_of_a_drawn_plan_are_its_own() -> None:
    check(import_plan((ROOT / "docs" / "plan.geojson").read_bytes(), "plan.geojson").scene)


def check(scene: Scene) -> None:
    ((_, content),) = export(scene, "svg").items()
    root = ElementTree.fromstring(content)
    drawn, written = chains(root), list(numbers(root))
    half = round(scene.wall_thickness * 500)
    for chain in drawn:
        lines = lines_of(scene, 0 if chain.along_x else 1)
        faces = {line + side * half for line in lines for side in (-1, 0, 1)}
        assert [mark for mark in chain.marks if not is_near(mark, faces)] == []
    for along_x, middle, across, words in written:
        said = [
            b - a
            for chain in drawn
            if chain.along_x == along_x and 0 <= chain.at - across < 400
            for a, b in pairwise(chain.marks)
            if a <= middle <= b
        ]
        assert any(abs(millimetres(words) - one) <= ROUNDED for one in said), (words, said)
    for axis, along_x in ((0, True), (1, False)):
        lines = {round(corner[axis] * 1000) for room in scene.rooms for corner in corners_of(room)}
        assert max(lines) - min(lines) + 2 * half in {millimetres(words) for one, *_, words in written if one == along_x}
    texts = [text.text or "" for text in root.iter(f"{SVG}text")]
    sizes = [text.text or "" for text in root.iter(f"{SVG}text") if text.get("class") == "size"]
    said_sizes = [tuple(map(millimetres, words.split(" × "))) for words in sizes]
    own = [clear_size(room, half) for room in scene.rooms]
    assert [size for size in said_sizes if not any(is_near(size[0], {a}) and is_near(size[1], {b}) for a, b in own)] == []
    assert len(sizes) >= 0.75 * len(scene.rooms)
    areas = sorted(words for words in texts if words.endswith(" m²"))
    told = sorted(re.findall(r"# (\d+\.\d m²) clear", str(view_scene({"scene": write_scene(scene)}, load_catalogs())["text"])))
    assert areas == told
    indoors = sorted(clear_area(room, half) for room in scene.rooms if not room.outdoor)
    assert len(indoors) >= 2 and [one for one in indoors if one not in areas] == []
