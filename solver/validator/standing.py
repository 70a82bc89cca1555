"""The rules for where bodies stand, in words: one function each, a room at a time; found by solver/core/validate/standing.cpp."""

from collections.abc import Iterator
from typing import Final

from solver.validator.judging import Finding, RuleCase
from solver.validator.lattice import exact, words
from solver.validator.sent_openings import openings_on

WALL_REACH: Final = exact(0.2)
"""A piece with a wall is no farther than this from its line,"""
FACE_REACH: Final = exact(0.15)
"""or than this from its face, where the wall is thick."""
_WAYS_OUT: Final = ("to the west", "to the east", "to the north", "to the south", "into a corner that is not part of it")
_TUCKED: Final = 1
"""How the core tells a chair that is too far under its table from other bodies that share space."""


def out_of_bounds(case: RuleCase) -> Iterator[Finding]:
    """A body leaves its room's clear area: the wall lines moved in by half a wall."""
    for told in case.told["out_of_bounds"]:
        name, where = case.name(told.body), f"{_WAYS_OUT[told.other]} by {words(told.amount)}"
        yield Finding((name,), told.amount, f"{name} leaves the clear floor of {case.room.room.id} {where}")


def overlap(case: RuleCase) -> Iterator[Finding]:
    """Two bodies share space; but a chair may be tucked under its table, and a thing may stand on another."""
    for told in case.told["overlap"]:
        one, other = case.name(told.body), case.name(told.other)
        if told.how == _TUCKED:
            room = f"{words(told.a)} of its {words(told.b)} depth, {words(told.amount)} too far to sit down"
            message = f"{one} is tucked under {other} by {room}"
        else:
            size = f"{words(told.a)} from west to east, {words(told.b)} from north to south"
            message = f"{one} and {other} share space: {size}, {words(told.c)} in height"
        yield Finding((one, other), told.amount, message)


def wall_far(case: RuleCase) -> Iterator[Finding]:
    """A piece whose `wall` is set is more than 0.2 m from that wall's line, and more than 0.15 m from its face."""
    most = max(WALL_REACH, case.world.half_wall + FACE_REACH)
    for told in case.told["wall_far"]:
        piece = case.room.room.furniture[told.body]
        where = f"{words(told.a)} from the {piece.wall} wall of {case.room.room.id}"
        yield Finding((piece.id,), told.amount, f"{piece.id} stands {where}, at most {words(most)} is allowed")


def blocks_door(case: RuleCase) -> Iterator[Finding]:
    """A body stands in the square of a door or passage, on either side of it."""
    openings = openings_on(case.world, case.room) if case.told["blocks_door"] else []
    for told in case.told["blocks_door"]:
        name, opening = case.name(told.body), openings[told.other]
        message = f"{name} stands {words(told.amount)} in the way of the {opening.kind} {opening.id} in {case.room.room.id}"
        yield Finding((name,), told.amount, message)


def blocks_window(case: RuleCase) -> Iterator[Finding]:
    """A piece taller than the sill stands within 0.5 m of a window, its width plus 0.1 m each side."""
    for told in case.told["blocks_window"]:
        name, where = case.name(told.body), f"{case.room.holes[told.other].opening.id} of {case.room.room.id}"
        message = f"{name} stands {words(told.amount)} before the window {where} and is {words(told.a)} higher than its sill"
        yield Finding((name,), told.amount, message)


def above_ceiling(case: RuleCase) -> Iterator[Finding]:
    """Furniture or a decoration reaches above the ceiling of its room; outdoors there is none."""
    for told in case.told["above_ceiling"]:
        name, where = case.name(told.body), f"the ceiling of {case.room.room.id}, which is {words(case.room.ceiling)} high"
        yield Finding((name,), told.amount, f"{name} reaches {words(told.amount)} above {where}")
