"""The placement core against its yardsticks: `make bench`.

    python -m tests.bench [--rooms 400] [--closed 100] [--houses 20] [--seconds 15] [--workers 2]

Prints one table with targets met or missed. Times are CPU times and only printed; the exit status is 1 where an answer is
wrong: a verdict, an optimum, or a result that breaks its own rules.
"""

from __future__ import annotations

import argparse
import platform
import statistics
import sys
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from importlib.metadata import version

from tqdm import tqdm

from tests.bench.measure import Found, Measured, against_optimum, house, measure
from tests.oracles.optimum import Optimum, scip_version

GAP = 1e-5
PROVEN_SHARE = 0.99
HOUSE_MS = 0.5
ROOM_P99_MS = 1.0
RATIO = 1000
Line = tuple[str, str, str, bool | None]
"""What, figure, target, whether met (None: no target)."""


def gap(ours: float, theirs: float) -> float:
    """Returns how far two optima are apart: absolute below 1, relative above; 0 where both say there is none."""
    return 0.0 if ours == theirs else abs(ours - theirs) / max(1.0, min(ours, theirs))


def percentile(values: Sequence[float], share: float) -> float:
    """Returns the value that this share of the values does not exceed."""
    return sorted(values)[min(int(share * len(values)), len(values) - 1)]


def verdict_lines(rooms: Sequence[Measured]) -> list[Line]:
    """Lines on verdicts, proofs, CPU and soundness."""
    closed = [room for room in rooms if room.verdict is not None]
    agreed = [room for room in closed if room.verdict == room.ours.found]
    proven = sum(room.ours.proven for room in rooms) / len(rooms)
    sound = sum(room.ours.sound for room in rooms)
    times = [1000 * room.cpu for room in rooms]
    p99 = percentile(times, 0.99)
    standing, choices = sum(room.ours.found for room in rooms), statistics.median(room.choices for room in rooms)
    return [
        ("rooms; with an answer; choices, median", f"{len(rooms)}; {standing}; {choices:.0f}", "", None),
        ("verdict = HiGHS, of the rooms it closes", f"{len(agreed)} of {len(closed)}", "all", len(agreed) == len(closed)),
        ("results that hold every rule and cost what they say", f"{sound} of {len(rooms)}", "all", sound == len(rooms)),
        ("proven", f"{100 * proven:.2f} %", ">= 99 %", proven >= PROVEN_SHARE),
        ("CPU a room, median", f"{statistics.median(times):.4f} ms", "", None),
        ("CPU a room, p99", f"{p99:.3f} ms", "<= 1 ms", p99 <= ROOM_P99_MS),
    ]


def guess_lines(rooms: Sequence[Measured]) -> list[Line]:
    """Lines on what OSQP with heuristics makes of the same rooms."""
    standing = [room for room in rooms if room.ours.found]
    guessed = [room for room in standing if room.guess.found]
    dearer = [room.guess.cost / max(room.ours.cost, 1e-9) - 1 for room in guessed if room.guess.cost > room.ours.cost + GAP]
    worse = f"{len(dearer)}, by {100 * statistics.median(dearer):.0f} % (median)" if dearer else "0"
    whole = statistics.median(room.guess.cpu / room.cpu for room in standing)
    inside = statistics.median(room.guess.osqp_cpu / room.cpu for room in standing)
    lost = f"{len(guessed)} of {len(standing)} = {100 * len(guessed) / len(standing):.0f} %"
    return [
        ("OSQP with heuristics: rooms found", lost, "", None),
        ("OSQP with heuristics: of these dearer", f"{worse} of {len(guessed)}", "", None),
        ("OSQP with heuristics: CPU, times ours (median)", f"{whole:.1f}; OSQP alone {inside:.1f}", "", None),
    ]


def optimum_lines(pairs: Sequence[tuple[Found, float, Optimum]]) -> list[Line]:
    """Lines on cost and speed against SCIP."""
    closed = [(ours, cpu, theirs) for ours, cpu, theirs in pairs if theirs.closed]
    both = [(ours, theirs) for ours, _, theirs in closed if ours.proven]
    worst = max((gap(ours.cost, theirs.cost) for ours, theirs in both), default=0.0)
    beaten = sum(theirs.cost < ours.cost - GAP for ours, _, theirs in pairs if not theirs.closed and ours.proven)
    ratio = statistics.median(theirs.cpu / cpu for _, cpu, theirs in pairs)
    standing = [theirs.cpu / cpu for ours, cpu, theirs in pairs if ours.found]
    share = f"{ratio:,.0f}" + (f"; where there is an answer {statistics.median(standing):,.0f}" if standing else "")
    return [
        ("SCIP closes", f"{len(closed)} of {len(pairs)}", "", None),
        ("cost gap to SCIP where both prove, max", f"{worst:.1e} in {len(both)} rooms", "<= 1e-5", worst <= GAP),
        ("proven, yet SCIP found something cheaper", f"{beaten}", "0", beaten == 0),
        ("SCIP's CPU, times ours (median)", share, ">= 1000", ratio >= RATIO),
    ]


def house_lines(houses: Sequence[tuple[float, int]]) -> list[Line]:
    """Lines on whole houses."""
    times = [1000 * cpu for cpu, _ in houses]
    median = statistics.median(times)
    pieces = statistics.median(pieces for _, pieces in houses)
    return [
        ("CPU a house, search with choices, median", f"{median:.3f} ms", "<= 0.5 ms", median <= HOUSE_MS),
        ("houses; their pieces, median", f"{len(houses)}; {pieces:.0f}", "", None),
    ]


def printed(lines: Sequence[Line]) -> None:
    """Prints the table and what it was made with."""
    versions = ", ".join(f"{name} {version(name)}" for name in ("numpy", "wasmtime", "osqp", "daqp"))
    print(f"python {platform.python_version()}, {versions}, HiGHS of scipy {version('scipy')}, SCIP {scip_version()} (pyscipopt)\n")
    print("| what | figure | target | |\n|---|---|---|---|")
    for what, figure, target, met in lines:
        print(f"| {what} | {figure} | {target} | {'' if met is None else 'met' if met else 'MISSED'} |")


def main() -> int:
    """Runs the measurements asked for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rooms", type=int, default=400, help="seeds 0 ... of the rooms for verdicts and times")
    parser.add_argument("--closed", type=int, default=100, help="how many of them SCIP solves too")
    parser.add_argument("--houses", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=15.0, help="SCIP's time limit a room")
    parser.add_argument("--workers", type=int, default=2)
    asked = parser.parse_args()
    with ProcessPoolExecutor(asked.workers) as pool:
        rooms = list(tqdm(pool.map(measure, range(asked.rooms), chunksize=4), "rooms", asked.rooms, file=sys.stderr))
        jobs = [(seed, asked.seconds) for seed in range(asked.closed)]
        pairs = list(tqdm(pool.map(against_optimum, jobs), "SCIP", asked.closed, file=sys.stderr))
        houses = list(tqdm(pool.map(house, range(asked.houses)), "houses", asked.houses, file=sys.stderr))
    print(f"seeds 0-{asked.rooms - 1} (SCIP 0-{asked.closed - 1}, {asked.seconds:g} s; houses 0-{asked.houses - 1}); ", end="")
    answers = [*verdict_lines(rooms), *optimum_lines(pairs)]
    printed([*answers, *house_lines(houses), *guess_lines(rooms)])
    wrong = ("verdict", "results", "cost gap", "proven, yet")
    return int(any(met is False for what, _, _, met in answers if what.startswith(wrong)))


if __name__ == "__main__":
    sys.exit(main())
