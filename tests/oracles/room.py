"""Can these pieces all stand in a room, over all their alternatives? A mixed-integer programme, answers checked in integers.

Comes in: a `Space` and wanted pieces, read as data. Goes out: an `Answer`. Written from the docstrings of solver/pieces.py: a
binary for every way to stand (an alternative and the rotation it then has), a position for every piece, four binaries for
every pair of things that must be apart, a square for every use side. What is left of the walk is in paths.py.

A piece of odd size attached to one of even size stands half a millimetre to the north-west of what was asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import combinations

from solver.geometry import Rect
from solver.pieces import Arrangement, Candidate, Piece, Placed, Space
from tests.oracles.programme import Floats, Programme, Terms
from tests.oracles.rules import QUARTERS, faults, holds
from tests.oracles.verdict import SECONDS
from tests.oracles.walk import side_towards

PERSON_MM = 1800
"""Height that a person at a use side needs free."""
_CHOSEN = 0.5


@dataclass(frozen=True)
class Way:
    """One way for a piece to stand: what decides feasibility of an alternative, anchors and costs aside.

    `parents` are the ways of its parent, by index, that it goes with.
    """

    alternative: Candidate
    rotation: int
    extent: tuple[int, int]
    low: tuple[int, int]
    high: tuple[int, int]
    offset: tuple[tuple[int, int], tuple[int, int]] | None = None
    """Least and most of own minus the parent's min corner, along x and z."""
    parents: tuple[int, ...] = ()

    @property
    def heights(self) -> tuple[int, int]:
        """Underside and top, mm."""
        return self.alternative.bottom_mm, self.alternative.bottom_mm + self.alternative.size_mm[2]

    @property
    def waives(self) -> tuple[str | None, str | None]:
        """The pieces it may overlap in plan."""
        return self.alternative.under, self.alternative.on


@dataclass
class Box:
    """A thing with a place: a piece, a person's square or the sweep of a walk.

    `x`, `z` and the ends are linear expressions with constants; `there` the binaries of which one is 1 where it is there
    (None: always); `ways` those of a piece with their heights and what each may overlap.
    """

    label: str
    starts: tuple[list[tuple[int, float]], list[tuple[int, float]]]
    ends: tuple[list[tuple[int, float]], list[tuple[int, float]]]
    solid: bool
    ways: list[tuple[int, Way]] = field(default_factory=list)
    size: int = 0
    """Added to `ends`."""


@dataclass(frozen=True)
class Answer:
    """`verdict`: True with an `arrangement` that shows it, False, or None where the limits came first; `how` says by what."""

    verdict: bool | None
    how: str
    arrangement: Arrangement | None = None


def ways_of(space: Space, piece: Piece, known: dict[str, list[Way]]) -> list[Way]:
    """Returns the ways a piece may stand; those it shares with others of its alternatives once."""
    found: dict[Way, None] = {}
    for a in piece.candidates:
        bare = Candidate(
            a.kind, a.size_mm, a.rotation, a.wall, within=a.within, bottom_mm=a.bottom_mm, attach=a.attach, under=a.under,
            on=a.on, slack_mm=a.slack_mm, stance=a.stance,
        )  # fmt: skip
        for way in _attached(space, bare, known) if a.attach else [_standing(space, bare)]:
            if all(low <= high for low, high in zip(way.low, way.high, strict=True)):
                found[way] = None
    return list(found)


def _standing(space: Space, a: Candidate) -> Way:
    wide, deep = a.size_mm[:2] if a.rotation % 180 == 0 else a.size_mm[1::-1]
    box, clear, gap = a.within or space.clear, space.clear, space.gap_mm
    low, high = [box.x0, box.z0], [box.x1 - wide, box.z1 - deep]
    least, most = (gap, gap) if a.slack_mm is None else (0, a.slack_mm)
    if a.wall in ("north", "west"):
        axis, face = (1, clear.z0) if a.wall == "north" else (0, clear.x0)
        low[axis], high[axis] = max(low[axis], face + least), min(high[axis], face + most)
    elif a.wall:
        axis, face = (1, clear.z1 - deep) if a.wall == "south" else (0, clear.x1 - wide)
        low[axis], high[axis] = max(low[axis], face - most), min(high[axis], face - least)
    return Way(a, a.rotation, (wide, deep), (low[0], low[1]), (high[0], high[1]))


def _attached(space: Space, a: Candidate, known: dict[str, list[Way]]) -> list[Way]:
    """Returns one way for every pose of the parent that the alternative is for."""
    assert a.attach is not None
    poses: dict[tuple[int, tuple[int, int]], list[int]] = {}
    for k, way in enumerate(known.get(a.attach.parent, [])):
        if (way.alternative.kind, way.alternative.stance) == (a.attach.parent_kind, a.attach.parent_stance):
            poses.setdefault((way.rotation, way.extent), []).append(k)
    found = []
    for (turn, parent), parents in poses.items():
        rotation = (turn + a.rotation) % 360
        wide, deep = a.size_mm[:2] if rotation % 180 == 0 else a.size_mm[1::-1]
        right, front = QUARTERS[turn]
        offset = []
        for axis, own in ((0, wide), (1, deep)):
            ends = [a.attach.across_mm[k] * right[axis] + a.attach.along_mm[k] * front[axis] for k in (0, 1)]
            shift = (parent[axis] - own) // 2
            offset.append((shift + min(ends), shift + max(ends)))
        box = a.within or space.clear
        found.append(
            Way(a, rotation, (wide, deep), (box.x0, box.z0), (box.x1 - wide, box.z1 - deep), (offset[0], offset[1]), tuple(parents))
        )  # fmt: skip
    return found


class Model:
    """The programme of a room.

    Args:
        space: where the pieces may stand.
        pieces: all of which must stand; what is attached comes after its parent.
        stands: whether their use sides must be free.
    """

    def __init__(self, space: Space, pieces: Sequence[Piece], stands: bool) -> None:
        self.space, self.pieces = space, pieces
        self.programme = Programme()
        self.ways: dict[str, list[Way]] = {}
        self.taken: dict[str, list[int]] = {}
        self.boxes: dict[str, Box] = {}
        self.people: list[tuple[Box, int]] = []
        """Squares at use sides, each with the binary that says it is used."""
        for piece in pieces:
            self._piece(piece)
        self._slots()
        for a, b in combinations(self.boxes.values(), 2):
            self._bodies_apart(a, b)
        for piece in pieces if stands else ():
            self._use(piece)

    def _piece(self, piece: Piece) -> None:
        programme = self.programme
        ways = self.ways[piece.label] = ways_of(self.space, piece, self.ways)
        taken = self.taken[piece.label] = [programme.binary() for _ in ways]
        programme.at_least([(b, 1.0) for b in taken], 1)
        programme.at_least([(b, -1.0) for b in taken], -1)
        starts, ends = [], []
        for axis in (0, 1):
            low, high = min((w.low[axis] for w in ways), default=0), max((w.high[axis] for w in ways), default=0)
            p = programme.variable(low, high)
            programme.at_least([(p, 1.0), *((b, -float(w.low[axis])) for b, w in zip(taken, ways, strict=True))], 0)
            programme.at_least([(p, -1.0), *((b, float(w.high[axis])) for b, w in zip(taken, ways, strict=True))], 0)
            starts.append([(p, 1.0)])
            ends.append([(p, 1.0), *((b, float(w.extent[axis])) for b, w in zip(taken, ways, strict=True))])
        box = Box(piece.label, (starts[0], starts[1]), (ends[0], ends[1]), True, list(zip(taken, ways, strict=True)))
        self.boxes[piece.label] = box
        for b, way in box.ways:
            self._follow(box, b, way)
        for link in piece.links:
            if link.required and link.of in self.boxes and link.of != piece.label:
                self._linked(box, self.boxes[link.of], partial(holds, link))
        for zone in self.space.zones:
            tall = [(b, 1.0) for b, way in box.ways if way.heights[1] > zone.above_mm]
            if tall:
                self._out_of(box, zone.rect, tall)

    def _follow(self, box: Box, b: int, way: Way) -> None:
        """Keeps a piece at its slot of its parent."""
        if way.offset is None or way.alternative.attach is None:
            return
        parent = way.alternative.attach.parent
        self.programme.at_least([*((self.taken[parent][k], 1.0) for k in way.parents), (b, -1.0)], 0)
        for axis in (0, 1):
            difference = [*box.starts[axis], *((v, -c) for v, c in self.boxes[parent].starts[axis])]
            least, most = way.offset[axis]
            self._when_taken(b, difference, least)
            self._when_taken(b, [(v, -c) for v, c in difference], -most)

    def _when_taken(self, b: int, entries: Terms, lower: float) -> None:
        """Adds a row that holds where a binary is 1."""
        big = lower - self.programme.least(entries)
        if big > 0:
            self.programme.at_least([*entries, (b, -big)], lower - big)

    def _linked(self, box: Box, other: Box, allowed: Callable[[tuple[int, str | None], tuple[int, str | None]], bool]) -> None:
        for b, way in box.ways:
            fitting = [(c, 1.0) for c, theirs in other.ways if allowed(_pose(way), _pose(theirs))]
            self.programme.at_least([*fitting, (b, -1.0)], 0)

    def _slots(self) -> None:
        """No two pieces in one slot."""
        slots: dict[tuple[str, str], list[int]] = {}
        for box in self.boxes.values():
            for b, way in box.ways:
                attach = way.alternative.attach
                if attach is not None and attach.slot:
                    slots.setdefault((attach.parent, attach.slot), []).append(b)
        for binaries in slots.values():
            self.programme.at_least([(b, -1.0) for b in binaries], -1)

    def _bodies_apart(self, a: Box, b: Box) -> None:
        """Parts two pieces in all their ways that share a height range and do not waive it."""
        sides = self._sides(a, b)
        waived = [(binary, 1.0) for binary, way in a.ways if b.label in way.waives]
        waived += [(binary, 1.0) for binary, way in b.ways if a.label in way.waives]
        for low_a, high_a in sorted({way.heights for _, way in a.ways}):
            of_a = [(v, -1.0) for v, way in a.ways if way.heights == (low_a, high_a)]
            low_b = [(v, -1.0) for v, way in b.ways if way.heights[0] < high_a and low_a < way.heights[1]]
            if low_b:
                self.programme.at_least([*((s, 1.0) for s in sides), *waived, *of_a, *low_b], -1)

    def _sides(self, a: Box, b: Box) -> list[int]:
        """Adds four binaries: a left of, right of, north of, south of b."""
        binaries = []
        for axis in (0, 1):
            for first, second in ((a, b), (b, a)):
                side = self.programme.binary()
                difference = [*second.starts[axis], *((v, -c) for v, c in first.ends[axis])]
                self._when_taken(side, difference, first.size)
                binaries.append(side)
        return binaries

    def _out_of(self, box: Box, rect: Rect, there: Terms) -> None:
        """Keeps a thing out of a fixed rectangle where the binaries `there` sum to 1."""
        sides = []
        for axis, (low, high) in ((0, (rect.x0, rect.x1)), (1, (rect.z0, rect.z1))):
            before, after = self.programme.binary(), self.programme.binary()
            self._when_taken(before, [(v, -c) for v, c in box.ends[axis]], box.size - low)
            self._when_taken(after, box.starts[axis], high)
            sides += [(before, 1.0), (after, 1.0)]
        self.programme.at_least([*sides, *((b, -c) for b, c in there)], 0)

    def _use(self, piece: Piece) -> None:
        """Adds a free square at the use sides that are needed."""
        used = []
        for stand in piece.stands:
            binary = self.programme.binary()
            used.append(binary)
            self._person(piece.label, stand.side, binary)
        if piece.stands and piece.need_all:
            for binary in used:
                self.programme.at_least([(binary, 1.0)], 1)
        elif piece.stands:
            self.programme.at_least([(binary, 1.0) for binary in used], 1)

    def square(self, label: str) -> Box:
        """Adds a square of the person's size anywhere on the floor."""
        clear, size = self.space.clear, self.space.robot_mm
        x = self.programme.variable(clear.x0, clear.x1 - size)
        z = self.programme.variable(clear.z0, clear.z1 - size)
        at = ([(x, 1.0)], [(z, 1.0)])
        return Box(label, at, at, False, size=size)

    def _person(self, label: str, side: str, used: int) -> None:
        """Adds the square that touches a side, its centre within the side's extent, free of all but its own piece."""
        if min(self.space.clear.width, self.space.clear.depth) < self.space.robot_mm:
            self.programme.at_least([(used, -1.0)], 0)
            return
        own, person, half = self.boxes[label], self.square(label), self.space.robot_mm // 2
        for wall in ("north", "south", "west", "east"):
            looking = [(b, 1.0) for b, way in own.ways if side_towards(side, way.rotation) == wall]
            if not looking:
                continue
            free = [(used, -1.0), *((b, -c) for b, c in looking)]  # 2 less the two: 0 where both hold
            normal = 1 if wall in ("north", "south") else 0
            touch = [*person.starts[normal], *((v, -c) for v, c in (own.starts if wall in ("north", "west") else own.ends)[normal])]
            reach = -self.space.robot_mm if wall in ("north", "west") else 0
            along = 1 - normal
            rows = [
                (touch, reach),
                ([(v, -c) for v, c in touch], -reach),
                ([*person.starts[along], *((v, -c) for v, c in own.starts[along])], -half),
                ([*own.ends[along], *((v, -c) for v, c in person.starts[along])], half),
            ]
            for entries, lower in rows:
                big = lower - self.programme.least(entries)
                if big > 0:
                    self.programme.at_least([*entries, *((b, big * c) for b, c in free)], lower - 2 * big)
        self.free(person, used, label)
        self.people.append((person, used))

    def free(self, person: Box, used: int, but: str = "") -> None:
        """Keeps a square or a sweep clear of all pieces and of what the room lacks, where a binary is 1."""
        for other in self.boxes.values():
            low = [(b, 1.0) for b, way in other.ways if way.heights[0] < PERSON_MM]
            if other.label != but and low:
                sides = self._sides(person, other)
                self.programme.at_least([*((s, 1.0) for s in sides), (used, -1.0), *((b, -c) for b, c in low)], -1)
        for zone in self.space.zones:
            if zone.cause == "outline":
                self._out_of(person, zone.rect, [(used, 1.0)])

    def solve(self, seconds: float) -> tuple[bool | None, Arrangement | None]:
        """Returns whether the pieces can stand, None where the time ran out first, and where.

        Positions are continuous at first. Where the answer holds by the solver's tolerance alone, which no whole millimetres
        meet, they are whole from the start.
        """
        if any(not ways for ways in self.ways.values()):
            return False, None
        whole = self.programme.whole
        for integers in (whole, [1] * len(whole)):
            self.programme.whole = integers
            found, x = self.programme.solve(seconds)
            if not found:
                return found, None
            settled = self._settled(x, whole, seconds)
            if settled is not None:
                return True, self._arrangement(settled)
        return None, None

    def _settled(self, x: Floats, binary: Sequence[int], seconds: float) -> Floats | None:
        """Solves once more for whole millimetres, every binary kept."""
        programme = self.programme
        settled = Programme(cost=programme.cost, entries=programme.entries, lower=programme.lower)
        settled.low = [float(round(v)) if b else low for low, v, b in zip(programme.low, x, binary, strict=True)]
        settled.high = [float(round(v)) if b else high for high, v, b in zip(programme.high, x, binary, strict=True)]
        settled.whole = [1] * len(x)
        found, whole = settled.solve(seconds)
        return whole if found else None

    def _arrangement(self, x: Floats) -> Arrangement:
        placed = []
        for piece in self.pieces:
            box = self.boxes[piece.label]
            way = next(way for b, way in box.ways if x[b] > _CHOSEN)
            left, top = (round(x[box.starts[axis][0][0]]) for axis in (0, 1))
            footprint = Rect(left, top, left + way.extent[0], top + way.extent[1])
            placed.append(Placed(piece.label, way.alternative, way.rotation, way.alternative.wall, footprint))
        return Arrangement(self.space.room, tuple(placed))


def _pose(way: Way) -> tuple[int, str | None]:
    return way.rotation, None if way.alternative.attach else way.alternative.wall


def shown(space: Space, pieces: Sequence[Piece], arrangement: Arrangement) -> Arrangement:
    """Returns an arrangement whose pieces stand as asked.

    Raises:
        RuntimeError: they do not; the oracle is wrong.
    """
    bare = {piece.label: {id(a): a for a in piece.candidates} for piece in pieces}
    placed = []
    for piece in arrangement.placed:
        asked = [a for a in bare[piece.label].values() if _same(a, piece.chosen)]
        placed.append(Placed(piece.label, asked[0], piece.rotation, piece.wall, piece.footprint))
    named = Arrangement(arrangement.room, tuple(placed))
    wrong = faults(space, pieces, named)
    if wrong:
        raise RuntimeError(f"the oracle's answer is wrong: {wrong}")
    return named


def _same(a: Candidate, b: Candidate) -> bool:
    names = ("kind", "stance", "size_mm", "rotation", "wall", "within", "bottom_mm", "attach", "under", "on", "slack_mm")
    return all(getattr(a, name) == getattr(b, name) for name in names)


def stand_together(space: Space, pieces: Sequence[Piece], seconds: float = SECONDS, stands: bool = False) -> Answer:
    """Tells whether pieces can all stand together, walking aside; with `stands`, each with room for a person at its sides."""
    verdict, arrangement = Model(space, pieces, stands).solve(seconds)
    if arrangement is None:
        return Answer(verdict, "no choice of ways and sides" if verdict is False else "time ran out")
    return Answer(True, "shown", shown(space, pieces, arrangement))
