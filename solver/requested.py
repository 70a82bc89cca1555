"""A room of the user's own and the list of pieces wanted in it: what `place` is asked with, checked.

Comes in: a `Room` and `Wish`es. Goes out: the wishes in an order in which every piece comes after those it refers to, and
the catalogs with one kind for every wish. May import: catalogs, the ground floor. Not here: ways to stand (furnish),
reading documents (service).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

from catalogs import Catalogs
from catalogs.checks import BETWEEN, OPENINGS, TO_SOMETHING
from catalogs.entries import Surface
from catalogs.schema import Furniture as Kind
from catalogs.schema import Piece, Rule, Variant
from solver.errors import RequestError
from solver.scene import Conflict, Furniture, Issue, Room, Scene

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
DENSITY: Final = 150.0
"""Mass per volume of a piece of no known kind, kg/m3: furniture of wood, mostly air."""
FIRM: Final = ("beside", "in_front_of", "around", "in_row", "on", "under")
"""Relations that give a piece its place at another one, which must then be placed before it."""
PLAIN_COLOUR: Final = "#9a9a9a"


@dataclass(frozen=True)
class Wish:
    """One line of the list: what is wanted, how large, how many times, and how it relates to the rest.

    Args:
        id: what relations call it; the body's id in the scene, with _1, _2, ... behind it where `count` is above 1.
        name: a kind of the catalogs, or any word.
        width: across the front, m; None for the kind's own.
        depth: front to back, m.
        height: m.
        count: how many of it.
        required: left out last of all.
        relations: rules of the catalogs' vocabulary; `of` names ids of wishes or of what stands in the room already.
    """

    id: str
    name: str
    width: float | None = None
    depth: float | None = None
    height: float | None = None
    count: int = 1
    required: bool = True
    relations: tuple[Rule, ...] = ()

    @property
    def labels(self) -> tuple[str, ...]:
        """The ids of its copies."""
        return (self.id,) if self.count == 1 else tuple(f"{self.id}_{n}" for n in range(1, self.count + 1))


def checked(room: Room, wishes: Sequence[Wish], catalogs: Catalogs) -> tuple[Wish, ...]:
    """Returns the wishes with every size and every relation's worth filled in.

    Raises:
        RequestError: names the field and what is allowed.
    """
    if sum(wish.count for wish in wishes) > MOST_PIECES:
        raise RequestError("pieces", f"are {sum(wish.count for wish in wishes)}, copies counted", f"at most {MOST_PIECES}")
    taken = {piece.id for piece in room.furniture} | {thing.id for thing in room.decorations}
    for k, wish in enumerate(wishes):
        _check_identity(f"pieces[{k}]", wish, taken)
        taken.update({wish.id, *wish.labels})
    names = [*(wish.id for wish in wishes), *(piece.id for piece in room.furniture)]
    for k, wish in enumerate(wishes):
        _check_relations(f"pieces[{k}]", wish, names)
    return tuple(_sized(f"pieces[{k}]", wish, catalogs) for k, wish in enumerate(wishes))


def _check_identity(field: str, wish: Wish, taken: set[str]) -> None:
    if not wish.id or wish.id in OPENINGS:
        raise RequestError(f"{field}.id", f"is {wish.id!r}", f"a text that is none of {', '.join(OPENINGS)}")
    for label in dict.fromkeys((wish.id, *wish.labels)):
        if label in taken:
            raise RequestError(f"{field}.id", f"{label!r} is given twice", "ids that differ, also from those of what stands in the room")
    if not wish.name:
        raise RequestError(f"{field}.name", "is empty", "a kind of the catalog, or any word")
    if not 1 <= wish.count <= MOST_PIECES:
        raise RequestError(f"{field}.count", f"is {wish.count}", f"a whole number from 1 to {MOST_PIECES}")


def _check_relations(field: str, wish: Wish, names: Sequence[str]) -> None:
    if len(wish.relations) > MOST_RELATIONS:
        raise RequestError(f"{field}.relations", f"are {len(wish.relations)}", f"at most {MOST_RELATIONS}")
    for j, rule in enumerate(wish.relations):
        _check_relation(f"{field}.relations[{j}]", wish, rule, names)


def _check_relation(field: str, wish: Wish, rule: Rule, names: Sequence[str]) -> None:
    takes = rule.type in BETWEEN + TO_SOMETHING
    if not takes and not rule.of:
        return
    openings = OPENINGS if rule.type in TO_SOMETHING else ()
    known = [*dict.fromkeys(names), *openings]
    if takes and not rule.of:
        raise RequestError(f"{field}.of", f"is missing: {rule.type} is a relation to something", _some(known))
    if rule.of and not takes:
        raise RequestError(f"{field}.of", f"{rule.type} takes no `of`", "no key `of`")
    for other in rule.of:
        if other not in known:
            raise RequestError(f"{field}.of", f"nothing is called {other!r}", _some(known))
        if other == wish.id and (wish.count == 1 or rule.type not in ("in_row", "near", "far_from", "beside", "aligned_with")):
            raise RequestError(f"{field}.of", f"{wish.id!r} cannot be {rule.type} itself", "another piece")


def _some(known: Sequence[str]) -> str:
    return "one of " + ", ".join(known[:20]) + (", ..." if len(known) > 20 else "")


def _sized(field: str, wish: Wish, catalogs: Catalogs) -> Wish:
    kind = catalogs.furniture.get(wish.name)
    sizes: list[float] = []
    for axis, key in enumerate(("width", "depth", "height")):
        given = getattr(wish, key)
        if given is None and kind is None:
            raise RequestError(f"{field}.{key}", f"is missing, and {wish.name!r} is no kind of the catalog", _range())
        value = kind.size[axis] if given is None and kind else given
        if not LEAST_LENGTH <= value <= MOST_LENGTH:
            raise RequestError(f"{field}.{key}", f"is {value!r}", _range())
        sizes.append(round(value * 1000) / 1000)
    width, depth, height = sizes
    return replace(wish, relations=tuple(map(_weighed, wish.relations)), width=width, depth=depth, height=height)


def _range() -> str:
    return f"a number from {LEAST_LENGTH:g} to {MOST_LENGTH:g}, m"


def in_order(wishes: Sequence[Wish]) -> tuple[Wish, ...]:
    """Returns the wishes so that each comes after those it refers to, required ones first, else as given.

    Where they refer to each other in a circle, places at another piece (`FIRM`) go before other relations, and then the
    given order decides.
    """
    waiting = sorted(wishes, key=lambda wish: not wish.required)
    ordered: list[Wish] = []
    while waiting:
        names = {wish.id for wish in waiting}
        free = _first_free(waiting, names, FIRM + tuple(BETWEEN + TO_SOMETHING)) or _most_wanted(waiting, names)
        ordered.append(free)
        waiting.remove(free)
    return tuple(ordered)


def _most_wanted(waiting: Sequence[Wish], names: set[str]) -> Wish:
    """Returns where to cut a circle: the piece that most others refer to, of those that have no place at a waiting one."""
    refers = [other for wish in waiting for other in {name for rule in wish.relations for name in rule.of} - {wish.id}]
    free = [wish for wish in waiting if _first_free([wish], names, FIRM)] or waiting
    return max(free, key=lambda wish: refers.count(wish.id))


def _first_free(waiting: Sequence[Wish], names: set[str], kinds: Sequence[str]) -> Wish | None:
    """Returns the first wish that none of these relations ties to a wish that waits too."""
    for wish in waiting:
        ties = {other for rule in wish.relations if rule.type in kinds for other in rule.of}
        if not (ties & names) - {wish.id}:
            return wish
    return None


def kinds_for(room: Room, wishes: Sequence[Wish], catalogs: Catalogs) -> Catalogs:
    """Returns the catalogs with one kind more for every wish and everything that stands in the room already."""
    added: dict[str, Kind] = {kind_of(wish.id): _kind(wish, catalogs) for wish in wishes}
    added |= {kind_of(piece.id): _kind(_as_wish(piece), catalogs) for piece in room.furniture}
    return catalogs.model_copy(update={"furniture": {**catalogs.furniture, **added}})


def kind_of(name: str) -> str:
    """Returns what the kind of a wish, or of a piece that stands already, is called."""
    return f"asked {name}"


def _as_wish(piece: Furniture) -> Wish:
    return Wish(piece.id, piece.name, piece.width, piece.depth, piece.height)


def _kind(wish: Wish, catalogs: Catalogs) -> Kind:
    size = (wish.width or 1.0, wish.depth or 1.0, wish.height or 1.0)
    known = catalogs.furniture.get(wish.name)
    name = catalogs.name_of(wish.name)
    if known is not None:
        grown = size[2] / known.size[2]
        surfaces = tuple(surface.model_copy(update={"height": round(surface.height * grown, 3)}) for surface in known.surfaces)
        return known.model_copy(update={"name": name, "size": size, "surfaces": surfaces})
    top = Surface.model_construct(name="top", height=size[2], inset=0.0, clearance=None)
    mass = max(0.1, min(DENSITY * size[0] * size[1] * size[2], 5000.0))
    return Kind.model_construct(
        category="misc", name=name, size=size, color=PLAIN_COLOUR, variants=(), mass=mass, stands="free", use=None, surfaces=(top,)
    )


def pieces_of(wishes: Sequence[Wish]) -> tuple[Piece, ...]:
    """Returns the wishes as pieces of a room type."""
    return tuple(
        Piece.model_construct(
            piece=wish.id,
            kinds=(Variant.model_construct(kind=kind_of(wish.id), cost=0.0, min_area=0.0),),
            required=wish.required, count=wish.count, per_area=None, min_area=0.0, chance=1.0,
            skip_cost=100.0, approach=(), rules=wish.relations,
        )
        for wish in wishes
    )  # fmt: skip


def _weighed(rule: Rule) -> Rule:
    """Gives a rule that does not say what it is worth the worth of a wish."""
    return rule if "cost" in rule.model_fields_set else rule.model_copy(update={"cost": RELATION_COST})


def relations_of(wishes: Sequence[Wish]) -> Iterator[tuple[str, Rule]]:
    """Yields every relation that is asked for, as (id of the copy, rule)."""
    for wish in wishes:
        for label in wish.labels:
            for rule in wish.relations:
                yield label, rule


def labels_by_name(room: Room, wishes: Sequence[Wish]) -> Mapping[str, tuple[str, ...]]:
    """Returns the ids of the bodies that each name of an `of` stands for."""
    return {**{piece.id: (piece.id,) for piece in room.furniture}, **{wish.id: wish.labels for wish in wishes}}


@dataclass(frozen=True)
class Held:
    """What became of one relation: the piece's id, the relation, what it was to (None: the room), and whether it is held."""

    piece: str
    type: str
    of: str | None
    held: bool


@dataclass(frozen=True)
class Unplaced:
    """A piece that is not in the scene, and why."""

    id: str
    reason: str


@dataclass(frozen=True)
class Placement:
    """One placement: the scene, which relations it holds, who is missing, what the relations it misses are worth, and issues."""

    scene: Scene
    relations: tuple[Held, ...]
    unplaced: tuple[Unplaced, ...]
    cost: float
    issues: tuple[Issue, ...]


@dataclass(frozen=True)
class Answered:
    """The answer of place: the best placement, the others by rank, why required pieces are missing, stage times in ms."""

    best: Placement
    alternatives: tuple[Placement, ...]
    conflicts: tuple[Conflict, ...]
    timing_ms: Mapping[str, float]
