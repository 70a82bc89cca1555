"""One test of what holds of many things: all of them are tried, and each that fails is named.

A test of its own for each, as pytest's parameters make, costs 2 ms to collect, hand out and report, where what it does takes none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from inspect import signature
from traceback import format_exception
from typing import Any

Test = Callable[..., None]


def every(name: str | tuple[str, ...], values: Iterable[Any]) -> Callable[[Test], Test]:
    """Has a test be done with each of some values of an argument, or of several; the others stay what they are, as fixtures."""
    names = (name,) if isinstance(name, str) else name
    cases = [dict(zip(names, (value,) if isinstance(name, str) else value, strict=True)) for value in values]

    def of_all(test: Test) -> Test:
        def tried(**given: Any) -> None:
            assert cases, f"there is no {name}"
            failed = []
            for case in cases:
                try:
                    test(**given, **case)
                except Exception as error:
                    failed.append(", ".join(f"{key} = {value!r}" for key, value in case.items()) + f"\n{''.join(format_exception(error))}")
            assert not failed, f"{len(failed)} of {len(cases)}:\n" + "\n".join(failed)

        for told in ("__name__", "__qualname__", "__module__", "__doc__"):
            setattr(tried, told, getattr(test, told))
        known = signature(test)
        left = [one for one in known.parameters.values() if one.name not in names]
        tried.__signature__ = known.replace(parameters=left)  # type: ignore[attr-defined]
        return tried

    return of_all
