"""A bounded slice of the floor plan's targets; `python -m tests.floorplan.targets` measures them in full."""

from __future__ import annotations

from statistics import median

import pytest

from catalogs import load_catalogs
from tests.floorplan.targets import PLAIN_ROOMS, floorplan_table, measure
from tests.sweeps import times

SEEDS = times(25, 11)


@pytest.mark.parametrize("request_of", sorted(PLAIN_ROOMS), ids=str)
def test_spine_targets(request_of: tuple[int, int, float]) -> None:
    width, depth, least = request_of
    row, line = measure("slice", SEEDS, load_catalogs(), width=width, depth=depth, min_room_size=least)
    aspects = sorted(row.aspects)
    assert row.violating == 0, line
    assert row.faults == 0, line
    assert median(row.rooms) >= 0.75 * PLAIN_ROOMS[request_of], line
    assert aspects[int(0.95 * (len(aspects) - 1))] <= 2.0, line
    assert aspects[-1] <= 2.5, line
    assert median(row.hallways) <= 0.15, line
    assert row.dark <= 0.15 * sum(row.rooms), line
    assert not row.notes, line


@pytest.mark.parametrize("option", [{"use_spine": False}, {"outdoor": True}], ids=str)
def test_option_targets(option: dict[str, bool]) -> None:
    row, line = measure("slice", SEEDS, load_catalogs(), **option)
    assert row.faults == 0, line
    assert row.violating == 0 or row.notes, line


def test_plain_houses_are_varied() -> None:
    row, line = measure("slice", SEEDS, load_catalogs())
    each = {name: count / SEEDS for name, count in row.types.items()}
    assert each["bathroom"] <= 4, line
    assert sum(each.get(name, 0) for name in ("bedroom", "bedroom_master", "kids_bedroom")) <= 7, line
    assert each["kitchen"] == 1, line
    assert {"dining_room", "office", "workshop", "bedroom", "kids_bedroom"} <= set(each), line


def test_the_table_has_a_line_for_every_request() -> None:
    table = floorplan_table(2)
    assert len(table.splitlines()) == 2 + len(PLAIN_ROOMS) + 2
    assert "| 0 of 2 |" in table
