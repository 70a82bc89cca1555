"""`compose dataset`: the same bytes for any number of processes, resumed without a lost or doubled home, nothing half-written."""

from __future__ import annotations

import gc
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from functools import partial
from hashlib import sha256
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

from service.cli import main
from service.dataset.dataset_plan import SPLITS, Shard, split_of
from service.dataset.shards import SCHEMAS
from service.pool import spread
from solver.errors import FieldError
from solver.exchange import load_text, read_scene
from solver.scene import Decoration, Furniture, Room
from solver.validator import validate
from tests.cli.programs import GUARD_S, started, until
from tests.dataset.pool_jobs import ends_always, ends_as_a_thing_goes, ends_once, nothing

ENDED = "compose: ended\n"
SMALL = ("dataset", "--width", "7", "--depth", "6", "--seeds", "3-19", "--shard-size", "6")
FORMATS = ("--formats", "json,csv,boxes")
ONE_ROOM = ("--width", "5", "--depth", "4", "--workers", "1")
"""For what is about files alone: made in a fifth of the time."""


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def made(folder: Path, *more: str, status: int = 0) -> dict[str, bytes]:
    """What a run leaves in its folder."""
    assert main([*SMALL, "--out", str(folder), *more]) == status
    return contents(folder)


def rows(folder: Path, table: str) -> list[dict[str, Any]]:
    found = [row for path in (folder / "tables" / table).glob("*.parquet") for row in pq.read_table(path).to_pylist()]
    return sorted(found, key=lambda row: row["seed"])


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("datasets") / "alone"
    made(path, "--workers", "1", *FORMATS)
    return path


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The set of rooms alone, made at once by one process."""
    path = tmp_path_factory.mktemp("datasets") / "whole"
    made(path, *ONE_ROOM)
    return path


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The set of rooms in several formats, made so too."""
    path = tmp_path_factory.mktemp("datasets") / "exported"
    made(path, *ONE_ROOM, *FORMATS)
    return path


def test_each_seed_has_one_row_whose_scene_is_what_generate_makes(folder: Path, tmp_path: Path) -> None:
    houses = rows(folder, "houses")
    assert [row["seed"] for row in houses] == list(range(3, 20))
    assert main(["generate", "--width", "7", "--depth", "6", "--decorate", "--seed", "11", "-o", str(tmp_path / "home.json")]) == 0
    assert str(houses[8]["scene"]).encode() == (tmp_path / "home.json").read_bytes()
    assert {row["digest"] for row in houses} == {sha256(str(row["scene"]).encode()).hexdigest() for row in houses}


def test_the_tables_say_what_the_scenes_say(folder: Path) -> None:
    manifest = json.loads((folder / "dataset.json").read_text())
    tables = {name: rows(folder, name) for name in manifest["rows"]}
    assert {name: len(found) for name, found in tables.items()} == manifest["rows"]
    for row in tables["houses"]:
        scene = read_scene(load_text(str(row["scene"]), "json"))
        own = {name: [one for one in found if one["seed"] == row["seed"]] for name, found in tables.items()}
        assert [(one["id"], one["type"]) for one in own["rooms"]] == [(room.id, room.type) for room in scene.rooms]
        things: list[tuple[Room, Furniture | Decoration]] = [(room, one) for room in scene.rooms for one in room.furniture]
        things += [(room, one) for room in scene.rooms for one in room.decorations]
        assert len(own["pieces"]) == len(things) + len(scene.dynamic)
        at = {one["id"]: one for one in own["pieces"]}
        for room, body in things:
            assert at[body.id]["x"] == pytest.approx(room.x + body.x) and at[body.id]["z"] == pytest.approx(room.z + body.z)
        assert {one["id"] for one in own["doors"]} == {one.id for room in scene.rooms for one in room.openings}
        assert row["errors"] == sum(issue.severity == "error" for issue in validate(scene))
        reports = json.loads(str(row["scene"]))["certificate"]["rooms"].values()
        fronts = {(piece, front) for report in reports for piece, ways in report.get("fronts", {}).items() for front in ways}
        assert {(one["piece"], one["front"]) for one in own["fronts"]} == fronts
        joined = {one["door"] for one in own["graph"] if one["door"]}
        assert joined <= {one["id"] for one in own["doors"] if one["kind"] != "window"} and joined


def test_what_lies_on_a_piece_lies_on_one_of_its_receptacles(folder: Path) -> None:
    pieces = {(row["seed"], row["id"]): row for row in rows(folder, "pieces")}
    carried, inside = Counter[str](), 0
    on: dict[tuple[object, object], list[dict[str, Any]]] = {}
    for row in rows(folder, "receptacles"):
        assert row["room"] == pieces[row["seed"], row["piece"]]["room"]
        on.setdefault((row["seed"], row["piece"]), []).append(row)
    for piece in pieces.values():
        if piece["sort"] != "decoration" or piece["parent"] is None or piece["wall"] is not None:
            continue
        found = on[piece["seed"], piece["parent"]]
        level = [one for one in found if abs(one["y"] - piece["y"]) < 0.011]
        holding = [one for one in level if is_over(piece["x"] - one["x"], piece["z"] - one["z"], one)]
        assert holding, piece
        carried[holding[0]["surface"]] += 1
        inside += holding[0]["front"] is not None
    assert carried["top"] > 50 < carried["shelves"] and inside == carried["drawers"] > 5


def is_over(dx: float, dz: float, one: dict[str, Any]) -> bool:
    """Tells whether a point beside the middle of a turned rectangle is within it."""
    turn = math.radians(one["turn"])
    across, along = dx * math.cos(turn) - dz * math.sin(turn), dx * math.sin(turn) + dz * math.cos(turn)
    return 2 * abs(across) <= one["width"] + 1e-6 and 2 * abs(along) <= one["depth"] + 1e-6


def test_a_door_swings_into_the_room_that_its_leaf_is_in(folder: Path) -> None:
    hung = {(row["seed"], row["id"]): row for row in rows(folder, "doors")}
    assert all((row["hinge"] is None) == (row["kind"] != "door") == (row["swing"] is None) for row in hung.values())
    seen = Counter[tuple[object, object]]()
    for house in rows(folder, "houses")[:6]:
        scene = read_scene(load_text(str(house["scene"]), "json"))
        for room in scene.rooms:
            for one in room.openings:
                if one.kind == "door" and one.render_panel:
                    row = hung[house["seed"], one.id]
                    sides = {row["room_a"]: "room_a", row["room_b"]: "room_b"}
                    into = sides[room.id] if one.swing != "out" else next(side for name, side in sides.items() if name != room.id)
                    assert (row["hinge"], row["swing"]) == (one.hinge or "start", into)
                    seen[row["hinge"], row["swing"]] += 1
    assert len(seen) >= 3


def test_archives_hold_each_home_once(folder: Path) -> None:
    import tarfile

    names: list[str] = []
    for path in (folder / "archives").glob("*.tar"):
        with tarfile.open(path) as archive:
            names += archive.getnames()
    assert len(names) == len(set(names))
    assert sorted(name for name in names if re.fullmatch(r"\d+\.csv", name)) == sorted(f"{seed}.csv" for seed in range(3, 20))
    assert {name.partition(".")[0] for name in names if ".boxes." in name} == {str(seed) for seed in range(3, 20)}


def test_killed_and_resumed_by_two_processes_it_is_what_one_makes(exported: Path, tmp_path: Path) -> None:
    killed = tmp_path / "killed"
    command = (sys.executable, "-m", "compose_homes", *SMALL, *ONE_ROOM, "--workers", "2", *FORMATS, "--out", str(killed))
    with started(*command, stderr=subprocess.PIPE) as run:
        until(lambda: bool(list(killed.glob("shards/*.json"))) or run.poll() is not None)
        run.kill()
        run.communicate(timeout=GUARD_S)  # until its processes have ended too, and write no more
    (killed / "tables" / "rooms" / "train-000009.parquet.elsewhere.1.part").write_bytes(b"half")
    assert made(killed, *ONE_ROOM, "--workers", "2", *FORMATS) == contents(exported)


@pytest.mark.parametrize(
    ("number", "told", "workers"), [(signal.SIGINT, os.killpg, "2"), (signal.SIGTERM, os.kill, "2"), (signal.SIGTERM, os.kill, "1")]
)
def test_told_to_end_it_ends_with_all_its_processes(
    tmp_path: Path, number: signal.Signals, told: Callable[[int, int], None], workers: str
) -> None:
    """Ctrl-C is told to every process of a terminal's foreground at once, SIGTERM to the command alone."""
    small = ("--width", "4", "--depth", "4", "--shard-size", "1", "--seeds", "0-9999", "--workers", workers)
    command = (sys.executable, "-m", "compose_homes", *SMALL, *small, "--out", str(tmp_path / "set"))
    with started(*command, stderr=subprocess.PIPE) as run:
        until(lambda: bool(list(tmp_path.glob("set/shards/*.json"))) or run.poll() is not None)
        told(run.pid, number)
        _, said = run.communicate(timeout=GUARD_S)  # until all have closed their standard error
    how_far, end = said[: -len(ENDED)], said[-len(ENDED) :]
    assert (run.returncode, end) == (130, ENDED)
    assert not list(tmp_path.rglob("*.part"))
    assert re.fullmatch(r"([\d,]+ of 10,000 \w+\n)*", how_far), "on a busy machine it may have told how far it was"


def test_a_file_that_is_gone_is_made_again(whole: Path, tmp_path: Path) -> None:
    shutil.copytree(whole, tmp_path / "set")
    next((tmp_path / "set" / "tables" / "houses").glob("train-000001*")).unlink()
    assert made(tmp_path / "set", *ONE_ROOM) == contents(whole)


def test_a_set_that_grows_keeps_its_splits_and_its_homes(whole: Path, tmp_path: Path) -> None:
    made(tmp_path / "grown", *ONE_ROOM, "--seeds", "3-9")
    assert made(tmp_path / "grown", *ONE_ROOM, "--seeds", "8-19") == contents(whole)


def test_splits_are_of_the_seed_alone() -> None:
    found = [split_of(seed) for seed in range(20_000)]
    for name, share in SPLITS.items():
        assert abs(found.count(name) / 200 - share) < 0.6


def test_homes_of_something_else_need_another_folder(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    before = made(tmp_path, "--workers", "1", "--seeds", "0-1")
    named = {"--style": "request", "--format": "formats"}
    made_of = {"--style": "rustic", "--formats": "json,csv", "--format": "json,csv", "--shard-size": "7"}
    for option, value in made_of.items():
        assert main([*SMALL, "--out", str(tmp_path), option, value]) == 2
        assert f"holds homes made with {named.get(option, option[2:].replace('-', '_'))}" in capfd.readouterr().err
    manifest = tmp_path / "dataset.json"
    manifest.write_text(manifest.read_text().replace('"version": "', '"version": "9'))
    assert main([*SMALL, "--out", str(tmp_path)]) == 2
    assert "holds homes made with version" in capfd.readouterr().err
    manifest.write_bytes(before["dataset.json"])
    assert contents(tmp_path) == before


def test_a_folder_of_something_else_stays_as_it_is(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "thesis.txt").write_text("mine")
    assert main([*SMALL, "--out", str(tmp_path)]) == 2
    assert "thesis.txt" in capfd.readouterr().err
    (tmp_path / "dataset.json").write_text("{}")
    assert main([*SMALL, "--out", str(tmp_path)]) == 2
    assert "no manifest" in capfd.readouterr().err
    assert sorted(contents(tmp_path)) == ["dataset.json", "thesis.txt"]


def test_where_nothing_can_be_written_is_said(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    assert main([*SMALL, "--out", str(tmp_path / "file" / "set")]) == 2
    assert f"no such folder: {tmp_path / 'file'}" in capfd.readouterr().err


def test_a_full_disk_is_said_and_leaves_nothing_half_written(
    exported: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    write_table = pq.ParquetWriter.write_table

    def on_a_full_disk(table: pq.ParquetWriter, *rows: Any) -> None:
        opened = {name: os.path.realpath(name) for name in Path("/proc/self/fd").iterdir()}
        parts = {name: path for name, path in opened.items() if re.search(r"-000001\.\w+\..*part$", path)}
        if sum(".parquet." in path for path in parts.values()) > 2:  # two tables have rows, and no end yet
            with open("/dev/full", "wb") as disk:
                for name in parts:
                    os.dup2(disk.fileno(), int(name.name))
        write_table(table, *rows)

    monkeypatch.setattr(pq.ParquetWriter, "write_table", on_a_full_disk)
    told: list[object] = []
    monkeypatch.setattr(sys, "unraisablehook", told.append)
    assert main([*SMALL, *ONE_ROOM, *FORMATS, "--out", str(tmp_path / "set")]) == 2
    words = capfd.readouterr().err
    gc.collect()
    assert told == [], "nothing is left open, and written once more as it is thrown away"
    assert "the disk is full" in words and "goes on" in words and "Traceback" not in words
    assert list(tmp_path.rglob("*.part")) == []
    assert {re.sub(r".*-(\d+).*", r"\1", path.name) for path in tmp_path.rglob("*.parquet")} == {"000000"}
    monkeypatch.undo()
    assert made(tmp_path / "set", *ONE_ROOM, *FORMATS) == contents(exported)


def test_homes_that_break_rules_or_cannot_be_are_kept_and_marked(tmp_path: Path) -> None:
    made(tmp_path / "wide", "--workers", "1", "--seeds", "0-3", "--robot-width", "1.6", "--min-room-size", "2", status=1)
    houses = rows(tmp_path / "wide", "houses")
    assert len(houses) == 4 and "errors" in {row["status"] for row in houses}
    for row in houses:
        assert (row["status"] == "errors") == (row["errors"] != 0)
    made(tmp_path / "castle", "--workers", "1", "--seeds", "0-1", "--force-type", "0=castle", status=1)
    for row in rows(tmp_path / "castle", "houses"):
        assert row["status"] == "refused" and "castle" in str(row["refused"]) and row["scene"] is None


def test_a_table_without_rows_is_a_table(tmp_path: Path) -> None:
    made(tmp_path, "--workers", "1", "--seeds", "3-3", "--width", "2", "--depth", "2", "--min-room-size", "2", "--no-people")
    (path,) = (tmp_path / "tables" / "fronts").glob("*.parquet")
    assert pq.read_table(path).to_pylist() == []
    assert pq.read_schema(path).names == SCHEMAS["fronts"].names
    assert len(rows(tmp_path, "rooms")) == 1


def test_the_shards_of_a_range_hold_each_seed_once() -> None:
    from tests.dataset.plans import plan

    for first, last in ((0, 0), (0, 5), (5, 6), (3, 40), (6, 11)):
        shards = plan(6).shards(first, last)
        assert [seed for shard in shards for seed in shard.seeds] == list(range(first, last + 1))
        assert all(shard == Shard(shard.first // 6, shard.first, shard.last) and shard.last // 6 == shard.number for shard in shards)


@pytest.mark.parametrize("job", [ends_always, ends_as_a_thing_goes])
def test_processes_that_always_end_are_said(job: Callable[[int], int], capfd: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(FieldError, match="again and again"):
        list(spread(job, range(4), 2, nothing))
    assert capfd.readouterr().err == ""


@pytest.mark.parametrize("by", [signal.SIGKILL, signal.SIGINT])
def test_what_an_ended_process_was_at_is_done_again(tmp_path: Path, by: signal.Signals) -> None:
    assert list(spread(partial(ends_once, tmp_path, by), range(20), 2, nothing, 2)) == [job * job for job in range(20)]


def test_an_interrupt_at_the_end_of_a_job_ends_its_process() -> None:
    code = (
        "from service import pool\n"
        "class Told(type):\n"
        "    def __setattr__(cls, name, value):\n"
        "        if value is False:\n"
        "            raise KeyboardInterrupt\n"
        "        super().__setattr__(name, value)\n"
        "class Work(metaclass=Told):\n"
        "    make = staticmethod(abs)\n"
        "pool._Work = Work\n"
        "try:\n"
        "    pool._each([-1])\n"
        "except KeyboardInterrupt:\n"
        "    print('taken for an error of the job')\n"
    )
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=GUARD_S)
    assert (ended.returncode, ended.stdout, ended.stderr) == (1, "", "")


def test_a_shard_is_made_without_pandas_and_what_needs_it_later_finds_it(tmp_path: Path) -> None:
    code = (
        "import sys\n"
        "from service.cli import main\n"
        "assert main([*sys.argv[2:], '--out', sys.argv[1], '--workers', '1']) == 0\n"
        "assert 'pandas' not in sys.modules\n"
        "import pyarrow as pa\n"
        "assert pa.table({'a': [1.0, None]}).to_pandas()['a'].isna().sum() == 1\n"
        "import pandas as pd\n"
        "assert pa.array(pd.Series([1.0, None])).null_count == 1\n"
    )
    small = ("dataset", "--width", "6", "--depth", "5", "--seeds", "1-2", "--shard-size", "2")
    subprocess.run([sys.executable, "-c", code, tmp_path / "made", *small], check=True)
