"""Where pieces usually stand that a list says nothing of: chairs at tables; plants in corners; the rest spread out.

Who asks for a place at any of several pieces is dealt one of them as who has it there by habit: evenly, by what each has free.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from math import ceil, sqrt
from typing import Final

from catalogs import Catalogs
from catalogs.schema import RelationSpec
from solver.geometry import Rect
from solver.relations.held import traits
from solver.relations.subject import Kind, is_tall
from solver.requested import PieceRequest

SEAT_MM: Final = 60
"""Free floor between two seats at a table, at least."""
WAY_MM: Final = 900
"""Wished width of the ways between large pieces that stand free."""
LARGE_MM: Final = 600
"""Shorter side of the smallest such piece."""
RIM_MM: Final = 700
"""Floor along the walls that is left to what stands there, where the room is large enough."""
ROOMY: Final = 4
"""A room's short side is so many times that floor at least, or it is too small to leave any."""
TO_THE_WALL: Final = (RelationSpec(type="against_wall", cost=1.0),)
"""The habit of what nobody knows and is tall."""
_ONE_EACH: Final = {"under": 1, "on": 1, "opposite": 1, "in_front_of": 1, "beside": 2}
"""How many pieces stand so at another one; others do in any number."""


@dataclass(frozen=True)
class Habits:
    """Where pieces stand that say nothing of it, by label: by which relations, and on which part of the floor.

    That is where a piece stands best that stands free and near nothing. `dealt` are the relations of pieces that do say something: which
    of several other pieces one is dealt comes first.
    """

    relations: Mapping[str, tuple[RelationSpec, ...]] = field(default_factory=dict)
    cells: Mapping[str, Rect] = field(default_factory=dict)
    dealt: Mapping[str, tuple[RelationSpec, ...]] = field(default_factory=dict)


@dataclass
class _Hosts:
    """Pieces that others stand at, by what scenes call them, and how many do so far."""

    labels: dict[str, list[str]]
    kinds: dict[str, Kind]
    taken: dict[tuple[str, str], int] = field(default_factory=dict)

    def dealt(self, spec: RelationSpec, own: Kind) -> str | None:
        """Returns the piece with the most room left for one more that stands so; None where none has any."""
        for name in spec.of:
            free = [label for label in self.labels.get(name, ()) if self._load(spec, label, own) < 1.0]
            if free:
                return self.taking(spec, free, own)
        return None

    def taking(self, spec: RelationSpec, labels: Sequence[str], own: Kind, count: int = 1) -> str:
        """Returns that of some pieces with the most room left; so many more stand there from now on."""
        chosen = min(labels, key=lambda label: self._load(spec, label, own))
        self.taken[spec.type, chosen] = self.taken.get((spec.type, chosen), 0) + count
        return chosen

    def _load(self, spec: RelationSpec, label: str, own: Kind) -> float:
        return self.taken.get((spec.type, label), 0) / _seats(spec.type, self.kinds[label], own)


def _seats(relation: str, host: Kind, own: Kind) -> int:
    """Returns how many pieces of a kind can stand in a relation to another piece."""
    if relation == "around":
        pitch = own.size[0] + SEAT_MM
        return max(1, 2 * (host.size[0] // pitch) + 2 * (host.size[1] // pitch))
    if relation == "in_front_of":
        return max(1, host.size[0] // (own.size[0] + SEAT_MM))
    return _ONE_EACH.get(relation, 1_000)


def habits_of(requests: Sequence[PieceRequest], kinds: Mapping[str, Kind], catalogs: Catalogs, clear: Rect) -> Habits:
    """Returns where the pieces stand that have no relations; `kinds` are theirs and those of what stands already, by id."""
    asked = {request.id for request in requests}
    copies = {request.id: request.labels for request in requests} | {name: (name,) for name in kinds if name not in asked}
    hosts = _Hosts({}, {})
    for name, labels in copies.items():
        hosts.labels.setdefault(catalogs.name_of(kinds[name].name), []).extend(labels)
        hosts.kinds |= dict.fromkeys(labels, kinds[name])
    dealt = _dealt(hosts, requests, kinds, copies)
    found: dict[str, tuple[RelationSpec, ...]] = {}
    for label, name in _silent(requests):
        relations = _way(hosts, label, kinds[name], catalogs)
        if relations:
            found[label] = relations
    free = {label: kinds[name] for label, name in _silent(requests) if label not in found and not kinds[name].at_walls}
    seated = {host for way in found.values() for spec in way if spec.type == "around" for host in spec.of}
    rim = any(kind.at_walls for kind in kinds.values()) or any(spec.type == "against_wall" for way in found.values() for spec in way)
    return Habits(found, _cells(free, seated, clear, rim), dealt)


def _dealt(
    hosts: _Hosts, requests: Sequence[PieceRequest], kinds: Mapping[str, Kind], copies: Mapping[str, Sequence[str]]
) -> dict[str, tuple[RelationSpec, ...]]:
    """Returns by label the relations of who asks to be at any of several pieces: which of them it is dealt comes first.

    It has all it asks for at the same one, where it has its place; those who ask for a single one come before. What a relation is to comes
    in the order of `copies`, whichever it was told in.
    """
    places = {name: place for place, name in enumerate(copies)}

    def in_order(spec: RelationSpec) -> Sequence[str]:
        return sorted(spec.of, key=lambda name: (places.get(name, len(places)), name))

    def others(request: PieceRequest, spec: RelationSpec) -> Sequence[str]:
        labels = [label for name in in_order(spec) for label in copies.get(name, ())]
        return labels if not traits(spec.type).with_all and request.id not in spec.of else ()

    for request in requests:
        for spec in request.relations:
            if len(only := others(request, spec)) == 1:
                hosts.taking(spec, only, kinds[request.id], request.count)
    found: dict[str, tuple[RelationSpec, ...]] = {}
    for label, request in ((label, one) for one in requests for label in one.labels):
        at = dict[str, None]()
        for spec in sorted(request.relations, key=lambda spec: not traits(spec.type).gives_place):
            if len(several := others(request, spec)) > 1:
                at[hosts.taking(spec, [one for one in several if one in at] or several, kinds[request.id])] = None
        if at or any(len(spec.of) > 1 for spec in request.relations):
            firsts = [[one for one in at if one in others(request, spec)][:1] for spec in request.relations]
            found[label] = tuple(
                spec.model_copy(update={"of": (*first, *in_order(spec))}) for spec, first in zip(request.relations, firsts, strict=True)
            )
    return found


def _silent(requests: Sequence[PieceRequest]) -> Iterator[tuple[str, str]]:
    """Yields (label, id of its request) of the pieces that say nothing of where they stand."""
    for request in requests:
        if not request.relations:
            yield from ((label, request.id) for label in request.labels)


def _way(hosts: _Hosts, label: str, kind: Kind, catalogs: Catalogs) -> tuple[RelationSpec, ...]:
    """Returns the relations of the first way whose pieces are there and have room for one more."""
    habit = catalogs.habits.get(catalogs.name_of(kind.name))
    for way in habit.ways if habit else ():
        chosen = hosts.dealt(way[0], kind) if way[0].of else None
        if chosen is not None or not way[0].of:
            return tuple(spec.model_copy(update={"of": (chosen,)}) if spec.of else spec for spec in way)
    is_guessed = kind.name not in catalogs.furniture and kind.use_sides
    return TO_THE_WALL if is_guessed and is_tall(kind) else ()


def _cells(free: Mapping[str, Kind], seated: set[str], clear: Rect, rim: bool) -> dict[str, Rect]:
    """Deals the floor to the pieces that stand free, in equal parts, row by row; large ones keep ways between them."""
    short = min(clear.width, clear.depth)
    if short <= 0:
        return {}
    floor = clear.shrunk(RIM_MM) if rim and short >= ROOMY * RIM_MM else clear
    columns = max(1, min(len(free), ceil(sqrt(len(free) * floor.width / floor.depth))))
    rows = ceil(len(free) / columns) if free else 1
    cells: dict[str, Rect] = {}
    for number, (label, kind) in enumerate(free.items()):
        row, column = divmod(number, columns)
        in_row = min(columns, len(free) - row * columns)
        x0, x1 = (floor.x0 + floor.width * k // in_row for k in (column, column + 1))
        z0, z1 = (floor.z0 + floor.depth * k // rows for k in (row, row + 1))
        cells[label] = _with_ways(Rect(x0, z0, x1, z1), kind, label in seated)
    return cells


def _with_ways(cell: Rect, kind: Kind, seated: bool) -> Rect:
    """Returns a cell less half a way on each side, and the floor of those who sit there; less of it where the piece needs the room."""
    width, depth = kind.size[:2]
    wished = (WAY_MM // 2 if min(width, depth) >= LARGE_MM else 0) + (LARGE_MM if seated else 0)
    spare = max(min(cell.width - across, cell.depth - along) // 2 for across, along in ((width, depth), (depth, width)))
    return cell.shrunk(max(0, min(wished, spare)))
