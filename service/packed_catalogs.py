"""Catalogs on their way to other processes, and what such a process loads before its first home.

Comes in: catalogs. Goes out: bytes, and back. May import: the solver; not the calls, which a process that makes homes never makes.
"""

from __future__ import annotations

import gc
import pickle
from functools import lru_cache
from hashlib import sha256
from typing import Final, cast

from catalogs import Catalogs
from solver.core import load_core


def packed(catalogs: Catalogs) -> bytes:
    """Packs catalogs for the way to a worker."""
    return pickle.dumps(catalogs, pickle.HIGHEST_PROTOCOL)


KNOWN: Final[dict[str, Catalogs]] = {}
"""The last catalogs that were sent to this process, by their mark."""

YOUNG: Final = 50_000
"""Objects made, beyond those gone, until cycles are looked for: a home holds some ten thousand and makes no cycle."""


def mark_of(catalogs: bytes) -> str:
    """Returns a mark of packed catalogs: it is sent in their place, as they are large beside a request."""
    return sha256(catalogs).hexdigest()


@lru_cache(maxsize=1)
def unpacked(catalogs: bytes) -> Catalogs:
    """Unpacks catalogs; those of the last call are kept."""
    found = cast(Catalogs, pickle.loads(catalogs))
    KNOWN.clear()
    KNOWN[mark_of(catalogs)] = found
    return found


def warm(catalogs: bytes) -> None:
    """Does nothing but load what calls need; the collector of cycles leaves that alone from then on."""
    unpacked(catalogs)
    ready()


def ready() -> None:
    """Loads the core; the collector of cycles leaves all that is loaded alone from then on."""
    load_core()
    gc.collect()
    gc.freeze()
    gc.set_threshold(YOUNG)
