"""How much of a long sweep a run takes: `make test` every so many cases of it, `make targets` all.

In: SWEEPS in the environment, "all" or nothing. Out: the seeds, repeats and examples of this run.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import TypeVar

from hypothesis import settings

T = TypeVar("T")

ALL = os.environ.get("SWEEPS") == "all"


def seeds(everything: range, every: int) -> range:
    """Returns every so many of a range of seeds, from its first; of `make targets`, all of them."""
    return everything if ALL else everything[::every]


def times(everything: int, some: int) -> int:
    """Returns how often to repeat something: `some` times; in `make targets`, as often as `everything` says."""
    return everything if ALL else some


def examples(some: int) -> Callable[[T], T]:
    """Returns what has Hypothesis draw `some` examples of a costly property; in `make targets`, ten times as many."""
    return settings(max_examples=times(10 * some, some))
