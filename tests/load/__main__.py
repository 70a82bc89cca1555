"""Loads a service of this machine and says how it stood: `make load`.

    python -m tests.load [--clients 32] [--seconds 60] [--requests 20000] [--abandoned 200] [--dribbling 600]

Each of the four parts has a service of its own, shows how far it is, and prints its line when it ends; 0 leaves a part out, so that each
can be run by itself: `make load LOAD_ARGS='--clients 0 --abandoned 0 --dribbling 0'`.

Exit status 1 where a request is answered by what is not declared, memory grows, or a light call waits behind what
was abandoned. Needs Linux's /proc. Wall-clock figures are this machine's, with all else that it does.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import sys
import time
from collections import Counter
from collections.abc import Awaitable, Callable
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack, suppress
from itertools import count
from multiprocessing import get_context
from pathlib import Path
from typing import Any, Final
from urllib.parse import urlsplit

import httpx2
from tqdm import tqdm

from tests.browser.service_process import ServiceProcess, descendants, running
from tests.load.light_calls import SMALL, light_calls
from tests.service.test_connections import Server

BUSY: Final = (429, 503)
"""What a service that is asked too much may answer."""
MOST_P99_S: Final = 0.02
MOST_VIEW_CPU_S: Final = 0.2
MOST_GROWTH: Final = 0.1
"""By how much of its memory after a quarter of the requests the service may grow until the last."""
SOFAS: Final[dict[str, Any]] = {
    "room": {"id": "den", "width": 10, "depth": 10},
    "pieces": [{"name": "sofa", "count": 64, "relations": [{"type": "near", "of": "sofa"}]}],
    "alternatives": 16,
}
"""As much as a call may ask for."""
SHELF: Final[dict[str, Any]] = {"room": {"width": 3.0, "depth": 3.0}, "pieces": [{"name": "bookshelf"}]}
CHAIR: Final[dict[str, Any]] = {"name": "chair", "x": 0.1, "z": 0.1, "width": 0.5, "depth": 0.5, "height": 0.9}
Ask = Callable[[int], Awaitable[httpx2.Response]]


def quantile(seconds: list[float], share: float) -> float:
    """Returns the time that so great a share of the requests took at most, s."""
    return sorted(seconds)[min(int(share * len(seconds)), len(seconds) - 1)]


def memory(process: int) -> int:
    """Returns the memory of a process and all that it started, bytes: what is shared is counted once."""
    total = 0
    for one in (process, *descendants(process)):
        try:
            lines = Path(f"/proc/{one}/smaps_rollup").read_text().splitlines()
        except OSError:
            continue
        total += sum(int(line.split()[1]) for line in lines if line.startswith("Pss:")) * 1024
    return total


def cpu(process: int) -> float:
    """Returns the CPU that a process has used, without those it started, s."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def mixed(client: httpx2.AsyncClient) -> list[Ask]:
    """Returns the calls of a mixed load."""
    room = {**SMALL["scene"]["rooms"][0], "furniture": [CHAIR, {**CHAIR, "x": 0.3}]}
    return [
        lambda seed: client.post("generate", json={"seed": seed, "width": 7.0, "depth": 6.0}),
        lambda _: client.post("fix", json={"scene": {"rooms": [room]}}),
        lambda _: client.post("place", json=SHELF),
        lambda seed: kept_for_a_moment(client, f"home {seed}"),
        lambda _: client.get("homes?limit=5"),
    ]


async def kept_for_a_moment(client: httpx2.AsyncClient, name: str) -> httpx2.Response:
    """Saves a home and removes it, as a service keeps a bounded number; returns the first answer, or the second that is no success."""
    saved = await client.post("homes", json={**SMALL, "name": name})
    if saved.is_error:
        return saved
    removed = await client.delete(f"homes/{saved.json()['id']}", headers={"If-Match": saved.headers["etag"]})
    return removed if removed.is_error else saved


async def all_at_once(address: str, clients: int, seconds: float) -> Counter[int]:
    """Has clients ask until the time is up; returns how often each status came."""
    ends, statuses, numbers = time.monotonic() + seconds, Counter[int](), count()
    shown = tqdm(disable=None, desc="answers")

    async def ask(first: int) -> None:
        async with httpx2.AsyncClient(base_url=address, timeout=120) as client:
            calls = mixed(client)
            for number in count(first):
                if time.monotonic() > ends:
                    return
                answer = await calls[number % len(calls)](next(numbers))
                statuses[answer.status_code] += 1
                shown.update()
                if answer.status_code in BUSY:
                    await asyncio.sleep(0.1)

    await asyncio.gather(*(ask(number) for number in range(clients)))
    return statuses


async def one_after_another(service: ServiceProcess, requests: int) -> list[int]:
    """Asks so often, by eight clients; returns the service's memory after each quarter, bytes."""
    found = list[int]()
    shown = tqdm(total=requests // 32 * 32, disable=None, desc="requests")
    async with httpx2.AsyncClient(base_url=service.address, timeout=120) as client:

        async def ask(share: int) -> None:
            for _ in range(share):
                (await client.post("validate", json=SMALL)).raise_for_status()
                shown.update()

        for _ in range(4):
            await asyncio.gather(*(ask(requests // 32) for _ in range(8)))
            found.append(memory(service.process.pid))
    return found


async def abandoned(service: ServiceProcess, calls: int) -> tuple[float, float]:
    """Abandons heavy calls; returns the most that an empty /view took meanwhile: the service's own CPU, and by the clock, s."""
    found = [(0.0, 0.0)]

    async def leave(leaver: httpx2.AsyncClient) -> None:
        with suppress(httpx2.TimeoutException):
            await leaver.post("place", json=SOFAS)

    many = httpx2.AsyncClient(base_url=service.address, timeout=0.5, limits=httpx2.Limits(max_connections=None))
    async with httpx2.AsyncClient(base_url=service.address, timeout=120) as client, many:
        leaving = asyncio.gather(*(leave(many) for _ in range(calls)))
        for _ in range(40):
            begun, used = time.perf_counter(), cpu(service.process.pid)
            (await client.post("view", json={"scene": {"rooms": []}})).raise_for_status()
            found.append((cpu(service.process.pid) - used, time.perf_counter() - begun))
        await leaving
    return max(one[0] for one in found), max(one[1] for one in found)


def dribbling(address: str, lines: int) -> int:
    """Opens connections that begin and never end; returns what another is answered meanwhile."""
    with ExitStack() as stack:
        place = urlsplit(address)
        server = Server((place.hostname or "", place.port or 0), stack)
        for _ in range(lines):
            server.line()
        return server.status("/export")


def told_mixed(clients: int, seconds: float) -> bool:
    """Prints what a mixed load met; returns whether all was declared."""
    with running(0) as service, ProcessPoolExecutor(1, get_context("spawn")) as another:
        httpx2.get(f"{service.address}readyz", timeout=120).raise_for_status()
        looking = another.submit(light_calls, service.address, seconds)
        statuses = asyncio.run(all_at_once(service.address, clients, seconds))
        by_light, light = looking.result()
    statuses += by_light
    wrong = sum(number for status, number in statuses.items() if status >= 400 and status not in BUSY)
    p50, p99 = (quantile(light, share) * 1000 for share in (0.5, 0.99))
    print(f"{clients} clients, {seconds} s: {dict(sorted(statuses.items()))}, {wrong} not declared")
    print(f"{len(light)} light calls meanwhile: p50 {p50:.1f} ms, p99 {p99:.1f} ms; wanted {MOST_P99_S * 1000:.0f} ms", flush=True)
    return wrong == 0


def told_abandoned(calls: int) -> bool:
    """Prints what /view took beside calls that were abandoned; returns whether that is little."""
    with running(0, "--client-connections", "0") as service:  # they stand for many clients, and come from one address
        used, waited = asyncio.run(abandoned(service, calls))
    print(f"{calls} abandoned calls: /view took {used:.2f} s of the service's CPU at most, {waited:.2f} s by the clock", flush=True)
    return used <= MOST_VIEW_CPU_S


def told_dribbling(lines: int) -> bool:
    """Prints what others are answered beside connections that dribble; returns whether they are served."""
    with running(0) as service:
        status = dribbling(service.address, lines)
    print(f"{lines} dribbling connections: another is answered by {status}", flush=True)
    return status == 200


def told_memory(requests: int) -> bool:
    """Prints the memory after each quarter of the requests; returns whether it stays."""
    with running(0) as service:
        found = asyncio.run(one_after_another(service, requests))
    print(f"{requests} requests: memory after each quarter {', '.join(f'{one / 2**20:.0f}' for one in found)} MB", flush=True)
    return found[-1] <= found[0] * (1 + MOST_GROWTH)


def main() -> int:
    """Prints the figures and returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, usual in (("clients", 32), ("seconds", 60), ("requests", 20_000), ("abandoned", 200), ("dribbling", 600)):
        parser.add_argument(f"--{name}", type=int, default=usual, help="0 leaves it out" if name != "seconds" else None)
    asked = parser.parse_args()
    parts: list[tuple[int, Callable[[int], bool]]] = [
        (asked.clients, lambda clients: told_mixed(clients, asked.seconds)),
        (asked.abandoned, told_abandoned),
        (asked.dribbling, told_dribbling),
        (asked.requests, told_memory),
    ]
    good = [part(many) for many, part in parts if many]
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
