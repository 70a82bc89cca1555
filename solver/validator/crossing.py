"""The rule for shapes: no part of one body is in a part of another.

It is found by the core (solver/core/validate/crossing.cpp). Where both bodies stand on the floor and neither is under or on the other,
`overlap` speaks of them. Bodies of kinds without a shape are passed over: what they are made of is not known.
"""

from collections.abc import Iterator

from solver.validator.judging import Finding, RuleCase
from solver.validator.lattice import words


def shapes_cross(case: RuleCase) -> Iterator[Finding]:
    """A part of a body is more than 2 mm deep in a part of another."""
    found: list[Finding] = []
    for told in case.told["shapes_cross"]:
        first, second = sorted((case.name(told.body), case.name(told.other)))
        message = f"{first} and {second} cross: a part of one is {words(told.amount)} deep in a part of the other"
        found.append(Finding((first, second), told.amount, message))
    yield from sorted(found)
