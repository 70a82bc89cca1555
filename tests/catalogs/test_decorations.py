"""What our own decorations are: the whole list, sizes and masses of such things, colours to choose from, a place for each."""

from __future__ import annotations

from pathlib import Path

import pytest

from catalogs import load_catalogs
from catalogs.decoration_types import INDOOR
from catalogs.faults import CatalogError
from tests.every import every

KNOWN = load_catalogs()
LIST = [
    "pillow",
    "throw_pillow",
    "blanket",
    "throw_blanket",
    "table_lamp",
    "desk_lamp",
    "picture_frame",
    "wall_frame",
    "wall_art",
    "wall_clock",
    "wall_mirror",
    "book",
    "book_stack",
    "notebook",
    "magazine",
    "pen",
    "laptop",
    "monitor",
    "keyboard",
    "pen_cup",
    "organizer",
    "tray",
    "basket",
    "mug",
    "glass",
    "wine_glass",
    "figurine",
    "vase",
    "small_vase",
    "candle",
    "candle_holder",
    "plant_small",
    "succulent",
    "coaster",
    "plate",
    "bowl",
    "silverware",
    "placemat",
    "table_runner",
    "centerpiece",
    "cutting_board",
    "knife_block",
    "fruit_bowl",
    "coffee_maker",
    "toaster",
    "spice_rack",
    "jar",
    "utensil_holder",
    "jewelry_box",
    "perfume_bottle",
    "soap_dispenser",
    "folded_towel",
    "toiletry_kit",
    "key_tray",
    "shoe_pair",
    "umbrella_stand",
    "toy_blocks",
    "stuffed_animal",
    "toy_car",
    "rug",
    "floor_rug_small",
    "alarm_clock",
    "wall_shelf",
]
"""What homes have had from the first catalog on."""
ASKEW = ("book", "magazine", "mug", "figurine", "candle", "picture_frame", "plant_small", "toy_blocks", "toy_car", "stuffed_animal")
kinds = every("name", sorted(KNOWN.decorations))


@every("name", LIST)
def test_the_whole_list_is_there(name: str) -> None:
    assert name in KNOWN.decorations


@kinds
def test_sizes_masses_and_colours_are_those_of_such_things(name: str) -> None:
    kind = KNOWN.decorations[name]
    width, depth, height = kind.size
    flat = kind.group == "floor"
    assert min(kind.size) >= 0.01 and max(width, depth) <= (3 if flat else 1.4) and height <= (0.02 if flat else 1.3)
    assert 2 < kind.mass / (width * depth * height) < 8000
    assert 3 <= len(kind.variants) <= 6 and len({kind.color, *kind.variants}) == len(kind.variants) + 1


@kinds
def test_every_kind_has_a_place_somewhere(name: str) -> None:
    rows = [row for entry in KNOWN.decorating.values() for row in (*entry.lies, *entry.hangs, *entry.stands, *entry.holds)]
    assert any(name in row.put for row in rows)


@every("name", ASKEW)
def test_what_lies_askew(name: str) -> None:
    assert KNOWN.decorations[name].jitter


@pytest.mark.parametrize("name", ["kitchen", "wall_shelf"])
def test_a_kind_called_as_a_room_or_a_decoration_is_reported_where_it_is_written(tmp_path: Path, name: str) -> None:
    file = tmp_path / "furniture.yaml"
    file.write_text(f"{name}:\n  {{category: storage, size: [1.2, 0.6, 0.9], color: '#c8c8c8', mass: 40, stands: wall}}\n")
    with pytest.raises(CatalogError, match="is a name of several things") as raised:
        load_catalogs(tmp_path)
    assert str(file) in str(raised.value)


def test_names_are_not_those_of_furniture() -> None:
    """Ids are made of names, so one name means one sort of thing."""
    names = {KNOWN.name_of(kind) for kind in KNOWN.furniture}
    assert names.isdisjoint(KNOWN.decorations)
    assert names.isdisjoint(KNOWN.rooms)
    assert INDOOR not in {*names, *KNOWN.decorations, *KNOWN.rooms}


@every("name", sorted(kind for kind, entry in KNOWN.furniture.items() if entry.surfaces and not entry.name and entry.category != "seating"))
def test_what_has_a_surface_is_decorated(name: str) -> None:
    assert name in KNOWN.decorating
