"""Candidates in another piece's frame: a box there for the relations to it, a rectangle in the room for those to the room.

A box is a rectangle of where the piece's centre may lie, from the other's centre, in the other's frame: right +x, front +z.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from math import inf
from typing import NamedTuple

from catalogs.schema import RelationSpec
from solver.furnish.stances import Costed, ListedPiece, PairRelation, cheapest, within_both
from solver.geometry import Rect, rotate
from solver.pieces import Attach, Candidate, Placed, Stance
from solver.relations.asking import ANYWHERE, boxes, missed, suits, traits
from solver.relations.subject import Footing, Kind, Parent

SLIDING_COST = 0.04
"""What a place that slides along an axis costs more than an exact one, or one turned across the other: pieces line up where they can."""
UNSURE = 0.25
"""The part of a relation's cost that a candidate pays which neither holds nor breaks it."""
FIRM, LOOSE = 0.3, 0.03
"""Pull, m^-2, to the middle of a box: of a place beside, before or around a piece, and of any other."""
SLACK_MM = 2
"""What halves of odd extents may add up to."""
BETWEEN_OTHERS = 12
"""Most candidates of a piece between others that stand."""
ANY_PLACE = Rect(ANYWHERE[0], ANYWHERE[0], ANYWHERE[1], ANYWHERE[1])
POINT = (0, 0)


class _Beside(NamedTuple):
    """A place beside another piece: what it costs, how the piece stands, its box there, its rectangle in the room."""

    cost: float
    footing: Footing
    box: Rect
    rect: Rect


def attached(listed: ListedPiece, every: Sequence[tuple[Footing, Sequence[Costed]]], dearest: float) -> Iterator[Candidate]:
    """Yields the candidates attached to another piece, each for one stance of that piece, those as dear as `dearest` left out.

    `every` are its footings, each with the rectangles that hold relations to the room.
    """
    for label in dict.fromkeys(label for pair in listed.pairs for label in listed.earlier(pair)):
        mine = [pair for pair in listed.pairs if label in listed.earlier(pair)]
        rest = [pair.spec for pair in listed.pairs if label not in listed.earlier(pair)]
        others = sum(spec.cost * (1.0 if traits(spec.type).gives_place else UNSURE) for spec in rest)
        if any(pair.spec.type == "on" for pair in mine):
            yield from _resting_on(listed, [pair.spec for pair in mine], label)
            continue
        frames = _Frames(listed, mine, others)
        hard = any(pair.spec.required for pair in mine)
        for parent in listed.subject.standing[label]:
            if hard or (label, parent.stance) not in listed.unlikely:
                for place in _cheapest(frames, every, parent, dearest - others):
                    yield frames.candidate(place, parent, others)


def _resting_on(listed: ListedPiece, specs: Sequence[RelationSpec], label: str) -> Iterator[Candidate]:
    """Yields the places on another piece's surface; it stands as that piece does."""
    kind = listed.kind
    for spec, parent in product((spec for spec in specs if spec.type == "on"), listed.subject.standing[label]):
        for box, level in boxes(spec, kind, parent.kind, 0):
            surface = parent.kind.levels[level]
            attach = Attach(label, parent.kind.name, (box.x0, box.x1), (box.z0, box.z1), f"on {surface.name}", parent.stance)
            yield Candidate(
                kind.name, kind.size, 0, weights=(FIRM, FIRM), attach=attach, on=label, bottom_mm=surface.height_mm,
                stance=Stance(_stance(parent).rotation),
            )  # fmt: skip


class _Frames:
    """The boxes of a piece's relations in the frame of another piece, each kind of frame worked out once.

    `pairs` are those with the one other piece, `others` what its relations with further pieces cost here.
    """

    def __init__(self, listed: ListedPiece, pairs: Sequence[PairRelation], others: float) -> None:
        self.listed, self._pairs, self._others = listed, pairs, others
        pull = FIRM if any(traits(pair.spec.type).gives_place for pair in pairs) else LOOSE
        self._pulls = (pull, pull)
        clear = listed.space.clear
        self._far = max(clear.width, clear.depth)
        self._tucked: set[tuple[int, Rect]] = set()
        self._centres: dict[tuple[Rect, Stance], Rect] = {}
        self._known: dict[tuple[int, tuple[bool, ...]], list[Costed]] = {}

    def dropped(self, cost: float) -> None:
        """Notes that a limit kept out a place that costs so much without the others."""
        self.listed.dropped.append(cost + self._others)

    def boxes(self, parent: Parent, footing: Footing) -> list[Costed]:
        """Returns boxes that each hold at least one relation, cheapest first."""
        stance = _stance(parent)
        suiting = tuple(_suits(pair, footing.wall, stance.wall) for pair in self._pairs)
        turn = (footing.rotation - stance.rotation) % 360
        if (turn, suiting) not in self._known:
            found = _boxes(self.listed, [*zip(self._pairs, suiting, strict=True)], parent.kind, turn)
            self._known[turn, suiting] = found
            for pair in self._pairs:
                if pair.owner is None and tucks(pair.spec):
                    held = _held_boxes(pair, self.listed.kind, parent.kind, turn)
                    self._tucked |= {(turn, box) for box, _ in found if any(within_both(box, other, POINT) == box for other in held)}
        return self._known[turn, suiting]

    def centres(self, box: Rect, parent: Parent) -> Rect:
        """Returns where the centre may be in the room, wherever the other stands so."""
        stance = _stance(parent)
        found = self._centres.get((box, stance))
        if found is None:
            other = self.listed.reach.get((parent.label, stance), ANY_PLACE)
            found = _in_room(box, stance.rotation, other).shrunk(-SLACK_MM)
            self._centres[box, stance] = found
        return found

    def candidate(self, place: _Beside, parent: Parent, more: float) -> Candidate:
        """Returns the candidate for a place in a box of the other's frame and a rectangle of the room; `more` is added to its cost."""
        relative = (place.footing.rotation - _stance(parent).rotation) % 360
        x0, z0, x1, z1 = place.box
        across, along = _clipped((x0, x1), self._far), _clipped((z0, z1), self._far)
        return Candidate(
            self.listed.kind.name, self.listed.kind.size, relative, weights=self._pulls, within=place.rect,
            cost=round(place.cost + more, 6), attach=Attach(parent.label, parent.kind.name, across, along, parent_stance=parent.stance),
            under=parent.label if (relative, place.box) in self._tucked else None, stance=place.footing.stance,
        )  # fmt: skip


def _stance(parent: Parent) -> Stance:
    assert parent.stance is not None, "pieces of a list tell how they stand"
    return parent.stance


def _in_room(box: Rect, rotation: int, centre: Rect) -> Rect:
    """Returns where the centre may be in the room with the other, turned so, anywhere in a rectangle."""
    (x0, z0), (x1, z1) = rotate(box.x0, box.z0, rotation), rotate(box.x1, box.z1, rotation)
    return Rect(centre.x0 + min(x0, x1), centre.z0 + min(z0, z1), centre.x1 + max(x0, x1), centre.z1 + max(z0, z1))


def _suits(pair: PairRelation, mine: str | None, theirs: str | None) -> bool:
    """Tells whether the walls at the backs of a piece and an earlier one lie as a relation between them wants."""
    walls = (mine, theirs) if pair.owner is None else (theirs, mine)
    return suits(pair.spec, *walls)


def _cheapest(
    frames: _Frames, every: Sequence[tuple[Footing, Sequence[Costed]]], parent: Parent, dearest: float
) -> list[_Beside]:  # fmt: skip
    """Returns the cheapest places of all stances beside one stance of another piece, those of the likeliest stances first."""
    likely: list[tuple[float, int, Footing, list[Costed], Sequence[Costed]]] = []
    for footing, found in every:
        held = frames.boxes(parent, footing)
        if held and found:
            likely.append((held[0][1] + found[0][1], len(likely), footing, held, found))
    likely.sort(key=lambda entry: entry[:2])
    places: list[_Beside] = []
    most = frames.listed.kept.beside
    for least, _, footing, held, found in likely:
        if least >= dearest or (len(places) >= most and least >= places[most - 1].cost):
            frames.dropped(least)
            break
        places += [place for place in _in_both(frames, footing, parent, (held, found)) if place.cost < dearest]
        places.sort(key=lambda place: round(place.cost, 9))
    for place in places[most : most + 1]:
        frames.dropped(place.cost)
    return places[:most]


def _in_both(frames: _Frames, footing: Footing, parent: Parent, at: tuple[Sequence[Costed], Sequence[Costed]]) -> list[_Beside]:
    """Returns the cheapest pairs of a box in the other's frame and a rectangle in the room that can hold together."""
    held, found = at
    pairs = sorted((cost + more, i, j) for i, (_, cost) in enumerate(held) for j, (_, more) in enumerate(found))
    half_x, half_z = footing.extent[0] // 2, footing.extent[1] // 2
    places: list[_Beside] = []
    for cost, i, j in pairs:
        if cost == inf:
            break
        if len(places) == frames.listed.kept.places:
            frames.dropped(cost)
            break
        (x0, z0, x1, z1), (low_x, low_z, high_x, high_z) = found[j][0], frames.centres(held[i][0], parent)
        if low_x <= x1 - half_x and x0 + half_x <= high_x and low_z <= z1 - half_z and z0 + half_z <= high_z:
            places.append(_Beside(cost, footing, held[i][0], found[j][0]))
    return places


def between_others(listed: ListedPiece, placed: Mapping[str, Placed]) -> list[Candidate]:
    """Returns candidates where as many relations as can be hold together with the other pieces where they are."""
    found: list[tuple[float, Footing, Rect, Attach | None]] = []
    for footing, in_room in listed.places:
        places, tucked = in_room, list[tuple[Attach, Rect]]()
        for pair in listed.pairs:
            held = _held_at(listed, pair, footing, placed)
            both = [(cut, cost) for rect, cost in places for _, other in held if (cut := within_both(rect, other, footing.extent))]
            places = cheapest([*both, *((rect, cost + missed(pair.spec)) for rect, cost in places)], listed.kept.rects, [])
            tucked += held if pair.owner is None and tucks(pair.spec) else []
        for rect, cost in places[: listed.kept.places]:
            found.append((cost, footing, rect, next((attach for attach, other in tucked if other.contains(rect)), None)))
    found.sort(key=lambda entry: entry[0])
    return [_between(listed, footing, (rect, cost), attach) for cost, footing, rect, attach in found[:BETWEEN_OTHERS]]


def _between(listed: ListedPiece, footing: Footing, place: Costed, attach: Attach | None) -> Candidate:
    """Returns the candidate at a place; attached to the piece it is tucked under, which may slide."""
    (rect, cost), rotation, wall = place, footing.rotation, footing.wall
    if attach is not None and attach.parent_stance is not None:
        rotation, wall = (rotation - attach.parent_stance.rotation) % 360, None
    return Candidate(
        listed.kind.name, listed.kind.size, rotation, wall, rect.centre, (LOOSE, LOOSE), within=rect, cost=round(cost, 6),
        attach=attach, under=attach.parent if attach else None, stance=footing.stance,
    )  # fmt: skip


def _held_at(listed: ListedPiece, pair: PairRelation, footing: Footing, placed: Mapping[str, Placed]) -> list[tuple[Attach, Rect]]:
    """Returns the rectangles within which a footprint holds a relation with any of the pieces it is between, where they stand."""
    found: list[tuple[Attach, Rect]] = []
    for parent in (parent for label in listed.earlier(pair) for parent in listed.subject.standing[label]):
        other = placed.get(parent.label)
        if other is None or other.chosen.stance != parent.stance or pair.spec.type == "on":
            continue
        stance = _stance(parent)
        suiting = _suits(pair, footing.wall, stance.wall)
        width, depth = footing.extent
        # Twice the other's centre is whole; its halves are rounded outwards.
        x, z = other.footprint.x0 + other.footprint.x1, other.footprint.z0 + other.footprint.z1
        own = Rect((x - width) // 2, (z - depth) // 2, (x + width + 1) // 2, (z + depth + 1) // 2)
        for box, cost in _boxes(listed, [(pair, suiting)], parent.kind, (footing.rotation - stance.rotation) % 360):
            if cost < pair.spec.cost:
                attach = Attach(parent.label, parent.kind.name, (box.x0, box.x1), (box.z0, box.z1), parent_stance=stance)
                found.append((attach, _in_room(box, other.rotation, own)))
    return found


def tucks(spec: RelationSpec) -> bool:
    """Tells whether a relation lets a piece reach under another one, as far as their parts do not cross."""
    return spec.type == "under" or (spec.gap is not None and spec.gap[0] < 0)


def _held_boxes(pair: PairRelation, own: Kind, other: Kind, turn: int) -> list[Rect]:
    """Returns the boxes in the other's frame in which a relation surely holds: to it, or its own to this piece."""
    if pair.owner is None:
        return [box for box, _ in boxes(pair.spec, own, other, turn)]
    theirs = (box for box, _ in boxes(pair.spec, other, own, -turn % 360))
    return [_in_room(Rect(-box.x1, -box.z1, -box.x0, -box.z0), turn, Rect(0, 0, 0, 0)) for box in theirs]


def _boxes(listed: ListedPiece, pairs: Sequence[tuple[PairRelation, bool]], other: Kind, turn: int) -> list[Costed]:
    """Returns boxes in the other's frame, each holding at least one of the relations, cheapest first.

    Each relation comes with whether the walls at their backs suit it; `turn` is the own rotation minus the other's.
    """
    found: list[Costed] = [(ANY_PLACE, 0.0)]
    for pair, suiting in pairs:
        hold = _held_boxes(pair, listed.kind, other, turn) if suiting else []
        priced = [(box, _sliding(pair.spec, box, turn)) for box in hold]
        held = [(both, cost + more) for box, cost in found for other_box, more in priced if (both := within_both(box, other_box, POINT))]
        without = missed(pair.spec)
        found = cheapest([*held, *((box, cost + without) for box, cost in found)], listed.kept.boxes, listed.dropped)
    return [(box, cost) for box, cost in found if box != ANY_PLACE]


def _sliding(spec: RelationSpec, box: Rect, turn: int) -> float:
    relation = traits(spec.type)
    across = turn % 180 != 0 and not relation.turns
    return SLIDING_COST * ((box.x0 < box.x1) + (box.z0 < box.z1) + across) if relation.gives_place else 0.0


def _clipped(interval: tuple[int, int], far: int) -> tuple[int, int]:
    """Cuts an interval without an end off where the room ends, so that its middle means something."""
    low, high = interval
    if low <= ANYWHERE[0]:
        low = min(-far, high)
    if high >= ANYWHERE[1]:
        high = max(far, low)
    return low, high
