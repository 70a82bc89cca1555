"""The rules about rooms, in words: what their types require, whether somebody comes to them and their pieces, whether the plan is one.

What is wrong is found by the core (solver/core/validate). For the rules about the plan (`rooms_overlap`, `opening_wrong`) bodies are not
looked at, and nothing is moved.
"""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Final

from catalogs.entries import Use
from catalogs.schema import RoomType
from solver.body_rows import furniture_names
from solver.geometry import LEAST_FLOOR_MM2, OPPOSITE
from solver.scene import WALLS, Furniture, Opening
from solver.validator.judging import Finding, RuleCase, Told
from solver.validator.lattice import PER_METRE, exact, words
from solver.validator.walk import Walk
from solver.validator.world import PlacedRoom, World, side_of

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


LEAST_FLOOR: Final = LEAST_FLOOR_MM2 * (PER_METRE // 1000) ** 2
"""How much of a room's free centres must be reached, in square lattice steps."""


def unreachable(case: RuleCase) -> Iterator[Finding]:
    """The robot's square cannot come to the room, or to a piece's use side. In a room it cannot come to, pieces go unsaid."""
    world, walk, place = case.world, case.walk, case.room
    if walk.floor(place) < LEAST_FLOOR:
        yield Finding((), world.robot, _room_message(world, walk, place))
        return
    missed = walk.missed[place.room.id]
    for number in (number for number, touched in enumerate(missed) if touched) if any(missed) else ():
        piece, use = place.room.furniture[number], case.kinds.uses[place.keys[number]]
        assert use is not None, "what is not used misses nothing"
        yield Finding((piece.id,), world.robot, _side_message(world, piece, use, missed[number]))


def _room_message(world: World, walk: Walk, place: PlacedRoom) -> str:
    wide = f"somebody {words(world.robot)} wide"
    ways = ", ".join(dict.fromkeys(hole.opening.id for hole in walk.entrances))
    if walk.floor(place, only_entered=False) < LEAST_FLOOR:
        return f"{place.room.id} has less than 0.25 m2 where {wide} can stand"
    openings = (*place.holes, *(hole for _, hole in world.leading_to.get(place.room.id, ())))
    if all(hole.opening.kind == "window" for hole in openings):
        return f"{place.room.id} has no door or passage{_behind(world, place)}"
    if walk.entrances and not walk.comes_in:
        return f"{wide} cannot get in through {ways}, so not to {place.room.id}"
    return f"{wide} cannot get to {place.room.id} from {ways or 'the largest free floor'}"


def _behind(world: World, place: PlacedRoom) -> str:
    """Says which room could be come from through a wall: where the most wall is shared, and somebody fits through."""
    shared = [
        (min(own.end, edge.end) - max(own.start, edge.start), own.side, other.room.id)
        for own in (edge.moved(place.x, place.z) for edge in place.edges)
        for other, edge in world.walls_along.get((place.room.level, OPPOSITE[own.side], own.line), ())
        if other is not place
    ]
    length, wall, room = max(shared, key=lambda one: one[0], default=(0, "", ""))
    return f"; it shares {words(length)} of its {wall} wall with {room}" if length >= world.robot else ""


def _side_message(world: World, piece: Furniture, use: Use, touched: int) -> str:
    """Says which use sides cannot be come to; of `touched` the bits of walls are those that its sides which can be look to."""
    joined, looks_to = " and its " if use.need == "all" else " or its ", {side: side_of(piece.rotation, side) for side in use.sides}
    sides = joined.join(f"{side} ({wall})" for side, wall in looks_to.items() if not touched >> WALLS.index(wall) & 1)
    return f"somebody {words(world.robot)} wide cannot get to {piece.id}'s {sides}"


_UNKNOWN: Final = "no reason is recorded"
_EMPTY: Final = "nothing stands in the room yet"
_AS_SENT: Final = "its furniture came with the scene as it is"
"""No certificate tells of the room: a plan's file, or a person, furnished it, or nobody did."""
_NEVER_TRIED: Final = "it was not asked for, or was taken away"
"""The certificate tells of the room what was left out, and not this."""


def missing_required(case: RuleCase) -> Iterator[Finding]:
    """A required piece is not there; the reason is what the scene's certificate gives, or that it tells nothing of the room."""
    place = case.room
    known = case.kinds.rooms.get(place.room.type)
    if known is None or not known.requires:
        return
    there = furniture_names(place.room)
    for line in known.requires:
        if any(there.count(name) >= count for name, count in line.items()):
            continue
        wanted = " or ".join(name if count == 1 else f"{count} {name}" for name, count in line.items())
        reason = _reason(case.world.scene.certificate, place, _labels(known, line))
        have = sum(map(there.count, line))
        short = f"has only {have} of {wanted}" if have else f"has no {wanted}"
        yield Finding((), 0, f"{place.room.id} ({place.room.type}) {short}: {reason}")


def _labels(known: RoomType | None, names: Mapping[str, int]) -> set[str]:
    """Returns under which labels of the room type a requirement may have been left out."""
    pieces = known.pieces if known else ()
    of_these = {piece.piece for piece in pieces if any(variant.kind in names for variant in piece.variants)}
    return of_these | set(names)


def _reason(certificate: Mapping[str, Any] | None, place: PlacedRoom, labels: set[str]) -> str:
    """Finds why a piece was left out, whatever shape the certificate of a foreign scene has."""
    rooms = (certificate or {}).get("rooms")
    entry = rooms.get(place.room.id) if isinstance(rooms, Mapping) else None
    if entry is None:
        return _AS_SENT if place.room.furniture else _EMPTY
    left_out = entry.get("left_out") if isinstance(entry, Mapping) else None
    if not isinstance(left_out, (list, tuple)) or not all(isinstance(item, Mapping) for item in left_out):
        return _UNKNOWN
    of_these = [item for item in left_out if _stem(item.get("piece")) in labels]
    if not of_these:
        return _NEVER_TRIED
    return next((str(item["reason"]) for item in of_these if item.get("reason")), _UNKNOWN)


def _stem(label: object) -> str:
    """Takes the number off a label: `bed_1` was wanted as `bed`."""
    head, _, tail = str(label).rpartition("_")
    return head if head and tail.isdigit() else str(label)
