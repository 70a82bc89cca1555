"""Fronts of homes by the hundred: how far they open, and whether MuJoCo says the same: `python -m tests.targets physics`."""

from __future__ import annotations

import sys
from concurrent.futures import ProcessPoolExecutor
from typing import NamedTuple

from tqdm import tqdm

from catalogs import load_catalogs
from solver.exports import describe
from solver.validator.opening import ENOUGH
from tests.exports.opening import open_all
from tests.exports.physics_targets import decorated
from tests.validator.travels import front_travels

MOST_WHOLLY = 0.9
"""At least so many of all fronts open wholly."""


class FoundFronts(NamedTuple):
    """The fronts of a home: how many, how many open wholly, which do not open half of their way; what MuJoCo says otherwise."""

    fronts: int
    wholly: int
    blocked: tuple[str, ...]
    wrong: tuple[str, ...]


def fronts_home(seed: int) -> FoundFronts:
    """Opens the fronts of a decorated home."""
    scene, catalogs = decorated(seed), load_catalogs()
    travels = [one for several in front_travels(scene, catalogs).values() for one in several]
    blocked = tuple(f"{seed}: {one.piece}/{one.front} by {one.meets}" for one in travels if one.share < ENOUGH)
    wrong = tuple(f"{seed}: {line}" for line in open_all(scene, describe(scene, catalogs), catalogs))
    return FoundFronts(len(travels), sum(one.meets is None for one in travels), blocked, wrong)


def fronts_of_homes(homes: int, workers: int) -> bool:
    """Prints how far the fronts of homes open; returns whether enough do, and MuJoCo agrees."""
    with ProcessPoolExecutor(workers) as pool:
        found = list(tqdm(pool.map(fronts_home, range(homes)), total=homes, desc="fronts", file=sys.stderr))
    fronts, wholly = sum(one.fronts for one in found), sum(one.wholly for one in found)
    blocked = [line for one in found for line in one.blocked]
    wrong = [line for one in found for line in one.wrong]
    print(f"fronts: {homes} homes, {fronts:,} fronts, {wholly / fronts:.1%} open wholly, {len(blocked) / fronts:.1%} less than half")
    print(f"fronts: {sum(not one.wrong for one in found)} homes are in MuJoCo as their certificates say, {len(wrong)} fronts are not")
    for line in wrong[:40]:
        print(f"  {line}")
    return wholly >= MOST_WHOLLY * fronts and not wrong
