"""`python -m scripts.debug_room` tells of the very room that a home has."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from catalogs import load_catalogs
from compose_homes import dump, load
from scripts.debug_room import described, main
from solver import Request, generate
from solver.geometry import Rect
from solver.pieces import Attach, Candidate, Piece, Space
from solver.scene import Room

SEED = 5


def test_it_tells_what_was_wanted_what_stands_and_what_was_refused(capsys: pytest.CaptureFixture[str]) -> None:
    scene = generate(Request(seed=SEED, program="studio")).scene
    certificate: Any = scene.certificate
    reports = certificate["rooms"]
    room = next(one for one in scene.rooms if one.type == "living_room")  # a kitchen's counters go by several labels
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


def test_the_costs_that_are_told_add_up(living_room: Room, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*STUDIO]) == 0
    wanted, rest = capsys.readouterr().out.split("\nPLACED at cost ")
    placed = rest.split("\nREFUSED")[0].splitlines()
    *rows, last = [line for line in placed if line.startswith("  ")]
    total, pieces, floor, relations, distances = map(float, re.findall(r"-?\d+\.\d+", last))
    assert f"{total:.3f}" == placed[0].split(";")[0]
    assert total == pytest.approx(pieces + floor + relations + distances, abs=0.003)
    told = [float(row.rpartition(", cost ")[2]) for row in rows if not row.startswith("  floor ")]
    assert len(told) == len(living_room.furniture) > 5
    assert pieces == pytest.approx(sum(told), abs=0.005 * len(told))
    floors = [row.strip().partition(":")[0] for row in rows if row.startswith("  floor ") and not row.startswith("  floor_")]
    assert len(floors) > 3 and all(f"  {label} " in wanted for label in floors)


def test_a_room_that_is_not_there_is_refused_with_those_that_are(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--seed", str(SEED), "--program", "studio", "--room", "ballroom_3"]) == 2
    assert "living_room_" in capsys.readouterr().err


def test_a_home_in_a_file_is_told_of_as_the_one_that_is_made(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    home = tmp_path / "home.yaml"
    dump(generate(Request(seed=SEED, program="studio", outline="L")).scene, home)
    assert main(["--home", str(home), "--room", "living_room", "--piece", "plant"]) == 0
    told = capsys.readouterr().out
    certificate: Any = load(home).certificate
    cost = next(report["cost"] for room, report in certificate["rooms"].items() if room.startswith("living_room"))
    assert f"PLACED at cost {cost:.3f}" in told
    assert main(["--home", str(tmp_path / "none.yaml"), "--room", "kitchen"]) == 2


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


def test_a_piece_that_the_room_type_does_not_list_is_refused_with_those_that_it_does(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*STUDIO, "--piece", "nonsense"]) == 2
    said = capsys.readouterr()
    assert said.err.startswith("no piece nonsense in the type living_room; there are sofa, ")
    assert "floor at" not in said.err
    assert not said.out


@pytest.mark.parametrize("piece", ["fireplace_1", "fireplace"])
def test_of_a_piece_that_was_not_wanted_the_reason_is_told(piece: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*STUDIO, "--piece", piece]) == 0
    told = capsys.readouterr().out
    assert told.rstrip().endswith("NOT WANTED was fireplace: by chance 0.25, not drawn")
    assert "PLACED" in told


# --- candidates, in a room of 3 x 2 m made by hand ----------------------------------------------------------------------
def told(*pieces: Piece) -> list[str]:
    """What is told of the last piece's candidates: a verdict each, and the line after them."""
    space = Space("den", Rect(0, 0, 3000, 2000), (), ())
    lines = list(described(Room("den", width=3.0, depth=2.0), space, pieces, (), pieces[-1:]))
    first = next(k for k, line in enumerate(lines) if "CANDIDATES" in line)
    return [line.strip() if line.startswith("  why") else line.partition(": ")[2] for line in lines[first + 1 :]]


def free(kind: str, width: int, cost: float = 0.0, depth: int = 1200) -> Candidate:
    return Candidate(kind, (width, depth, 800), 0, None, (1500, 1000), cost=cost)


def at_table(size: str) -> Candidate:
    return Candidate("chair", (400, 400, 800), 0, None, (0, 0), attach=Attach("table_1", size, (0, 0), (700, 700)))


BED = Piece("bed_1", True, (free("bed", 2400),))


def test_what_cannot_stand_names_with_what_and_by_how_much() -> None:
    assert told(BED, Piece("chest_1", False, (free("chest", 700),))) == [
        "cannot stand with bed_1",
        "why: bed_1 and chest_1 cannot stand and be used together: chest 0.70 + bed 2.40 = 3.10 > 3.00 m from west to east: 10 cm short",
    ]


def test_a_piece_that_stands_has_no_line_that_tells_why_not() -> None:
    assert told(BED, Piece("chest_1", False, (free("chest", 500), free("chest", 700)))) == ["stands", "cannot stand with bed_1"]


def test_what_costs_more_than_to_leave_it_out_says_how_much() -> None:
    verdict, why = told(BED, Piece("chest_1", False, (free("chest", 500, cost=3.0),), skip_cost=2.0))
    assert re.fullmatch(r"stands, but costs [345]\.\d\d: more than to leave it out", verdict)
    assert why == "why: it can stand only as told above"


def test_what_stands_at_a_piece_that_was_left_out_sends_there() -> None:
    table = Piece("table_1", False, (free("table", 800),))
    assert told(BED, table, Piece("chair_1", False, (at_table("table"),))) == [
        "table_1 does not stand",
        "why: table_1 does not stand, and it stands nowhere else: ask about that one",
    ]


def test_a_candidate_at_another_size_of_what_it_stands_at_names_the_one_that_stands() -> None:
    table = Piece("table_1", True, (free("small_table", 500, depth=500),))
    assert told(table, Piece("chair_1", False, (at_table("small_table"), at_table("table")))) == ["stands", "table_1 stands as small_table"]


def test_floor_better_kept_free_that_a_candidate_takes_is_named() -> None:
    kept = Candidate("floor", (600, 1200, 1800), 0, None, (0, 0), attach=Attach("bed_1", "bed", (1500, 1500), (0, 0)))
    floor = Piece("floor at the right of bed_1", True, (kept,), is_floor=True)
    verdict, why = told(BED, floor, Piece("chest_1", False, (free("chest", 500),)))
    assert verdict == "stands, but takes the floor at the right of bed_1"
    assert why == "why: it can stand only as told above"


def test_floor_that_is_used_is_told_with_what_that_costs() -> None:
    beside = Candidate("floor", (600, 1200, 1800), 0, None, (0, 0), attach=Attach("bed_1", "bed", (1500, 1500), (0, 0)))
    none = Candidate("floor", (1, 1, 1800), 0, None, (0, 0), cost=1.5, attach=Attach("bed_1", "bed", (0, 1500), (0, 0)))
    floor = Piece("floor at the right of bed_1", True, (beside, none), is_floor=True)
    space, chest = Space("den", Rect(0, 0, 3000, 2000), (), ()), Piece("chest_1", True, (free("chest", 500),))
    used = list(described(Room("den", width=3.0, depth=2.0), space, (BED, chest, floor), ()))
    assert "  floor at the right of bed_1: used, cost 1.50" in used
    assert re.search(r"= 0\.000 of pieces \+ 1\.500 of floor used \+ 0\.000 of relations", used[-1])
    kept = list(described(Room("den", width=3.0, depth=2.0), space, (BED, floor), ()))
    assert "  floor at the right of bed_1: kept free" in kept


def test_a_required_piece_is_not_said_to_be_better_left_out() -> None:
    assert told(BED, Piece("chest_1", True, (free("chest", 500, cost=30.0),))) == ["stands"]


def test_what_has_no_place_in_the_room_at_all_is_held_against_no_piece() -> None:
    assert told(BED, Piece("chest_1", False, (free("chest", 3100),)))[0] == "cannot stand even alone"
