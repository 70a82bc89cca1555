"""Requests that differ: weights hold over many seeds, a home is made again from its row alone, wrong files are refused by their key."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

from catalogs import load_catalogs
from service.cli import main
from service.dataset.dataset_plan import check_names, varied
from solver.errors import FieldError
from solver.exchange import load_text
from tests.sweeps import seeds

VARY = """
program: {studio: 3, one_bed: 1}
style: {rustic: 1, null: 1}
outline: {rectangle: 1, L: 1}
area: {from: 40, to: 60, step: 10}
decorate: {true: 1, false: 1}
people: {null: 1, false: 1}
access: {null: 3, din_18040_2: 1}
robot_width:
- {value: 0.5, weight: 2}
- {value: 0.6}
catalog: {ours: 1, catalogs/example: 1}
"""


def test_values_are_drawn_by_their_weights() -> None:
    requests = varied({"decorate": True}, load_text(VARY.encode(), "yaml"))
    drawn = [requests.drawn(seed) for seed in range(4000)]
    shares = Counter(request["program"] for request, _ in drawn)
    assert abs(shares["studio"] / 4000 - 0.75) < 0.03
    assert Counter(request["area"] for request, _ in drawn).keys() == {40.0, 50.0, 60.0}
    assert abs(Counter(request["robot_width"] for request, _ in drawn)[0.5] / 4000 - 2 / 3) < 0.03
    assert abs(sum("style" not in request for request, _ in drawn) / 4000 - 0.5) < 0.03
    assert abs(sum(request.get("people") is False for request, _ in drawn) / 4000 - 0.5) < 0.03
    assert abs(sum("access" in request for request, _ in drawn) / 4000 - 0.25) < 0.03
    assert {catalog for _, catalog in drawn} == {"ours", "catalogs/example"} == set(requests.catalogs)


def test_another_key_changes_nothing_that_others_drew() -> None:
    document: Any = load_text(VARY.encode(), "yaml")
    less = {key: value for key, value in document.items() if key != "area"}
    for seed in range(200):
        (with_area, catalog), without = varied({}, document).drawn(seed), varied({}, less).drawn(seed)
        assert ({key: value for key, value in with_area.items() if key != "area"}, catalog) == without


@pytest.mark.parametrize(
    ("document", "field"),
    [
        ([], "vary"),
        ({"colour": {"red": 1}}, "vary.colour"),
        ({"seed": {1: 1}}, "vary.seed"),
        ({"style": "rustic"}, "vary.style"),
        ({"style": {"rustic": -1}}, "vary.style"),
        ({"style": {"rustic": 0}}, "vary.style"),
        ({"style": {"rustic": "much"}}, "vary.style.rustic"),
        ({"style": {}}, "vary.style"),
        ({"area": {"from": 60, "to": 40}}, "vary.area"),
        ({"area": {"from": 60, "to": 80, "step": 0}}, "vary.area"),
        ({"area": {"from": 2, "to": 40}}, "vary.area"),
        ({"robot_width": {"wide": 1}}, "vary.robot_width"),
        ({"catalog": {3: 1}}, "vary.catalog"),
    ],
)
def test_what_is_wrong_is_said_by_its_key(document: object, field: str) -> None:
    with pytest.raises(FieldError) as found:
        varied({}, document)
    assert found.value.field == field


@pytest.mark.parametrize(
    ("options", "document", "words"),
    [
        ((), {"program": {"studio": 1, "stuido": 1}}, "vary.program: 'stuido' is in none of the catalogs"),
        ((), {"style": {"rustic": 1, "rural": 1}}, "vary.style: 'rural'"),
        ((), {"access": {"none": 1, "din": 1}}, "vary.access: 'din'"),
        (("--program", "musician"), {}, "program: 'musician'"),
        (("--style", "rural"), {}, "style: 'rural'"),
    ],
)
def test_names_that_no_catalog_knows_are_refused_before_any_home_is_made(
    options: tuple[str, ...], document: object, words: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "vary.json").write_text(json.dumps(document))
    folder = tmp_path / "set"
    assert main(["dataset", "--seeds", "0-9", "--vary", str(tmp_path / "vary.json"), "--out", str(folder), *options]) == 2
    assert words in capfd.readouterr().err and not folder.exists()
    plan_words = {"program": {"musician": 1}, "catalog": {"ours": 1, "catalogs/example": 1}}
    check_names(varied({}, plan_words), [load_catalogs(), load_catalogs("catalogs/example")])


def test_a_home_is_made_again_from_its_row_alone(tmp_path: Path) -> None:
    (tmp_path / "vary.yaml").write_text(VARY)
    folder = tmp_path / "set"
    asked = ["dataset", "--seeds", "40-48", "--vary", str(tmp_path / "vary.yaml"), "--workers", "1", "--out", str(folder)]
    assert main(asked) in (0, 1)
    rows = [row for path in (folder / "tables" / "houses").glob("*") for row in pq.read_table(path).to_pylist()]
    assert len(rows) == 9 and len({row["program"] for row in rows}) == 2 and len({row["catalog"] for row in rows}) == 2
    assert {row["people"] for row in rows if '"people":false' in row["request"]} == {0} and max(row["people"] for row in rows) > 0
    for row in seeds(rows, 4):
        if row["scene"] is not None:
            again = ["dataset", "make", str(folder), "--seed", str(row["seed"]), "-o", str(tmp_path / "home.json")]
            assert main(again) == (row["status"] != "clean")
            assert (tmp_path / "home.json").read_bytes() == row["scene"].encode()
    assert main(["dataset", "check", str(folder), "--all"]) == 0
    assert main(["dataset", "make", str(folder), "--seed", "99"]) == 2
