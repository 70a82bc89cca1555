"""The rule `floating`: a decoration lies on something, or hangs at its wall; furniture stands `on` what it says.

It is found by the core (solver/core/validate/floating.cpp). A parent of a kind and size that the catalogs know carries things on its
surfaces, each as far in from its edges as the kind says, and inside, on the boards of its carcass and in its drawers. Any other parent is
what its sizes say: it carries on all of its top, and at the heights that the catalogs know for its name. A thing without a parent, or whose
parent is not in the room, lies on the floor or on any of the room's bodies. Furniture that says `on` what it stands is judged like a thing
with that parent; of other furniture nothing is said: a cupboard may hang.
"""

from collections.abc import Iterator

from solver.scene import Decoration
from solver.validator.judging import Finding, RuleCase, Told
from solver.validator.lattice import words

_FLOATS, _IN_A_CIRCLE, _NO_SUCH_WALL = 0, 1, 2
"""How the core tells what floats."""


def floating(case: RuleCase) -> Iterator[Finding]:
    """A body's middle is not over a surface of what carries it at its height, or a decoration hangs at no wall."""
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
