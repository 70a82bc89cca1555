"""What our own catalogs hold: sizes on the lattice, floors that can take the furniture, what rooms require."""

from __future__ import annotations

import json
from collections import Counter
from fractions import Fraction
from pathlib import Path
from typing import get_args

import catalogs
from catalogs import load_catalogs
from catalogs.entries import Category
from tests.every import every

KNOWN = load_catalogs()
BEDS = [{"bed": 1, "single_bed": 1}]
REQUIRED = {
    "bedroom": BEDS, "bedroom_master": BEDS, "kids_bedroom": BEDS,
    "kitchen": [{"counter": 1}, {"sink": 1}, {"stove": 1}, {"refrigerator": 1}],
    "bathroom": [{"toilet": 1}, {"sink": 1, "vanity": 1}],
    "living_room": [{"sofa": 1}], "dining_room": [{"dining_table": 1}, {"dining_chair": 2}],
    "office": [{"desk": 1}, {"office_chair": 1}], "laundry": [{"washer": 1}],
    "garage": [{"workbench": 1, "car": 1}], "garage_2car": [{"workbench": 1, "car": 2}],
    "garage_3car": [{"workbench": 1, "car": 3}],
    "foyer": [], "hallway": [], "workshop": [], "patio": [], "outdoor_deck": [], "backyard": [], "balcony": [],
}  # fmt: skip
"""What each room type requires, as docs/scene.md says."""
FLOORS = {
    "bedroom": "wood", "bedroom_master": "wood", "living_room": "wood", "dining_room": "wood", "office": "wood", "hallway": "wood",
    "kids_bedroom": "wood", "kitchen": "tile", "bathroom": "tile", "laundry": "tile", "balcony": "tile", "garage": "concrete",
    "garage_2car": "concrete", "garage_3car": "concrete", "workshop": "concrete", "patio": "stone", "outdoor_deck": "deck",
    "backyard": "grass", "foyer": "stone",
}  # fmt: skip
OUTDOORS = {"patio", "outdoor_deck", "backyard", "balcony"}
rooms = every("name", sorted(KNOWN.rooms))
kinds = every("kind", sorted(KNOWN.furniture))


def test_the_room_types_and_what_they_require() -> None:
    assert {name: [dict(line) for line in room.requires] for name, room in KNOWN.rooms.items()} == REQUIRED


def test_floors_and_outdoors() -> None:
    assert {name: room.flooring for name, room in KNOWN.rooms.items()} == FLOORS
    assert {name for name, room in KNOWN.rooms.items() if room.outdoor} == OUTDOORS


ASKED_BY_NONE = {
    "child": "people are drawn at random; children are put into scenes by hand",
    "garden_box": "gardens have planters and flower beds; for lists of one's own",
    "speaker": "a pair belongs to a music room: for catalogs of one's own",
    "treadmill": "no room type of ours is for sport; for lists of one's own",
}
"""Kinds that neither a room type nor the people at home ask for, and why they are there."""


def test_every_kind_is_asked_for_by_something() -> None:
    asked = {variant.kind for room in KNOWN.rooms.values() for piece in room.pieces for variant in piece.variants}
    asked |= {kind for entry in KNOWN.people.values() for kind in entry.kinds}
    assert set(KNOWN.furniture) - asked == set(ASKED_BY_NONE)


def test_every_category_has_furniture() -> None:
    assert {entry.category for entry in KNOWN.furniture.values()} == set(get_args(Category))


@kinds
def test_sizes_lie_on_the_lattice_and_are_those_of_furniture(kind: str) -> None:
    entry = KNOWN.furniture[kind]
    for length in entry.size:
        assert Fraction(str(length)) * 100 % 1 == 0
    width, depth, height = entry.size
    assert 0.1 <= width <= 12 and 0.1 <= depth <= 5 and 0.2 <= height <= 3
    if entry.category not in ("vehicle", "water", "dynamic", "structure"):
        assert 5 < entry.mass / (width * depth * height) < 1100
    assert len(entry.variants) >= 1


@kinds
def test_surfaces_lie_within_their_piece(kind: str) -> None:
    entry = KNOWN.furniture[kind]
    heights = [surface.height for surface in entry.surfaces]
    assert heights == sorted(heights) and all(height <= entry.size[2] for height in heights)
    for surface, above in zip(entry.surfaces, heights[1:], strict=False):
        assert surface.clearance is not None and surface.height + surface.clearance <= above


def test_surfaces_are_where_things_are_put() -> None:
    surfaces = {kind: [surface.height for surface in entry.surfaces] for kind, entry in KNOWN.furniture.items()}
    assert surfaces["bed"][0] < KNOWN.furniture["bed"].size[2] - 0.3
    assert surfaces["sofa"][0] < KNOWN.furniture["sofa"].size[2] - 0.3
    assert len(surfaces["bookshelf"]) == 4


@rooms
def test_variants_go_from_wanted_down_to_least(name: str) -> None:
    for piece in KNOWN.rooms[name].pieces:
        for corner in (None, "left", "right"):
            variants = [one for one in piece.variants if one.corner == corner]
            areas = [KNOWN.furniture[one.kind].size[0] * KNOWN.furniture[one.kind].size[1] for one in variants]
            assert [one.cost for one in variants] == sorted(one.cost for one in variants), piece.piece
            assert areas == sorted(areas, reverse=True), piece.piece


def test_no_bathroom_wants_two_tubs_or_two_showers() -> None:
    for area in (quarter / 4 for quarter in range(4, 80)):
        wanted = Counter[str]()
        for piece in KNOWN.rooms["bathroom"].pieces:
            fits = [one for one in piece.variants if one.min_area <= area and (one.max_area is None or area < one.max_area)]
            if area >= piece.min_area:
                wanted.update({KNOWN.name_of(one.kind) for one in fits})
        assert wanted["bathtub"] <= 1 and wanted["shower"] == 1, area


@rooms
def test_the_smallest_room_has_floor_for_what_it_requires(name: str) -> None:
    """Twice the least footprints, and a door's square, must fit the clear floor of the minimum area."""
    room = KNOWN.rooms[name]
    required = [(piece.count, [one for one in piece.variants if not one.corner][-1].kind) for piece in room.pieces if piece.required]
    least = sum(count * KNOWN.furniture[kind].size[0] * KNOWN.furniture[kind].size[1] for count, kind in required)
    side = room.area.min[0] ** 0.5
    clear = (side - 0.1) ** 2
    assert least <= clear - 0.81
    if "car" not in {kind for line in room.requires for kind in line}:
        assert 2 * least <= clear


@rooms
def test_required_pieces_bear_the_names_that_are_required(name: str) -> None:
    room = KNOWN.rooms[name]
    supply: dict[str, int] = {}
    for piece in room.pieces:
        if piece.required:
            for kind in {KNOWN.name_of(variant.kind) for variant in piece.variants}:
                supply[kind] = supply.get(kind, 0) + piece.count
    for line in room.requires:
        assert any(supply.get(kind, 0) >= count for kind, count in line.items())


def test_every_name_is_said_in_german_too() -> None:
    table = json.loads((Path(catalogs.__file__).parents[1] / "web" / "src" / "words" / "names.de.json").read_text("utf-8"))
    shown = {kind.name or name for name, kind in KNOWN.furniture.items()} | set(KNOWN.decorations)
    walls = {finish.type for style in KNOWN.styles.values() for finishes in style.walls.values() for finish in finishes}
    wanted = {piece.piece for room in KNOWN.rooms.values() for piece in room.pieces}
    assert (shown | wanted | walls | set(KNOWN.rooms) | {kind.category for kind in KNOWN.furniture.values()}) - set(table) == set()
