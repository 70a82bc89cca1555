"""Catalogs on their way to other processes, and what such a process loads before its first home.

Imports none of the calls, which a process that makes homes never makes.
"""

import gc
import pickle
from functools import lru_cache
from hashlib import sha256
from typing import Final, cast

from catalogs import Catalogs
from service.effort import YOUNG

KNOWN: Final[dict[str, Catalogs]] = {}
"""The last catalogs that this process packed or was sent, by their mark."""

KEPT: Final = 8
"""How many of them."""


def packed(catalogs: Catalogs) -> bytes:
    """Packs catalogs for the way to a worker."""
    content = pickle.dumps(catalogs, pickle.HIGHEST_PROTOCOL)
    _keep(mark_of(content), catalogs)
    return content


@lru_cache(maxsize=KEPT)
def mark_of(catalogs: bytes) -> str:
    """Returns a mark of packed catalogs: it is sent in their place, as they are large beside a request."""
    return sha256(catalogs).hexdigest()


def unpacked(catalogs: bytes) -> Catalogs:
    """Unpacks catalogs; where this process packed or unpacked them of late, the very same.

    What is worked out from catalogs is kept by them: it is found at once for the same ones, and by comparing all they hold for equal ones.
    """
    mark = mark_of(catalogs)
    if mark not in KNOWN:
        _keep(mark, cast(Catalogs, pickle.loads(catalogs)))
    return KNOWN[mark]


def _keep(mark: str, catalogs: Catalogs) -> None:
    KNOWN.pop(mark, None)
    KNOWN[mark] = catalogs
    if len(KNOWN) > KEPT:
        del KNOWN[next(iter(KNOWN))]


def warm(catalogs: bytes) -> None:
    """Does nothing but load what calls need; the collector of cycles leaves that alone from then on."""
    from solver.core import load_core  # noqa: PLC0415 - the service itself makes no calls

    unpacked(catalogs)
    load_core()
    gc.collect()
    gc.freeze()
    gc.set_threshold(YOUNG)
