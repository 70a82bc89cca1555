"""The rules about the plan itself: rooms that share floor, openings that are in no wall, or in another's way.

They are found by the core (solver/core/validate/plan.cpp). Bodies are not looked at, and nothing is moved for these rules.
"""

from collections.abc import Iterable, Iterator

from solver.scene import Opening
from solver.validator.judging import Finding, RuleCase, Told
from solver.validator.lattice import exact, words

_LEAVES_WALL, _LEADS_NOWHERE, _FACES_ROOM, _MISSES_ROOM, _MEETS, _REACHES_ABOVE = range(6)
"""How the core tells what is wrong with an opening."""
_STANDS = exact(0.3)
"""Floor that is less wide is shared by rooms drawn a little inaccurately, and hardly any furniture stands on it."""


def rooms_overlap(case: RuleCase) -> Iterator[Finding]:
    """The clear floors of two rooms of a storey share floor; told of the one listed first."""
    for told in case.told["rooms_overlap"]:
        other = case.walk.places[told.other].room
        size = f"{words(told.a)} from west to east, {words(told.b)} from north to south"
        yield Finding((), told.amount, f"{case.room.room.id} and {other.id} are rooms that share floor: {size}")


def sharing_floor(cases: Iterable[RuleCase]) -> dict[str, str]:
    """Returns the rooms that share floor with another one on which furniture could stand, and with which.

    Rooms that both begin at 0, 0 were given no place in a plan: they share none.
    """
    found: dict[str, str] = {}
    for case in cases:
        for told in case.told["rooms_overlap"]:
            one, other = case.room.room, case.walk.places[told.other].room
            if told.amount < _STANDS or (one.x, one.z) == (other.x, other.z) == (0, 0):
                continue
            found.setdefault(one.id, other.id)
            found.setdefault(other.id, one.id)
    return found


def opening_wrong(case: RuleCase) -> Iterator[Finding]:
    """An opening is not wholly in a wall, does not lead where it says, or meets another of its room; of each the first that is wrong.

    What both its rooms list wrongly is told once, of the room listed first.
    """
    there: dict[str, set[tuple[str, str | None]]] = {}
    for opening, amount, before, after in _wrong(case):
        rooms, other = case.room.room.id, case.others.get(opening.connects_to or "")
        if other is not None and other is not case:
            name = other.room.room.id
            if name not in there:
                there[name] = {(one.id, one.connects_to) for one, *_ in _wrong(other)}
            if (opening.id, rooms) in there[name]:
                if next(one for one in case.world.places if one is case.room or one is other.room) is other.room:
                    continue
                rooms = f"{rooms} and {name}"
        yield Finding((), amount, f"the {opening.kind} {opening.id} {before} {rooms}{after}")


def _wrong(case: RuleCase) -> Iterator[tuple[Opening, int, str, str]]:
    """Yields what is wrong with the openings that a room lists: by how much, and how, before and after the room's name."""
    holes, placed = case.room.holes, 0
    for opening in case.room.room.openings:  # the holes come in this order; of a room read anew they are the old one's
        if placed < len(holes) and holes[placed].opening == opening:
            placed += 1
        else:
            yield opening, 0, "is in no wall of", ""
    for told in case.told["opening_wrong"]:
        yield holes[told.body].opening, told.amount, "of", f" {_how(case, holes[told.body].opening, told)}"


def _how(case: RuleCase, opening: Opening, told: Told) -> str:
    amount = words(told.amount)
    if told.how == _LEADS_NOWHERE:
        return f"leads to {opening.connects_to}, which is no room of the scene"
    if told.how == _FACES_ROOM:
        return f"leads outside, but {case.walk.places[told.other].room.id} lies behind {amount} of it"
    if told.how == _MISSES_ROOM:
        return f"leads to {opening.connects_to}, whose wall is missing behind {amount} of it"
    if told.how == _MEETS:
        other = case.room.holes[told.other].opening
        return f"and the {other.kind} {other.id} share {amount} of its wall"
    ceiling = words(case.room.ceiling)
    return f"reaches {amount} beyond its wall" if told.how == _LEAVES_WALL else f"reaches {amount} above its wall, which is {ceiling} high"
