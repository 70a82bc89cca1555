"""How a listed piece may be turned and at which wall its back may be, and where in the room it then holds which relations."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import inf
from typing import NamedTuple, TypeAlias

from catalogs.relation_keys import OPENINGS
from catalogs.schema import RelationSpec
from solver.geometry import INWARDS, ROTATION_AT_WALL, Rect, strip_at, turned
from solver.pieces import Space, Stance, Stretch
from solver.relations.asking import missed, regions, traits
from solver.relations.subject import Footing, Kind, Subject
from solver.scene import WALLS

Costed: TypeAlias = tuple[Rect, float]
"""A rectangle, and what it costs to miss the relations that do not hold there."""


class Kept(NamedTuple):
    """How many ways to stand are kept, the cheapest; what is left out is noted in `ListedPiece.dropped`.

    Args:
        rects: most rectangles of one stance, before the few that are searched are chosen.
        each: most rectangles of one stance that are searched, and the dearest of all.
        boxes: most boxes of one stance, in another piece's frame, that differ in what they hold.
        places: most candidates of one stance beside one stance of another piece.
        beside: most candidates of all stances beside one stance of another piece.
        attached: most candidates of a piece that are attached to others.
        dear: a stance that costs so much more than a piece's best is too unlikely for others to be attached to it.
        in_all: most candidates of all pieces of a list together.
    """

    rects: int
    each: int
    boxes: int
    places: int
    beside: int
    attached: int
    dear: float
    in_all: float


FEW = Kept(rects=12, each=3, boxes=14, places=3, beside=5, attached=400, dear=5.0, in_all=inf)
"""What finds a good placement of any list; `dear` is less than a relation costs."""
NEARLY_ALL = Kept(rects=64, each=64, boxes=64, places=64, beside=64, attached=2000, dear=inf, in_all=900)
"""What proves one the best, of lists that are short enough."""


class PairRelation(NamedTuple):
    """A relation between a piece and an earlier one: its own, or that one's, which is called by `owner`."""

    spec: RelationSpec
    owner: str | None = None


@dataclass(frozen=True)
class ListedPiece:
    """One copy of a listed piece, and what its candidates are made from.

    Args:
        subject: the piece.
        space: the room's.
        reach: where the centre of an earlier piece may be, by its label and stance, mm.
        unlikely: stances of earlier pieces that miss a relation which others hold: no places are sought beside them.
        cell: the part of the floor where it stands best, if it stands free.
        kept: how many ways to stand are kept.
        owed: relations of earlier pieces to it.
        dropped: filled while its candidates are made: what those cost at least that a limit kept out.
    """

    subject: Subject
    space: Space
    reach: Mapping[tuple[str, Stance], Rect]
    unlikely: Collection[tuple[str, Stance]]
    cell: Rect | None = None
    kept: Kept = FEW
    owed: tuple[PairRelation, ...] = ()
    dropped: list[float] = field(default_factory=list, compare=False)

    @property
    def kind(self) -> Kind:
        """Its kind and size."""
        return self.subject.kind

    @cached_property
    def to_room(self) -> tuple[RelationSpec, ...]:
        """Its relations to the room and its openings; those to pieces that come later are these pieces' business."""
        relations = (spec for spec in self.subject.relations if not self.subject.labels(spec.of))
        return tuple(spec for spec in relations if not spec.of or set(spec.of) & set(OPENINGS))

    @cached_property
    def to_pieces(self) -> tuple[RelationSpec, ...]:
        """Its relations to earlier pieces; to keep away from what has no way to stand is kept."""
        subject = self.subject
        named = [spec for spec in subject.relations if subject.labels(spec.of)]
        return tuple(spec for spec in named if subject.parents(spec.of) or not traits(spec.type).with_all)

    @cached_property
    def pairs(self) -> tuple[PairRelation, ...]:
        """The relations between it and earlier pieces."""
        return (*map(PairRelation, self.to_pieces), *self.owed)

    def earlier(self, pair: PairRelation) -> list[str]:
        """Returns the labels of the earlier pieces that a relation is between."""
        return self.subject.labels(pair.spec.of) if pair.owner is None else [pair.owner]

    @cached_property
    def stretches(self) -> Mapping[str, list[Stretch]]:
        """The clear stretches of each wall for it."""
        return {wall: self.space.free_stretches(wall, *self.kind.size[1:]) for wall in WALLS}

    @cached_property
    def places(self) -> Sequence[tuple[Footing, list[Costed]]]:
        """Its footings, each with the rectangles that hold relations to the room, cheapest first."""
        return [(footing, _places(self, footing)) for footing in _footings(self)]


def _footings(listed: ListedPiece) -> Iterator[Footing]:
    """Yields the ways a piece may be turned: with its back at each wall, and free in the room."""
    clear, gap = listed.space.clear, listed.space.gap_mm
    width, depth, _ = listed.kind.size
    relations = [traits(spec.type) for spec in listed.subject.relations]
    if listed.kind.at_walls or any(relation.at_walls for relation in relations):
        for wall in WALLS:
            turn = ROTATION_AT_WALL[wall]
            reach = strip_at(wall, clear.line(wall) + INWARDS[wall] * gap, clear.along(wall), depth)
            if within_both(reach, clear, turned(width, depth, turn)):
                yield Footing(turn, wall, turned(width, depth, turn), reach)
    if not listed.kind.at_walls:
        turns = (0, 90, 180, 270) if any(relation.turns for relation in relations) else _rotations(listed.kind)
        for turn in turns:
            yield Footing(turn, None, turned(width, depth, turn), clear)


def _rotations(kind: Kind) -> tuple[int, ...]:
    """Returns the rotations that differ: four for what has a front, two for what is only longer one way, else one."""
    if 0 < len(kind.use_sides) < 4:
        return (0, 90, 180, 270)
    return (0,) if kind.size[0] == kind.size[1] else (0, 90)


def _places(listed: ListedPiece, footing: Footing) -> list[Costed]:
    """Returns rectangles for a footing, each holding some of the relations to the room, cheapest first."""
    found = [(footing.reach, 0.0)] if within_both(footing.reach, footing.reach, footing.extent) else []
    for spec in listed.to_room:
        hold = regions(listed.subject.scope, spec, footing)
        held = [(both, cost) for rect, cost in found for region in hold if (both := within_both(rect, region, footing.extent))]
        without = missed(spec)
        found = cheapest([*held, *((rect, cost + without) for rect, cost in found)], listed.kept.rects, listed.dropped)
    return found


def cheapest(found: Sequence[Costed], most: int, dropped: list[float]) -> list[Costed]:
    """Sorts by cost, the largest first, and drops what lies within a rectangle that costs no more.

    Where there are more than `most`, the cost of the first one left out is added to `dropped`.
    """
    best: list[Costed] = []
    for rect, cost in sorted(found, key=_by_cost_then_size):
        if cost == inf:
            break
        x0, z0, x1, z1 = rect
        for (a0, b0, a1, b1), _ in best:
            if a0 <= x0 and b0 <= z0 and x1 <= a1 and z1 <= b1:
                break
        else:
            if len(best) == most:
                dropped.append(cost)
                break
            best.append((rect, cost))
    return best


def _by_cost_then_size(place: Costed) -> tuple[float, int]:
    (x0, z0, x1, z1), cost = place
    return cost, (x0 - x1) * (z1 - z0)


def within_both(a: Rect, b: Rect, extent: tuple[int, int]) -> Rect | None:
    """Returns what two rectangles share, if a footprint of that extent fits in it."""
    (a_x0, a_z0, a_x1, a_z1), (b_x0, b_z0, b_x1, b_z1) = a, b
    x0, x1 = a_x0 if a_x0 > b_x0 else b_x0, a_x1 if a_x1 < b_x1 else b_x1
    z0, z1 = a_z0 if a_z0 > b_z0 else b_z0, a_z1 if a_z1 < b_z1 else b_z1
    return Rect(x0, z0, x1, z1) if x1 - x0 >= extent[0] and z1 - z0 >= extent[1] else None
