"""All formats say the same of a house: the same bodies, at the same places, as large and as heavy.

Each format is read by its consumer's library (`readers`); what it says is held against the description, body by body.
"""

from __future__ import annotations

from itertools import product

import pytest

from catalogs import load_catalogs
from solver.export_formats import EXPORTERS
from solver.exports import describe, home_picture, written_as
from solver.exports.writers import ExportSettings
from solver.scene import Room, Scene
from tests.exports.agreement import NOT_READ, differences, reader_of
from tests.exports.homes import SCENES, described
from tests.sweeps import pairs

READ = [format for format in EXPORTERS if format not in NOT_READ]
OTHERS = [home for home in SCENES if home != "own"]
PAIRS = [*product(["own"], READ), *pairs(OTHERS, READ)]
"""What is read of which home: all formats of the one that was made by hand, and each of one of the others."""


def test_every_format_is_read_or_is_said_why_not() -> None:
    assert set(NOT_READ) <= set(EXPORTERS)
    assert all(reader_of(format) for format in READ)


@pytest.mark.parametrize(("home", "format"), PAIRS)
def test_a_format_agrees_with_the_description(home: str, format: str) -> None:
    model = described(home)
    seen = reader_of(format)(written_as(model, ExportSettings(format)))
    assert differences(model, seen, format) == []


@pytest.mark.parametrize("format", READ)
@pytest.mark.parametrize("home", ["hostile", "storeys"])
def test_hostile_names_break_no_file_and_bodies_of_all_storeys_agree(home: str, format: str) -> None:
    model = described(home)
    seen = reader_of(format)(written_as(model, ExportSettings(format)))
    assert differences(model, seen, format) == []


@pytest.mark.parametrize("format", EXPORTERS)
@pytest.mark.parametrize(("width", "depth"), [(1e-12, 1e-12), (0.0004, 0.0004), (1e-12, 4.0)])
def test_rooms_without_a_floor_break_no_file(width: float, depth: float, format: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(home_picture, "LONG_SIDE", 200)  # of paper alone
    rooms = tuple(Room(name, number, "den", width=width, depth=depth) for number, name in enumerate("ab"))
    assert written_as(describe(Scene(wall_thickness=0.0, rooms=rooms), load_catalogs()), ExportSettings(format))


def test_a_mirror_image_would_be_seen() -> None:
    model = described("own")
    seen = reader_of("csv")(written_as(model, ExportSettings("csv")))
    mirrored = {name: one._replace(x=14.0 - one.x, turn=-one.turn) for name, one in seen.items()}
    assert len(differences(model, mirrored, "csv")) > 5
    heavier = {name: one._replace(mass=(one.mass or 0) * 1.01) for name, one in seen.items()}
    assert len(differences(model, heavier, "csv")) == len(model.bodies)
    assert differences(model, dict(list(seen.items())[1:]), "csv")
