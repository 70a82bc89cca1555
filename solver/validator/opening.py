"""How far the fronts of furniture open before they meet something; and the rule for those that hardly open.

It is found by the core (solver/core/validate/opening.cpp). Each front is opened alone, all others shut. People and pets step aside, what
lies on a lid is taken off; doors are closed and are walls.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Final, NamedTuple

from solver.body_rows import furniture_ids
from solver.validator.judging import Finding, RuleCase
from solver.validator.walk import OPENED

WALL: Final = "wall"
"""What a front meets that meets a wall."""
ENOUGH: Final = 0.5
"""A front that opens less of its way than this is blocked."""
_NOTHING: Final = -1
_MILLIONTHS: Final = 1_000_000
_new: Final = tuple.__new__
"""What a named tuple's own constructor calls, in half its time: a home has a hundred fronts."""


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
    place, found = case.room, list[FrontTravel]()
    names = furniture_ids(place.room) if case.judged.opened else ()
    for travel, meets, body, front, _ in OPENED.iter_unpack(case.judged.opened):
        name, slides, reach, must_open = case.kinds.fronts(place.pieces[body][0]).each[front]
        way, by = (reach, None) if meets == _NOTHING else (travel / _MILLIONTHS, WALL if meets < 0 else place.ids[meets])
        found.append(_new(FrontTravel, (names[body], name, slides, way, reach, by, must_open)))
    return found


def certified_fronts(travels: Sequence[FrontTravel]) -> dict[str, dict[str, Any]]:
    """Returns what a certificate says of fronts, by piece and front: 1 for one that opens wholly, else the share and what it meets."""
    said: dict[str, dict[str, Any]] = {}
    for one in travels:
        whole = one.meets is None
        said.setdefault(one.piece, {})[one.front] = 1 if whole else {"opens": round(one.share, 3), "meets": one.meets}
    return said
