"""`python -m scripts.debug_room` tells of the very room that a home has."""

from __future__ import annotations

from typing import Any

import pytest

from catalogs import load_catalogs
from scripts.debug_room import main
from solver import Request, generate
from solver.scene import Room

SEED = 5


def test_it_tells_what_was_wanted_what_stands_and_what_was_refused(capsys: pytest.CaptureFixture[str]) -> None:
    scene = generate(Request(seed=SEED, program="studio")).scene
    certificate: Any = scene.certificate
    reports = certificate["rooms"]
    room = max(scene.rooms, key=lambda one: len(reports[one.id]["left_out"]))
    report = reports[room.id]
    assert report["left_out"]
    missing = report["left_out"][0]["piece"]
    assert main(["--seed", str(SEED), "--program", "studio", "--room", room.id, "--piece", missing]) == 0
    told = capsys.readouterr().out
    assert f"cost {report['cost']:.3f}; proven: {report['proven']}" in told
    standing, refused = told.split("PLACED")[1].split("REFUSED")
    assert all(piece.id.split("/")[1] in standing for piece in room.furniture if piece.name == room.furniture[0].name)
    assert all(f"{entry['piece']}: {entry['reason']}" in refused for entry in report["left_out"])
    assert f"CANDIDATES of {missing}" in told


def test_a_room_that_is_not_there_is_refused_with_those_that_are(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--seed", str(SEED), "--program", "studio", "--room", "ballroom_3"]) == 2
    assert "living_room_" in capsys.readouterr().err


@pytest.fixture(scope="module")
def living_room() -> Room:
    scene = generate(Request(seed=SEED, program="studio")).scene
    return next(room for room in scene.rooms if room.type == "living_room")


STUDIO = ("--seed", str(SEED), "--program", "studio", "--room", "living_room")


def test_every_piece_of_the_room_type_is_named_and_turned_as_in_the_scene(living_room: Room, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*STUDIO, "--piece", "plant"]) == 0
    told = capsys.readouterr().out
    wanted, rest = told.split("NOT WANTED")
    unwanted, standing = rest.split("PLACED")
    catalogs = load_catalogs()
    for spec in catalogs.rooms["living_room"].pieces:
        assert f"  {spec.piece}_1 " in wanted or f"  {spec.piece}: " in unwanted, spec.piece
        if spec.min_area > living_room.width * living_room.depth:
            assert f"  {spec.piece}: needs {spec.min_area:g} m2" in unwanted
    turned = {piece.id.split("/")[1]: piece.rotation for piece in living_room.furniture if piece.id.split("/")[1] in wanted}
    lines = {line.split()[0]: line for line in standing.split("REFUSED")[0].splitlines() if line.startswith("  ")}
    assert len(turned) > 5
    assert all(f"rotation {rotation:g}," in lines[label] for label, rotation in turned.items())


def test_a_name_without_number_is_every_piece_named_so_and_no_two_candidates_read_alike(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*STUDIO, "--piece", "side_table"]) == 0
    told = capsys.readouterr().out
    assert told.count("CANDIDATES of side_table_1") == told.count("CANDIDATES of ") == 1
    ways = [line for line in told.split("CANDIDATES of ")[1].splitlines() if line.startswith("  side_table ")]
    assert len(ways) == len(set(ways)) > 1
    assert " 1 candidates" not in told


@pytest.mark.parametrize("piece", ["fireplace_1", "nonsense"])
def test_a_piece_that_was_not_wanted_is_refused_with_those_that_were(piece: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*STUDIO, "--piece", piece]) == 2
    said = capsys.readouterr()
    assert said.err.startswith(f"no piece {piece} was wanted; there are sofa_1, ")
    assert not said.out


def test_counts_are_read_as_by_compose_and_a_wrong_request_is_refused_in_a_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--seed", "7", "--program", "bedrooms=1", "--room", "kitchen"]) == 0
    assert "kitchen" in capsys.readouterr().out
    assert main(["--seed", "7", "--program", "bedrooms=99", "--room", "kitchen"]) == 2
    assert capsys.readouterr().err == "program.bedrooms: is 99 (allowed: a whole number from 0 to 12)\n"
