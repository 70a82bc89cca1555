"""Names of others: what is plainly meant is understood, what is not is left alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from catalogs import CatalogError, load_catalogs
from catalogs.synonyms import KindSize, synonyms_of, words_of

KNOWN = load_catalogs()
NAMES = synonyms_of(KNOWN)
UNDERSTOOD: list[tuple[str, KindSize, str]] = [
    ("Bed", (1.5, 2.0, 0.8), "bed"),
    ("queenBed", (1.5, 2.05, 0.6), "bed"),
    ("lit d'enfant", (0.8, 1.6, 0.7), "single_bed"),
    ("Nacht-Tische", (0.4, 0.4, 0.5), "nightstand"),
    ("TVUnit_7", (1.5, 0.4, 0.5), "tv_stand"),
    ("tvunit", (1.5, 0.4, 0.5), "tv_stand"),
    ("Étagères", (1.0, 0.3, 1.9), "bookshelf"),
    ("modernOakWritingDesk", (1.3, 0.7, 0.75), "desk"),
    ("three seater velvet sofa", (2.3, 0.95, 0.8), "sofa"),
    ("corner sofa with cushions", (2.6, 1.7, 0.8), "sofa"),
    ("Chaise", (0.45, 0.5, 0.9), "dining_chair"),
    ("Wardrobbe", (1.7, 0.6, 2.1), "wardrobe"),
    ("table", (1.1, 0.6, 0.4), "coffee_table"),
    ("table", (1.6, 0.9, 0.75), "dining_table"),
    ("table", (0.4, 0.4, 0.55), "side_table"),
    ("Mirror", (0.6, 0.03, 0.8), "wall_mirror"),
    ("Mirror", (0.6, 0.4, 1.7), "standing_mirror"),
    ("frigo", (0.6, 0.65, 1.8), "refrigerator"),
    ("heater", (0.8, 0.1, 0.6), "radiator"),
]
LEFT_ALONE: list[tuple[str, KindSize]] = [
    ("bed sheet", (1.6, 2.0, 0.02)),
    ("Chair", (0.05, 0.06, 0.1)),
    ("sofa table cloth", (1.6, 0.9, 0.01)),
    ("lampshade", (0.3, 0.3, 0.2)),
    ("picture", (1.6, 2.0, 0.9)),
    ("desk pad", (0.8, 0.4, 0.01)),
    ("gizmo", (0.6, 0.6, 0.9)),
    ("x", (1.0, 1.0, 1.0)),
    ("", (1.0, 1.0, 1.0)),
    ("12", (1.0, 1.0, 1.0)),
    ("small", (0.4, 0.4, 0.5)),
]


@pytest.mark.parametrize(("name", "size", "kind"), UNDERSTOOD)
def test_what_is_plainly_meant_is_understood(name: str, size: KindSize, kind: str) -> None:
    meaning = NAMES.meaning(name, size)
    assert meaning is not None
    assert KNOWN.name_of(meaning.key) == KNOWN.name_of(kind)


@pytest.mark.parametrize(("name", "size"), LEFT_ALONE)
def test_a_wrong_understanding_is_worse_than_none(name: str, size: KindSize) -> None:
    assert NAMES.meaning(name, size) is None


def test_the_size_variant_is_the_nearest_one() -> None:
    found = [NAMES.meaning("double bed", (width, 2.0, 0.9)) for width in (1.35, 1.6, 1.9)]
    assert [meaning.key for meaning in found if meaning] == ["small_bed", "bed", "king_bed"]


def test_every_kind_of_furniture_has_names_of_others_or_is_a_variant() -> None:
    named = {name for name, entry in KNOWN.synonyms.items() if entry.means == "kind"}
    without = {kind for kind in KNOWN.furniture if KNOWN.name_of(kind) == kind} - named
    assert without == {"hall_bench", "bistro_chair", "drill_press", "table_saw", "garden_shed", "child", "dog", "cat"}


def test_a_kind_in_any_way_of_writing_is_that_kind() -> None:
    for kind, spec in KNOWN.furniture.items():
        for name in ("".join(word.capitalize() for word in kind.split("_")), kind.upper(), kind.replace("_", " ") + "s"):
            meaning = NAMES.meaning(name, spec.size)
            assert meaning is not None, name
            assert meaning.name == KNOWN.name_of(kind), name


def test_words() -> None:
    assert words_of("TVStands_03") == ("tv", "stand")
    assert words_of("Fridge & Freezer") == ("fridge", "freezer")
    assert words_of("Bücherregale") == ("bucherregale",)
    assert words_of("kitchen/big-BookShelf01") == ("kitchen", "big", "book", "shelf")
    assert words_of("012") == ()


def test_names_of_ones_own(tmp_path: Path) -> None:
    (tmp_path / "synonyms.yaml").write_text("sofa: {known_as: [flurble]}\n")
    meaning = synonyms_of(load_catalogs(tmp_path)).meaning("Flurble", (2.0, 0.9, 0.8))
    assert meaning is not None
    assert meaning.name == "sofa"


def test_a_name_for_no_kind_is_a_fault(tmp_path: Path) -> None:
    (tmp_path / "synonyms.yaml").write_text("bed: {known_as: [cot]}\nsofaa: {known_as: [couch]}\n")
    with pytest.raises(CatalogError, match=r"synonyms\.yaml.*2.*sofaa"):
        load_catalogs(tmp_path)
