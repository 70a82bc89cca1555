"""What others read a dataset with reads ours: pandas, polars, datasets, webdataset, and a loader that reads boxes as ATISS does."""

from __future__ import annotations

import io
import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from service.cli import main
from service.dataset.dataset_plan import SPLITS
from service.dataset.shards import SCHEMAS
from tests.architecture.tree import ROOT

# webdataset leaves the archives it has read for the collector to close.
UNCLOSED = ("ignore::ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning")
pytestmark = [pytest.mark.filterwarnings(words) for words in UNCLOSED]
HOMES = 40


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("datasets") / "set"
    asked = [
        "dataset",
        "--program",
        "studio",
        "--seeds",
        f"0-{HOMES - 1}",
        "--shard-size",
        "20",
        "--workers",
        "1",
        "--formats",
        "json,boxes",
    ]
    assert main([*asked, "--out", str(path)]) == 0
    return path


@pytest.fixture(scope="module")
def manifest(folder: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((folder / "dataset.json").read_text())
    assert set(found["splits"]) == set(SPLITS)
    return found


def test_pandas_and_polars_read_all_rows(folder: Path, manifest: dict[str, Any]) -> None:
    import pandas as pd
    import polars as pl

    for name, count in manifest["rows"].items():
        frame, other = pd.read_parquet(folder / "tables" / name), pl.read_parquet(folder / "tables" / name / "*.parquet")
        assert len(frame) == len(other) == count
        assert list(frame.columns) == other.columns == SCHEMAS[name].names
    areas = pl.scan_parquet(folder / "tables" / "rooms" / "*.parquet").group_by("type").agg(pl.col("area").mean()).collect()
    frame = pd.read_parquet(folder / "tables" / "rooms").groupby("type")["area"].mean()
    assert {row["type"]: row["area"] for row in areas.iter_rows(named=True)} == pytest.approx(frame.to_dict())


def test_datasets_reads_every_table_by_the_card(folder: Path, manifest: dict[str, Any], tmp_path: Path) -> None:
    """In a process of its own: it must not look for a hub."""
    code = (
        "import sys, json, datasets\n"
        "found = {}\n"
        "for name in sys.argv[3:]:\n"
        "    loaded = datasets.load_dataset(sys.argv[1], name, cache_dir=sys.argv[2])\n"
        "    found[name] = {split: rows.num_rows for split, rows in loaded.items()}\n"
        "print(json.dumps([found, loaded['train'].column_names]))"
    )
    offline = {**os.environ, "HF_HUB_OFFLINE": "1", "HF_DATASETS_OFFLINE": "1", "HF_HOME": str(tmp_path)}
    words = [sys.executable, "-c", code, str(folder), str(tmp_path / "cache"), "rooms", "houses"]
    run = subprocess.run(words, capture_output=True, text=True, env=offline, check=False)
    assert run.returncode == 0, run.stderr
    found, columns = json.loads(run.stdout.splitlines()[-1])
    assert found["houses"] == manifest["splits"]
    assert sum(found["rooms"].values()) == manifest["rows"]["rooms"]
    assert columns == SCHEMAS["houses"].names


def samples(folder: Path) -> list[dict[str, Any]]:
    """The homes of all archives as webdataset groups their files."""
    paths = sorted(str(path) for path in (folder / "archives").glob("*.tar"))
    import webdataset as wds

    return list(wds.WebDataset(paths, shardshuffle=False, empty_check=False))


def test_webdataset_reads_a_sample_a_home(folder: Path) -> None:
    found = samples(folder)
    assert sorted(int(one["__key__"]) for one in found) == list(range(HOMES))
    for one in found:
        assert json.loads(one["json"])["seed"] == int(one["__key__"])


def test_a_loader_of_boxes_reads_every_room(folder: Path, manifest: dict[str, Any]) -> None:
    """As ATISS's ThreedFront reads a folder a room: classes one-hot with start and end, half extents, middles, angles."""
    import pandas as pd

    rooms, boxes, widths = 0, 0, set()
    for one in samples(folder):
        archive = zipfile.ZipFile(io.BytesIO(one["boxes.zip"]))
        for name in (name for name in archive.namelist() if name.endswith("boxes.npz")):
            room = np.load(io.BytesIO(archive.read(name)))
            count = len(room["translations"])
            assert room["class_labels"].shape[0] == room["sizes"].shape[0] == room["angles"].shape[0] == count
            assert (room["sizes"] > 0).all() and (room["class_labels"].sum(axis=1) == 1).all()
            widths.add(room["class_labels"].shape[1])
            rooms, boxes = rooms + 1, boxes + count
    assert len(widths) == 1
    frame = pd.read_parquet(folder / "tables" / "pieces")
    assert boxes == (frame["sort"] == "furniture").sum()
    assert 0 < rooms <= manifest["rows"]["rooms"]


def test_a_home_of_several_files_finds_them_where_it_is_unpacked(tmp_path: Path) -> None:
    words = "dataset --program studio --seeds 3-3 --shard-size 1 --workers 1 --formats urdf,sdf"
    assert main([*words.split(), "--out", str(tmp_path / "homes")]) == 0
    (home,) = samples(tmp_path / "homes")
    for format, of in (("urdf", r'filename="([^"]+)"'), ("sdf", r"<uri>([^<]+)</uri>")):
        unpacked = tmp_path / format
        zipfile.ZipFile(io.BytesIO(home[f"{format}.zip"])).extractall(unpacked)
        (world,) = unpacked.glob(f"*.{format}")
        named = set(re.findall(of, world.read_text()))
        assert named and all((unpacked / name).is_file() for name in named)


def test_the_card_says_what_the_manifest_says(folder: Path, manifest: dict[str, Any]) -> None:
    text = (folder / "README.md").read_text()
    _, front, body = text.split("---\n", 2)
    said = yaml.load(front, yaml.CSafeLoader)
    assert (said["license"], said["size_categories"]) == ("mit", ["n<1K"])
    assert {one["config_name"] for one in said["configs"]} == set(SCHEMAS)
    for one in said["configs"]:
        for files in one["data_files"]:
            assert list(folder.glob(files["path"])), files
    assert f"{HOMES} whole homes" in body and manifest["digest"] in body
    for name in re.findall(r"!\[\w+\]\((.*)\)", body):
        assert (folder / name).read_text().startswith("<svg")


def test_the_card_s_command_makes_the_set_again(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    command = re.findall(r"^compose (dataset .*)$", (folder / "README.md").read_text(), re.MULTILINE)[0].split()
    (tmp_path / "made_from").symlink_to(folder / "made_from")
    monkeypatch.chdir(tmp_path)
    assert main([*command, "--workers", "1"]) == 0
    assert json.loads((tmp_path / "homes" / "dataset.json").read_text()) == json.loads((folder / "dataset.json").read_text())


def test_the_example_learns_what_rooms_are(folder: Path) -> None:
    words = [sys.executable, str(ROOT / "docs" / "examples" / "room_types.py"), str(folder)]
    said = subprocess.run(words, capture_output=True, text=True, check=True).stdout
    shares = [tuple(map(float, found)) for found in re.findall(r"rooms, ([\d.]+) % known; ([\d.]+) %", said)]
    assert len(shares) == 3
    assert all(known > 90 > commonest for known, commonest in shares)
