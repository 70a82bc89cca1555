"""What Python asks of the core while something is made, to be asked again of the same core.wasm elsewhere: Node, Chromium.

Comes in: a block. Goes out: bytes that `web/tests/replay.js` reads, in whole numbers of 32 bits, little-endian:

    1, instance, first, count, words...                     words that Python wrote to the memory of an instance
    2, instance, length of the name, name, arguments, results, floats..., memory, changed, [first, count]..., sum
                                                            a call: doubles in and out, the memory's size, which words it changed, and what
                                                            they add up to, each multiplied by the odd number of its place
    3, instance                                             a new instance under that number

The names are padded to whole words.
"""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from unittest import mock

import numpy as np
from numpy.typing import NDArray
from wasmtime import Memory

from solver.core import host

WROTE, CALLED, BEGAN = 1, 2, 3
NEAR = 8
"""Changed words that have fewer unchanged ones between them are told as one run."""
MIXER = 2654435761
"""Each place's number is its index times this, made odd; Knuth's multiplier."""

Words = NDArray[np.uint32]


def sum_of(words: Words) -> int:
    """What words add up to, modulo 2^32, each times the odd number of its place."""
    places = (np.arange(len(words), dtype=np.uint64) * MIXER).astype(np.uint32) | np.uint32(1)
    return int((words * places).sum(dtype=np.uint32))


def runs_of(changed: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First index and length of each run of changed words."""
    where = np.flatnonzero(changed)
    if not len(where):
        return []
    ends = np.flatnonzero(np.diff(where) > NEAR)
    firsts, lasts = where[np.r_[0, ends + 1]], where[np.r_[ends, len(where) - 1]]
    return [(int(first), int(last - first + 1)) for first, last in zip(firsts, lasts, strict=True)]


class Recorder:
    """Writes down what is asked of instances; those of before the recording are not used in it."""

    def __init__(self) -> None:
        self.parts: list[bytes] = []
        self.calls = 0
        self._numbers: dict[int, int] = {}
        self._seen: dict[int, Words] = {}
        self._kept: list[Any] = []  # so that no two instances are one number

    def _words(self, instance: host.CoreInstance) -> Words:
        memory = instance._found["memory"]  # asked itself: an instance that begins does not know its size yet
        assert isinstance(memory, Memory)
        size = memory.data_len(instance._store)
        return np.ctypeslib.as_array(ctypes.cast(instance._base, ctypes.POINTER(ctypes.c_uint32)), (size // 4,))

    def _add(self, *numbers: int) -> None:
        self.parts.append(struct.pack(f"<{len(numbers)}I", *numbers))

    def _number(self, instance: host.CoreInstance) -> int:
        if id(instance) not in self._numbers:
            self._numbers[id(instance)] = len(self._numbers)
            self._kept.append(instance)
            self._seen[id(instance)] = self._words(instance).copy()
            self._add(BEGAN, self._numbers[id(instance)])
        return self._numbers[id(instance)]

    def before(self, instance: host.CoreInstance) -> None:
        """Tells what Python wrote since the last call."""
        number, words, seen = self._number(instance), self._words(instance), self._seen[id(instance)]
        for first, count in runs_of(words != seen):
            self._add(WROTE, number, first, count)
            self.parts.append(words[first : first + count].tobytes())
            seen[first : first + count] = words[first : first + count]

    def after(self, instance: host.CoreInstance, name: str, arguments: tuple[float, ...], result: float | None) -> None:
        """Tells a call and what it did."""
        words, seen = self._words(instance), self._seen[id(instance)]
        if len(seen) < len(words):
            seen = self._seen[id(instance)] = np.concatenate([seen, np.zeros(len(words) - len(seen), np.uint32)])
        runs = runs_of(words != seen)
        total = 0
        for first, count in runs:
            total = (total * MIXER + sum_of(words[first : first + count])) % 2**32
            seen[first : first + count] = words[first : first + count]
        padded = name.encode().ljust(-(-len(name) // 4) * 4, b"\0")
        floats = [float(value) for value in arguments] + ([] if result is None else [float(result)])
        self._add(CALLED, self._number(instance), len(padded))
        self.parts.append(padded)
        self._add(len(arguments), 0 if result is None else 1)
        self.parts.append(struct.pack(f"<{len(floats)}d", *floats))
        self._add(len(words), len(runs), *(number for run in runs for number in run), total)
        self.calls += 1

    @property
    def content(self) -> bytes:
        """All that was written down."""
        return b"".join(self.parts)


@contextmanager
def recorded() -> Iterator[Recorder]:
    """Records all calls of a block."""
    recorder, call = Recorder(), host.CoreInstance.call

    def told(instance: host.CoreInstance, name: str, *arguments: float) -> Any:
        recorder.before(instance)
        result = call(instance, name, *arguments)
        recorder.after(instance, name, arguments, result)
        return result

    for idle in host._idle.values():
        idle.clear()
    with mock.patch.object(host.CoreInstance, "call", told):
        yield recorder
    for idle in host._idle.values():
        idle.clear()
