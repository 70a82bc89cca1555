"""Styles: what they change and what they leave alone, and what a bad one is told."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import asdict
from functools import lru_cache
from pathlib import Path
from typing import Any

import pytest
import yaml

import catalogs
from catalogs import CatalogError, load_catalogs
from solver import Request, Scene, generate
from solver.errors import RequestError

KNOWN = load_catalogs()
SIX = ("modern", "rustic", "industrial", "scandi", "classic", "mid_century")
POSE = ("id", "x", "y", "z", "rotation", "width", "depth", "height", "wall", "under", "on")
styles = pytest.mark.parametrize("name", SIX)
CATALOG = (Path(catalogs.__file__).parents[1] / "docs" / "catalog.md").read_text(encoding="utf-8")


@lru_cache(maxsize=16)
def house(style: str | None, seed: int = 11) -> Scene:
    return generate(Request(seed=seed, width=12, depth=10, outdoor=True, style=style)).scene


def palette(style: Any, name: str, size: tuple[float, float, float]) -> set[str]:
    """Every colour a piece may have, from the catalogs: by kind, name, category, else its own."""
    found: set[str] = set()
    for kind, entry in KNOWN.furniture.items():
        if (entry.name or kind) == name and entry.size == size:
            keys = [key for key in (kind, name, entry.category) if key in style.palette]
            found |= set(style.palette[keys[0]] if keys else ()) or {entry.color, *entry.variants}
    return found


def test_there_are_the_six() -> None:
    assert tuple(KNOWN.styles) == SIX


@styles
def test_furniture_stands_the_same_in_every_style(name: str) -> None:
    def poses(scene: Scene) -> list[tuple[Any, ...]]:
        return [tuple(asdict(piece)[key] for key in POSE) for room in scene.rooms for piece in room.furniture]

    assert len(poses(house(name))) > 40
    assert poses(house(name)) == poses(house(None))
    assert [room.openings for room in house(name).rooms] == [room.openings for room in house(None).rooms]


@styles
def test_colours_floors_and_walls_are_the_styles(name: str) -> None:
    style = KNOWN.styles[name]
    for room in house(name).rooms:
        for piece in room.furniture:
            assert piece.color in palette(style, piece.name, (piece.width, piece.depth, piece.height)), piece.id
        flooring = KNOWN.rooms[room.type].flooring
        floors = {(floor.type or flooring, floor.color) for floor in style.floors.get(flooring, ())}
        walls = {(wall.type, wall.color) for wall in style.walls.get(flooring, ())}
        assert room.flooring is not None
        if room.outdoor:
            assert room.walls is None
            assert (room.flooring.type, room.flooring.color) == (flooring, KNOWN.floorings[flooring].color)
        else:
            assert room.walls is not None and (room.walls.type, room.walls.color) in walls
            assert (room.flooring.type, room.flooring.color) in floors or not floors


def test_one_house_has_one_floor_of_a_kind_and_styles_differ() -> None:
    looks = set()
    for name in SIX:
        floors = {
            (KNOWN.rooms[room.type].flooring, room.flooring.color) for room in house(name).rooms if room.flooring and not room.outdoor
        }
        assert len(floors) == len({flooring for flooring, _ in floors})
        looks.add((frozenset(floors), tuple(piece.color for room in house(name).rooms for piece in room.furniture)))
    assert len(looks) == len(SIX)


def test_pieces_with_one_palette_match_in_a_room() -> None:
    style = KNOWN.styles["scandi"]
    matched = 0
    for room in house("scandi").rooms:
        wooden = {piece.color for piece in room.furniture if {piece.name, piece.category} & {"storage"} and piece.name not in style.palette}
        assert len(wooden) <= 1
        matched += sum(piece.category == "storage" for piece in room.furniture) > 1
    assert matched


def test_a_seed_draws_a_style_and_the_request_makes_it_again() -> None:
    drawn = Counter(str((generate(Request(seed=seed, width=5, depth=4)).scene.request or {})["style"]) for seed in range(60))
    assert set(drawn) == set(SIX)
    scene = house(None)
    style = (scene.request or {})["style"]
    assert house(style) == scene


def test_an_unknown_style_is_refused_with_the_known_ones() -> None:
    with pytest.raises(RequestError, match="unknown style 'baroque'") as told:
        generate(Request(seed=1, style="baroque"))
    assert (told.value.field, told.value.allowed) == ("style", ", ".join(SIX))


def test_a_new_style_is_one_entry(tmp_path: Path) -> None:
    """The one of docs/catalog.md."""
    section = CATALOG.split("\n## Styles")[1].split("\n## ")[0]
    (written,) = re.findall(r"```yaml styles\n(.*?)```", section, re.DOTALL)
    (tmp_path / "styles.yaml").write_text(written, encoding="utf-8")
    known = load_catalogs(tmp_path)
    assert tuple(known.styles) == (*SIX, "coastal")
    scene = generate(Request(seed=11, width=12, depth=10, style="coastal"), catalogs=known).scene
    spec = yaml.load(written, yaml.CSafeLoader)["coastal"]
    seats = {piece.color for room in scene.rooms for piece in room.furniture if piece.category == "seating"}
    assert seats and seats <= set(spec["palette"]["seating"])
    walls = {room.walls.color for room in scene.rooms if room.walls}
    assert walls and walls <= {wall["color"] for wall in spec["walls"]["wood"]}
    assert {room.flooring.type for room in scene.rooms if room.type == "bathroom" and room.flooring} == {"stone"}


@pytest.mark.parametrize(
    ("written", "key", "line", "words"),
    [
        ('x:\n  palette:\n    sofaa: ["#aabbcc"]', "x.palette.sofaa", 3, "unknown kind or category 'sofaa'"),
        ('x:\n  palette:\n    sofa: ["red"]', "x.palette.sofa.0", 3, "#rrggbb"),
        (
            'x:\n  palette: {}\n  floors:\n    wood:\n      - {type: lava, color: "#aabbcc"}',
            "x.floors.wood.0.type",
            5,
            "unknown flooring 'lava'",
        ),
        ('x:\n  palette: {}\n  walls:\n    sand: [{type: brick, color: "#aabbcc"}]', "x.walls.sand", 4, "unknown flooring 'sand'"),
        ('x:\n  palette: {}\n  walls:\n    wood: [{type: gold, color: "#aabbcc"}]', "x.walls.wood.0.type", 4, "plaster"),
        ("x:\n  palette: {}\n  decorations:\n    avoided: [gnome]", "x.decorations.avoided", 4, "unknown decoration or group 'gnome'"),
        ("x:\n  palette: {}\n  shine: true", "x.shine", 3, "is not known"),
    ],
)
def test_a_bad_style_is_named_with_file_key_and_line(tmp_path: Path, written: str, key: str, line: int, words: str) -> None:
    (tmp_path / "styles.yaml").write_text(written, encoding="utf-8")
    with pytest.raises(CatalogError) as told:
        load_catalogs(tmp_path)
    assert (Path(told.value.file).name, told.value.key, told.value.line) == ("styles.yaml", key, line)
    assert words in str(told.value)


def test_what_a_style_avoids_does_not_come() -> None:
    counts: dict[str, Counter[str]] = {}
    for name in ("modern", "classic"):
        scenes = [generate(Request(seed=seed, width=12, depth=9, decorate=True, style=name)).scene for seed in range(6)]
        counts[name] = Counter(thing.name for scene in scenes for room in scene.rooms for thing in room.decorations)
        assert not set(counts[name]) & set(KNOWN.styles[name].decorations.avoided)
    assert sum(counts["modern"].values()) > 200
