"""How far the fronts of furniture open before they meet something; and the rule for those that hardly open.

It is found by the core (solver/core/validate/opening.cpp). Each front is opened alone, all others shut. People and pets step aside, what
lies on a lid is taken off; doors are closed and are walls.
"""

from collections.abc import Iterator, Sequence
from struct import Struct
from typing import Any, Final, NamedTuple

from solver.body_rows import furniture_ids
from solver.validator.judging import Finding, RuleCase
from solver.validator.kinds import KindFront

WALL: Final = "wall"
"""What a front meets that meets a wall."""
ENOUGH: Final = 0.5
"""A front that opens less of its way than this is blocked."""
_OPENED: Final = Struct("<q3i4x")
_Opened = tuple[int, int, int, int]
"""How far a front opens as the core tells it, millionths, what it meets then, of which body it is, and which of its fronts."""
_NOTHING: Final = -1
_MILLIONTHS: Final = 1_000_000


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
    """Fronts of a piece open less than half of their way; where its kind says that one must open, that is an error."""
    blocked: dict[tuple[str, bool], list[FrontTravel]] = {}
    for told in _opened(case):
        if told[1] != _NOTHING and (one := _travel(case, told)).share < ENOUGH:
            blocked.setdefault((one.piece, one.must_open), []).append(one)
    for (piece, must_open), fronts in blocked.items():
        met = dict.fromkeys(one.meets for one in fronts if one.meets is not None and one.meets != WALL)
        yield Finding((piece, *met), 0, _words(fronts), "error" if must_open else None)


def _words(fronts: Sequence[FrontTravel]) -> str:
    """Says how far a front opens; of several the one that opens least."""
    one = min(fronts, key=lambda front: front.share)
    far = f"{one.travel * 100:.0f} of {one.range * 100:.0f} cm" if one.slides else f"{one.travel:.0f} of {one.range:.0f} degrees"
    then = f"{far}: then it meets {'a wall' if one.meets == WALL else one.meets}"
    if len(fronts) > 1:
        return f"{len(fronts)} fronts of {one.piece} open less than half, the {one.front} {then}"
    return f"{one.piece}'s {one.front} {'comes out' if one.slides else 'opens'} {then}"


def _opened(case: RuleCase) -> Iterator[_Opened]:
    """Yields what is told of the fronts of a judged room, in the order of its furniture."""
    return _OPENED.iter_unpack(case.judged.opened)


def _travel(case: RuleCase, told: _Opened) -> FrontTravel:
    travel, meets, body, number = told
    name, slides, reach, must_open = case.kinds.fronts[case.room.keys[body]].each[number]
    way, by = (reach, None) if meets == _NOTHING else (travel / _MILLIONTHS, WALL if meets < 0 else case.name(meets))
    return FrontTravel(case.name(body), name, slides, way, reach, by, must_open)


def travels_in(case: RuleCase) -> list[FrontTravel]:
    """Returns how far every front of a judged room opens."""
    return [_travel(case, told) for told in _opened(case)]


def certified_fronts(case: RuleCase) -> dict[str, dict[str, Any]]:
    """Returns what a certificate says of a room's fronts, by piece and front: 1 where it opens wholly, else the share and what it meets."""
    said: dict[str, dict[str, Any]] = {}
    names, keys, kinds = furniture_ids(case.room.room), case.room.keys, case.kinds.fronts
    before, fronts, own = -1, tuple[KindFront, ...](), dict[str, Any]()
    for told in _opened(case):
        _, meets, body, number = told
        if body != before:
            before, fronts, own = body, kinds[keys[body]].each, said.setdefault(names[body], {})
        own[fronts[number][0]] = 1 if meets == _NOTHING else _certified(_travel(case, told))
    return said


def _certified(one: FrontTravel) -> dict[str, Any]:
    return {"opens": round(one.share, 3), "meets": one.meets}
