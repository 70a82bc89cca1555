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
    assert total.far <= total.wall_pieces // 20


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
