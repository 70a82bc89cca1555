"""The core's host: memory, views, calls, failures; what the core is asked elsewhere is tested there."""

from __future__ import annotations

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from solver.core import CoreFailed, CoreInstance, borrowed
from solver.core.host import WASM, _idle, _loaded


def test_the_core_imports_nothing() -> None:
    assert list(_loaded().module.imports) == []


def test_views_show_the_memory_and_keep_it() -> None:
    instance = CoreInstance()
    at, behind = instance.reserve(120), instance.reserve(56)
    first, second = instance.view(at, (3, 5), np.int64), instance.view(behind, (7,), np.float64)
    first[:], second[:] = np.arange(15).reshape(3, 5), 0.25
    base = first.__array_interface__["data"][0]
    assert at % 16 == 0 and instance.read(at, 120) == np.arange(15).tobytes()
    assert behind >= at + 120
    instance.reserve(100 << 20)  # the memory grows
    assert first.__array_interface__["data"][0] == base
    row = first[2]
    del instance, first, second
    assert row.tolist() == [10, 11, 12, 13, 14]


def test_what_is_not_in_the_memory_is_refused() -> None:
    instance = CoreInstance()
    with pytest.raises(ValueError, match="not within"):
        instance.view(instance.size - 8, (2,), np.int64)


def test_bytes_come_back_as_they_were_written() -> None:
    with borrowed() as instance:
        content = bytes(range(256)) * 1000
        assert instance.read(instance.write(content), len(content)) == content


def test_a_trap_is_an_exception_and_ends_the_instance() -> None:
    instance = CoreInstance()
    with pytest.raises(CoreFailed, match="reserve ended in a trap of the core: its memory is full"):
        instance.reserve(1 << 31)
    with pytest.raises(CoreFailed, match="failed before"):
        instance.mark()
    assert CoreInstance().mark() == 0


def test_what_is_not_exported_cannot_be_called() -> None:
    instance = CoreInstance()
    for name, arguments in (("nothing", ()), ("memory", ()), ("failure", (1,))):
        with pytest.raises(CoreFailed, match="no such function"):
            instance.call(name, *arguments)
    assert instance.mark() == 0


def test_a_borrowed_instance_is_lent_again_empty_and_thrown_away_after_a_failure() -> None:
    for instances in _idle.values():
        instances.clear()
    with borrowed() as first:
        first.write(b"something")
    with borrowed() as again:
        assert again is first and again.mark() == 0
    with pytest.raises(CoreFailed), borrowed() as failing:
        failing.reserve(-1)
    with pytest.raises(KeyError), borrowed():
        raise KeyError
    with borrowed() as next_one:
        assert next_one is not failing and next_one.mark() == 0


def test_threads_have_instances_of_their_own() -> None:
    def fill(number: int) -> bool:
        with borrowed() as instance:
            array = instance.view(instance.reserve(160_000), (20_000,), np.int64)
            for k in range(50):
                array[:] = number * 1000 + k
                if not (array == number * 1000 + k).all():
                    return False
        return True

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(fill, range(40)))


def test_the_memory_is_given_back() -> None:
    """Each instance takes address space: many more than could be held at once are made and dropped."""
    for number in range(3000):
        instance = CoreInstance()
        array = instance.view(instance.reserve(8000), (1000,), np.int64)
        array[:] = number
    assert array[-1] == 2999


def test_a_core_that_is_not_built_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("solver.core.host.WASM", WASM.with_name("nothing.wasm"))
    with pytest.raises(CoreFailed, match="make core"):
        _loaded.__wrapped__()


def test_python_ends_quietly_whatever_still_holds_memory_of_the_core() -> None:
    held = "import numpy\nfrom solver.core import CoreInstance\nnumpy.held_until_the_end = CoreInstance()"
    run = subprocess.run([sys.executable, "-c", held], capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout, run.stderr) == (0, "", "")
