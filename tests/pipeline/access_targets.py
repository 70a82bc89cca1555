"""How many homes made for a profile of access are certified by the judge, which shares no code with what makes them. `targets access`.

In: how many seeds. Out: a table, and whether the targets are met.
"""

from __future__ import annotations

import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import cache
from typing import Final

from tqdm import tqdm

from catalogs import load_catalogs
from solver import Request, generate
from solver.validator import access_of

FIRST_SEED: Final = 500_000
PRESETS: Final = ("studio", "one_bed", "family", "large")
TARGETS: Final = {(preset, "din_18040_2"): 1.0 if preset == "family" else 0.9 for preset in PRESETS} | {
    (preset, profile): 0.98 if preset == "family" else 0.9 for preset in PRESETS for profile in ("din_18040_2_r", "ada")
}
"""Least shares of homes that are certified, their outline free."""
_load = cache(load_catalogs)


@dataclass
class _Certified:
    """What homes of a preset show: how many there are, are certified, have errors; rooms without proof; pieces; ms; why not."""

    homes: int = 0
    met: int = 0
    errors: int = 0
    unproven: int = 0
    rooms: int = 0
    pieces: int = 0
    cpu_ms: float = 0.0
    short: Counter[str] = field(default_factory=Counter)

    def add(self, other: _Certified) -> None:
        """Adds another tally to this one."""
        for name in ("homes", "met", "errors", "unproven", "rooms", "pieces", "cpu_ms", "short"):
            setattr(self, name, getattr(self, name) + getattr(other, name))


def certified_home(case: tuple[str, str | None, int]) -> _Certified:
    """Makes a decorated home of a preset for a profile and judges it."""
    preset, profile, seed = case
    start = time.process_time()
    made = generate(Request(seed=seed, program=preset, access=profile, decorate=True), catalogs=_load())
    spent = (time.process_time() - start) * 1000
    errors = sum(issue.severity == "error" for issue in made.issues)
    unproven = sum(not room["proven"] for room in (made.scene.certificate or {}).get("rooms", {}).values())  # type: ignore[attr-defined]
    unmet = access_of(made.scene, profile, _load()).unmet if profile else ()
    types = {room.id: room.type for room in made.scene.rooms}
    short = Counter({f"{one.what} in {types[one.room]}": 1 for one in unmet})
    pieces = sum(len(room.furniture) for room in made.scene.rooms)
    return _Certified(1, int(not unmet), errors, unproven, len(types), pieces, spent, short)


def accessible_homes(seeds: int, workers: int) -> bool:
    """Prints which homes are certified; returns whether as many are as wanted, and none has an error."""
    print(
        "| profile | preset | certified | errors | rooms without proof | pieces a home | CPU ms a home | short, in homes |",
        "|---|" + "---|" * 7,
        sep="\n",
    )
    good = True
    for profile in (None, *_load().access):
        for preset in PRESETS:
            total, cases = _Certified(), [(preset, profile, FIRST_SEED + seed) for seed in range(seeds)]
            with ProcessPoolExecutor(workers) as pool:
                for one in tqdm(pool.map(certified_home, cases, chunksize=4), total=seeds, desc=f"{profile} {preset}"):
                    total.add(one)
            why = ", ".join(f"{words} {count}" for words, count in total.short.most_common(3))
            each = f"{total.errors} | {total.unproven} of {total.rooms} | {total.pieces / seeds:.1f} | {total.cpu_ms / seeds:.0f} | {why} |"
            print(f"| {profile or 'none'} | {preset} | {f'{total.met} of {seeds}' if profile else '-'} | {each}")
            good &= total.errors == 0 and total.met >= TARGETS.get((preset, profile or ""), 0.0) * seeds
    return good
