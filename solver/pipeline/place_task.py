"""One request of place: what it means to every stage, and an arrangement written down and judged.

Pieces are placed in an order that follows from what is asked for, not from ids or places in the list: so a list told otherwise is the
same. What relations cannot tell apart stays in the order that was sent, and of equal copies the first ones stand. Where not everything
finds a place the sent order counts, as it says what matters most (place). Not here: which arrangement (rounds, place).
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

from catalogs import Catalogs
from catalogs.schema import RelationSpec
from solver.certificate import room_certificate
from solver.furnish import Habits, Listing, habits_of, opened_about, scope_of, space_of, tucks
from solver.furnished import furnished
from solver.geometry import WALL_BEHIND, to_mm
from solver.named_assets import with_assets
from solver.pieces import Arrangement, Candidate, Piece, Placed, Space
from solver.pipeline.frames import SearchFrame, frame_of
from solver.pipeline.room_spaces import entrances_of
from solver.pipeline.staying import obstacles
from solver.relations.held import FinishedRoom, Standing, at_wall, held, standing, traits
from solver.relations.subject import Kind
from solver.requested import (
    Held,
    PieceRequest,
    Placement,
    Unplaced,
    checked,
    in_order,
    kind_of_request,
    kinds_of,
    labels_by_name,
    relations_of,
)
from solver.scene import Furniture, Level, Room, Scene
from solver.streams import Stream
from solver.understanding import Understood, understood
from solver.validator import RULES, validate


class PlaceSetting(NamedTuple):
    """What a list is placed in besides its room.

    Of the room its `wall_thickness`, how high it is, None: not known, and the square that must be able to walk in it, all m;
    the engine of the final solve; `flush`: backs touch the walls, else they stand a little off; `roaming`: ids of requested
    pieces that may stand free though their kind stands at walls.
    """

    wall_thickness: float
    robot_width: float
    engine: str
    height: float | None
    flush: bool = False
    roaming: frozenset[str] = frozenset()

    def space_in(self, room: Room) -> Space:
        """Returns where a room's furniture may stand."""
        space = space_of(room, self.wall_thickness, self.robot_width)
        return replace(space, gap_mm=0) if self.flush else space


@dataclass(frozen=True)
class PlaceTask:
    """What every placement of one request shares."""

    room: Room
    requests: tuple[PieceRequest, ...]
    catalogs: Catalogs
    setting: PlaceSetting
    space: Space
    """Of the room as it was sent."""
    bare: FinishedRoom
    """The room as it was sent, before anything is placed, to be judged."""
    frame: SearchFrame
    framed: FinishedRoom
    """The room in the frame of its search, before anything is placed, to be judged."""
    listing: Listing
    """What is asked for, in the frame."""
    kinds: Mapping[str, Kind]
    """The kind of every piece that is asked for or stands already, by its label."""
    words: Understood
    """What stands in the room, in the catalogs' words."""

    @property
    def understood_as(self) -> dict[str, str]:
        """What a piece was taken for that is called by no name of the catalogs, by the id of the body or of the request."""
        kinds = {one.id: kind_of_request(one, self.catalogs) for one in self.requests if one.name not in self.catalogs.furniture}
        return {**self.words.understood_as, **{name: kind for name, kind in kinds.items() if kind}}

    @cached_property
    def names(self) -> Mapping[str, str]:
        """What the pieces to be placed are called in the scene, by label: as they were asked for, in a kind's size variants its name."""
        return {label: self.catalogs.name_of(one.name) for one in self.requests for label in one.labels}

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The pieces to be placed, each after those it refers to, behind those that stand already."""
        return self.listing.few.pieces


def task_of(room: Room, requests: Sequence[PieceRequest], catalogs: Catalogs, setting: PlaceSetting, as_sent: bool = False) -> PlaceTask:
    """Checks a request and says what it means.

    Args:
        room: with what stands in it.
        requests: what is wanted.
        catalogs: whose kinds are known.
        setting: of the room, and of the solve.
        as_sent: the pieces are placed in the order of the list, the most important first; else in one that does not depend on it.

    Raises:
        RequestError: a field is wrong.
    """
    words = understood(Scene(rooms=(room,)), catalogs)
    room = words.scene.rooms[0]
    ceiling = None if room.outdoor else setting.height
    sent = checked(room, requests, catalogs, ceiling)
    kinds = kinds_of(room, sent, catalogs)
    if ceiling is not None:
        bottoms = {one.id: one.y for one in room.furniture}
        kinds = {name: kind.below(to_mm(ceiling - bottoms.get(name, 0.0))) for name, kind in kinds.items()}
    kinds = {name: replace(kind, at_walls=False) if name in setting.roaming else kind for name, kind in kinds.items()}
    wanted = sent if as_sent else by_content(sent, kinds)
    names = labels_by_name(room, wanted)
    by_label = {label: kinds[name] for name, labels in names.items() for label in labels}
    own = setting.space_in(room)
    relations = [*_every_relation(wanted, habits_of(wanted, kinds, catalogs, own.clear))]
    tucked = [by_label[one] for label, spec in relations if tucks(spec) for name in (label, *spec.of) for one in names.get(name, (name,))]
    frame = frame_of(room, kinds.values(), tucked, (spec for _, spec in relations))
    inside = frame.room(room)
    entrances = {name for _, name in entrances_of((inside,))}
    empty = replace(setting.space_in(inside), closed=not entrances)
    space, there = obstacles(inside, empty, catalogs, entrances)
    habits = habits_of(wanted, kinds, catalogs, space.clear)
    goes_to = _goes_to(wanted, habits)
    floors = {name: opened_about(kind, catalogs) for name, kind in kinds.items()}
    listing = Listing(inside, space, empty.zones, in_order(wanted, goes_to), kinds, habits, there, floors, ceiling)
    framed, bare = _bare(inside, space, by_label, names), _bare(room, own, by_label, names)
    return PlaceTask(room, in_order(sent, goes_to), catalogs, setting, own, bare, frame, framed, listing, by_label, words)


def without_wishes(request: PieceRequest) -> PieceRequest:
    """Returns the request with no relations but those that must hold."""
    return replace(request, relations=tuple(spec for spec in request.relations if spec.required))


def without_partings(request: PieceRequest, gone: set[str]) -> PieceRequest:
    """Returns a request of a piece that is gone without what has to keep it away from others that are gone, too; any other as it is."""
    if gone.isdisjoint(request.labels):
        return request
    held = [spec for spec in request.relations if spec.required and traits(spec.type).with_all and gone.issuperset(spec.of)]
    return replace(request, relations=tuple(spec for spec in request.relations if spec not in held))


def _bare(room: Room, space: Space, kinds: Mapping[str, Kind], names: Mapping[str, tuple[str, ...]]) -> FinishedRoom:
    bodies = {one.id: standing(one, space.clear, _heights(kinds[one.id])) for one in room.furniture}
    return FinishedRoom(scope_of(room, space), bodies, names)


def _every_relation(requests: Sequence[PieceRequest], habits: Habits) -> Iterator[tuple[str, RelationSpec]]:
    """Yields (label, relation) of what is asked for and what is usual."""
    yield from relations_of(requests)
    yield from ((label, spec) for label, specs in habits.relations.items() for spec in specs)


def _goes_to(requests: Sequence[PieceRequest], habits: Habits) -> Mapping[str, frozenset[str]]:
    """Returns by id the requests at whose pieces those of another have their place by habit."""
    of = {label: request.id for request in requests for label in request.labels}
    return {
        request.id: frozenset(
            of[name] for label in request.labels for spec in habits.relations.get(label, ()) for name in spec.of if name in of
        )
        for request in requests
    }


def _heights(kind: Kind) -> list[float]:
    return [level.height_mm / 1000 for level in kind.levels]


def finished(task: PlaceTask, arrangement: Arrangement) -> Placement:
    """Writes an arrangement of the frame down, as the room was sent, and judges it."""
    arrangement = _first_copies(task, task.frame.back(arrangement))
    room = _written(task, arrangement)
    document = {"rules": list(RULES), "rooms": {room.id: room_certificate(arrangement, room)}}
    request = {"robot_width": task.setting.robot_width}
    room = task.words.in_their_words(Scene(rooms=(room,))).rooms[0]
    levels = () if task.setting.height is None else (Level(room.level, height=task.setting.height),)
    scene = Scene(request=request, wall_thickness=task.setting.wall_thickness, rooms=(room,), levels=levels, certificate=document)
    stands = {piece.id for piece in task.room.furniture} | {piece.label for piece in task.listing.there}
    unplaced = tuple(Unplaced(label, reason) for label, reason in arrangement.left_out if label not in stands)
    bodies = {one.id: standing(one, task.space.clear, _heights(task.kinds[one.id])) for one in room.furniture}
    seen = replace(task.bare, bodies=bodies)
    relations = []
    for label, spec in relations_of(task.requests):
        holds, of = held(seen, label, spec)
        relations.append(Held(label, spec.type, of, holds))
    return Placement(with_assets(scene, task.catalogs), tuple(relations), unplaced, arrangement.cost, validate(scene, task.catalogs))


def first_copies(requests: Sequence[PieceRequest], arrangement: Arrangement) -> Mapping[str, str]:
    """Returns what the copies of requests are called, by label, so that of each the first ones stand: which of them does, says nothing."""
    there = {one.label for one in arrangement.placed}
    several = [one.labels for one in requests if one.count > 1 and not there.issuperset(one.labels)]
    return {old: new for own in several for old, new in zip(sorted(own, key=lambda label: label not in there), own, strict=True)}


def _first_copies(task: PlaceTask, arrangement: Arrangement) -> Arrangement:
    """Returns an arrangement in which of equal copies the first ones stand, and the list of what is missing as that of the requests."""
    called = first_copies(task.requests, arrangement)
    places = {label: place for place, label in enumerate(label for request in task.requests for label in request.labels)}
    gone = sorted(((called.get(label, label), why) for label, why in arrangement.left_out), key=lambda one: places.get(one[0], -1))
    placed = [replace(one, label=called.get(one.label, one.label), chosen=_beside(one.chosen, called)) for one in arrangement.placed]
    return replace(arrangement, placed=tuple(placed), left_out=tuple(gone)) if called else replace(arrangement, left_out=tuple(gone))


def _beside(chosen: Candidate, called: Mapping[str, str]) -> Candidate:
    """Returns a way to stand with other names for what it stands on or under."""
    on, under = (other and called.get(other, other) for other in (chosen.on, chosen.under))
    return replace(chosen, on=on, under=under)


def _written(task: PlaceTask, arrangement: Arrangement) -> Room:
    """Returns the room with what stands in it as sent, and the placed pieces under their own ids."""
    fresh = tuple(one for one in arrangement.placed if one.label in task.listing.listed)
    stream = Stream(0, "colour", task.room.index)
    made = furnished(task.room, replace(arrangement, placed=fresh), task.catalogs, stream).furniture
    called = (_called(task, piece, one) for piece, one in zip(made, fresh, strict=True))
    return replace(task.room, furniture=(*task.room.furniture, *called))


def _called(task: PlaceTask, piece: Furniture, placed: Placed) -> Furniture:
    """Gives a piece its own id, and its wall where its kind hugs one and its back is at it."""
    chosen, wall = placed.chosen, placed.wall
    if wall is None and task.kinds[placed.label].at_walls and chosen.on is None:
        behind = WALL_BEHIND[placed.rotation]
        wall = behind if placed.footprint.wall_distance(behind, task.space.clear) <= task.space.gap_mm else None
    return replace(piece, id=placed.label, name=task.names[placed.label], under=chosen.under, on=chosen.on, wall=wall)


def lost(task: PlaceTask, arrangement: Arrangement) -> list[tuple[str, RelationSpec]]:
    """Judges an arrangement that is not written down: returns (piece, relation) of every relation that is not held."""
    bodies = {one.label: _standing(task, one) for one in arrangement.placed}
    seen = replace(task.framed, bodies={**task.framed.bodies, **bodies})
    return [(label, spec) for label, spec in relations_of(task.requests) if not held(seen, label, spec)[0]]


def _standing(task: PlaceTask, one: Placed) -> Standing:
    kind, bottom = task.kinds.get(one.label), one.chosen.bottom_mm
    levels = tuple(bottom + level.height_mm for level in kind.levels) if kind else ()
    return at_wall(Standing(one.label, one.footprint, one.rotation, bottom, None, one.chosen.on, levels), task.listing.space.clear)


def by_content(requests: Sequence[PieceRequest], kinds: Mapping[str, Kind]) -> tuple[PieceRequest, ...]:
    """Returns requests, with every size filled in, sorted by kind, size, number, relations, and those of others to them.

    Of those that all this leaves tied the first of the list goes first, and what is asked for in relation to it is told apart by that.
    """
    words = {request.id: [(spec.model_dump_json(exclude={"of"}), spec.of) for spec in request.relations] for request in requests}
    told = {name: repr((name,)) for own in words.values() for _, of in own for name in of}
    told |= {name: repr((kind.name, kind.size, place)) for place, (name, kind) in enumerate(kinds.items())}
    told |= {one.id: repr((not one.required, kinds[one.id].name, one.size, one.count)) for one in requests}
    ranks = _told_apart(_ranked(told), words)
    for request in requests:
        others = [one.id for one in requests if ranks[one.id] == ranks[request.id] and one is not request]
        if others:
            ranks = _told_apart(ranks | {name: ranks[name] + 1 for name in others}, words)
    return tuple(sorted(requests, key=lambda request: ranks[request.id]))


_Words: TypeAlias = Mapping[str, Sequence[tuple[str, Sequence[str]]]]
"""The relations of requests, in words, each with the names that it is to, by the request's id."""


def _told_apart(ranks: Mapping[str, int], words: _Words) -> dict[str, int]:
    """Returns ranks of names, those of one rank told apart by their relations to others of other ranks, and by those of others to them."""
    known, ranks = 0, dict(ranks)
    while len({*ranks.values()}) > known:
        known = len({*ranks.values()})
        named: dict[str, list[tuple[int, str]]] = {name: [] for name in ranks}
        for own, relations in words.items():
            for word, of in relations:
                for name in of:
                    named[name].append((ranks[own], word))
        to = {own: tuple((word, tuple(sorted(ranks[name] for name in of))) for word, of in words.get(own, ())) for own in ranks}
        ranks = _ranked({name: (rank, to[name], tuple(sorted(named[name]))) for name, rank in ranks.items()})
    return ranks


def _ranked(keys: Mapping[str, Any]) -> dict[str, int]:
    """Returns how many names have a lesser key than each."""
    places: dict[Any, int] = {}
    for place, key in enumerate(sorted(keys.values())):
        places.setdefault(key, place)
    return {name: places[key] for name, key in keys.items()}
