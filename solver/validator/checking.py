"""What is wrong with a scene; and with one that is being changed, where only what a change can touch is checked again.

Not here: the rules.

Where bodies and people alone differ, the rooms that do not hold them keep their issues, but for what is within reach: that is
walked anew for the storey, as a thing in one room may close the way to another. Where walls or openings differ, all is checked.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Final

from catalogs import Catalogs, load_catalogs
from solver.answers import Issue
from solver.demanded import demand, still_allowed
from solver.scene import Room, Scene
from solver.understanding import understood
from solver.validator.judging import FINDING_WORK, RuleCase
from solver.validator.kinds import Kinds, kinds_of
from solver.validator.rules import CHECKS, UNJUDGED, homeless, issues_of
from solver.validator.sent_rooms import NumberedKinds, room_bytes
from solver.validator.walk import ANY_NUMBER, judged_storey, storeys
from solver.validator.world import AnyBody, PlacedRoom, World, world_of

_OF_THE_CERTIFICATE = "missing_required"
"""The one rule that reads what is no room: the reasons that the certificate gives."""

ROOM_WORK: Final = 150
"""What judging a room counts; measured."""


@dataclass(frozen=True)
class _Judged:
    """A room as it was checked, and its issues by those rules that it breaks."""

    case: RuleCase
    issues: Mapping[str, tuple[Issue, ...]]


@dataclass(frozen=True)
class Checked:
    """A scene and its issues, in the order of `validate`; none with severity `error`: the scene is clean."""

    scene: Scene
    issues: tuple[Issue, ...]
    _kinds: Kinds
    _judged: tuple[_Judged, ...]

    @cached_property
    def errors(self) -> tuple[Issue, ...]:
        """The issues that must not be."""
        return tuple(issue for issue in self.issues if issue.severity == "error")

    @property
    def cases(self) -> tuple[RuleCase, ...]:
        """The rooms as they were judged."""
        return tuple(one.case for one in self._judged)

    def after(self, scene: Scene) -> Checked:
        """Returns the changed scene with its issues; checks again only what the change can have touched."""
        if scene is self.scene:
            return self
        return _checked(scene, self._kinds, self._judged if _same_shell(scene, self.scene) else ())


def validate(scene: Scene, catalogs: Catalogs | None = None) -> tuple[Issue, ...]:
    """Lists what breaks the rules: room by room, in a room rule by rule, in a rule in the document's order.

    Args:
        scene: any scene that could be read; of one that was made in Python only numbers are checked.
        catalogs: which sides of a piece are used, and what room types require; ours by default.

    Returns:
        Issues; amounts in metres. None with severity `error`: the scene is clean.

    Raises:
        SceneError: what was given is no scene, or a number in it is none.

    Example:
        >>> from compose_homes import Furniture, Room, Scene, validate
        >>> bed = Furniture("bed", "bed", x=0.5, z=1.5, width=1.6, depth=2.0, height=0.5)
        >>> [(issue.rule, issue.amount) for issue in validate(Scene(rooms=(Room("cell", width=3, depth=3, furniture=(bed,)),)))]
        [('out_of_bounds', 0.3)]
    """
    return check(scene, catalogs or load_catalogs()).issues


def check(scene: Scene, catalogs: Catalogs) -> Checked:
    """Returns a scene, in the catalogs' words, with its issues, all of it checked."""
    return check_made(understood(scene, catalogs).scene, catalogs)


def check_made(scene: Scene, catalogs: Catalogs) -> Checked:
    """Returns a scene that was made here, in the catalogs' words, with its issues, all of it checked."""
    return _checked(scene, kinds_of(catalogs), ())


def _same_shell(one: Scene, other: Scene) -> bool:
    """Tells whether two scenes differ in nothing but what may be moved."""
    if len(one.rooms) != len(other.rooms) or _without_rooms(one) != _without_rooms(other):
        return False
    return all(a is b or _empty(a) == _empty(b) for a, b in zip(one.rooms, other.rooms, strict=True))


def _without_rooms(scene: Scene) -> Scene:
    return replace(scene, rooms=(), dynamic=(), certificate=None)


def _empty(room: Room) -> Room:
    return replace(room, furniture=(), decorations=())


def _checked(scene: Scene, kinds: Kinds, before: tuple[_Judged, ...]) -> Checked:
    world = world_of(scene, before[0].case.world if before else None)
    was = {one.case.room.room.id: one for one in before}
    same = {place.room.id: was[place.room.id] for place in world.places if place.room.id in was and was[place.room.id].case.room == place}
    table = before[0].case.table if before else NumberedKinds(kinds)
    cases: dict[str, RuleCase] = {}
    for places in storeys(world):
        cases.update((case.room.room.id, case) for case in _storey_cases(world, places, table, same, cases))
    rooms = tuple(_judge(cases[place.room.id], same.get(place.room.id)) for place in world.places)
    cases.clear()  # each holds them all: nothing would be freed before the collector came
    found = (issue for one in rooms if one.issues for rule in CHECKS for issue in one.issues.get(rule, ()))
    return Checked(scene, (*homeless(scene), *found), kinds, rooms)


def _storey_cases(
    world: World, places: Sequence[PlacedRoom], table: NumberedKinds, same: Mapping[str, _Judged], others: Mapping[str, RuleCase]
) -> Iterator[RuleCase]:
    """Judges those rooms of a storey by the core that are not the same as before, and yields all of them."""
    anew = {number: place for number, place in enumerate(places) if place.room.id not in same}
    if not anew:
        yield from (replace(same[place.room.id].case, world=world, room=place, others=others) for place in places)
        return
    demand(ROOM_WORK * len(anew))
    rows = [room_bytes(world, place, table) if k in anew else same[place.room.id].case.rows for k, place in enumerate(places)]
    most = int(min(still_allowed() / FINDING_WORK, ANY_NUMBER))
    walk, told = judged_storey(world, list(zip(places, rows, strict=True)), table, list(anew), most)
    demand(FINDING_WORK * sum(len(one.findings) + len(one.of_plan) for one in told))
    judged = dict(zip(anew, told, strict=True))
    for number, place in enumerate(places):
        if number in anew:
            yield RuleCase(world, walk, place, table, rows[number], judged[number], others)
        else:
            yield replace(same[place.room.id].case, world=world, walk=walk, room=place, others=others)


def _judge(case: RuleCase, known: _Judged | None) -> _Judged:
    """Judges a room; of what is known already of the same room nothing that still holds is checked again."""
    if known is None:
        return _Judged(case, issues_of(CHECKS if case.may_break_judged else UNJUDGED, case))
    open_again = set[str]()
    if known.case.walk is not case.walk:
        open_again.add("unreachable")
    if known.case.world.scene.certificate is not case.world.scene.certificate:
        open_again.add(_OF_THE_CERTIFICATE)
    kept = {rule: found for rule, found in known.issues.items() if rule not in open_again}
    return _Judged(case, {**kept, **issues_of(open_again, case)})


@dataclass(frozen=True)
class RoomAlone:
    """A room as a storey of its own: its rows as the core reads it, and furniture, small things, people in their order."""

    rows: bytes
    bodies: tuple[AnyBody, ...]


def room_alone(scene: Scene, catalogs: Catalogs) -> RoomAlone:
    """Returns the one room of a scene."""
    world, kinds = world_of(scene), NumberedKinds(kinds_of(catalogs))
    (place,) = world.places
    walk, _ = judged_storey(world, [(place, room_bytes(world, place, kinds))], kinds)
    return RoomAlone(walk.rows, place.bodies)
