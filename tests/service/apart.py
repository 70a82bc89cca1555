"""Runs asynchronous code in a thread of its own: the main one may carry the loop that drives the browser."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import anyio


def run(call: Callable[..., Awaitable[Any]], *arguments: object) -> Any:
    """Returns what the call returns."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(anyio.run, call, *arguments).result()
