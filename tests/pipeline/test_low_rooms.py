"""Rooms under low ceilings: nothing that furnishes or decorates them is higher than they are, and what is missing for that is told."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import pytest

from catalogs import load_catalogs
from compose_homes import Request, generate, validate
from solver.pipeline.own_plan import furnish
from solver.scene import Level, Scene, Size

KNOWN = load_catalogs()
HEIGHTS = {name: kind.size[2] for name, kind in KNOWN.furniture.items()}
HIGH = re.compile(r"the lowest, (\w+), is ([0-9.]+) m high, and the room ([0-9.]+) m")
SEEDS = (3, 8)


def bare(seed: int, height: float, by_level: bool) -> Scene:
    """A home of three bedrooms, empty, its openings no higher than it is."""
    home = generate(Request(program={"bedrooms": 3, "bathrooms": 1, "garage": 1}, seed=seed)).scene
    assert home.size is not None
    rooms = tuple(
        replace(
            room,
            furniture=(),
            decorations=(),
            openings=tuple(replace(one, height=min(one.height, height - one.sill)) for one in room.openings),
        )
        for room in home.rooms
    )
    size = home.size if by_level else replace(home.size, height=height)
    levels = (Level(0, 0.0, height),) if by_level else ()
    return replace(home, rooms=rooms, size=Size(size.width, size.depth, size.height), levels=levels, dynamic=(), certificate=None)


@pytest.mark.parametrize("by_level", [False, True])
@pytest.mark.parametrize("height", [1.6, 1.9])
@pytest.mark.parametrize("seed", SEEDS)
def test_nothing_is_higher_than_its_room(seed: int, height: float, by_level: bool) -> None:
    done = furnish(bare(seed, height, by_level), seed=seed, decorate=True, catalogs=KNOWN).scene
    indoors = [room for room in done.rooms if not room.outdoor]
    tops = {piece.id: piece.y + piece.height for room in indoors for piece in room.furniture}
    tops |= {thing.id: thing.y + thing.height for room in indoors for thing in room.decorations}
    assert len(tops) > 50
    assert {name: top for name, top in tops.items() if top > height + 1e-9} == {}
    assert not [issue for issue in validate(done) if issue.severity == "error"]


def test_what_no_variant_fits_of_is_told_with_its_height() -> None:
    done = furnish(bare(3, 1.9, False), seed=3, catalogs=KNOWN).scene
    assert done.certificate is not None
    said = [one for room in dict[str, Any](done.certificate)["rooms"].values() for one in room["left_out"] if HIGH.fullmatch(one["reason"])]
    assert {one["piece"] for one in said} >= {"wardrobe_1"}
    for one in said:
        found = HIGH.fullmatch(one["reason"])
        assert found is not None
        kind, high, room = found.groups()
        assert HEIGHTS[kind] == float(high) > float(room) == 1.9


def test_a_room_of_the_usual_height_is_furnished_as_ever() -> None:
    empty = bare(3, 2.8, False)
    assert furnish(empty, seed=3, catalogs=KNOWN).scene.rooms == furnish(replace(empty, size=None), seed=3, catalogs=KNOWN).scene.rooms
