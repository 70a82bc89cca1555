"""What the worst of many hostile requests costs, in seconds of CPU: `make hostile`.

    python -m tests.hostile [--requests 20000] [--first 0] [--workers 2] [--seconds 1e9] [--texts 5000] [--wire 6000] [--kept FILE]

Each is made as the service makes it, in a process of its own with bounded memory, at normal effort; after MOST_PATIENCE_S of CPU it is
ended. With --kept each cost is written to that file as it is found, a line of JSON, and requests that it holds are not made again: what
was stopped goes on where it was. Prints the ten that cost most; exit status 1 where one costs more than MOST_CPU_S, is answered by a fault
of ours, or kills its process. Needs a system with interval timers: Linux or macOS.
"""

from __future__ import annotations

import argparse
import json
import signal
import sys
import time
from collections.abc import Generator, Iterable
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import ExitStack, closing
from functools import cache
from itertools import islice
from pathlib import Path
from typing import NamedTuple, TextIO

from starlette.responses import Response
from tqdm import tqdm

from catalogs import load_catalogs
from service.packed_catalogs import mark_of, packed, warm
from service.work import Job, do_alone
from tests.browser.service_process import running
from tests.hostile.requests import hostile
from tests.hostile.texts import faults
from tests.hostile.wire_cases import SHORT, wire_faults

MOST_CPU_S = 5.0
MOST_PATIENCE_S = 60.0
SHOWN = 10
SLICE = 16
"""Requests that are handed to the processes at once: when a process ends amid them, those without an answer are made one by one."""
ENDED = 0
"""The status of a request that ended its process."""


class Cost(NamedTuple):
    """What a request cost: seconds of CPU, its seed, its family, its bytes, the answer's status (500 for a fault) and bytes."""

    cpu_s: float
    seed: int
    family: str
    asked: int
    status: int
    answered: int


@cache
def known() -> bytes:
    """Returns our catalogs, packed."""
    return packed(load_catalogs())


def cost(seed: int) -> Cost:
    """Makes the call of a seed and returns what it cost."""
    sent = hostile(seed)
    wanted = sent.family if sent.call == "export" else "json"
    signal.setitimer(signal.ITIMER_PROF, MOST_PATIENCE_S)
    begun = time.process_time()
    done = do_alone(Job(sent.call, sent.body, "json", wanted, mark_of(known())))
    cpu_s = time.process_time() - begun
    signal.setitimer(signal.ITIMER_PROF, 0)
    status, size = (done.status_code, len(done.body)) if isinstance(done, Response) else (500, 0)
    return Cost(round(cpu_s, 3), seed, sent.family, len(sent.body), status, size)


def costs(seeds: Iterable[int], workers: int, seconds: float) -> Generator[Cost]:
    """Yields what the requests cost, each as it is known, until the time is up."""
    ends, left = time.monotonic() + seconds, iter(seeds)
    with ExitStack() as stack:
        pool = stack.enter_context(_pool(workers))
        while time.monotonic() < ends and (slice_ := list(islice(left, SLICE))):
            answered = set[int]()
            try:
                for one in pool.map(cost, slice_):
                    answered.add(one.seed)
                    yield one
            except BrokenProcessPool:
                yield from (_alone(seed) for seed in slice_ if seed not in answered)
                pool = stack.enter_context(_pool(workers))


def _pool(workers: int) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(workers, initializer=warm, initargs=(known(),))


def _alone(seed: int) -> Cost:
    """Returns what a request costs in a pool of its own; a process that it ends counts as all the patience there is."""
    with _pool(1) as pool:
        try:
            return pool.submit(cost, seed).result()
        except BrokenProcessPool:
            sent = hostile(seed)
            return Cost(MOST_PATIENCE_S, seed, sent.family, len(sent.body), ENDED, 0)


def found_before(kept: TextIO | None) -> list[Cost]:
    """Returns the costs that a file holds; a line that was cut off is left out, and the file ends before it."""
    found = list[Cost]()
    if kept is None:
        return found
    kept.seek(0)
    whole = [line for line in kept.read().splitlines(keepends=True) if line.endswith("\n")]
    found = [Cost(*json.loads(line)) for line in whole]
    kept.truncate(len("".join(whole).encode()))
    return found


def told(found: list[Cost]) -> bool:
    """Prints the table; returns whether no request is a fault or costs too much."""
    worst = sorted(found, reverse=True)
    bad = [one for one in found if one.status in (500, ENDED)]
    dear = [one for one in worst if one.cpu_s > MOST_CPU_S]
    print(f"{len(found)} requests, {len(bad)} faults, {len(dear)} above {MOST_CPU_S:.0f} s, {sum(one.cpu_s for one in found):.0f} s of CPU")
    print("| CPU s | request | bytes | status | bytes answered |\n|---|---|---|---|---|")
    for one in worst[:SHOWN]:
        print(f"| {one.cpu_s:.2f} | {one.family} {one.seed} | {one.asked:,} | {one.status} | {one.answered:,} |")
    for one in bad:
        print(f"FAULT: {one.family} {one.seed}")
    return not (bad or dear)


def main() -> int:
    """Prints the table and returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--requests", type=int, default=20_000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=1e9)
    parser.add_argument("--texts", type=int, default=5000, help="spoilt texts of each format")
    parser.add_argument("--wire", type=int, default=6000, help="requests that are spoilt on the wire")
    parser.add_argument("--kept", type=Path, help="where each cost is written, and read from again")
    options = parser.parse_args()
    asked = range(options.first, options.first + options.requests)
    with ExitStack() as stack:
        kept = stack.enter_context(options.kept.open("a+", encoding="utf-8")) if options.kept else None
        found = [one for one in found_before(kept) if one.seed in asked]
        before = {one.seed for one in found}
        one_by_one = stack.enter_context(closing(costs((seed for seed in asked if seed not in before), options.workers, options.seconds)))
        for one in tqdm(one_by_one, total=len(asked), initial=len(found), disable=None):
            found.append(one)
            if kept:
                print(json.dumps(one), file=kept, flush=True)
    good = told(found)
    wrong = [line for format in ("json", "yaml") for line in tqdm(faults(range(options.texts), format), disable=None)]
    print(f"{2 * options.texts} spoilt texts, {len(wrong)} faults", *wrong, sep="\n")
    with running(0, *SHORT) as service:
        taken = wire_faults(service, range(options.wire))
    print(f"{options.wire} requests spoilt on the wire, {len(taken)} faults", *taken, sep="\n")
    return int(bool(wrong or taken) or not good)


if __name__ == "__main__":
    sys.exit(main())
