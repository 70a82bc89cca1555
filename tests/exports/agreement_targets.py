"""Every format of homes by the hundred, and what they say of half of them held against the description: `python -m tests.targets agree`."""

from __future__ import annotations

import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from typing import NamedTuple

from tqdm import tqdm

from catalogs import load_catalogs
from solver.export_formats import EXPORTERS
from solver.exports import ExportSettings, describe, written_as
from tests.exports.agreement import NOT_READ, differences, reader_of
from tests.exports.physics_targets import decorated

COMPARED_EVERY = 2
"""Of so many homes one is read back: that takes ten times as long as to write it."""


class Agreed(NamedTuple):
    """What became of one home: its bodies, formats written, formats read back, and what was wrong."""

    bodies: int
    written: int
    read: int
    wrong: list[str]


def agreed_home(seed: int) -> Agreed:
    """Writes a decorated home in every format, and reads some homes back."""
    model = describe(decorated(seed), load_catalogs())
    wrong: list[str] = []
    counts: Counter[str] = Counter()
    for format in EXPORTERS:
        try:
            files = written_as(model, ExportSettings(format))
            counts["written"] += 1
            if seed % COMPARED_EVERY == 0 and format not in NOT_READ:
                wrong += differences(model, reader_of(format)(files), format)
                counts["read"] += 1
        except Exception as error:
            wrong.append(f"{format}: {type(error).__name__}: {error}")
    return Agreed(len(model.bodies), counts["written"], counts["read"], [f"seed {seed}: {word}" for word in wrong])


def formats_agree(homes: int, workers: int) -> bool:
    """Prints how many files of how many homes were written and agree; returns whether all were and do."""
    with ProcessPoolExecutor(workers) as pool:
        found = list(tqdm(pool.map(agreed_home, range(homes)), total=homes, desc="agree", file=sys.stderr))
    wrong = [word for one in found for word in one.wrong]
    written, read = sum(one.written for one in found), sum(one.read for one in found)
    print(f"{homes} homes, {sum(one.bodies for one in found)} bodies, {len(EXPORTERS)} formats: {written} written, {read} read back")
    print(f"{len(wrong)} findings (counts, ids, places and sizes to 1 mm, turns to 0.1 degree, masses)")
    for line in wrong[:20]:
        print(f"  {line}")
    return not wrong
