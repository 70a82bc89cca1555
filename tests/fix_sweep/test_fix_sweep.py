"""`/fix` on generated homes with pieces thrown about: what was valid a moment ago is never called impossible, and nearly always found."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from tests.fix_sweep.judge import faults
from tests.fix_sweep.ruler import Tally, measured
from tests.fix_sweep.thrown import PRESETS, WAYS, thrown
from tests.sweeps import seeds

SEEDS = seeds(range(60), 6)


@pytest.mark.parametrize("way", WAYS)
def test_what_was_thrown_is_put_back(way: str) -> None:
    presets, total = list(PRESETS), Tally()
    for seed in SEEDS:
        total.add(measured("report", (way, presets[seed % len(presets)], seed, False)))
    assert (total.impossible, total.wrong) == (0, 0), total.lines
    assert total.clean >= total.homes - 1, total.lines
    assert total.far <= max(1, total.wall_pieces // 20)  # a slice of the seeds holds few


def test_the_judge_sees_what_was_thrown() -> None:
    seen = 0
    for seed in SEEDS:
        case, uses = thrown("3", "family", seed), load_catalogs().use_sides()
        before = next(room for room in case.home.rooms if room.id == case.room)
        after = next(room for room in case.scene.rooms if room.id == case.room)
        assert faults(case.home, before, uses) == []
        seen += bool(faults(case.scene, after, uses))
        assert faults(case.home, replace(before, furniture=before.furniture * 2), uses)
    assert seen >= len(SEEDS) // 2


@pytest.mark.parametrize("way", WAYS)
def test_what_is_turned_too_is_explained_with_what_helps_and_removed_where_asked(way: str) -> None:
    presets, total, removed = list(PRESETS), Tally(), Tally()
    for seed in SEEDS:
        job = (way, presets[seed % len(presets)], seed, True)
        total.add(measured("report", job))
        removed.add(measured("remove", job))
    assert (total.hopeless, total.wrong, removed.wrong) == (0, 0, 0), total.lines
    assert removed.clean == removed.homes, removed.lines
    assert total.clean >= total.homes - 2
