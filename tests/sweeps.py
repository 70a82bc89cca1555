"""How much of a long sweep a run takes: `make test` every so many cases of it, `make targets` all.

In: SWEEPS in the environment, "all" or nothing. Out: the seeds, pairs, repeats and examples of this run.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from hypothesis import settings

T = TypeVar("T")
Some = TypeVar("Some", range, list[Any], tuple[Any, ...])
One = TypeVar("One")
Other = TypeVar("Other")

ALL = os.environ.get("SWEEPS") == "all"


def seeds(everything: Some, every: int) -> Some:
    """Returns every so many of seeds, or of other cases, from the first; in `make targets`, all of them.

    Where kinds of cases take turns by the number of a seed, `every` has no factor in common with how many kinds there are.
    """
    return everything if ALL else everything[::every]


def pairs(ones: Sequence[One], others: Sequence[Other]) -> list[tuple[One, Other]]:
    """Returns each of the longer list with one of the other, dealt in turn, so that none is left out; in `make targets`, each with each."""
    longest = range(max(len(ones), len(others)))
    dealt = [(ones[at % len(ones)], others[at % len(others)]) for at in longest]
    return [(one, other) for one in ones for other in others] if ALL else dealt


def times(everything: int, some: int) -> int:
    """Returns how often to repeat something: `some` times; in `make targets`, as often as `everything` says."""
    return everything if ALL else some


def examples(some: int) -> Callable[[T], T]:
    """Returns what has Hypothesis draw `some` examples of a costly property; in `make targets`, 25 times as many."""
    return settings(max_examples=times(25 * some, some))
