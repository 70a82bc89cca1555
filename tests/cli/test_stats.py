"""`compose stats`: its table, its figures as documents, its processes, its exit status."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Sequence
from pathlib import Path

import pytest
import yaml

from catalogs import load_catalogs
from service.cli import main
from solver.validator import RULES

Captured = pytest.CaptureFixture[bytes]
SMALL = ("--width", "7", "--depth", "6")


def cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip("|").split("|")]


def section(text: str, title: str) -> list[list[str]]:
    """The rows of the table under a title, its head first; every line of a table is as long as the others."""
    lines = text.split(f"## {title}\n\n")[1].split("\n\n", maxsplit=1)[0].splitlines()
    assert len({len(line) for line in lines}) == 1
    assert re.fullmatch(r"\|:-+(\|-+:)+\|", lines[1])
    return [cells(lines[0]), *map(cells, lines[2:])]


def stats(capture: Captured, *arguments: str, status: int = 0) -> str:
    assert main(["stats", "--workers", "1", *arguments]) == status
    return capture.readouterr().out.decode()


def column(rows: Sequence[Sequence[str]], head: str) -> dict[str, str]:
    at = rows[0].index(head)
    return {row[0]: row[at] for row in rows[1:]}


def test_the_tables_say_what_the_document_says(tmp_path: Path, capfdbinary: Captured) -> None:
    asked = ("-n", "3", "--seed", "11", *SMALL)
    text = stats(capfdbinary, *asked)
    document = json.loads(stats(capfdbinary, *asked, "--format", "json"))
    assert yaml.load(stats(capfdbinary, *asked, "--format", "yaml"), yaml.CSafeLoader) == document
    assert stats(capfdbinary, *asked, "-o", str(tmp_path / "figures.json")) == ""
    assert json.loads((tmp_path / "figures.json").read_text()) == document
    (one,) = document["sets"]
    assert (one["name"], one["count"], one["first_seed"], one["request"]["decorate"]) == ("7 x 6 m", 3, 11, True)
    homes = column(section(text, "Homes"), "7 x 6 m")
    assert homes["houses"] == "3"
    assert homes["floor indoors, m2"].startswith("42.0 ")
    assert homes["homes without an error, %"] == "100.0"
    assert list(column(section(text, "Issues"), "7 x 6 m")) == list(RULES)
    rooms = section(text, "Rooms: 7 x 6 m")
    assert rooms[0] == [
        "type", "rooms", "m2", "cover %", "walkable %", "pieces", "decorations", "together", "left out", "missing", "people",
        "different", "most alike",
    ]  # fmt: skip
    assert list(column(rows := rooms, "rooms")) == list(one["rooms"])
    for name, figures in one["rooms"].items():
        assert column(rows, "rooms")[name] == str(figures["count"])
        assert column(rows, "pieces")[name].split()[0] == f"{figures['pieces']['median']:g}"
        assert column(rows, "cover %")[name].split()[0] == f"{100 * figures['cover']['median']:.0f}"
        assert column(rows, "different")[name] == str(figures["signatures"])


def test_the_number_of_processes_changes_nothing(capfdbinary: Captured) -> None:
    asked = ("-n", "3", "--seed", "3", *SMALL)
    assert main(["stats", *asked, "--workers", "2"]) == 0
    assert capfdbinary.readouterr().out.decode() == stats(capfdbinary, *asked)


def test_presets_stand_side_by_side(capfdbinary: Captured) -> None:
    text = stats(capfdbinary, "-n", "1", "--presets", "--no-decorate", "--style", "rustic")
    presets = list(load_catalogs().presets)
    homes = section(text, "Homes")
    assert homes[0] == ["", *presets]
    assert next(row for row in homes if row[0] == "decorations")[1:] == ["0 (0-0)"] * len(presets)
    assert all(section(text, f"Rooms: {name}") for name in presets)
    assert main(["stats", "--presets", "--program", "family"]) == 2
    assert b"--presets" in capfdbinary.readouterr().err


def test_a_request_file_may_count_rooms(tmp_path: Path, capfdbinary: Captured) -> None:
    (tmp_path / "request.yaml").write_text("{program: {bedrooms: 1, bathrooms: 1}, area: 50, decorate: false}")
    document = json.loads(stats(capfdbinary, str(tmp_path / "request.yaml"), "-n", "1", "--format", "json"))
    (one,) = document["sets"]
    assert one["name"] == "1 bedrooms, 1 bathrooms, 50 m2"
    assert (one["first_seed"], one["home"]["decorations"]["mean"]) == (0, 0)


def test_errors_are_told_by_the_exit_status_and_with_their_seeds(capfdbinary: Captured) -> None:
    text = stats(capfdbinary, "-n", "4", "--program", "studio", "--width", "5", "--depth", "5", "--robot-width", "1.6", status=1)
    broken = column(section(text, "Issues"), "studio")["unreachable"]
    assert re.fullmatch(r"\d+ in [1-4]", broken)
    assert re.search(r"^- studio, seed [0-3]: error unreachable: ", text, re.MULTILINE)


def test_what_no_house_can_meet_is_bad_use(capfdbinary: Captured) -> None:
    asked = ("-n", "3", "--program", "castle")
    assert main(["stats", *asked, "--workers", "2"]) == 2
    out, words = capfdbinary.readouterr()
    assert out == b""
    assert b"castle" in words and b"Traceback" not in words
    assert stats(capfdbinary, *asked, status=2) == ""


def test_a_person_sees_how_far_it_is_and_a_file_hears_nothing_of_quick_work(capfdbinary: Captured, monkeypatch: pytest.MonkeyPatch) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    seen = Terminal()
    monkeypatch.setattr("sys.stderr", seen)
    assert stats(capfdbinary, "-n", "2", *SMALL).startswith("# Statistics: 2 houses")
    assert "2/2" in seen.getvalue()
    monkeypatch.setattr("sys.stderr", written := io.StringIO())
    monkeypatch.setattr("service.progress.monotonic", lambda: 7.0)
    stats(capfdbinary, "-n", "2", *SMALL)
    assert written.getvalue() == ""
