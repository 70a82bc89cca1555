"""A room of the user's own and the list of pieces wanted in it: what `place` is asked with, checked.

Not here: candidates (furnish), reading documents (service).
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from functools import cache, partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Final

from annotated_types import Ge, Le, MaxLen, MinLen

from catalogs import Catalogs
from catalogs.checks import BETWEEN, OPENINGS, TO_SOMETHING
from catalogs.kind_book import KindBook
from catalogs.schema import RelationSpec
from catalogs.synonyms import synonyms_of
from solver.answers import Conflict, Issue
from solver.errors import RequestError, all_of
from solver.fields import GIVEN, STRICT, WHOLE, Flag, Record
from solver.relations.subject import RELATION_WORDS, Kind, as_its_size_says
from solver.scene import Room, Scene
from solver.scene_bodies import check_is, check_listed

if TYPE_CHECKING:
    from solver.relations.held import Traits

MOST_PIECES: Final = 64
"""Most pieces of one request, copies counted; our choice: a furnished living room holds fifteen."""
MOST_RELATIONS: Final = 16
"""Most relations of one piece; our choice."""
MOST_ALTERNATIVES: Final = 16
"""Most placements of one request; our choice."""
MOST_LENGTH: Final = 100.0
"""Largest size of a wished piece, m."""
LEAST_LENGTH: Final = 0.001
"""Smallest size of a wished piece, m: the lattice's step."""
RELATION_COST: Final = 6.0
"""What doing without a relation costs where the request does not say: as much as moving 2.4 m."""

WishedMetres = Annotated[float, STRICT, Ge(LEAST_LENGTH), Le(MOST_LENGTH)]
WishedName = Annotated[str, MinLen(1), MaxLen(100), STRICT]


@dataclass(frozen=True)
class PieceRequest(Record):
    """One line of the list: what is wanted, how large, how many times, and how it relates to the rest.

    Args:
        id: what relations call it; the body's id in the scene, with _1, _2, ... behind it where `count` is above 1. Its name by default.
        name: a kind of the catalogs, or any word. Its id by default.
        width: across the front, m; None for the kind's own.
        depth: front to back, m.
        height: m.
        count: how many of it.
        required: left out last of all.
        relations: rules of the catalogs' vocabulary; `of` names ids of requests or of what stands in the room already.
    """

    id: WishedName = ""
    name: WishedName = ""
    width: WishedMetres | None = None
    depth: WishedMetres | None = None
    height: WishedMetres | None = None
    count: Annotated[int, Ge(1), Le(MOST_PIECES), WHOLE] = 1
    required: Flag = True
    relations: Annotated[tuple[Annotated[RelationSpec, GIVEN], ...], MaxLen(MOST_RELATIONS)] = ()

    def __post_init__(self) -> None:
        """Calls a piece without an id by its name, and the other way round."""
        object.__setattr__(self, "id", self.id or self.name)
        object.__setattr__(self, "name", self.name or self.id)

    @property
    def size(self) -> tuple[float, float, float] | None:
        """Its width, depth and height, m; None where they are not all given."""
        return (self.width, self.depth, self.height) if self.width and self.depth and self.height else None

    @property
    def labels(self) -> tuple[str, ...]:
        """The ids of its copies."""
        return (self.id,) if self.count == 1 else tuple(f"{self.id}_{n}" for n in range(1, self.count + 1))


def checked(room: Room, requests: Sequence[PieceRequest], catalogs: Catalogs, ceiling: float | None = None) -> tuple[PieceRequest, ...]:
    """Returns the requests with every size and every relation's worth filled in; `ceiling` is how high the room is, m, if that is said.

    Raises:
        RequestError: names the field and what is allowed.
    """
    check_listed("pieces", requests, PieceRequest, "a PieceRequest", RequestError)
    for k, request in enumerate(requests):
        _check_types(f"pieces[{k}]", request)
    if sum(request.count for request in requests) > MOST_PIECES:
        raise RequestError("pieces", f"are {sum(request.count for request in requests)}, copies counted", f"at most {MOST_PIECES}")
    taken = {piece.id for piece in room.furniture} | {thing.id for thing in room.decorations}
    for k, request in enumerate(requests):
        _check_identity(f"pieces[{k}]", request, taken)
        taken.update({request.id, *request.labels})
    names = [*(request.id for request in requests), *(piece.id for piece in room.furniture)]
    for k, request in enumerate(requests):
        _check_relations(f"pieces[{k}]", request, names)
    return tuple(all_of(partial(_sized, f"pieces[{k}]", request, catalogs, ceiling) for k, request in enumerate(requests)))


def _check_types(field: str, request: PieceRequest) -> None:
    for key in ("id", "name"):
        check_is(f"{field}.{key}", getattr(request, key), str, "a text", RequestError)
    check_is(f"{field}.count", request.count, int, f"a whole number from 1 to {MOST_PIECES}", RequestError)
    check_listed(f"{field}.relations", request.relations, RelationSpec, "a RelationSpec", RequestError)


def _check_identity(field: str, request: PieceRequest, taken: set[str]) -> None:
    if not request.id:
        raise RequestError(f"{field}.id", "is missing, and so is the name", "an id, or a name")
    if request.id in OPENINGS:
        raise RequestError(f"{field}.id", f"is {request.id!r}", f"a text that is none of {', '.join(OPENINGS)}")
    for label in dict.fromkeys((request.id, *request.labels)):
        if label in taken:
            raise RequestError(f"{field}.id", f"{label!r} is given twice", "ids that differ, also from those of what stands in the room")
    if not 1 <= request.count <= MOST_PIECES:
        raise RequestError(f"{field}.count", f"is {request.count}", f"a whole number from 1 to {MOST_PIECES}")


def _check_relations(field: str, request: PieceRequest, names: Sequence[str]) -> None:
    if len(request.relations) > MOST_RELATIONS:
        raise RequestError(f"{field}.relations", f"are {len(request.relations)}", f"at most {MOST_RELATIONS}")
    for j, rule in enumerate(request.relations):
        _check_relation(f"{field}.relations[{j}]", request, rule, names)


def _check_relation(field: str, request: PieceRequest, rule: RelationSpec, names: Sequence[str]) -> None:
    takes = rule.type in BETWEEN + TO_SOMETHING
    if not takes and not rule.of:
        return
    openings = OPENINGS if rule.type in TO_SOMETHING else ()
    known = [*dict.fromkeys(names), *openings]
    alone = request.count == 1 or not _traits(rule.type).among_copies
    others = _some([one for one in known if not (alone and one == request.id)])
    if takes and not rule.of:
        raise RequestError(f"{field}.of", f"is missing: {rule.type} is a relation to something", others)
    if rule.of and not takes:
        raise RequestError(f"{field}.of", f"{rule.type} takes no `of`", "no key `of`")
    for other in rule.of:
        if other not in known:
            raise RequestError(f"{field}.of", f"nothing is called {other!r}", others)
        if alone and other == request.id:
            raise RequestError(f"{field}.of", f"{request.id!r} cannot be {rule.type} itself", "another piece")


def _some(known: Sequence[str]) -> str:
    return "one of " + ", ".join(known[:20]) + (", ..." if len(known) > 20 else "") if known else "another piece"


def _sized(field: str, request: PieceRequest, catalogs: Catalogs, ceiling: float | None) -> PieceRequest:
    kind = catalogs.furniture.get(kind_of_request(request, catalogs) or "")
    own = kind.size if kind else (None,) * 3
    keys = ("width", "depth", "height")
    width, depth, height = all_of(partial(_length, field, key, request, usual, catalogs) for key, usual in zip(keys, own, strict=True))
    if ceiling is not None and height > ceiling:
        raise RequestError(f"{field}.height", f"is {height:.2f} m, and the room {ceiling:.2f} m high", "what fits under the ceiling")
    return replace(request, relations=tuple(map(_weighed, request.relations)), width=width, depth=depth, height=height)


def _length(field: str, key: str, request: PieceRequest, usual: float | None, catalogs: Catalogs) -> float:
    given: float | None = getattr(request, key)
    value = usual if given is None else given
    if value is None:
        raise RequestError(
            f"{field}.{key}",
            f"is missing, and {request.name!r} is no kind of the catalog",
            f"{_range()}; or a kind as its name, such as {_one_like(request.name, catalogs)}",
        )
    check_is(f"{field}.{key}", value, (int, float), _range(), RequestError)
    if not LEAST_LENGTH <= value <= MOST_LENGTH:
        raise RequestError(f"{field}.{key}", f"is {value!r}", _range())
    return round(value * 1000) / 1000


def kind_of_request(request: PieceRequest, catalogs: Catalogs) -> str | None:
    """Returns the kind of the catalogs that is wanted, perhaps by a foreign name; None where there is none like it."""
    if request.name in catalogs.furniture:
        return request.name
    meaning = synonyms_of(catalogs).meaning(request.name, request.size)
    return meaning.key if meaning and meaning.sort == "furniture" else None


def _one_like(name: str, catalogs: Catalogs) -> str:
    """Returns the kind whose name is most like another name; where none is, any."""
    return repr((get_close_matches(name.lower(), catalogs.furniture, 1) or [*catalogs.furniture])[0])


def _range() -> str:
    return f"a number from {LEAST_LENGTH:g} to {MOST_LENGTH:g}, m"


def in_order(requests: Sequence[PieceRequest], goes_to: Mapping[str, Collection[str]] = MappingProxyType({})) -> tuple[PieceRequest, ...]:
    """Returns the requests so that each comes after those it refers to or `goes_to` (by id), required ones first, else as given.

    Where they refer to each other in a circle, places at another piece (`giving_place`) go before other relations, and then the
    given order decides.
    """
    waiting = sorted(requests, key=lambda request: not request.required)
    ordered: list[PieceRequest] = []
    while waiting:
        names = {request.id for request in waiting}
        every = (*giving_place(), *BETWEEN, *TO_SOMETHING)
        refers = {request.id: _refers(request, every) | {*goes_to.get(request.id, ())} for request in waiting}
        free = _first_free(waiting, names, refers) or _most_wanted(waiting, names, goes_to)
        ordered.append(free)
        waiting.remove(free)
    return tuple(ordered)


def _most_wanted(waiting: Sequence[PieceRequest], names: set[str], goes_to: Mapping[str, Collection[str]]) -> PieceRequest:
    """Returns where to cut a circle: the piece that most others refer to, of those that have no place at a waiting one."""
    refers = [other for request in waiting for other in {name for rule in request.relations for name in rule.of} - {request.id}]
    placed_at = {request.id: _refers(request, giving_place()) | {*goes_to.get(request.id, ())} for request in waiting}
    free = [request for request in waiting if _first_free([request], names, placed_at)] or waiting
    return max(free, key=lambda request: refers.count(request.id))


def _refers(request: PieceRequest, kinds: Sequence[str]) -> set[str]:
    """Returns what a request's relations of these types refer to."""
    return {other for rule in request.relations if rule.type in kinds for other in rule.of}


def _first_free(waiting: Sequence[PieceRequest], names: set[str], refers: Mapping[str, set[str]]) -> PieceRequest | None:
    """Returns the first request that refers to no other of these names."""
    return next((request for request in waiting if not (refers[request.id] & names) - {request.id}), None)


def kinds_of(room: Room, requests: Sequence[PieceRequest], catalogs: Catalogs) -> dict[str, Kind]:
    """Returns the kinds, in their sizes, of what is wanted and of what stands in the room already, by id."""
    book = KindBook(catalogs)

    def kind(name: str, size: tuple[float, float, float] | None, said: str | None = None) -> Kind:
        return Kind.of(name, catalogs, size, book.kind_of("furniture", name, size, said) if size else None)

    standing = {one.id: kind(one.name, (one.width, one.depth, one.height), one.kind) for one in room.furniture}
    wanted = {one.id: kind(kind_of_request(one, catalogs) or one.name, one.size) for one in requests}
    guessed = {one.id: as_its_size_says(wanted[one.id]) for one in requests if not one.relations and not kind_of_request(one, catalogs)}
    return {**standing, **wanted, **guessed}


def _weighed(rule: RelationSpec) -> RelationSpec:
    """Gives a rule that does not say what it is worth the worth of a wish."""
    return rule if "cost" in rule.model_fields_set else rule.model_copy(update={"cost": RELATION_COST})


def _traits(word: str) -> "Traits":
    from solver.relations.held import traits  # noqa: PLC0415 - what only reads the types of requests needs no core

    return traits(word)


@cache
def giving_place() -> Sequence[str]:
    """Returns the relations that give a piece its place at another one, which must then be placed before it."""
    return [word for word in RELATION_WORDS if _traits(word).gives_place]


def relations_of(requests: Sequence[PieceRequest]) -> Iterator[tuple[str, RelationSpec]]:
    """Yields every relation that is asked for, as (id of the copy, rule)."""
    for request in requests:
        for label in request.labels:
            for rule in request.relations:
                yield label, rule


def labels_by_name(room: Room, requests: Sequence[PieceRequest]) -> Mapping[str, tuple[str, ...]]:
    """Returns the ids of the bodies that each name of an `of` stands for."""
    return {**{piece.id: (piece.id,) for piece in room.furniture}, **{request.id: request.labels for request in requests}}


@dataclass(frozen=True)
class Held(Record):
    """What became of one relation: the piece's id, the relation, what it was to (None: the room), and whether it is held."""

    piece: str
    type: str
    of: str | None
    held: bool


@dataclass(frozen=True)
class Unplaced(Record):
    """A piece that is not in the scene, and why."""

    id: str
    reason: str


@dataclass(frozen=True)
class Placement(Record):
    """One placement: the scene, which relations it holds, who is missing, what the relations it misses are worth, and issues."""

    scene: Scene
    relations: tuple[Held, ...]
    unplaced: tuple[Unplaced, ...]
    cost: float
    issues: tuple[Issue, ...]


@dataclass(frozen=True)
class Answered:
    """The answer of place: the best placement, the others by rank, why required pieces are missing, stage times in ms.

    `understood_as` tells what a piece, by its id, was taken for that is called by no name of the catalogs.
    """

    best: Placement
    alternatives: tuple[Placement, ...]
    conflicts: tuple[Conflict, ...]
    timing_ms: Mapping[str, float]
    understood_as: Mapping[str, str]
