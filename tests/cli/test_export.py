"""`compose export -f FORMAT`: files into a folder, one file to a name or to standard output."""

from __future__ import annotations

from pathlib import Path

import pytest

from compose_homes import Room, Scene, dump, export
from service.cli import main
from solver.export_formats import EXPORTERS

DEN = Scene(rooms=(Room("den", type="office", width=4.0, depth=3.0),))


@pytest.fixture
def den(tmp_path: Path) -> Path:
    dump(DEN, tmp_path / "den.yaml")
    return tmp_path / "den.yaml"


@pytest.mark.parametrize("format", EXPORTERS)
def test_files_go_into_a_folder(den: Path, tmp_path: Path, format: str) -> None:
    folder = tmp_path / "out0.4"
    assert main(["export", str(den), "-f", format, "-o", str(folder)]) == 0
    found = {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    assert found == export(DEN, format)


def test_one_file_goes_to_a_name_that_tells_its_format(den: Path, tmp_path: Path, capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    (written,) = export(DEN, "csv").values()
    assert main(["export", str(den), "-o", str(tmp_path / "den.csv")]) == 0
    assert (tmp_path / "den.csv").read_bytes() == written
    assert main(["export", str(den), "-f", "csv"]) == 0
    assert capfdbinary.readouterr().out == written


def test_a_scene_with_errors_is_refused_when_strict(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "far.yaml").write_text(
        "rooms: [{id: den, width: 4, depth: 3, furniture: [{id: s, name: sofa, x: 9, z: 1, width: 2, depth: 0.9, height: 0.8}]}]"
    )
    assert main(["export", str(tmp_path / "far.yaml"), "-f", "csv", "-o", str(tmp_path), "--strict"]) == 2
    assert "scene" in capsys.readouterr().err
    assert main(["export", str(tmp_path / "far.yaml"), "-f", "csv", "-o", str(tmp_path)]) == 0
