"""Seeded random streams: one per seed, stage and room, so that changing one stage leaves the others' numbers alone.

SplitMix64 (Steele, Lea, Flood, OOPSLA 2014) started from a BLAKE2b digest of the stream's name. Nothing here depends on
the platform, the process or the order in which streams are made.
"""

from collections.abc import MutableSequence, Sequence
from hashlib import blake2b
from typing import TypeVar

T = TypeVar("T")
_MASK = (1 << 64) - 1
_BEGUN = blake2b(digest_size=8)


class Stream:
    """A stream of random numbers named by (seed, stage, room): the room's index or id, or any finer name; empty for the whole house."""

    def __init__(self, seed: int, stage: str, room: int | str = "") -> None:
        digest = _BEGUN.copy()  # takes a quarter less time than a new one
        digest.update(f"{seed}/{stage}/{room}".encode())
        self.state = int.from_bytes(digest.digest(), "little")
        """Where the stream is: 64 bits; the core's streams go on from here."""

    def bits(self) -> int:
        """Returns the next 64 random bits."""
        self.state = (self.state + 0x9E3779B97F4A7C15) & _MASK
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & _MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & _MASK
        return z ^ (z >> 31)

    def unit(self) -> float:
        """Returns a float in [0, 1)."""
        return (self.bits() >> 11) * 2.0**-53

    def uniform(self, low: float, high: float) -> float:
        """Returns a float in [low, high)."""
        return low + (high - low) * self.unit()

    def below(self, n: int) -> int:
        """Returns an integer in [0, n).

        Raises:
            ValueError: n < 1.
        """
        if n < 1:
            raise ValueError(f"below({n}): needs n >= 1")
        return (self.bits() * n) >> 64

    def chance(self, probability: float) -> bool:
        """Returns True with that probability."""
        return self.unit() < probability

    def pick(self, options: Sequence[T]) -> T:
        """Returns one of the options, each equally likely."""
        return options[self.below(len(options))]

    def shuffle(self, items: MutableSequence[T]) -> None:
        """Permutes the items in place (Fisher-Yates)."""
        for i in range(len(items) - 1, 0, -1):
            j = self.below(i + 1)
            items[i], items[j] = items[j], items[i]
