"""`compose assets check`: what it guesses and marks, what it refuses, and that what it writes is read."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from catalogs import Catalogs, add_assets, load_catalogs
from catalogs.assets.asset_check import checked_folder
from service.cli import main
from solver.exports.asset_surfaces import levels_of
from tests.assets.makers import folder, shape, under


def files() -> dict[str, bytes]:
    return {
        "Bar Stools/barStool_2.glb": under(shape("bar_stool"), scale=[100] * 3),
        "loungeSofa.glb": shape("loveseat"),
        "dining-table-oak.glb": under(shape("dining_table"), scale=[1 / 0.0254] * 3),
        "rock.glb": shape("armchair"),
        "giant_sofa.glb": under(shape("sofa"), scale=[10] * 3),
        "sub/loungeSofa.glb": shape("sofa"),
        "Vase.GLB": shape("vase"),
        "sofa_broken.glb": shape("sofa")[:-1],
    }


@pytest.fixture
def checked(tmp_path: Path) -> Path:
    return folder(
        tmp_path, files(), {"mine": {"file": "rock.glb", "kinds": ["armchair"], "license": "MIT", "front": "+x", "size": [0.82, 0.8, 0.85]}}
    )


def test_guesses_and_marks_them(checked: Path) -> None:
    found = checked_folder(checked, load_catalogs())
    said = {name: (entry.kinds, entry.guessed) for name, entry in found.entries.items()}
    guess = ("kinds", "front", "license")
    assert said == {
        "mine": (("armchair",), ()),
        "barStool_2": (("bar_stool",), (*guess, "size")),
        "loungeSofa": (("sofa",), guess),
        "loungeSofa_2": (("sofa",), guess),
        "dining-table-oak": (("dining_table",), (*guess, "size")),
        "Vase": (("vase",), guess),
    }
    assert found.guessed == 5
    assert set(found.refused) == {"giant_sofa.glb", "sofa_broken.glb"}
    assert "unknown unit" in found.refused["giant_sofa.glb"]
    assert any(note.startswith("loungeSofa: not for a sofa") for note in found.notes)


def test_what_it_writes_is_read_and_checked_to_the_same(checked: Path) -> None:
    text = checked_folder(checked, load_catalogs()).text
    (checked / "assets.yaml").write_text(text)
    for name in ("giant_sofa.glb", "sofa_broken.glb"):
        (checked / name).unlink()
    assert checked_folder(checked, load_catalogs()).text == text
    assert sorted(add_assets(load_catalogs(), checked, "any").assets) == sorted(yaml.load(text, yaml.CSafeLoader))
    assert list(add_assets(load_catalogs(), checked).assets) == ["mine"]


def test_every_kind_s_own_file_is_guessed(tmp_path: Path) -> None:
    """A file that is called like a kind is of a kind that scenes call so, and has its size."""
    catalogs: Catalogs = load_catalogs()
    keys = [key for key, kind in catalogs.furniture.items() if kind.category != "dynamic"]
    found = checked_folder(folder(tmp_path, {f"{key}.glb": shape(key) for key in keys}), catalogs)
    assert found.refused == {}
    assert [key for key in keys if catalogs.name_of(key) not in found.entries[key].kinds] == []


def test_a_front_that_looks_aside_shows_in_the_proportions(tmp_path: Path) -> None:
    files = {"sofa.glb": under(shape("sofa"), rotation=[0, 0.5**0.5, 0, 0.5**0.5])}
    entry = checked_folder(folder(tmp_path, files), load_catalogs()).entries["sofa"]
    assert (entry.front, entry.size) == ("+x", pytest.approx((2.2, 0.9, 0.85), rel=1e-4))


def test_surfaces_are_found_where_those_of_the_kind_are(tmp_path: Path) -> None:
    """Of our own shapes, turned and in centimetres: each surface of the kind is found, to 2 cm, and a home then lays its things on them."""
    catalogs = load_catalogs()
    keys = ["sofa", "loveseat", "armchair", "dining_chair", "bed", "single_bed", "bookshelf", "dining_table", "nightstand", "desk"]
    files = {f"{key}.glb": under(shape(key), scale=[100] * 3, rotation=[0, 1, 0, 0]) for key in keys}
    found = checked_folder(folder(tmp_path, files), catalogs, levels_of)
    assert found.refused == {}
    for key in keys:
        asset = found.entries[key]
        assert "surfaces" in asset.guessed
        for surface in catalogs.furniture[key].surfaces:
            assert min(abs(surface.height - height) for height in asset.surfaces) < 0.02, (key, surface, asset.surfaces)
    assert checked_folder(tmp_path, catalogs).entries["sofa"].surfaces == ()


def test_the_command(checked: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    written = tmp_path / "written.yaml"
    assert main(["assets", "check", str(checked), "-o", str(written)]) == 1
    words = capsys.readouterr().err
    assert "refused sofa_broken.glb: is not whole" in words
    assert words.endswith("6 assets, 2 refused, 5 with something guessed\n")
    assert written.read_text() == checked_folder(checked, load_catalogs()).text


def test_homes_and_exports_by_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    at = folder(tmp_path / "own", {"a.glb": shape("toilet")}, {"a": {"file": "a.glb", "kinds": ["toilet"], "license": "CC-BY-NC-4.0"}})
    home, given = tmp_path / "home.yaml", ["--assets", str(at)]
    assert main(["generate", "--program", "studio", "--seed", "3", *given, "-o", str(home)]) == 0
    assert "asset" not in home.read_text()
    unused = "not used, as nobody says that their licence allows commercial use: a (--license any uses them)\n"
    assert capsys.readouterr().err == unused
    assert main(["generate", "--program", "studio", "--seed", "3", *given, "--license", "any", "-o", str(home)]) == 0
    assert "asset: a" in home.read_text()
    assert main(["export", str(home), *given, "--license", "any", "-f", "glb", "-o", str(tmp_path / "out")]) == 0
    assert "a: CC-BY-NC-4.0" in (tmp_path / "out" / "CREDITS.txt").read_text()
    words = capsys.readouterr().err
    assert "not used" not in words and "no asset" not in words
    assert main(["export", str(home), "-f", "csv", "-o", str(tmp_path / "out")]) == 0
    assert "no asset here is called a: --assets names a folder of your own\n" in capsys.readouterr().err
    assert main(["export", str(home), "--assets", str(tmp_path), "-o", str(tmp_path / "x.yaml")]) == 2
    assert "assets.yaml" in capsys.readouterr().err
