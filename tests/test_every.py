"""A test that is done with every value of an argument tries all, names each that fails, and fails where there is none."""

from __future__ import annotations

from inspect import signature

import pytest

from tests.every import every


def test_each_that_fails_is_named_and_all_are_tried() -> None:
    tried = []

    @every("size", [3, 4])
    @every(("number", "word"), [(1, "one"), (2, "two")])
    def small(number: int, word: str, size: int, given: str) -> None:
        tried.append((number, word, size, given))
        assert number * size < 6, "too large"

    assert list(signature(small).parameters) == ["given"]
    with pytest.raises(AssertionError) as caught:
        small(given="a fixture")
    assert tried == [(1, "one", 3, "a fixture"), (2, "two", 3, "a fixture"), (1, "one", 4, "a fixture"), (2, "two", 4, "a fixture")]
    told = str(caught.value)
    assert told.startswith("2 of 2:\n") and told.count("1 of 2:\n") == told.count("number = 2, word = 'two'\n") == 2
    assert "size = 3\n" in told and "size = 4\n" in told and "too large" in told and "number = 1" not in told


def test_nothing_to_try_is_a_failure() -> None:
    @every("number", [])
    def never(number: int) -> None:
        raise ValueError(number)

    with pytest.raises(AssertionError, match="there is no number"):
        never()
