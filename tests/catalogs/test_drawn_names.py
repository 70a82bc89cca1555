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
        ("Keller", 0), ("GROUND FLOOR PLAN", 1), ("Grundriss EG", 1), ("Rez-de-chaussée", 1), ("1. OG", 2), ("2. OG", 3), ("OG_Wand", 2),
        ("Second floor", 3), ("DG", 4), ("Wand", None), ("Allegro", None),
    ],
)  # fmt: skip
def test_a_title_tells_a_storey_by_its_longest_word(title: str, rank: int | None) -> None:
    assert NAMES.storey(title) == rank


def test_every_word_tells_something() -> None:
    """Of two keys that hold one word the latter would never count."""
    for key, entry in KNOWN.drawn_names.items():
        for word in entry.known_as:
            assert word == word.lower()
            assert NAMES.is_passed((word,)) or NAMES.storey(word) is not None or entry.means == "nothing" or NAMES.sort_within((word,)), (
                key,
                word,
            )


def test_words_of_ones_own_replace_those_of_a_key(tmp_path: Path) -> None:
    (tmp_path / "drawn_names.yaml").write_text("wall: {known_as: [zid]}\n", encoding="utf-8")
    names = drawn_names_of(load_catalogs(tmp_path))
    assert [names.sort_within((one,)) for one in ("ZIDOVI", "WALLS", "DOORS")] == ["wall", None, "door"]


def test_a_key_that_no_drawing_has_is_refused(tmp_path: Path) -> None:
    (tmp_path / "drawn_names.yaml").write_text("walls: {known_as: [zid]}\n", encoding="utf-8")
    with pytest.raises(CatalogError, match=r"drawn_names\.yaml.*walls"):
        load_catalogs(tmp_path)
