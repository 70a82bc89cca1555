"""How much of a long sweep a run takes: `make test` every so many cases of it, `make targets` all.

In: SWEEPS in the environment, "all" or nothing. Out: the seeds, pairs, repeats and examples of this run.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from math import gcd
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
    """Returns each of the longer list with one of the other, dealt in turn, so that none is left out; in `make targets`, each with each.

    Where the lengths have a common factor each round of the shorter list begins one further on, and so do rounds of rounds: kinds that take
    turns in the longer one, as many as a factor of both or a power of it, would else meet the same of the shorter always.
    """
    longest, shifted = max(len(ones), len(others)), gcd(len(ones), len(others)) > 1
    dealt = [(_in_turn(ones, at, shifted), _in_turn(others, at, shifted)) for at in range(longest)]
    return [(one, other) for one in ones for other in others] if ALL else dealt


def _in_turn(members: Sequence[T], at: int, shifted: bool) -> T:
    rounds = range(at.bit_length() if shifted else 1)
    return members[sum(at // len(members) ** power for power in rounds) % len(members)]


def times(everything: int, some: int) -> int:
    """Returns how often to repeat something: `some` times; in `make targets`, as often as `everything` says."""
    return everything if ALL else some


def examples(some: int) -> Callable[[T], T]:
    """Returns what has Hypothesis draw `some` examples of a costly property; in `make targets`, 25 times as many."""
    return settings(max_examples=times(25 * some, some))
