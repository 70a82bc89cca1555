"""The rules for where bodies stand and lie, in words: one function each, a room at a time.

They are found in solver/core/validate, by standing.cpp, crossing.cpp and floating.cpp.
"""

from collections.abc import Iterator
from typing import Final

from solver.scene import Decoration
from solver.validator.judging import Finding, RuleCase, Told
from solver.validator.lattice import words
from solver.validator.sent_rooms import openings_on

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
    for told in case.told["wall_far"]:
        piece = case.room.room.furniture[told.body]
        where = f"{words(told.a)} from the {piece.wall} wall of {case.room.room.id}"
        yield Finding((piece.id,), told.amount, f"{piece.id} stands {where}, at most {words(told.a - told.amount)} is allowed")


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


def shapes_cross(case: RuleCase) -> Iterator[Finding]:
    """A part of a body is more than 2 mm deep in a part of another.

    Where both stand on the floor and neither is under or on the other, `overlap` speaks of them. Bodies of kinds without a shape are passed
    over: what they are made of is not known.
    """
    found: list[Finding] = []
    for told in case.told["shapes_cross"]:
        first, second = sorted((case.name(told.body), case.name(told.other)))
        message = f"{first} and {second} cross: a part of one is {words(told.amount)} deep in a part of the other"
        found.append(Finding((first, second), told.amount, message))
    yield from sorted(found)


_FLOATS, _IN_A_CIRCLE, _NO_SUCH_WALL = 0, 1, 2
"""How the core tells what floats."""


def floating(case: RuleCase) -> Iterator[Finding]:
    """A body's middle is not over a surface of what carries it at its height, or a decoration hangs at no wall.

    A parent of a kind and size that the catalogs know carries things on its surfaces, each as far in from its edges as the kind says. Any
    other parent is what its sizes say: it carries on all of its top, and at the heights that the catalogs know for its name, as they are
    and as much higher as it is. Both carry inside, on the boards of the carcass and in the drawers that their kind's shape has at their
    size. A thing without a parent, or whose parent is not in the room, lies on the floor or on any of the room's bodies. Furniture that
    says `on` what it stands is judged like a thing with that parent; of other furniture nothing is said: a cupboard may hang.
    """
    for told in case.told["floating"]:
        name = case.name(told.body)
        yield Finding((name,), told.amount, f"{name} {_what_is_wrong(case, told)}")


def _what_is_wrong(case: RuleCase, told: Told) -> str:
    thing, room = case.room.bodies[told.body], case.room.room.id
    if told.how == _FLOATS:
        own = "its parent " if isinstance(thing, Decoration) else ""
        below = f"{own}{case.name(told.other)}" if told.other >= 0 else "anything"
        how = f"{words(told.b)} above or below" if told.b >= told.a else f"with its middle {words(told.a)} beside"
        return f"floats {how} what could carry it on {below}"
    if told.how == _IN_A_CIRCLE:
        how = "its own parent" if told.other == told.body else f"on {case.name(told.other)}, and that on {thing.id} in the end"
        return f"is {how}: nothing carries it"
    assert isinstance(thing, Decoration)
    if told.how == _NO_SUCH_WALL:
        return f"hangs at the {thing.mounted_on_wall} wall, which {room} does not have"
    return f"floats {words(told.amount)} from the face of the {thing.mounted_on_wall} wall of {room}"
