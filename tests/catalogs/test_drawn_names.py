"""What layers and titles of drawings are called is data: words that a catalog of one's own may replace."""

from __future__ import annotations

from pathlib import Path

import pytest

from catalogs import load_catalogs
from catalogs.faults import CatalogError
from catalogs.synonyms import drawn_names_of

KNOWN = load_catalogs()
NAMES = drawn_names_of(KNOWN)


@pytest.mark.parametrize(
    ("layer", "sort"),
    [
        ("A-WALL-FULL", "wall"), ("10_WAND_TRAGEND", "wall"), ("ŚCIANY", "wall"), ("A-WIND", "window"), ("Rewind", None),
        ("31_kozijnen", "window"), ("Türen", "door"), ("A-DOOR-WINDOW", "opening"),
        ("Outdoor", None), ("A-ROOM-IDEN", "label"), ("Möbel Wand", None), ("0", None),
    ],
)  # fmt: skip
def test_a_layer_holds_what_a_word_in_its_name_says(layer: str, sort: str | None) -> None:
    assert NAMES.sort_within((layer,)) == sort


def test_the_nearest_name_counts_that_tells_anything() -> None:
    assert NAMES.sort_within(("WALLS", "DOORS", "x")) == "door"
    assert NAMES.sort_within(("WALLS", "FURNITURE")) is None


@pytest.mark.parametrize(
    ("title", "rank"),
    [
        ("Keller", -1), ("GROUND FLOOR PLAN", 0), ("Grundriss EG", 0), ("Rez-de-chaussée", 0), ("1. OG", 1), ("2. OG", 2), ("OG_Wand", 1),
        ("Second floor", 2), ("DG", 10), ("Wand", None), ("Allegro", None), ("3. OG", 3), ("2. Obergeschoss", 2), ("2e étage", 2),
        ("3rd floor", 3), ("LEVEL 1", 1), ("Floor_04 Walls", 4), ("Level 12", None), ("Floor 30x30", None), ("F1", None), ("L2", None),
    ],
)  # fmt: skip
def test_a_title_tells_a_storey_by_its_longest_word(title: str, rank: int | None) -> None:
    assert NAMES.storey(title) == rank


@pytest.mark.parametrize(
    ("layer", "storey"), [("L1-WALL", 1), ("F02_Doors", 2), ("2F-壁", 2), ("GF_Walls", 0), ("Wand_F30", None), ("A-WALL-1HR", None)]
)
def test_layers_tell_storeys_by_short_words_too(layer: str, storey: int | None) -> None:
    """How long walls withstand a fire, and a window's number, are no storeys."""
    assert NAMES.storey_of_layer(layer) == storey


def test_every_word_tells_something() -> None:
    """Of two keys that hold one word the latter would never count."""
    for key, entry in KNOWN.drawn_names.items():
        for word in entry.known_as:
            assert word == word.lower()
            storey = NAMES.storey_of_layer(word.replace("#", "2"))
            assert NAMES.is_passed((word,)) or storey is not None or entry.means == "nothing" or NAMES.sort_within((word,)), (key, word)


def test_words_of_ones_own_replace_those_of_a_key(tmp_path: Path) -> None:
    (tmp_path / "drawn_names.yaml").write_text("wall: {known_as: [zid]}\n", encoding="utf-8")
    names = drawn_names_of(load_catalogs(tmp_path))
    assert [names.sort_within((one,)) for one in ("ZIDOVI", "WALLS", "DOORS")] == ["wall", None, "door"]


def test_a_key_that_no_drawing_has_is_refused(tmp_path: Path) -> None:
    (tmp_path / "drawn_names.yaml").write_text("walls: {known_as: [zid]}\n", encoding="utf-8")
    with pytest.raises(CatalogError, match=r"drawn_names\.yaml.*walls"):
        load_catalogs(tmp_path)
