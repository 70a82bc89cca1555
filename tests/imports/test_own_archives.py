"""An export of several files, packed as the service packs it or as people do, comes back as the home that it was."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from io import BytesIO
from zipfile import ZipFile

import pytest

from solver import Request, export, generate
from solver.errors import FieldError
from solver.exchange import dump_scene
from solver.export_formats import EXPORTERS
from solver.exports import home_picture
from solver.scene import Level, Room, Scene
from tests.imports.plans import read

UPPER = Room("loft", type="office", level=1, width=3.0, depth=3.0)
SEVERAL = ("nav2", "png", "boxes", "habitat", "svg", "arena", "urdf", "sdf", "dxf")


@cache
def home() -> Scene:
    return generate(Request(seed=41, program="studio", decorate=True)).scene


@cache
def two_storeys() -> Scene:
    return replace(home(), levels=(Level(), Level(1, 2.9, 2.5)), rooms=(*home().rooms, UPPER), certificate=None)


@cache
def exported(name: str, storeys: int) -> dict[str, bytes]:
    return export(two_storeys() if storeys > 1 else home(), name)


@pytest.fixture(autouse=True, scope="module")
def small_pictures() -> Iterator[None]:
    """Most work of an archive of pictures is to draw what nobody looks at here."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(home_picture, "LONG_SIDE", 200)
        yield


def archive(files: dict[str, bytes], folder: str = "") -> bytes:
    made = BytesIO()
    with ZipFile(made, "w") as opened:
        for name, content in files.items():
            opened.writestr(folder + name, content)
    return made.getvalue()


def test_formats_of_several_files_are_those_that_are_known() -> None:
    small = replace(two_storeys(), rooms=(min(home().rooms, key=lambda room: len(room.furniture)), UPPER), dynamic=())
    assert {name for name in EXPORTERS if len(export(small, name)) > 1} == {*SEVERAL}


@pytest.mark.parametrize("format", SEVERAL)
@pytest.mark.parametrize("folder", ["", "my home/"])
def test_an_archive_comes_back_as_the_home_that_it_was(format: str, folder: str) -> None:
    for storeys, scene in enumerate((home(), two_storeys()), 1):
        files = exported(format, storeys)
        if len(files) > 1:
            answer = read(archive(files, folder), f"{format}.zip")
            assert (answer.format, answer.changes, answer.guesses, answer.unread) == ("scene", (), (), ())
            assert json.loads(dump_scene(answer.scene, "json")) == json.loads(dump_scene(scene, "json"))


def test_two_homes_in_an_archive_are_refused() -> None:
    files = {f"{number}/{name}": content for number in (1, 2) for name, content in exported("nav2", 1).items()}
    with pytest.raises(FieldError, match="an archive of 2 plans"):
        read(archive(files), "homes.zip")


def test_what_is_one_file_is_alone() -> None:
    assert list(export(Scene(rooms=(UPPER,)), "csv")) == ["house.csv"]


def test_atiss_loader_splits_the_name_of_all_in_a_folder() -> None:
    """It takes what follows the first underscore of each, and fails where there is none."""
    known = {line.split(b",")[0].decode() for line in exported("boxes", 1)["house_splits.csv"].splitlines()}
    tops = {name.split("/")[0] for name in exported("boxes", 1)}
    assert {top.split("_")[1] for top in tops} & known == known
