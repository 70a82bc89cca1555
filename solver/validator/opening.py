"""How far the fronts of furniture open before they meet something; and the rule for those that hardly open.

It is found by the core (solver/core/validate/opening.cpp). Each front is opened alone, all others shut. People and pets step aside, what
lies on a lid is taken off; doors are closed and are walls.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from struct import Struct, pack
from typing import Any, Final, NamedTuple

from solver.body_rows import furniture_ids
from solver.demanded import demand
from solver.validator.judging import Finding, RuleCase
from solver.validator.kinds import KindFronts, Kinds
from solver.validator.shells import ShellRows, shell_of
from solver.validator.walk import OPENED
from solver.validator.world import PlacedRoom, World

WALL: Final = "wall"
"""What a front meets that meets a wall."""
ENOUGH: Final = 0.5
"""A front that opens less of its way than this is blocked."""
FRONT_WORK: Final = 0.35
"""What a front costs for each body of its room [see demanded.py]. Measured."""
_ASKED: Final = Struct("<6q")
_NOTHING: Final = -1
_MILLIONTHS: Final = 1_000_000
_new: Final = tuple.__new__
"""What a named tuple's own constructor calls, in half its time: a home has a hundred fronts."""
Opener = tuple[int, KindFronts]
"""A piece of furniture by its number in its room, and its fronts."""


class FrontTravel(NamedTuple):
    """How far a front opens, of how far it could: degrees, of a drawer m; and what it meets then: an id, `wall`, None for nothing."""

    piece: str
    front: str
    slides: bool
    travel: float
    range: float
    meets: str | None
    must_open: bool = False

    @property
    def share(self) -> float:
        """Which part of its way it opens, 0 to 1; all of it where that is nothing, as of a drawer in what is a hair deep."""
        return self.travel / self.range if self.range else 1.0


def front_blocked(case: RuleCase) -> Iterator[Finding]:
    """A front opens less than half of its way; where its kind says that it must open, that is an error."""
    for one in travels_in(case):
        if one.meets is not None and one.share < ENOUGH:
            ids = (one.piece,) if one.meets == WALL else (one.piece, one.meets)
            yield Finding(ids, 0, f"{one.piece}'s {one.front} {_words(one)}", "error" if one.must_open else None)


def _words(one: FrontTravel) -> str:
    if one.slides:
        how = f"comes out {one.travel * 100:.0f} of {one.range * 100:.0f} cm"
    else:
        how = f"opens {one.travel:.0f} of {one.range:.0f} degrees"
    return f"{how}: then it meets {'a wall' if one.meets == WALL else one.meets}"


def travels_in(case: RuleCase) -> list[FrontTravel]:
    """Returns how far every front of a judged room opens; a home's certificate and its issues ask for the same."""
    if "fronts" not in case.kept:
        case.kept["fronts"] = _travels(case)
    found: list[FrontTravel] = case.kept["fronts"]
    return found


def _travels(case: RuleCase) -> list[FrontTravel]:
    """Returns how far every front of a room opens, in the order of its furniture."""
    place, told, found = case.room, OPENED.iter_unpack(case.judged.opened), list[FrontTravel]()
    names = furniture_ids(place.room) if case.openers else ()
    for body, fronts in case.openers:
        for (name, slides, reach, must_open), (travel, meets) in zip(fronts.each, told, strict=False):
            way, by = (reach, None) if meets == _NOTHING else (travel / _MILLIONTHS, WALL if meets < 0 else place.ids[meets])
            found.append(_new(FrontTravel, (names[body], name, slides, way, reach, by, must_open)))
    return found


def asked_room(world: World, place: PlacedRoom, kinds: Kinds, number: int) -> tuple[bytes, Sequence[Opener]]:
    """Returns a room of that number in its storey, to be judged, as the core reads it; and what of it has fronts.

    Raises:
        TooMuch: the call may not have so much work.
    """
    openers = openers_in(place, kinds)
    if not openers:
        return _ASKED.pack(number, 0, 0, 0, 0, 0), ()
    demand(FRONT_WORK * sum(len(fronts.each) for _, fronts in openers) * place.count_bodies())
    return _front_bytes(openers, shell_of(world, place), number), openers


def _front_bytes(openers: Sequence[Opener], shell: ShellRows, number: int) -> bytes:
    each, numbers, who = list[bytes](), list[bytes](), list[int]()
    count = parts = 0
    for body, fronts in openers:
        each.append(fronts.rows)
        numbers.append(fronts.numbers)
        who += body, len(fronts.each), fronts.parts
        count, parts = count + len(fronts.each), parts + fronts.parts
    head = _ASKED.pack(number, shell.holes, shell.fitted, len(openers), count, parts)
    return b"".join([head, shell.rows, pack(f"<{len(who)}q", *who), *each, *numbers])


def openers_in(place: PlacedRoom, kinds: Kinds) -> list[Opener]:
    """Returns the pieces of a room that have fronts, by their number there."""
    return [(number, fronts) for number, (key, _) in enumerate(place.pieces) if (fronts := kinds.fronts(key)).each]


def certified_fronts(travels: Sequence[FrontTravel]) -> dict[str, dict[str, Any]]:
    """Returns what a certificate says of fronts, by piece and front: 1 for one that opens wholly, else the share and what it meets."""
    said: dict[str, dict[str, Any]] = {}
    for one in travels:
        whole = one.meets is None
        said.setdefault(one.piece, {})[one.front] = 1 if whole else {"opens": round(one.share, 3), "meets": one.meets}
    return said
