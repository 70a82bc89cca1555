"""Light calls beside a load, made by a process that does nothing else: one that makes the load, too, would time how busy it is itself."""

from __future__ import annotations

import time
from collections import Counter
from typing import Any, Final

import httpx2

SMALL: Final[dict[str, Any]] = {"scene": {"rooms": [{"id": "den", "type": "office", "width": 4.0, "depth": 3.0}]}}
PAUSE_S: Final = 0.05


def light_calls(address: str, seconds: float) -> tuple[Counter[int], list[float]]:
    """Asks for /healthz and /view in turns until the time is up; returns how often each status came, and what each call took, s."""
    ends, statuses, took = time.monotonic() + seconds, Counter[int](), list[float]()
    with httpx2.Client(base_url=address, timeout=120) as client:
        while time.monotonic() < ends:
            for path in ("healthz", "view"):
                begun = time.perf_counter()
                answer = client.post("view", json=SMALL) if path == "view" else client.get(path)
                took.append(time.perf_counter() - begun)
                statuses[answer.status_code] += 1
            time.sleep(PAUSE_S)
    return statuses, took
